"""One link's energy, from the recordings of both ends: what it did to the copies, what its spring holds, what it lost.

Copies are followed as they move in real time: along a straight line in every step, standing between steps. Then work
is linear within a step, and the spring `½ ‖x_i - x_j‖²` in K is known at every instant. With `W` the work on the copies
and `ā` the ages that the damping was made for,

    W_ij + W_ji + ΔS  ≤  ½ (ā_ij + ā_ji) K (∫‖v_i‖² + ∫‖v_j‖²)

at every instant after a start at rest: what the age of samples adds is taken by the link's share of B_i and B_j.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple, final

import numpy as np

from cotouch.arrays import Bool, Float, Long
from cotouch.peer import LinkState
from cotouch.recording._guards import EARLY, READ, granted, linked_steps
from cotouch.recording._motion import Motion
from cotouch.recording._recording import Recording

ABSENT = -1
_STATES = {ABSENT: "absent"} | {int(state): state.name.lower() for state in LinkState}
_BLOCK = 4096


class Ages(NamedTuple):
    """Ages of the samples on a link, one way, while it was coupled [s].

    Attributes:
        least: of all.
        quick: of the quickest way, whatever a hundredth of the samples, or one of a few, say: clocks go by it.
        most: of all.
    """

    least: float
    quick: float
    most: float


@final
@dataclass(frozen=True, kw_only=True, eq=False)
class LinkLedger:
    """What one link did.

    Attributes:
        ends: the two users.
        strength: of the spring, the largest there was [N/m].
        work: on the first user's copy and on the second's [J].
        spring: energy in the spring at the end less that at the beginning [J].
        age: most age of samples at either end [s].
        by_state: `W + ΔS` for each state that there was, of both ends the less trusting one's [J].
        dissipated: by its share of the users' damping [J].
        made: `W + ΔS` so far, on the grid; the spring counts where both ends are coupled [J].
        taken: dissipated so far [J].
        excess: most that it made beyond what was taken, in any stretch without a gap [J].
        moment: when that was [s].
        strict: whether all positions are known; else springs are interpolated, and the link is not judged.
        whole: whether there is no gap.
        initial: energy in the spring at the beginning [J].
        unknown: share of its steps whose work is as booked.
        granted: what the tanks of guarded ends had besides its damping: what they began with and were given [J].
    """

    ends: tuple[int, int]
    strength: float
    work: tuple[float, float]
    spring: float
    age: tuple[float, float]
    by_state: Mapping[str, float]
    dissipated: float
    made: Float
    taken: Float
    excess: float
    moment: float
    strict: bool
    whole: bool
    initial: float
    unknown: float
    granted: float = 0.0


def ages(recording: Recording, neighbour: int) -> Ages | None:
    """Of the samples of a neighbour, by the clocks as they are; None where none was used.

    Args:
        recording: of one user.
        neighbour: number of the sender, from 0.
    """
    column = recording.neighbours.index(neighbour)
    age = recording.columns["age"][:, column]
    counted = age[np.isfinite(age) & (recording.columns["link_state"][:, column] == LinkState.COUPLED)]
    if not counted.size:
        return None
    rank = min(counted.size - 1, max(1, counted.size // 100))
    return Ages(float(counted.min()), float(np.partition(counted, rank)[rank]), float(counted.max()))


def linked(one: Recording, two: Recording) -> bool:
    """Whether both had a link to the other; who came again under another key is another.

    Args:
        one: recording of one user.
        two: recording of another.
    """
    return (
        one.user != two.user
        and two.user in one.neighbours
        and one.user in two.neighbours
        and bool(linked_steps(one, two.user, two.header.key).any())
        and bool(linked_steps(two, one.user, one.header.key).any())
    )


def align(recordings: Sequence[Recording]) -> tuple[list[float], bool]:
    """Shared time less each user's own [s], and whether Unix time had to be corrected.

    Clocks of different machines may be so far apart that a sample would have been used before it was there. Then the
    ages say better: half the difference between the quickest of either direction, as NTP has it. A few samples that
    cannot be say nothing about clocks.
    """
    base = recordings[0].header.offset
    offsets = [recording.header.offset - base for recording in recordings]
    apart: dict[tuple[int, int], float] = {}
    wrong = False
    for i, one in enumerate(recordings):
        for j, two in enumerate(recordings):
            if j < i or not linked(one, two):
                continue
            there, back = ages(one, two.user), ages(two, one.user)
            if there is None or back is None:
                continue
            ahead = offsets[i] - offsets[j]
            wrong |= min(there.quick + ahead, back.quick - ahead) < -READ
            apart[i, j] = 0.5 * (back.quick - there.quick)
    if not wrong:
        return offsets, False
    known = {0}
    for _ in recordings:  # a tree over the links, from the first user
        for (i, j), ahead in apart.items():
            if i in known and j not in known:
                offsets[j] = offsets[i] - ahead
                known.add(j)
            elif j in known and i not in known:
                offsets[i] = offsets[j] + ahead
                known.add(i)
    return offsets, True


def too_young(recordings: Sequence[Recording], offsets: Sequence[float]) -> list[str]:
    """A sentence for every link on which a sample was used before it was there, by clocks as `align` laid them.

    Args:
        recordings: of all users.
        offsets: of the users' clocks [s].
    """
    found: list[str] = []
    for i, one in enumerate(recordings):
        for j, two in enumerate(recordings):
            age = ages(one, two.user) if i != j and linked(one, two) else None
            ahead = offsets[i] - offsets[j]
            if age is not None and age.least + ahead < -EARLY and age.quick + ahead >= -READ:
                least = age.least + ahead
                found.append(f"{one.name} used a sample of {two.name} at an age of {least:.3g} s, which cannot be")
    return found


def grid_of(motions: Sequence[Motion]) -> Float:
    """Every instant at which some step begins or ends [s]."""
    return np.unique(np.concatenate([times for motion in motions for times in (motion.begin, motion.end)]))


def so_far(motion: Motion, values: Float, grid: Float) -> Float:
    """The sum of what steps booked, at the instants of a grid; straight within a step.

    Args:
        motion: of the user.
        values: what each step booked, (steps,).
        grid: instants [s].
    """
    total = np.concatenate([[0.0], np.cumsum(values)])
    knots = np.empty(2 * values.size)
    sums = np.empty(2 * values.size)
    knots[0::2], knots[1::2] = motion.begin, motion.end
    sums[0::2], sums[1::2] = total[:-1], total[1:]
    return np.interp(grid, np.maximum.accumulate(knots), sums)


def link_ledger(one: Motion, two: Motion, grid: Float, fractions: tuple[Float, Float]) -> LinkLedger:
    """Works out the ledger of the link between two users.

    Args:
        one: the first user's.
        two: the second user's.
        grid: as `grid_of` makes it.
        fractions: of each user's damping loss that is this link's, per step.
    """
    ends = one.recording.user, two.recording.user
    sides = (one, one.recording.neighbours.index(ends[1])), (two, two.recording.neighbours.index(ends[0]))
    other = two.recording.header.key, one.recording.header.key
    here = [linked_steps(m.recording, user, key) for (m, _), user, key in zip(sides, ends[::-1], other, strict=True)]
    works = [so_far(m, m.link[:, c] * own, grid) for (m, c), own in zip(sides, here, strict=True)]
    taken = np.zeros(grid.size)
    for motion, fraction, own in zip((one, two), fractions, here, strict=True):
        taken += so_far(motion, motion.known["local_loss"] * fraction * own, grid)
    ours = list(zip(sides, here, strict=True))
    strength = np.maximum(*(_at_grid(m, _strength(m, c) * own, grid) for (m, c), own in ours))
    status = np.minimum(*(_at_grid(m, np.where(own, _status(m, c), ABSENT), grid) for (m, c), own in ours))
    spring = _spring(one, two, grid) * strength
    counted = np.where(status == LinkState.COUPLED, spring, 0.0)
    bad = unrecorded(one, grid) | unrecorded(two, grid)
    work = works[0] + works[1]
    steps = np.diff(work + spring)
    steps[bad[1:]] = 0.0
    by_state = {
        name: float(steps[status[1:] == code].sum()) for code, name in _STATES.items() if np.any(status[1:] == code)
    }
    most = [ages(motion.recording, other) for motion, other in zip((one, two), ends[::-1], strict=True)]
    long = tuple(0.0 if age is None else age.most for age in most)
    excess, moment = _excess(one, two, grid, work + counted, taken, bad, float(strength.max(initial=0.0)), long)
    steps_of = sum(int(np.isfinite(motion.recording.columns["age"][:, c]).sum()) for motion, c in sides)
    found = sum(int(motion.link_known[:, c].sum()) for motion, c in sides)
    return LinkLedger(
        ends=ends,
        strength=float(strength.max(initial=0.0)),
        work=(float(works[0][-1]), float(works[1][-1])),
        spring=float(spring[-1] - spring[0]),
        age=(long[0], long[1]),
        by_state=by_state,
        dissipated=float(taken[-1]),
        made=work + counted - counted[0],
        taken=taken,
        excess=excess,
        moment=moment,
        strict=bool(one.kept.all() and two.kept.all()),
        whole=not bool(bad.any()),
        initial=float(counted[0]),
        unknown=1.0 - found / steps_of if steps_of else 1.0,
        granted=sum(
            granted(m.recording, user, key) for (m, _), user, key in zip(sides, ends[::-1], other, strict=True)
        ),
    )


def _excess(
    one: Motion,
    two: Motion,
    grid: Float,
    made: Float,
    taken: Float,
    bad: Bool,
    strength: float,
    long: tuple[float, ...],
) -> tuple[float, float]:
    """Most that was made beyond what was taken, each stretch between gaps by itself, and when."""
    best, moment = -np.inf, float(grid[0])
    edges = np.flatnonzero(np.diff(np.concatenate(([True], bad, [True]))))
    for first, last in edges.reshape(-1, 2):
        if last - first < 2:
            continue
        own = slice(first, last)
        # Motion before the stretch may still be on its way in samples: ½ K a² v² for each end.
        begin = float(grid[first])
        fast = max(_speed_at(motion, begin) for motion in (one, two))
        slack = 0.5 * strength * (long[0] ** 2 + long[1] ** 2) * fast
        beyond = made[own] - made[first] - taken[own] + taken[first] - slack
        at = int(np.argmax(beyond))
        if beyond[at] > best:
            best, moment = float(beyond[at]), float(grid[first + at])
    return (best if np.isfinite(best) else 0.0), moment


def _speed_at(motion: Motion, time: float) -> float:
    """‖v‖² just before an instant; 0 before the first step of a copy that starts at rest."""
    step = int(np.searchsorted(motion.end, time, side="right"))
    if step == 0:
        T = motion.end[0] - motion.begin[0]
        states = motion.recording.states
        if not motion.kept[0]:
            return 0.0
        start = 4.0 * (states["position"][0] - states["middle"][0]) / T - states["velocity"][0]
        field = motion.recording.header.body.field(start[None])
        square = float(motion.recording.header.body.form(motion.recording.header.body.weights[0], field)[0])
        fast = np.nanmax(motion.speed, initial=0.0)
        return square if square > 1e-20 * fast else 0.0
    value = float(motion.speed[min(step, motion.speed.size) - 1])
    return value if np.isfinite(value) else float(np.nanmax(motion.speed, initial=0.0))


def _spring(one: Motion, two: Motion, grid: Float) -> Float:
    """½ ‖x_i - x_j‖² in the weight of the link, for a spring of 1 N/m."""
    body = one.recording.header.body
    setup = next(s for s in one.recording.setups if two.recording.user in s.neighbours)
    weight = body.weights[setup.weight[setup.neighbours.index(two.recording.user)]]
    paths = [_Path(motion) for motion in (one, two)]
    out = np.zeros(grid.size)
    for first in range(0, grid.size, _BLOCK):
        times = grid[first : first + _BLOCK]
        apart = body.field(paths[0].at(times) - paths[1].at(times))
        out[first : first + _BLOCK] = 0.5 * body.form(weight, apart)
    return out


@final
class _Path:
    """Where a copy was, in recorded rows."""

    def __init__(self, motion: Motion) -> None:
        states = motion.recording.states
        rows = states["state_row"]
        self._x, self._middle = states["position"], states["middle"]
        knots = np.empty(2 * rows.size)
        knots[0::2], knots[1::2] = motion.begin[rows], motion.end[rows]
        self._knots = np.maximum.accumulate(knots)

    def at(self, times: Float) -> Float:
        """Position at the given times, (times, rows, axes); standing before the first and after the last."""
        last = self._knots.size - 1
        right = np.searchsorted(self._knots, times, side="right").clip(1, last)
        left = right - 1
        length = self._knots[right] - self._knots[left]
        part = ((times - self._knots[left]) / np.where(length > 0.0, length, 1.0)).clip(0.0, 1.0)
        before, after = self._knot(left), self._knot(right)
        return before + part[:, None, None] * (after - before)

    def _knot(self, knots: Long) -> Float:
        step = knots // 2
        ends = self._x[step]
        return np.where((knots % 2 == 0)[:, None, None], 2.0 * self._middle[step] - ends, ends)


def _at_grid(motion: Motion, values: Float, grid: Float) -> Float:
    """What a step says, at the instants up to its end: entry g holds between grid[g - 1] and grid[g]."""
    step = np.searchsorted(motion.end, grid - 1e-9).clip(0, values.size - 1)
    return values[step]


def _status(motion: Motion, column: int) -> Float:
    columns = motion.recording.columns
    return np.where(np.isfinite(columns["age"][:, column]), columns["link_state"][:, column], float(ABSENT))


def _strength(motion: Motion, column: int) -> Float:
    out = np.zeros(motion.recording.steps)
    user = motion.recording.neighbours[column]
    for setup, span in motion.recording.setup_rows():
        if user in setup.neighbours:
            out[span] = setup.strength[setup.neighbours.index(user)]
    return out


def unrecorded(motion: Motion, grid: Float) -> Bool:
    """Instants that end an interval of which the recording says nothing, though the user was there.

    Args:
        motion: of the user.
        grid: instants [s].
    """
    recording = motion.recording
    bad = np.zeros(grid.size, dtype=bool)
    for step in np.flatnonzero(~recording.consecutive)[1:]:
        bad |= (grid > motion.end[step - 1]) & (grid <= motion.begin[step] + 1e-9)
    if not recording.closed or recording.missing_after:
        bad |= grid > motion.end[-1]
    return bad
