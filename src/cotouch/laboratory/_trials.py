"""What might make a law give out more energy than it declares: runs at random, and users who are searched for."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import NamedTuple, final

import numpy as np

from cotouch.arrays import Float
from cotouch.interrupt import check
from cotouch.laboratory._tasks import Task
from cotouch.scenario import Scenario
from cotouch.simulation import TICK_RESIDUAL, Outcome, Prepared, prepare, run_prepared

# How long a trial is [s], and what of a run's energies is round-off.
_LONG, _ROUND = 1.5, 1e-12
# A search fills the space evenly for this share of its evaluations, then goes on near the best; widths of its steps.
_FIRST, _STEP, _LONGER, _SHORTER, _LEAST = 0.2, 0.2, 1.5, 0.93, 0.02


@final
class Wild(NamedTuple):
    """Delay of each pair one way, (users, users) [s]; tables of steps, channel and hands."""

    delay: Float
    steps: dict[str, object]
    channel: dict[str, object]
    hands: Task


def wild(rng: np.random.Generator, users: int, duration: float) -> Wild:
    """Any delays, steps and channel, and hands, soft and stiff.

    Args:
        rng: randomness.
        users: how many.
        duration: of the run [s].
    """
    return Wild(
        delay=rng.uniform(0.0, 0.15, (users, users)) * (1.0 - np.eye(users)),
        steps={"duration": duration, "random": {"low": 0.001, "high": float(rng.choice([0.001, 0.005, 0.03]))}},
        channel={
            "jitter": {"kind": "exponential", "scale": float(rng.choice([0.0, 0.01, 0.05]))},
            "loss": float(rng.choice([0.0, 0.1, 0.7])),
            "burst": {"enter": float(rng.choice([0.0, 0.01])), "leave": 0.05},
            "duplication": 0.2,
            "reordering": 0.2,
            "reordering_delay": 0.04,
        },
        hands=[
            {
                "user": i + 1,
                "stiffness": float(10.0 ** rng.uniform(1.0, 3.5)),
                "damping": float(rng.choice([0.0, 6.5])),
                "path": float(rng.uniform(-0.1, 0.1)),
                "amplitude": float(rng.choice([0.0, 0.05])),
                "frequency": float(10.0 ** rng.uniform(-0.5, 1.0)),
                "begin": float(duration * rng.uniform(0.0, 0.3)),
                "release": float(duration * rng.uniform(0.5, 1.0)),
            }
            for i in range(users)
        ],
    )


def trial(number: int, law: str | Mapping[str, object] = "spring") -> Scenario:
    """Anything: users, springs, delays, rates, losses, hands, soft and stiff, an object that flies.

    Args:
        number: of the trial; another one is another run.
        law: as in `[synchronisation]`.
    """
    rng = np.random.default_rng((number, 18))
    users = int(rng.integers(2, 5))
    anything = wild(rng, users, _LONG)
    spring = np.zeros((users, users))
    for a in range(users):
        for b in range(a):
            spring[a, b] = spring[b, a] = rng.choice([0.0, 20.0, 100.0]) if b else 50.0
    return Scenario.make(
        network={
            "users": [str(i) for i in range(users)],
            "spring": spring.tolist(),
            "delay": anything.delay.tolist(),
        },
        body={"mass": float(10 ** rng.uniform(-1, 1)), "stiffness": float(rng.choice([0.0, 30.0]))},
        synchronisation={"law": law},
        initial={"position": rng.uniform(-0.05, 0.05, users).tolist(), "velocity": rng.normal(size=users).tolist()},
        seed=number,
        steps=anything.steps,
        channel=anything.channel,
        hands=anything.hands,
    )


def touching(number: int, law: str | Mapping[str, object] = "paid") -> Scenario:
    """Anything that tools do to a block: by hands alone or over devices, pressing, sliding, knocking, letting go.

    Two or three users, a block that stands or turns, on a floor or without weight, networks as in `trial` with up to
    half of what is sent lost.

    Args:
        number: of the trial; another one is another run.
        law: as in `[synchronisation]`.
    """
    rng = np.random.default_rng((number, 388))
    users = int(rng.integers(2, 4))
    wide = wild(rng, users, 0.8)
    wide.channel["loss"] = float(rng.uniform(0.0, 0.5))
    # As a rule near enough that tools work together; now and then not.
    near = float(rng.choice([0.05, 0.2, 1.0]))
    shape, spacing = rng.integers(2, 5, 3), float(rng.uniform(0.01, 0.03))
    size, radius = (shape - 1) * spacing, float(rng.uniform(0.4, 1.0)) * spacing
    tools: list[dict[str, object]] = []
    for k in range(int(rng.integers(1, users + 2))):
        axis, side = int(rng.integers(0, 3)), float(rng.choice([-1.0, 1.0]))
        at = rng.uniform(0.2, 0.8, 3) * size
        at[axis] = (size[axis] if side > 0 else 0.0) + side * (radius + 0.003)
        press = np.zeros(3)
        press[axis] = -side * rng.uniform(0.3, 1.0) * spacing
        slide = press + rng.uniform(-0.5, 0.5, 3) * spacing
        away = side * 0.02 * np.eye(3)[axis]
        path = [(0.0, np.zeros(3)), (0.2, press), (0.35, press), (0.6, slide), (0.75, away)]
        device = {"preset": str(rng.choice(["omega", "delta"])), "stiffness": float(10 ** rng.uniform(2.0, 3.2))}
        tools.append(
            {
                "user": int(rng.integers(1, users + 1)) if k >= 2 else k + 1,
                "at": at.tolist(),
                "radius": radius,
                "mass": float(10 ** rng.uniform(-2.0, -0.5)),
                "stiffness": float(10 ** rng.uniform(2.0, 4.0)),
                "damping": float(rng.choice([0.0, 1.0])),
                "friction": float(rng.choice([0.0, 0.3, 1.0])),
                "hand": {"grip": float(rng.uniform(0.5, 4.0)), "path": [[t, *p.tolist()] for t, p in path]},
                **({"device": device} if rng.random() < 0.5 else {}),
            }
        )
    floor = {"gravity": [0.0, 0.0, -9.81], "planes": [{"stiffness": 1e5, "damping": 1.0, "friction": 0.5}]}
    return Scenario.make(
        network={
            "users": [str(i) for i in range(users)],
            "spring": (20.0 * (1.0 - np.eye(users))).tolist(),
            "delay": (near * wide.delay).tolist(),
        },
        body={
            "kind": "lattice",
            "shape": shape.tolist(),
            "spacing": spacing,
            "mass": float(10 ** rng.uniform(-1.5, 0.0)),
            "stiffness": float(10 ** rng.uniform(2.0, 3.5)),
            "damping": float(10 ** rng.uniform(-1.0, 0.5)),
            "frame": str(rng.choice(["fixed", "floating"])),
        },
        world=floor if rng.random() < 0.5 else {},
        steps=wide.steps,
        channel=wide.channel,
        synchronisation={"law": law},
        tools=tools,
        seed=number,
    )


@final
@dataclass(frozen=True, kw_only=True)
class MadeEnergy:
    """What a run's links made.

    Attributes:
        beyond: most energy that they had made, less what the law declares [J]; infinite where the motion left floating
            point.
        last: what they had made at the end, likewise [J].
        play: greatest of the energies that the run's books hold [J].
        residual: what the books do not account for, at most [J].
    """

    beyond: float
    last: float
    play: float
    residual: float

    @property
    def kept(self) -> bool:
        """Whether they made no more than the law declares, but for round-off."""
        return self.beyond <= _ROUND * self.play


def made_energy(prepared: Prepared) -> MadeEnergy:
    """Runs it.

    Args:
        prepared: of any law.
    """
    return energy_of(prepared, run_prepared(prepared))


def energy_of(prepared: Prepared, outcome: Outcome) -> MadeEnergy:
    """What links made in a run.

    Args:
        prepared: what was run.
        outcome: what came of it.
    """
    record = outcome.record
    seed = float(record.links[0].sum()) if prepared.law is None else prepared.law.initial_energy
    play = float(np.nanmax(np.abs(record.ticks[:TICK_RESIDUAL]), initial=0.0))
    finite = outcome.events == prepared.schedule.order.size and np.isfinite(record.made).all()
    return MadeEnergy(
        beyond=float(record.made[0]) - seed if finite else float("inf"),
        last=float(record.made[1]) - seed,
        play=play,
        residual=float(np.nanmax(np.abs(record.ticks[TICK_RESIDUAL]), initial=0.0)),
    )


_HAND, _PATH = 6, 6
# Numbers between 0 and 1 that make a scenario of two: a hand each, and the network.
NUMBERS = 2 * _HAND + _PATH


def users_at(place: Float, law: str | Mapping[str, object], **options: object) -> Scenario:
    """Two users, their impedances, what they do, and the network between them.

    Args:
        place: of the search, (NUMBERS,), 0 to 1.
        law: as in `[synchronisation]`.
        **options: others of that table.
    """
    hands = [
        {
            "user": user + 1,
            "stiffness": float(10 ** (1.0 + 2.5 * a)),
            "damping": float(10.0 * b * b),
            "amplitude": float(0.1 * c),
            "frequency": float(10 ** (-0.5 + 1.5 * d)),
            "phase": float(2.0 * np.pi * e),
            "release": float(0.5 + 1.5 * f),
        }
        for user, (a, b, c, d, e, f) in enumerate(place[: 2 * _HAND].reshape(2, _HAND))
    ]
    there, back, jitter, loss, rate, mass = place[2 * _HAND :].tolist()
    return Scenario.make(
        network={
            "users": ["one", "two"],
            "spring": [[0.0, 50.0], [50.0, 0.0]],
            "delay": [[0.0, 0.2 * there], [0.2 * back, 0.0]],
        },
        body={"mass": float(10 ** (mass - 0.5))},
        steps={"duration": 1.5, "period": [0.002, 0.002 * (1.0 + 4.0 * rate)]},
        synchronisation={"law": law, **options},
        channel={"jitter": {"kind": "exponential", "scale": 0.05 * jitter}, "loss": 0.6 * loss},
        hands=hands,
    )


@final
@dataclass(frozen=True, kw_only=True)
class Found:
    """The worst that a search found.

    Attributes:
        beyond: energy made beyond what the law declares [J].
        kept: whether no run made more than that, but for round-off.
        place: of the search, for `users_at`.
    """

    beyond: float
    kept: bool
    place: Float


def searched(law: str | Mapping[str, object], evaluations: int, *, seed: int = 18, **options: object) -> Found:
    """Searches for two users, and a network, that get energy out of a law.

    Evenly at first, then near the best so far, and elsewhere once nothing better is found there. As long as nothing is
    made, the best is what makes the most for its energy, and dissipates the least.

    Args:
        law: as in `[synchronisation]`.
        evaluations: runs.
        seed: of the search.
        **options: others of that table.
    """
    rng = np.random.default_rng(seed)
    here, best, step = rng.random(NUMBERS), -np.inf, _STEP
    most, kept, worst = -np.inf, True, here
    for number in range(evaluations):
        check()
        even = number < _FIRST * evaluations or best == -np.inf
        there = rng.random(NUMBERS) if even else np.clip(here + step * rng.standard_normal(NUMBERS), 0.0, 1.0)
        found = made_energy(prepare(users_at(there, law, **options)))
        kept = kept and found.kept
        if found.beyond > most:
            most, worst = found.beyond, there
        value = found.beyond if not found.kept else (found.beyond + 0.01 * found.last) / max(found.play, 1e-9)
        better = value > best
        if better:
            here, best = there, value
        if not even:
            step = min(_STEP, step * (_LONGER if better else _SHORTER))
            if step < _LEAST:  # as good as it gets near here
                best, step = -np.inf, _STEP
    return Found(beyond=float(most), kept=kept, place=worst)
