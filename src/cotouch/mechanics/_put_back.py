"""Putting the forces of the small problem back into the body and the proxies."""
# pyright: reportArgumentType=false, reportReturnType=false

from cotouch.arrays import Float
from cotouch.mechanics._columns import Columns, read_column
from cotouch.mechanics._kernel import part
from cotouch.mechanics._modal_ports import ModalPorts
from cotouch.mechanics._operator import Operator, row_sum
from cotouch.mechanics._small import Small, sound
from cotouch.mechanics._surface import FOUR
from cotouch.mechanics._vector import at, load, splat, store, total

# What the energy's two sides may differ by, beside the sizes of their terms: what rounding does to the sums. At rest in
# contact the terms are large and the sums nothing; a quotient of these would be any number.
_NOTICED = 1e-15


@part
def put_back(
    op: Operator,
    columns: Columns,
    small: Small,
    modal_ports: ModalPorts,
    T: float,
    account: Float,
    first: int,
    tools: int,
    elements: int,
    used: int,
    held: int,
    values: Float,
    scale: float,
    diagonal: Float,
    rhs: Float,
    mean: Float,
    modal: bool,
    lanes: tuple[int, ...],
) -> None:
    """Puts forces into body and proxies, and scales both so that the step's work is what its energy changes by.

    If the contacts would then take more from an account than it has, which takes a solver that stopped far too early,
    they stay without force in this step.

    Args:
        op: gives the pattern.
        columns: how the body yields.
        small: forces.
        modal_ports: of a modal body.
        T: length of the step [s].
        account: of all tools [J].
        first: the first of these tools.
        tools: how many.
        elements: number of elements.
        used: number of columns.
        held: number of ports.
        values: off the diagonal of A, (entries,).
        scale: of them.
        diagonal: of A, (rows,).
        rhs: b, (rows, width).
        mean: v̂₀ going in, v̂ coming out, (rows, width).
        modal: whether A is diagonal but for ports.
        lanes: fixes the width.
    """
    force, direction, column, owner, solved = small.force, small.direction, small.column, small.owner, small.solved
    loads, proxies, grip_gain, grip_column = small.load, small.mean, small.grip_gain, small.grip_column
    reading, rate, drive, inertia = small.reading, small.rate, small.drive, small.inertia
    wide, size, rows = mean.shape[1] > 1, 3 * tools, mean.shape[0]
    width = 3 if wide else 1
    power = splat(0.0, lanes)  # v̂₀ᵀ b, which is v̂₀ᵀ A v̂₀
    for i in range(rows):
        power = power + load(mean, i, lanes) * load(rhs, i, lanes)
    base = total(power)
    work, form = base, base
    factor = 1.0
    for attempt in range(2):
        sign = 1.0 if attempt == 0 else -1.0
        for c in range(used):
            for a in range(width):
                loads[c, a] = 0.0
        for j in range(elements):
            for a in range(width):
                known = small.guess[j] if attempt == 0 else 0.0
                loads[column[j], a] -= sign * (direction[j, a] if wide else 1.0) * (force[j] - known)
        for i in range(size):
            change = 0.0
            for j in range(elements):
                change += solved[i, j] * force[j]
            proxies[i] += sign * change
            p, a = i // 3, i % 3
            if grip_gain[p] > 0.0:
                pull = grip_gain[p] * (proxies[i] if attempt == 0 else -change)
                if wide:
                    loads[grip_column[p], a] = pull
                else:
                    loads[grip_column[p] + a, 0] = pull
        if attempt == 1:
            for j in range(elements):
                force[j] = 0.0
        if modal:
            gain, more = _add_modal(columns, loads, modal_ports, used, held, diagonal, rhs, mean, lanes)
        else:
            gain, more = _add_nodal(op, columns, loads, used, values, scale, diagonal, rhs, mean, lanes)
        work += gain
        form += more
        for c in range(used):
            for a in range(width):
                reading[c, a] = read_column(columns, c, mean, a)
        supplied, spent, terms = work, form, base + abs(gain) + abs(more)
        for j in range(elements):
            body, proxy = 0.0, 0.0
            for a in range(3):
                proxy += direction[j, a] * proxies[3 * owner[j] + a]
            for a in range(width):
                body += (direction[j, a] if wide else 1.0) * reading[column[j], a]
            rate[j] = body - proxy
            supplied -= force[j] * rate[j] - small.guess[j] * body  # b holds the guess
            terms += abs(force[j]) * (abs(body) + abs(proxy))
        for i in range(size):
            p, a = i // 3, i % 3
            w = proxies[i]
            supplied += w * drive[i]
            spent += w * w * inertia[p]
            terms += abs(w * drive[i]) + w * w * inertia[p]
            if grip_gain[p] > 0.0:
                g = grip_column[p]
                v = reading[g, a] if wide else reading[g + a, 0]
                spent -= 2.0 * grip_gain[p] * w * v
        factor = 1.0
        if not abs(supplied - spent) <= _NOTICED * terms:
            # Where only rounding is left of what is spent, standing still is the one motion whose energy is known.
            factor = 0.0 if spent <= _NOTICED * terms else max(supplied, 0.0) / spent
        if sound(small, elements, account, first, tools, T * factor, True):
            break
    if factor != 1.0:
        for i in range(rows):
            store(mean, i, factor * load(mean, i, lanes), lanes)
        for i in range(size):
            proxies[i] *= factor
        for j in range(elements):
            rate[j] *= factor
        for c in range(used):
            for a in range(width):
                reading[c, a] *= factor


@part
def _add_nodal(
    op: Operator,
    columns: Columns,
    loads: Float,
    used: int,
    values: Float,
    scale: float,
    diagonal: Float,
    rhs: Float,
    mean: Float,
    lanes: tuple[int, ...],
) -> tuple[float, float]:
    """Adds `y = X loads` to v̂, where the columns reach.

    Returns:
        `yᵀ b` and `yᵀ A (2 v̂ + y)`: what v̂ᵀ b and v̂ᵀ A v̂ grow by.
    """
    y = columns.direction  # zero everywhere, and again when this is done
    reached, width = columns.size[0], 3 if len(lanes) > 1 else 1
    for place in range(reached):
        i = at(columns.reach, place)
        step = splat(0.0, FOUR)
        for c in range(used):
            entry = ((c // 4) * mean.shape[0] + i) * 4 + c % 4
            step = step + at(columns.answer, entry) * load(loads, c, FOUR)
        store(y, i, step, FOUR)
    gain, form = splat(0.0, FOUR), splat(0.0, FOUR)
    for place in range(reached):
        i = at(columns.reach, place)
        own = load(y, i, FOUR)
        gain = gain + own * load(rhs, i, lanes)
        # Twice what v̂ has and once what y has; in a field of one column y has only its first lane.
        image = 2.0 * (at(diagonal, i) * load(mean, i, lanes) + scale * row_sum(op, values, i, mean, lanes))
        form = form + own * (at(diagonal, i) * own + scale * row_sum(op, values, i, y, FOUR) + image)
    for place in range(reached):
        i = at(columns.reach, place)
        for a in range(width):
            mean[i, a] += y[i, a]
    for place in range(reached):
        store(y, at(columns.reach, place), splat(0.0, FOUR), FOUR)
    return total(gain), total(form)


@part
def _add_modal(
    columns: Columns,
    loads: Float,
    modal_ports: ModalPorts,
    used: int,
    held: int,
    diagonal: Float,
    rhs: Float,
    mean: Float,
    lanes: tuple[int, ...],
) -> tuple[float, float]:
    """The same where A is diagonal but for ports."""
    rows, width = mean.shape[0], 3 if len(lanes) > 1 else 1
    gain = form = 0.0
    form -= _modal_ports_form(modal_ports, held, mean, lanes)
    for i in range(rows):
        for a in range(width):
            y = 0.0
            for c in range(used):
                y += columns.answer[c // 4, i, c % 4] * loads[c, a]
            gain += y * rhs[i, a]
            form += diagonal[i] * y * (2.0 * mean[i, a] + y)
            mean[i, a] += y
    return gain, form + _modal_ports_form(modal_ports, held, mean, lanes)


@part
def _modal_ports_form(modal_ports: ModalPorts, held: int, mean: Float, lanes: tuple[int, ...]) -> float:
    """What ports add to v̂ᵀ A v̂."""
    form = 0.0
    for p in range(held):
        reading = splat(0.0, lanes)
        for i in range(mean.shape[0]):
            reading = reading + modal_ports.shape[p, i] * load(mean, i, lanes)
        form += modal_ports.gain[p] * modal_ports.gain[p] * total(reading * reading)
    return form
