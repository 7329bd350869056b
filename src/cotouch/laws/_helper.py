"""What laws are written with."""

from collections.abc import Callable
from math import sqrt
from typing import Any, TypeVar

import numba

from cotouch.arrays import Float
from cotouch.kernels import at, inner, kernel, put
from cotouch.laws._end import End
from cotouch.mechanics import Ports

F = TypeVar("F", bound=Callable[..., object])


def helper(function: F) -> F:
    """Compiled with the law and not kept alone, because only a law's own machine code is bound to its file.

    Args:
        function: in the file of the law that calls it.
    """
    njit: Any = numba.njit
    return njit(nogil=True, fastmath={"contract"}, error_model="numpy", _nrt=False, forceinline=True)(function)


@inner
def square(weight: Float, field: Float) -> float:
    """`‖field‖²_W`.

    Args:
        weight: of each entry.
        field: the values.
    """
    result = 0.0
    for i in range(field.shape[0]):
        result += at(weight, i) * at(field, i) * at(field, i)
    return result


@inner
def copy(target: Float, source: Float) -> None:
    """`target = source`.

    Args:
        target: written.
        source: read.
    """
    for i in range(target.shape[0]):
        put(target, i, at(source, i))


@inner
def move_set(end: End, hold: Float, spare: float, force: float) -> tuple[float, float]:
    """Set-position modulation: `hold` goes as near to the sample as energy and force allow.

    Args:
        end: that has heard a sample.
        hold: where its spring is held; moved.
        spare: energy for that beyond what the spring holds [J].
        force: largest of the spring; what it would hold beyond is not spent [N].

    Returns:
        What the spring held and what it holds [J].
    """
    x, half = end.position, 0.5 * end.spring
    held = desired = 0.0
    for i in range(x.shape[0]):
        held += half * at(end.weight, i) * (at(x, i) - at(hold, i)) ** 2
        desired += half * at(end.weight, i) * (at(x, i) - at(end.sample, i)) ** 2
    fraction = sqrt((held + spare) / desired) if desired > held + spare else 1.0
    pull = sqrt(2.0 * end.spring * desired)
    if fraction * pull > force:
        fraction = force / pull
    for i in range(x.shape[0]):
        put(hold, i, at(x, i) + fraction * (at(end.sample, i) - at(x, i)))
    return held, fraction * fraction * desired


@inner
def given_power(end: End) -> float:
    """Power of the link's push and damper on the copy, `⟨c, v̂⟩_W - b‖v̂‖²_W`; after the step [W]."""
    result, b = 0.0, end.gains[1]
    for i in range(end.mean.shape[0]):
        v = at(end.mean, i)
        result += at(end.weight, i) * v * (at(end.push, i) - b * v)
    return result


@inner
def brake(end: End, energy: float, least: float, most: float) -> None:
    """Writes a damper b beside the push c, so that both can do no more than an energy in the coming step.

    For every v̂ is `T (⟨c, v̂⟩ - b‖v̂‖²) ≤ T‖c‖²/(4b)`. Where that would take more than the greatest damper, c is
    reduced.

    Args:
        end: its `push` is there.
        energy: >= 0 [J].
        least: b at least [Ns/m].
        most: b at most, >= least [Ns/m].
    """
    price = 0.25 * end.T * square(end.weight, end.push)
    b = least
    if price > b * energy:
        if price > most * energy:
            fraction = sqrt(most * energy / price)
            b = most
            for i in range(end.push.shape[0]):
                put(end.push, i, fraction * at(end.push, i))
        else:
            b = price / energy
    end.gains[1] = b


@kernel
def feel(hand: Float, ports: Ports, weight: Float) -> None:
    """The force of the hands on every row and axis, from those of the ports that they have.

    Args:
        hand: result, flat, (size,) [N].
        ports: after the step.
        weight: of a link, flat; what it is 0 of, a tool, links do not know, nor who holds that.
    """
    dense, width = ports.shape.shape[0] > 0, ports.force.shape[1]
    for place in range(hand.shape[0]):
        put(hand, place, 0.0)
    for p in range(ports.row.shape[0]):
        for axis in range(width):
            force = at(ports.force, (p, axis))
            if dense:
                for row in range(ports.shape.shape[1]):
                    place = row * width + axis
                    put(hand, place, at(hand, place) + at(ports.shape, (p, row)) * force)
            else:
                place = at(ports.row, p) * width + axis
                put(hand, place, at(hand, place) + force)
    for place in range(hand.shape[0]):
        if at(weight, place) == 0.0:
            put(hand, place, 0.0)
