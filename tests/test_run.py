"""Two runs at once, of which one gives way; what they say, and how they end."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from tests.conftest import IMPORTS
from tests.keeper import marked
from tests.run import both, give_way, stand_back

PYTHON = [sys.executable, "-S", "-c"]


def test_both_codes_are_told():
    timed, others = ([*PYTHON, f"raise SystemExit({code})"] for code in (2, 3))
    assert both([timed], [(others, give_way)]) == ([3], [2])


def test_the_second_of_the_others_waits_for_the_first_of_the_timed_and_for_nothing_else(tmp_path: Path):
    """It may be what the first of the timed cannot bear; the first of the others goes on beside it."""

    def noted(name: str, wait: float) -> list[str]:
        return [*PYTHON, f"import time; log = open({str(tmp_path / 'log')!r}, 'a'); log.write('{name} begins\\n'); "
                f"log.flush(); time.sleep({wait}); log.write('{name} ends\\n')"]  # fmt: skip

    timed, others = [noted("one", 0.6), noted("two", 1.2)], [noted("first", 1.5), noted("second", 0.1)]
    assert both(timed, [(command, give_way) for command in others]) == ([0, 0], [0, 0])
    lines = (tmp_path / "log").read_text().splitlines()
    order = [lines.index(line) for line in ("first begins", "one ends", "second begins", "second ends", "first ends")]
    assert order == sorted(order)
    assert lines.index("one ends") < lines.index("two begins") < lines.index("two ends")


def test_what_is_timed_waits_for_a_process_and_the_others_do_not(tmp_path: Path):
    done, begun = tmp_path / "done", tmp_path / "begun"
    wait = f"import os, time\nwhile not os.path.exists({str(begun)!r}): time.sleep(0.01)\nopen({str(done)!r}, 'w')"
    look = f"import os; raise SystemExit(not os.path.exists({str(done)!r}))"
    with subprocess.Popen([*PYTHON, wait]) as before:
        assert both([[*PYTHON, look]], [([*PYTHON, f"open({str(begun)!r}, 'w')"], give_way)], before) == ([0], [0])


def test_one_gives_way_and_the_other_speaks_last(capfd: pytest.CaptureFixture[str]):
    nice = "import os; print(os.nice(0))"
    wait = f"{nice}; import time; time.sleep(0.1)"
    assert both([[*PYTHON, nice]], [([*PYTHON, wait], give_way)]) == ([0], [0])
    others, timed = map(int, capfd.readouterr().out.split())
    assert timed == os.nice(0)
    assert others == min(timed + 10, 19)


@pytest.mark.skipif(not hasattr(os, "SCHED_IDLE"), reason="only Linux has it")
def test_one_stands_back(capfd: pytest.CaptureFixture[str]):
    how = [*PYTHON, "import os; print(os.sched_getscheduler(0))"]
    others = [*how[:-1], f"{how[-1]}; import time; time.sleep(0.1)"]
    assert both([how], [(others, stand_back)]) == ([0], [0])
    assert capfd.readouterr().out.split() == [str(os.SCHED_IDLE), str(os.SCHED_OTHER)]


WAITS = """
import os, sys
sys.path.insert(0, {root!r})
from tests.leftovers import none_left
from tests.run import both, give_way, obey
obey()
with none_left():
    both(
        [[sys.executable, "-S", "-c", "print('one'); import time; time.sleep(600)"]],
        [([sys.executable, "-S", "-c", "print('other', flush=True); import time; time.sleep(600)"], give_way)],
    )
"""


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGINT, signal.SIGKILL])
def test_nothing_goes_on_after_it(number: signal.Signals):
    mark = f"run-{os.getpid()}-{number}"
    env = {**os.environ, "PYTHONPATH": IMPORTS, "COTOUCH_RUN": mark}
    command = [sys.executable, "-c", WAITS.format(root=str(Path(__file__).parent.parent))]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, env=env) as run:
        assert run.stdout is not None
        assert run.stdout.readline() == b"other\n"
        while len(marked(mark)) < 4:  # the other one begins first
            assert run.poll() is None
            time.sleep(0.01)
        if number == signal.SIGINT:  # as the terminal does, all of them but the keeper
            for pid in marked(mark):
                os.kill(pid, number)
        else:
            run.send_signal(number)
        run.wait(60)
        assert run.returncode != 0
        while marked(mark):
            time.sleep(0.01)
