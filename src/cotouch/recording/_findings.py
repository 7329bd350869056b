"""Where a joule came from that nothing explains: one finding for each place, largest first."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import final

import numpy as np

from cotouch.arrays import Float
from cotouch.recording._guards import unbalanced, unfounded
from cotouch.recording._motion import LOSSES, Motion
from cotouch.recording._recording import Recording
from cotouch.recording._said import unpaid_errors
from cotouch.units import user_number

# `cotouch.mechanics.CLOSURE_ALARM`, which reading a recording must not load kernels for.
_CLOSURE_ALARM = 1e-2
_NAMES = {
    "supplied": ("hands", "the work of the forces at the ports"),
    "drive_work": ("hands", "the work of the forces on the proxies"),
    "body_loss": ("damping", "what the body's own dampers took"),
    "local_loss": ("damping", "what the damping B_i of the synchronisation took"),
    "extra_loss": ("damping", "what the extra damping B_e took"),
    "cut": ("cuts", "what was lost with the elements that were cut"),
    "stored": ("state", "the energy of position and velocity"),
    "closure": ("state", "the work on the velocity that closed steps"),
    "held": ("proxies", "the energy of proxies and contacts"),
    "proxies": ("proxies", "the motion of the proxies under the forces on them"),
    "contacts": ("contacts", "the energy that contacts and grasps store and lose"),
}


@final
@dataclass(frozen=True, kw_only=True)
class AuditFinding:
    """Energy that is not accounted for.

    Attributes:
        user: index of the user in whose copy, or None.
        link: the two users between whom, or None.
        place: hands, damping, state, step, between steps, proxies, contacts, guard, link or network.
        energy: how much; > 0 came from nowhere [J].
        time: when it is seen first, since the beginning [s].
        step: index of that step of the user; None where there is none.
        words: what is known, one sentence.
    """

    user: int | None
    link: tuple[int, int] | None
    place: str
    energy: float
    time: float
    step: int | None
    words: str


def findings_of(motion: Motion, tolerance: float, start: float, names: dict[int, str]) -> list[AuditFinding]:
    """What does not fit in one user's recording.

    Args:
        motion: of the user.
        tolerance: that energies may differ by [J].
        start: of the session in shared time [s].
        names: of users by index.
    """
    recording = motion.recording
    found: list[AuditFinding] = []

    def add(place: str, energies: Float, words: str, link: tuple[int, int] | None = None) -> None:
        step = int(np.argmax(np.abs(energies) > max(tolerance / max(energies.size, 1), 1e-3 * np.abs(energies).max())))
        found.append(
            AuditFinding(
                user=recording.user,
                link=link,
                place=place,
                energy=_most(energies),
                time=float(motion.end[step] - start),
                step=int(recording.columns["index"][step]),
                words=words,
            )
        )

    # What is stored is a level, not a flow: an error that stays must not count in every step anew.
    levels = {name: np.diff(motion.difference[name], prepend=0.0) for name in ("stored", "held")}
    flows = {**motion.difference, **levels}
    for name, difference in flows.items():
        if not _counts(difference, tolerance):
            continue
        total = _most(difference)
        if name.startswith("link "):
            other = int(name.split()[1])
            words = (
                f"the link's work on {names[recording.user]}'s copy is {_beside(total)} according to the sample that "
                f"{names.get(other, f'user {user_number(other)}')} recorded than according to the ledger"
            )
            add("link", difference, words, (recording.user, other))
        elif name in {"proxies", "contacts"}:
            place, what = _NAMES[name]
            add(place, difference, f"{what} at {names[recording.user]} differs from the ledger by {_joule(total)}")
        else:
            place, what = _NAMES[name]
            add(place, difference, f"{what} at {names[recording.user]} is {_beside(total)} than the ledger says")
    residual = motion.residual
    booked = residual + _explained(motion)
    # What the ledger explains and the recorded numbers don't is in one of the places above.
    if _counts(residual, tolerance) and (not found or _counts(booked, tolerance)):
        add("step", residual, f"steps of {names[recording.user]} gained {_joule(_most(residual))} without explanation")
    for lacking in unbalanced(recording, motion.link, motion.known["local_loss"]):
        if _counts(lacking.energy, tolerance):
            other = lacking.user
            pair = None if other is None else (recording.user, other)
            to = "" if other is None else f" towards {names.get(other, f'user {user_number(other)}')}"
            words = f"at {names[recording.user]}{to} {lacking.words}, by {_joule(_most(lacking.energy))}"
            add("guard", lacking.energy, words, pair)
    for other in recording.neighbours:
        beyond = unpaid_errors(recording, other)
        if _counts(beyond, tolerance):
            neighbour = names.get(other, f"user {user_number(other)}")
            words = (
                f"the error in what {names[recording.user]} sent to {neighbour} exceeded what its damping had paid "
                f"for, by {_joule(_most(beyond))}"
            )
            add("codec", beyond, words, (recording.user, other))
    # Shares that rise as members leave are paid by what the copy lost.
    came = np.cumsum(np.where(motion.members, motion.carried - motion.sunk, 0.0))
    unpaid = came - np.cumsum(motion.known["body_loss"] + motion.known["extra_loss"])
    if unpaid.max(initial=0.0) > tolerance:
        rises = np.diff(np.maximum.accumulate(np.maximum(unpaid, 0.0)), prepend=0.0)
        words = f"{_joule(_most(rises))} entered {names[recording.user]}'s copy unpaid as members joined and left"
        add("between steps", rises, words)
    carried = np.where(motion.members, 0.0, motion.carried)
    if _counts(carried, tolerance):
        words = f"{_joule(_most(carried))} entered {names[recording.user]}'s copy between two of its steps"
        add("between steps", carried, words)
    return sorted(found, key=lambda finding: -abs(finding.energy))


def exchanged(moved: Sequence[Motion], tolerance: float, start: float, names: dict[int, str]) -> list[AuditFinding]:
    """Energy that an end of a link got of the other, which never gave it.

    Args:
        moved: motions of all users.
        tolerance: that energies may differ by [J].
        start: of the session in shared time [s].
        names: of users by index.
    """
    found: list[AuditFinding] = []
    for one in moved:
        for two in moved:
            if one.recording.user == two.recording.user:
                continue
            lacks = unfounded(one.recording, two.recording, one.end, two.end)
            if _counts(lacks, tolerance):
                step = int(np.argmax(lacks > 0.0))
                users = one.recording.user, two.recording.user
                taker, giver = (names[user] for user in users)
                found.append(
                    AuditFinding(
                        user=users[0],
                        link=users,
                        place="guard",
                        energy=_most(lacks),
                        time=float(one.end[step] - start),
                        step=int(one.recording.columns["index"][step]),
                        words=f"{taker} took {_joule(_most(lacks))} from {giver} that {giver} had not given",
                    )
                )
    return found


def missing_words(recordings: Sequence[Recording], names: dict[int, str]) -> list[str]:
    """What the recordings don't hold, one sentence each.

    Args:
        recordings: of all users.
        names: of the users, by number.
    """
    notes: list[str] = []
    for recording in recordings:
        own = names[recording.user]
        if recording.cut is not None:
            notes.append(f"the recording of {own} is {recording.cut}; it is judged up to that point")
        if recording.missing:
            notes.append(f"{recording.missing} steps of {own} are not recorded; what happened in them is not known")
        kept = recording.states["state_row"].size
        if kept < recording.steps:
            notes.append(
                f"the state of {own} was recorded at {kept} of {recording.steps} steps; at the others, the ledger is "
                f"trusted"
            )
    if absent := absent_users(recordings):
        who = ", ".join(f"user {user_number(user)}" for user in absent)
        notes.append(
            f"there is no recording of {who}; links to them are known from one end only, and whether users took out "
            "more than was put in is not known"
        )
    return notes


def absent_users(recordings: Sequence[Recording]) -> list[int]:
    """Whose neighbours are recorded, but not they themselves."""
    return sorted(
        {user for recording in recordings for user in recording.neighbours}
        - {recording.user for recording in recordings}
    )


def closing_words(recordings: Sequence[Recording]) -> list[str]:
    """Whose forces and energy disagree, though the ledger balances, one sentence each.

    Args:
        recordings: of all users.
    """
    notes: list[str] = []
    for recording in recordings:
        factor, shortened = recording.columns["closure_factor"], recording.columns["shortened"]
        count = int(((factor > _CLOSURE_ALARM) | (shortened > 0.0)).sum())
        if count:
            notes.append(
                f"in {count} of {recording.steps} steps of {recording.name}, forces and energy disagree: closing them "
                f"changed the velocity by up to {100.0 * float(factor.max()):.3g} %, or shortened them; use shorter "
                "steps, or more damping"
            )
    return notes


def _explained(motion: Motion) -> Float:
    """What the residual would lose if the recorded numbers were what the ledger says, per step."""
    difference = motion.difference
    links = sum((values for name, values in difference.items() if name.startswith("link ")), np.zeros(motion.end.size))
    losses = sum((difference[name] for name in LOSSES), np.zeros(motion.end.size))
    explained = difference["supplied"] - losses + links - np.where(motion.kept, difference["stored"], 0.0)
    return explained + np.where(motion.recording.consecutive, difference["drive_work"], 0.0)


def _counts(energies: Float, tolerance: float) -> bool:
    # What is no number is not below the tolerance.
    return not (
        np.abs(energies).max(initial=0.0) <= tolerance and np.abs(np.cumsum(energies)).max(initial=0.0) <= tolerance
    )


def _most(energies: Float) -> float:
    """The sum so far where it is furthest from nothing."""
    total = np.cumsum(energies)
    return float(total[int(np.argmax(np.abs(total)))])


def _beside(energy: float) -> str:
    return f"{abs(energy):.4g} J {'more' if energy > 0 else 'less'}"


def _joule(energy: float) -> str:
    return f"{energy:.4g} J"
