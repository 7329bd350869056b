"""What closed the recorded steps of a body with a material, taken back: where their velocities led to."""

from typing import TYPE_CHECKING

import numpy as np

from cotouch.arrays import Float, Long
from cotouch.errors import RecordingError
from cotouch.recording._columns import CLOSING

if TYPE_CHECKING:
    from cotouch.recording._recording import Recording


# As in the kernels: below this share of the kinetic energy nothing moves about the centre of mass.
_RIGID = 1e-9


def reopened(recording: "Recording", at: Long, v: Float, share: float) -> tuple[Float, Float]:
    """Takes back what closed the steps: `v⁺ = c + β (v' - c)`, c the centre's velocity or none.

    Args:
        recording: of a body with a material.
        at: steps whose states are recorded.
        v: velocities after these, before what a jammed tool lost, (steps, rows, axes) [m/s].
        share: of the body that the copy carried.

    Returns:
        v', likewise, NaN where nothing can be said, and the work on the velocity that closed each step, (steps,) [J].

    Raises:
        RecordingError: there are several bodies, and what closed them does not fit them.
    """
    material, columns = recording.header.body.material, recording.columns
    if material is not None and material.body.parts:
        sizes = [part.body.nodes for part in material.body.parts]
        closing = columns.get(CLOSING)
        fits = closing is not None and closing.shape[1:] == (len(sizes), 4) and sum(sizes) == v.shape[1]
        if closing is None or not fits or not np.isfinite(closing[at]).all():
            raise RecordingError(f"{recording.path} does not say how the steps of its {len(sizes)} bodies were closed")
        unclosed, did = _several(recording, at, np.repeat(np.arange(len(sizes)), sizes), closing[at], v, share)
        return unclosed, np.where(np.isnan(did), columns["closure"][at], did)
    return _one(recording, columns["closure"][at], columns["closure_factor"][at], v, share)


def _several(
    recording: "Recording", at: Long, part: Long, closing: Float, v: Float, share: float
) -> tuple[Float, Float]:
    """Each body by itself, or with others about their common centre, which those are that say the same."""
    body = recording.header.body
    bodies, masses = closing.shape[1], body.mass.diagonal()
    of = np.zeros((bodies, part.size))
    of[part, np.arange(part.size)] = masses
    mass, momentum = of.sum(axis=1), np.einsum("br,sra->sba", of, v)
    together = (closing[:, :, None] == closing[:, None]).all(axis=3).astype(np.float64)
    centre = np.einsum("sbc,sca->sba", together, momentum) / (together @ mass)[:, :, None]
    # What is said of the centre is believed only as far as whether it is one: any velocity could be made of another.
    centre[(closing[:, :, 1:] == 0.0).all(axis=2)] = 0.0
    beta = np.array(closing[:, :, :1])
    # What was taken from a body that comes to rest was rounding, unless a change is booked.
    nothing = recording.columns["closure_factor"][at] == 0.0
    beta[~(beta > 0.0)] = np.nan
    beta[nothing] = np.where(np.isnan(beta[nothing]), 1.0, beta[nothing])
    centre, beta = centre[:, part], beta[:, part]
    unclosed = np.where(beta == 1.0, v, centre + (v - centre) / beta)
    did = 0.5 * share * (body.form(body.mass, v) - body.form(body.mass, unclosed))
    return unclosed, did


def _one(recording: "Recording", work: Float, factor: Float, v: Float, share: float) -> tuple[Float, Float]:
    """About the centre or about rest: which it was is told by the work that goes with β."""
    body = recording.header.body
    # A change that rounding explains is booked as none; the work tells it.
    hidden = (factor == 0.0) & (work != 0.0)
    masses = body.mass.diagonal()
    centre = np.einsum("r,sra->sa", masses, v)[:, None] / masses.sum()
    beta = (1.0 + np.copysign(factor, work))[:, None, None]
    beta[beta <= 0.0] = np.nan
    kinetic = body.form(body.mass, v)
    tried: list[tuple[Float, Float]] = []
    for about in (centre, 0.0 * centre):
        moving = 0.5 * share * body.form(body.mass, v - about)
        part = 1.0 - np.divide(work, moving, out=np.zeros_like(work), where=hidden & (moving > np.abs(work)))
        unclosed = about + (v - about) * np.where(hidden, np.sqrt(part), 1.0)[:, None, None] / beta
        tried.append((unclosed, 0.5 * share * (kinetic - body.form(body.mass, unclosed))))
    (central, one), (whole, other) = tried
    beside = 0.5 * share * body.form(body.mass, v - centre)
    still = beside <= np.maximum(np.abs(work), _RIGID * 0.5 * share * kinetic)
    as_whole = np.where(hidden, still, np.abs(other - work) < np.abs(one - work))
    unclosed = np.where(as_whole[:, None, None], whole, central)
    return unclosed, np.where(np.isnan(one), work, np.where(as_whole, other, one))
