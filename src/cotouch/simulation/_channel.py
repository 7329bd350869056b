"""The virtual network: when every message arrives, drawn from a seed, one stream for each direction of each link."""

from collections.abc import Callable
from typing import NamedTuple, TypeAlias

import numpy as np

from cotouch.arrays import Bool, Float, Long
from cotouch.passing import by_address
from cotouch.scenario import Channel, Trace

# Further delay of some messages of one direction, by their numbers and how long after the others they are sent [s].
MeasuredDelays: TypeAlias = Callable[[Long, float], Float]

# A message that was lost this often in a row is taken to arrive with the next try; beyond any loss rate of use.
_MOST_TRIES = 1000


@by_address
class Draws(NamedTuple):
    """What happens to the messages of one direction; not for writing, because a constant is one number seen as many.

    Attributes:
        latency: from sending to arrival, (messages,) [s]; infinite: lost.
        second: likewise for the duplicate, where there is one.
        first: of whichever of the two arrives first.
    """

    latency: Float
    second: Float
    first: Float


def certain(channel: Channel) -> bool:
    """Whether every message arrives once, after the constant delay."""
    chances = (channel.reordering, channel.loss, channel.duplication)
    return channel.jitter is None and channel.trace is None and channel.burst is None and not any(chances)


def measured_at(trace: Trace | None, sent: Float, *, seed: tuple[int, ...]) -> MeasuredDelays | None:
    """What a trace adds to the delay of one direction, which begins at a place of its own; None without a trace.

    Args:
        trace: of the channel.
        sent: when messages are sent, (messages,) [s].
        seed: of this direction.
    """
    if trace is None:
        return None
    start = start_of(seed)
    return lambda index, later: trace.of(sent + later, start)[index]


def start_of(seed: tuple[int, ...]) -> float:
    """Share of a trace at which a direction of a link finds it.

    Args:
        seed: of this direction.
    """
    return float(np.random.Generator(np.random.PCG64(np.random.SeedSequence((*seed, 2)))).random())


def draw(
    channel: Channel, delay: float, messages: int, *, seed: tuple[int, ...], measured: MeasuredDelays | None = None
) -> Draws:
    """Draws the fate of every message of one direction.

    Args:
        channel: the law.
        delay: constant part of the delay [s].
        messages: how many.
        measured: of the channel's trace, as `measured_at` has it.
        seed: of this direction; the same seed gives the same fates, whatever other links there are.
    """
    if certain(channel):
        latency = np.broadcast_to(delay, messages)
        return Draws(latency, np.broadcast_to(np.inf, messages), latency)
    rng = np.random.Generator(np.random.PCG64(np.random.SeedSequence(seed)))
    every = np.arange(messages)
    latency = delay + _jitter(channel, every, rng, measured)
    if channel.reordering > 0.0:
        latency = latency + channel.reordering_delay * (rng.random(messages) < channel.reordering)
    latency[_lost(channel, messages, rng)] = np.inf
    if channel.duplication == 0.0:
        return Draws(latency, np.broadcast_to(np.inf, messages), latency)
    second = np.full(messages, np.inf)
    twice = rng.random(messages) < channel.duplication
    second[twice] = delay + _jitter(channel, every[twice], rng, measured)
    return Draws(latency, second, np.minimum(latency, second))


def resent(
    channel: Channel,
    draws: Draws,
    delay: float,
    round_trip: float,
    *,
    seed: tuple[int, ...],
    measured: MeasuredDelays | None = None,
) -> Float:
    """Latency of every sample when lost messages are sent again until they arrive, (messages,) [s]; not for writing.

    Args:
        channel: the law; `resend` is the time from sending to sending again.
        draws: fates of the first tries.
        delay: constant part of the delay [s].
        round_trip: constant part of the round trip, from which the default of `resend` is made [s].
        seed: of the later tries.
        measured: of the channel's trace, as `measured_at` has it.
    """
    waiting = np.flatnonzero(np.isinf(draws.first))
    if not waiting.size:
        return draws.first
    latency = draws.first.copy()
    rng = np.random.Generator(np.random.PCG64(np.random.SeedSequence((*seed, 1))))
    wait = channel.resend
    if wait is None:
        # An exponential's 99 % point is 4.6 means away; a sender that waits less would repeat what is only late.
        wait = round_trip + 2.0 * 4.6 * (channel.jitter.scale if channel.jitter else 0.0) + channel.reordering_delay
        if measured is not None:
            wait += 2.0 * float(np.quantile(measured(np.arange(draws.first.size), 0.0), 0.99))
    probability = _mean_loss(channel)
    sent = np.zeros(latency.size)
    for tries in range(_MOST_TRIES):
        if not waiting.size:
            break
        sent[waiting] += wait
        arrived = rng.random(waiting.size) >= probability
        if tries == _MOST_TRIES - 1:
            arrived[:] = True
        home = waiting[arrived]
        if home.size:  # all that still wait were sent again at the same time after their first try
            latency[home] = sent[home] + delay + _jitter(channel, home, rng, measured, float(sent[home[0]]))
        waiting = waiting[~arrived]
    return latency


def _jitter(
    channel: Channel,
    index: Long,
    rng: np.random.Generator,
    measured: MeasuredDelays | None,
    later: float = 0.0,
) -> Float:
    """Further delay of messages, by their numbers, sent again so much later."""
    count = index.size
    if measured is not None:
        return measured(index, later)
    if channel.jitter is None:
        return np.zeros(count)
    scale = channel.jitter.scale
    match channel.jitter.kind:
        case "uniform":
            return rng.uniform(0.0, scale, count)
        case "exponential":
            return rng.exponential(scale, count)
        case "normal":
            return np.abs(rng.normal(0.0, scale, count))


def _lost(channel: Channel, count: int, rng: np.random.Generator) -> Bool:
    lost = np.zeros(count, dtype=bool)
    if channel.loss > 0.0:
        lost |= rng.random(count) < channel.loss
    burst = channel.burst
    if burst is not None:
        # Stays in a state last geometrically many messages; drawing the stays is exact and needs no loop over messages.
        enter = max(burst.enter, 1e-12)
        bad = np.zeros(count, dtype=bool)
        here = 0
        while here < count:
            here += int(rng.geometric(enter))
            stay = int(rng.geometric(burst.leave))
            bad[here : here + stay] = True
            here += stay
        lost |= rng.random(count) < np.where(bad, burst.loss_bad, burst.loss_good)
    return lost


def _mean_loss(channel: Channel) -> float:
    kept = 1.0 - channel.loss
    if channel.burst is not None:
        bad = channel.burst.enter / (channel.burst.enter + channel.burst.leave)
        kept *= 1.0 - (bad * channel.burst.loss_bad + (1.0 - bad) * channel.burst.loss_good)
    return 1.0 - kept
