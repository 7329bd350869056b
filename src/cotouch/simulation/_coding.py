"""What a perceptual codec asks of a run: what cannot have one, the ages that it may cause, and its damping."""

import numpy as np

from cotouch.arrays import Float, Int
from cotouch.errors import ScenarioError
from cotouch.laws import Law
from cotouch.mechanics import WEIGHTS, Model
from cotouch.network import damping_for
from cotouch.scenario import Scenario
from cotouch.simulation._schedule import Schedule
from cotouch.simulation._timing import ages, newest


def check_codec(scenario: Scenario, ready: Model, law: Law, weight: Int) -> None:
    """Refuses what a codec cannot serve.

    Args:
        scenario: what was asked for.
        ready: the body.
        law: of the links.
        weight: of every slot, (slots,).

    Raises:
        ScenarioError: the scenario has a codec, and something that goes with none.
    """
    if scenario.channel.codec is None:
        return
    mode = scenario.synchronisation.mode
    if mode != "freshest":
        raise ScenarioError(
            f'channel.codec is given, but synchronisation.mode is "{mode}", which needs every sample in full; use mode '
            '"freshest", or leave the codec out'
        )
    if any(np.any(ready.operator.mix[WEIGHTS + w]) for w in weight):
        raise ScenarioError(
            "channel.codec is given, but a link's weight couples nodes or axes; what its errors cost is known for "
            "diagonal weights only"
        )
    if law.passive and law.rule == 0.0 and not law.energies:
        raise ScenarioError(
            f'channel.codec is given, but law "{law.name}" does not say in which numbers its ends pay (energies), so '
            "nothing bounds what inexact samples make; take another law, or leave the codec out"
        )
    if law.constant_delay:
        raise ScenarioError(
            f'channel.codec is given, but law "{law.name}" needs samples of a constant age; leave the codec out'
        )
    for there, what in (
        (bool(scenario.tools), "tools"),
        (scenario.record.frames is not None, "record.frames"),
        (scenario.cutting is not None, "cutting"),
    ):
        if there:
            raise ScenarioError(
                f"channel.codec is given with {what}, which a message-by-message run does not record; leave one of "
                "them out"
            )


def age_budget(scenario: Scenario, timing: Schedule, law: Law, quantile: float) -> Float:
    """Age that the given share of steps stays within, (users, users), [i][j] at i of j's samples [s].

    With a codec, what goes on from a lost content is lost too. Whatever the sender decides, a sample can be used once
    it and all that may hold its content have arrived, so for laws whose damping pays for ages those count.

    Args:
        scenario: what was asked for.
        timing: of the run.
        law: of the links.
        quantile: share of the steps.
    """
    asked = scenario.channel.codec
    if asked is None or timing.mode != "freshest" or law.rule == 0.0:
        return timing.budget(quantile)
    users, slots = timing.count.size, timing.slots
    result = np.zeros((users, users))
    for s, (i, j) in enumerate(slots.pairs):
        n, m = int(timing.count[i]), int(timing.count[j])
        sent = timing.end[j, :m]
        whole = np.array(sent + timing.draws[s].first[:m])
        arrival = whole.copy()
        for back in range(1, min(asked.hold, m - 1) + 1):
            np.maximum(arrival[back:], whole[:-back], out=arrival[back:])
        used, age = np.full(n, -1, dtype=np.int32), np.zeros(n)
        newest(sent, arrival, timing.end[i, :n], used)
        ages(timing.end[i, :n], sent, timing.length[j, :m], used, age)
        result[i, j] = age.max() if quantile == 1.0 else np.quantile(age, quantile)
    return result


def codec_damping(scenario: Scenario) -> Float | float:
    """Damping on top of the rule's that pays for the codec's errors, K_ij ε for each link, (users, 1 + weights) [Ns/m].

    Args:
        scenario: what was asked for.
    """
    asked, network = scenario.channel.codec, scenario.network
    if asked is None:
        return 0.0
    return damping_for(network, "rule", ages=np.full((network.size, network.size), asked.age))
