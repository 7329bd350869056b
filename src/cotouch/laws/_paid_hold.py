"""What `paid` wishes where its account cannot pay for it: what it exerts already, and little more.

A hand that holds still where others do not want it pulls its copy back. An account that is spent to the last on moving
the copy against it is then empty; the copy recoils, which fills the account, and so on: the copy shivers. A force costs
nothing where nothing moves. So what was exerted of late goes on, only as much more is wished as the account can pay for
in the steps that follow, and meanwhile a damper stops the copy.
"""

from cotouch.kernels import FOUR, load, size, splat, store, total, upper, where
from cotouch.laws._end import End
from cotouch.laws._helper import helper
from cotouch.laws._paid_fields import EXERTED, HELD, LEVEL, STILL, WISH
from cotouch.laws._paid_rows import ONE

# Share of its level that an account keeps: without any, it pays for no force at all.
_KEEPS = 0.05
# A wish of s times more, with s in proportion to the account, makes a mass m and the account swing: ω² is more than the
# steps can follow if m times the account is less than this many times N T² times the price of more.
_SLOWNESS = 3.0


@helper
def _price_of_more(end: End, first: int, last: int, lanes: tuple[int, ...]) -> float:
    weight, wishes, exerted, nothing = end.weight, end.shared[WISH], end.shared[EXERTED], splat(0.0, lanes)
    price = nothing
    for r in range(first, last):
        now = load(exerted, r, lanes)
        if total(size(now)) == 0.0:
            continue
        more = load(weight, r, lanes) * now * (load(wishes, r, lanes) - now)
        # Of a node all axes together.
        price = price + upper(splat(0.25 * total(more), lanes) if end.width > 1 else more, nothing)
    return total(price)


@helper
def _hold(end: End, less: float, first: int, last: int, lanes: tuple[int, ...]) -> None:
    wishes, exerted, nothing = end.shared[WISH], end.shared[EXERTED], splat(0.0, lanes)
    for r in range(first, last):
        wish, now = load(wishes, r, lanes), load(exerted, r, lanes)
        if total(size(now)) == 0.0:
            continue
        more = wish - now
        along = splat(total(now * more), lanes) if end.width > 1 else now * more
        store(wishes, r, wish - where(along, less * more, nothing), lanes)


@helper
def hold_on(end: End, account: float) -> float:
    """As the account runs dry, nodes wish for no more than they exert already.

    Nodes that wish for less do as they wish, because giving way fills the account. A copy that its own user does not
    hold is left alone, because nothing pulls it back.

    Args:
        end: of the copy's last link.
        account: what it has, >= 0 [J].

    Returns:
        Damper that stops the copy meanwhile [Ns/m].
    """
    T, numbers, n, mass = end.T, end.shared_scalars, end.position.shape[0], end.parameters[STILL]
    if numbers[HELD] == 0.0 or mass == 0.0:
        return 0.0
    price = _price_of_more(end, 0, n // 4, FOUR) + _price_of_more(end, n // 4 * 4, n, ONE)
    spare = max(account - _KEEPS * numbers[LEVEL], 0.0)
    enough = _SLOWNESS * end.copies * T * T * price
    if mass * spare >= enough:
        return 0.0
    less = 1.0 - mass * spare / enough
    _hold(end, less, 0, n // 4, FOUR)
    _hold(end, less, n // 4 * 4, n, ONE)
    return less * mass / (T * (n // end.width))
