"""Whether what is seen is passive, and how much is to spare, in plain words."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Literal, final

from cotouch.session import LinkStatus, Overview, Status

# As in the books of a session: a residual above this share is no round-off; and joules that are.
_ALARM = 1e-9
_ROUND_OFF = 1e-9
_NARROW = 0.05  # share to spare below which it is worth a warning


@final
@dataclass(frozen=True)
class Verdict:
    """A judgement.

    Attributes:
        level: good: passive, with something to spare; warn: passive, but look; bad: not passive, or not known to be.
        text: why, in a sentence.
    """

    level: Literal["good", "warn", "bad"]
    text: str

    def as_json(self) -> dict[str, Any]:
        """As JSON's values."""
        return {"level": self.level, "text": self.text}


def judged(overview: Overview) -> Verdict:
    """Judges by what members said last: their books, their damping, and the ages that it covers.

    Args:
        overview: of a stage.
    """
    names = {entry.seat: entry.name for entry in overview.roster.members}
    known = [status for seat, status in sorted(overview.statuses.items()) if seat in names and status.steps]
    if overview.ended:
        return Verdict("warn", "the session is over")
    if not known:
        return Verdict("warn", "nobody moves yet")
    return _broken(known, names) or _short(known, names, overview.damping) or _links(known)


def _broken(known: Sequence[Status], names: dict[int, str]) -> Verdict | None:
    """Books that do not balance, or energy from nowhere."""
    for status in known:
        if status.alarms or status.residual > _ALARM:
            off = f"{status.residual:.0e} of the energy in play"
            return Verdict("bad", f"the energy books of {names[status.seat]} are off by {off}: do not trust this copy")
    margin = sum(status.supplied + status.initial for status in known)
    if margin < -_ROUND_OFF:
        return Verdict("bad", f"not passive: {-margin:.3g} J came out that nobody put in")
    return None


def _short(known: Sequence[Status], names: dict[int, str], share: float) -> Verdict | None:
    """Damping that does not cover what links may come to."""
    if share < 1.0:
        lowered = _percent(share) if share >= 0.01 else f"{100.0 * share:.2g} %"
        return Verdict("bad", f"not passive: the damping is lowered to {lowered} of what the delays need")
    lacking = [(status.certificate, status.seat) for status in known if status.certificate is not None]
    least, seat = min(lacking, default=(0.0, -1))
    if least < -_ALARM:
        return Verdict("bad", f"not passive: {names[seat]} has {_percent(-least)} less damping than the delays need")
    return None


def _links(known: Sequence[Status]) -> Verdict:
    """The narrowest link."""
    ends = [(status.seat, link) for status in known for link in status.links]
    held = [_name(seat, link) for seat, link in ends if link.state == "guarded"]
    if held:
        return Verdict(
            "warn", f"passive: link {held[0]} is held back until its damping covers how late its samples are"
        )
    spare = [
        (1.0 - link.ages / link.budget, _name(seat, link))
        for seat, link in ends
        if link.state == "coupled" and link.ages is not None and link.budget
    ]
    joining = [_name(seat, link) for seat, link in ends if link.state not in {"coupled", "guarded"}]
    if not spare:
        if joining:
            return Verdict("warn", f"passive: link {joining[0]} is being joined")
        return Verdict("good", "passive: there are no links yet that could add energy")
    least, name = min(spare)
    if least < 0.0:
        return Verdict("warn", f"passive: link {name} is later than its damping covers and will be held back")
    text = f"passive: {_percent(least)} to spare on link {name}"
    if joining:
        return Verdict("warn", f"{text}; link {joining[0]} is being joined")
    return Verdict("good" if least >= _NARROW else "warn", text)


def _name(seat: int, link: LinkStatus) -> str:
    a, b = sorted((seat, link.seat))
    return f"{a + 1}–{b + 1}"


def _percent(share: float) -> str:
    """For people; never 0 % or 100 % by rounding."""
    return f"{min(max(round(100.0 * share), 1 if share > 0.0 else 0), 99 if share < 1.0 else 100)} %"
