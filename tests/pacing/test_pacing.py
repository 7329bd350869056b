"""The pacer on clocks that are made up, and once on the real one; what a process is given and gives back."""

import ctypes
import gc
import math
import os
import platform
import subprocess
import sys
from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from cotouch.errors import SessionError
from cotouch.pacing import Pacer, give_back_memory, prepare_process

PERIOD = 0.001


class Clock:
    """Every look takes a microsecond; sleeps last as long as they should and a little more."""

    def __init__(self, begin: float = 0.0, oversleep: Iterator[float] | None = None) -> None:
        self.now = begin
        self.slept: list[float] = []
        self._oversleep = oversleep

    def time(self) -> float:
        self.now += 1e-6
        return self.now

    def sleep(self, seconds: float) -> None:
        assert seconds > 0.0
        self.slept.append(seconds)
        self.now += seconds + (next(self._oversleep) if self._oversleep else 0.0)


def pacer(clock: Clock, **options: float) -> Pacer:
    return Pacer(PERIOD, clock=clock.time, sleep=clock.sleep, **options)


def test_steps_end_on_the_grid() -> None:
    clock = Clock(1000.0)
    paced = pacer(clock)
    begin = clock.now
    for k in range(1, 200):
        turn = paced.wait()
        assert 0.0 <= turn.now - (begin + k * PERIOD) < 3e-6
        assert pytest.approx(PERIOD, abs=3e-6) == turn.T
        assert turn.too_long == 0.0
    assert max(clock.slept) <= PERIOD - 100e-6  # the rest is spent looking
    done = paced.statistics()
    assert (done.steps, done.missed, done.too_long) == (199, 0, 0)
    assert 0.0 <= done.late_p50 <= done.late_p99 <= done.late_p999 < 3e-6
    assert done.busy < 0.01


def test_a_late_step_takes_longer_and_none_is_made_up_for() -> None:
    clock = Clock()
    paced = pacer(clock)
    begin = clock.now
    paced.wait()
    clock.now += 5.3 * PERIOD  # the loop was away
    late = paced.wait()
    assert pytest.approx(5.3 * PERIOD, abs=5e-6) == late.T
    following = [paced.wait() for _ in range(10)]
    assert pytest.approx(0.7 * PERIOD, abs=5e-6) == following[0].T  # back on the grid
    for turn in following[1:]:
        assert pytest.approx(PERIOD, abs=5e-6) == turn.T
    for turn in following:
        assert abs((turn.now - begin) / PERIOD - round((turn.now - begin) / PERIOD)) < 0.01
    assert paced.statistics().missed == 4  # those that should have ended 3, 4, 5 and 6 periods after the beginning


def test_beyond_the_cap_the_rest_is_told() -> None:
    clock = Clock()
    paced = pacer(clock, cap=0.01)
    paced.wait()
    clock.now += 0.05
    turn = paced.wait()
    assert turn.T == 0.01
    assert turn.too_long == pytest.approx(0.04, abs=1e-5)
    assert paced.wait().too_long == 0.0
    assert paced.statistics().too_long == 1
    assert paced.statistics().period_max == pytest.approx(0.05, abs=1e-5)


@given(
    st.lists(st.floats(0.0, 0.02), min_size=1, max_size=60),
    st.lists(st.floats(0.0, 0.005), min_size=1),
    st.floats(0.0, 0.001),
)
def test_time_is_never_lost_and_steps_never_come_in_bursts(
    work: list[float], oversleep: list[float], spin: float
) -> None:
    def late() -> Iterator[float]:
        while True:
            yield from oversleep

    clock = Clock(50.0, late())
    paced = pacer(clock, spin=spin, cap=0.004)
    begin = clock.now
    turns = []
    for seconds in work:
        clock.now += seconds
        turns.append(paced.wait())
    assert sum(turn.T + turn.too_long for turn in turns) == pytest.approx(turns[-1].now - begin, abs=1e-9)
    assert all(turn.T <= 0.004 for turn in turns)
    for turn, seconds in zip(turns[1:], work[1:], strict=True):
        assert min(0.5 * PERIOD, max(seconds, 0.5 * PERIOD)) - 1e-9 <= turn.T
    for one, two in pairwise(turns):
        assert two.now > one.now


def test_a_clock_that_stands_still_ends_nothing_but_the_waiting() -> None:
    paced = Pacer(PERIOD, clock=lambda: 5.0, sleep=lambda _: None)
    turn = paced.wait()
    assert turn.now == 5.0
    assert turn.T > 0.0


class Reader:
    """Something to do while waiting: finds something when it is due, and when time `takes` has to be spent on it."""

    def __init__(self, clock: Clock, *, takes: float = 0.0, every: float = math.inf) -> None:
        self.clock = clock
        self.takes, self.every = takes, every
        self.looks: list[float] = []
        self.next = every
        self.fresh = False

    def due(self) -> float:
        return self.next

    def look(self, now: float) -> None:
        assert now <= self.clock.now
        self.looks.append(now)
        while self.next <= now:
            self.next += self.every
        self.clock.now += self.takes if self.fresh else 1e-6
        self.fresh = False


def test_what_arrived_is_read_in_time_and_again_until_shortly_before_the_deadline() -> None:
    clock = Clock()
    reader = Reader(clock, takes=200e-6)
    paced = Pacer(PERIOD, clock=clock.time, sleep=clock.sleep, idle=reader)
    begin = clock.now
    for k in range(1, 150):
        reader.fresh = True
        reader.looks.clear()
        turn = paced.wait()
        deadline = begin + k * PERIOD
        assert paced.worked == pytest.approx(200e-6, abs=5e-6)
        assert len(reader.looks) < 100
        if k < 100:  # how long reading takes is not known yet
            assert 0.0 <= turn.now - deadline < 150e-6
            continue
        assert 0.0 <= turn.now - deadline < 3e-6
        assert 280e-6 < deadline - reader.looks[0] < 320e-6  # not before it must: what comes later is read as well
        assert 29e-6 < deadline - reader.looks[-1] < 60e-6
    assert paced.statistics().busy == pytest.approx(0.2, abs=0.02)


def test_with_nothing_to_read_it_sleeps_on() -> None:
    clock = Clock()
    reader = Reader(clock, takes=200e-6)
    paced = Pacer(PERIOD, clock=clock.time, sleep=clock.sleep, idle=reader)
    for _ in range(100):
        reader.fresh = True
        paced.wait()
    clock.slept.clear()
    paced.wait()
    assert len(clock.slept) == 2
    assert sum(clock.slept) == pytest.approx(PERIOD - 100e-6, abs=5e-6)


def test_reading_that_takes_long_is_given_a_share_of_the_period_only() -> None:
    clock = Clock()
    reader = Reader(clock, takes=5e-3)
    paced = Pacer(PERIOD, clock=clock.time, sleep=clock.sleep, idle=reader)
    reader.fresh = True
    paced.wait()
    for _ in range(20):
        reader.looks.clear()
        turn = paced.wait()
        assert reader.looks[0] >= turn.now - 0.45 * PERIOD


def test_what_is_due_is_looked_at_when_it_is() -> None:
    clock = Clock()
    reader = Reader(clock, every=0.00023)
    paced = Pacer(PERIOD, clock=clock.time, sleep=clock.sleep, idle=reader)
    for _ in range(40):
        paced.wait()
        clock.now += 20e-6  # the step
    checked = 0
    for due in (n * 0.00023 for n in range(1, 170)):
        if 0.00003 < due % PERIOD < 0.00096:  # else the step, or the last look before it, is in the way
            checked += 1
            assert any(-1e-9 <= look - due < 30e-6 for look in reader.looks)
    assert checked > 140


def test_a_due_time_that_has_passed_keeps_nobody_from_sleeping() -> None:
    clock = Clock()
    reader = Reader(clock)
    reader.next = -1.0
    reader.every = 0.0
    reader.look = reader.looks.append  # does not help
    Pacer(PERIOD, clock=clock.time, sleep=clock.sleep, idle=reader).wait()
    assert sum(clock.slept) > 0.8 * PERIOD


def test_restart_begins_a_new_grid() -> None:
    clock = Clock()
    paced = pacer(clock)
    paced.wait()
    clock.now += 1.0
    paced.restart(0.005)
    assert pytest.approx(0.005, abs=1e-5) == paced.wait().T
    assert paced.statistics().steps == 1
    assert paced.period == 0.005


def test_nothing_is_known_before_the_first_step() -> None:
    done = pacer(Clock()).statistics()
    assert done.steps == 0
    assert math.isnan(done.late_p50)
    assert math.isnan(done.period_mean)


@pytest.mark.parametrize(
    ("period", "options", "nonces"),
    [
        (0.0, {}, "period is 0 s"),
        (math.nan, {}, "period is nan s"),
        (0.01, {"cap": 0.001}, "cap is 0.001 s"),
        (0.01, {"spin": -1.0}, "spin is -1 s"),
    ],
)
def test_what_makes_no_sense_is_refused(period: float, options: dict[str, float], nonces: str) -> None:
    with pytest.raises(SessionError, match=nonces):
        Pacer(period, **options)


def test_on_the_real_clock() -> None:
    paced = Pacer(0.002)
    turns = [paced.wait() for _ in range(50)]
    assert all(turn.T >= 0.001 for turn in turns)
    assert sum(turn.T for turn in turns) == pytest.approx(50 * paced.statistics().period_mean)


def test_a_process_gets_back_what_it_gave() -> None:
    interval, enabled = sys.getswitchinterval(), gc.isenabled()
    with prepare_process(real_time=None) as state:
        assert not gc.isenabled()
        assert gc.get_freeze_count() > 0
        assert state.collector_off
        assert state.real_time_refused == "not asked for"
        assert sys.getswitchinterval() == state.switch_interval <= interval
        if sys.platform.startswith("linux"):
            assert state.timer_slack == 1
    assert gc.isenabled() == enabled
    assert gc.get_freeze_count() == 0
    assert sys.getswitchinterval() == interval


@pytest.mark.parametrize("threads", ["1", "4"])
def test_real_time_only_with_one_blas_thread(threads: str) -> None:
    """In a process of its own; where it is not permitted, the reason is said."""
    program = (
        "import os\n"
        "from cotouch.pacing import prepare_process\n"
        "before = os.sched_getscheduler(0)\n"
        "with prepare_process() as state:\n"
        "    inside = os.sched_getscheduler(0) & 0xff\n"
        "print(state.real_time, inside == os.SCHED_FIFO, os.sched_getscheduler(0) == before, state.real_time_refused)\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", program],
        env={**os.environ, "OPENBLAS_NUM_THREADS": threads, "OMP_NUM_THREADS": threads, "MKL_NUM_THREADS": threads},
        capture_output=True,
        text=True,
        timeout=60,
        check=True,
    )
    priority, inside, back, refused = done.stdout.split(maxsplit=3)
    assert back == "True"
    assert (priority == "10") == (inside == "True") == (refused.strip() == "None")
    if threads == "4" and "threadpoolctl" not in sys.modules:
        try:
            import threadpoolctl  # noqa: F401
        except ImportError:
            assert "BLAS" in refused


PIECES = """
import sys
from cotouch.pacing import give_back_memory
def resident():
    with open("/proc/self/statm") as statm:
        return int(statm.read().split()[1])
before = resident()
held = [bytearray(20000) for _ in range(2000)]
kept = held[::8]  # so that what is freed lies between what is not, and the heap cannot shrink
most = resident()
del held
freed = resident()
given = give_back_memory()
print(before, most, freed, resident(), given, len(kept))
"""


@pytest.mark.skipif(platform.libc_ver()[0] != "glibc", reason="arenas are glibc's")
def test_memory_in_pieces_is_given_back():
    done = subprocess.run([sys.executable, "-c", PIECES], capture_output=True, check=True, timeout=60, text=True)
    *pages, given, _ = done.stdout.split()
    before, most, freed, after = map(int, pages)
    assert given == "True"
    assert freed - before > 0.7 * (most - before)  # glibc keeps it
    assert after - before < 0.5 * (most - before)


@pytest.mark.skipif(platform.libc_ver()[0] != "glibc", reason="only glibc is asked")
def test_giving_back_leaves_nothing_for_a_collector_that_is_off() -> None:
    def libraries() -> int:
        return sum(isinstance(one, ctypes.CDLL) for one in gc.get_objects())

    give_back_memory()
    before = libraries()
    was_on = gc.isenabled()
    gc.disable()
    try:
        for _ in range(5):
            give_back_memory()
        assert libraries() == before
    finally:
        if was_on:
            gc.enable()


ARENAS = """
import ctypes, pathlib, sys, threading
from cotouch.pacing import few_arenas
if "few" in sys.argv:
    assert few_arenas()
go, gone = threading.Barrier(13), threading.Barrier(13)
def work():
    held = [bytes(3000) for _ in range(50)]
    go.wait(20)
    gone.wait(20)
threads = [threading.Thread(target=work, daemon=True) for _ in range(12)]
for thread in threads:
    thread.start()
go.wait(20)
libc = ctypes.CDLL(None)
libc.fopen.restype = ctypes.c_void_p
stream = ctypes.c_void_p(libc.fopen(sys.argv[1].encode(), b"w"))
libc.malloc_info(0, stream)
libc.fclose(stream)
gone.wait(20)
print(pathlib.Path(sys.argv[1]).read_text().count("<heap nr="))
"""


@pytest.mark.skipif(platform.libc_ver()[0] != "glibc", reason="arenas are glibc's")
def test_threads_share_two_arenas(tmp_path: Path):
    def arenas(*options: str) -> int:
        environment = {name: value for name, value in os.environ.items() if name != "MALLOC_ARENA_MAX"}
        command = [sys.executable, "-c", ARENAS, str(tmp_path / "arenas.xml"), *options]
        return int(subprocess.run(command, capture_output=True, check=True, timeout=60, env=environment).stdout)

    assert arenas() > 4
    assert arenas("few") <= 2
