"""A run as an `xarray.Dataset`: labelled, with units, with its scenario, ready for NetCDF."""

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from cotouch.arrays import Array, Float
from cotouch.body import cut_away
from cotouch.errors import ScenarioError
from cotouch.files import write_netcdf
from cotouch.interrupt import interruptible
from cotouch.scenario import Scenario
from cotouch.simulation._batch import Outcome
from cotouch.simulation._law_setup import given_law
from cotouch.simulation._layout import (
    CLOSED_LEDGER,
    CUT_LEDGER,
    TICK_RESIDUAL,
    TICK_STORED,
    TOOL_LEDGER,
    USER_LEDGER,
    WORLD_LEDGER,
    Record,
)
from cotouch.simulation._outcome import run_prepared
from cotouch.simulation._prepare import Prepared, prepare
from cotouch.simulation._rigid_tool_result import UNITS as RIGID_TOOL_UNITS
from cotouch.simulation._rigid_tool_result import masses_of, rigid_tool_variables
from cotouch.simulation._schedule import Schedule
from cotouch.simulation._tool_result import LEAST_ENERGY, leading_variables, tool_attributes, tool_variables
from cotouch.simulation._tool_result import UNITS as TOOL_UNITS

if TYPE_CHECKING:
    import xarray as xr


_AXES = ("x", "y", "z")
_UNITS = {
    "time": ("s", "end of the step, on a clock that all users share"),
    "period": ("s", "length T of the step: the time that the copy simulates in it"),
    "position": ("m", "position x of a node"),
    "velocity": ("m/s", "velocity v of a node"),
    "force": (
        "N",
        "sum of the mean forces of a user's hands and tools on the object over the step, or of hands on rigid tools",
    ),
    "hand_force": ("N", "mean force of a hand over the step"),
    "supplied": ("J", "work of a user's hands so far"),
    "body_loss": ("J", "dissipated so far by the body's own dampers, at obstacles and between bodies"),
    "local_loss": ("J", "dissipated so far by the damping B_i of the synchronisation"),
    "extra_loss": ("J", "dissipated so far by the extra damping B_e"),
    "kinetic": ("J", "kinetic energy of the copy"),
    "elastic": ("J", "energy of the copy's deformation and weight, at obstacles and between bodies"),
    "iterations": ("1", "iterations of the solver in the step; 0 if the solution is a closed form"),
    "closure": (
        "J",
        "work so far, on the copy's velocity, of the scale that closes a step's balance; small if the forces are right",
    ),
    "closure_factor": ("1", "largest change so far of the end velocity by that scale, |beta - 1|"),
    "closure_alarms": ("1", "steps so far with a change above 0.01, or that had to be shortened"),
    "world_loss": ("J", "of body_loss: lost so far in friction and damping at obstacles and between bodies"),
    "world_stored": ("J", "of elastic: held by obstacles and between bodies"),
    "world_force": ("N", "mean force of obstacles on the copy over the step"),
    "cut": ("J", "energy lost so far with the elements that were cut"),
    "cut_elements": ("1", "elements of the copy that were cut so far"),
    "cut_time": ("s", "when the copy lost the element; NaN: it is whole"),
    "debris_time": (
        "s",
        "when the copy's node lost its last element and came to rest; NaN: it still has one, or never had",
    ),
    "cut_by": ("1", "number of the user who decided to cut the element, from 1; 0: it is whole"),
    "link_work": ("J", "work of the link on its receiver so far"),
    "delay_work": (
        "J",
        "energy added to the link so far by the age of samples; with a law other than springs: all work of the link",
    ),
    "age": ("s", "age of the sample used, from the middle of its step to the end of the step that uses it"),
    "link_energy": ("J", "energy of the spring between two copies"),
    "stored": ("J", "energy of all copies and links"),
    "supplied_total": ("J", "work of all hands so far"),
    "dissipated_total": ("J", "dissipated so far by all dampers, and lost with what was cut"),
    "delay_work_total": ("J", "energy added so far by the age of samples"),
    "residual": ("J", "stored - initial - supplied + dissipated - delay work: zero except for round-off"),
    "slack": (
        "J",
        "lost so far in the damping B_i, less what the age of samples added: the slack of inequality (7)",
    ),
    "tick_time": ("s", "time of the network-wide records"),
    "local_damping": ("N s/m", "damping B_i of the synchronisation, as multiples of each link weight"),
    "frame_position": ("m", "position x of every node at the time of a frame"),
    **TOOL_UNITS,
    **{f"rigid_{name}": unit for name, unit in TOOL_UNITS.items()},
    **RIGID_TOOL_UNITS,
}


@interruptible
def simulate(scenario: "Scenario | str | Path | Mapping[str, Any]") -> "xr.Dataset":
    """Runs a scenario.

    Args:
        scenario: a `Scenario`, a path of a TOML file, or a mapping of tables.

    Returns:
        Dimensions `user`, `step` (a user's own steps; 0 is the initial state; NaN after its last), `node`, `axis`,
        `hand`, `tool`, `direction` (a receiver's view of a neighbour, "1<-2"), `link`, `tick` (network-wide records),
        `weight`, and `frame` with `node_all` where whole copies are asked for. Coordinates beside them: `time` of every
        user's steps and `tick_time`; the users' names as `receiver` and `sender` of a direction, `one` and `other` of a
        link, `hand_user` and `tool_user`. `tables` makes data frames of it. Every variable has its unit in `attrs`;
        the dataset's `attrs` hold the scenario as JSON, the energy residual relative to the energy in play, and the
        passivity margin [J].

    Raises:
        InputError: something in the scenario is wrong.

    Examples:
        >>> run = simulate({
        ...     "network": {"users": ["Ann", "Ben"], "spring": [[0, 50], [50, 0]], "delay": [[0, 0.05], [0.05, 0]]},
        ...     "steps": {"duration": 1.0},
        ...     "hands": [{"user": 1, "path": 0.1}],
        ... })
        >>> run.attrs["energy_residual"] < 1e-10
        True
    """
    if isinstance(scenario, str | Path):
        scenario = Scenario.read(scenario)
    elif not isinstance(scenario, Scenario):
        if not isinstance(scenario, Mapping):  # pyright: ignore[reportUnnecessaryIsInstance]
            raise ScenarioError(f"scenario is {scenario!r}; it must be a Scenario, a path or a mapping of tables")
        scenario = Scenario.make(**{str(name): table for name, table in scenario.items()})
    prepared = prepare(scenario)
    return dataset(prepared, run_prepared(prepared))


# What was not reached was never written, and a run that diverges overflows: neither is worth a warning here.
@np.errstate(over="ignore", invalid="ignore")
def dataset(prepared: Prepared, outcome: Outcome) -> "xr.Dataset":
    """Labels what a run recorded.

    Args:
        prepared: what was run.
        outcome: what it recorded.
    """
    from cotouch.simulation._run import Run  # which imports xarray

    scenario, timing, record, body = prepared.scenario, prepared.schedule, outcome.record, prepared.body
    network, every = scenario.network, record.every
    _, users, records = record.users.shape
    # Entry r of user i exists once step r * every is taken; what was not reached is NaN.
    taken = outcome.taken // every
    gaps = bool((taken < records - 1).any())
    everyone = np.arange(int(users))
    data: dict[str, tuple[tuple[str, ...], Array]] = {}

    def put(name: str, dims: tuple[str, ...], values: Array, owner: Array | None = None) -> None:
        if owner is not None and gaps and "step" in dims:
            values = np.array(values)
            values[np.arange(records)[None, :] > taken[owner, None]] = np.nan
        data[name] = (dims, values)

    axes = body.dimension
    for name, values in (("position", record.position), ("velocity", record.velocity)):
        own = values[:, :, : values.shape[2] - masses_of(prepared)]  # those of tools are behind
        shaped = own.reshape(users, records, prepared.nodes.size, -1)[..., :axes]
        if name == "position" and np.any(body.rest):
            shaped = shaped + body.held_rest[prepared.nodes]
        put(name, ("user", "step", "node", "axis"), shaped, everyone)
    ledger = USER_LEDGER if prepared.touching is None else USER_LEDGER + TOOL_LEDGER
    ledger = ledger if prepared.model.force is None else ledger + CLOSED_LEDGER
    if prepared.model.force is not None and prepared.model.force.world is not None:
        own = record.users[len(ledger) :]
        for name, values in zip(WORLD_LEDGER[:2], own, strict=False):
            put(name, ("user", "step"), values, everyone)
        put("world_force", ("user", "step", "axis"), np.moveaxis(own[2:5], 0, -1), everyone)
    if outcome.cuts is not None:
        for name, values in zip(CUT_LEDGER, record.users[-len(CUT_LEDGER) :], strict=True):
            put(name, ("user", "step"), values, everyone)
        after, by = np.moveaxis(outcome.cuts, 1, 0)
        known = np.take_along_axis(timing.end, np.maximum(after.astype(np.int64) - 1, 0), axis=1)
        when = np.where(after > 0.0, known, np.inf)
        put("cut_time", ("user", "element"), np.where(np.isinf(when), np.nan, when))
        alone = np.full((int(users), max(body.held_rest.shape[0], body.nodes)), np.inf)
        alone[:, : body.nodes] = [cut_away(body, own) for own in when]
        put("debris_time", ("user", "node"), np.where(np.isinf(alone), np.nan, alone)[:, prepared.nodes])
        put("cut_by", ("user", "element"), by.astype(np.int32))
    for name, values in zip(ledger, record.users, strict=False):
        put(name, ("user", "step"), values, everyone)
    time, period = (
        np.pad(kept[:, every - 1 :: every][:, : records - 1], ((0, 0), (1, 0)), constant_values=first)
        for kept, first in ((timing.end, 0.0), (timing.length, np.nan))
    )
    put("time", ("user", "step"), time, everyone)
    put("period", ("user", "step"), period, everyone)

    hand_force = hand_forces(prepared, record.force, axes)
    force = np.zeros((users, records, axes))
    for index, hand in enumerate(scenario.hands):
        force[hand.user - 1] += hand_force[index]
    holders = np.array([hand.user - 1 for hand in scenario.hands], dtype=np.int64)
    put("hand_force", ("hand", "step", "axis"), hand_force, holders)
    tools, leading = tool_variables(prepared, outcome), leading_variables(prepared, outcome)
    rigid = rigid_tool_variables(prepared, record, period)
    owners = np.array([tool.user - 1 for tool in scenario.proxies], dtype=np.int64)
    movers = np.array([tool.user for tool in prepared.rigid_tools], dtype=np.int64)
    for variables, whose in ((tools, owners), (rigid | leading, movers)):
        for name, (dims, values) in variables.items():
            put(name, dims, values, whose)
    for index, owner in enumerate(owners):
        force[owner] -= tools["touch_force"][1][index]
    for index, owner in enumerate(movers):
        force[owner] += rigid["rigid_force"][1][index]
    put("force", ("user", "step", "axis"), force, everyone)

    slots = timing.slots
    put("link_work", ("direction", "step"), record.slots[0], slots.receiver)
    put("delay_work", ("direction", "step"), record.slots[1], slots.receiver)
    age = np.empty((slots.link.size, records))
    age[:, 0] = np.nan
    if every == 1:
        timing.ages_into(age[:, 1:])
    else:
        age[:, 1:] = timing.age[:, every - 1 :: every][:, : records - 1]
    put("age", ("direction", "step"), age, slots.receiver)

    ticks = int(taken[timing.reference]) + 1
    put("link_energy", ("tick", "link"), record.links[:ticks])
    totals = ("stored", "supplied_total", "dissipated_total", "delay_work_total", "residual", "slack")
    for name, values in zip(totals, record.ticks, strict=True):
        put(name, ("tick",), values[:ticks])
    put("tick_time", ("tick",), time[timing.reference, :ticks].copy())
    put("local_damping", ("user", "weight"), prepared.local_damping)
    if outcome.frame_time.size:
        shown = np.array([[prepared.model.to_nodes(copy) for copy in frame] for frame in outcome.frames])
        put("frame_position", ("frame", "user", "node_all", "axis"), (shown + body.rest).astype(np.float32))
    labelled = {
        name: (dims, values, {"units": _UNITS[name][0], "long_name": _UNITS[name][1]})
        for name, (dims, values) in data.items()
    }

    names = [f"{i + 1}<-{j + 1}" for i, j in slots.pairs]
    return Run(
        labelled,
        coords={
            "user": list(network.users),
            "node": prepared.nodes.astype(np.int64) + 1,
            "axis": list(_AXES[:axes]),
            "direction": np.array(names, dtype=np.str_),
            "link": np.array([f"{a + 1}-{b + 1}" for a, b in network.links], dtype=np.str_),
            "hand": np.arange(1, len(scenario.hands) + 1),
            "weight": np.arange(prepared.local_damping.shape[1]),
            "receiver": ("direction", [network.users[i] for i in slots.receiver]),
            "sender": ("direction", [network.users[j] for j in slots.sender]),
            "one": ("link", [network.users[a] for a, _ in network.links]),
            "other": ("link", [network.users[b] for _, b in network.links]),
            "hand_user": ("hand", [network.users[i] for i in holders]),
            **({"tool": np.arange(1, owners.size + 1)} if owners.size else {}),
            **({"tool_user": ("tool", [network.users[i] for i in owners])} if owners.size else {}),
            **({"rigid_tool": np.arange(1, movers.size + 1)} if movers.size else {}),
            **({"rigid_tool_user": ("rigid_tool", [network.users[i] for i in movers])} if movers.size else {}),
            **({"frame": outcome.frame_time} if outcome.frame_time.size else {}),
        },
        attrs={**_attributes(prepared, outcome, ticks), **tool_attributes(tools | leading)},
    ).set_coords(["time", "tick_time"])


def hand_forces(prepared: Prepared, force: Float, axes: int) -> Float:
    """Force of every hand, (hands, records, axes) [N]; no copy where each port is a hand's.

    Args:
        prepared: what was run.
        force: of the ports, (ports, records, width) [N].
        axes: of a hand with one port.
    """
    ports = prepared.ports
    if ports.shape[1] > 1:
        return np.ascontiguousarray(force[ports, :, 0].transpose(0, 2, 1))
    own = ports[:, 0]
    return force[..., :axes] if np.array_equal(own, np.arange(int(force.shape[0]))) else force[own, :, :axes]


def _attributes(prepared: Prepared, outcome: Outcome, ticks: int) -> dict[str, object]:
    from cotouch.version import __version__

    ledger = outcome.record.ticks[:, :ticks]
    timing, scenario = prepared.schedule, prepared.scenario
    in_play, residual = _in_play(outcome.record, ledger), _largest(ledger[TICK_RESIDUAL])
    finished = outcome.events == timing.order.size
    return {
        "title": scenario.title or "cotouch run",
        "source": f"cotouch {__version__}",
        "scenario": scenario.as_json(),
        "mode": timing.mode,
        "seed": scenario.seed,
        "basis": prepared.model.basis,
        "steps": int(timing.count.max()) if finished else int(outcome.taken.max()),
        "finished": int(finished),
        "energy_in_play": in_play,
        "energy_residual": residual / max(in_play, LEAST_ENERGY),
        # What a law's ends may make is there from the start, as what springs hold is.
        "passivity_margin": float(outcome.record.lowest[0] + _had(outcome.record))
        + (0.0 if prepared.law is None else prepared.law.initial_energy),
        **_judged(prepared, outcome),
        **_paces(timing),
        "underruns": int(timing.underruns.sum()),
        "messages": sum(draws.first.size for draws in timing.draws),
        "messages_lost": sum(int(np.isinf(draws.first).sum()) for draws in timing.draws),
        **_traffic(outcome),
        "index_delay": [] if timing.index_delay is None else [int(n) for n in timing.index_delay.ravel()],
    }


def _traffic(outcome: Outcome) -> dict[str, int]:
    """Samples that senders said in full and in one byte, and bytes of both without headers; nothing without a codec."""
    said = outcome.traffic
    if said is None:
        return {}
    return {name: int(getattr(said, name).sum()) for name in ("contents", "unchanged")} | {
        "content_bytes": int(said.size.sum())
    }


def _had(record: Record) -> float:
    """Energy that was there to be taken out: that of the start, and what weight and attraction gave below that [J]."""
    return float(record.ticks[TICK_STORED, 0] - record.lowest[1:].sum())


def _judged(prepared: Prepared, outcome: Outcome) -> dict[str, object]:
    """What the links made of their own, beside what their law promises; all worked out by the kernels [J].

    `made` is the most that links less the damping B_i had put into the copies, `extracted` the most that hands and
    tools had got out beyond what there was in the beginning.
    """
    wish, timing, record = prepared.scenario.synchronisation, prepared.schedule, outcome.record
    law, _ = given_law(prepared.scenario)
    covered = (wish.damping is None or isinstance(wish.damping, str)) and wish.damping_scale >= 1.0
    covered = covered and wish.quantile in {None, 1.0} and not timing.underruns.any()
    covered = covered or (law.rule == 0.0 and not (law.constant_delay and timing.underruns.any()))
    promised = law.passive and covered and (prepared.law is None or prepared.law.holds)
    seed = prepared.law.initial_energy if prepared.law is not None else float(record.links[0].sum())
    return {
        "law": law.name,
        "law_promises": int(promised),
        "law_initial_energy": seed,
        "made": float(record.made[0]),
        "made_at_end": float(record.made[1]),
        "extracted": max(-float(record.lowest[0] + _had(record)), 0.0),
    }


def _paces(timing: Schedule) -> dict[str, list[float]]:
    """How often every user steps, as asked and as it comes to with waiting [Hz], and how late its copy is [s]."""
    users = range(timing.count.size)
    asked = [float(n / timing.nominal[i, :n].sum()) for i, n in zip(users, timing.count, strict=True)]
    taken = [float(n / timing.end[i, n - 1]) for i, n in zip(users, timing.count, strict=True)]
    return {"rate_asked": asked, "rate": taken, "behind": timing.behind.tolist()}


def _in_play(record: Record, ledger: Float) -> float:
    """The most energy that was stored, supplied or dissipated at any time of a run [J].

    A falling body gains as much kinetic energy as its weight loses: the sum says nothing of what is at stake.
    """
    return max(_largest(ledger[:4]), -float(record.lowest[1:].sum()))


def _largest(values: Float) -> float:
    """Largest magnitude, without a temporary array of them."""
    return max(float(values.max(initial=0.0)), -float(values.min(initial=0.0)))


def save(run: "xr.Dataset", path: str | Path) -> None:
    """Writes a run to a NetCDF 4 file, compressed, whole or not at all; the same run gives the same bytes.

    Args:
        run: a result of `simulate`.
        path: ends in ".nc", ".nc4", ".h5" or ".hdf5".

    Raises:
        OutputError: the file cannot be written, or its name does not end in ".nc", ".nc4", ".h5" or ".hdf5".
    """
    write_netcdf(run, path, "result")
