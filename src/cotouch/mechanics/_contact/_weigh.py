"""The way that a body with a material goes in a step with tools, weighed and judged."""

from cotouch.arrays import Float
from cotouch.kernels import part
from cotouch.mechanics._closed._balance import ABOUT, HAVE, LEAST, MOST, NOISE, RIGID, weigh, with_links
from cotouch.mechanics._closed._balance_parts import judge
from cotouch.mechanics._closed._debris import rest_debris
from cotouch.mechanics._linear._operator import Operator
from cotouch.mechanics._linear._state import SUPPLIED, Links, Ports, State, Workspace
from cotouch.mechanics._linear._step import move, port_work
from cotouch.mechanics._materials._force import BodyForce

# What the end velocity may make up for, as a share of its energy, where tools touch: a scale does the rest.
EASY = 0.015


@part
def weigh_way(
    op: Operator,
    force: BodyForce,
    state: State,
    links: Links,
    ports: Ports,
    local_damping: Float,
    extra_damping: Float,
    T: float,
    sample: int,
    pushed: Float,
    over: float,
    noise: float,
    shorter: int,
    work: Workspace,
    link_work: Float,
    ledger: Float,
    lanes: tuple[int, ...],
) -> tuple[float, float, float, bool, bool]:
    """Moves a body with a material as far as it goes, and judges that.

    Args:
        op: the body.
        force: what resists inside it.
        state: of the copy, which is moved.
        links: its links.
        ports: what holds it.
        local_damping: b_i [Ns/m].
        extra_damping: b_i' [Ns/m].
        T: length of the step [s].
        sample: slot of `links.samples` that receives x̂; negative: none.
        pushed: what tools push rows with.
        over: what tools leave over [J].
        noise: what of that may be rounding [J].
        shorter: how often the step was tried.
        work: scratch; `mean` holds the motion, debris rests in it.
        link_work: result (links,).
        ledger: result (LEDGER_COLUMNS,), as of `step`.
        lanes: fixes the width of a row.

    Returns:
        What `over` is then, and what of it may be rounding [J]; the rest as `judge`.
    """
    rest_debris(op, work.mean, lanes)
    ledger[SUPPLIED] = port_work(op, state, ports, T, work.mean, lanes)
    move(op, state, links, T, sample, work, link_work, lanes)
    gain = with_links(ledger[SUPPLIED] + over, links, link_work)
    weigh(op, force, state, local_damping, extra_damping, T, gain, work, ledger, lanes)
    weighed = work.weighed
    if weighed[NOISE] >= 0.0:  # else energies overflowed, and so may have what tools did
        weighed[NOISE] += noise / op.copy_scale
    lacks, square, passed, others = judge(
        op,
        force,
        state,
        links,
        ports,
        local_damping,
        extra_damping,
        T,
        pushed,
        over / op.copy_scale,
        shorter,
        work,
        lanes,
    )
    return op.copy_scale * lacks, op.copy_scale * weighed[NOISE], square, passed, others


@part
def is_closed(
    weighed: Float, over: float, noise: float, square: float, easy: bool, rounded: bool, seeks: bool, central: bool
) -> bool:
    """Whether the way that was weighed may be taken.

    Args:
        weighed: what was found.
        over: what is left over [J].
        noise: what of that may be rounding [J].
        square: β² that closes it.
        easy: whether the body may only do so by little, as a length or a search may yet do better.
        rounded: whether forces and energy do not disagree.
        seeks: whether a length is sought.
        central: whether all goes about a centre.
    """
    least, greatest = (1.0 - EASY, 1.0 + EASY) if easy else (LEAST, MOST)
    # Who moves as a whole alone could make up for something only by that.
    whole = central and weighed[ABOUT] <= RIGID * weighed[HAVE]
    fine = abs(over) <= noise or (least <= square <= greatest and (seeks or over < 0.0) and not whole)
    return fine or (rounded and square >= 0.0)


@part
def next_scale(
    scale: float, over: float, last: float, last_over: float, slope: float, aim: float, tries: int
) -> tuple[float, float]:
    """Which scale leaves over what it should, by the last two.

    Args:
        scale: the last.
        over: what it leaves over [J].
        last: the one before.
        last_over: what that left over [J].
        slope: of what is left over, as it was thought to be [J].
        aim: what should be left over [J].
        tries: how many there were before the last.

    Returns:
        The slope, and the scale.
    """
    if tries > 0:
        slope = (over - last_over) / (scale - last)
    return slope, min(max(scale - (over - aim) / slope, LEAST), MOST) if slope < 0.0 else scale
