"""`paid`: hands' forces are exchanged and predicted as boldly as one likes; an account makes it passive.

With share 1/N of the body, a copy that felt all hands would move as the whole body does, so copy i wishes the force
`(1/N) Σ_j (F_j - f_i)`, F_j what hand j would do here and now: a spring and damper that its own end identifies, to a
place whose integrals travel. In a tree a copy tells each neighbour of the hands that its other links bring, too:
springs, dampers and what is left of forces add up. Samples of the copies draw what is left of their differences
together, compared with where this copy was at the same time, so common motion has no drag.

What was guessed of a hand is compared with what it did, once that is heard: while the own hand holds, a copy wishes for
what hands do beyond it only as far as guesses came true.

The wish is paid from an account H. For every v̂, `T v̂ᵀ(wish + b*v - b*v̂) ≤ T‖wish + b*v‖²/(4b*) = H` by choice of b*:
whatever body, hand or contact do, H stays above zero, and all copies together make no more than they begin with. A weak
wave line, passive by itself, lies beside it, or copies whose accounts are dry could stay apart for ever.
"""

from math import inf, sqrt

from cotouch.laws._end import End
from cotouch.laws._helper import copy, helper
from cotouch.laws._law import FORCE, Facts, Law, Parameter, register
from cotouch.laws._origin_force import OriginForce
from cotouch.laws._paid_fields import (
    ACCOUNT,
    AGE,
    AHEAD,
    ALL_GRASPED,
    ALL_HANDS,
    ALL_K,
    ALL_P,
    ALL_Q,
    ALL_W,
    AS_ONE,
    BACK,
    BETA,
    BRAKE,
    CALM,
    CREDITED,
    DEGREE,
    E_IN,
    E_OUT,
    FLOOR,
    FORCE_LIMIT,
    GD,
    GIVEN,
    GK,
    GRASPED_AT,
    HELD,
    HORIZON,
    KEPT,
    KNOWN,
    LEVEL,
    LINE,
    LOGGED,
    LONGEST,
    M_AGE,
    M_AS_ONE,
    M_B,
    M_E,
    M_EPOCH,
    M_GIVEN,
    M_HANDS,
    M_K,
    M_SINCE,
    M_T,
    MASS,
    PART_B,
    PART_EPOCH,
    PART_GRASPED,
    PART_HANDS,
    PART_K,
    RELAY,
    SEED,
    SPAN,
    STAMP,
    TELLS,
    TIME,
    UNHEARD,
    WAVE_IN,
    WAVE_OUT,
    WISH,
    X_BEFORE,
    X,
)
from cotouch.laws._paid_guess import believed, check_guess
from cotouch.laws._paid_hand import book_copy
from cotouch.laws._paid_heard import Heard, add_wish, at_once, between, bring_hand, wish
from cotouch.laws._paid_hold import hold_on
from cotouch.laws._paid_other import bring, credible, past, take_over, tell
from cotouch.laws._paid_rows import pay, price, push_wave, receive_wave, return_wave
from cotouch.laws._paid_touch import SMOOTH, stretch

# Share of the brake that a soft body keeps while its own user does not hold it: no hand fills the account there, and
# what another's hand moves at one node, while all are braked, is stretched by what was to move it.
_FREE = 0.1
# What one grasps others cannot know of at once. A copy that is faster than this meanwhile is braked [m/s]; that pays
# for what others' hands turn out to do. Before anybody is heard, an age is taken to be so long; none is longer [s].
_FAST, _UNHEARD = 0.5, 0.6
# A force that would need a greater damper beside it to be paid for is left out [Ns/m].
_GREATEST = 1e6


def _before(end: End) -> None:
    T, x, own, numbers = end.T, end.position, end.shared, end.shared_scalars
    kept, told, p = end.scalars, end.received_scalars, end.parameters
    size, heard = x.shape[0], end.sample_index >= 0
    if end.first:
        if end.step == 0:
            copy(own[X], x)
            copy(own[X_BEFORE], x)
        for i in range(size):
            own[WISH, i] = 0.0
        if p[RELAY] > 0.0:
            for i in range(size):
                own[ALL_W, i] = own[ALL_P, i] = own[ALL_Q, i] = 0.0
        numbers[LEVEL] = numbers[UNHEARD] = 0.0
        numbers[ALL_GRASPED] = numbers[LONGEST] = numbers[BACK] = numbers[DEGREE] = 0.0
        for name in range(ALL_K, ALL_HANDS + 1):
            numbers[name] = 0.0
    if end.step == 0:
        numbers[ACCOUNT] += p[SEED]
    numbers[LEVEL] += p[SEED]
    numbers[DEGREE] += 1.0
    # The wave line.
    root, span = sqrt(2.0 * p[LINE]), max(0.02, T)
    if end.step == 0:
        for i in range(size):
            end.memory[WAVE_IN, i] = end.memory[WAVE_OUT, i] = 0.5 * root * x[i]
    power = receive_wave(end, 1.0 / span if heard else 0.0)
    most = max(told[M_E] - kept[E_IN], 0.0)
    fraction = sqrt(most / (power * span)) if power * span > most else 1.0
    push = root * sqrt(2.0 * power)
    if fraction * push > p[FORCE_LIMIT]:
        fraction = p[FORCE_LIMIT] / push
    left = max(p[FORCE_LIMIT] - fraction * push, 0.0)
    kept[E_IN] += fraction * fraction * power * T
    push_wave(end, fraction, root)
    end.gains[0], end.gains[1] = 0.0, p[LINE]
    # What the neighbour's hand would do here, and where the neighbour is.
    numbers[ACCOUNT] += max(told[M_GIVEN] - kept[CREDITED], 0.0)
    kept[CREDITED] = max(kept[CREDITED], told[M_GIVEN])
    kept[PART_HANDS] = 0.0
    if heard:
        kept[AGE] += (end.age - kept[AGE]) * (min(T / 0.3, 1.0) if kept[AGE] > 0.0 else 1.0)
        mean = max(kept[AGE], p[FLOOR], 2.0 * T)
        stale = 3.0 * mean + 0.05
        trust = min(max((1.6 - end.age / stale) / 0.6, 0.0), 1.0)
        theirs = max(told[M_T], 0.0)  # length of the neighbour's steps, unless it lies
        # Forces act in the middle of the step, where the copy is taken to be.
        early = 0.25 * kept[AGE] - 0.5 * T
        ahead = max(end.age - early - 0.5 * theirs, 0.0)
        numbers[LONGEST] = max(numbers[LONGEST], mean)
        fresh = kept[KNOWN] != told[M_EPOCH]
        kept[KNOWN] = told[M_EPOCH]
        when = numbers[TIME] + T - end.age
        before, after, share, gap = past(end, when)
        then = between(before, after, share, gap)
        # A is of this time after the start of the step. Where that changes, A must, or T and age would seem forces.
        horizon = T - early
        shift = 0.0 if fresh else horizon - kept[HORIZON]
        kept[HORIZON] = horizon
        # How fast the hand's force changes, so that it is not held where it was.
        if fresh:
            kept[STAMP], kept[SPAN] = when, 0.0
        passed = when - kept[STAMP]
        follows, part = fresh or passed > 0.25 * theirs, 0.0
        if follows:
            kept[STAMP] = when
            kept[SPAN] += passed
            part = min(passed / min(kept[SPAN], SMOOTH), 1.0) if passed > 0.0 else 0.0
        as_one = told[M_AS_ONE] > 0.0
        if as_one:
            stretch(end, then, numbers[TIME] + 0.5 * T - when, fresh)
        # A hand that grasped or let go did so before this was heard.
        begun = when + 0.5 * told[M_T] - told[M_SINCE] - horizon
        taken = fresh and told[M_SINCE] >= 0.0 and take_over(end, begun)
        kept[PART_GRASPED] = 1.0 if taken else 0.0
        back = told[M_SINCE] + ahead if taken else 0.0
        numbers[BACK] = max(numbers[BACK], back)
        lag = max(0.005, 0.5 * mean, 2.0 * T)  # shorter than two steps, A would swing
        known = Heard(
            fresh,
            taken,
            as_one,
            follows,
            1.0 / passed if passed > 0.0 else 0.0,
            part,
            ahead,
            p[AHEAD],
            shift,
            lag,
            back,
            told[M_K],
            told[M_B],
            at_once(end),
            told[M_HANDS],
        )
        check_guess(end, when, passed, lag, fresh)
        told_of = bring_hand(end, known)
        # The same at both ends, or what draws copies together would push on both.
        both = 0.5 * (mean + told[M_AGE]) if told[M_AGE] > 0.0 else mean
        # The end that tells of hands is ahead of one that tells of none and hears of them `early` late. Drawn together
        # without that, a hand would feel drag.
        behind = 0.0
        if not as_one and numbers[AS_ONE] == 0.0 and (kept[TELLS] > 0.0) != told_of:
            if told_of:
                behind = max(early, 0.0)
            else:
                before, after, share, gap = past(end, when - max(0.25 * told[M_AGE] - 0.5 * theirs, 0.0))
                then = between(before, after, share, gap)
        gain = p[MASS] / end.copies
        part = believed(end)
        force = sqrt(wish(end, then, gain * p[GK] / (both * both), gain * p[GD] / both, trust, part, behind))
        add_wish(end, left / force if force > left else 1.0, trust * part)
        if p[RELAY] > 0.0 and trust > 0.0 and credible(end, told):
            kept[PART_K], kept[PART_B], kept[PART_HANDS] = told[M_K], told[M_B], told[M_HANDS]
            kept[PART_EPOCH] = told[M_EPOCH] + 1.0
            bring(end)
    else:
        numbers[UNHEARD] = _UNHEARD
    if end.last:
        _settle(end)


@helper
def _settle(end: End) -> None:
    """The payment, on the last of the copy's links."""
    T, numbers, p = end.T, end.shared_scalars, end.parameters
    H = max(numbers[ACCOUNT], 0.0)
    still = hold_on(end, H)
    along, wished, speed = price(end)
    fraction = 1.0
    due = T * (along + sqrt(wished * speed))
    if due > 2.0 * H:
        fraction = 2.0 * H / due
    along, wished = fraction * along, fraction * fraction * wished
    root = sqrt(max((2.0 * H - T * along) ** 2 - T * T * wished * speed, 0.0))
    room = 2.0 * H - T * along + root
    b = T * wished / room if room > 0.0 and wished > 0.0 else 0.0
    if b > _GREATEST or (wished > 0.0 and not room > 0.0):
        fraction = b = 0.0
    pay(end, fraction, b)
    floor = 0.5 * numbers[LEVEL]
    free = numbers[HELD] == 0.0 and end.position.shape[0] > end.width
    beta = _FREE * p[BETA] if free else p[BETA]
    b += still + (beta * max(1.0 - H / floor, 0.0) if floor > 0.0 else beta)
    if numbers[TIME] - numbers[GRASPED_AT] < min(max(numbers[LONGEST], numbers[UNHEARD]), _UNHEARD):
        rows = end.position.shape[0] // end.width
        b += p[CALM] / end.copies * max(sqrt(speed / rows) - _FAST, 0.0)
    numbers[BRAKE] = b
    end.gains[1] += b


def _after(end: End) -> None:
    T, numbers, kept, p = end.T, end.shared_scalars, end.scalars, end.parameters
    kept[E_OUT] += return_wave(end, sqrt(2.0 * p[LINE])) * T
    end.sent_scalars[M_E] = kept[E_OUT]
    if end.first:
        book_copy(end)
    spare = max(numbers[ACCOUNT] - numbers[LEVEL], 0.0)
    given = spare if end.last else 0.5 * spare
    numbers[ACCOUNT] -= given
    kept[GIVEN] += given
    end.sent_scalars[M_AGE] = max(kept[AGE], p[FLOOR], 2.0 * T)
    tell(end)


def _share(facts: Facts) -> float:
    return 0.02 / facts.degree  # of a copy, whatever its body: so much nobody notices


def _mass(facts: Facts) -> float:
    return facts.mass / (facts.degree + 1) / sqrt(facts.rows)


def _still(facts: Facts) -> float:
    return facts.mass * sqrt(facts.rows) / (facts.degree + 1)  # a force at a node moves some of a soft body


def _lightest(facts: Facts) -> float:
    return facts.mass if facts.lightest is None else facts.lightest


def _calm(facts: Facts) -> float:
    return 80.0 * facts.mass


def _relays(facts: Facts) -> float:
    return float(facts.tree and facts.rows == 1)  # of a soft body, the sum of springs says not where they hold


def _line(facts: Facts) -> float:
    return 0.2 / max(facts.degree, facts.degree_back) / facts.rows  # the same at both ends, or copies rest apart


PAID = register(
    Law(
        name="paid",
        before=_before,
        after=_after,
        source="docs/laws.md",
        parameters=(
            Parameter(
                name="initial_energy",
                meaning="energy that an end contributes to its copy's account [J]",
                default=_share,
            ),
            Parameter(name="floor", meaning="least age over which copies are drawn together [s]", default=0.005),
            Parameter(name="brake", meaning="damper that fills an empty account [Ns/m]", default=10.0),
            Parameter(name="pull", meaning="g_k, how strongly copies are drawn together", default=0.04),
            Parameter(name="damp", meaning="g_d, how strongly their velocities are drawn together", default=0.35),
            Parameter(name="line", meaning="impedance of the parallel wave line [Ns/m]", default=_line),
            Parameter(name="mass", meaning="mass with which copies are drawn together [kg]", default=_mass),
            Parameter(name="ahead", meaning="share of a hand's change of force that is expected to last", default=0.5),
            Parameter(
                name="calm", meaning="damper on fast motion unknown to others yet, for each m/s [Ns²/m²]", default=_calm
            ),
            Parameter(name=FORCE, meaning="largest force with which a neighbour may push [N]", default=inf),
            Parameter(
                name="relay",
                meaning="share of hands on other links that is relayed; only in trees, otherwise some count twice",
                default=_relays,
                most=1.0,
                tuned=False,
            ),
            Parameter(
                name="still",
                meaning="mass with which a copy stops that cannot pay for its wish; 0: never [kg]",
                default=_still,
                tuned=False,
            ),
            Parameter(
                name="lightest",
                meaning="mass of the lightest row, which limits how fast a hand elsewhere is felt [kg]",
                default=_lightest,
                tuned=False,
            ),
        ),
        sends=("U_out", "P", "Q", "w", "v", "way"),
        sends_scalars=("E_out", "k", "b", "epoch", "given", "T", "hands", "as one", "since", "age"),
        keeps=(
            *("U_in", "U_out", "s", "A", "A2", "wish", "w before", "slope", "part w", "stretch"),
            *("P", "Q", "hand", "done", "first", "second", "part P", "part Q", "alive", "grip"),
            *(f"done{k}" for k in range(LOGGED)),
            *("guess", "even guess", "even truth", *(f"guess{k}" for k in range(LOGGED))),
        ),
        keeps_scalars=(
            *("E_in", "E_out", "age", "credited", "given", "epoch", "horizon", "stamp", "span"),
            *("part k", "part b", "part epoch", "part hands", "told epoch", "since", "rounds", "part grasped"),
            *("checked", "right", "guessed", "settled", "tells"),
            *(f"evenly {axis}" for axis in range(4)),
        ),
        shares=(
            *("w", "wish", "f", "x", "v", "x before", "v before"),
            *(
                "x rate",
                "v rate",
                "f rate",
                "all w",
                "all P",
                "all Q",
                "asked",
                "touch",
                "told",
                "way",
                "acting",
                "exerted",
            ),
            *(f"{name}{k}" for name in ("x", "v") for k in range(KEPT)),
            *(f"force{k}" for k in range(LOGGED)),
        ),
        shares_scalars=(
            *("account", "time", "k", "level", "epoch", "xx", "xv", "vv"),
            *("xf", "vf", "held", "count", "brake", "b", "new k", "new b", "steady"),
            *("all k", "all b", "all epoch", "all hands", "as one", "grasped", "all grasped", "longest"),
            *("back", "degree", "newest", "grasped at", "unheard"),
            *(f"t{k}" for k in range(KEPT)),
        ),
        sums=("U_out", "P", "Q"),
        energies=("E_out", "given"),
        length="T",
        counts=("epoch", "hands", "as one"),
        origin_force=OriginForce(force="w", integral="P", double="Q", stiffness="k", damping="b", plain="as one"),
        store=("account", "level"),
        feels=True,
        initial_energy="initial_energy",
        dragless=True,
    )
)
