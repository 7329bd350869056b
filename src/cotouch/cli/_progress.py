"""What is going on while nothing else can be shown: a line that says what, and for how long already."""

import sys
import threading
import time
from types import TracebackType
from typing import Self, final

# A line in place is drawn so often, and one for a log is written so often [s]. The first waits as long: whoever gave a
# wrong option soon reads one sentence, which says that.
_DRAW, _LOG = 0.25, 1.0


@final
class ProgressLine:
    """Says on standard error what takes time, from a thread of its own; compilation leaves the main one no turn."""

    def __init__(self, *, quiet: bool) -> None:
        """Says nothing yet.

        Args:
            quiet: whether to say nothing at all.
        """
        self._text, self._since = "", 0.0
        self._lock, self._over = threading.Lock(), threading.Event()
        self._terminal = sys.stderr.isatty()
        self._thread = None if quiet else threading.Thread(target=self._run, name="cotouch progress", daemon=True)

    def say(self, text: str) -> None:
        """Says what begins now.

        Args:
            text: in a few words.
        """
        with self._lock:
            if text != self._text:
                self._text, self._since = text, time.monotonic()
            if self._thread is not None and not self._thread.is_alive() and not self._over.is_set():
                self._thread.start()

    def tell(self, text: str) -> None:
        """Says what stays to be read, above the line that goes on.

        Args:
            text: a sentence.
        """
        with self._lock:
            here = self._terminal and self._thread is not None and self._thread.is_alive()
            sys.stderr.write(f"\r\x1b[Kcotouch: {text}\n" if here else f"cotouch: {text}\n")
            sys.stderr.flush()

    def end(self) -> None:
        """Takes the line away; the rest has its own display."""
        if self._over.is_set():
            return
        self._over.set()
        if self._thread is not None and self._thread.is_alive():
            self._thread.join()
            if self._terminal:
                sys.stderr.write("\r\x1b[K")
                sys.stderr.flush()

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.end()

    def _run(self) -> None:
        while not self._over.wait(_DRAW if self._terminal else _LOG):
            with self._lock:
                text, seconds = self._text, time.monotonic() - self._since
                # Not imported here: that takes seconds, of which somebody is to be told as well.
                kernels = sys.modules.get("cotouch.compiled")
                made = kernels.compiled_so_far() if kernels is not None and "compiling" in text else 0
                line = f"cotouch: {text} ({seconds:.0f} s{f', {made} functions' if made else ''})"
                sys.stderr.write(f"\r{line}\x1b[K" if self._terminal else f"{line}\n")
                sys.stderr.flush()
