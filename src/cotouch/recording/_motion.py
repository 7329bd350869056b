"""One user's ledger, worked out anew: from recorded positions, velocities and forces, and the matrices of the body.

A recorded step says all there is: with x⁺, v⁺ after it, x̂ at its middle and T, it began at `x = 2 x̂ - x⁺` with
`v = 2 v̂ - v⁺`, where `v̂ = 2 (x⁺ - x̂) / T`. What the peer booked is used only where nothing else is recorded.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import final

import numpy as np

from cotouch.arrays import Bool, Float, Long
from cotouch.errors import RecordingError
from cotouch.peer import LinkState
from cotouch.recording._body import RecordedBody
from cotouch.recording._closing import reopened
from cotouch.recording._columns import UNSAID
from cotouch.recording._jammed import Jammed, before_loss, jammed_of
from cotouch.recording._outside import Outside, cut_steps, outside_of, scale_of, sunk_of
from cotouch.recording._recording import Recording, Setup
from cotouch.recording._said import told
from cotouch.recording._stopped import before_stop, stopped_rows

# Of a stamp that went through two clocks' numbers and back [s].
_SAME_STAMP = 1e-6
_EPS = float(np.finfo(np.float64).eps)
LOSSES = ("body_loss", "local_loss", "extra_loss", "cut")
# Events after which a copy may carry another share of the body.
_MEMBERS = {"joined", "left", "rescaled"}


@final
@dataclass(frozen=True, kw_only=True, eq=False)
class Motion:
    """What the recorded states say, at every step of the recording; energies and work in J.

    Attributes:
        recording: that it is of.
        begin: of every step, in the time that all users share [s].
        end: likewise.
        kept: whether the state of the step is recorded, so that it was worked out anew.
        known: by name (supplied, body_loss, local_loss, extra_loss, cut, drive_work), per step: worked out where it can
            be, else as booked.
        link: work of each link on the copy, (steps, links); likewise, 0 where there is none.
        link_known: whether it was worked out, (steps, links).
        start: stored in copy, proxies and contacts when the step began.
        stored: after it.
        residual: what nothing explains, per step; 0 where it was not worked out.
        carried: what came into the copy between the step before (or the last one whose state is recorded) and this.
        members: whether somebody joined or left there.
        sunk: of carried: what a share of a potential below 0 makes, that no hand can get; see `cotouch.peer.CopyScale`.
        depth: how far below 0 the energy was at most, of a body that fell below where it began.
        fallen: how far below 0 its potential energy was at most, however fast it moved there.
        difference: by name, what was worked out less what was booked, per step; links as "link N".
        speed: ‖v̂‖² in the weight of W_0, per step, NaN where not worked out.
        rounding: of the energies, from the size of the numbers they come from.
    """

    recording: Recording
    begin: Float
    end: Float
    kept: Bool
    known: Mapping[str, Float]
    link: Float
    link_known: Bool
    start: Float
    stored: Float
    residual: Float
    carried: Float
    members: Bool
    sunk: Float
    depth: float
    fallen: float
    difference: Mapping[str, Float]
    speed: Float
    rounding: float


def motions(recordings: Sequence[Recording], offsets: Sequence[float]) -> list[Motion]:
    """Works out everybody's ledger.

    Args:
        recordings: of different users of one session.
        offsets: shared time less each user's own [s].

    Raises:
        RecordingError: they do not belong together.
    """
    return [_motion(recording, recordings, offset) for recording, offset in zip(recordings, offsets, strict=True)]


def _motion(recording: Recording, others: Sequence[Recording], offset: float) -> Motion:
    columns, body = recording.columns, recording.header.body
    steps, T = recording.steps, columns["period"]
    rows = recording.states["state_row"]
    kept = np.zeros(steps, dtype=bool)
    kept[rows] = True
    known = {name: np.array(columns[name]) for name in ("supplied", *LOSSES, "drive_work")}
    link = np.nan_to_num(columns["link_work"])
    link_known = np.zeros(link.shape, dtype=bool)
    booked = columns["kinetic"] + columns["elastic"]
    stored = np.array(booked)
    start = np.full(steps, np.nan)
    speed = np.full(steps, np.nan)
    rounding = 0.0
    copies = np.ones(steps)
    closure = np.array(columns["closure"]) if body.material is not None else np.zeros(steps)
    scale, potential = scale_of(recording), np.zeros(rows.size)
    outside, jammed = outside_of(recording, scale), jammed_of(recording)
    for setup, span in recording.setup_rows():
        copies[span] = setup.copies
        chosen = np.flatnonzero((rows >= span.start) & (rows < span.stop))
        if chosen.size == 0:
            continue
        at = rows[chosen]
        around = None if outside is None else Outside(*(values[chosen] for values in outside))
        step = _Steps(body, recording, chosen, T[at], setup, scale[at], around, jammed)
        known["supplied"][at] = step.supplied(columns["force"][at], known["supplied"][at])
        for name, values in zip(LOSSES, step.losses(), strict=True):
            known[name][at] = values
        stored[at], start[at], size = step.energies()
        closure[at], potential[chosen] = step.closure, step.potential
        speed[at] = body.form(body.weights[0], step.mean)
        rounding = max(rounding, size)
        for entry, neighbour in enumerate(setup.neighbours):
            column = recording.neighbours.index(neighbour)
            key = setup.keys[entry] if setup.keys is not None else ""
            other = next((o for o in others if o.user == neighbour and (not key or o.header.key in {"", key})), None)
            work, found = step.link(entry, column, other, at)
            link[at[found], column] = work[found]
            link_known[at[found], column] = True
    extra, drive, tool_difference = _tools(recording, jammed)
    known["drive_work"] = drive
    difference = {name: known[name] - columns[name] for name in known}
    if body.material is not None:
        difference["closure"] = closure - columns["closure"]
    difference["stored"] = np.where(kept, stored - booked, 0.0)
    difference |= tool_difference
    for column, neighbour in enumerate(recording.neighbours):
        difference[f"link {neighbour}"] = link[:, column] - np.nan_to_num(columns["link_work"][:, column])
    touch = columns["touch_work"]
    lost = sum((known[name] for name in LOSSES), start=np.zeros(steps))
    gained = known["supplied"] + touch - lost + link.sum(axis=1)
    kept &= ~np.isnan(start)  # a step that was stopped to close it does not say how it began
    residual = np.where(kept, stored - start - gained, 0.0)
    start = np.where(kept, start, stored - gained)
    carried, members = _carried(recording, kept, stored, start, gained)
    sunk = sunk_of(scale, rows, potential)
    # Beyond the copy itself: proxies and contacts, whose part in a step is what the drives gave less what the body got.
    more = known["drive_work"] - touch - columns["touch_loss"]
    before = np.where(recording.consecutive, np.concatenate([[0.0], extra[:-1]]), extra - more)
    return Motion(
        recording=recording,
        begin=columns["time"] - T + offset,
        end=columns["time"] + offset,
        kept=kept,
        known=known,
        link=link,
        link_known=link_known,
        start=start + before,
        stored=stored + extra,
        residual=residual + np.where(recording.consecutive, extra - before - more, 0.0),
        carried=carried,
        members=members,
        sunk=sunk,
        depth=max(0.0, -float((stored + extra).min(initial=0.0))),
        fallen=max(0.0, -float((scale[rows] * potential).min(initial=0.0))),
        difference=difference,
        speed=speed,
        rounding=rounding,
    )


@final
class _Steps:
    """Steps with one setup whose states are recorded; every field (steps, body rows, axes)."""

    def __init__(
        self,
        body: RecordedBody,
        recording: Recording,
        chosen: Long,
        T: Float,
        setup: Setup,
        scale: Float,
        outside: Outside | None,
        jammed: Jammed | None,
    ) -> None:
        self.body, self.recording, self.setup, self.T = body, recording, setup, T
        x, self.v, self.middle = (
            body.field(recording.states[name][chosen]) for name in ("position", "velocity", "middle")
        )
        self.x = x
        self.mean = 2.0 * (x - self.middle) / T[:, None, None]
        self.copy_scale = 1.0 / setup.copies
        at = recording.states["state_row"][chosen]
        self.stiff, self.outside, self.potential = scale, outside, np.zeros(T.size)
        material = body.material
        when = cut_steps(recording) if material is not None else np.zeros(0)
        index, self.booked = recording.columns["index"][at], recording.columns["cut"][at]
        stopped = None if material is None else stopped_rows(material.body, when, index)
        moving, self.stopped = self.v, np.zeros(T.size)
        if stopped is not None:
            moving = before_stop(recording, chosen, self.v, self.mean, stopped, self.copy_scale)
            self.stopped = 0.5 * self.copy_scale * (body.form(body.mass, moving) - body.form(body.mass, self.v))
        if jammed is not None:
            about = jammed.rows(recording, at)
            if stopped is not None:  # of what then lost half of its motion and stopped nothing can be said
                moving = np.where(
                    (stopped[:, :, None] & ~np.isnan(about)).any(axis=(1, 2), keepdims=True), np.nan, moving
                )
                self.stopped[np.isnan(moving).any(axis=(1, 2))] = np.nan
            moving = before_loss(moving, about)
        self.start, self.unclosed, self.closure = 2.0 * self.middle - x, moving, np.zeros(T.size)
        self.inner = None if material is None else material.energies(self.start, x, self.mean, index=index, when=when)
        if material is not None:
            self.unclosed, self.closure = reopened(recording, at, moving, self.copy_scale)

    def energies(self) -> tuple[Float, Float, float]:
        """After each step, before it, and what rounding may make of them."""
        body = self.body
        start, speed = self.start, 2.0 * self.mean - self.unclosed
        after = self.copy_scale * body.form(body.mass, self.v) + self.stiff * body.form(body.stiffness, self.x)
        before = self.copy_scale * body.form(body.mass, speed) + self.stiff * body.form(body.stiffness, start)
        # The stretch of a body that has travelled is a small difference of large places; so is its mean velocity.
        places = np.abs(self.x).max(axis=(1, 2), initial=0.0)
        stiff, heavy = float(abs(body.stiffness).sum()), float(abs(body.mass).sum())
        fast = np.abs(self.v).max(axis=(1, 2), initial=0.0)
        size = stiff * places**2 + heavy * places * fast / self.T
        if self.inner is not None and body.material is not None:
            (held, came, _, _), mass = self.inner, body.mass.diagonal()
            came, held = came + body.material.weight(self.x, mass), held + body.material.weight(start, mass)
            if self.outside is not None:
                came, held = came + self.outside.after, held + self.outside.before
            after += 2.0 * self.stiff * came
            before += 2.0 * self.stiff * held
            self.potential = came + 0.5 * body.form(body.stiffness, self.x)
            # A place is as large as the body; what its rounding does grows with the force.
            strained = np.maximum(*self.inner[:2]) * float(abs(body.material.body.stiffness).sum())
            far = places + np.abs(body.rest).max()
            weight = float(np.linalg.norm(body.material.material.gravity)) * float(mass.sum())
            size = size + (np.sqrt(2.0 * strained) + weight) * far
            if self.outside is not None:
                firm = body.material.firmness()
                size = size + np.sqrt(2.0 * np.nan_to_num(np.maximum(*self.outside[:2])) * firm) * far
        return 0.5 * after, 0.5 * before, _EPS * self.copy_scale * float(size.max(initial=0.0))

    def losses(self) -> tuple[Float, Float, Float, Float]:
        """By the body's dampers, by B_i, by B_e, and with what was cut."""
        body, T = self.body, self.T
        square = [body.form(weight, self.mean) for weight in body.weights]
        local = sum((b * s for b, s in zip(self.setup.local_damping, square, strict=False)), np.zeros(T.size))
        extra = sum((b * s for b, s in zip(self.setup.extra_damping, square, strict=False)), np.zeros(T.size))
        own = self.copy_scale * body.form(body.damping, self.mean)
        if self.inner is not None:
            own += self.stiff * self.inner[2]
        rubbed = 0.0 if self.outside is None else self.stiff * self.outside.lost
        gone = np.zeros(T.size) if self.inner is None else self.stiff * self.inner[3]
        if self.outside is not None:
            gone = gone + self.stiff * self.outside.cut
        gone = gone + self.stopped
        gone = np.where(np.isnan(gone), self.booked, gone)
        return T * own + rubbed, T * local, T * extra, gone

    def supplied(self, force: Float, booked: Float) -> Float:
        """Work of the recorded forces at the nodes they act on."""
        ports = self.setup.ports
        if ports is None:
            return booked
        rate, material = self.mean.reshape(self.T.size, *self.body.rest.shape), self.body.material
        rate = rate if material is None else material.held(rate)
        if len(ports) != force.shape[1] or any(not 0 <= node < rate.shape[1] for node in ports):
            raise RecordingError(
                f"{self.recording.path} says that its ports hold the nodes {list(ports)}; its steps have "
                f"{force.shape[1]} ports, its body {rate.shape[1]} nodes"
            )
        seen: dict[int, int] = {}
        work = np.zeros(self.T.size)
        for port, node in enumerate(ports):
            if self.body.full:
                axis = seen.get(node, 0) % rate.shape[2]
                seen[node] = axis + 1
                work += force[:, port, 0] * rate[:, node, axis]
            else:
                work += np.einsum("sa,sa->s", force[:, port, : rate.shape[2]], rate[:, node])
        return self.T * work

    def link(self, entry: int, column: int, other: Recording | None, at: Long) -> tuple[Float, Bool]:
        """Work of a link, from the neighbour's own recording of the sample that was used, and where that was found."""
        work, found = np.zeros(at.size), np.zeros(at.size, dtype=bool)
        if other is None or self.setup.law != "spring":
            return work, found
        own = self.recording.columns
        places = _samples(other, own["used"][at, column], own["time"][at] - own["age"][at, column])
        found = (places >= 0) & (own["link_state"][at, column] == LinkState.COUPLED)
        if not found.any():
            return work, found
        weight = self.body.weights[self.setup.weight[entry]]
        said = told(other, self.recording.user, places[found])
        sure = np.isfinite(said).all(axis=(1, 2))
        found[found] = sure
        stretch = self.middle[found] - other.header.body.field(said[sure])
        scale = -self.T[found] * self.setup.strength[entry]
        work[found] = scale * self.body.form(weight, self.mean[found], stretch)
        rounding = self.setup.rounding
        if rounding > 0.0:  # a sample that was sent with fewer digits: what is booked fits it if it is this near
            booked = own["link_work"][at, column]
            slack = np.abs(scale) * rounding * np.abs(self.body.image(weight, self.mean[found])).sum(axis=(1, 2))
            work[found] = np.where(np.abs(work[found] - booked[found]) <= slack, booked[found], work[found])
        return work, found


def _samples(other: Recording, used: Long, stamp: Float) -> Long:
    """Which recorded states of the neighbour are the samples that were used: by index, else by stamp; -1: none."""
    rows = other.states["state_row"]
    if rows.size == 0:
        return np.full(used.size, -1)
    index = other.columns["index"][rows]
    stamps = other.columns["time"][rows] - 0.5 * other.columns["period"][rows]
    by_index = np.searchsorted(index, used).clip(0, rows.size - 1)
    right = np.searchsorted(stamps, stamp).clip(0, rows.size - 1)
    left = (right - 1).clip(0)
    nearest = np.where(np.abs(stamps[left] - stamp) < np.abs(stamps[right] - stamp), left, right)
    fits = np.abs(stamps[nearest] - stamp) <= _SAME_STAMP
    return np.where(
        used >= 0,
        np.where(index[by_index] == used, by_index, -1),
        np.where((used == UNSAID) & fits, nearest, -1),
    )


def _carried(recording: Recording, kept: Bool, stored: Float, start: Float, gained: Float) -> tuple[Float, Bool]:
    """What came into the copy between steps, beyond what the steps whose states are not recorded booked."""
    carried, members = np.zeros(kept.size), np.zeros(kept.size, dtype=bool)
    index = recording.columns["index"]
    copies = [(setup.first, setup.copies) for setup in recording.setups]
    changed = {first for (first, n), (_, before) in zip(copies[1:], copies[:-1], strict=True) if n != before}
    changed |= {event.first for event in recording.events if event.kind in _MEMBERS}
    rows = np.flatnonzero(kept)
    if rows.size < 2:
        return carried, members
    total = np.concatenate([[0.0], np.cumsum(gained)])
    breaks = np.cumsum(~recording.consecutive)
    whole = breaks[rows[1:]] == breaks[rows[:-1]]
    between = total[rows[1:]] - total[rows[:-1] + 1]
    carried[rows[1:]] = np.where(whole, start[rows[1:]] - stored[rows[:-1]] - between, 0.0)
    fractions = recording.columns.get("stiffness_scale")
    if fractions is not None:  # K's share rises over some steps
        members[rows[1:]] = np.diff(fractions[rows]) != 0.0
    for first in changed:
        after = np.searchsorted(index[rows], first)
        if 0 < after < rows.size:
            members[rows[after]] = True
    return carried, members


def _tools(recording: Recording, jammed: Jammed | None) -> tuple[Float, Float, dict[str, Float]]:
    """Energy of proxies and contacts, work of the drives, and where those differ from the ledger.

    Where there are no tools there is nothing of these, whatever the ledger says.
    """
    columns, steps = recording.columns, recording.steps
    drive = np.array(columns["drive_work"])
    without = "tool_velocity" not in columns
    if not without and not any(setup.tool_mass for setup in recording.setups):
        return columns["proxy"] + columns["touch_stored"], drive, {"held": np.zeros(steps)}
    rate, place, pulled, touched = (
        np.zeros((steps, 0, 3)) if without else columns[name]
        for name in ("tool_velocity", "tool_position", "drive_force", "touch_force")
    )
    mass = np.zeros((steps, rate.shape[1]))
    for setup, span in recording.setup_rows():
        if len(setup.tool_mass) == mass.shape[1]:
            mass[span] = setup.tool_mass
    kinetic = 0.5 * (mass * (rate**2).sum(axis=2)).sum(axis=1)
    moving = rate if jammed is None else before_loss(rate, jammed.tools)
    lost = 0.5 * (mass * (moving**2 - rate**2).sum(axis=2)).sum(axis=1)
    follows = recording.consecutive
    moved = np.zeros_like(place)
    moved[1:] = np.diff(place, axis=0)
    worked = (pulled * moved).sum(axis=(1, 2))
    felt = (touched * moved).sum(axis=(1, 2))
    drive = np.where(follows, worked, drive)
    before = np.concatenate([[0.0], kinetic[:-1]])
    held = np.concatenate([[0.0], columns["touch_stored"][:-1]])
    contact = -felt - columns["touch_work"] - columns["touch_loss"] - (columns["touch_stored"] - held)
    stored = np.zeros(steps) if without else columns["touch_stored"]  # nothing touches where there is no tool
    return (
        kinetic + stored,
        drive,
        {
            "held": kinetic + stored - columns["proxy"] - columns["touch_stored"],
            "proxies": np.where(follows, kinetic + lost - before - worked - felt, 0.0),
            "contacts": np.where(follows, contact + lost, 0.0),
        },
    )
