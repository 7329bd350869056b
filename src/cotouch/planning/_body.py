"""The modes of a body, each of which the users' springs couple by itself."""

import numpy as np

from cotouch.arrays import Float
from cotouch.body import Body
from cotouch.errors import UnsupportedError
from cotouch.mechanics import WEIGHTS, mixed, model

# Dense matrices of more rows are not turned into modes unasked.
_MOST_ROWS = 1024
# Beside the largest, a stiffness or damping this small is round-off; and modes this close are the same.
_NOTHING, _DIGITS = 1e-10, 10


def modes_of(body: Body) -> dict[str, Float]:
    """Mass [kg], damping [Ns/m] and stiffness [N/m] of each mode, to hand to `plan`: `plan(..., **modes_of(body))`.

    Springs between users join equal places of their copies, so in the modal basis they join equal modes. Each mode is
    scaled so that a link pulls at it with the spring constant itself. Modes alike count once, for the slowest decides.

    What turns, bends far or weighs counts as what it is like at rest.

    Args:
        body: its matrices must be diagonal in one basis; a truncated one gives its shapes.

    Raises:
        UnsupportedError: the matrices do not commute, or the body is too large to find out.
    """
    body = body.linearised
    rows = body.mass.shape[0]
    remedy = "give its slowest mode by mass, damping and stiffness"
    if body.truncation is None and rows > _MOST_ROWS:
        raise UnsupportedError(
            f"the body has {rows} rows, too many to find all its modes; truncate it to a few (modes), or {remedy}"
        )
    try:
        operator = model(body).operator if body.truncation is not None else model(body, basis="modal").operator
    except UnsupportedError:
        raise UnsupportedError(
            "the body has no independent modes: its mass, damping, stiffness and the springs between "
            f"users are not diagonal in one basis; {remedy}"
        ) from None
    assert not any(mixed(operator, q) for q in range(WEIGHTS + 1))
    parts = np.stack([operator.mass, operator.damping, operator.stiffness]) / operator.weight[0]
    largest = parts.max(axis=1, keepdims=True)
    parts[parts <= _NOTHING * largest] = 0.0
    # Equal to some digits is equal: numerically each copy differs.
    digits = np.where(largest > 0, largest, 1.0) * 10.0**-_DIGITS
    _, kept = np.unique((parts / digits).round(), axis=1, return_index=True)
    return dict(zip(("mass", "damping", "stiffness"), parts[:, np.sort(kept)].copy(), strict=True))
