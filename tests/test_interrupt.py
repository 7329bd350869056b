"""Ctrl-C reaches whoever called, at once, and ends what was called."""

import os
import signal
import sys
import threading
import time
from collections.abc import Callable
from typing import Any

import numba
import numpy as np
import pytest

from cotouch import simulate, tune_springs
from cotouch.compiled import raised
from cotouch.interrupt import check, finishing, flag, interruptible
from cotouch.network import Network
from cotouch.planning import plan

# What any wait is bounded by; what is waited for takes a fraction of a second [s].
_PATIENCE = 60.0


@numba.njit(nogil=True)
def spin(stop: Any, started: Any) -> int:
    """Works until it is stopped."""
    started[0] = 1
    turns = 0
    while not raised(stop):
        turns += 1
    return turns


def worker() -> threading.Thread | None:
    return next((thread for thread in threading.enumerate() if thread.name == "cotouch work"), None)


class Interrupted:
    """Sends this process a SIGINT as soon as something is so, and expects that it ends what goes on here."""

    def __init__(self, when: Callable[[], bool]) -> None:
        self.when = when
        self.thread: threading.Thread | None = None

    def _send(self) -> None:
        end = time.monotonic() + _PATIENCE
        while not self.when() and time.monotonic() < end:
            time.sleep(0.01)
        self.thread = worker()
        os.kill(os.getpid(), signal.SIGINT)

    def __enter__(self) -> "Interrupted":
        self.sender = threading.Thread(target=self._send)
        self.sender.start()
        self.expected = pytest.raises(KeyboardInterrupt)
        self.expected.__enter__()
        return self

    def __exit__(self, *error: Any) -> bool:
        self.sender.join()
        return self.expected.__exit__(*error)

    def ended(self) -> bool:
        """Whether the thread that worked comes to its end."""
        if self.thread is not None:
            self.thread.join(_PATIENCE)
        return self.thread is None or not self.thread.is_alive()


def working_in(name: str) -> Callable[[], bool]:
    """Whether the work has for a moment stood where a Python function of that name calls a kernel."""
    seen: list[int] = []

    def look() -> bool:
        thread = worker()
        frame = None if thread is None or thread.ident is None else sys._current_frames().get(thread.ident)
        if frame is None or frame.f_code.co_name != name:
            seen.clear()
        else:
            seen.append(frame.f_lineno)
        return len(seen) > 20 and len(set(seen[-20:])) == 1

    return look


def test_a_kernel_ends_and_its_caller_goes_on() -> None:
    started, turns = np.zeros(1, np.int64), []
    spin(np.ones(1, np.int64), np.zeros(1, np.int64))
    with Interrupted(lambda: bool(started[0])) as sent:
        interruptible(lambda: turns.append(spin(flag(), started)))()
    assert sent.ended()
    assert turns[0] > 0
    assert interruptible(lambda: 42)() == 42


def test_what_cannot_be_stopped_is_not_waited_for() -> None:
    release = threading.Event()
    started = threading.Event()

    def stubborn() -> None:
        started.set()
        release.wait()
        check()  # raised for it alone: what is called meanwhile goes on

    with Interrupted(started.is_set) as sent:
        interruptible(stubborn)()
    assert sent.thread is not None
    assert sent.thread.is_alive()
    interruptible(check)()
    release.set()
    assert sent.ended()


def test_errors_results_and_other_threads_are_as_without_it() -> None:
    @interruptible
    def add(a: int, b: int = 0) -> int:
        """Sums."""
        if b < 0:
            raise ValueError("b")
        return a + b

    assert add(1, b=2) == 3
    assert add.__doc__ == "Sums."
    with pytest.raises(ValueError, match="b"):
        add(1, b=-1)
    threads: list[threading.Thread] = []
    inside = interruptible(lambda: threads.append(threading.current_thread()))
    inside()
    assert threads[0].name == "cotouch work"
    other = threading.Thread(target=inside)
    other.start()
    other.join()
    assert threads[1] is other
    assert not flag()[0]


def long_run() -> dict[str, Any]:
    return {
        "network": {"users": ["a", "b"], "spring": [[0, 50], [50, 0]], "delay": [[0, 0.01], [0.01, 0]]},
        "body": {"kind": "lattice", "shape": [12, 12, 12], "ground": "z-", "ground_stiffness": 100.0},
        "steps": {"duration": 1000.0},
        "record": {"every": 1000},
    }


def circle(users: int) -> Network:
    angle = 2.0 * np.pi * np.arange(users) / users
    apart = np.abs(np.exp(1j * angle)[:, None] - np.exp(1j * angle)[None, :])
    delay = 0.02 + 0.1 * apart + 0.01 * np.sin(np.add.outer(3.0 * np.arange(users), 5.0 * np.arange(users)))
    np.fill_diagonal(delay, 0.0)
    return Network(users=[str(i) for i in range(users)], spring=50.0 * (1.0 - np.eye(users)), delay=delay)


def test_a_simulation_ends() -> None:
    with Interrupted(working_in("run_batch")) as sent:
        simulate(long_run())
    assert sent.ended()
    tables = long_run()
    assert simulate({**tables, "steps": {"duration": 0.01}, "record": {}}).attrs["finished"]


@pytest.mark.parametrize("objective", ["consensus", "decay"])
def test_a_plan_ends(objective: Any) -> None:
    with Interrupted(lambda: worker() is not None) as sent:
        plan(circle(24), links=60, objective=objective, rounding="nearest", method="local", starts=10_000)
    assert sent.ended()
    assert plan(circle(4), links=4, objective=objective, rounding="nearest").status == "proved"


def test_tuning_springs_ends() -> None:
    network = circle(12)
    tune_springs(circle(3), damping_limit=5.0, rounds=1)
    with Interrupted(lambda: worker() is not None) as sent:
        tune_springs(network, damping_limit=50.0)
    assert sent.ended()


@pytest.mark.slow
def test_what_has_something_to_tell_is_waited_for(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("cotouch.interrupt._GRACE", 3.0)

    def tell() -> None:
        os.kill(os.getpid(), signal.SIGINT)
        while not flag()[0]:
            time.sleep(0.001)
        finishing(flag())
        time.sleep(4.0)  # longer than anything is waited for that says nothing
        raise KeyboardInterrupt("what was found")

    with pytest.raises(KeyboardInterrupt, match="what was found"):
        interruptible(tell)()


def test_who_was_not_interrupted_does_not_finish() -> None:
    own = np.zeros(1, dtype=np.int64)
    finishing(own)
    assert own[0] == 0
