"""When every user steps and which sample each step uses; clocks and channel decide all of it, motion none."""

from dataclasses import dataclass
from functools import cached_property
from typing import final

import numpy as np
import numpy.typing as npt

from cotouch.errors import ScenarioError
from cotouch.network import Network
from cotouch.scenario import Mode, Scenario, per_user
from cotouch.simulation._channel import Draws, certain, draw, resent
from cotouch.simulation._timing import ages, elapsed, indexed, newest, ring_size, self_paced

Float = npt.NDArray[np.float64]
Int = npt.NDArray[np.int32]

_DEFAULT_PERIOD = 1e-3
_MOST_STEPS = 50_000_000
# Self-pacing waits for the samples that N_ij does not cover; one in a hundred keeps the pace near the nominal one.
_SELF_PACED_QUANTILE = 0.99


@final
@dataclass(frozen=True, kw_only=True, eq=False)
class Slots:
    """Directions of links, ordered by receiver: slot s is what `receiver[s]` sees of `sender[s]` over `link[s]`."""

    first: Int
    receiver: Int
    sender: Int
    link: Int

    @classmethod
    def of(cls, network: Network) -> "Slots":
        """The slots of a network."""
        rows = [(b, a, k) for k, (a, b) in enumerate(network.links)]
        rows += [(a, b, k) for k, (a, b) in enumerate(network.links)]
        table = np.array(sorted(rows), dtype=np.int32).reshape(-1, 3)
        first = np.searchsorted(table[:, 0], np.arange(network.size + 1)).astype(np.int32)
        receiver, sender, link = (np.ascontiguousarray(column) for column in table.T)
        return cls(first=first, receiver=receiver, sender=sender, link=link)


@final
@dataclass(frozen=True, kw_only=True, eq=False)
class Schedule:
    """The timing of a run.

    Attributes:
        mode: how samples are chosen.
        slots: directions of links.
        count: steps of each user, (users,).
        end: when each step is taken, (users, steps) [s]; rows are filled up to `count`.
        length: T of each step, (users, steps) [s].
        nominal: T as the clocks were set, (users, steps) [s]; waiting makes self-paced steps longer.
        bound: on T, (users,) [s].
        order: user of each event, (events,).
        used: index of the sample that each slot uses, (slots, steps); -1: the initial one.
        ring: how many samples of a user are kept so that none is overwritten before its last use; a power of two.
        reference: the user with the most steps (the last of them).
        index_delay: N_ij, (users, users), in the modes that have one.
        underruns: how often the sample k - N_ij had not arrived, (slots,).
        draws: fates of the messages of each slot.
        latency: of every sample, resends included, (slots, steps) [s]; where the mode needs every sample.
    """

    mode: Mode
    slots: Slots
    count: npt.NDArray[np.int64]
    end: Float
    length: Float
    nominal: Float
    bound: Float
    order: Int
    used: Int
    ring: int
    reference: int
    index_delay: npt.NDArray[np.int64] | None
    underruns: npt.NDArray[np.int64]
    draws: list[Draws]
    latency: Float | None

    @cached_property
    def age(self) -> Float:
        """Age of the sample that each slot uses, at the end of the step, (slots, steps) [s]."""
        result = np.zeros(self.used.shape)
        self.ages_into(result)
        return result

    def ages_into(self, age: Float) -> None:
        """Writes the ages of the steps that are taken into the rows of an array, (slots, at least those steps) [s]."""
        for s in range(self.slots.link.size):
            i, j = self.slots.receiver[s], self.slots.sender[s]
            n, m = self.count[i], self.count[j]
            ages(self.end[i, :n], self.end[j, :m], self.length[j, :m], self.used[s, :n], age[s, :n])

    def budget(self, quantile: float) -> Float:
        """Age in seconds that the given share of steps stays within, (users, users), [i][j] at i of j's samples."""
        users = self.count.size
        result = np.zeros((users, users))
        for s in range(self.slots.link.size):
            i, j = self.slots.receiver[s], self.slots.sender[s]
            ages_here = self.age[s, : self.count[i]]
            result[i, j] = ages_here.max() if quantile == 1.0 else np.quantile(ages_here, quantile)
        return result

    def longest(self) -> Float:
        """Largest T of each user, (users,) [s]."""
        return np.array([self.length[i, :n].max(initial=0.0) for i, n in enumerate(self.count)])


def schedule(scenario: Scenario) -> Schedule:
    """Works out the timing of a scenario.

    Raises:
        ScenarioError: steps or delays that the mode cannot have.
    """
    network = scenario.network
    slots = Slots.of(network)
    mode = scenario.synchronisation.mode
    if mode == "freshest":
        return _freshest(scenario, network, slots)
    nominal = _lengths(scenario, network.size, common=True)
    steps = nominal.shape[1]
    draws = _draws(scenario, network, slots, steps)
    latency = _latencies(scenario, network, slots, draws, steps)
    delay = _index_delays(scenario, network, slots, latency, nominal)
    of_slot = delay[slots.receiver, slots.sender].astype(np.int32)
    used = np.empty((slots.link.size, steps), dtype=np.int32)
    bound = nominal.max(axis=1)
    underruns = np.zeros(slots.link.size, dtype=np.int64)
    if mode == "constant":
        clock = _clock(nominal)
        end, length = np.tile(clock, (network.size, 1)), nominal
        for s in range(slots.link.size):
            underruns[s] = indexed(np.ascontiguousarray(latency[s]), clock, int(of_slot[s]), used[s])
        count = np.full(network.size, steps, dtype=np.int64)
    else:
        end, length = np.zeros_like(nominal), np.zeros_like(nominal)
        self_paced(nominal, slots.first, slots.sender, of_slot, np.ascontiguousarray(latency), end)
        longest = scenario.synchronisation.longest
        # Twice the mean pace leaves room to make up for a long wait.
        bound = 2.0 * end[:, -1] / steps if longest is None else longest * nominal.max(axis=1)
        elapsed(end, bound, length)
        np.maximum(np.arange(steps, dtype=np.int32)[None, :] - of_slot[:, None], -1, out=used)
        # A step that would be taken after the run has ended is not part of it.
        count = np.array([np.searchsorted(row, scenario.steps.duration + 1e-9, side="right") for row in end])
        if count.min(initial=1) < 1:
            raise ScenarioError(
                f"the run lasts {scenario.steps.duration} s, but user {int(count.argmin()) + 1} waits longer than that "
                "for the first samples; make it longer"
            )
    return _finish(mode, slots, count, end, length, nominal, bound, used, delay, underruns, draws, latency)


def _freshest(scenario: Scenario, network: Network, slots: Slots) -> Schedule:
    length = _lengths(scenario, network.size, common=False)
    end = np.cumsum(length, axis=1)
    if scenario.steps.random is None:
        end = length * np.arange(1, length.shape[1] + 1)  # products, not sums: step 10,000 of 1 ms ends at 10 s exactly
    limit = scenario.steps.duration * (1.0 + 1e-12) + 1e-12
    count = np.array([np.searchsorted(row, limit, side="right") for row in end])
    steps = int(count.max())
    end, length = np.ascontiguousarray(end[:, :steps]), np.ascontiguousarray(length[:, :steps])
    draws = _draws(scenario, network, slots, steps)
    used = np.full((slots.link.size, steps), -1, dtype=np.int32)
    for s in range(slots.link.size):
        i, j = slots.receiver[s], slots.sender[s]
        sent = end[j, : count[j]]
        newest(sent, sent + draws[s].first[: count[j]], end[i, : count[i]], used[s, : count[i]])
    none = np.zeros(slots.link.size, dtype=np.int64)
    bound = length.max(axis=1)
    return _finish("freshest", slots, count, end, length, length, bound, used, None, none, draws, None)


def _finish(
    mode: Mode,
    slots: Slots,
    count: npt.NDArray[np.int64],
    end: Float,
    length: Float,
    nominal: Float,
    bound: Float,
    used: Int,
    delay: npt.NDArray[np.int64] | None,
    underruns: npt.NDArray[np.int64],
    draws: list[Draws],
    latency: Float | None,
) -> Schedule:
    users, steps = end.shape
    if mode != "freshest" or (end == end[0]).all():
        order = np.tile(np.arange(users, dtype=np.int32), steps)
        if count.min() < steps:
            index = np.repeat(np.arange(steps), users)
            order = order[index < count[order]]
    else:
        owner = np.concatenate([np.full(n, i, dtype=np.int32) for i, n in enumerate(count)])
        moment = np.concatenate([end[i, :n] for i, n in enumerate(count)])
        order = owner[np.argsort(moment, kind="stable")]
    ring = ring_size(order, slots.first, slots.sender, used, np.zeros(users, np.int32))
    return Schedule(
        mode=mode,
        slots=slots,
        count=count,
        end=end,
        length=length,
        nominal=nominal,
        bound=bound,
        order=order,
        used=used,
        ring=1 << (int(ring) - 1).bit_length(),
        reference=int(users - 1 - np.argmax(count[::-1])),
        index_delay=delay,
        underruns=underruns,
        draws=draws,
        latency=latency,
    )


def _lengths(scenario: Scenario, users: int, *, common: bool) -> Float:
    """Nominal step lengths, (users, steps); with a common index, as many steps as the slowest has time for."""
    steps = scenario.steps
    if steps.random is not None:
        most = _checked(steps.duration / steps.random.low)
        rows = [
            np.random.Generator(np.random.PCG64(np.random.SeedSequence((scenario.seed, 1, i)))).uniform(
                steps.random.low, steps.random.high, most
            )
            for i in range(users)
        ]
        lengths = np.array(rows)
    else:
        if steps.rate is not None:
            period = 1.0 / per_user(steps.rate, users, "steps.rate")
        else:
            period = per_user(_DEFAULT_PERIOD if steps.period is None else steps.period, users, "steps.period")
        longest = period.max() if common else period.min()
        lengths = np.broadcast_to(period[:, None], (users, _checked(steps.duration / longest)))
    if common:
        clock = _clock(lengths)
        count = int(np.searchsorted(clock, steps.duration * (1.0 + 1e-12) + 1e-12, side="right"))
        lengths = lengths[:, :count]
    if lengths.shape[1] < 1 or lengths[:, 0].max() > steps.duration * (1.0 + 1e-12):
        raise ScenarioError(f"the run lasts {steps.duration} s, which is less than one step; make it longer")
    return np.ascontiguousarray(lengths)


def _clock(lengths: Float) -> Float:
    """When the common index advances: with the slowest user at every step."""
    slowest = lengths.max(axis=0)
    if slowest.size and (slowest == slowest[0]).all():
        return slowest * np.arange(1, slowest.size + 1)
    return np.cumsum(slowest)


def _checked(steps: float) -> int:
    if steps > _MOST_STEPS:
        raise ScenarioError(f"the run has {steps:.3g} steps; at most {_MOST_STEPS:.0e} fit, so make it shorter")
    return int(np.ceil(steps * (1.0 + 1e-12) - 1e-9)) + 1


def _seed(scenario: Scenario, receiver: int, sender: int) -> tuple[int, ...]:
    return (scenario.seed, 2, receiver, sender)


def _draws(scenario: Scenario, network: Network, slots: Slots, messages: int) -> list[Draws]:
    return [
        draw(scenario.channel, float(network.delay[i, j]), messages, seed=_seed(scenario, int(i), int(j)))
        for i, j in zip(slots.receiver, slots.sender, strict=True)
    ]


def _latencies(scenario: Scenario, network: Network, slots: Slots, draws: list[Draws], steps: int) -> Float:
    """Latency of every sample, resends included, (slots, steps) [s]."""
    pairs = list(zip(slots.receiver.tolist(), slots.sender.tolist(), strict=True))
    there = np.array([network.delay[i, j] for i, j in pairs])
    back = np.array([network.delay[j, i] for i, j in pairs])
    if certain(scenario.channel):
        return np.broadcast_to(there[:, None], (there.size, steps))
    latency = np.empty((there.size, steps))
    for s, pair in enumerate(pairs):
        latency[s] = resent(scenario.channel, draws[s], there[s], there[s] + back[s], seed=_seed(scenario, *pair))
    return latency


def _index_delays(
    scenario: Scenario, network: Network, slots: Slots, latency: Float, nominal: Float
) -> npt.NDArray[np.int64]:
    """N_ij as given, or as many of the shortest common steps as the latencies ask for."""
    users = network.size
    given = scenario.synchronisation.index_delay
    result = np.zeros((users, users), dtype=np.int64)
    if given is not None:
        if len(given) != users or any(len(row) != users for row in given):
            raise ScenarioError(f"synchronisation.index_delay must be {users} x {users}, one row for each user")
        for i, j in zip(slots.receiver, slots.sender, strict=True):
            if given[i][j] < 1:
                raise ScenarioError(
                    f"synchronisation.index_delay[{i + 1}][{j + 1}] is {given[i][j]}; it must be at least 1, because "
                    "the neighbour's current sample is not known before the step is solved"
                )
            result[i, j] = given[i][j]
        return result
    quantile = scenario.synchronisation.quantile
    if quantile is None:
        quantile = _SELF_PACED_QUANTILE if scenario.synchronisation.mode == "self-paced" else 1.0
    shortest = float(nominal.max(axis=0).min())
    for s in range(slots.link.size):
        every = quantile == 1.0  # the largest of many needs no sorting
        needed = float(latency[s].max() if every else np.quantile(latency[s], quantile, method="higher"))
        result[slots.receiver[s], slots.sender[s]] = max(1, int(np.ceil(needed / shortest - 1e-9)))
    return result
