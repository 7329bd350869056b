"""What neighbours were told by a perceptual codec, from what its sender recorded, and what that may have cost.

A column says of every step and link how its sample was said. With the recorded positions that gives every content, and
how it went on, to the last bit (`cotouch.peer.ContentForm`).
"""

from collections import deque

import numpy as np

from cotouch.arrays import Float, Long
from cotouch.laws import SPRING
from cotouch.peer import FULL, ROUNDED, Content, ContentForm
from cotouch.recording._columns import SAID
from cotouch.recording._recording import Recording

_ASTRAY = 1e12  # [m²]


def told(recording: Recording, user: int, places: Long) -> Float:
    """Positions as a neighbour was told them, (places, rows, axes); NaN where that cannot be said [m].

    Args:
        recording: of the sender.
        user: the neighbour.
        places: states of the recording that were its samples.
    """
    middle, rows = recording.states["middle"], recording.states["state_row"]
    codec = next((setup.codec for setup in recording.setups if setup.codec is not None), None)
    if codec is None or SAID not in recording.columns or user not in recording.neighbours:
        return middle[places]
    said = recording.columns[SAID][:, recording.neighbours.index(user)]
    index, stamp = recording.columns["index"], recording.columns["time"] - 0.5 * recording.columns["period"]
    step = rows[places]
    since = np.nan_to_num(np.where((said > FULL) & (said < ROUNDED), said, 0.0), nan=0.0).astype(np.int64)[step]
    base = np.searchsorted(index, index[step] - since).clip(0, index.size - 1)
    known = (index[base] == index[step] - since) & np.isin(said[base], (FULL, ROUNDED))
    before = _before(said)[base]
    known &= (before >= 0) | (since == 0)
    before = np.where(known, before.clip(0), base)
    at, earlier = (np.searchsorted(rows, which).clip(0, rows.size - 1) for which in (base, before))
    known &= (rows[at] == base) & (rows[earlier] == before)
    passed = (stamp[base] - stamp[before])[:, None, None]
    rates = np.divide(middle[at] - middle[earlier], passed, out=np.zeros_like(middle[at]), where=passed > 0.0)
    form, out = ContentForm(codec, SPRING), np.full(middle[at].shape, np.nan)
    for kind, make in ((FULL, form.exact), (ROUNDED, form.rounded)):
        own = np.flatnonzero(known & (said[base] == kind))
        shape = middle[at[own]].shape
        none = np.zeros(0)
        content = Content(
            index=0,
            stamp=0.0,
            fields=middle[at[own]].reshape(1, -1),
            rates=rates[own].reshape(1, -1),
            scalars=none,
            flow=none,
        )
        found = make(content) if own.size else None
        if found is not None:
            on = (stamp[step] - stamp[base])[own, None, None]
            out[own] = found.fields.reshape(shape) + np.where(on > 0.0, on * found.rates.reshape(shape), 0.0)
    return out


def unpaid_errors(recording: Recording, user: int) -> Float:
    """What errors of samples for a neighbour may have cost beyond the damping that pays for them, per step [J].

    Nothing where a state or step is not recorded, or the recording begins later than the copy.

    Args:
        recording: of the sender.
        user: the neighbour.
    """
    out, rows = np.zeros(recording.steps), recording.states["state_row"]
    whole = rows.size == recording.steps and recording.consecutive[1:].all() and recording.columns["index"][0] == 0
    if SAID not in recording.columns or not whole:
        return out
    body, middle = recording.header.body, recording.states["middle"]
    off = told(recording, user, np.arange(rows.size)) - middle
    said = recording.columns[SAID][:, recording.neighbours.index(user)]
    index = recording.columns["index"]
    spoke = said >= FULL  # false for NaN
    first = int(index[np.argmax(spoke)]) if spoke.any() else 0
    # What goes on from before the recording is not known; what goes on from nothing at all is as wrong as can be.
    early = spoke & (index - np.where(said < ROUNDED, said, 0.0) <= first)
    unknown = ~np.isfinite(off).all(axis=(1, 2))
    off[~spoke | (unknown & early)] = 0.0
    columns, stamp = recording.columns, recording.columns["time"] - 0.5 * recording.columns["period"]
    mean = 2.0 * (recording.states["position"] - middle) / columns["period"][:, None, None]
    for setup, span in recording.setup_rows():
        codec = setup.codec
        if codec is None or user not in setup.neighbours or setup.link_damping is None:
            continue
        at = setup.neighbours.index(user)
        strength, weight = setup.strength[at], body.weights[setup.weight[at]]
        if strength > 0.0:
            wrong = body.form(weight, body.field(off[span]))
            window = 2.0 * setup.link_damping[at] / strength - 2.0 * codec.age
            worst = _worst(np.where(np.isfinite(wrong), wrong, _ASTRAY), stamp[span], columns["period"][span], window)
            earned = codec.age * body.form(weight, body.field(mean[span]))
            out[span] = 0.5 * strength * columns["period"][span] * (worst / codec.age - earned)
    spent = np.cumsum(out)
    return np.diff(np.maximum.accumulate(np.maximum(spent, 0.0)), prepend=0.0)


def _worst(wrong: Float, stamp: Float, T: Float, window: float) -> Float:
    """The largest error of the samples that may be in use all through each step: never more than there was."""
    out, kept = np.zeros(wrong.size), deque[int]()
    for k, error in enumerate(wrong.tolist()):
        while kept and stamp[kept[0]] + window < stamp[k] + 0.5 * T[k]:
            kept.popleft()
        out[k] = wrong[kept[0]] if kept else 0.0  # the step's own sample is sent after it
        while kept and wrong[kept[-1]] <= error:
            kept.pop()
        kept.append(k)
    return out


def _before(said: Float) -> Long:
    """The last step before each of which something was said on the same link; -1: none that is known."""
    steps = np.arange(said.size)
    last = np.maximum.accumulate(np.where(said >= FULL, steps, -1))
    gone = np.maximum.accumulate(np.where(np.isnan(said), steps, -1))
    before = np.concatenate([[-1], last[:-1]])
    return np.where(before > np.concatenate([[-1], gone[:-1]]), before, -1)
