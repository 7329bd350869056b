"""Machine code is kept as long as its sources stay the same, and large kernels are kept once."""
# pyright: reportPrivateUsage=false

import gc
import importlib
import os
import pkgutil
import resource
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Generator
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path
from shutil import copytree, ignore_patterns
from types import ModuleType
from typing import Any

import numba
import pytest
from numba.core.compiler import Flags
from numba.core.cpu import CPUContext
from numba.core.dispatcher import Dispatcher
from numba.extending import overload
from tests.coupling.inside import credit

import cotouch
from cotouch import compiled as machine
from cotouch import stamps as sources
from cotouch.mechanics import settle, step
from cotouch.network import rightmost

PACKAGE = Path(str(cotouch.__file__)).parent


def dispatchers() -> dict[Path, list[Any]]:
    """All kernels of the package, by their files."""
    found: dict[Path, list[Any]] = {}
    for module in pkgutil.walk_packages([str(PACKAGE)], "cotouch."):
        if module.name.split(".")[1] in {
            "device",
            "interaction",
            "laws",
            "mechanics",
            "network",
            "planning",
            "simulation",
        }:
            for value in vars(importlib.import_module(module.name)).values():
                if isinstance(value, Dispatcher) and value.py_func.__module__ == module.name:
                    found.setdefault(Path(value.py_func.__code__.co_filename), []).append(value)
    return found


@pytest.mark.parametrize("compiled", [step, settle, rightmost])
def test_the_cache_is_stamped_with_the_kernels_sources(compiled: Any):
    assert stamp_kept(compiled) == sources.stamp_of(Path(compiled.py_func.__code__.co_filename))


def stamp_kept(compiled: Any) -> tuple[str, int]:
    """Of the sources with which what numba keeps of a function on disk is valid."""
    return compiled._cache._cache_file._source_stamp


def test_whatever_a_kernel_calls_counts():
    found = dispatchers()
    assert sum(map(len, found.values())) > 200
    for path, kernels in found.items():
        counted = set(sources._sources(path))
        for compiled in kernels:
            function = compiled.py_func
            for name in function.__code__.co_names:
                called = function.__globals__.get(name)
                # What numba inlines as an overload of its own says where it is from as any function does.
                origin = sys.modules.get(getattr(called, "__module__", None) or "")
                if origin is not None and origin.__name__.startswith("cotouch."):
                    assert Path(str(origin.__file__)) in counted, f"{path.name}: {function.__name__} calls {name}"


@pytest.fixture
def elsewhere(tmp_path: Path) -> Path:
    """A copy of the package."""
    return copytree(PACKAGE, tmp_path / "cotouch", ignore=ignore_patterns("__pycache__"))


def read_anew(package: Path) -> ModuleType:
    """The module of stamps as another process has it that uses this package: each reads sources once."""
    spec = spec_from_file_location("stamps_read_anew", package / "stamps.py")
    assert spec is not None
    assert spec.loader is not None
    made = module_from_spec(spec)
    spec.loader.exec_module(made)
    return made


ENGINE, STEP, ROOT = "simulation/_engine.py", "mechanics/_linear/_step.py", "network/_rightmost.py"


@pytest.mark.parametrize(
    ("name", "concerned"),
    [
        ("mechanics/_linear/_operator.py", {ENGINE, STEP}),
        ("kernels/_vector.py", {ENGINE, STEP}),
        ("mechanics/_contact/_step.py", {ENGINE}),
        ("simulation/_engine.py", {ENGINE}),
        ("device/_phantom.py", {ENGINE}),
        ("network/_loop.py", {ROOT}),
        ("planning/_task.py", set[str]()),
        ("compiled.py", {ENGINE, STEP, ROOT}),
    ],
)
def test_an_edit_changes_the_stamp_of_what_it_concerns(name: str, concerned: set[str], elsewhere: Path):
    def stamps() -> dict[str, object]:
        stamp_of = read_anew(elsewhere).stamp_of
        return {kernel: stamp_of(elsewhere / kernel) for kernel in (ENGINE, STEP, ROOT)}

    before = stamps()
    path = elsewhere / name
    os.utime(path, (0.0, 0.0))
    assert stamps() == before, "a file that was only touched needs no compilation"
    text = path.read_text()
    path.write_text(text[:-2] + text[-2:][::-1])
    after = stamps()
    assert {kernel for kernel in before if after[kernel] != before[kernel]} == concerned


@pytest.mark.parametrize(
    ("line", "counted", "everything"),
    [
        ("from cotouch.kernels import at", {"kernels/_vector.py"}, False),
        (
            "from cotouch.mechanics import (\n    step,  # which, why\n    multiply as by,\n)",
            {"mechanics/_linear/_operator.py"},
            False,
        ),
        ("if True:\n    from cotouch.network._loop import Loop", {"network/_loop.py"}, False),
        ("from cotouch import drawing", {"drawing/_style.py"}, False),
        ("from cotouch import simulate", {"simulation/_engine.py"}, False),
        ("import cotouch.laws", {"laws/_end.py"}, True),
        ("# from cotouch import simulate\nimport numpy", set[str](), False),
    ],
)
def test_every_form_of_an_import_counts(line: str, counted: set[str], everything: bool, tmp_path: Path):
    path = tmp_path / "foreign.py"
    path.write_text(line + "\n")
    found = set(sources._sources(path))
    assert found >= {path, PACKAGE / "compiled.py", *(PACKAGE / name for name in counted)}
    assert (PACKAGE / "web" / "_hub.py" in found) is everything


def test_a_copy_with_the_same_content_needs_no_compilation(elsewhere: Path):
    stamp_of = read_anew(elsewhere).stamp_of
    assert stamp_kept(step) == stamp_of(elsewhere / STEP)
    assert stamp_kept(rightmost) == stamp_of(elsewhere / ROOT)


def test_kernels_keep_their_names_and_documentation():
    assert step.__name__ == "step"
    assert step.__doc__ is not None
    assert step.__doc__.startswith("Advances one copy by T")


def test_cold_is_what_neither_memory_nor_disk_holds(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    path = tmp_path / "doubling.py"
    path.write_text("from cotouch.compiled import routine\n\n\n@routine\ndef double(x):\n    return 2.0 * x\n")
    monkeypatch.syspath_prepend(tmp_path)

    def fresh() -> Any:
        sys.modules.pop("doubling", None)
        return importlib.import_module("doubling").double

    assert machine.cold(fresh())
    once = fresh()
    assert once(2.0) == 4.0
    assert not machine.cold(once)
    assert not machine.cold(fresh()), "the disk holds it"
    path.write_text(path.read_text() + "# Changed.\n")
    monkeypatch.setattr(machine, "stamp_of", read_anew(PACKAGE).stamp_of)
    assert machine.cold(fresh()), "its source has changed"
    assert not machine.cold(len)


DOUBLE = """
from cotouch.compiled import routine

@routine
def double(x):
    return 2.0 * x
"""


@pytest.fixture
def kept(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[[], bool]:
    """Calls a kernel in a file of its own, as another process would; whether its machine code had been kept."""
    (tmp_path / "doubling.py").write_text(DOUBLE)
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.setattr(sys, "dont_write_bytecode", True)
    monkeypatch.setattr(machine, "_told", [])

    def run() -> bool:
        sys.modules.pop("doubling", None)
        double = importlib.import_module("doubling").double
        assert double(2.0) == 4.0
        return sum(double.stats.cache_hits.values()) == 1

    return run


def test_our_own_is_loaded_without_what_numba_compiles_with(kept: Callable[[], bool], monkeypatch: pytest.MonkeyPatch):
    """Others' machine code may need symbols that come with it."""
    compiled: Any = credit
    balance = compiled(2.0, 1.0)
    assert not kept()
    read: list[object] = []

    def refresh(context: object) -> None:
        read.append(context)

    monkeypatch.setattr(CPUContext, "refresh", refresh)
    again: Any = machine.routine(compiled.py_func)
    assert again(2.0, 1.0) == balance
    assert sum(again.stats.cache_hits.values()) == 1
    assert read == []
    assert kept()
    assert read != []


def test_without_a_folder_that_can_be_written_kernels_run_and_say_so(
    tmp_path: Path, kept: Callable[[], bool], monkeypatch: pytest.MonkeyPatch
):
    (tmp_path / "__pycache__").write_text("no folder")
    monkeypatch.setenv("XDG_CACHE_HOME", "/dev/null/x")
    monkeypatch.setenv("HOME", "/dev/null/x")
    with pytest.warns(machine.CacheWarning, match="compiled anew.*neither this package nor a home can be written"):
        assert not kept()
    assert not kept(), "and it is said once"
    assert machine.cold(importlib.import_module("doubling").double) is False, "compiled in this process"
    sys.modules.pop("doubling")
    assert machine.cold(importlib.import_module("doubling").double)


def test_on_a_full_disk_kernels_run_and_say_so(tmp_path: Path, kept: Callable[[], bool]):
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (64, hard))
    try:
        with pytest.warns(machine.CacheWarning, match="__pycache__: File too large"):
            assert not kept()
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))
    assert not kept(), "nothing half-written was left"
    assert kept()


@pytest.mark.parametrize("suffix", ["nbi", "nbc"])
def test_a_cache_that_was_cut_off_heals(tmp_path: Path, kept: Callable[[], bool], suffix: str):
    assert not kept()
    assert kept()
    for file in tmp_path.rglob(f"*.{suffix}"):
        file.write_bytes(file.read_bytes()[: file.stat().st_size // 2])
    assert not kept()
    assert kept()


TWICE = """
import sys
import time
from cotouch.compiled import routine

@routine
def twice(x):
    return x + x

print(len(twice(tuple(range(int(sys.argv[1]))))))
"""


def test_two_processes_that_number_their_files_alike_are_told_apart(tmp_path: Path):
    """Both saw no file yet and took number 1; the index is of one of them and the machine code of the other."""

    script = tmp_path / "twice.py"
    script.write_text(TWICE)

    def ran(folder: str, count: int) -> int:
        (tmp_path / folder).mkdir(exist_ok=True)
        environment = {**os.environ, "NUMBA_CACHE_DIR": str(tmp_path / folder), "PYTHONDONTWRITEBYTECODE": "1"}
        command = [sys.executable, str(script), str(count)]
        return int(subprocess.run(command, env=environment, capture_output=True, text=True, check=True).stdout)

    assert ran("one", 1) == 2
    assert ran("other", 4) == 8
    (mine,), (theirs,) = (list((tmp_path / folder).rglob("*.nbc")) for folder in ("one", "other"))
    assert mine.name == theirs.name
    mine.write_bytes(theirs.read_bytes())
    for count in (1, 4, 1, 4):
        assert ran("one", count) == 2 * count


def inverse(x: float) -> float: ...


@overload(inverse)
def _(x: Any) -> Any:
    def invert(x: Any) -> Any:
        return 1.0 / x

    return invert


def test_a_call_means_what_its_caller_asks_for_however_often_it_was_met():
    njit: Any = numba.njit

    def caller(model: str) -> Any:
        def call(x: float) -> float:
            return inverse(x)

        return njit(error_model=model)(call)

    for _ in range(2):
        assert caller("numpy")(0.0) == float("inf")
        with pytest.raises(ZeroDivisionError):
            caller("python")(0.0)


NAMESAKES = """
import sys
from numba.extending import overload
from cotouch.kernels import kernel, part

def plus(x, y): ...
def times(x, y): ...

def arithmetic(operation):
    @overload(operation)
    def choose(x, y):
        return (lambda x, y: x + y) if operation is plus else (lambda x, y: x * y)

arithmetic(plus)
arithmetic(times)

@part
def adds(x):
    return plus(x, x)

@part
def multiplies(x):
    return times(x, x)

@kernel
def sum(x):
    return adds(x)

@kernel
def product(x):
    return multiplies(x)

@kernel
def both(x):
    return 100.0 * adds(x) + multiplies(x)

print(globals()[sys.argv[1]](3.0))
"""


def test_what_processes_have_kept_is_not_taken_for_a_namesake(tmp_path: Path):
    """Both operations have the name of what makes them, and are the first that their process compiles."""
    script = tmp_path / "namesakes.py"
    script.write_text(NAMESAKES)
    environment = {**os.environ, "NUMBA_CACHE_DIR": str(tmp_path)}
    said = [
        subprocess.run([sys.executable, script, name], env=environment, capture_output=True, text=True, check=True)
        for name in ("sum", "product", "both")
    ]
    assert [float(each.stdout) for each in said] == [6.0, 9.0, 609.0]


CALLER = """
from cotouch.compiled import routine
from cotouch.probe_callee import large

@routine
def calls(x):
    return large(x) + 1.0
"""
CALLEE = """
from cotouch.compiled import subroutine

@subroutine
def large(x):
    {body}
    return x
"""


@pytest.fixture
def pair(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[[], tuple[float, int, int]]:
    """Two files of the package, one with a kernel that calls a large one of the other, as another process runs them."""
    copy = copytree(PACKAGE, tmp_path / "cotouch", ignore=ignore_patterns("__pycache__"))
    (copy / "probe_callee.py").write_text(
        CALLEE.format(body="\n    ".join(f"x = x * {k}.5 + {k}.0" for k in range(120)))
    )
    (copy / "probe_caller.py").write_text(CALLER)
    script = (
        "from cotouch.probe_caller import calls\nfrom cotouch.probe_callee import large\n"
        "print(calls(0.0), *(sum(f.stats.cache_hits.values()) for f in (calls, large)))"
    )

    def run() -> tuple[float, int, int]:
        environment = {**os.environ, "PYTHONPATH": str(tmp_path), "PYTHONDONTWRITEBYTECODE": "1"}
        environment.pop("NUMBA_CACHE_DIR", None)
        ran = subprocess.run(
            [sys.executable, "-c", script], env=environment, capture_output=True, text=True, check=True
        )
        value, caller, callee = ran.stdout.split()
        return float(value), int(caller), int(callee)

    monkeypatch.chdir(tmp_path)
    return run


def test_a_large_kernel_is_called_and_not_copied(tmp_path: Path, pair: Callable[[], tuple[float, int, int]]):
    value, *hits = pair()
    assert hits == [0, 0]
    assert pair() == (value, 1, 1), "who calls it brings it along"
    (caller,), (callee,) = tmp_path.rglob("probe_caller*.nbc"), tmp_path.rglob("probe_callee*.nbc")
    assert caller.stat().st_size < callee.stat().st_size, "its code is kept once"
    for file in tmp_path.rglob("probe_callee*.nb?"):
        file.unlink()
    assert pair() == (value, 1, 0), "its symbol is the same wherever it is compiled"
    for file in tmp_path.rglob("probe_callee*.nbc"):
        file.write_bytes(file.read_bytes()[:100])
    assert pair() == (value, 1, 0)
    source = tmp_path / "cotouch" / "probe_callee.py"
    source.write_text(source.read_text().replace("return x", "return x + 1.0"))
    assert pair() == (value + 1.0, 0, 0), "its source belongs to who calls it"


def test_who_calls_what_has_another_symbol_now_is_compiled_anew(
    tmp_path: Path, pair: Callable[[], tuple[float, int, int]]
):
    value, *_ = pair()
    (caller,) = tmp_path.rglob("probe_caller*.nbc")
    kept = caller.read_bytes()
    assert b"5large" in kept
    caller.write_bytes(kept.replace(b"5large", b"5lArge", 1))
    assert pair() == (value, 0, 1)
    assert pair() == (value, 1, 1)


def test_a_function_that_another_process_compiles_is_waited_for(tmp_path: Path):
    """Until that process has kept it, or has died."""
    for dies in (False, True):
        told, tell = os.pipe()
        child = os.fork()
        if child == 0:
            turns = machine._Turns()
            turns.take(str(tmp_path), ("step", (1,)))
            os.write(tell, b"1")
            time.sleep(0.2)
            os.write(tell, b"2")
            if dies:
                os._exit(1)
            turns.give(str(tmp_path), ("step", (1,)))
            time.sleep(60.0)
        try:
            assert os.read(told, 1) == b"1"
            turns = machine._Turns()
            turns.take(str(tmp_path), ("step", (2,)))  # another function is nobody's
            os.set_blocking(told, False)
            with pytest.raises(BlockingIOError):
                os.read(told, 1)
            turns.take(str(tmp_path), ("step", (1,)))
            assert os.read(told, 1) == b"2"
            turns.give(str(tmp_path), ("step", (1,)))
        finally:
            os.kill(child, signal.SIGKILL)
            os.waitpid(child, 0)
            os.close(told)
            os.close(tell)


GIVEN_UP = """
import sys
from numba.core.errors import TypingError
from cotouch.compiled import routine

@routine
def inside(x):
    return x.nothing

@routine
def outside(x):
    return inside(x)

try:
    outside(1.0)
except TypingError:
    print("given up", flush=True)
sys.stdin.read(int(sys.argv[1]))
"""


def test_a_function_that_cannot_be_compiled_keeps_nobody_waiting(tmp_path: Path):
    """Nor does one of which the compilation was interrupted; its process may go on for hours."""
    script = tmp_path / "given_up.py"
    script.write_text(GIVEN_UP)
    pipe = subprocess.PIPE
    with subprocess.Popen([sys.executable, script, "1"], stdin=pipe, stdout=pipe, text=True) as first:
        assert first.stdout is not None
        assert first.stdout.readline() == "given up\n"
        second = subprocess.run([sys.executable, script, "0"], stdout=pipe, text=True, timeout=60.0, check=True)
        assert second.stdout == "given up\n"
        assert first.poll() is None
        first.communicate("1")


def test_where_nothing_can_be_kept_nobody_is_waited_for(tmp_path: Path):
    machine._Turns().take(str(tmp_path / "gone"), "step")


def test_a_constant_in_a_call_compiles_nothing_once_more():
    """Nor does one that is told by its name."""

    @machine.routine
    def doubled(value: int, more: bool) -> int:
        return 2 * value + (1 if more else 0)

    @machine.routine
    def summed(value: int) -> int:
        return doubled(value, value > 0) + doubled(3, True) + doubled(4, more=False)

    assert summed(1) == 3 + 7 + 8
    assert len(doubled.signatures) == 1  # type: ignore[attr-defined]


COPIED = """
from cotouch.kernels import inner, kernel

@inner
def halved(x):
    if x > 100.0:
        print("much", x)
    if x < 0.0:
        raise ValueError("less than nothing")
    return 0.5 * x

@kernel
def quartered(x):
    return halved(halved(x))

@kernel
def eighth(x):
    return halved(quartered(x))
"""


def test_what_only_kernels_call_has_no_machine_code(tmp_path: Path):
    """It is kept as what others copy, and finds what it needs of Python wherever it is copied to."""
    (tmp_path / "parts.py").write_text(COPIED)
    script = (
        "import sys; from parts import eighth, halved, quartered\n"
        "if sys.argv[1:]: print(quartered(8.0))\n"
        "print(eighth(8.0), *(sum(f.stats.cache_hits.values()) for f in (eighth, quartered, halved)))\n"
        "for f in (eighth, quartered):\n"
        "    try: f(-1.0)\n"
        "    except ValueError as error: print(error)\n"
        "eighth(200.0)\n"
    )

    def ran(*options: str) -> list[str]:
        environment = {**os.environ, "PYTHONPATH": f"{tmp_path}{os.pathsep}{PACKAGE.parent}"}
        command = [sys.executable, "-c", script, *options]
        found = subprocess.run(
            command, env=environment, capture_output=True, text=True, check=True, cwd=tmp_path, timeout=60.0
        )
        return found.stdout.splitlines()

    complaints = ["less than nothing", "less than nothing", "much 200.0"]
    assert ran() == ["1.0 0 0 0", *complaints]
    assert ran() == ["1.0 1 0 0", *complaints], "who called it brings it along"
    assert ran("x") == ["2.0", "1.0 1 1 0", *complaints]
    (whole,), (part,) = tmp_path.rglob("parts.quartered*.nbc"), tmp_path.rglob("parts.halved*.nbc")
    assert b"\x7fELF" in whole.read_bytes()
    assert b"\x7fELF" not in part.read_bytes()
    for file in tmp_path.rglob("parts.quartered*.nb?"):
        file.unlink()
    assert ran("x") == ["2.0", "1.0 1 0 1", *complaints], "and who is compiled anew copies what was kept"


@pytest.fixture
def usual() -> Generator[tuple[int, int, int]]:
    """How often memory is looked through before something is compiled; it is put back afterwards."""
    had, set_here = gc.get_threshold(), (700, 11, 12)
    gc.set_threshold(*set_here)
    yield set_here
    gc.set_threshold(*had)


def test_memory_is_looked_through_less_often_while_something_is_compiled(usual: tuple[int, int, int]):
    while_compiling: list[tuple[int, ...]] = []
    over: Any = overload

    @over(seen)
    def _(number: int) -> Any:
        while_compiling.append(gc.get_threshold())

        def found(number: int) -> int:
            return number

        return found

    compiled_here: Any = numba.njit  # not kept: in every run

    @compiled_here
    def made(number: int) -> int:
        return seen(number)

    assert made(1) == 1
    assert while_compiling
    assert {first for first, *_ in while_compiling} == {50_000}
    assert gc.get_threshold() == usual


def seen(number: int) -> int:
    """Stands for what numba finds the types of while it compiles."""
    return number


def test_options_are_alike_where_numba_says_so():
    flags: Any = Flags
    one, same, other = flags(), flags(), flags()
    same.nrt, other.nrt = one.nrt, not one.nrt
    assert one == same
    assert one != other
    assert hash(one) == hash(same)
    assert one != "nrt"


def test_generators_and_functions_of_pythons_objects_are_compiled_as_ever():
    """They alone ask what lives where a block begins, which numba would work out nine times for each kernel."""
    any_numba: Any = numba

    @any_numba.njit
    def sums(most: int) -> Generator[int]:
        total = 0
        for number in range(most):
            total += number
            yield total

    @any_numba.jit(forceobj=True)
    def spaced(text: str) -> str:
        found = ""
        for letter in text:
            found += letter + "-"
        return found

    assert list(sums(4)) == [0, 1, 3, 6]
    assert spaced("ab") == "a-b-"
