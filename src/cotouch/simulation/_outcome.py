"""Running a prepared scenario, by the batch engine or message by message, with the same record of it."""

import numpy as np

from cotouch.arrays import Float
from cotouch.mechanics import CLOSURE_ALARM, ELASTIC, KINETIC, LEDGER_COLUMNS, State, closed_settle, settle, unsettled
from cotouch.peer import StepReport
from cotouch.simulation._batch import CodecTraffic, Outcome, record_of, run_batch
from cotouch.simulation._layout import (
    CLOSED_LEDGER,
    TICK_STORED,
    USER_LEDGER,
    WORLD_LEDGER,
    Record,
)
from cotouch.simulation._peers import PeerRun, run_peers
from cotouch.simulation._prepare import Prepared

# Columns that are sums of all steps so far.
_SO_FAR = {"supplied", "body_loss", "local_loss", "extra_loss", "closure", "closure_alarms", "world_loss"}


def run_prepared(prepared: Prepared) -> Outcome:
    """Runs all users: in one compiled loop, or message by message where senders decide by the motion what they send.

    Raises:
        KeyboardInterrupt: it was interrupted; see `cotouch.interrupt.interruptible`.
        ScenarioError: the links' law asks for what no link can be.
    """
    if prepared.scenario.channel.codec is None:
        return run_batch(prepared)
    with np.errstate(over="ignore", invalid="ignore"):  # of a motion that leaves floating point
        return _recorded(prepared, run_peers(prepared))


def _recorded(prepared: Prepared, run: PeerRun) -> Outcome:
    """The record that the batch engine would have made; what a law's link did counts as delay work, as there."""
    ready, timing, hands = prepared.model, prepared.schedule, prepared.hands
    every, users, slots = prepared.scenario.record.every, timing.count.size, timing.slots
    taken = np.array([len(reports) for reports in run.reports], dtype=np.int32)
    record = record_of(prepared)
    books, shape = record.users.shape[0], record.shape

    def seen(field: Float) -> Float:
        return np.asarray(shape @ field if shape.shape[0] else field[:, record.row])

    start = np.array([_energies(prepared, run, i) for i in range(users)])
    for i, reports in enumerate(run.reports):
        last = taken[i] // every + 1
        record.position[i, :last] = seen(run.position[i][::every])
        record.velocity[i, :last] = seen(run.velocity[i][::every])
        ledger = _ledger(reports, books)
        record.users[4:6, i, 0] = start[i]
        record.lowest[1 + i] = min(0.0, start[i, 1], *(report.elastic + report.touch_stored for report in reports))
        record.users[:, i, 1:last] = ledger[every - 1 :: every].T
        own = slice(slots.first[i], slots.first[i + 1])
        work = np.cumsum([report.link_work for report in reports], axis=0).reshape(len(reports), -1)
        record.slots[:, own, 1:last] = work[every - 1 :: every].T
        force = np.array([report.force for report in reports[every - 1 :: every]])
        record.force[hands.first[i] : hands.first[i + 1], 1:last] = np.moveaxis(force, 0, 1)
    _totals(prepared, run, record, start)
    finite = all(np.isfinite(positions).all() for positions in run.position)
    return Outcome(
        record=record,
        position=np.array([positions[-1] for positions in run.position]),
        velocity=np.array([velocities[-1] for velocities in run.velocity]),
        events=int(taken.sum()) if finite else int(taken.sum()) - 1,
        taken=taken,
        tools=None,
        frames=np.zeros((0, users, ready.operator_rows, ready.width)),
        frame_time=np.zeros(0),
        traffic=CodecTraffic(
            contents=np.array([encoder.contents for encoder in run.encoders]),
            unchanged=np.array([encoder.unchanged for encoder in run.encoders]),
            size=np.array([encoder.size for encoder in run.encoders]),
        ),
    )


def _ledger(reports: list[StepReport], books: int) -> Float:
    """What a user's steps booked, as `Record.users` has it, (steps, books)."""
    result = np.array([_row(report)[:books] for report in reports]).reshape(-1, books)
    for book, name in enumerate((*USER_LEDGER, *CLOSED_LEDGER, *WORLD_LEDGER)[:books]):
        if name in _SO_FAR:
            result[:, book] = np.cumsum(result[:, book])
        elif name == "closure_factor":
            result[:, book] = np.maximum.accumulate(result[:, book])
    return result


def _row(report: StepReport) -> tuple[float, ...]:
    """Of all ledgers that there may be."""
    losses = report.body_loss, report.local_loss, report.extra_loss
    own = report.supplied, *losses, report.kinetic, report.elastic, float(report.iterations)
    alarm = report.closure_factor > CLOSURE_ALARM or report.shortened > 0.0
    closed = report.closure, report.closure_factor, float(alarm)
    return *own, *closed, report.world_loss, report.world_stored, *report.world_force


def _energies(prepared: Prepared, run: PeerRun, i: int) -> tuple[float, float]:
    """Kinetic and elastic energy of a copy at the start [J]."""
    ready, ledger = prepared.model, np.zeros(LEDGER_COLUMNS)
    rows = np.zeros((2, ready.operator_rows, ready.width))
    state = State(run.position[i][0].copy(), run.velocity[i][0].copy(), rows[0], rows[1], unsettled(ready, i))
    if ready.force is None:
        settle(ready.operator, state, ledger, ready.lanes)
    else:
        closed_settle(ready.operator, ready.force, state, ready.workspace(0), ledger, ready.lanes)
    return float(ledger[KINETIC]), float(ledger[ELASTIC])


def _totals(prepared: Prepared, run: PeerRun, record: Record, start: Float) -> None:
    """What all users together came to, in the order of their steps."""
    timing, every = prepared.schedule, record.every
    following = np.zeros(timing.count.size, dtype=np.int64)
    stored = start.sum(axis=1)
    # Of each event: change of what is stored, supplied, dissipated, done by links, lost in the damping B_i.
    steps = np.zeros((timing.order.size, 5))
    for event, i in enumerate(timing.order):
        report = run.reports[int(i)][int(following[i])]
        following[i] += 1
        energy = report.kinetic + report.elastic
        losses = report.body_loss + report.local_loss + report.extra_loss
        work = float(report.link_work.sum())
        steps[event] = energy - stored[i], report.supplied, losses, work, report.local_loss
        stored[i] = energy
    sums = np.cumsum(steps, axis=0)
    made = sums[:, 3] - sums[:, 4]
    record.lowest[0] = min(float(sums[:, 1].min(initial=0.0)), 0.0)
    record.made[:] = max(float(made.max(initial=0.0)), 0.0), made[-1] if made.size else 0.0
    initial = float(start.sum())
    record.ticks[TICK_STORED, 0] = initial
    at = np.flatnonzero(timing.order == timing.reference)[every - 1 :: every]
    change, supplied, lost, links, local = sums[at].T
    residual = change - supplied + lost - links
    record.ticks[:, 1 : at.size + 1] = initial + change, supplied, lost, links, residual, local - links
