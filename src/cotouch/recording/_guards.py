"""What guarded links were allowed, from the recorded books of their tanks; see `cotouch.peer.GuardBooks`.

Of every end of a link, as long as it has one guard, with U the energy in its spring as a step begins:

* tank = seed + credited + taken - given - paid - spilled, after every step;
* injected - U of a step is what the link did on the copy up to then, by recorded motion where that is known;
* what moves the spring's end while it is guarded is paid: injected rises no more than paid;
* what all tanks of a copy are credited in a step, its damping B_i took.
"""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from cotouch.recording._columns import GUARDS, LinkPhase
from cotouch.recording._recording import Recording

Float = npt.NDArray[np.float64]
Bool = npt.NDArray[np.bool_]


class Life(NamedTuple):
    """Steps over which an end of a link had one guard.

    Attributes:
        user: at the other end.
        key: of that user; None: not said.
        seed: what the tank started with; None: not said [J].
        steps: rows of the recording.
    """

    user: int
    key: str | None
    seed: float | None
    steps: slice


class Unbalanced(NamedTuple):
    """What one of the balances above lacks.

    Attributes:
        user: at the other end; None: of all links of the copy.
        words: which balance.
        energy: per step of the recording [J].
    """

    user: int | None
    words: str
    energy: Float


def lives(recording: Recording) -> list[Life]:
    """Every guard that there was, in order."""
    index = recording.columns["index"]
    open_now: dict[int, Life] = {}
    done: list[Life] = []
    for at, setup in enumerate(recording.setups):
        first = int(np.searchsorted(index, setup.first)) if at else 0
        keys = setup.keys or (None,) * len(setup.neighbours)
        seeds = setup.seeds or (None,) * len(setup.neighbours)
        here = {user: (key, seed) for user, key, seed in zip(setup.neighbours, keys, seeds, strict=True)}
        for user, life in list(open_now.items()):
            if user not in here or here[user][0] != life.key:
                done.append(life._replace(steps=slice(life.steps.start, first)))
                del open_now[user]
        for user, (key, seed) in here.items():
            if user not in open_now:
                open_now[user] = Life(user, key, seed, slice(first, recording.steps))
    return [life for life in [*done, *open_now.values()] if life.steps.stop > life.steps.start]


def linked_steps(recording: Recording, user: int, key: str) -> Bool:
    """Steps with a link to the one who is called by this key; a recording that says no keys means whoever it is."""
    out = np.zeros(recording.steps, dtype=bool)
    for life in lives(recording):
        if life.user == user and (life.key is None or not key or life.key == key):
            out[life.steps] = True
    return out


def seeds(recording: Recording) -> float:
    """What all tanks started with [J]."""
    return sum(life.seed or 0.0 for life in lives(recording))


def granted(recording: Recording, user: int, key: str) -> float:
    """What the tanks of a link had besides its own damping: seeds, and most of what others gave [J]."""
    if not set(GUARDS) <= set(recording.columns):
        return 0.0
    column, total = recording.neighbours.index(user), 0.0
    for life in lives(recording):
        if life.user == user and (life.key is None or not key or life.key == key):
            net = recording.columns["taken"][life.steps, column] - recording.columns["given"][life.steps, column]
            total += (life.seed or 0.0) + float(np.nanmax(net, initial=0.0))
    return total


def unbalanced(recording: Recording, link: Float, local_loss: Float) -> Iterator[Unbalanced]:
    """What the balances of the guards lack; nothing for a recording without guards.

    Args:
        recording: of one user.
        link: work of each link on the copy, per step, (steps, links) [J].
        local_loss: taken by B_i, per step [J].
    """
    columns = recording.columns
    if not set(GUARDS) <= set(columns):
        return
    credited = np.zeros(recording.steps)
    for life in lives(recording):
        at, column = life.steps, recording.neighbours.index(life.user)
        book = {name: columns[name][at, column] for name in GUARDS}
        if not all(np.isfinite(values).all() for values in book.values()):
            bad = np.where(np.all([np.isfinite(values) for values in book.values()], axis=0), 0.0, np.inf)
            yield Unbalanced(
                life.user, "the books of a guard have numbers that are not finite", _placed(bad, at, recording)
            )
            continue
        # A step after a gap has nothing to be compared with, nor has the first of a guard that began before.
        follows = recording.consecutive[at].copy()
        follows[0] = False
        kept = book["tank"] - book["credited"] - book["taken"] + book["given"] + book["paid"] + book["spilled"]
        lacks = _rise(kept, follows)
        if life.seed is not None:
            lacks[0] = kept[0] - life.seed
        yield Unbalanced(life.user, "a tank holds other than what it was given and paid", _placed(lacks, at, recording))
        done = np.zeros(kept.size)
        done[1:] = link[at, column][:-1]
        held = _rise(book["injected"] - book["potential"], follows) - np.where(follows, done, 0.0)
        words = "the books of a guard say another work than the link did"
        yield Unbalanced(life.user, words, _placed(held, at, recording))
        paid = _rise(book["injected"], follows) - _rise(book["paid"], follows)
        unpaid = np.where(columns["phase"][at, column] == LinkPhase.GUARDED, np.maximum(paid, 0.0), 0.0)
        yield Unbalanced(life.user, "a guarded link moved its spring's end unpaid", _placed(unpaid, at, recording))
        credited[at] += _rise(book["credited"], follows)
    beyond = np.maximum(credited - local_loss, 0.0)
    yield Unbalanced(None, "tanks were credited more than the damping took", beyond)


def _rise(values: Float, follows: Bool) -> Float:
    out = np.zeros(values.size)
    out[1:] = np.diff(values)
    return np.where(follows, out, 0.0)


def _placed(values: Float, at: slice, recording: Recording) -> Float:
    out = np.zeros(recording.steps)
    out[at] = values
    return out
