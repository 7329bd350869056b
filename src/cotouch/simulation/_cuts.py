"""What a copy of a run loses by cutting, after each of its steps."""

from cotouch.arrays import Float
from cotouch.kernels import part
from cotouch.mechanics import CUT, CUT_COUNT, BodyForce, Cutting, Operator, State, hear_cuts, sever
from cotouch.passing import Each
from cotouch.simulation._layout import Record, Timing, Topology
from cotouch.simulation._ledger import add


@part
def cut_away(
    cutting: Cutting,
    op: Operator,
    force: BodyForce,
    topology: Topology,
    timing: Timing,
    states: Each[State],
    record: Record,
    ledger: Float,
    i: int,
    k: int,
    lanes: tuple[int, ...],
) -> float:
    """Takes away what a user decided and what its samples told; books and returns the energy that went [J].

    Args:
        cutting: the elements, with what was decided.
        op: the body.
        force: what resists inside.
        topology: who is joined to whom.
        timing: which samples the step used.
        states: of all copies; changed in place.
        record: what is kept; written to.
        ledger: of the step; changed in place.
        i: the user.
        k: number of its step.
        lanes: fixes the width.
    """
    state = states[i]
    for s in range(topology.first[i], topology.first[i + 1]):
        hear_cuts(cutting, state.memory, states[topology.peer[s]].memory, timing.used[s, k])
    sever(cutting, op, force, state, k, ledger, lanes)
    columns = record.running.shape[1]  # those of `CUT_LEDGER` are the last
    add(record.running, i, columns - 2, ledger[CUT])
    add(record.running, i, columns - 1, ledger[CUT_COUNT])
    return ledger[CUT]
