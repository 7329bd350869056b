"""Steps with a jammed tool, which lost half of their motion at their end: what moved how fast before that."""

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from cotouch.arrays import Bool, Float, Long
from cotouch.errors import RecordingError
from cotouch.recording._columns import JAMMED
from cotouch.recording._outside import cut_steps
from cotouch.recording._stopped import stopped_rows

if TYPE_CHECKING:
    from cotouch.recording._recording import Recording

# As in the kernels.
_KEPT = 0.5


class Jammed(NamedTuple):
    """Of each step, about which velocity bodies and tools lost motion; NaN: they did not.

    Attributes:
        bodies: (steps, bodies, 3) [m/s].
        tools: (steps, tools, 3) [m/s].
    """

    bodies: Float
    tools: Float

    def rows(self, recording: "Recording", at: Long) -> Float:
        """About which velocity each row of a field did, of some steps, (at, body rows, axes).

        Args:
            recording: of the copy.
            at: which steps.
        """
        body = recording.header.body
        about = np.broadcast_to(self.bodies[at][:, _part(recording)], (at.size, *body.rest.shape))
        return about.reshape(at.size, body.mass.shape[0], -1)


def jammed_of(recording: "Recording") -> Jammed | None:
    """What a recording says of such steps; None: there was none.

    Where the state is recorded, only which bodies and tools lost motion is believed, and along which axes they cannot
    go as a whole: about a freely chosen velocity, any could be made of any other. Where nodes lost their last element
    in the same step, and stopped, how all moved on the whole before is not in the state, and is believed.

    Args:
        recording: of the copy.

    Raises:
        RecordingError: it does not fit its bodies and tools.
    """
    told = recording.columns.get(JAMMED)
    if told is None:
        return None
    bodies = int(_part(recording).max()) + 1
    tools = recording.columns["tool_velocity"].shape[1] if "tool_velocity" in recording.columns else 0
    if told.shape[1:] != (bodies + tools, 3):
        raise RecordingError(f"{recording.path} does not say which of its {bodies} bodies and {tools} tools jammed")
    lost: Bool = np.logical_and.reduce(np.isfinite(told), axis=2)
    about = np.array(told, dtype=np.float64)
    about[~lost] = np.nan
    rows = recording.states["state_row"]
    stopped = _stopped(recording, rows)
    for setup, span in recording.setup_rows():
        masses = np.array(setup.tool_mass) if len(setup.tool_mass) == tools else np.zeros(tools)
        for chosen in np.flatnonzero((rows >= span.start) & (rows < span.stop) & lost[rows].any(axis=1)):
            k = int(rows[chosen])
            if stopped is not None and (stopped[chosen] & lost[k, _part(recording)]).any():
                continue
            momentum, mass = _whole(recording, int(chosen), lost[k, :bodies], setup.copies)
            if tools:
                moving = masses * lost[k, bodies:]
                momentum, mass = momentum + moving @ recording.columns["tool_velocity"][k], mass + moving.sum()
            with np.errstate(invalid="ignore", divide="ignore"):
                about[k] = np.where(lost[k][:, None] & (about[k] != 0.0), momentum / mass, about[k])
    return Jammed(about[:, :bodies], about[:, bodies:])


def before_loss(after: Float, about: Float) -> Float:
    """Velocities before a part of them was lost.

    Args:
        after: that [m/s].
        about: which velocity, likewise; NaN where none was.
    """
    return np.where(np.isnan(about), after, about + (after - about) / _KEPT)


def _stopped(recording: "Recording", rows: Long) -> Bool | None:
    """Which nodes each step whose state is recorded stopped, (states, nodes); None: none did."""
    material = recording.header.body.material
    return (
        None
        if material is None
        else stopped_rows(material.body, cut_steps(recording), recording.columns["index"][rows])
    )


def _part(recording: "Recording") -> Long:
    """Body of each node, (n,)."""
    body = recording.header.body
    parts = () if body.material is None else body.material.body.parts
    return np.repeat(np.arange(len(parts)), [p.body.nodes for p in parts]) if parts else np.zeros(len(body.rest), int)


def _whole(recording: "Recording", chosen: int, lost: Bool, copies: int) -> tuple[Float, Float]:
    """Momentum and mass of the bodies that lost motion, along each axis."""
    body = recording.header.body
    v = body.field(recording.states["velocity"][chosen])[None]
    momentum, mass = np.zeros(3), np.zeros(3)
    for axis in range(3):
        whole = np.zeros(body.rest.shape)
        whole[lost[_part(recording)], axis] = 1.0
        along = whole.reshape(v.shape)
        momentum[axis], mass[axis] = (body.form(body.mass, along, other)[0] / copies for other in (v, along))
    return momentum, mass
