"""What guarded links, and those of a law that pays, may do, by recorded ledgers; see `cotouch.peer.GuardLedger`.

Of every end of a link, as long as it has one guard, with U the energy in its spring as a step begins:

* tank = initial_energy + credited + taken - given - paid - discarded, after every step;
* injected - U of a step is what the link did on the copy up to then, by recorded motion where that is known;
* what moves the spring's end while it is guarded is paid: injected rises no more than paid;
* what all tanks of a copy are credited in a step, its damping B_i took;
* what an end got of the other, it took, and the other had given it by then;
* what else the tanks of a copy took, they gave each other, or the body's damping and B_e took it, or it is of the
  newcomer's allowance, of which there is no more than was declared.

Of every copy whose links a law holds that is passive by itself: what all of them did on it, by recorded motion where
that is known, is at no time more than what they began with, the allowance and what the other ends gave, less what it
gave.
"""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from cotouch.arrays import Bool, Float
from cotouch.peer import MOST_AHEAD, LinkState
from cotouch.recording._columns import ADVANCED, EXCHANGE, GUARDS
from cotouch.recording._recording import Recording

# Time may pass between the two readings that relate a user's clock to Unix time [s].
READ = 1e-4
# What a step used may have been sent so long after its end [s].
EARLY = MOST_AHEAD + READ


class Life(NamedTuple):
    """Steps over which an end of a link had one guard.

    Attributes:
        user: at the other end.
        key: of that user; None: not said.
        initial_energy: what the tank started with; None: not said [J].
        steps: rows of the recording.
    """

    user: int
    key: str | None
    initial_energy: float | None
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
    """Every guard that there was, in order, of which a step is recorded."""
    return [life for life in _all_lives(recording) if life.steps.stop > life.steps.start]


def _all_lives(recording: Recording) -> list[Life]:
    index = recording.columns["index"]
    open_now: dict[int, Life] = {}
    done: list[Life] = []
    for at, setup in enumerate(recording.setups):
        first = int(np.searchsorted(index, setup.first)) if at else 0
        keys = setup.keys or (None,) * len(setup.neighbours)
        energies = setup.initial_energies or (None,) * len(setup.neighbours)
        here = {user: (key, energy) for user, key, energy in zip(setup.neighbours, keys, energies, strict=True)}
        for user, life in list(open_now.items()):
            if user not in here or here[user][0] != life.key:
                done.append(life._replace(steps=slice(life.steps.start, first)))
                del open_now[user]
        for user, (key, energy) in here.items():
            if user not in open_now:
                open_now[user] = Life(user, key, energy, slice(first, recording.steps))
    return [*done, *open_now.values()]


def linked_steps(recording: Recording, user: int, key: str) -> Bool:
    """Steps with a link to the one who is called by this key; a recording that says no keys means whoever it is.

    Args:
        recording: of one user.
        user: number of the neighbour, from 0.
        key: of the neighbour, as its recording says.
    """
    out = np.zeros(recording.steps, dtype=bool)
    for life in lives(recording):
        if life.user == user and (life.key is None or not key or life.key == key):
            out[life.steps] = True
    return out


def advanced(recording: Recording) -> Float:
    """What the tanks got of the newcomer's allowance, per step; nothing where that is no number [J]."""
    said = np.asarray(recording.columns.get(ADVANCED, np.zeros(recording.steps)), dtype=np.float64)
    return np.where(np.isfinite(said), said, 0.0)


def started(recording: Recording) -> float:
    """What all tanks were given once: what they began with, and of the allowance as far as that was declared [J]."""
    declared = max(setup.allowance for setup in recording.setups)
    return sum(life.initial_energy or 0.0 for life in lives(recording)) + min(
        float(advanced(recording).sum()), declared
    )


def granted(recording: Recording, user: int, key: str) -> float:
    """What the tanks of a link had besides its own damping: what they began with, and most of what others gave [J].

    Args:
        recording: of one user.
        user: number of the neighbour, from 0.
        key: of the neighbour, as its recording says.
    """
    if not set(GUARDS) <= set(recording.columns):
        return 0.0
    column, total = recording.neighbours.index(user), 0.0
    for life in lives(recording):
        if life.user == user and (life.key is None or not key or life.key == key):
            net = recording.columns["taken"][life.steps, column] - recording.columns["given"][life.steps, column]
            total += (life.initial_energy or 0.0) + float(np.nanmax(net, initial=0.0))
    return total


def unbalanced(recording: Recording, link: Float, local_loss: Float) -> Iterator[Unbalanced]:
    """What the balances of the guards lack; nothing for a recording without guards.

    Args:
        recording: of one user.
        link: work of each link on the copy, per step, (steps, links) [J].
        local_loss: taken by B_i, per step [J].
    """
    columns = recording.columns
    if any(setup.law != "spring" for setup in recording.setups):
        yield Unbalanced(None, "links did more than they were paid for", _unpaid(recording, link))
        return
    if not set(GUARDS) <= set(columns):
        return
    credited, helped, shared = (np.zeros(recording.steps) for _ in range(3))
    exchange = set(EXCHANGE) <= set(columns)
    for life in lives(recording):
        at, column = life.steps, recording.neighbours.index(life.user)
        book = {name: columns[name][at, column] for name in (*GUARDS, *(EXCHANGE if exchange else ()))}
        if not all(np.isfinite(values).all() for values in book.values()):
            bad = np.where(np.all([np.isfinite(values) for values in book.values()], axis=0), 0.0, np.inf)
            yield Unbalanced(
                life.user, "the ledger of a guard has numbers that are not finite", _placed(bad, at, recording)
            )
            continue
        # A step after a gap has nothing to be compared with, nor has the first of a guard that began before.
        follows = recording.consecutive[at].copy()
        follows[0] = False
        kept = book["tank"] - book["credited"] - book["taken"] + book["given"] + book["paid"] + book["discarded"]
        lacks = _rise(kept, follows)
        if life.initial_energy is not None:
            lacks[0] = kept[0] - life.initial_energy
        yield Unbalanced(
            life.user, "a tank does not hold what it received less what it paid", _placed(lacks, at, recording)
        )
        done = np.zeros(kept.size)
        done[1:] = link[at, column][:-1]
        held = _rise(book["injected"] - book["potential"], follows) - np.where(follows, done, 0.0)
        words = "a guard's ledger disagrees with the work that the link did"
        yield Unbalanced(life.user, words, _placed(held, at, recording))
        paid = _rise(book["injected"], follows) - _rise(book["paid"], follows)
        unpaid = np.where(columns["link_state"][at, column] != LinkState.COUPLED, np.maximum(paid, 0.0), 0.0)
        yield Unbalanced(
            life.user, "a guarded link moved the end of its spring without paying", _placed(unpaid, at, recording)
        )
        credited[at] += _rise(book["credited"], follows)
        if exchange:
            gave, got = _rise(book["sent"], follows), _rise(book["received"], follows)
            more = np.maximum(gave - _rise(book["given"], follows), 0.0)
            more += np.maximum(got - _rise(book["taken"], follows), 0.0) + np.maximum(-got, 0.0)
            yield Unbalanced(
                life.user, "a tank exchanged more with the other end than in total", _placed(more, at, recording)
            )
            helped[at] += _rise(book["taken"], follows) - got
            shared[at] += _rise(book["given"], follows) - gave
    beyond = np.maximum(credited - local_loss, 0.0)
    yield Unbalanced(None, "tanks were credited more than the damping took", beyond)
    if exchange:
        most = np.cumsum(shared + columns["body_loss"] + columns["extra_loss"] + advanced(recording))
        words = "tanks took more from the copy than other tanks gave and its own damping dissipated"
        yield Unbalanced(None, words, _rises(np.cumsum(helped) - most))
        got = np.cumsum(advanced(recording))
        more = _rises(got - max(setup.allowance for setup in recording.setups)) + np.maximum(-advanced(recording), 0.0)
        yield Unbalanced(None, "tanks received more of the newcomer's allowance than there is", more)


def _unpaid(recording: Recording, link: Float) -> Float:
    """What the links of a law did on a copy beyond what paid for it, per step, up to the first gap [J]."""
    columns, until = recording.columns, recording.steps
    gaps = np.flatnonzero(~recording.consecutive[1:])
    if gaps.size:
        until = int(gaps[0]) + 1
    if not set(EXCHANGE) <= set(columns) or not all(
        np.isfinite(columns[name][life.steps, recording.neighbours.index(life.user)]).all()
        for life in lives(recording)
        for name in EXCHANGE
    ):
        return np.full(recording.steps, np.inf)
    declared = max(setup.allowance for setup in recording.setups)
    paid = np.minimum(np.cumsum(advanced(recording)), declared)
    for life in lives(recording):
        at, column = life.steps, recording.neighbours.index(life.user)
        net = columns["received"][at, column] - columns["sent"][at, column]
        paid[at] += net + (life.initial_energy or 0.0)
        paid[at.stop :] += net[-1] + (life.initial_energy or 0.0)
    beyond = np.cumsum(link.sum(axis=1)) - paid
    beyond[until:] = -np.inf
    return _rises(beyond)


def unfounded(one: Recording, two: Recording, at_one: Float, at_two: Float) -> Float:
    """What an end got of the other that the other had not given by then, per step of the first [J].

    Nothing where either does not say, where the second is not recorded to the end of what the first got, or to the end
    of its guard, or has gaps and more than one guard.

    Args:
        one: of the user who got it.
        two: of the one at the other end.
        at_one: ends of the first one's steps, on a clock that both share [s].
        at_two: likewise of the second.
    """
    nothing = np.zeros(one.steps)
    if not set(EXCHANGE) <= set(one.columns) & set(two.columns):
        return nothing
    got, gave = _so_far(one, "received", two), _so_far(two, "sent", one)
    if two.missing and (guards := [life for life in _all_lives(two) if _towards(life, one)]):
        end = guards[0].steps.stop
        if len(guards) > 1 or end == guards[0].steps.start:
            return nothing
        if end < two.steps and not two.consecutive[end]:
            gave[end:] = np.inf  # it may have given more before the guard went
    # The first step that ends no earlier than what may have been used was sent: what it had given is no less, whatever
    # is not recorded in between.
    when = np.searchsorted(at_two, at_one + EARLY)
    late = when == at_two.size
    open_ended = two.broken is not None or two.missing_after > 0
    least = np.where(late, np.inf if open_ended else gave[-1], gave[np.minimum(when, at_two.size - 1)])
    return _rises(got - least)


def _towards(life: Life, other: Recording) -> bool:
    return life.user == other.user and (life.key is None or not other.header.key or life.key == other.header.key)


def _so_far(recording: Recording, name: str, other: Recording) -> Float:
    """A sum over all guards towards another, after each step."""
    out, before = np.zeros(recording.steps), 0.0
    for life in lives(recording):
        if _towards(life, other):
            values = np.nan_to_num(recording.columns[name][life.steps, recording.neighbours.index(life.user)])
            out[life.steps] = before + values
            before += float(values[-1])
            out[life.steps.stop :] = before
    return out


def _rises(values: Float) -> Float:
    """What a sum, where it is above all before and above zero, rose by."""
    return np.diff(np.maximum.accumulate(np.maximum(values, 0.0)), prepend=0.0)


def _rise(values: Float, follows: Bool) -> Float:
    out = np.zeros(values.size)
    out[1:] = np.diff(values)
    return np.where(follows, out, 0.0)


def _placed(values: Float, at: slice, recording: Recording) -> Float:
    out = np.zeros(recording.steps)
    out[at] = values
    return out
