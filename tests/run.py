"""Checks and tests everything: what waits in real time, and the rest in the time that it leaves.

    python tests/run.py [--thorough]

What waits in real time leaves most of a machine idle, so everything else runs beside it. What only computes does so
from beginning to end, and only while nothing else wants a core: not even what must come within milliseconds notices.
The rest begins beside other real sessions and networks, which have patience for seconds, with a tenth of their weight:
nothing there has to wait so long that it gives up.
"""

import contextlib
import os
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Sequence
from pathlib import Path

ROOT = Path(__file__).parent.parent
# Rooms whose real tests need no kernels.
PLAIN = ("control/", "live/")
Command = Sequence[str]
# What runs is looked at so often [s].
_LOOK = 0.05
# What was interrupted has so long to say so [s].
_LAST_WORDS = 30.0


def obey() -> None:
    """Ctrl-C and SIGTERM end this process as they should, also where a shell started it in its background."""
    signal.signal(signal.SIGINT, signal.default_int_handler)
    signal.signal(signal.SIGTERM, lambda number, frame: sys.exit(128 + number))


def give_way() -> None:
    """This process, and whatever it starts, has a tenth of the others' weight."""
    os.nice(10)


def stand_back() -> None:
    """This process, and whatever it starts, runs only where nobody else wants to."""
    give_way()
    with contextlib.suppress(AttributeError, OSError):  # only Linux has it
        os.sched_setscheduler(0, os.SCHED_IDLE, os.sched_param(0))


def both(
    timed: Sequence[Command],
    others: Sequence[tuple[Command, Callable[[], None]]],
    after: "subprocess.Popen[bytes] | None" = None,
) -> tuple[list[int], list[int]]:
    """Runs commands beside others; what any but the first of the others says comes when all is done.

    Args:
        timed: what others make room for, one after the other.
        others: what gives way to it, and how. The first begins at once, the second as soon as the first of the timed is
            done, and so on.
        after: none of the timed begins before this has ended.

    Returns:
        Their codes, the others' first.
    """
    plain: list[tuple[Command, Callable[[], None] | None]] = [(command, None) for command in timed]
    rows = [plain, *([other] for other in others)]
    running: list[subprocess.Popen[bytes] | None] = [None] * len(rows)
    codes: list[list[int]] = [[] for _ in rows]
    with contextlib.ExitStack() as files:
        words = [files.enter_context(tempfile.TemporaryFile()) for _ in rows]
        try:
            while any(len(codes[row]) < len(rows[row]) for row in range(len(rows))):
                for row, process in enumerate(running):
                    at = len(codes[row])
                    free = len(codes[0]) >= row - 1 if row else after is None or after.poll() is not None
                    if process is None and at < len(rows[row]) and free:
                        command, polite = rows[row][at]
                        out, errors = (None, None) if row == 1 else (words[row], subprocess.STDOUT)
                        running[row] = subprocess.Popen(
                            command,
                            cwd=ROOT,
                            stdout=out,
                            stderr=errors,
                            preexec_fn=polite,  # noqa: PLW1509  (no threads here)
                        )
                    elif process is not None and process.poll() is not None:
                        codes[row].append(process.returncode)
                        running[row] = None
                time.sleep(_LOOK)
        except BaseException as error:
            left = [process for process in running if process is not None]
            for process in left:
                if not isinstance(error, KeyboardInterrupt):  # the terminal told them, too
                    process.terminate()
            for process in left:
                process.wait(_LAST_WORDS)
            raise
        finally:
            sys.stdout.flush()
            for said in words:
                said.seek(0)
                sys.stdout.buffer.write(said.read())
            sys.stdout.flush()
    return [code for row in codes[1:] for code in row], codes[0]


def main(options: Sequence[str]) -> int:
    """Compiles the kernels while all is checked and tests run that need none; then runs the others beside each other.

    Args:
        options: of pytest besides.

    Returns:
        What the process ends with.
    """
    sys.path.insert(0, str(ROOT))
    from tests.leftovers import none_left
    from tests.order import ALONE, PATIENT, numerical

    obey()
    pytest = [sys.executable, "-m", "pytest", *options]
    early, late = (
        [*pytest, *(f"tests/{name}" for name in PATIENT if name.startswith(PLAIN) == early)] for early in (True, False)
    )
    # One more than cores: of those that compute one may wait for what another compiles, and the others mostly wait for
    # processes and browsers.
    workers = str(max(2, len(os.sched_getaffinity(0))) + 1)
    # What pytest makes of each file is kept then: nine processes would make it anew, for eight seconds each.
    os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
    with none_left():
        collect = subprocess.Popen(
            [*pytest, "--collect-only", "--warm"],
            cwd=ROOT,
            stdout=subprocess.DEVNULL,
            preexec_fn=give_way,  # noqa: PLW1509
        )
        warm = subprocess.Popen([sys.executable, "tests/warm_up.py"], cwd=ROOT, preexec_fn=give_way)  # noqa: PLW1509
        check: Command = ["make", "--no-print-directory", "check", "THREADS=1"]
        (checked,), (first,) = both([early], [(check, give_way)])
        if checked:
            return checked
        collect.wait()
        computing = [f"tests/{name}" for name in numerical(ROOT / "tests")]
        shared = ["--dist", "loadfile", "--no-loadscope-reorder", "-m", "not timed", "--warm"]
        exact = [*pytest, *(f"tests/{name}" for name in ALONE)]
        compute = [*pytest, *shared, "-n", workers, *computing]
        rest = [*pytest, *shared, "-n", workers, *(f"--ignore={name}" for name in computing)]
        # The kernels that are still missing may be compiled by what computes: whoever needs one waits for it.
        others, timed = both([exact, late], [(compute, stand_back), (rest, give_way)], after=warm)
        return next(filter(None, (first, *timed, *others)), 0)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
