"""Recording while everybody moves: each member of this machine keeps a file, and each order comes to a told end."""

import shutil
import tempfile
from collections.abc import Callable, Sequence
from contextlib import suppress
from pathlib import Path
from typing import final

from cotouch.errors import SessionError
from cotouch.observers._command_client import CommandClient, RecordingOutcome
from cotouch.observers._mailboxes import MailboxFolder
from cotouch.observers._session_api import RecordingState

# Whoever did not finish its file by then is not waited for [s].
_PATIENCE = 10.0


@final
class RecordingClient:
    """Orders recordings and reports their outcomes; all but `hand_out` belong to one thread.

    Attributes:
        troubles: what went wrong with any of them, in sentences.
    """

    def __init__(
        self, mailboxes: MailboxFolder, commands: CommandClient, names: Sequence[str], say: Callable[[float, str], None]
    ) -> None:
        """Nothing is recorded yet.

        Args:
            mailboxes: where the files are.
            commands: by which members are told.
            names: of the members whose processes run here.
            say: is told when something happened [s], and what.
        """
        self.troubles: list[str] = []
        self._mailboxes, self._commands, self._names, self._say = mailboxes, commands, list(names), say
        self._number = 0
        self._began: float | None = None
        self._ended: float | None = None
        self._asked = set[str]()  # who moves, and so records
        self._announced: dict[str, RecordingOutcome | None] = {}  # what each said; None: its process ended first
        self._now = RecordingState()
        self._ready: tuple[Path, ...] = ()
        self._handed_out = True

    def look(self, now: float) -> RecordingState:
        """How it is.

        Args:
            now: [s].
        """
        if self._now.state != "on" or self._began is None:
            return self._now
        return self._now._replace(seconds=max(0.0, now - self._began))

    def switch(self, on: bool, now: float) -> str:
        """Begins or ends a recording.

        Args:
            on: which.
            now: [s].

        Raises:
            SessionError: it is so already, the one before is still being finished, or there is nothing to record.
        """
        if on:
            if self._now.state in {"on", "ending"}:
                raise SessionError(
                    "a recording is already under way"
                    if self._now.state == "on"
                    else "the previous recording is still being finished; try again in a moment"
                )
            asked = {name for name in self._names if self._commands.number(name, "step") > 0}
            if not asked:
                raise SessionError("no copy is moving yet, so there is nothing to record")
            self._number += 1
            self._asked, self._announced = asked, {}
            self._began, self._ended = now, None
            self._now = RecordingState(state="on", number=self._number)
            self._commands.record(self._number, on=True)
            return "recording"
        if self._now.state != "on":
            raise SessionError("nothing is being recorded")
        self._end(now)
        return "the recording is ending; the result follows in a moment"

    def turn(self, now: float, running: Sequence[str], *, ended: bool = False) -> None:
        """Hears what came of it.

        Args:
            now: [s].
            running: names of those whose processes run.
            ended: whether the session is over.
        """
        if self._now.state not in {"on", "ending"}:
            return
        for name in self._names:
            self._receive(name, now, running=name in running)
        if self._now.state == "on" and (ended or self._asked <= self._announced.keys()):
            self._end(now)
        if self._ended is None:
            return
        late = now - self._ended > _PATIENCE
        for name in sorted(self._asked - self._announced.keys()) if late else ():
            self._announced[name] = None
            self._trouble(now, f"{name}'s was not finished within {_PATIENCE:.0f} s and is cut off")
        if self._asked <= self._announced.keys():
            self._finish(now)

    def hand_out(self) -> tuple[Path, ...]:
        """Files of the last recording that came to its end; any thread may ask."""
        self._handed_out = True
        return self._ready

    def close(self, now: float) -> str | None:
        """Brings what is under way to an end, and keeps what nobody fetched; returns in a sentence where it is.

        Args:
            now: [s].
        """
        self.turn(now, (), ended=True)
        if self._handed_out or not self._ready:
            return None
        try:
            folder = Path(tempfile.mkdtemp(prefix="cotouch-recording-"))
            for path in self._ready:
                shutil.move(path, folder / path.name)
        except OSError as error:
            return f"the last recording was not downloaded and could not be saved: {error.strerror or error}"
        return f"the last recording was not downloaded from the page; it is in {folder}"

    def _receive(self, name: str, now: float, *, running: bool) -> None:
        """Takes note of who takes part, and of what became of it."""
        if name in self._announced and self._announced[name] is not None:
            return
        if self._commands.number(name, "recording") == self._number:
            self._asked.add(name)  # who came meanwhile, or came back
            self._announced.pop(name, None)
        outcome = self._commands.outcome(name)
        if outcome is not None and outcome.number == self._number:
            self._asked.add(name)
            self._announced[name] = outcome
            if outcome.trouble:
                self._trouble(now, f"{name}'s {outcome.trouble}")
        elif name in self._asked and name not in self._announced and not running:
            self._announced[name] = None
            self._trouble(now, f"{name}'s is cut off because the process ended")

    def _trouble(self, now: float, text: str) -> None:
        self.troubles.append(f"recording {self._number} from the page: {text}")
        self._now = self._now._replace(troubles=(*self._now.troubles, text))
        self._say(now, f"ALARM: recording {self._number}: {text}")

    def _end(self, now: float) -> None:
        self._commands.record(self._number, on=False)
        seconds = 0.0 if self._began is None else max(0.0, now - self._began)
        self._began, self._ended = None, now
        self._now = self._now._replace(state="ending", seconds=seconds)

    def _finish(self, now: float) -> None:
        """Looks what there is; files of the recording before are removed once there is another."""
        found: list[tuple[Path, int]] = []
        with suppress(OSError):
            found = [(path, path.stat().st_size) for path in self._mailboxes.recordings(self._number)]
        files = [(path, size) for path, size in found if size]
        if files:
            for path in self._ready:
                with suppress(OSError):
                    path.unlink()
            self._ready, self._handed_out = tuple(path for path, _ in files), False
            size = sum(size for _, size in files)
            text = f"{_count(len(files))} of {self._now.seconds:.1f} s, {size / 1e6:.2f} MB"
        else:
            text = "nothing was recorded"
            if not self._now.troubles:
                self._trouble(now, "no user left a file")
        self._ended = None
        named = tuple((path.name, size) for path, size in files)
        self._now = self._now._replace(state="done" if files else "failed", text=text, files=named)
        self._say(now, f"recording {self._number}: {text}")


def _count(files: int) -> str:
    return "one file" if files == 1 else f"{files} files"
