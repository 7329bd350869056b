"""What `paid` does to whole fields, four numbers at a time: its wave line, the payment, and the past.

Each pass is called for all whole fours, and for what is left over number by number.
"""

from cotouch.kernels import FOUR, load, size, splat, store, total, where
from cotouch.laws._end import End
from cotouch.laws._helper import helper
from cotouch.laws._paid_fields import (
    ASKED,
    BRAKE,
    EXERTED,
    KEPT,
    M_WAVE,
    PAST,
    V_BEFORE,
    WAVE,
    WAVE_IN,
    WAVE_OUT,
    WISH,
    X_BEFORE,
    V,
    X,
)

# Lanes of a number that is alone.
ONE = (0,)
# No force, nor integral of it, that anything could tell from none; no number gets so small that it costs time
# [N, Ns, Ns²].
NOTHING = 1e-15
# What is exerted is evened out over so long [s].
_EVEN = 0.02


@helper
def _receive_wave(end: End, share: float, first: int, last: int, lanes: tuple[int, ...]) -> float:
    there, before, wave, weight = end.received[M_WAVE], end.memory[WAVE_IN], end.memory[WAVE], end.weight
    power = splat(0.0, lanes)
    for r in range(first, last):
        rate = share * (load(there, r, lanes) - load(before, r, lanes))
        store(wave, r, rate, lanes)
        power = power + load(weight, r, lanes) * rate * rate
    return 0.5 * total(power)


@helper
def receive_wave(end: End, share: float) -> float:
    """Takes up what has come by the wave line, and gives its power [W].

    Args:
        end: of the link.
        share: of it in a second [1/s].
    """
    n = end.position.shape[0]
    return _receive_wave(end, share, 0, n // 4, FOUR) + _receive_wave(end, share, n // 4 * 4, n, ONE)


@helper
def _push_wave(end: End, fraction: float, root: float, first: int, last: int, lanes: tuple[int, ...]) -> None:
    T, before, wave, push = end.T, end.memory[WAVE_IN], end.memory[WAVE], end.push
    for r in range(first, last):
        rate = fraction * load(wave, r, lanes)
        store(wave, r, rate, lanes)
        store(before, r, load(before, r, lanes) + T * rate, lanes)
        store(push, r, root * rate, lanes)


@helper
def push_wave(end: End, fraction: float, root: float) -> None:
    """Pushes with what has come by the wave line.

    Args:
        end: of the link.
        fraction: of it that may.
        root: √(2b) of the line.
    """
    n = end.position.shape[0]
    _push_wave(end, fraction, root, 0, n // 4, FOUR)
    _push_wave(end, fraction, root, n // 4 * 4, n, ONE)


@helper
def _return_wave(end: End, root: float, first: int, last: int, lanes: tuple[int, ...]) -> float:
    T, wave, out, weight, mean = end.T, end.memory[WAVE], end.memory[WAVE_OUT], end.weight, end.mean
    sent, power = end.sent[M_WAVE], splat(0.0, lanes)
    for r in range(first, last):
        back = root * load(mean, r, lanes) - load(wave, r, lanes)
        gone = load(out, r, lanes) + T * back
        store(out, r, gone, lanes)
        store(sent, r, gone, lanes)
        power = power + load(weight, r, lanes) * back * back
    return 0.5 * total(power)


@helper
def return_wave(end: End, root: float) -> float:
    """Sends back what the copy left of it, and gives its power [W].

    Args:
        end: of the link.
        root: √(2b) of the line.
    """
    n = end.mean.shape[0]
    return _return_wave(end, root, 0, n // 4, FOUR) + _return_wave(end, root, n // 4 * 4, n, ONE)


@helper
def _price(end: End, first: int, last: int, lanes: tuple[int, ...]) -> tuple[float, float, float]:
    weight, wishes, velocity = end.weight, end.shared[WISH], end.velocity
    along, wished, speed = splat(0.0, lanes), splat(0.0, lanes), splat(0.0, lanes)
    for r in range(first, last):
        weighed, v = load(weight, r, lanes), load(velocity, r, lanes)
        force = load(wishes, r, lanes)
        along = along + weighed * force * v
        wished = wished + weighed * force * force
        speed = speed + weighed * v * v
    return total(along), total(wished), total(speed)


@helper
def price(end: End) -> tuple[float, float, float]:
    """`⟨wish, v⟩_W`, `‖wish‖²_W` and `‖v‖²_W` [W, N², m²/s²]."""
    n = end.position.shape[0]
    a, b, c = _price(end, 0, n // 4, FOUR)
    d, e, f = _price(end, n // 4 * 4, n, ONE)
    return a + d, b + e, c + f


@helper
def _pay(end: End, fraction: float, b: float, first: int, last: int, lanes: tuple[int, ...]) -> None:
    asked, wishes, velocity, push = end.shared[ASKED], end.shared[WISH], end.velocity, end.push
    for r in range(first, last):
        wish = load(wishes, r, lanes)
        store(asked, r, wish, lanes)
        wish = fraction * wish + b * load(velocity, r, lanes)
        store(wishes, r, wish, lanes)
        store(push, r, load(push, r, lanes) + wish, lanes)


@helper
def pay(end: End, fraction: float, b: float) -> None:
    """Pushes with what of the wish is paid for.

    Args:
        end: the last of the copy's.
        fraction: of the wish.
        b: of the damper beside it [Ns/m].
    """
    n = end.position.shape[0]
    _pay(end, fraction, b, 0, n // 4, FOUR)
    _pay(end, fraction, b, n // 4 * 4, n, ONE)


@helper
def _go_on(end: End, first: int, last: int, lanes: tuple[int, ...]) -> tuple[float, float]:
    own, position, mean, weight = end.shared, end.position, end.mean, end.weight
    x, v, x_before, v_before, wishes = own[X], own[V], own[X_BEFORE], own[V_BEFORE], own[WISH]
    done, speed, half = splat(0.0, lanes), splat(0.0, lanes), 0.5 * end.T
    exerted, brake, part = own[EXERTED], end.shared_scalars[BRAKE], min(end.T / _EVEN, 1.0)
    nothing, least = splat(0.0, lanes), splat(NOTHING, lanes)
    for r in range(first, last):
        now, weighed = load(mean, r, lanes), load(weight, r, lanes)
        store(x_before, r, load(x, r, lanes), lanes)
        store(v_before, r, load(v, r, lanes), lanes)
        store(x, r, load(position, r, lanes) - half * now, lanes)
        store(v, r, now, lanes)
        wish, before = load(wishes, r, lanes), load(exerted, r, lanes)
        after = before + part * (wish - brake * now - before)
        store(exerted, r, where(size(after) - least, after, nothing), lanes)
        done = done + weighed * now * wish
        speed = speed + weighed * now * now
    return total(done), total(speed)


@helper
def go_on(end: End) -> tuple[float, float]:
    """The newest of the past gets older by a step; gives `⟨wish, v̂⟩_W` and `‖v̂‖²_W` of the step [W, m²/s²]."""
    n = end.mean.shape[0]
    a, b = _go_on(end, 0, n // 4, FOUR)
    c, d = _go_on(end, n // 4 * 4, n, ONE)
    return a + c, b + d


@helper
def _keep(end: End, slot: int, first: int, last: int, lanes: tuple[int, ...]) -> None:
    x, v, position, mean = end.shared[PAST + slot], end.shared[PAST + KEPT + slot], end.position, end.mean
    half = 0.5 * end.T
    for r in range(first, last):
        now = load(mean, r, lanes)
        store(x, r, load(position, r, lanes) - half * now, lanes)
        store(v, r, now, lanes)


@helper
def keep(end: End, slot: int) -> None:
    """Keeps where the copy was in the middle of the step.

    Args:
        end: of the copy.
        slot: row of the past.
    """
    n = end.mean.shape[0]
    _keep(end, slot, 0, n // 4, FOUR)
    _keep(end, slot, n // 4 * 4, n, ONE)
