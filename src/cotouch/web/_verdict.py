"""Whether what is seen is passive, and how much is to spare, in plain words."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal, final

from cotouch.members import LinkStatus, Status, margin_of
from cotouch.observers import Overview

# As in the ledger of a session: a residual above this share is no round-off; and joules that are.
_ALARM = 1e-9
_ROUND_OFF = 1e-9
_OFTEN = 0.01  # share of steps whose forces and energy disagree from which it is worth one
_NARROW = 0.05  # share to spare below which it is worth a warning


@final
@dataclass(frozen=True)
class Verdict:
    """A judgement.

    Attributes:
        level: good: passive, with something to spare; warn: passive, but look; bad: not passive, or not known to be.
        text: why, in a few words; "safe" is passive.
    """

    level: Literal["good", "warn", "bad"]
    text: str


def judged(overview: Overview) -> Verdict:
    """Judges a session by members' last reports: their ledger, their damping, and the ages that it covers.

    Args:
        overview: of a stage.
    """
    names = {entry.slot: entry.name for entry in overview.roster.members}
    known = [status for slot, status in sorted(overview.statuses.items()) if slot in names and status.steps]
    if overview.ended:
        return Verdict("warn", "the session is over")
    if not known:
        return Verdict("warn", "no copy is moving yet")
    return (
        _broken(known, names, overview.left)
        or _short(known, names, overview.damping)
        or _away(known, names)
        or _apart(known, names)
        or _links(known)
    )


def _broken(known: Sequence[Status], names: dict[int, str], left: bool) -> Verdict | None:
    """A ledger that does not balance, or energy from nowhere, as far as nobody took a part of the ledger along."""
    for status in known:
        if status.alarms or status.residual > _ALARM:
            off = f"{status.residual:.0e} of the energy in play"
            return Verdict("bad", f"the energy ledger of {names[status.slot]} is off by {off}: do not trust this copy")
    margin = margin_of(known)
    if margin < -_ROUND_OFF and not left:
        return Verdict("bad", f"not safe: {-margin:.3g} J came out that nobody had put in")
    return None


def _short(known: Sequence[Status], names: dict[int, str], fraction: float) -> Verdict | None:
    """Damping that does not cover what links may come to."""
    if fraction < 1.0:
        lowered = _percent(fraction) if fraction >= 0.01 else f"{100.0 * fraction:.2g} %"
        return Verdict("bad", f"not safe: damping lowered to {lowered}")
    lacking = [(status.damping_margin, status.slot) for status in known if status.damping_margin is not None]
    least, slot = min(lacking, default=(0.0, -1))
    if least < -_ALARM:
        return Verdict("bad", f"not safe: {names[slot]} has {_percent(-least)} less damping than the delays need")
    return None


def _away(known: Sequence[Status], names: dict[int, str]) -> Verdict | None:
    """A copy whose neighbours hear nothing of it because of where it is, whatever the network does."""
    for status in known:
        if status.unsent:
            why = "farther away than samples can tell, so its neighbours hear nothing"
            return Verdict("warn", f"safe: {names[status.slot]}'s copy is {why}")
    return None


def _apart(known: Sequence[Status], names: dict[int, str]) -> Verdict | None:
    """Steps that were too long for a body that turns or bends: balanced, but not by their forces."""
    for status in known:
        if status.closure_alarms > _OFTEN * status.steps:
            off = f"by up to {100.0 * status.closure_factor:.2g} %; shorter steps help"
            return Verdict("warn", f"safe: forces and energy of {names[status.slot]}'s copy disagree {off}")
    return None


def _links(known: Sequence[Status]) -> Verdict:
    """The narrowest link."""
    ends = [(status.slot, link) for status in known for link in status.links]
    held = sorted({_name(slot, link) for slot, link in ends if link.state == "guarded"})
    if held:
        which = f"link {held[0]}" if len(held) == 1 else f"{len(held)} links"
        return Verdict("warn", f"safe: {which} paused, network slow")
    silent = sorted({_name(slot, link) for slot, link in ends if link.state == "waiting" and link.age is not None})
    if silent:
        which = f"link {silent[0]} receives" if len(silent) == 1 else f"{len(silent)} links receive"
        return Verdict("warn", f"safe: {which} nothing, network slow")
    spare = [
        (1.0 - link.age_sum / link.budget, _name(slot, link))
        for slot, link in ends
        if link.state == "coupled" and link.age_sum is not None and link.budget
    ]
    joining = [_name(slot, link) for slot, link in ends if link.state not in {"coupled", "guarded"}]
    if not spare:
        if joining:
            return Verdict("warn", f"safe: link {joining[0]} is connecting")
        laws = sorted({link.law for _, link in ends} - {"spring"})
        if laws:
            return Verdict("good", f"safe: law {laws[0]} needs no damping")
        return Verdict("good", "safe: no links yet")
    least, name = min(spare)
    if least < 0.0:
        return Verdict("warn", f"safe: link {name} is late and may pause")
    text = f"safe: {_percent(least)} to spare on link {name}"
    if joining:
        return Verdict("warn", f"{text}; link {joining[0]} is connecting")
    return Verdict("good" if least >= _NARROW else "warn", text)


def _name(slot: int, link: LinkStatus) -> str:
    a, b = sorted((slot, link.slot))
    return f"{a + 1}–{b + 1}"


def _percent(fraction: float) -> str:
    """For people; never 0 % or 100 % by rounding."""
    return f"{min(max(round(100.0 * fraction), 1 if fraction > 0.0 else 0), 99 if fraction < 1.0 else 100)} %"
