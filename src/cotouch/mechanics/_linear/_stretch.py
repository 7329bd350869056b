"""What a link's spring holds before the step, and a sample taken only part of the way."""

from cotouch.arrays import Float
from cotouch.kernels import at, kernel, load, splat, store, total
from cotouch.mechanics._linear._operator import WEIGHTS, Operator, multiply


@kernel
def stretches(
    weight: Float, position: Float, sample: Float, held: Float, lanes: tuple[int, ...]
) -> tuple[float, float]:
    """Squares of the distances to a sample and to what is held, in the norm of a diagonal weight.

    Args:
        weight: diagonal of W, (rows,).
        position: x, (rows, width) [m].
        sample: y, likewise.
        held: ȳ, likewise.
        lanes: fixes the width of a row.

    Returns:
        ‖x - y‖²_W and ‖x - ȳ‖²_W.
    """
    to_sample, to_held = splat(0.0, lanes), splat(0.0, lanes)
    for i in range(weight.shape[0]):
        x, w = load(position, i, lanes), at(weight, i)
        away, before = x - load(sample, i, lanes), x - load(held, i, lanes)
        to_sample = to_sample + w * (away * away)
        to_held = to_held + w * (before * before)
    return total(to_sample), total(to_held)


@kernel
def mixed_stretch(
    op: Operator, w: int, position: Float, sample: Float, away: Float, image: Float, lanes: tuple[int, ...]
) -> float:
    """‖x - y‖²_W of weight w, which has entries off the diagonal; `away` and `image` are scratch, (rows, width).

    Args:
        op: of the body.
        w: number of the weight.
        position: x, (rows, width) [m].
        sample: y, likewise.
        away: scratch.
        image: scratch.
        lanes: fixes the width of a row.
    """
    for i in range(op.mass.shape[0]):
        store(away, i, load(position, i, lanes) - load(sample, i, lanes), lanes)
    return multiply(op, WEIGHTS + w, op.weight[w], away, image, lanes)


@kernel
def approach(position: Float, sample: Float, fraction: float, held: Float, lanes: tuple[int, ...]) -> None:
    """`ȳ = x + fraction (y - x)`, written to `held`.

    Args:
        position: x, (rows, width) [m].
        sample: y, likewise.
        fraction: of the way to it.
        held: result.
        lanes: fixes the width of a row.
    """
    for i in range(position.shape[0]):
        x = load(position, i, lanes)
        store(held, i, x + fraction * (load(sample, i, lanes) - x), lanes)
