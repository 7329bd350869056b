"""What a process leaves behind when it ends, however it ends: neither its processes nor mailboxes in memory.

A child holds the end of a pipe whose other end only its parent has; the system closes that for whoever dies. A folder
in memory is locked by whoever made it; the system unlocks it likewise, and then anybody may remove it.
"""

import contextlib
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
import weakref
from collections.abc import Generator, Mapping, Sequence
from pathlib import Path
from typing import Any, Final, final

try:
    import fcntl
except ImportError:  # no Unix: folders are removed by whoever made them only
    fcntl = None

# In the environment of a child that keeps to one processor: others of ours have the rest.
ONE_THREAD: Final = dict.fromkeys(("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"), "1")
_PIPE: Final = "COTOUCH_PARENT"
# A child that is told to end and does not is ended after so long [s].
_PATIENCE: Final = 5.0
_tied = threading.Event()
_MEMORY: Final = Path("/dev/shm")  # noqa: S108  # mailboxes on a disk would wait for it
_PREFIX: Final = "cotouch-"
_OWNER: Final = "owner"


def start_child(
    command: Sequence[str], *, env: Mapping[str, str] | None = None, **options: Any
) -> "subprocess.Popen[Any]":
    """Starts a process that is told to end as soon as this one is gone, if it calls `tie_to_parent`.

    Args:
        command: program and arguments.
        env: its environment; None: this process's.
        options: of `subprocess.Popen`.

    Returns:
        The process.
    """
    theirs, ours = os.pipe()
    try:
        process = subprocess.Popen(  # noqa: S603
            command, env={**(os.environ if env is None else env), _PIPE: str(theirs)}, pass_fds=(theirs,), **options
        )
    except BaseException:
        os.close(ours)
        raise
    finally:
        os.close(theirs)
    weakref.finalize(process, os.close, ours)
    return process


@contextlib.contextmanager
def aside(module: str, function: str, *, stdin: int = subprocess.DEVNULL) -> "Generator[subprocess.Popen[bytes]]":
    """Has another process of Python call a function meanwhile; what is printed there nobody reads.

    Args:
        module: where the function is.
        function: without arguments.
        stdin: of the process, for `subprocess.Popen`.

    Yields:
        The process, which is ended on leaving.
    """
    program = f"from cotouch.processes import tie_to_parent; tie_to_parent(); from {module} import {function}; "
    command = [sys.executable, "-c", f"{program}{function}()"]
    process = start_child(command, stdin=stdin, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    try:
        yield process
    finally:
        process.kill()
        process.wait()


def tie_to_parent() -> None:
    """Ends this process soon after whoever started it by `start_child`; to be called first of all.

    It is asked by SIGTERM, so that it can leave in order, and ended if it does not. Does nothing in other processes.
    """
    pipe = os.environ.pop(_PIPE, "")
    if not pipe.isdecimal():
        return
    _tied.set()
    os.set_inheritable(int(pipe), False)
    threading.Thread(target=_watch, args=(int(pipe),), name="cotouch parent", daemon=True).start()


def tied() -> bool:
    """Whether this process is a child of another of ours, which tells the user what a Ctrl-C at both of them did."""
    return _tied.is_set()


def _watch(pipe: int) -> None:
    with contextlib.suppress(OSError):
        os.read(pipe, 1)
    remove_abandoned()
    os.kill(os.getpid(), signal.SIGTERM)
    end = time.monotonic() + _PATIENCE
    while time.monotonic() < end:  # whoever dies closes its pipes and its locks one after the other
        time.sleep(0.02)
        remove_abandoned()
    os.kill(os.getpid(), signal.SIGKILL)


@final
class MemoryFolder:
    """A private folder for mailboxes, in memory where there is such a place.

    Attributes:
        path: of it.
    """

    def __init__(self) -> None:
        """Makes it; takes those away whose process was killed."""
        remove_abandoned()
        self.path = Path(tempfile.mkdtemp(prefix=_PREFIX, dir=_memory()))
        self._lock: int | None = None
        if fcntl is not None:
            # Locked before it has its name, so that nobody takes a new folder for an abandoned one.
            part = self.path / f"{_OWNER}.part"
            self._lock = os.open(part, os.O_RDWR | os.O_CREAT, 0o600)
            fcntl.flock(self._lock, fcntl.LOCK_EX)
            part.rename(self.path / _OWNER)

    def close(self) -> None:
        """Removes it with all that is in it. May be called again."""
        shutil.rmtree(self.path, ignore_errors=True)
        if self._lock is not None:
            os.close(self._lock)
            self._lock = None

    def __enter__(self) -> "MemoryFolder":
        return self

    def __exit__(self, *error: object) -> None:
        self.close()


def remove_abandoned() -> int:
    """Removes this user's folders in memory whose process is gone without having done so.

    Returns:
        How many folders of this user stay, because a process has them still, if only until it has died altogether.
    """
    where, kept = _memory(), 0
    if fcntl is None or where is None:
        return 0
    for owner in where.glob(f"{_PREFIX}*/{_OWNER}"):
        with contextlib.suppress(OSError):  # it is somebody's, or was removed just now
            if os.lstat(owner.parent).st_uid != os.geteuid():
                continue
            lock = os.open(owner, os.O_RDWR | os.O_NOFOLLOW)
            try:
                fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
                shutil.rmtree(owner.parent, ignore_errors=True)
            except BlockingIOError:
                kept += 1
            finally:
                os.close(lock)
    return kept


def _memory() -> Path | None:
    return _MEMORY if _MEMORY.is_dir() and os.access(_MEMORY, os.W_OK) else None
