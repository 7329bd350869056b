"""What somebody who takes part wants, and what came of it."""

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Final, Literal, final

from pydantic import TypeAdapter, ValidationError

from cotouch.errors import SessionError
from cotouch.members._messages import Name, Status

_NAME: Final[TypeAdapter[str]] = TypeAdapter(Name)

HandKind = Literal["scripted", "none"]


@final
@dataclass(frozen=True, kw_only=True)
class Participation:
    """How somebody wants to take part.

    Attributes:
        name: that others see.
        version: of this software.
        hand: what moves the copy: what the session's file says for its slot, or nothing.
        device: that moves the copy instead, in the words of `cotouch.haptics.DeviceChoice.read`; None: none.
        seconds: how long, from the first step; None: until the end.
        listen: address in numbers to listen on; None: the one by which this machine reaches the host.
        record: file to record into; must not exist.
        mailboxes: folder of the mailboxes by which this member is shown and told things on this machine; see
            `_mailboxes`.
        identities: folder where this member's key is kept, so that it has its name again after a crash; None: nowhere.
        unsafe: whether it may be told to take less damping than passivity needs.
        real_time: whether to ask for real-time priority.

    Raises:
        SessionError: the name is none that others could see.
    """

    name: str
    version: str
    hand: HandKind = "scripted"
    device: str | None = None
    seconds: float | None = None
    listen: str | None = None
    record: Path | None = None
    mailboxes: Path | None = None
    identities: Path | None = None
    unsafe: bool = False
    real_time: bool = True

    def __post_init__(self) -> None:
        try:
            object.__setattr__(self, "name", _NAME.validate_python(self.name.strip()))
        except ValidationError:
            raise SessionError(
                f"the name is {self.name[:40]!r}; it must be 1 to 32 letters in one line, such as --name Ann"
            ) from None


@final
@dataclass(frozen=True, kw_only=True)
class ParticipationOutcome:
    """How taking part went.

    Attributes:
        name: of this member.
        slot: index of the user; None if it never had one.
        status: the last; None before the first step.
        why: it ended: "time", "ended" (by the host) or "stopped".
        pace: of its steps, as the pacer counted.
        recorded: steps in the recording; None without.
        trouble: what is wrong with the recording, in words that follow its name; None: nothing.
        device: its name, what was said of it, and how its servo kept pace; None without.
    """

    name: str
    slot: int | None
    status: Status | None
    why: str
    pace: Mapping[str, float]
    recorded: int | None
    trouble: str | None = None
    device: Mapping[str, object] | None = None
