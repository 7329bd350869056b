"""From a scenario to the arrays that the engines work on."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Literal, final

import numpy as np

from cotouch.arrays import Float, Int
from cotouch.body import Body
from cotouch.errors import ScenarioError
from cotouch.interaction import Hands, Leading, Touching
from cotouch.mechanics import Model, model
from cotouch.network import damping_for
from cotouch.scenario import (
    HandTable,
    RigidTool,
    Scenario,
    leading_of,
    per_user,
    ports_of,
    refusing,
    touching_of,
    with_tools,
)
from cotouch.simulation._coding import age_budget, codec_damping
from cotouch.simulation._law_setup import LawSetup, given_law, law_setup
from cotouch.simulation._layout import Topology
from cotouch.simulation._memory import free_memory, needed, refuse_beyond
from cotouch.simulation._schedule import Schedule, schedule

# Up to this many nodes all of them are recorded unless a scenario says otherwise.
_ALL_NODES = 64


@final
@dataclass(frozen=True, kw_only=True, eq=False)
class Prepared:
    """Everything a run needs.

    Attributes:
        scenario: what was asked for.
        body: the shared object.
        model: the body in the kernels' form.
        schedule: the timing.
        topology: slots for the kernels.
        hands: ports for the kernels; a hand has one port, or one for each axis in the full form.
        ports: ports of each hand, (hands, ports per hand).
        local_damping: B_i as coefficients over the weights, (users, weights) [Ns/m].
        extra_damping: B_e likewise.
        position: initial displacements, (users, n, d) [m].
        velocity: initial velocities, (users, n, d) [m/s].
        nodes: recorded nodes.
        touching: the tools as they start; an engine works on a copy. None without tools.
        tool: which of those tools is each of the scenario's proxies.
        rigid_tools: those that are rigid bodies; the ports of `hands` hold them, too.
        leading: devices that lead these, as they start; an engine works on a copy. None without.
        led: its row of each of `rigid_tools`.
        law: of the links; None for springs, which the kernels have built in.
    """

    scenario: Scenario
    body: Body
    model: Model
    schedule: Schedule
    topology: Topology
    hands: Hands
    ports: Int
    local_damping: Float
    extra_damping: Float
    position: Float
    velocity: Float
    nodes: Int
    touching: Touching | None
    tool: list[int]
    rigid_tools: list[RigidTool]
    leading: Leading | None
    led: list[int]
    law: LawSetup | None = None


def prepare(scenario: Scenario) -> Prepared:
    """Checks what only network and body together can tell, and builds the arrays.

    Raises:
        ScenarioError: a hand, an initial state or an option does not fit network or body.
        BodyError: the body is wrong, or a link weight does not fit it.
        UnsupportedError: a damping method that cannot do this network or timing.
    """
    with scenario.naming():
        return _prepared(scenario.placed())


def _prepared(scenario: Scenario) -> Prepared:
    network = scenario.network
    body = scenario.build_body()
    ready = model(
        body,
        copies=network.size,
        weights=network.weights,
        basis=_basis(scenario, body),
        obstacles=scenario.world.obstacles(),
        between=scenario.between.made(),
    )
    nodes = _recorded(scenario, body)
    refuse_beyond(needed(scenario, body, ready, nodes.size), free_memory())
    timing = schedule(scenario)
    if scenario.record.every > timing.count.max():
        raise ScenarioError(
            f"record.every is {scenario.record.every}, but the run has {timing.count.max()} steps; make it less"
        )
    slots = timing.slots
    strength = network.spring[slots.receiver, slots.sender]
    weight = network.weight_of[slots.receiver, slots.sender] + 1  # weight 0 of the kernels is the identity
    topology = Topology(
        first=slots.first,
        peer=slots.sender,
        strength=np.ascontiguousarray(strength, dtype=np.float64),
        weight=weight.astype(np.int32),
        ends=np.array(network.links, dtype=np.int32).reshape(-1, 2),
        slot=np.array([int(np.flatnonzero(slots.link == k)[0]) for k in range(len(network.links))], dtype=np.int32),
    )
    hands, ports = ports_of(scenario.hands, network.size, body, ready)
    rigid_tools: list[RigidTool] = []
    if scenario.rigid_tools:
        hands, ports, rigid_tools = with_tools(hands, ports, scenario.rigid_tools, ready, devices=True)
    leading, led = leading_of(scenario.rigid_tools, rigid_tools, ready, timing.length)
    position = _initial(scenario.initial.position, "position", network.size, body)
    scenario.world.refuse_overlap(ready, position)
    scenario.refuse_cutters()
    touching, tool = touching_of(
        scenario.proxies,
        network.size,
        body,
        ready,
        timing.length,
        start=position,
        contact=scenario.contact,
        numbers=scenario.proxy_numbers,
    )
    extra = np.zeros((network.size, 1 + len(network.weights)))
    extra[:, 0] = per_user(scenario.synchronisation.extra_damping, network.size, "synchronisation.extra_damping")
    return Prepared(
        scenario=scenario,
        body=body,
        model=ready,
        schedule=timing,
        topology=topology,
        hands=hands,
        ports=ports,
        local_damping=_local_damping(scenario, timing),
        extra_damping=extra,
        position=position,
        velocity=_initial(scenario.initial.velocity, "velocity", network.size, body),
        nodes=nodes,
        touching=touching,
        tool=tool,
        rigid_tools=rigid_tools,
        leading=leading,
        led=led,
        law=law_setup(scenario, ready, timing, topology.weight, position),
    )


def _basis(scenario: Scenario, body: Body) -> Literal["auto", "nodal", "modal"]:
    """Nodes for a law that looks at hands: in the modal basis, and of a truncated body, a hand is in every row."""
    asked = scenario.solver.basis
    felt = given_law(scenario)[0].feels and body.truncation is None
    return "nodal" if asked == "auto" and felt else asked


def with_hands(prepared: Prepared, hands: Sequence[Mapping[str, object]]) -> Prepared:
    """The same run with other hands: body, schedule and channel are not worked out again.

    Args:
        prepared: without tools, whose room for hands is their own.
        hands: tables, each with a node.

    Raises:
        ScenarioError: a hand does not fit network or body, or there are tools.
    """
    if prepared.touching is not None or prepared.rigid_tools:
        raise ScenarioError("there are tools; hands of a prepared run can be changed only without them")
    with refusing("the hands"):
        tables = [HandTable.model_validate(table) for table in hands]
    scenario = prepared.scenario.model_copy(update={"hands": tables})
    body = prepared.body
    ports, of_hand = ports_of(scenario.hands, scenario.network.size, body, prepared.model)
    return replace(prepared, scenario=scenario, hands=ports, ports=of_hand, nodes=_recorded(scenario, body))


def with_law(prepared: Prepared, law: str | Mapping[str, object]) -> Prepared:
    """The same run with another link law: body, schedule and channel are not worked out again.

    Args:
        prepared: the run.
        law: as in `[synchronisation]`.

    Raises:
        ScenarioError: the law cannot have this channel, or these weights.
        NetworkError: there is no such law, or a parameter is out of range.
    """
    scenario, timing = prepared.scenario.replace(synchronisation__law=law), prepared.schedule
    return replace(
        prepared,
        scenario=scenario,
        local_damping=_local_damping(scenario, timing),
        law=law_setup(scenario, prepared.model, timing, prepared.topology.weight, prepared.position),
    )


def _local_damping(scenario: Scenario, timing: Schedule) -> Float:
    """B_i over (identity, *network.weights), (users, 1 + weights)."""
    network, asked = scenario.network, scenario.synchronisation
    law, _ = given_law(scenario)
    method = "rule" if asked.damping is None else asked.damping
    if not isinstance(method, str):
        result = np.zeros((network.size, 1 + len(network.weights)))
        # A plain number is a multiple of the links' own weight where they share one, else of the identity.
        own = 1 if network.weights and all(network.weight_of[a, b] == 0 for a, b in network.links) else 0
        result[:, own] = per_user(method, network.size, "synchronisation.damping")
        return result * asked.damping_scale
    if method == "exact" and not (timing.mode == "constant" and not np.ptp(timing.length)):
        raise ScenarioError(
            'synchronisation.damping is "exact", which covers only mode "constant" with one constant step length '
            'for all; use "rule" or "minimax"'
        )
    if timing.index_delay is None:
        budget = age_budget(scenario, timing, law, 1.0 if asked.quantile is None else asked.quantile)
        coefficients = damping_for(network, method, ages=budget)
    else:
        coefficients = damping_for(network, method, index_delay=timing.index_delay, periods=timing.longest())
    if asked.damping is None:
        coefficients = coefficients * law.rule
        coefficients[:, 0] += law.drag
    if law.rule > 0.0:
        coefficients = coefficients + codec_damping(scenario)
    return np.ascontiguousarray(coefficients) * asked.damping_scale


def _initial(given: list[object] | None, name: str, users: int, body: Body) -> Float:
    """Initial field of every user, (users, n, d)."""
    result = np.zeros((users, body.nodes, body.dimension))
    shared = body.shared
    if given is None:
        return result
    if len(given) != users:
        raise ScenarioError(f"initial.{name} has {len(given)} entries; the network has {users} users")
    for i, entry in enumerate(given):
        try:
            field = np.asarray(entry, dtype=np.float64)
            result[i, :shared] = field[:, None] if field.shape == (shared,) and body.dimension == 1 else field
        except (TypeError, ValueError):
            raise ScenarioError(
                f"initial.{name}[{i + 1}] is {str(entry)[:60]}; it must be a number, {body.dimension} numbers, or "
                f"{shared} rows of {body.dimension}"
            ) from None
    if not np.isfinite(result).all():
        raise ScenarioError(f"initial.{name} must hold finite numbers only")
    return result


def _recorded(scenario: Scenario, body: Body) -> Int:
    asked = scenario.record.nodes
    if asked == "all" or (asked is None and body.nodes <= _ALL_NODES and not body.rigid):
        return np.arange(body.shared, dtype=np.int32)
    if asked is None:
        held = {hand.node for hand in scenario.hands}
        for tool in scenario.proxies:
            held.add(1 + int(np.argmin(np.linalg.norm(body.rest[: body.shared] - np.array(tool.at), axis=1))))
        held |= set(range(1, body.shared + 1)) if body.rigid else set() if held else {1}
        return np.array(sorted(held), dtype=np.int32) - 1
    for number in asked:
        if number > body.holds:
            raise ScenarioError(f"record.nodes names node {number}; the body has nodes 1 to {body.shared}")
    return np.array(sorted(set(asked)), dtype=np.int32) - 1
