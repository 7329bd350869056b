"""Making a process fit for a loop at 1 kHz, and undoing it: what would interrupt the loop, as far as it can be had."""

import contextlib
import ctypes
import gc
import os
import sys
from collections.abc import Callable, Generator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cache
from importlib import import_module
from typing import final

_SET_TIMER_SLACK, _GET_TIMER_SLACK = 29, 30  # of prctl(2)
_SLACK = 1  # [ns]
# Another thread that computes must hand over the interpreter sooner than after 5 ms, Python's default.
_SWITCH = 200e-6
# Threads that come and go, as Zenoh's do whenever a path breaks, leave memory behind in arenas of their own, of which
# glibc makes up to eight times the cores. Number of arenas, and of `mallopt`'s parameter for it.
_ARENAS, _ARENA_MAX = 2, -8
_BLAS = ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS")


@final
@dataclass(frozen=True, kw_only=True)
class ProcessState:
    """What the process obtained.

    Attributes:
        timer_slack: how much later the kernel may end a sleep; None where it cannot be said [ns].
        real_time: priority under SCHED_FIFO; None without.
        real_time_refused: why not; None with it.
        blas_threads: 1, or None where it is not known how many there are.
        collector_off: whether the garbage collector is kept out.
        switch_interval: of the interpreter [s].
    """

    timer_slack: int | None
    real_time: int | None
    real_time_refused: str | None
    blas_threads: int | None
    collector_off: bool
    switch_interval: float


def few_arenas() -> bool:
    """Lets all threads share two of glibc's memory arenas, so that memory stays flat as threads come and go.

    To be called before threads are started; whoever set `MALLOC_ARENA_MAX` keeps it. Cannot be undone.

    Returns:
        Whether it is so from now on; False with another libc.
    """
    if "MALLOC_ARENA_MAX" in os.environ:
        return False
    mallopt = _of_libc("mallopt")
    return mallopt is not None and mallopt(_ARENA_MAX, _ARENAS) == 1


def give_back_memory() -> bool:
    """Returns memory to the system that glibc's allocator holds unused, wherever in its arenas it is.

    Takes about a millisecond, in which other threads may wait for memory: for calm times.

    Returns:
        Whether there was anything to give back; False with another libc.
    """
    trim = _of_libc("malloc_trim")
    return trim is not None and trim(0) == 1


@cache
def _of_libc(name: str) -> Callable[..., int] | None:
    """A function of Linux's libc, if it has it; looked up once, as every `CDLL` leaves a cycle behind."""
    if not sys.platform.startswith("linux"):
        return None
    try:
        return getattr(ctypes.CDLL(None), name)
    except (OSError, AttributeError):
        return None


@contextmanager
def prepare_process(*, real_time: int | None = 10) -> Generator[ProcessState]:
    """Prepares this process and the entering thread, for as long as the context lasts.

    Collects garbage, then keeps the collector from looking at what is there and from running; one BLAS thread; sleeps
    that end when they should; real-time priority where it is permitted. What is refused is left out and said.

    Args:
        real_time: priority under SCHED_FIFO, 1 to 99; None: do not ask. It is only asked for with one BLAS thread: with
            several, threads that wait for each other by spinning never end.
    """
    with contextlib.ExitStack() as undo:
        blas = _one_blas_thread(undo)
        slack = _timer_slack(undo)
        before = sys.getswitchinterval()
        undo.callback(sys.setswitchinterval, before)
        sys.setswitchinterval(min(before, _SWITCH))
        was_on = gc.isenabled()
        gc.collect()
        gc.freeze()
        gc.disable()
        undo.callback(gc.unfreeze)
        if was_on:
            undo.callback(gc.enable)
        priority, refused = (None, "not asked for") if real_time is None else _real_time(real_time, blas, undo)
        yield ProcessState(
            timer_slack=slack,
            real_time=priority,
            real_time_refused=refused,
            blas_threads=blas,
            collector_off=not gc.isenabled(),
            switch_interval=sys.getswitchinterval(),
        )


def real_time_refused(priority: int) -> str | None:
    """Whether this user's processes may have real-time priority.

    Args:
        priority: under SCHED_FIFO, 1 to 99.

    Returns:
        Why not; None if they may.
    """
    with contextlib.ExitStack() as undo:
        return _real_time(priority, 1, undo)[1]


def _one_blas_thread(undo: contextlib.ExitStack) -> int | None:
    """One thread, by threadpoolctl if it is there; else the environment may have said so before numpy was loaded."""
    try:
        threadpoolctl = import_module("threadpoolctl")
    except ImportError:
        return 1 if any(os.environ.get(name) == "1" for name in _BLAS) else None
    limits = threadpoolctl.threadpool_limits(limits=1)
    undo.callback(limits.restore_original_limits)
    return 1


def _timer_slack(undo: contextlib.ExitStack) -> int | None:
    prctl = _of_libc("prctl")
    if prctl is None:
        return None
    before = int(prctl(_GET_TIMER_SLACK, 0, 0, 0, 0))
    if before < 0 or prctl(_SET_TIMER_SLACK, _SLACK, 0, 0, 0) != 0:
        return None
    undo.callback(prctl, _SET_TIMER_SLACK, before, 0, 0, 0)
    return int(prctl(_GET_TIMER_SLACK, 0, 0, 0, 0))


def _real_time(priority: int, blas: int | None, undo: contextlib.ExitStack) -> tuple[int | None, str | None]:
    if blas != 1:
        return None, "BLAS may have several threads; install threadpoolctl or set OPENBLAS_NUM_THREADS=1"
    if not hasattr(os, "sched_setscheduler"):
        return None, "this system has no SCHED_FIFO"
    before, parameters = os.sched_getscheduler(0), os.sched_getparam(0)
    # Threads and processes that this one starts, such as the recorder's, stay out of it.
    policy = os.SCHED_FIFO | getattr(os, "SCHED_RESET_ON_FORK", 0)
    try:
        os.sched_setscheduler(0, policy, os.sched_param(priority))
    except (OSError, ValueError) as error:
        return None, f"{error}"
    undo.callback(os.sched_setscheduler, 0, before, parameters)
    return priority, None
