"""Users who move their copies as they like, and look for a way to get energy out of guarded links.

Without mass and body (which only add what is passive already) whoever moves a copy by v̂ supplies
`T v̂ (B v̂ + Σ_j K (x̂_i - ȳ_ij))`. Users start at rest, so the sum over all may never be below minus the seeds.
"""

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

from cotouch.peer import NO_HEADER, FreshestLink, LinkGuard, Sample

K = 50.0


@dataclass
class Way:
    """One direction of a link: when what is sent at a time arrives; NaN: never. Outages are spans of sending times."""

    delay: float
    jitter: float = 0.0
    loss: float = 0.0
    outages: list[tuple[float, float]] = field(default_factory=list)

    def arrival(self, now: float, rng: np.random.Generator) -> float:
        latency = self.delay + rng.exponential(self.jitter) if self.jitter else self.delay
        lost = rng.random() < self.loss or any(first <= now < last for first, last in self.outages)
        return np.nan if lost else now + latency


@dataclass
class Plan:
    """All that does not depend on the motion.

    Attributes:
        ends: of every user's steps.
        links: pairs of users.
        ways: of each ordered pair.
        budget: A_ij of each ordered pair, true ages.
        offset: of each user's clock.
        arrival: of each ordered pair and step.
    """

    ends: list[np.ndarray]
    links: list[tuple[int, int]]
    ways: dict[tuple[int, int], Way]
    budget: dict[tuple[int, int], float]
    offset: list[float]
    options: dict[str, float] = field(default_factory=dict)
    seed: int = 0
    arrival: dict[tuple[int, int], np.ndarray] = field(init=False)
    order: list[tuple[float, int, int]] = field(init=False)

    def __post_init__(self) -> None:
        rng = np.random.default_rng(self.seed)
        self.arrival = {  # from i to j
            (i, j): np.array([way.arrival(t, rng) for t in self.ends[i]]) for (i, j), way in self.ways.items()
        }
        self.order = sorted((float(t), i, k) for i, ends in enumerate(self.ends) for k, t in enumerate(ends))

    def total(self, i: int, j: int) -> float:
        return self.budget[i, j] + self.budget[j, i]

    def damping(self, i: int) -> float:
        return sum(0.5 * K * self.total(*pair) for pair in self.links if i in pair)


@dataclass
class Outcome:
    supplied: float  # the least that it ever came to
    scale: float
    coupled: int
    guarded: int
    force: float
    spread: float
    work: float
    final: float
    guards: dict[tuple[int, int], LinkGuard]


Policy = Callable[[int, int, float, float], float]


def attack(plan: Plan, move: Policy, guard: Callable[..., LinkGuard] = LinkGuard) -> Outcome:
    """Runs the plan; `move(user, step, force, damping)` is the velocity that the user gives its copy."""
    users = len(plan.ends)
    x = [0.0] * users
    guards: dict[tuple[int, int], LinkGuard] = {}
    for a, b in plan.links:
        for i, j in ((a, b), (b, a)):
            start = Sample(sender=j, index=-1, stamp=0.0, position=np.zeros(1), header=NO_HEADER)
            shift = plan.offset[i] - plan.offset[j]
            guards[i, j] = guard(
                FreshestLink(start), budget=plan.budget[i, j] + shift, total=plan.total(i, j), **plan.options
            )
            guards[i, j].attach(K)
    held = dict.fromkeys(guards, 0.0)
    waiting: dict[tuple[int, int], list[tuple[float, Sample]]] = {pair: [] for pair in guards}
    before = [0.0] * users
    supplied = least = scale = greatest = worked = 0.0
    coupled = guarded = 0
    mine = [[pair for pair in guards if pair[0] == i] for i in range(users)]
    damping = [plan.damping(i) for i in range(users)]
    for now, i, k in plan.order:
        T, clock = now - before[i], now + plan.offset[i]
        before[i] = now
        force = 0.0
        for pair in mine[i]:
            end = guards[pair]
            arrived = [entry for entry in waiting[pair] if entry[0] <= now]
            waiting[pair] = [entry for entry in waiting[pair] if entry[0] > now]
            for _, sample in sorted(arrived, key=lambda entry: entry[0]):
                end.offer(sample)
            newest = end.choose(k)
            y = float(newest.position[0])
            was = end.state
            fraction = end.decide(newest, (x[i] - y) ** 2, (x[i] - held[pair]) ** 2, clock, T)
            coupled += was != 2 and end.state == 2
            guarded += was == 2 and end.state != 2
            held[pair] = y if fraction == 1.0 else x[i] + fraction * (y - x[i])
            force -= K * (x[i] - held[pair])
            greatest = max(greatest, K * abs(x[i] - held[pair]))
        v = move(i, k, force, damping[i])
        middle = x[i] + 0.5 * T * v
        for pair in mine[i]:
            guards[pair].settle(v * v, T)
            work = -T * v * K * (middle - held[pair])
            supplied -= work
            worked += work
        supplied += T * damping[i] * v * v
        scale += T * damping[i] * v * v
        least = min(least, supplied)
        x[i] += T * v
        for pair in mine[i]:
            arrival = plan.arrival[pair][k]
            if np.isfinite(arrival):
                sample = Sample(
                    sender=i, index=k, stamp=clock - 0.5 * T, position=np.array([middle]), header=guards[pair].header
                )
                waiting[pair[1], i].append((float(arrival), sample))
    return Outcome(least, scale, coupled, guarded, greatest, max(x) - min(x), worked, supplied, guards)


def knots(plan: Plan, speed: np.ndarray, length: float) -> Policy:
    """Constant velocities over spans of a length, (users, spans)."""

    def move(i: int, k: int, force: float, damping: float) -> float:
        span = int(plan.ends[i][k] / length)
        return float(speed[i, min(span, speed.shape[1] - 1)])

    return move


def random_plan(number: int, *, duration: float = 1.5, users: int | None = None, **options: float) -> Plan:
    """Two to five users with rates, paths, outages and clocks of their own."""
    rng = np.random.default_rng(number)
    users = int(rng.integers(2, 6)) if users is None else users
    T = [float(rng.choice([0.01, 0.02, 0.03])) for _ in range(users)]
    ends = []
    for i in range(users):
        steps = T[i] * rng.uniform(0.5, 1.5, int(duration / T[i]) + 2)
        ends.append(np.cumsum(steps)[np.cumsum(steps) < duration])
    links = [(int(rng.integers(0, j)), j) for j in range(1, users)]
    ways, budget = {}, {}
    for a, b in links:
        for i, j in ((a, b), (b, a)):
            outages = []
            for _ in range(int(rng.integers(0, 4))):
                first = float(rng.uniform(0.0, duration))
                outages.append((first, first + float(rng.uniform(0.02, 0.3))))
            ways[i, j] = Way(
                float(rng.choice([0.0, 0.01, 0.04])), float(rng.choice([0.0, 0.003, 0.02])),
                float(rng.choice([0.0, 0.1, 0.3])), outages,
            )  # fmt: skip
    for i, j in ways:
        budget[i, j] = ways[j, i].delay + 1.5 * ways[j, i].jitter + 1.5 * (T[i] + T[j]) * float(rng.choice([1.0, 1.5]))
    offset = [float(rng.choice([0.0, 3.0, -7.0])) for _ in range(users)]
    return Plan(ends, links, ways, budget, offset, options, number)


def greedy(seed: int, *, eager: float = 1.0, switch: float = 0.1, push: float = 1.0) -> Policy:
    """Pushes at random for a while, then follows the force: that is how energy is taken."""
    rng = np.random.default_rng(seed)
    mode: dict[int, tuple[str, float]] = {}

    def move(i: int, k: int, force: float, damping: float) -> float:
        if i not in mode or rng.random() < switch:
            mode[i] = (str(rng.choice(["push", "take", "take", "hold", "shake"])), float(rng.normal(0.0, push)))
        what, v = mode[i]
        if what == "push":
            return v
        if what == "take":
            return eager * force / (2.0 * max(damping, 1e-9))
        return v * (-1.0) ** k if what == "shake" else 0.0

    return move


def tight_plan(number: int, *, duration: float = 4.0, **options: float) -> Plan:
    """Two users with equal steps and constant delays, budgets met exactly, and one or more outages of either way."""
    rng = np.random.default_rng(number)
    T = 0.01
    ends = [T * np.arange(1, int(duration / T) + 1) for _ in range(2)]
    steps = [int(rng.integers(0, 4)) for _ in range(2)]
    ways: dict[tuple[int, int], Way] = {}
    for pair, delay in zip(((0, 1), (1, 0)), steps, strict=True):
        outages = []
        for _ in range(int(rng.integers(0, 4))):
            first = float(rng.uniform(0.3, duration))
            outages.append((first, first + float(rng.choice([0.02, 0.1, 0.4]))))
        ways[pair] = Way((delay + 0.5) * T, outages=outages)
    # a sample of the step that ends at t arrives at t + (delay + ½) T, is used by the step that ends T/2 later at most
    budget = {(i, j): (steps[0 if (j, i) == (0, 1) else 1] + 1.5) * T + 1e-9 for i, j in ((0, 1), (1, 0))}
    return Plan(ends, [(0, 1)], ways, budget, [0.0, 0.0], options, number)
