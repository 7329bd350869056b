"""`pspm`: passive set-position modulation [Lee & Huang 2010]; the spring is as far stretched as a tank pays for.

Passive whatever stiffness, rates and mailboxes; see `_end.py` for the tanks and `_modulation.py` for the law.
The proxy's end never owes: an implicit step takes at most what its spring holds.
"""

from math import isfinite

from cotouch.arrays import Float
from cotouch.coupling._end import END, available_energy, discard, hold_gap, share, squared
from cotouch.coupling._law import DeviceCoupling, HeldForce, register_coupling
from cotouch.coupling._modulation import modulate, modulation_bound


def _device(end: Float) -> None:
    share(end, max(0.0, end[END.energy] - end[END.acting] - end[END.kept]))
    potential = 0.5 * end[END.stiffness] * squared(end, END.gap) if end[END.known] > 0.0 else 0.0
    fraction, _, excess = modulate(potential, available_energy(end), end[END.cap])
    discard(end, excess)
    hold_gap(end, fraction, 1.0, end[END.damping], 0.0)


def _proxy(end: Float) -> None:
    share(end, max(0.0, end[END.energy]))
    damping, there = end[END.damping], max(0.0, available_energy(end))
    rate, gap = squared(end, END.rate), squared(end, END.gap)
    if end[END.known] == 0.0 or not (isfinite(gap) and isfinite(rate)):
        discard(end, max(0.0, there - end[END.cap]))
        hold_gap(end, 0.0, 1.0, damping, 0.0)
        return
    # The damper's pull towards a velocity gives at most ¼ b ‖v‖² T in a step; it is set aside first.
    cost = 0.25 * damping * end[END.T] * rate
    part = 1.0 if cost <= there else (there / cost) ** 0.5
    left = max(0.0, there - part * part * cost)
    fraction, _, excess = modulate(0.5 * end[END.stiffness] * gap, left, end[END.cap])
    discard(end, excess)
    hold_gap(end, fraction, 1.0, damping, part * damping)


def _bound(held: HeldForce) -> float:
    return modulation_bound(
        stiffness=held.stiffness,
        damping=held.damping,
        period=held.period,
        speed=held.speed,
        reserve=held.reserve,
        force=held.force,
        resolution=held.resolution,
        axes=3,
    )


PSPM_COUPLING = register_coupling(
    DeviceCoupling(
        name="pspm",
        device=_device,
        proxy=_proxy,
        source="Lee & Huang 2010, passive set-position modulation",
        bound=_bound,
        rests=True,
    )
)
