"""The audit: do the recordings of all users say together that nobody got energy out of the network, and if not, where?

Nothing is taken from the peers' own ledgers that recorded motion and forces say (`_motion.py`). Then, for the whole:

* every step's energy is explained, at every user;
* N-port passivity [Lee & Huang 2010, eq. 4]: at every instant users have put in `Σ ∫ f v ≥ -c²`, c² what was stored at
  the beginning;
* what the links made through the age of samples (`_links.py`) was taken by the damping of the synchronisation.
"""

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from cotouch.arrays import Float
from cotouch.errors import RecordingError
from cotouch.recording._audited import Audit, UserLedger
from cotouch.recording._columns import GUARDS
from cotouch.recording._findings import AuditFinding, absent_users, closing_words, exchanged, findings_of, missing_words
from cotouch.recording._guards import started
from cotouch.recording._law import law_ledger
from cotouch.recording._links import (
    LinkLedger,
    ages,
    align,
    grid_of,
    link_ledger,
    linked,
    so_far,
    too_young,
    unrecorded,
)
from cotouch.recording._motion import LOSSES, Motion, motions
from cotouch.recording._recording import Recording
from cotouch.units import user_number

# Share of the energy in play that rounding may make of it.
TOLERANCE = 1e-9


def audit(recordings: Sequence[Recording], *, tolerance: float = TOLERANCE) -> Audit:
    """Recomputes the energy of a session from the recordings of its users.

    Args:
        recordings: of different users of the same session; one is enough for its own ledger.
        tolerance: share of the energy in play that rounding may make of it.

    Raises:
        RecordingError: they do not belong together.
    """
    recordings = sorted(recordings, key=lambda recording: (recording.user, float(recording.time[0])))
    _belong(recordings)
    names = {recording.user: recording.name for recording in recordings}
    notes = missing_words(recordings, names)
    complete = not notes
    left: list[AuditFinding] = []
    for at, recording in enumerate(recordings):
        if recording.finite < recording.steps:
            left.append(_left(recording))
            recordings[at] = recording.first_steps(recording.finite)
    offsets, corrected = align(recordings)
    if corrected:
        notes.append("the machines' Unix times contradict each other, so clocks were aligned by the ages of samples")
    notes += too_young(recordings, offsets) + closing_words(recordings)
    moved = motions(recordings, offsets)
    grid = grid_of(moved)
    start = float(grid[0])
    asked = [_asked(recording, recordings) for recording in recordings]
    links = _links(moved, grid, asked)
    supply = sum((so_far(m, m.known["supplied"] + m.known["drive_work"], grid) for m in moved), np.zeros(grid.size))
    made = sum((ledger.made for ledger in links), np.zeros(grid.size))
    taken = sum((so_far(m, m.known["local_loss"], grid) for m in moved), np.zeros(grid.size))
    initial = sum(float(m.start[0]) + started(m.recording) for m in moved) + sum(ledger.initial for ledger in links)
    lost = sum(float(m.known[name].sum()) for m in moved for name in LOSSES)
    stored = sum(max(float(np.abs(m.stored).max()), m.fallen) for m in moved)
    in_play = max(float(np.abs(supply).max()), lost, stored, initial)
    rounding = sum(m.rounding * np.sqrt(m.end.size) for m in moved)
    allowed = tolerance * in_play + 10.0 * float(rounding)
    found = left + [finding for m in moved for finding in findings_of(m, allowed, start, names)]
    found += exchanged(moved, allowed, start, names)
    # What a change of members brings or takes is nobody's work, but was there to be taken out afterwards.
    members = sum((so_far(m, np.where(m.members, m.carried, 0.0), grid) for m in moved), np.zeros(grid.size))
    # A body that fell below where it began has given what no hand put in: its weight did.
    margin = supply + initial + members + sum(m.depth for m in moved)
    # What hands did in steps that are not recorded is not known, nor what was put in from then on.
    unknown = np.any([unrecorded(m, grid) for m in moved], axis=0)
    until = int(np.argmax(unknown)) if unknown.any() else grid.size
    if until < grid.size and not absent_users(recordings):
        notes.append(
            f"steps are missing from {float(grid[until - 1]) - start:.2f} s on; whether users took out more than was "
            "put in is known up to there"
        )
    least = int(np.argmin(margin[:until]))
    if margin[least] < -allowed and not absent_users(recordings):
        words = f"users took {-margin[least]:.4g} J more out of the network than they had put in"
        energy, time = float(-margin[least]), float(grid[least]) - start
        found.append(
            AuditFinding(user=None, link=None, place="network", energy=energy, time=time, step=None, words=words)
        )
    # Guarded ends may spend what they were given once, and what the body's own damping took.
    spare = allowed + sum(
        started(m.recording) + float(m.known["body_loss"].sum() + m.known["extra_loss"].sum())
        for m in moved
        if _guarded(m)
    )
    found += _links_beyond(links, made - taken, grid, allowed, spare, names)
    for ledger, need in zip(moved, asked, strict=True):
        have = _least_damping(ledger.recording)
        if sum(need.values()) > have * (1.0 + 1e-9) and not _guarded(ledger):  # a guard judges every sample by itself
            notes.append(
                f"the damping of {ledger.recording.name} was {have:.4g} Ns/m; the age rule requires "
                f"{sum(need.values()):.4g} Ns/m for the ages that occurred"
            )
    return Audit(
        users=tuple(_user(m, sum(need.values())) for m, need in zip(moved, asked, strict=True)),
        links=tuple(links),
        law=law_ledger(moved),
        findings=tuple(sorted(found, key=lambda finding: -abs(finding.energy))),
        complete=complete,
        notes=tuple(notes),
        tolerance=allowed,
        in_play=in_play,
        initial=initial,
        margin=float(margin[least]),
        margin_time=float(grid[least]) - start,
        time=grid - start,
        supplied=supply,
        made=made,
        taken=taken,
    )


def _belong(recordings: Sequence[Recording]) -> None:
    if not recordings:
        raise RecordingError("no recording was given; an audit needs at least one")
    first = recordings[0]
    for other in recordings[1:]:
        if other.header.session != first.header.session:
            raise RecordingError(
                f"{other.path} is from session {other.header.session!r}, {first.path} from {first.header.session!r}; "
                "give recordings of one session"
            )
        same = other.header.body, first.header.body
        own, others = (body.material for body in same)
        alike = own is None if others is None else others.same(own)
        if not alike or any(
            not np.array_equal(*(getattr(body, part).data for body in same)) for part in ("mass", "stiffness")
        ):
            raise RecordingError(
                f"{other.path} is of a different body from {first.path}; give recordings of one session"
            )
    for one, two in pairwise(recordings):
        again = one.header.key and two.header.key and one.header.key != two.header.key
        if one.user == two.user and not again:
            raise RecordingError(
                f"{one.path} and {two.path} are both of user {user_number(one.user)}; give only one of them"
            )


def _left(recording: Recording) -> AuditFinding:
    """Of a copy that left floating point, after which nothing can be worked out.

    Raises:
        RecordingError: it did so at once.
    """
    row, columns = recording.finite, recording.columns
    if row == 0:
        raise RecordingError(f"the first step of {recording.path} has non-finite numbers")
    return AuditFinding(
        user=recording.user,
        link=None,
        place="state",
        energy=float("inf"),
        time=float(columns["time"][row] - columns["time"][0] + columns["period"][0]),
        step=int(columns["index"][row]),
        words=f"{recording.name}'s numbers are no longer finite; nothing can be judged from there on",
    )


def _guarded(motion: Motion) -> bool:
    return set(GUARDS) <= set(motion.recording.columns)


def _asked(recording: Recording, recordings: Sequence[Recording]) -> dict[int, float]:
    """Damping that the age rule asks of a user, by link, for the ages that there were [Ns/m]."""
    result: dict[int, float] = {}
    for user in recording.neighbours:
        here = ages(recording, user)
        back = [ages(o, recording.user) for o in recordings if o.user == user and recording.user in o.neighbours]
        there = max((age for age in back if age is not None), key=lambda age: age.most, default=None)
        if here is None:
            result[user] = 0.0
            continue
        strength = max(
            (s.strength[s.neighbours.index(user)] for s in recording.setups if user in s.neighbours), default=0.0
        )
        # Of a neighbour that is not recorded, the way back is taken to be as long.
        result[user] = 0.5 * strength * (here.most + (here.most if there is None else there.most))
    return result


def _links(moved: Sequence[Motion], grid: Float, asked: Sequence[dict[int, float]]) -> list[LinkLedger]:
    result: list[LinkLedger] = []
    for i, one in enumerate(moved):
        for j in range(i + 1, len(moved)):
            two = moved[j]
            users = one.recording.user, two.recording.user
            if linked(one.recording, two.recording):
                fractions = _share(one, users[1], asked[i]), _share(two, users[0], asked[j])
                result.append(link_ledger(one, two, grid, fractions))
    return result


def _share(motion: Motion, user: int, asked: dict[int, float]) -> Float:
    """Share of the user's damping that is this link's, per step."""
    fraction = np.zeros(motion.end.size)
    for setup, span in motion.recording.setup_rows():
        if user not in setup.neighbours:
            continue
        if setup.link_damping is not None:
            parts = dict(zip(setup.neighbours, setup.link_damping, strict=True))
        else:
            parts = {other: asked[other] for other in setup.neighbours}
        total = sum(parts.values())
        fraction[span] = parts[user] / total if total > 0.0 else 0.0
    return fraction


def _links_beyond(
    links: Sequence[LinkLedger], beyond: Float, grid: Float, allowed: float, spare: float, names: dict[int, str]
) -> list[AuditFinding]:
    """Links that made more than the damping took, if all together did.

    One alone may: its share of the damping is a convention, and what another link leaves over is there for it.
    """
    judged = [ledger for ledger in links if ledger.strict and ledger.strength > 0.0]
    if not judged or len(judged) < len(links):
        return []
    together = float(beyond.max()) if all(ledger.whole for ledger in links) else np.inf
    over = [ledger for ledger in judged if ledger.excess > allowed + ledger.granted]
    if together <= spare or not over:
        return []
    result: list[AuditFinding] = []
    for ledger in over:
        one, two = (names[user] for user in ledger.ends)
        words = f"the link of {one} and {two} added {ledger.excess:.4g} J more than its damping took"
        result.append(
            AuditFinding(
                user=None,
                link=ledger.ends,
                place="link",
                energy=ledger.excess,
                time=ledger.moment - float(grid[0]),
                step=None,
                words=words,
            )
        )
    return result


def _least_damping(recording: Recording) -> float:
    return min(setup.local_damping[0] if setup.local_damping else 0.0 for setup in recording.setups)


def _user(motion: Motion, asked: float) -> UserLedger:
    recording, known = motion.recording, motion.known
    return UserLedger(
        user=recording.user,
        name=recording.name,
        steps=recording.steps,
        worked_out=int(motion.kept.sum()),
        supplied=float(known["supplied"].sum() + known["drive_work"].sum()),
        body_loss=float(known["body_loss"].sum()),
        local_loss=float(known["local_loss"].sum()),
        extra_loss=float(known["extra_loss"].sum()),
        touch_loss=float(recording.columns["touch_loss"].sum()),
        cut=float(motion.known["cut"].sum()),
        link_work=float(motion.link.sum()),
        members=float(motion.carried[motion.members].sum()),
        stored=float(motion.stored[-1] - motion.start[0]),
        residual=float(motion.residual.sum()),
        closure=float(recording.columns["closure"].sum()),
        closure_factor=float(recording.columns["closure_factor"].max()),
        damping=_least_damping(recording),
        asked=asked,
    )
