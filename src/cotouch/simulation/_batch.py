"""Running a prepared scenario with the batch engine."""

from copy import deepcopy
from dataclasses import dataclass
from itertools import pairwise
from typing import final

import numpy as np

from cotouch.arrays import Float, Int, Long
from cotouch.errors import ScenarioError
from cotouch.interaction import ToolRecord, Touching, tool_record, tools_of
from cotouch.interrupt import check, flag
from cotouch.mechanics import BLADE, LEDGER_COLUMNS, Links, State, cutting_of, idle_ports, own_ports, unsettled
from cotouch.passing import Each
from cotouch.simulation._ends import Ends
from cotouch.simulation._engine import run
from cotouch.simulation._law_setup import ends_of
from cotouch.simulation._layout import (
    CLOSED_LEDGER,
    CUT_LEDGER,
    SLOT_LEDGER,
    TICK_LEDGER,
    TOOL_LEDGER,
    USER_LEDGER,
    WORLD_LEDGER,
    Copies,
    Fields,
    Frames,
    Record,
    Scratch,
    Timing,
)
from cotouch.simulation._prepare import Prepared
from cotouch.simulation._rigid_tool_result import with_masses


@final
@dataclass(frozen=True, kw_only=True, eq=False)
class CodecTraffic:
    """What senders with a codec said, of each slot.

    Attributes:
        contents: samples said in full, (slots,).
        unchanged: samples said in one byte, (slots,).
        size: of all of them, without headers, (slots,) [bytes].
    """

    contents: Long
    unchanged: Long
    size: Long


@final
@dataclass(frozen=True, kw_only=True, eq=False)
class Outcome:
    """What a run left behind.

    Attributes:
        record: what was recorded; entry r is the state after step `r * every`.
        position: of every user at the end, in the model's rows, (users, rows, width) [m].
        velocity: likewise [m/s].
        events: how many steps were taken in all; fewer than scheduled if the motion left floating point.
        taken: steps taken and recorded by each user, (users,).
        tools: what was recorded of tools; None without them.
        frames: whole copies, (frames, users, rows, width) [m].
        frame_time: of the frames that were reached, (frames,) [s].
        ends: what the ends of the links came to keep; None where all links are springs, or ran message by message.
        traffic: what senders said; None without a codec.
        cuts: `marks_of` the copies; None of a body that cannot be cut.
        led: what was recorded of devices that lead rigid tools; None without.
    """

    record: Record
    position: Float
    velocity: Float
    events: int
    taken: Int
    tools: ToolRecord | None
    frames: Float
    frame_time: Float
    ends: Ends | None = None
    traffic: CodecTraffic | None = None
    cuts: Float | None = None
    led: ToolRecord | None = None


def marks_of(memory: Float, first: int, elements: int) -> Float:
    """After which step each copy lost an element, from 1, and who decided it, from 1; 0 of those that are whole.

    Args:
        memory: of all copies, (users, numbers).
        first: where the marks begin.
        elements: how many there are.

    Returns:
        (users, 2, elements).
    """
    return memory[:, first : first + 2 * elements].reshape(memory.shape[0], 2, elements)


def run_batch(prepared: Prepared) -> Outcome:
    """Runs all users in one compiled loop.

    Raises:
        KeyboardInterrupt: it was interrupted; see `cotouch.interrupt.interruptible`.
        ScenarioError: the links' law asks for what no link can be, or there is a codec.
    """
    if prepared.scenario.channel.codec is not None:
        raise ScenarioError(
            "channel.codec is given, and what senders say with it depends on the motion, which the batch engine does "
            "not know beforehand; use run_prepared, which runs it message by message"
        )
    ready, timing, hands = prepared.model, prepared.schedule, prepared.hands
    users, rows, width = timing.count.size, ready.operator_rows, ready.width
    slots = timing.slots.link.size
    position = np.stack([ready.to_rows(field) for field in prepared.position])
    fields = Fields(
        position=position,
        velocity=np.stack([ready.to_rows(field) for field in prepared.velocity]),
        momentum=np.zeros((users, rows, width)),
        tension=np.zeros((users, rows, width)),
        memory=np.stack([unsettled(ready, user) for user in range(users)]),
        samples=np.zeros((users * timing.ring + users + (0 if prepared.law is None else slots), rows, width)),
    )
    touching = deepcopy(prepared.touching)
    asked = prepared.scenario.cutting
    may = () if asked is None else [asked.may(user + 1) for user in range(users)]
    cutting = cutting_of(ready, tools=0 if touching is None else touching.kind.size, decides=may)
    books = (0 if touching is None else len(TOOL_LEDGER)) + (0 if cutting is None else len(CUT_LEDGER))
    record = record_of(prepared, books)
    records = record.ticks.shape[1]
    # A copy with tools that are bodies knows of contact by a law only where some tool may touch or hold.
    only_blades = bool(ready.body.tools) and touching is not None and bool(np.all(touching.kind == BLADE))
    leading = deepcopy(prepared.leading)
    tools = None if touching is None else tool_record(touching.kind.size, records)
    led = None if leading is None else tool_record(leading.touching.kind.size, records)
    wanted = prepared.scenario.record.frames
    moments = np.zeros(0) if wanted is None else np.arange(0.0, prepared.scenario.steps.duration, 1.0 / wanted)
    frames = Frames(moments, np.zeros((moments.size, users, rows, width)), np.zeros(1, dtype=np.int32))
    counter = np.zeros(users, dtype=np.int32)
    scratch = Scratch(
        ports=idle_ports(hands.row, hands.shape, width),
        work=ready.workspace(int(np.diff(hands.first).max(initial=0))),
        ledger=np.zeros(LEDGER_COLUMNS),
        link_work=np.zeros(slots),
        slot=np.zeros(slots, dtype=np.int64),
        counter=counter,
        cursor=hands.path_first[:-1].copy(),
        slot_running=np.zeros((slots, 2)),
        difference=np.zeros((rows, width)),
        product=np.zeros((rows, width)),
    )
    law = prepared.law
    ends = None if law is None else ends_of(law, timing, fields, scratch.work.mean, users)
    solver = prepared.scenario.solver
    events = run(
        ready.operator,
        ready.force,
        prepared.topology,
        Timing(
            order=timing.order,
            end=timing.end,
            length=timing.length,
            used=timing.used,
            ring=timing.ring,
            reference=timing.reference,
            stop=flag(),
        ),
        hands,
        prepared.local_damping,
        prepared.extra_damping,
        fields,
        _each_of(prepared, fields, scratch, touching, ends),
        record,
        scratch,
        touching,
        None if touching is None or only_blades else touching.contact,
        cutting,
        leading,
        tools,
        led,
        frames,
        ends,
        solver.tolerance,
        solver.iterations,
        ready.lanes,
    )
    check()
    if law is not None and record.refused[0]:
        raise ScenarioError(
            f'law "{law.law.name}" gives a link of user {record.refused[0]} a stiffness or damping that is not a '
            "finite number of at least 0"
        )
    if events < timing.order.size:  # the step in which the motion left floating point was not recorded
        counter[timing.order[events]] -= 1
    shown = int(frames.done[0])
    return Outcome(
        record=record,
        position=fields.position,
        velocity=fields.velocity,
        events=events,
        taken=counter,
        tools=tools,
        led=led,
        frames=frames.position[:shown],
        frame_time=frames.time[:shown],
        ends=ends,
        cuts=None if cutting is None else marks_of(fields.memory, cutting.first, cutting.wanted.size),
    )


def record_of(prepared: Prepared, more: int = 0) -> Record:
    """Room for what is recorded of a run.

    Args:
        prepared: what is run.
        more: rows of the users' ledgers beside those of their bodies.
    """
    ready, timing, every = prepared.model, prepared.schedule, prepared.scenario.record.every
    users, records, width = timing.count.size, int(timing.count.max()) // every + 1, ready.width
    more += 0 if ready.force is None else len(CLOSED_LEDGER)
    more += 0 if ready.force is None or ready.force.world is None else len(WORLD_LEDGER)
    kept = np.concatenate([ready.port_rows(int(node)) for node in prepared.nodes])
    shape, kept = with_masses(prepared, ready.port_shapes(kept), kept)
    return Record(
        every=every,
        row=kept,
        shape=shape,
        position=np.empty((users, records, kept.size, width)),
        velocity=np.empty((users, records, kept.size, width)),
        force=np.zeros((prepared.hands.row.size, records, width)),
        users=np.zeros((len(USER_LEDGER) + more, users, records)),
        slots=np.zeros((len(SLOT_LEDGER), timing.slots.link.size, records)),
        links=np.zeros((records, len(prepared.scenario.network.links))),
        ticks=np.zeros((len(TICK_LEDGER), records)),
        running=np.zeros((users, 6 + more)),
        lowest=np.zeros(1 + users),
        refused=np.zeros(1, dtype=np.int32),
        made=np.zeros(2),
    )


def _each_of(
    prepared: Prepared, fields: Fields, scratch: Scratch, touching: Touching | None, ends: Ends | None
) -> Copies:
    """The copies one by one."""
    topology, users = prepared.topology, range(fields.position.shape[0])
    held, linked = (list(pairwise(first.tolist())) for first in (prepared.hands.first, topology.first))
    strength, slot, more = topology.strength, scratch.slot, list[Float]()
    if ends is not None:
        strength, slot, more = ends.stiffness, ends.slot, [ends.brake, ends.push_rows]
    return Copies(
        states=Each([State._make(array[i] for array in fields[:5]) for i in users]),
        links=Each(
            [
                Links(strength[a:b], topology.weight[a:b], slot[a:b], fields.samples, *(array[a:b] for array in more))
                for a, b in linked
            ]
        ),
        ports=Each([own_ports(scratch.ports, *span) for span in held]),
        tools=None if touching is None else Each([tools_of(touching, i) for i in users]),
    )
