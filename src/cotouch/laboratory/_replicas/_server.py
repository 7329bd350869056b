"""`server`: the whole body at one user's place, a light proxy at every user's, any link law on the spokes between.

The place is the user's whose longest way there and back is the shortest. [Buttolo et al. 1997]
"""

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np

from cotouch.arrays import Float, Int, Long
from cotouch.compiled import routine, subroutine
from cotouch.laboratory._replicas._replica import AxisRun, ReplicaKind, advance, body_energy
from cotouch.laws import END_WORDS, CompiledHalf, End, Facts, Law, hand, handed

_LIGHT = 0.05  # [kg]


class Spokes(NamedTuple):
    """The ends of all spokes: 2j at the server, 2j + 1 at proxy j. Copy 0 is the server's, copy 1 + j proxy j.

    Attributes:
        before: of the law.
        after: of the law.
        parameters: of each end, (2N, parameters).
        spring: of each spoke, (N,) [N/m].
        brake: B_i of each copy, (N + 1,) [Ns/m].
        used: newest step of the other end that each end knows in each step, (2N, S); -1: none.
        place: x̂ of each copy in each step, after its first place, (N + 1, S + 1) [m].
        rate: v̂ likewise, without a first one, (N + 1, S) [m/s].
        mail: messages to each end, by the sender's step; the last is empty, (2N, S + 1, fields, 1).
        mail_scalars: (2N, S + 1, scalars).
        memory: (2N, fields, 1).
        scalars: (2N, scalars).
        shared: (N + 1, fields, 1).
        shared_scalars: (N + 1, scalars).
        ends: y, c and gains of each end, (2N, 4).
        felt: force of each copy's hand in the step before, (N + 1, 1) [N].
        state: x, v and v̂ of each copy, (N + 1, 3, 1).
        words: as the law reads an end, (2N, words).
    """

    before: CompiledHalf
    after: CompiledHalf
    parameters: Float
    spring: Float
    brake: Float
    used: Int
    place: Float
    rate: Float
    mail: Float
    mail_scalars: Float
    memory: Float
    scalars: Float
    shared: Float
    shared_scalars: Float
    ends: Float
    felt: Float
    state: Float
    words: Long


@subroutine
def _take(
    run: AxisRun,
    spokes: Spokes,
    copy: int,
    k: int,
    stiffness: float,
    damping: float,
    push: float,
    mass: float,
    own: float,
) -> float:
    """Step k of a copy, whose hand is a spring, a damper and a push; its mean velocity."""
    count = spokes.spring.shape[0]
    first, last = (0, count) if copy == 0 else (copy - 1, copy)
    state, weight, untouched = spokes.state[copy], np.ones(1), np.zeros(1)
    held, braked, driven = stiffness, damping + spokes.brake[copy], push
    for j in range(first, last):
        e, other = (2 * j, 1 + j) if copy == 0 else (2 * j + 1, 0)
        index, before = spokes.used[e, k], spokes.used[e, k - 1] if k > 0 else -1
        letter = index if index >= 0 else spokes.mail.shape[1] - 1
        out = spokes.ends[e]
        out[:] = 0.0
        end = End(
            run.T,
            run.T * (k + 0.5 - index) if index >= 0 else run.T * (k + 1.0),
            index,
            index > before,
            k,
            0 if copy == 0 else 1,
            j == first,
            j + 1 == last,
            count + 1,
            1,
            spokes.spring[j],
            spokes.parameters[e],
            weight,
            state[0],
            state[1],
            state[2],
            spokes.place[other, index + 1 : index + 2],
            spokes.felt[copy],
            untouched,
            spokes.mail[e, letter],
            spokes.mail_scalars[e, letter],
            spokes.memory[e],
            spokes.scalars[e],
            spokes.shared[copy],
            spokes.shared_scalars[copy],
            out[0:1],
            out[1:2],
            out[2:4],
            spokes.mail[e ^ 1, k],
            spokes.mail_scalars[e ^ 1, k],
        )
        hand(end, spokes.words[e])
        spokes.before(handed(spokes.words[e]))
        held, braked, driven = held + out[2], braked + out[3], driven + out[2] * out[0] + out[1]
    x, v = state[0, 0], state[1, 0]
    rate = advance(run, x, v, held, braked, driven, mass, own)
    spokes.place[copy, k + 1], spokes.rate[copy, k] = x + 0.5 * run.T * rate, rate
    state[0, 0], state[1, 0], state[2, 0] = x + run.T * rate, 2.0 * rate - v, rate
    for j in range(first, last):
        spokes.after(handed(spokes.words[2 * j if copy == 0 else 2 * j + 1]))
    spokes.felt[copy, 0] = push - stiffness * spokes.place[copy, k + 1] - damping * rate
    return rate


@routine
def _move(run: AxisRun, spokes: Spokes) -> None:
    count, steps = run.mean.shape
    state = spokes.state
    run.energy[0] = body_energy(run, state[0, 0, 0], state[0, 1, 0])
    run.energy[0] += 0.5 * count * _LIGHT * state[0, 1, 0] ** 2
    for k in range(steps):
        rate = _take(run, spokes, 0, k, 0.0, 0.0, 0.0, run.mass, 1.0)
        run.energy[k + 1] = body_energy(run, state[0, 0, 0], state[0, 1, 0])
        run.lost[k] = run.T * run.damping * rate * rate
        for j in range(count):
            rate = _take(
                run, spokes, 1 + j, k, run.hand_stiffness[j, k], run.hand_damping[j, k], run.aim[j, k], _LIGHT, 0.0
            )
            run.mean[j, k], run.rate[j, k] = spokes.place[1 + j, k + 1], rate
            run.place[j, k + 1], run.speed[j, k + 1] = state[1 + j, 0, 0], state[1 + j, 1, 0]
            run.energy[k + 1] += 0.5 * _LIGHT * run.speed[j, k + 1] ** 2


def _serve(run: AxisRun, law: Law, given: Mapping[str, float | str]) -> float:
    """Runs it; what the ends of all spokes may make [J]."""
    count, steps = run.mean.shape
    longest = (run.delay + run.delay.T).max(axis=1)
    place = int(np.argmin(longest))
    everyone = np.arange(int(count))
    other = np.where(everyone == place, (place + 1) % count, everyone)
    spring = run.spring[place, other]
    used = np.empty((2 * count, steps), dtype=np.int32)
    used[0::2], used[1::2] = run.used[place], run.used[:, place]
    # Who is at the server's place hears of it a step later, which is 1.5 steps old at the end of the next.
    used[[2 * place, 2 * place + 1]] = np.arange(-1, steps - 1)
    ages = np.empty(2 * count)
    ages[0::2], ages[1::2] = run.delay[place], run.delay[:, place]
    ages[[2 * place, 2 * place + 1]] = 1.5 * run.T
    parameters: list[list[float]] = []
    for end in range(2 * count):
        age = run.T * (np.arange(int(steps)) + 0.5 - used[end])[used[end] >= 0]
        facts = Facts(
            spring=float(spring[end // 2]),
            age=float(ages[end]),
            age_back=float(ages[end ^ 1]),
            spread=float(np.ptp(age)) if age.size else 0.0,
            period=run.T,
            mass=run.mass,
            degree=1 if end % 2 else count,
            degree_back=count if end % 2 else 1,
            tree=True,
        )
        parameters.append(law.values(facts, given))
    half = 0.5 * law.rule * spring * (ages[0::2] + ages[1::2])
    start = np.concatenate([run.place[:1, 0], run.place[:, 0]])
    speed = np.concatenate([run.speed[:1, 0], run.speed[:, 0]])
    before, after = law.parts
    places = np.zeros((count + 1, steps + 1))
    places[:, 0] = start
    _move(
        run,
        Spokes(
            before=before,
            after=after,
            parameters=np.array(parameters, dtype=np.float64).reshape(2 * count, len(law.parameters)),
            spring=spring,
            brake=law.drag + np.concatenate([[half.sum()], half]),
            used=used,
            place=places,
            rate=np.zeros((count + 1, steps)),
            mail=np.zeros((2 * count, steps + 1, len(law.sends), 1)),
            mail_scalars=np.zeros((2 * count, steps + 1, len(law.sends_scalars))),
            memory=np.zeros((2 * count, len(law.keeps), 1)),
            scalars=np.zeros((2 * count, len(law.keeps_scalars))),
            shared=np.zeros((count + 1, len(law.shares), 1)),
            shared_scalars=np.zeros((count + 1, len(law.shares_scalars))),
            ends=np.zeros((2 * count, 4)),
            felt=np.zeros((count + 1, 1)),
            state=np.ascontiguousarray(np.stack([start, speed, 0.0 * speed], axis=1)[:, :, None]),
            words=np.zeros((2 * count, END_WORDS), dtype=np.int64),
        ),
    )
    return sum(law.initial_energy_of(values) for values in parameters)


server = ReplicaKind(name="server", move=_move, join=_serve, sends=("x̂",), source="Buttolo et al. 1997")
