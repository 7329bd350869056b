"""The network that a session's file describes, put on the real one."""

from collections.abc import Callable

from cotouch.errors import ScenarioError
from cotouch.samples import PathLaw
from cotouch.scenario import Scenario


def path_laws(scenario: Scenario, slot: int) -> dict[int, PathLaw]:
    """The law of the direction from one slot to each other: delay from `[network]`, the rest from `[channel]`.

    Args:
        scenario: of the session.
        slot: who sends.

    Raises:
        ScenarioError: the channel has a law that is only for simulations, or its trace cannot be read.
    """
    channel = scenario.channel
    if channel.jitter is not None and channel.jitter.kind != "uniform":
        raise ScenarioError(f'channel.jitter.kind is "{channel.jitter.kind}"; a session can emulate only "uniform"')
    if channel.trace is not None and not channel.trace.loop:
        raise ScenarioError("channel.trace.loop is false, but a session may last longer; set it to true")
    burst = channel.burst
    if burst is not None and (burst.loss_good, burst.loss_bad) != (0.0, 1.0):
        raise ScenarioError("for a session to emulate channel.burst, it must have loss_good = 0 and loss_bad = 1")
    return {
        other: PathLaw(
            delay=float(scenario.network.delay[other, slot]),
            jitter=0.0 if channel.jitter is None else channel.jitter.scale,
            loss=channel.loss,
            duplication=channel.duplication,
            reordering=channel.reordering,
            hold=channel.reordering_delay,
            enter=0.0 if burst is None else burst.enter,
            leave=1.0 if burst is None else burst.leave,
            further=_measured(scenario, slot, other),
        )
        for other in range(scenario.network.size)
        if other != slot
    }


def _measured(scenario: Scenario, slot: int, other: int) -> Callable[[float, int], float] | None:
    """What the channel's trace adds, from where the direction finds it in the simulator; None: there is none."""
    trace = scenario.trace()
    if trace is None:
        return None
    from cotouch.simulation import start_of

    start = start_of((scenario.seed, 2, other, slot))
    return lambda since, number: trace.one(since, number, start)
