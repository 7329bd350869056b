"""When every user steps and which sample each step uses; clocks and channel decide all of it, motion none."""

from dataclasses import dataclass
from functools import cached_property
from typing import final

import numpy as np

from cotouch.arrays import Float, Int, Long
from cotouch.errors import ScenarioError
from cotouch.network import Network
from cotouch.scenario import Mode, Scenario
from cotouch.simulation._channel import Draws, MeasuredDelays, certain, draw, measured_at, resent
from cotouch.simulation._clocks import bound_apart, bound_together, step_lengths, together
from cotouch.simulation._timing import ages, elapsed, indexed, newest, ring_size, self_paced

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

    @cached_property
    def pairs(self) -> list[tuple[int, int]]:
        """Receiver and sender of each."""
        return list(zip(self.receiver.tolist(), self.sender.tolist(), strict=True))


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
        nominal: T as the clocks were set, (users, steps) [s]; waiting for others makes steps of an index longer.
        bound: on T, (users,) [s].
        behind: the most by which the time that a copy has simulated was behind its user's clock, (users,) [s].
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
    count: Long
    end: Float
    length: Float
    nominal: Float
    bound: Float
    behind: Float
    order: Int
    used: Int
    ring: int
    reference: int
    index_delay: Long | None
    underruns: Long
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
        for s, (i, j) in enumerate(self.slots.pairs):
            n, m = self.count[i], self.count[j]
            ages(self.end[i, :n], self.end[j, :m], self.length[j, :m], self.used[s, :n], age[s, :n])

    def budget(self, quantile: float) -> Float:
        """Age in seconds that the given share of steps stays within, (users, users), [i][j] at i of j's samples."""
        users = self.count.size
        result = np.zeros((users, users))
        for s, (i, j) in enumerate(self.slots.pairs):
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
    nominal = step_lengths(scenario, network.size, common=True)
    steps = nominal.shape[1]
    clock = nominal if scenario.channel.trace is None else np.cumsum(nominal, axis=1)
    draws = _draws(scenario, network, slots, clock)
    latency = _latencies(scenario, network, slots, draws, clock)
    if mode == "constant":
        end, length = together(nominal)
    else:
        end, length = np.zeros_like(nominal), np.zeros_like(nominal)
    delay = _index_delays(scenario, network, slots, latency, nominal, end)
    of_slot = delay[slots.receiver, slots.sender].astype(np.int32)
    used = np.empty((slots.link.size, steps), dtype=np.int32)
    underruns = np.zeros(slots.link.size, dtype=np.int64)
    behind = np.zeros(network.size)
    if mode == "constant":
        bound = bound_together(scenario, nominal, length)
        for s, (i, j) in enumerate(slots.pairs):
            underruns[s] = indexed(np.ascontiguousarray(latency[s]), end[j], end[i], int(of_slot[s]), used[s])
        count = np.full(network.size, steps, dtype=np.int64)
    else:
        self_paced(nominal, slots.first, slots.sender, of_slot, np.ascontiguousarray(latency), end)
        bound = bound_apart(scenario, nominal, end)
        elapsed(end, bound, length)
        np.maximum(np.arange(steps, dtype=np.int32)[None, :] - of_slot[:, None], -1, out=used)
        # A step that would be taken after the run has ended is not part of it.
        count = np.array([np.searchsorted(row, scenario.steps.duration + 1e-9, side="right") for row in end])
        if count.min(initial=1) < 1:
            raise ScenarioError(
                f"the run lasts {scenario.steps.duration} s, but user {int(count.argmin()) + 1} waits longer than that "
                "for the first samples; make it longer"
            )
        late = end - np.cumsum(length, axis=1)
        behind = np.array([max(float(late[i, :n].max()), 0.0) for i, n in enumerate(count)])
    return _finish(mode, slots, count, end, length, nominal, bound, behind, used, delay, underruns, draws, latency)


def _freshest(scenario: Scenario, network: Network, slots: Slots) -> Schedule:
    length = step_lengths(scenario, network.size, common=False)
    end = np.cumsum(length, axis=1)
    if scenario.steps.random is None:
        # Products, not sums: step 10,000 of 1 ms ends at 10 s exactly.
        end = length * np.arange(1, int(length.shape[1]) + 1)
    limit = scenario.steps.duration * (1.0 + 1e-12) + 1e-12
    count = np.array([np.searchsorted(row, limit, side="right") for row in end])
    steps = int(count.max())
    end, length = np.ascontiguousarray(end[:, :steps]), np.ascontiguousarray(length[:, :steps])
    draws = _draws(scenario, network, slots, np.minimum(end, limit))
    used = np.full((slots.link.size, steps), -1, dtype=np.int32)
    for s, (i, j) in enumerate(slots.pairs):
        sent = end[j, : count[j]]
        newest(sent, sent + draws[s].first[: count[j]], end[i, : count[i]], used[s, : count[i]])
    none = np.zeros(slots.link.size, dtype=np.int64)
    bound, behind = length.max(axis=1), np.zeros(network.size)
    return _finish("freshest", slots, count, end, length, length, bound, behind, used, None, none, draws, None)


def _finish(
    mode: Mode,
    slots: Slots,
    count: Long,
    end: Float,
    length: Float,
    nominal: Float,
    bound: Float,
    behind: Float,
    used: Int,
    delay: Long | None,
    underruns: Long,
    draws: list[Draws],
    latency: Float | None,
) -> Schedule:
    users, steps = end.shape
    if mode != "freshest" or (end == end[0]).all():
        order = np.tile(np.arange(users, dtype=np.int32), steps)
        if count.min() < steps:
            index = np.repeat(np.arange(int(steps)), int(users))
            order = order[index < count[order]]
    else:
        owner = np.concatenate([np.full(n, i, dtype=np.int32) for i, n in enumerate(count)])
        moment = np.concatenate([end[i, :n] for i, n in enumerate(count)])
        order = owner[np.argsort(moment, kind="stable")]
    ring = ring_size(order, slots.first, slots.sender, used, np.zeros(int(users), np.int32))
    return Schedule(
        mode=mode,
        slots=slots,
        count=count,
        end=end,
        length=length,
        nominal=nominal,
        bound=bound,
        behind=behind,
        order=order,
        used=used,
        ring=1 << (int(ring) - 1).bit_length(),
        reference=int(users - 1 - np.argmax(count[::-1])),
        index_delay=delay,
        underruns=underruns,
        draws=draws,
        latency=latency,
    )


def _seed(scenario: Scenario, receiver: int, sender: int) -> tuple[int, ...]:
    return (scenario.seed, 2, receiver, sender)


def _measured(scenario: Scenario, slots: Slots, clock: Float) -> list[MeasuredDelays | None]:
    """What the channel's trace adds to the messages of each slot; they are sent by the users' own clocks."""
    trace = scenario.trace()
    return [measured_at(trace, clock[j], seed=_seed(scenario, i, j)) for i, j in slots.pairs]


def _draws(scenario: Scenario, network: Network, slots: Slots, clock: Float) -> list[Draws]:
    traced = _measured(scenario, slots, clock)
    return [
        draw(
            scenario.channel,
            float(network.delay[i, j]),
            clock.shape[1],
            seed=_seed(scenario, i, j),
            measured=measured,
        )
        for (i, j), measured in zip(slots.pairs, traced, strict=True)
    ]


def _latencies(scenario: Scenario, network: Network, slots: Slots, draws: list[Draws], clock: Float) -> Float:
    """Latency of every sample, resends included, (slots, steps) [s]."""
    there, back = network.delay[slots.receiver, slots.sender], network.delay[slots.sender, slots.receiver]
    if certain(scenario.channel):
        return np.broadcast_to(there[:, None], (there.size, clock.shape[1]))
    latency = np.empty((there.size, clock.shape[1]))
    for s, (pair, measured) in enumerate(zip(slots.pairs, _measured(scenario, slots, clock), strict=True)):
        latency[s] = resent(
            scenario.channel, draws[s], there[s], there[s] + back[s], seed=_seed(scenario, *pair), measured=measured
        )
    return latency


def _index_delays(
    scenario: Scenario, network: Network, slots: Slots, latency: Float, nominal: Float, end: Float
) -> Long:
    """N_ij as given, or as many steps as the latencies ask for: all alike, else as the common index takes them.

    Of self-paced users, whose steps follow from N_ij, the shortest that the slowest may take counts.
    """
    users = network.size
    given = scenario.synchronisation.index_delay
    result = np.zeros((users, users), dtype=np.int64)
    if given is not None:
        if len(given) != users or any(len(row) != users for row in given):
            raise ScenarioError(f"synchronisation.index_delay must be {users} x {users}, one row for each user")
        for i, j in slots.pairs:
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
    known = scenario.synchronisation.mode == "constant" and not (nominal == nominal.flat[0]).all()
    for s, (i, j) in enumerate(slots.pairs):
        needed = _steps_until(end[j] + latency[s], end[i]) if known else latency[s] / shortest
        every = quantile == 1.0  # the largest of many needs no sorting
        most = float(needed.max() if every else np.quantile(needed, quantile, method="higher"))
        result[i, j] = max(1, int(np.ceil(most - 1e-9)))
    return result


def _steps_until(arrival: Float, end: Float) -> Float:
    """How many indices after that of each sample the receiver takes the first step that finds it, (steps,)."""
    steps = end.size
    first = np.searchsorted(end, arrival - 1e-9)  # as `indexed` has it
    beyond = np.maximum(arrival - end[-1], 0.0) * steps / end[-1]  # in mean steps, had the run gone on
    return np.asarray(first + np.where(first < steps, 0.0, np.ceil(beyond)) - np.arange(steps), dtype=np.float64)
