"""Work that ends when its time is up, or when it is interrupted, whatever it is at."""

import threading
import time
from collections.abc import Callable, Generator
from contextlib import contextmanager
from typing import TypeVar

import numpy as np

from cotouch.interrupt import Flag, finishing, flag, heeding

R = TypeVar("R")

# How soon a deadline is seen, and a flag by who waits for what hears none [s].
_LOOK = 0.02


# A budget lasts up to so many times as long where others keep this process from working.
_PATIENCE = 4.0


def worked() -> float:
    """A clock [s] that stands nearly still while others have the processors, at a quarter of its pace.

    What a search finds in a budget by it depends less on how busy the machine is, and it still ends.
    """
    return (1.0 - 1.0 / _PATIENCE) * time.process_time() + time.monotonic() / _PATIENCE


def in_real_time(clock: Callable[[], float]) -> bool:
    """Whether a clock goes on by itself, so that a thread may watch it; one of a test need not."""
    return clock in (time.monotonic, worked)


@contextmanager
def until(late: Callable[[], bool]) -> Generator[None]:
    """Raises a flag of its own once it is late, or once the current one is raised, whose owner then waits a little.

    Args:
        late: whether the time is up; asked again and again, in another thread.
    """
    own: Flag = np.zeros(1, dtype=np.int64)
    asked, over = flag(), threading.Event()

    def watch() -> None:
        while not over.wait(_LOOK):
            finishing(asked)
            if asked[0] or late():
                own[0] = 1

    threading.Thread(target=watch, name="cotouch deadline", daemon=True).start()
    try:
        with heeding(own):
            yield
    finally:
        over.set()


def aside(work: Callable[[], R], stop: Flag | None = None) -> R:
    """What a function gives that hears no flag, such as eigenvalues of a large matrix; once one is raised it is left.

    Args:
        work: the function; it goes on alone, and what it gives then is lost.
        stop: the flag; None: the current one.

    Raises:
        KeyboardInterrupt: the flag is raised.
    """
    heard, done = flag() if stop is None else stop, threading.Event()
    results: list[R] = []
    errors: list[BaseException] = []

    def call() -> None:
        try:
            results.append(work())
        except BaseException as error:  # noqa: BLE001  it is raised where it was called
            errors.append(error)
        finally:
            done.set()

    if not heard[0]:
        threading.Thread(target=call, name="cotouch aside", daemon=True).start()
    while not heard[0] and not done.wait(_LOOK):
        pass
    if not done.is_set():
        raise KeyboardInterrupt
    if errors:
        raise errors[0]
    return results[0]
