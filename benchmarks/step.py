"""One full step of a peer on lattices, beside the memory bound, the same step in C, and MuJoCo flex.

The bound is the bytes that the step has to move, divided by the bandwidth of the better of copy and triad (counted as
STREAM does: reads and writes, 16 and 24 bytes an element) over arrays as large together as what the solver goes
round. With n rows, E off-diagonal entries, L links and F the bytes of one field, which is 32 n as stored (three axes
padded to four) and 24 n at the least:

    an iteration   of Chebyshev, two half sweeps: 4 F + 12 E + 12 n
    once           assemble: (4 + L) F + 40 n;  bound and start: 2 F + 32 n;  scale: 2 F;
                   move and links: (6 + L) F + 8 n;  books: 4 F + 12 E + 28 n

k iterations have 2 k - 1 half sweeps, because the start is the first; what the scale sums up is as much as one more.
Whatever a pass reads twice is taken to be still in cache the second time.
"""

import contextlib
import ctypes
import os
import shutil
import subprocess
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numba
import numpy as np

from benchmarks._copy import CAP, MASS, PERIOD, TOLERANCE, Copy, called, compiled, copy, cube
from benchmarks._report import Row, command, interleave, ratio
from cotouch.body import point
from cotouch.mechanics import ITERATIONS, KINETIC

SIDES = (10, 17, 27)
MAIN = 17
ROUNDS = 15
_MUJOCO_SIDES = (10, 17)


def bytes_moved(c: Copy, iterations: float, columns: int) -> float:
    """Bytes that a step has to move; the formula is at the head of this module."""
    op = c.model.operator
    n, entries, links = op.mass.size, op.column.size, c.links.slot.size
    field = 8 * columns * n
    each = 4 * field + 12 * entries + 12 * n
    once = (18 + 2 * links) * field + 12 * entries + 108 * n
    return iterations * each + once


@numba.njit(nogil=True)
def _copy(a: Any, b: Any, times: int) -> None:
    for _ in range(times):
        for i in range(a.size):
            a[i] = b[i]


@numba.njit(nogil=True, fastmath=True)
def _triad(a: Any, b: Any, c: Any, times: int) -> None:
    for _ in range(times):
        for i in range(a.size):
            a[i] = b[i] + 3.0 * c[i]


def _streams(c: Copy) -> tuple[dict[str, Callable[[], object]], dict[str, float]]:
    """Copy and triad over as many bytes as the solver goes round, and the bytes that a call moves."""
    op = c.model.operator
    working = 2 * c.work.mean.nbytes + 12 * op.column.size + 12 * op.mass.size
    times = max(1, int(2e7 / working))
    half, third = (np.ones((count, working // (8 * count))) for count in (2, 3))
    actions: dict[str, Callable[[], object]] = {
        "copy": lambda: _copy(half[0], half[1], times),
        "triad": lambda: _triad(third[0], third[1], third[2], times),
    }
    return actions, {"copy": 16.0 * times * half.shape[1], "triad": 24.0 * times * third.shape[1]}


class Reference:
    """The same step in C."""

    def __init__(self, folder: Path) -> None:
        """Compiles it.

        Raises:
            OSError: there is no compiler, or it fails.
        """
        compiler = shutil.which("gcc") or shutil.which("cc")
        if compiler is None:
            raise OSError("no C compiler was found")
        library = folder / "step.so"
        source = Path(__file__).parent / "step.c"
        options = ["-O3", "-march=native", "-ffp-contract=fast", "-shared", "-fPIC"]
        built = subprocess.run([compiler, *options, str(source), "-o", str(library)], capture_output=True, check=False)
        if built.returncode:
            raise OSError(f"the C compiler failed: {built.stderr.decode()[:200]}")
        self._run = ctypes.CDLL(str(library)).run
        self._run.restype = ctypes.c_long

    def of(self, c: Copy) -> Callable[[], int]:
        """All steps of a copy."""
        op, s, g, w = c.model.operator, c.state, c.ports, c.work
        assert op.entries.shape[0] == 1
        assert c.model.width == 4
        sizes = [op.mass.size, c.links.slot.size, g.row.size, c.links.slot.size, CAP, c.lengths.size, op.split]
        numbers = [op.copy_scale, op.mix[1, 0], op.mix[2, 0], c.local[0], TOLERANCE]
        arrays = [
            *(c.lengths, op.mass, op.damping, op.stiffness, op.pointer, op.column, op.entries),
            op.magnitude,
            *(s.position, s.velocity, s.tension, c.links.samples, c.links.strength),
            *(g.row, g.stiffness, g.damping, g.start, g.end, g.push, g.force),
            *(w.diagonal, w.inverse, w.rhs, w.mean, c.ledger, c.link_work),
        ]
        size = (ctypes.c_long * len(sizes))(*sizes)
        number = (ctypes.c_double * len(numbers))(*numbers)
        array = (ctypes.c_void_p * len(arrays))(*(a.ctypes.data for a in arrays))

        def run(keep_alive: Copy = c) -> int:  # C sees addresses only
            del keep_alive
            return self._run(size, number, array)

        return run


def _flex(side: int, integrator: str, softer: float) -> Callable[[], object]:
    """A step of MuJoCo flex on the same grid: same mass and spring per edge (Young's modulus k/h), no contact."""
    import mujoco

    spacing = 0.01
    young = MASS / side**3 * (2.0 * 1.8 / PERIOD) ** 2 / 12.0 / spacing / softer
    text = f"""
    <mujoco>
      <option timestep="{PERIOD}" gravity="0 0 0" integrator="{integrator}"><flag contact="disable"/></option>
      <size memory="2G"/>
      <worldbody>
        <flexcomp name="f" type="grid" count="{side} {side} {side}" spacing="{spacing} {spacing} {spacing}" dim="3"
                  mass="{MASS}" radius="0.001">
          <elasticity young="{young}" poisson="0"/>
          <contact selfcollide="none" contype="0" conaffinity="0"/>
        </flexcomp>
      </worldbody>
    </mujoco>"""
    model = mujoco.MjModel.from_xml_string(text)
    data = mujoco.MjData(model)
    data.qvel[:] = np.random.default_rng(1).normal(size=model.nv, scale=1e-2)

    def advance() -> None:
        mujoco.mj_step(model, data)
        assert not any(warning.number for warning in data.warning), "MuJoCo's motion left its range"

    return advance


def _diverges(advance: Callable[[], object], steps: int = 50) -> bool:
    """Whether a few steps are enough to leave the range of numbers."""
    try:
        for _ in range(steps):
            advance()
    except AssertionError:
        return True
    return False


def _us(seconds: np.ndarray) -> str:
    value = 1e6 * float(np.median(seconds))
    return f"{value:,.0f} µs" if value >= 10 else f"{value:.2f} µs"


def lattices(reference: Reference | None) -> list[Row]:
    """The step against the bound and against C, for every size."""
    rows: list[Row] = []
    for side in SIDES:
        steps = max(2, 60_000 // side**3)
        ours, theirs, python = (copy(cube(side), steps=steps) for _ in range(3))
        streams, volume = _streams(ours)
        actions: dict[str, Callable[[], object]] = {"numba": lambda ours=ours: compiled(ours), **streams}
        if reference is not None:
            actions["c"] = reference.of(theirs)
        if side == MAIN:
            actions["python"] = lambda python=python: called(python)
        seconds = interleave(actions, ROUNDS)
        iterations = compiled(ours) / steps
        if reference is not None:
            actions["c"]()
            gap = np.abs(ours.state.position - theirs.state.position).max() / np.abs(ours.state.position).max()
            assert gap < 1e-9, f"the kernel and C differ by {gap:g}"
        each = seconds["numba"] / steps
        speed = np.maximum(*(volume[name] / seconds[name] for name in ("copy", "triad")))
        stored, least = (ratio(each, bytes_moved(ours, iterations, columns) / speed) for columns in (4, 3))
        bound = bytes_moved(ours, iterations, 4) / float(np.median(speed))
        rows.append(
            Row(
                "step",
                f"lattice of {side**3:,} nodes, T changing, tol 1e-6",
                _us(each),
                "",
                f"{iterations:.1f} iterations; {float(np.median(speed)) / 1e9:.0f} GB/s",
            )
        )
        goal = "≤ 2" if side == MAIN else ""
        rows.append(
            Row(
                "step",
                "— over the bound, bytes as stored",
                f"{stored:.2f}",
                goal,
                f"bound {1e6 * bound:,.0f} µs; over the bound with three columns {least:.2f}",
            )
        )
        if reference is not None:
            note = f"{ratio(each, seconds['c'] / steps):.2f} is ours over it"
            rows.append(Row("step", "— the same step in C", _us(seconds["c"] / steps), "", note))
        if side == MAIN:
            extra = float(np.median(seconds["python"] / steps - each))
            rows.append(
                Row("step", "— a call from Python costs in addition", f"{1e6 * extra:,.0f} µs", "", "each step")
            )
    return rows


def rivals() -> list[Row]:
    """The step beside MuJoCo flex."""
    try:
        import mujoco
    except ImportError:
        return [Row("step", "MuJoCo flex", "not installed")]
    rows: list[Row] = []
    with tempfile.TemporaryDirectory() as folder, contextlib.chdir(folder):  # MuJoCo logs into the working directory
        for side in _MUJOCO_SIDES:
            with _quiet():
                actions = {
                    "flex": _flex(side, "discrete", 1.0),
                    "explicit": _flex(side, "Euler", 10.0),
                }
                diverges = _diverges(_flex(side, "Euler", 1.0))
            steps = 20
            ours, tied = copy(cube(side), steps=steps), copy(cube(side), steps=steps, spring=60.0)
            seconds = interleave(
                {**actions, "numba": lambda c=ours: compiled(c), "tied": lambda c=tied: compiled(c)}, 9
            )
            faster = {name: ratio(seconds[name], seconds["numba"] / steps) for name in actions}
            goal = "≥ 80 ×" if side == MAIN else ""
            what = f"MuJoCo {mujoco.__version__} flex, {side**3:,} nodes"
            rows += [
                Row(
                    "step",
                    f"{what}, implicit (discrete)",
                    _ms(seconds["flex"]),
                    goal,
                    f"ours is {faster['flex']:.0f} × faster with links so weak that they help the solver nothing",
                ),
                Row(
                    "step",
                    "— compared with ours, with links of 60 N/m at every node and their damping",
                    _us(seconds["tied"] / steps),
                    "",
                    f"{compiled(tied) / steps:.1f} iterations; ours is then "
                    f"{ratio(seconds['flex'], seconds['tied'] / steps):.0f} × faster than discrete",
                ),
                Row(
                    "step",
                    f"{what}, explicit Euler, 10 × softer",
                    _ms(seconds["explicit"]),
                    "",
                    f"ours, at full stiffness, is {faster['explicit']:.0f} × faster; Euler "
                    f"{'diverges' if diverges else 'holds'} at that stiffness",
                ),
            ]
    return rows


def _ms(seconds: np.ndarray) -> str:
    return f"{1e3 * float(np.median(seconds)):.1f} ms"


@contextlib.contextmanager
def _quiet() -> Any:
    """Keeps what a C library prints while it reads a model off the screen."""
    kept = os.dup(2)
    with open(os.devnull, "w") as nowhere:  # noqa: PTH123
        os.dup2(nowhere.fileno(), 2)
    try:
        yield
    finally:
        os.dup2(kept, 2)
        os.close(kept)


def closed_forms() -> list[Row]:
    """Where the solve is a division: a point, and a lattice in its modes."""
    dot = copy(point(mass=1.0, stiffness=10.0, damping=0.1, rest=[0.0, 0.0, 0.0]), steps=100_000)
    modal, nodal = (copy(cube(8, "all"), steps=200, basis=basis) for basis in ("modal", "nodal"))
    seconds = interleave(
        {"point": lambda: compiled(dot), "modal": lambda: compiled(modal), "nodal": lambda: compiled(nodal)}, ROUNDS
    )
    for c in (dot, modal):
        assert c.ledger[ITERATIONS] == 0
        assert np.isfinite(c.ledger[KINETIC])
    each = {"point": seconds["point"] / 1e5, "modal": seconds["modal"] / 200, "nodal": seconds["nodal"] / 200}
    gain = ratio(each["nodal"], each["modal"])
    return [
        Row("step", "point in three dimensions", f"{1e9 * np.median(each['point']):.0f} ns", "", "closed form"),
        Row(
            "step",
            "lattice of 512 nodes in its modes",
            _us(each["modal"]),
            "",
            f"by iteration {_us(each['nodal'])}, {gain:.1f} × as long; 8 hands",
        ),
    ]


def measure() -> list[Row]:
    """Rows of the table."""
    with tempfile.TemporaryDirectory() as folder:
        try:
            reference: Reference | None = Reference(Path(folder))
            missing: list[Row] = []
        except OSError as error:
            reference, missing = None, [Row("step", "the same step in C", "skipped", "", str(error))]
        return [*lattices(reference), *missing, *closed_forms(), *rivals()]


if __name__ == "__main__":
    command(measure, __doc__)
