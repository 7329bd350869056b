"""The batch engine: all steps of all users in one compiled loop, with the energy ledger of the whole network.

Storage is booked in the order of the steps: when user i moves, its springs are measured against where the neighbours'
copies are at that moment. With a common index this is V of [Lee & Huang 2010, eq. 7] once all users have taken the
step; with own rates it stays an exact balance, because every joule is booked by the copy that moves.
"""
# An array indexed by an element of another is a number to numba and an array to numpy's types.
# pyright: reportArgumentType=false, reportReturnType=false

from cotouch.compiled import raised
from cotouch.interaction import (
    Hands,
    Leading,
    ToolRecord,
    Touching,
    after_step,
    before_step,
    begin_lead,
    end_lead,
    grip,
    keep_tools,
    proxy_energy,
)
from cotouch.kernels import at, kernel, put
from cotouch.mechanics import (
    BETA,
    BODY_LOSS,
    CLOSURE,
    CLOSURE_ALARM,
    DRIVE,
    ELASTIC,
    EXTRA_LOSS,
    KINETIC,
    LOCAL_LOSS,
    PROXY,
    SHORTENED,
    SUPPLIED,
    TOUCH_LOSS,
    TOUCH_STORED,
    TOUCHED,
    WORLD_FORCE,
    WORLD_LOSS,
    WORLD_STORED,
    BodyForce,
    Contact,
    Cutting,
    Operator,
    are_apart,
    begin_cut,
    closed_settle,
    closed_step,
    contact_step,
    decide_cuts,
    expose,
    move_apart,
    settle,
    step,
)
from cotouch.simulation._cuts import cut_away
from cotouch.simulation._ends import Ends, ask, tell
from cotouch.simulation._layout import (
    CLOSED_CLOSURE,
    CLOSED_CLOSURE_ALARMS,
    CLOSED_CLOSURE_FACTOR,
    CLOSED_WORLD_LOSS,
    CLOSED_WORLD_STORED,
    CLOSED_WORLD_X,
    SLOT_DELAY_WORK,
    SLOT_LINK_WORK,
    TICK_DELAY_WORK,
    TICK_DISSIPATED,
    TICK_RESIDUAL,
    TICK_SLACK,
    TICK_STORED,
    TICK_SUPPLIED,
    TOOL_DRIVE_WORK,
    TOOL_PROXY,
    TOOL_TOUCH_LOSS,
    TOOL_TOUCH_STORED,
    TOOL_TOUCH_WORK,
    USER_BODY_LOSS,
    USER_ELASTIC,
    USER_EXTRA_LOSS,
    USER_KINETIC,
    USER_LOCAL_LOSS,
    USER_SUPPLIED,
    Copies,
    Fields,
    Float,
    Frames,
    Record,
    Scratch,
    Timing,
    Topology,
)
from cotouch.simulation._ledger import add, copy, delay_work_of, keep_frames, keep_user, spring_energies


@kernel
def run(
    op: Operator,
    force: BodyForce | None,
    topology: Topology,
    timing: Timing,
    hands: Hands,
    local_damping: Float,
    extra_damping: Float,
    fields: Fields,
    copies: Copies,
    record: Record,
    scratch: Scratch,
    touching: Touching | None,
    contact: Contact | None,
    cutting: Cutting | None,
    leading: Leading | None,
    tool_record: ToolRecord | None,
    led_record: ToolRecord | None,
    frames: Frames,
    ends: Ends | None,
    tolerance: float,
    cap: int,
    lanes: tuple[int, ...],
) -> int:
    """Runs all events; returns how many were run before the motion left the range of floating point.

    Without tools `touching`, `contact` and `tool_record` are None, without devices of rigid tools `leading` and
    `led_record`. Of a linear body `force` is None, and so are `ends` where all links are springs: what concerns them
    is not even compiled. What a law's link holds is its own: then what links did counts as delay work.

    Args:
        op: the body's operator; of a body with a material at rest.
        force: of a body with a material; None: it is linear.
        topology: who is linked to whom, and by what slots.
        timing: what step each event is, its length, and which samples it uses.
        hands: that hold the body directly.
        local_damping: B_i as coefficients over the weights, (users, weights) [Ns/m].
        extra_damping: B_e likewise.
        fields: positions and velocities of all users, and what is under way; changed in place.
        copies: one by one, in the memory of `fields` and `scratch`.
        record: written to.
        scratch: of one step; changed in place.
        touching: tools of all users; changed in place.
        contact: the law by which tools touch; None: they never do, beside tools that are bodies.
        cutting: of a body that can be cut; None: it cannot.
        leading: devices of rigid tools of all users; changed in place.
        tool_record: written to.
        led_record: likewise, of devices of rigid tools.
        frames: shapes that are kept for an animation; written to.
        ends: of all links under a law; changed in place.
        tolerance: of the solver, on the residual relative to the right-hand side, > 0.
        cap: most iterations of the solver in a step, >= 1.
        lanes: as long as a row is wide; see `cotouch.mechanics`.
    """
    users = fields.position.shape[0]
    supplied, dissipated, delay_work, energy = 0.0, 0.0, 0.0, 0.0
    initial, lowest, made, most_made = 0.0, 0.0, 0.0, 0.0
    tick = 0
    for i in range(users):
        state = copies.states[i]
        if force is None:
            settle(op, state, scratch.ledger, lanes)
        else:
            closed_settle(op, force, state, scratch.work, scratch.ledger, lanes)
        record.running[i, USER_KINETIC] = scratch.ledger[KINETIC]
        record.running[i, USER_ELASTIC] = scratch.ledger[ELASTIC]
        put(record.lowest, 1 + i, min(0.0, scratch.ledger[ELASTIC]))
        initial += scratch.ledger[KINETIC] + scratch.ledger[ELASTIC]
        if touching is not None:
            moving = proxy_energy(touching, i)
            put(record.running, (i, TOOL_PROXY), moving)
            initial += moving
        copy(fields.samples[users * timing.ring + i], fields.position[i], lanes)
        keep_user(record, hands, fields, scratch, topology, i, 0, lanes)
        if touching is not None:
            keep_tools(tool_record, touching, i, 0)
        if leading is not None:
            keep_tools(led_record, leading.touching, i, 0)
    if ends is None:
        initial += spring_energies(op, topology, fields, record, scratch, 0, lanes)
    put(record.ticks, (TICK_STORED, 0), initial)
    for row in range(TICK_SUPPLIED, TICK_SLACK + 1):
        put(record.ticks, (row, 0), 0.0)
    energy = initial
    for event in range(timing.order.shape[0]):
        if raised(timing.stop):
            return event
        i = at(timing.order, event)
        k = at(scratch.counter, i)
        put(scratch.counter, i, k + 1)
        T = at(timing.length, (i, k))
        end = at(timing.end, (i, k))
        keep_frames(frames, fields, end, lanes)
        s0, s1 = at(topology.first, i), at(topology.first, i + 1)
        p0, p1 = at(hands.first, i), at(hands.first, i + 1)
        for s in range(s0, s1):
            index = at(timing.used, (s, k))
            peer = at(topology.peer, s)
            kept = peer * timing.ring + (index & (timing.ring - 1))
            put(scratch.slot, s, users * timing.ring + peer if index < 0 else kept)
        for p in range(p0, p1):
            grip(hands, scratch.ports, scratch.cursor, p, end, T, lanes)
        if leading is not None and not begin_lead(leading, scratch.ports, fields.position[i], i, end, T):
            return event
        if ends is not None and not ask(ends, topology, timing, scratch.slot, i, k, T):
            record.refused[0] = i + 1
            return event
        state, links, ports = copies.states[i], copies.links[i], copies.ports[i]
        ledger, link_work = scratch.ledger, scratch.link_work[s0:s1]
        if cutting is not None and force is not None and touching is None:
            begin_cut(cutting, force.world, state, None)
        if touching is not None and copies.tools is not None:
            if not before_step(touching, i, end, T):
                return event
            tools = copies.tools[i]
            if cutting is not None and force is not None:
                begin_cut(cutting, force.world, state, tools)
                if contact is not None:
                    expose(cutting, state.memory, contact.work.fit.hidden)
            if contact is not None and not are_apart(force, tools):
                contact_step(
                    contact,
                    op,
                    force,
                    state,
                    links,
                    ports,
                    touching.surface,
                    tools,
                    local_damping[i],
                    extra_damping[i],
                    T,
                    i * timing.ring + (k & (timing.ring - 1)),
                    scratch.work,
                    ledger,
                    touching.ledger,
                    link_work,
                    tolerance,
                    cap,
                    lanes,
                )
            elif force is not None:  # beside tools that are bodies
                closed_step(
                    op,
                    force,
                    state,
                    links,
                    ports,
                    local_damping[i],
                    extra_damping[i],
                    T,
                    i * timing.ring + (k & (timing.ring - 1)),
                    scratch.work,
                    ledger,
                    link_work,
                    tolerance,
                    cap,
                    lanes,
                )
                move_apart(contact, tools, T, touching.ledger, lanes)
            if cutting is not None:
                decide_cuts(cutting, state.memory, state.position, tools, i + 1, True)
            after_step(touching, i)
            own = touching.ledger
            add(record.running, i, TOOL_DRIVE_WORK, own[DRIVE])
            add(record.running, i, TOOL_TOUCH_WORK, own[TOUCHED])
            add(record.running, i, TOOL_TOUCH_LOSS, own[TOUCH_LOSS])
            put(record.running, (i, TOOL_PROXY), own[PROXY])
            put(record.running, (i, TOOL_TOUCH_STORED), own[TOUCH_STORED])
            supplied += own[DRIVE]
            dissipated += own[TOUCH_LOSS]
        elif force is not None:
            closed_step(
                op,
                force,
                state,
                links,
                ports,
                local_damping[i],
                extra_damping[i],
                T,
                i * timing.ring + (k & (timing.ring - 1)),
                scratch.work,
                ledger,
                link_work,
                tolerance,
                cap,
                lanes,
            )
        else:
            step(
                op,
                state,
                links,
                ports,
                local_damping[i],
                extra_damping[i],
                T,
                i * timing.ring + (k & (timing.ring - 1)),
                scratch.work,
                ledger,
                link_work,
                tolerance,
                cap,
                lanes,
            )
        if leading is not None:
            end_lead(leading, scratch.ports, state.position, i)
        if cutting is not None:
            if touching is None:
                decide_cuts(cutting, state.memory, state.position, None, i + 1, True)
            if force is not None:
                dissipated += cut_away(cutting, op, force, topology, timing, copies.states, record, ledger, i, k, lanes)
        if ends is not None:
            tell(ends, topology, timing, ports, contact, force, op.copy_scale * op.firmness, i, k)
        for s in range(s0, s1):
            added = at(scratch.link_work, s)
            made += added
            add(scratch.slot_running, s, SLOT_LINK_WORK, added)
            if ends is None:
                added = delay_work_of(op, topology, fields, scratch, s, T, lanes)
            add(scratch.slot_running, s, SLOT_DELAY_WORK, added)
            delay_work += added
        running = record.running
        add(running, i, USER_SUPPLIED, ledger[SUPPLIED])
        add(running, i, USER_BODY_LOSS, ledger[BODY_LOSS])
        add(running, i, USER_LOCAL_LOSS, ledger[LOCAL_LOSS])
        add(running, i, USER_EXTRA_LOSS, ledger[EXTRA_LOSS])
        put(running, (i, USER_KINETIC), ledger[KINETIC])
        put(running, (i, USER_ELASTIC), ledger[ELASTIC])
        if force is not None:
            first = USER_ELASTIC + 1 if touching is None else TOOL_TOUCH_STORED + 1
            add(running, i, first + CLOSED_CLOSURE, ledger[CLOSURE])
            largest = first + CLOSED_CLOSURE_FACTOR
            put(running, (i, largest), max(at(running, (i, largest)), ledger[BETA]))
            if ledger[BETA] > CLOSURE_ALARM or ledger[SHORTENED] > 0.0:
                add(running, i, first + CLOSED_CLOSURE_ALARMS, 1.0)
            if running.shape[1] >= first + CLOSED_WORLD_X + 3:  # there are obstacles
                add(running, i, first + CLOSED_WORLD_LOSS, ledger[WORLD_LOSS])
                put(running, (i, first + CLOSED_WORLD_STORED), ledger[WORLD_STORED])
                for axis in range(3):
                    put(running, (i, first + CLOSED_WORLD_X + axis), ledger[WORLD_FORCE + axis])
        supplied += ledger[SUPPLIED]
        dissipated += ledger[BODY_LOSS] + ledger[LOCAL_LOSS] + ledger[EXTRA_LOSS]
        made -= ledger[LOCAL_LOSS]
        most_made = max(most_made, made)
        lowest = min(lowest, supplied)
        held = ledger[ELASTIC] + (at(running, (i, TOOL_TOUCH_STORED)) if touching is not None else 0.0)
        put(record.lowest, 1 + i, min(at(record.lowest, 1 + i), held))
        record.lowest[0] = lowest
        record.made[0] = most_made
        record.made[1] = made
        if not ledger[KINETIC] + ledger[ELASTIC] < 1e200:
            return event
        if (k + 1) % record.every == 0:
            keep_user(record, hands, fields, scratch, topology, i, (k + 1) // record.every, lanes)
            if touching is not None:
                keep_tools(tool_record, touching, i, (k + 1) // record.every)
            if leading is not None:
                keep_tools(led_record, leading.touching, i, (k + 1) // record.every)
            if i == timing.reference:
                tick = (k + 1) // record.every
                energy = 0.0
                if ends is None:
                    energy = spring_energies(op, topology, fields, record, scratch, tick, lanes)
                slack = -delay_work
                for user in range(users):
                    slack += at(running, (user, USER_LOCAL_LOSS))
                    energy += at(running, (user, USER_KINETIC)) + at(running, (user, USER_ELASTIC))
                    if touching is not None:
                        energy += at(running, (user, TOOL_PROXY)) + at(running, (user, TOOL_TOUCH_STORED))
                put(record.ticks, (TICK_STORED, tick), energy)
                put(record.ticks, (TICK_SUPPLIED, tick), supplied)
                put(record.ticks, (TICK_DISSIPATED, tick), dissipated)
                put(record.ticks, (TICK_DELAY_WORK, tick), delay_work)
                put(record.ticks, (TICK_RESIDUAL, tick), energy - initial - supplied + dissipated - delay_work)
                put(record.ticks, (TICK_SLACK, tick), slack)
    return timing.order.shape[0]
