"""What every coupling must do, tried on ends at random; those of other packages are tried before they hold anything."""

from collections.abc import Iterator
from math import isfinite

import numpy as np

from cotouch.arrays import Float
from cotouch.coupling._end import END, EnergyMessage, end_row, hear
from cotouch.coupling._law import DeviceCoupling, HeldForce

_TRIES = 100
_HELD = HeldForce(stiffness=500.0, damping=2.0, period=1e-3, speed=0.5, reserve=1e-3, force=3.0, resolution=1e-5)


def conform_coupling(law: DeviceCoupling) -> list[str]:
    """What a coupling breaks of the interface, in a sentence each.

    What both ends together give out over time is no part of this: runs compare it with `bound`.

    Args:
        law: the coupling.

    Raises:
        DeviceError: one of its functions cannot be compiled, leaves its row, or raises.
    """
    found: list[str] = []
    for proxy in (False, True):
        half, end = law.half(proxy=proxy), "proxy" if proxy else "device"
        for row in _rows(latency=not proxy):
            before = _owned(row)
            half(row)
            found += [f"{said} ({end})" for said in _findings(row, before)]
    try:
        bound = float(law.bound(_HELD))
    except Exception as error:  # noqa: BLE001 - what somebody wrote may be wrong in any way
        found.append(f"bound cannot be worked out: {error} ({type(error).__name__})")
    else:
        if not (isfinite(bound) and bound >= 0.0):
            found.append(f"bound is {bound:g} J; it must be a finite number of at least 0")
    return list(dict.fromkeys(found))


def _rows(*, latency: bool) -> Iterator[Float]:
    """Ends that are rich and in debt, near and far, that hear of gifts and of work, some without a place to follow."""
    rng = np.random.default_rng(0)
    for index in range(_TRIES):
        row = end_row(
            stiffness=float(10.0 ** rng.uniform(1.0, 4.0)),
            damping=float(rng.uniform(0.0, 5.0)),
            cap=0.1,
            reserve=1e-3,
            initial=5e-3,
            ages=float(rng.uniform(0.0, 0.02)),
            most=float(10.0 ** rng.uniform(0.0, 1.5)),
            latency=int(latency and index % 2),
        )
        row[END.energy] = rng.normal(0.0, 0.02)
        row[END.acting] = rng.uniform(0.0, 1e-3) if latency else 0.0
        row[END.T], row[END.known] = 1e-3, float(index % 10 != 0)
        row[END.gap : END.rate], row[END.rate : END.acting] = rng.normal(0.0, 0.02, 3), rng.normal(0.0, 0.3, 3)
        given, taken = rng.uniform(0.0, 1e-3, 2).tolist()
        hear(row, EnergyMessage(given=given, taken=taken, tank=rng.normal(0.0, 0.02), starved=index % 3 == 0))
        yield row


def _owned(row: Float) -> float:
    """What a law cannot change: the tank with what went elsewhere, less what came from there [J]."""
    spent = row[END.given] + row[END.lost] + row[END.known_taken]
    return float(row[END.energy] + spent - row[END.received] - row[END.known_put])


def _findings(row: Float, before: float) -> Iterator[str]:
    spring, brake, fraction, held = (float(row[at]) for at in (END.spring, END.brake, END.fraction, END.held))
    if not np.isfinite(row[END.energy :]).all():
        yield "what it writes is no number"
        return
    if min(spring, brake) < 0.0:
        yield "its spring or its damper is below 0"
    if not 0.0 <= fraction <= 1.0:
        yield "its fraction is not from 0 to 1"
    stored = 0.5 * spring * float((row[END.stretch : END.push] ** 2).sum())
    if abs(held - stored) > 1e-9 * stored + 1e-15:
        yield "held is not the energy of its spring, ½ k ‖stretch‖²"
    elif held > max(0.0, float(row[END.energy])) * (1.0 + 1e-9):
        yield "its spring holds more energy than its end has"
    if row[END.known] == 0.0 and stored > 0.0:
        yield "it has a spring where no place is known"
    if (row[END.starved] != 0.0) != (row[END.known] > 0.0 and fraction < 1.0):
        yield "starved does not say whether it follows only in part"
    if abs(_owned(row) - before) > 1e-12:
        yield "it changes the energy of its end otherwise than by share, pool and discard"
