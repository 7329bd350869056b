"""What stood around a recorded body: what it held and took, and what a changed share of it makes."""

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from cotouch.arrays import Float, Long
from cotouch.errors import RecordingError

if TYPE_CHECKING:
    from cotouch.recording._recording import Recording

# Of a place that is worked out from two others.
_ROUNDING = 1e-14


class Outside(NamedTuple):
    """What obstacles hold and take of a whole body.

    Attributes:
        before: each step, (steps,) [J].
        after: likewise.
        lost: in it, likewise.
        cut: what went with what was cut after it, likewise; NaN where that cannot be told.
    """

    before: Float
    after: Float
    lost: Float
    cut: Float


def scale_of(recording: "Recording") -> Float:
    """Share of K, weight and obstacles that the copy carried in each step, (steps,).

    Args:
        recording: of the copy.
    """
    given = recording.columns.get("stiffness_scale")
    if given is not None:
        return np.asarray(given, dtype=np.float64)
    scale = np.ones(recording.steps)
    for setup, span in recording.setup_rows():
        scale[span] = 1.0 / setup.copies
    return scale


def outside_of(recording: "Recording", scale: Float) -> Outside | None:
    """What planes and boxes held and took in the steps whose states are recorded; None without.

    Args:
        recording: of the copy.
        scale: of `scale_of`.
    """
    material, columns, states = recording.header.body.material, recording.columns, recording.states
    if material is None or not (material.world or material.between):
        return None
    rows = states["state_row"]
    x, middle = (recording.header.body.field(states[name]) for name in ("position", "middle"))
    held = columns["world_stored"] / scale
    before = np.where(recording.consecutive, np.concatenate([[np.nan], held[:-1]]), np.nan)
    follows = np.concatenate([[False], np.diff(rows) == 1]) & recording.consecutive[rows]
    fresh = columns["index"][rows] == 0
    when, index = cut_steps(recording), columns["index"][rows]
    gone = np.where(np.isin(index, when), np.nan, 0.0)
    told = Outside(before[rows], held[rows], (columns["world_loss"] / scale)[rows], gone)
    given = (_begun(x, middle), x, columns["period"][rows], told)
    return material.outside(*given, fresh=fresh, follows=follows, index=index, when=when, user=recording.user)


def _begun(x: Float, middle: Float) -> Float:
    """Where steps began: where the ones before ended, to the bit, if rounding is all that tells these apart.

    Which of two triangles is nearer to a point, a bit may decide, and with that what is lost in friction.

    Args:
        x: displacements after each step, (steps, rows, axes) [m].
        middle: at its middle, likewise.
    """
    start, before = 2.0 * middle - x, np.concatenate([x[:1], x[:-1]])
    largest = np.maximum(np.abs(x), np.abs(before)).max(axis=(1, 2), initial=0.0)
    apart = np.abs(start - before).max(axis=(1, 2), initial=0.0)
    same = apart <= _ROUNDING * largest
    return np.where(same[:, None, None], before, start)


def cut_steps(recording: "Recording") -> Float:
    """After which step each element was cut, as far as the recording says; infinite where it was not, (elements,).

    Args:
        recording: of the copy; nothing of it is believed.

    Raises:
        RecordingError: it names an element that the body has not.
    """
    material = recording.header.body.material
    found = np.full(0 if material is None else material.body.cut_count, np.inf)
    for event in recording.events:
        if event.kind != "cut":
            continue
        named: list[object] = list(event.fields.get("elements") or [])
        step = event.fields.get("step")
        known = all(isinstance(e, int) and 0 <= e < found.size for e in named)
        if not known or not isinstance(step, int):
            raise RecordingError(f"{recording.path} lists cut elements that its body does not have: {str(named)[:60]}")
        chosen = np.array(named, dtype=np.int64)
        found[chosen] = np.minimum(found[chosen], step)
    return found


def sunk_of(scale: Float, rows: Long, potential: Float) -> Float:
    """Of what came with a change of share, what counts from the lowest place at which that fell, (steps,) [J].

    Args:
        scale: of `scale_of`.
        rows: steps whose states are recorded.
        potential: of the whole body after each of these [J].
    """
    sunk, low = np.zeros(scale.size), 0.0
    for n in np.flatnonzero(np.diff(scale[rows])):
        change = scale[rows[n + 1]] - scale[rows[n]]
        if change < 0.0:
            low = min(low, float(potential[n]))
        sunk[rows[n + 1]] = change * low
    return sunk
