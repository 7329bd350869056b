"""Ctrl-C while kernels run.

Python heeds a signal between two of its own instructions, in its main thread. A kernel is one instruction, however long
it takes, and so is its compilation. What may take long therefore runs in a thread of its own, while the main thread
waits and is there for the signal. It then raises a flag that the kernels look at, so that they end too.
"""

import threading
from collections.abc import Callable, Generator
from contextlib import contextmanager
from contextvars import ContextVar, copy_context
from functools import wraps
from typing import ParamSpec, TypeAlias, TypeVar

import numpy as np
import numpy.typing as npt

Flag: TypeAlias = npt.NDArray[np.int64]

P = ParamSpec("P")
R = TypeVar("R")

_NEVER: Flag = np.zeros(1, dtype=np.int64)
_CURRENT: ContextVar[Flag] = ContextVar("flag", default=_NEVER)
# So long is waited for what was interrupted to end by itself. A compilation does not: its thread goes on alone, and
# what it compiles is there the next time [s].
_GRACE = 0.5
# And for what has heard it and is about to tell what it has [s].
_FINISHING, _LAST = 2, 5.0
# Some systems wake a thread that waits for a lock only when its time is up [s].
_POLL = 0.2


def flag() -> Flag:
    """What a kernel that may last looks at by `compiled.raised`, (1,): not 0 once it shall end."""
    return _CURRENT.get()


def check() -> None:
    """Ends what was interrupted: to be called after such a kernel, and in loops that call many.

    Raises:
        KeyboardInterrupt: the flag is raised.
    """
    if flag()[0]:
        raise KeyboardInterrupt


def finishing(asked: Flag) -> None:
    """Asks whoever waits for what was interrupted for a little more time: it has something to tell.

    Args:
        asked: the flag of what was interrupted.
    """
    if asked[0]:
        asked[0] = _FINISHING


@contextmanager
def heeding(own: Flag) -> Generator[None]:
    """Makes a flag the current one, in a thread that knows it by what it was given."""
    before = _CURRENT.set(own)
    try:
        yield
    finally:
        _CURRENT.reset(before)


def interruptible(function: Callable[P, R]) -> Callable[P, R]:
    """Makes a function that Ctrl-C ends at once, whatever it is doing.

    Called by the main thread, it runs in another one. Anywhere else signals never come, and it is just called: the flag
    of whoever runs that thread counts. It raises `KeyboardInterrupt` when it is interrupted; its own, if it has one.
    """

    @wraps(function)
    def call(*args: P.args, **options: P.kwargs) -> R:
        return _call(function, *args, **options)

    return call


def _call(function: Callable[P, R], *args: P.args, **options: P.kwargs) -> R:
    if threading.current_thread() is not threading.main_thread():
        return function(*args, **options)
    own: Flag = np.zeros(1, dtype=np.int64)
    done = threading.Event()
    results: list[R] = []
    errors: list[BaseException] = []

    def work() -> None:
        try:
            with heeding(own):
                results.append(function(*args, **options))
        except BaseException as error:  # noqa: BLE001  it is raised where it was called
            errors.append(error)
        finally:
            done.set()

    thread = threading.Thread(target=copy_context().run, args=(work,), name="cotouch work", daemon=True)
    try:
        thread.start()
        while not done.wait(_POLL):
            pass
    except BaseException:
        own[0] = 1
        if not done.wait(_GRACE) and own[0] == _FINISHING:
            done.wait(_LAST)
        for error in errors:
            if isinstance(error, KeyboardInterrupt):
                raise error from None
        raise
    try:
        for error in errors:
            raise error
        return results[0]
    finally:
        errors.clear()  # their tracebacks hold this frame
