"""One end of a device's coupling: a row of named numbers, and the energy that it may use.

A device and its proxy are joined by a spring and dampers whose two ends live apart: in two processes on a real device,
in the ticks of a servo and the steps of a body in a simulation. Each knows the other as it was, by how much nobody can
promise. One account for both cannot be kept so: two that draw on what they believe is there draw it twice. So each end
has a *tank* of its own, and books into it its own port's work, exactly:

* the device's end `F·Δq` for a force held between two measured places, plus what encoder and levers may hide, less
  what the device's own friction took, as far as that is known;
* the proxy's end `τᵀŵ T`, what the spring of the implicit step really did.

An end tells the other sums since the start that only rise: what it gave away (`given`), what came into the coupling at
its port (`put`) and what left it there (`taken`), and what it knows of the other's. A law counts on one of two things:

* **gifts** (`share`). What one gives to the other leaves its own tank first. Whatever is lost, late, read twice or
  never: received by i, as i knows it ≤ given to i, in truth, because an old sum is a smaller one. With X the work that
  left the coupling at a port, less what friction paid,

      X_device + X_proxy = initial energies - tanks - lost - (given and not yet received) ≤ initial energies + debts

  which is two-port passivity without a word about delays. A stale sum costs liveliness, never passivity. Each end says
  whether it is starved and what its tank holds; the other then evens the tanks out, in some milliseconds. An *initial
  energy* starts both: without any, no held force does work that could be saved.
* **one pool** (`pool`). Each counts on `put - taken` of the other as if it were its own. An old `taken` promises too
  much, so the proxy never takes more than the initial energy beyond what the device has heard of (`unheard`).

The device's end decides on a force while the one before may still act (`latency`). It therefore keeps back what the
acting force's spring holds, and owes at most two such ticks (`cotouch.mechanics.modulation_bound`).
"""

from math import exp, inf, isfinite
from typing import NamedTuple

import numpy as np

from cotouch.arrays import Float
from cotouch.coupling._modulation import credit
from cotouch.kernels import inner, kernel

# In which tanks even out [s]: quicker than a hand, slower than what one end knows of the other on a loaded machine.
_EVEN = 0.01


class EndFields(NamedTuple):
    """Where each number of an end stands in its row. Triples are named by their first.

    Attributes:
        stiffness: k of the coupling [N/m]; like all that follow up to `latency`, never changed by a law.
        damping: b, at each end [Ns/m].
        cap: most that a tank keeps beyond its springs [J].
        reserve: debt up to which the damping stays on [J].
        initial: energy that the tank starts with; counts once in the bound of passivity [J].
        friction: viscous, that the device itself has for certain [Ns/m].
        ages: of the places that both ends know of each other, together [s].
        weight: d of the age rule.
        most: force at which a law may saturate [N].
        latency: ticks from a decision until its force acts, 0 or 1.
        energy: in the tank, springs included; negative: a debt [J].
        given: to the other since the start [J].
        received: of what the other gave [J].
        put: what came in at this port since the start, by work and friction [J].
        taken: what left there, by work or unseen [J].
        known_put: of the other's `put`, what is in this tank [J].
        known_taken: of the other's `taken`, likewise [J].
        lost: what could not be kept, and what may have been unseen [J].
        work: of this port on what is outside [J].
        paid: what friction took [J].
        lowest: the deepest debt so far, <= 0 [J].
        starved: 1: this end cannot follow for want of energy.
        heard_given: as the other said it last [J].
        heard_received: likewise [J].
        heard_put: likewise [J].
        heard_taken: likewise [J].
        heard_known: of this end's `taken`, what the other knows [J].
        heard_energy: in the other's tank [J].
        heard_starved: likewise.
        T: length of the tick or step [s].
        known: 1: there is a desired place; 0: none is known, or it is not to be followed.
        gap: desired place less place, in three numbers [m].
        rate: velocity of the device's tip, in three numbers [m/s].
        acting: energy of the springs behind a force that still acts when this one begins; 0 at the proxy [J].
        kept: energy that other springs of this end hold [J].
        spring: result: k of the spring that acts [N/m].
        brake: result: b of the damper at this end [Ns/m].
        stretch: result: from the place to the set position, in three numbers [m].
        push: result: force beside spring and damper, in three numbers [N].
        held: result: energy of the spring, `½ k‖stretch‖²` [J].
        fraction: result: how far the set position follows the desired position, in [0, 1].
        memory: four numbers that a law keeps for itself; 0 at the start.
        length: of a row.
    """

    stiffness: int = 0
    damping: int = 1
    cap: int = 2
    reserve: int = 3
    initial: int = 4
    friction: int = 5
    ages: int = 6
    weight: int = 7
    most: int = 8
    latency: int = 9
    energy: int = 10
    given: int = 11
    received: int = 12
    put: int = 13
    taken: int = 14
    known_put: int = 15
    known_taken: int = 16
    lost: int = 17
    work: int = 18
    paid: int = 19
    lowest: int = 20
    starved: int = 21
    heard_given: int = 22
    heard_received: int = 23
    heard_put: int = 24
    heard_taken: int = 25
    heard_known: int = 26
    heard_energy: int = 27
    heard_starved: int = 28
    T: int = 29
    known: int = 30
    gap: int = 31
    rate: int = 34
    acting: int = 37
    kept: int = 38
    spring: int = 39
    brake: int = 40
    stretch: int = 41
    push: int = 44
    held: int = 47
    fraction: int = 48
    memory: int = 49
    length: int = 53


END = EndFields()


class EnergyMessage(NamedTuple):
    """What one end tells the other with every message; see `EndFields`.

    Attributes:
        given: to the other since the start [J].
        received: of what the other gave [J].
        put: what came in at this port [J].
        taken: what left there [J].
        known: of the other's `taken`, what is known here [J].
        tank: what is there now [J].
        starved: whether it cannot follow for want of energy.
    """

    given: float = 0.0
    received: float = 0.0
    put: float = 0.0
    taken: float = 0.0
    known: float = 0.0
    tank: float = 0.0
    starved: bool = False


def end_row(
    *,
    stiffness: float,
    damping: float,
    cap: float = inf,
    reserve: float = 0.0,
    initial: float = 0.0,
    friction: float = 0.0,
    ages: float = 0.0,
    weight: float = 1.0,
    most: float = inf,
    latency: int = 0,
) -> Float:
    """A relaxed end, (END.length,); the parameters are those of `EndFields`.

    Args:
        stiffness: k, >= 0 [N/m].
        damping: b, >= 0 [Ns/m].
        cap: of the tank, >= 0 [J].
        reserve: debt up to which the damping stays on, >= 0 [J].
        initial: energy, >= 0 [J].
        friction: of the device itself, >= 0 [Ns/m].
        ages: sum of the largest ages of both places, >= 0 [s].
        weight: of the age rule, > 0.
        most: force, > 0 [N].
        latency: 0 or 1.
    """
    row = np.zeros(END.length)
    row[: END.energy + 1] = stiffness, damping, cap, reserve, initial, friction, ages, weight, most, latency, initial
    return row


def message_of(row: Float) -> EnergyMessage:
    """What an end tells the other now."""
    given, received, put, taken, _, known = row[END.given : END.known_taken + 1].tolist()
    return EnergyMessage(given, received, put, taken, known, float(row[END.energy]), bool(row[END.starved]))


def hear(row: Float, message: EnergyMessage) -> None:
    """Puts what the other end said last where a law finds it.

    Args:
        row: of this end.
        message: of the other one, however old.
    """
    row[END.heard_given : END.heard_starved + 1] = message


@inner
def hear_end(ends: Float, e: int, others: Float, o: int) -> None:
    """`hear` inside kernels: end e hears what the other says now.

    Args:
        ends: rows of ends.
        e: which one hears.
        others: rows of the other ends.
        o: which one speaks.
    """
    ends[e, END.heard_given] = others[o, END.given]
    ends[e, END.heard_received] = others[o, END.received]
    ends[e, END.heard_put] = others[o, END.put]
    ends[e, END.heard_taken] = others[o, END.taken]
    ends[e, END.heard_known] = others[o, END.known_taken]
    ends[e, END.heard_energy] = others[o, END.energy]
    ends[e, END.heard_starved] = others[o, END.starved]


@inner
def _book(end: Float, work: float, paid: float, charge: float) -> None:
    net = paid - work - charge
    if net > 0.0:
        end[END.put] += net
    else:
        end[END.taken] -= net
    end[END.work] += work
    end[END.paid] += paid
    end[END.lost] += charge
    end[END.energy] += net
    end[END.lowest] = min(end[END.lowest], end[END.energy])


@kernel
def book_end(ends: Float, e: int, work: float, paid: float, charge: float) -> None:
    """Books what passed through an end's port since the last time.

    Args:
        ends: rows of ends; changed in place.
        e: which one.
        work: done on what is outside [J].
        paid: what the device's own friction took for certain, >= 0 [J].
        charge: what encoder and levers may have hidden, >= 0 [J].
    """
    _book(ends[e], work, paid, charge)


@inner
def share(end: Float, free: float) -> None:
    """Takes what the other end gave; gives it what evens the tanks out, if it lacks it. What is no number is nothing.

    Args:
        end: row of this end; changed in place.
        free: what may be given at most, beside what is received now, >= 0 [J].
    """
    heard = end[END.heard_energy]
    if not (isfinite(end[END.heard_given]) and isfinite(end[END.heard_received]) and isfinite(heard)):
        return
    gift = credit(end[END.heard_given], end[END.received])
    end[END.received] += gift
    end[END.energy] += gift
    if end[END.heard_starved] != 0.0:
        theirs = heard + max(0.0, end[END.given] - end[END.heard_received])
        spare = min(0.5 * (end[END.energy] - theirs) * (1.0 - exp(-end[END.T] / _EVEN)), free + gift)
        if spare > 0.0:
            end[END.energy] -= spare
            end[END.given] += spare


@inner
def pool(end: Float) -> None:
    """Counts what came in and left at the other's port as at this one's. What is no number is not believed.

    Args:
        end: row of this end; changed in place.
    """
    if not (isfinite(end[END.heard_put]) and isfinite(end[END.heard_taken]) and isfinite(end[END.heard_known])):
        return
    put = credit(end[END.heard_put], end[END.known_put])
    taken = credit(end[END.heard_taken], end[END.known_taken])
    end[END.known_put] += put
    end[END.known_taken] += taken
    end[END.energy] += put - taken


@inner
def unheard(end: Float) -> float:
    """What has left at this end's port that the other has not heard of yet, >= 0 [J].

    Args:
        end: row of this end.
    """
    known = end[END.heard_known]
    return max(0.0, end[END.taken] - known) if isfinite(known) else end[END.taken]


@inner
def available_energy(end: Float) -> float:
    """What the spring of an end may hold; negative: a debt [J].

    With a latency half at most, so that two ticks with little energy share it instead of taking turns.

    Args:
        end: row of this end.
    """
    free = end[END.energy] - end[END.acting]
    if end[END.latency] > 0.0:
        free = min(free, 0.5 * end[END.energy])
    return free - end[END.kept]


@inner
def discard(end: Float, excess: float) -> None:
    """Loses what is beyond the cap.

    Args:
        end: row of this end; changed in place.
        excess: >= 0 [J].
    """
    end[END.energy] -= excess
    end[END.lost] += excess


@inner
def hold_gap(end: Float, fraction: float, shorten: float, brake: float, push: float) -> None:
    """Writes the results of a law: a spring along the gap, a damper, and a push along the device's velocity.

    Without a place to follow there is no spring. An end that follows only in part says that it is starved.

    Args:
        end: row of this end; changed in place.
        fraction: how far the set position follows the desired position, in [0, 1]; 0 where the gap is no number.
        shorten: of the gap, what a law wants to follow at all, in (0, 1]; 1: all.
        brake: b, >= 0 [Ns/m].
        push: force by velocity of the device, >= 0 [Ns/m].
    """
    known = end[END.known] > 0.0
    follows = fraction if known else 0.0
    size = 0.0
    for axis in range(3):
        stretch = follows * shorten * end[END.gap + axis] if follows > 0.0 else 0.0
        size += stretch * stretch
        end[END.stretch + axis] = stretch
        end[END.push + axis] = push * end[END.rate + axis]
    end[END.spring] = end[END.stiffness] if known else 0.0
    end[END.brake] = brake
    end[END.held] = 0.5 * end[END.stiffness] * size
    end[END.fraction] = follows
    end[END.starved] = 1.0 if known and follows < 1.0 else 0.0


@inner
def squared(end: Float, field: int) -> float:
    """Squared length of a triple of an end.

    Args:
        end: row of the end.
        field: its first number, as `END.gap`.
    """
    return end[field] * end[field] + end[field + 1] * end[field + 1] + end[field + 2] * end[field + 2]
