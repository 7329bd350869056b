"""Numerical tests as other processors would run them: other kernels of BLAS, numpy without its newest, plain code.

Each setting is a run of its own, because libraries look at their processor once, when they are loaded.
"""

import os
import subprocess
import sys
from pathlib import Path

import pytest
from numpy._core._multiarray_umath import __cpu_dispatch__, __cpu_features__
from tests.conftest import IMPORTS, ROOT

# Where results go through many digits: eigenvalues far apart and close together, powers, optima, recursions.
ALGEBRA = (
    "body/test_eigenspaces.py::test_any_mixture_of_equals_gives_the_same",
    "body/test_truncation.py",
    "cli/test_plan_command.py::test_plan_draws_and_tunes",
    "mechanics/test_modal.py",
    "network/test_consensus.py",
    "network/test_passivity.py",
    "study/test_confirm.py",
)
# Kernels of the simulator and of the search for roots; compiled once for the plain processor, kept apart.
KERNELS = ("study/test_confirm.py",)
# Of both, what costs little and went wrong, or would be the first to.
FEW = (
    "body/test_eigenspaces.py::test_any_mixture_of_equals_gives_the_same",
    "network/test_consensus.py::test_agrees_with_dense_eigenvalues",
    "network/test_passivity.py::test_minimax_is_the_perron_eigenvalue_and_no_weights_do_better",
    "study/test_confirm.py::test_the_slowest_of_several_exponentials",
    "simulation/test_codec.py::test_the_record_is_that_of_the_batch_engine",
    "study/test_confirm.py::test_powers_that_leave_the_range_of_floating_point",
)
FEW_KERNELS = (
    "mechanics/test_step.py::TestPoint::test_scalar_formula",
    "network/test_returns.py::test_what_is_excluded_is_empty_and_no_turn_is_lost[0]",
)
KEPT = Path(ROOT, ".pytest_cache", "numba-generic")


def without(*features: str) -> str:
    """Of these, what numpy uses here."""
    return " ".join(name for name in features if name in __cpu_dispatch__ and __cpu_features__.get(name))


# What each needs of the processor, what is set, which tests run, and which of them always do.
SETTINGS = {
    "AVX2": (
        ("X86_V4",),  # without AVX-512 this is how all other tests run
        {"OPENBLAS_CORETYPE": "Haswell", "NPY_DISABLE_CPU_FEATURES": without("X86_V4", "AVX512_ICL", "AVX512_SPR")},
        ALGEBRA,
        FEW,
    ),
    "SSE4": (
        ("SSE42",),
        {
            "OPENBLAS_CORETYPE": "Nehalem",
            "NPY_DISABLE_CPU_FEATURES": without("X86_V3", "X86_V4", "AVX512_ICL", "AVX512_SPR"),
        },
        ALGEBRA,
        FEW,
    ),
    "plain": ((), {"NUMBA_CPU_NAME": "generic", "NUMBA_CACHE_DIR": str(KEPT)}, KERNELS, FEW_KERNELS),
}


@pytest.mark.parametrize("name", SETTINGS)
def test_numbers_do_not_depend_on_the_processor(name: str):
    run(name, SETTINGS[name][3])


@pytest.mark.slow
@pytest.mark.parametrize("name", SETTINGS)
def test_nor_do_all_the_others(name: str):
    run(name, SETTINGS[name][2])


def run(name: str, tests: tuple[str, ...]) -> None:
    needed, setting = SETTINGS[name][:2]
    if not all(__cpu_features__.get(feature) for feature in needed):
        pytest.skip(f"this processor has no {' and '.join(needed)}")
    paths = [str(Path(ROOT, "tests", test)) for test in tests]
    command = [sys.executable, "-m", "pytest", "-q", "-x", "-p", "no:xdist", "-p", "no:cacheprovider", *paths]
    done = subprocess.run(
        command,
        cwd=ROOT,
        env={**os.environ, "PYTHONPATH": IMPORTS, **setting},
        capture_output=True,
        text=True,
        timeout=900,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr


HEARD = """
import ctypes
from pathlib import Path
import numpy as np
from numba.core.registry import cpu_target
from numpy._core._multiarray_umath import __cpu_features__
blas = next(line.split()[-1] for line in Path("/proc/self/maps").read_text().splitlines() if "openblas" in line)
name = ctypes.CDLL(blas).scipy_openblas_get_corename64_
name.restype = ctypes.c_char_p
print(__cpu_features__["X86_V3"], cpu_target.target_context.codegen()._get_host_cpu_name(), name().decode())
"""


@pytest.mark.skipif("openblas" not in Path("/proc/self/maps").read_text(), reason="numpy has another BLAS here")
def test_the_settings_reach_the_libraries():
    """One that nobody heeds would test nothing."""
    env = {**os.environ, **SETTINGS["SSE4"][1], **SETTINGS["plain"][1]}
    done = subprocess.run([sys.executable, "-c", HEARD], env=env, capture_output=True, text=True, check=False)
    assert done.stdout.split() == ["False", "generic", "Nehalem"], done.stderr
