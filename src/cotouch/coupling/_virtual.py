"""`virtual`: a plain spring and dampers, passive where the device's friction pays, and an account that watches them.

The device holds `-k (q - y) - b v`, the proxy is pulled by `k (q - ŷ) - (b + drag) ŵ`: one spring, whose ends each know
the other's place as it was, and a damper at each end. Its slope never exceeds k, and its force never what the motors
may hold: the gap saturates, so that the spring is the slope of a convex energy.

What a sampled spring makes has to be paid by friction that is really there (`virtual_coupling_limit`). The device pays
from its own; how old places are, both share, the proxy with `drag = ½ k ages / weight`, which is felt.

Where it is not so (ages beyond those declared, ticks that are late, less friction than was said), a period may make
energy. How much is known, because both ends book their ports' exact work: they count on one pool (`_end.py`),
and each shortens its spring where the pool holds less than the spring's energy. So, whatever the rates, the clocks and
the mailboxes do, both ports together give no more than friction paid, both initial energies, and what the last ticks of
a held force can make.
"""

from math import inf

from cotouch.arrays import Float
from cotouch.coupling._end import END, available_energy, hold_gap, pool, squared, unheard
from cotouch.coupling._law import DeviceCoupling, register_coupling
from cotouch.coupling._modulation import modulate
from cotouch.kernels import inner


@inner
def _spring(end: Float, there: float, brake: float) -> None:
    """The saturated spring, as far as there is energy for it; and a damper."""
    stiffness = end[END.stiffness]
    size = squared(end, END.gap) ** 0.5 if end[END.known] > 0.0 else 0.0
    shorten = end[END.most] / (stiffness * size) if stiffness * size > end[END.most] else 1.0
    fraction, _, _ = modulate(0.5 * stiffness * (shorten * size) ** 2, there, inf)
    hold_gap(end, fraction, shorten, brake, 0.0)


def _device(end: Float) -> None:
    pool(end)
    _spring(end, end[END.energy] - end[END.kept], end[END.damping])


def _proxy(end: Float) -> None:
    pool(end)
    there = max(0.0, min(available_energy(end), end[END.initial] - unheard(end)))
    drag = 0.5 * end[END.stiffness] * end[END.ages] / end[END.weight]
    _spring(end, there, end[END.damping] + drag)


VIRTUAL_COUPLING = register_coupling(
    DeviceCoupling(
        name="virtual",
        device=_device,
        proxy=_proxy,
        source="after Colgate & Schenkel 1997",
        pools=True,
        parameters=("friction", "coulomb", "ages", "weight"),
    )
)
