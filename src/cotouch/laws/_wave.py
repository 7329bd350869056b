"""`wave`: a wave line, whose integrals and energies travel, so that losses neither drift nor make energy.

With the impedance b, the wave s into the copy and s' out of it, `√(2b) v̂ = s + s'` and the power into the copy is
`½(s² - s'²)`. The copy takes of the arrived wave no more energy than its sender put in: E_in ≤ Ẽ_j ≤ E_out.
[Anderson & Spong 1989; Niemeyer & Slotine 1991, 2004; many copies: Rakhsha, Constantinescu & Shi 2019]
"""

from math import inf, sqrt

from cotouch.laws._end import End
from cotouch.laws._helper import copy, square
from cotouch.laws._law import FORCE, Facts, Law, Parameter, Tone, register

_IN, _OUT, _WAVE = range(3)


def _before(end: End) -> None:
    root, T = sqrt(2.0 * end.parameters[0]), end.T
    into, out, wave, energy = end.memory[_IN], end.memory[_OUT], end.memory[_WAVE], end.scalars
    if end.step == 0:  # so that copies at rest agree on places, not only on how far they went
        for i in range(into.shape[0]):
            into[i] = out[i] = 0.5 * root * end.position[i]
    span = max(end.parameters[1], T)
    for i in range(into.shape[0]):
        wave[i] = (end.received[0, i] - into[i]) / span if end.sample_index >= 0 else 0.0
    most = max(end.received_scalars[0] - energy[0], 0.0)
    power = 0.5 * square(end.weight, wave)
    # Over the filter's time, as waves are: what comes in bursts would else be taken in bursts, which carry less.
    fraction = sqrt(most / (power * span)) if power * span > most else 1.0
    push = root * sqrt(2.0 * power)
    if fraction * push > end.parameters[3]:
        fraction = end.parameters[3] / push
    for i in range(into.shape[0]):
        wave[i] *= fraction
        into[i] += wave[i] * T
        end.push[i] = root * wave[i]
    energy[0] += fraction * fraction * power * T
    end.gains[1] = end.parameters[0]


def _after(end: End) -> None:
    root, wave, out, energy = sqrt(2.0 * end.parameters[0]), end.memory[_WAVE], end.memory[_OUT], end.scalars
    power = 0.0
    for i in range(wave.shape[0]):
        back = root * end.mean[i] - wave[i]
        out[i] += back * end.T
        power += 0.5 * end.weight[i] * back * back
    energy[1] += power * end.T
    copy(end.sent[0], out)
    end.sent_scalars[0] = energy[1] + end.parameters[2]


def _linear(tone: Tone) -> tuple[complex, complex]:
    b, around = tone.parameters[0], tone.there * tone.back
    return b * (1.0 + around) / (1.0 - around), 2.0 * b * tone.there / (1.0 - around)


def _filter(facts: Facts) -> float:
    return min(facts.spread, 0.03)


def _impedance(facts: Facts) -> float:
    return facts.spring * facts.lag(_filter(facts))


WAVE = register(
    Law(
        name="wave",
        before=_before,
        after=_after,
        source="Niemeyer & Slotine 2004; Rakhsha, Constantinescu & Shi 2019",
        parameters=(
            Parameter(
                name="impedance",
                meaning="b; divided by delay and filter, it is the line's stiffness [Ns/m]",
                default=_impedance,
            ),
            Parameter(name="filter", meaning="time constant of the filter of arriving waves [s]", default=_filter),
            Parameter(name="initial_energy", meaning="energy that an end's line starts with [J]", default=0.0),
            Parameter(name=FORCE, meaning="largest force with which a neighbour may push [N]", default=inf),
        ),
        sends=("U_out",),
        sends_scalars=("E_out",),
        keeps=("U_in", "U_out", "s"),
        keeps_scalars=("E_in", "E_out"),
        initial_energy="initial_energy",
        sums=("U_out",),
        energies=("E_out",),
        linear=_linear,
        drag=0.5,
        dragless=True,
    )
)
