"""What a scenario's link law needs before a run: its parameters at every end, and the arrays of its ends."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import final

import numpy as np

from cotouch.arrays import Float, Int
from cotouch.errors import ScenarioError
from cotouch.laws import END_WORDS, Facts, Law, law_named
from cotouch.mechanics import WEIGHTS, Model
from cotouch.scenario import Scenario, makes_tree
from cotouch.simulation._channel import certain
from cotouch.simulation._coding import age_budget, check_codec
from cotouch.simulation._ends import Ends
from cotouch.simulation._layout import Fields
from cotouch.simulation._schedule import Schedule


@final
@dataclass(frozen=True, kw_only=True, eq=False)
class LawSetup:
    """A law, and its numbers at every end.

    Attributes:
        law: of all links.
        parameters: of every slot, (slots, parameters).
        weight: diagonal of every slot's weight, flat, (slots, size).
        holds: whether the law's promise holds with its parameters at every end.
        initial_energy: what all ends together may make, with what springs hold at the start [J].
    """

    law: Law
    parameters: Float
    weight: Float
    holds: bool
    initial_energy: float


def given_law(scenario: Scenario) -> tuple[Law, Mapping[str, float | str]]:
    """The scenario's law, which may be the default, and the parameters that it gives.

    Raises:
        NetworkError: there is no such law, or it has no such parameter.
    """
    name, given = scenario.law
    law = law_named(name)
    law.check(given)
    return law, given


def facts_of(scenario: Scenario, ready: Model, timing: Schedule, weight: Int) -> list[Facts]:
    """What is known of the end of every slot.

    Args:
        scenario: what is asked for.
        ready: the model that is stepped.
        timing: the schedule.
        weight: of each slot's link.
    """
    operator = ready.operator
    quantile = scenario.synchronisation.quantile
    budget = age_budget(scenario, timing, given_law(scenario)[0], 1.0 if quantile is None else quantile)
    longest, slots = timing.longest(), timing.slots
    network = scenario.network
    tree = makes_tree(range(network.size), network.links)
    ages = {
        pair: timing.age[s, : timing.count[pair[0]]][timing.used[s, : timing.count[pair[0]]] >= 0]
        for s, pair in enumerate(slots.pairs)
    }
    result: list[Facts] = []
    for s, (i, j) in enumerate(slots.pairs):
        known = operator.weight[weight[s]] > 0.0  # links do not know of tools
        masses = operator.mass[known] / operator.weight[weight[s], known]
        both = [heard for heard in (ages[i, j], ages[j, i]) if heard.size]
        result.append(
            Facts(
                spring=float(scenario.network.spring[i, j]),
                age=float(budget[i, j]),
                age_back=float(budget[j, i]),
                usual=float(np.mean([heard.mean() for heard in both])) if both else None,
                spread=max((float(np.ptp(heard)) for heard in both), default=0.0),
                period=float(longest[i]),
                period_back=float(longest[j]),
                mass=float(masses.mean()),
                lightest=float(masses.min()),
                degree=int(slots.first[i + 1] - slots.first[i]),
                degree_back=int(slots.first[j + 1] - slots.first[j]),
                tree=tree,
                rows=int(known.sum()),
            )
        )
    return result


def law_setup(scenario: Scenario, ready: Model, timing: Schedule, weight: Int, start: Float) -> LawSetup | None:
    """The law of a scenario's links; None for springs, which the kernels have built in, but for those with a codec.

    Args:
        scenario: what was asked for.
        ready: the body.
        timing: of the run.
        weight: of every slot, (slots,).
        start: initial displacements, (users, n, d) [m].

    Raises:
        ScenarioError: the law cannot have this channel, or these weights.
        NetworkError: there is no such law, or a parameter is out of range.
    """
    law, given = given_law(scenario)
    check_codec(scenario, ready, law, weight)
    if law.name == "spring" and scenario.channel.codec is None:
        return None
    if law.constant_delay and timing.mode != "constant":
        _check_constant(scenario, law, timing)
    operator = ready.operator
    if any(np.any(operator.mix[WEIGHTS + w]) for w in weight):
        raise ScenarioError(
            f'synchronisation.law is "{law.name}", but a link\'s weight couples nodes or axes, which only law "spring" '
            "can do"
        )
    ends = facts_of(scenario, ready, timing, weight)
    parameters = [law.values(facts, given) for facts in ends]
    diagonal = np.repeat(operator.weight[weight], ready.width, axis=1)
    held = 0.0
    if law.springs:
        fields = np.array([ready.to_rows(field).ravel() for field in start])
        apart = fields[timing.slots.receiver] - fields[timing.slots.sender]
        springs = np.array([facts.spring for facts in ends])
        held = 0.25 * float(springs @ (diagonal * apart**2).sum(axis=1))  # each link has two slots
    return LawSetup(
        law=law,
        parameters=np.array(parameters, dtype=np.float64).reshape(weight.size, len(law.parameters)),
        weight=diagonal,
        holds=law.holds is None or all(law.holds(*end) for end in zip(ends, parameters, strict=True)),
        initial_energy=held + sum(law.initial_energy_of(values) for values in parameters),
    )


def _check_constant(scenario: Scenario, law: Law, timing: Schedule) -> None:
    """Refuses a law that needs samples of a constant age where only an index would make them so."""
    if not certain(scenario.channel) or timing.mode != "freshest":
        varies = "the channel's varies; take jitter and losses out"
    elif not np.ptp(timing.length):
        return
    else:
        varies = "with steps of different lengths ages vary; give all the same period"
    raise ScenarioError(
        f'synchronisation.law is "{law.name}", which needs a constant delay, but {varies}, or use mode "constant", '
        "whose index delay covers that"
    )


def ends_of(setup: LawSetup, timing: Schedule, fields: Fields, mean: Float, copies: int) -> Ends:
    """Ends for the batch engine; y of the slots is the last part of the samples.

    Args:
        setup: the law and its parameters.
        timing: the schedule.
        fields: state of all copies.
        mean: weights' mean.
        copies: how many.
    """
    law, slots = setup.law, timing.slots
    count, (users, rows, width) = slots.link.size, fields.position.shape
    size = rows * width
    first = fields.samples.shape[0] - count
    before, after = law.parts
    push = np.zeros((count, rows, width))
    letters = timing.ring + 1
    return Ends(
        before=before,
        after=after,
        copies=copies,
        feels=law.feels,
        reverse=np.array([slots.pairs.index((j, i)) for i, j in slots.pairs], dtype=np.int32),
        parameters=setup.parameters,
        weight=setup.weight,
        used=np.full(count, -1, dtype=np.int32),
        steps=np.zeros(users, dtype=np.int32),
        position=fields.position.reshape(users, size),
        velocity=fields.velocity.reshape(users, size),
        mean=mean.reshape(size),
        samples=fields.samples.reshape(-1, size),
        hand=np.zeros((users, size if law.feels else 0)),
        touch=np.zeros((users, size if law.feels else 0)),
        mail=np.zeros((count, letters, len(law.sends), size)),
        mail_scalars=np.zeros((count, letters, len(law.sends_scalars))),
        memory=np.zeros((count, len(law.keeps), size)),
        scalars=np.zeros((count, len(law.keeps_scalars))),
        shared=np.zeros((users, len(law.shares), size)),
        shared_scalars=np.zeros((users, len(law.shares_scalars))),
        first=first,
        slot=np.arange(first, first + count),
        push=push.reshape(count, size),
        push_rows=push,
        gains=np.zeros((count, 2)),
        stiffness=np.zeros(count),
        brake=np.zeros(count),
        words=np.zeros((count, END_WORDS), dtype=np.int64),
    )
