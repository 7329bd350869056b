"""The small problem that a step with tools comes down to: contacts and proxies, with the body as a few columns.

With v̂₀ the body's motion under guessed contact forces, X = A⁻¹ H its columns, the motion is `v̂ = v̂₀ + X load`; the load
of a contact is the guess minus its force, that of a grasp its spring's pull towards the proxy. Everything that contacts
and proxies need to know is `Hᵀ v̂₀` and `Hᵀ X`, few numbers both. X is taken as it is, not as it should be: the forces
then fit the motion that comes out, even if the solver of the columns stopped early.
"""
# pyright: reportArgumentType=false, reportReturnType=false

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from cotouch.mechanics._columns import Columns, read_column
from cotouch.mechanics._kernel import block, part
from cotouch.mechanics._operator import Operator, row_sum
from cotouch.mechanics._ports import Ports, factorise
from cotouch.mechanics._surface import FOUR
from cotouch.mechanics._vector import at, load, splat, store, total

Float = npt.NDArray[np.float64]
Int = npt.NDArray[np.int32]

# What the energy's two sides may differ by, beside the sizes of their terms: what rounding does to the sums. At rest in
# contact the terms are large and the sums nothing; a quotient of these would be any number.
_NOTICED = 1e-15
# How deep an account may go into debt, as a share of the energy that moves within the step.
_DEBT = 1e-12
# What contacts at least leave in an account that they would empty: room for rounding and for the scale of the step.
_LEFT = 1e-8


class Small(NamedTuple):
    """Scratch of the small problem; a proxy p is the tool `first + p`.

    Attributes:
        column: column of each element, (elements,).
        owner: proxy of each element, (elements,).
        direction: of each element, (elements, 4).
        depth: of each contact, (contacts,).
        stiffness: likewise.
        loss: λ/T likewise.
        friction: likewise.
        free: motion of each element without contacts, (elements,).
        compliance: R, (elements, elements).
        force: (elements,).
        guess: what the solve for v̂₀ took the force to be, (elements,).
        trail: scratch of the sweeps, (2, elements).
        rate: mean velocity of the body less that of the proxy along each element, (elements,).
        yielding: Hᵀ X, (columns, columns).
        reading: Hᵀ v̂ at the columns, (columns, 4).
        load: force at each column that is put into the body, (columns, 4).
        grip_column: first column of each proxy's grasp, (proxies,).
        grip_gain: coefficient of a held node's velocity in its spring's force; 0 where nothing is held, (proxies,).
        pushing: forces of the elements on the proxies' coordinates, (3 proxies, elements).
        reading_back: how the elements' motion depends on the proxies' coordinates, (3 proxies, elements).
        solved: S⁻¹ pushing, (3 proxies, elements).
        proxies: S and its Cholesky factor, (3 proxies, 3 proxies).
        drive: right-hand side of the proxies, (3 proxies,).
        mean: ŵ, (3 proxies,).
        inertia: coefficient of each proxy's own ŵ, (proxies,).
    """

    column: Int
    owner: Int
    direction: Float
    depth: Float
    stiffness: Float
    loss: Float
    friction: Float
    free: Float
    compliance: Float
    force: Float
    guess: Float
    trail: Float
    rate: Float
    yielding: Float
    reading: Float
    load: Float
    grip_column: Int
    grip_gain: Float
    pushing: Float
    reading_back: Float
    solved: Float
    proxies: Float
    drive: Float
    mean: Float
    inertia: Float


def small(contacts: int, tools: int, columns: int) -> Small:
    """Room for so many contacts (three elements each), tools and columns."""
    elements, size = 3 * contacts, 3 * tools
    return Small(
        column=np.zeros(elements, dtype=np.int32),
        owner=np.zeros(elements, dtype=np.int32),
        direction=np.zeros((elements, 4)),
        depth=np.zeros(contacts),
        stiffness=np.zeros(contacts),
        loss=np.zeros(contacts),
        friction=np.zeros(contacts),
        free=np.zeros(elements),
        compliance=np.zeros((elements, elements)),
        force=np.zeros(elements),
        guess=np.zeros(elements),
        trail=np.zeros((2, elements)),
        rate=np.zeros(elements),
        yielding=np.zeros((columns, columns)),
        reading=np.zeros((columns, 4)),
        load=np.zeros((columns, 4)),
        grip_column=np.zeros(tools, dtype=np.int32),
        grip_gain=np.zeros(tools),
        pushing=np.zeros((size, elements)),
        reading_back=np.zeros((size, elements)),
        solved=np.zeros((size, elements)),
        proxies=np.zeros((size, size)),
        drive=np.zeros(size),
        mean=np.zeros(size),
        inertia=np.zeros(tools),
    )


@part
def reduce_step(columns: Columns, small: Small, T: float, tools: int, elements: int, used: int, mean: Float) -> None:
    """Motion of the elements without contacts, and the matrix R by which contact forces take it away.

    Args:
        columns: how the body yields.
        small: result: `free`, `compliance`, and ŵ without contacts.
        T: length of the step [s].
        tools: number of proxies.
        elements: number of elements.
        used: number of columns.
        mean: v̂₀, (rows, width).
    """
    wide, size = mean.shape[1] > 1, 3 * tools
    yielding, reading, direction, column = small.yielding, small.reading, small.direction, small.column
    proxies, inertia, drive, still = small.proxies, small.inertia, small.drive, small.mean
    pushing, back_of, solved, owner = small.pushing, small.reading_back, small.solved, small.owner
    grip_gain, grip_column, free_of, compliance = small.grip_gain, small.grip_column, small.free, small.compliance
    answers = columns.answer
    for c in range(used):
        for o in range(used):
            yielding[c, o] = read_column(columns, c, answers[o // 4], o % 4)
        for a in range(3 if wide else 1):
            reading[c, a] = read_column(columns, c, mean, a)
    for j in range(elements):  # without the guess
        for c in range(used):
            moved = yielding[c, column[j]] * small.guess[j]
            for a in range(3 if wide else 1):
                reading[c, a] += moved * (direction[j, a] if wide else 1.0)
    for i in range(size):
        for j in range(size):
            proxies[i, j] = 0.0
    for p in range(tools):
        gain, g = grip_gain[p], grip_column[p]
        for a in range(3):
            row, own = 3 * p + a, g if wide else g + a
            proxies[row, row] = inertia[p]
            still[row] = drive[row]
            if gain > 0.0:
                still[row] += gain * reading[own, a if wide else 0]
            for j in range(elements):
                along = direction[j, a]
                push, back = (along, along) if owner[j] == p else (0.0, 0.0)
                if gain > 0.0:
                    share = gain * along if wide else gain
                    push -= share * yielding[own, column[j]]
                    back -= share * yielding[column[j], own]
                pushing[row, j] = push
                back_of[row, j] = back
            for other in range(3 * (p + 1)):
                q, b = other // 3, other % 3
                if gain > 0.0 and grip_gain[q] > 0.0 and (a == b or not wide):
                    beside = grip_column[q] if wide else grip_column[q] + b
                    both = 0.5 * (yielding[own, beside] + yielding[beside, own])
                    proxies[row, other] -= gain * grip_gain[q] * both
    factorise(proxies, size)
    _substitute(proxies, size, still)
    for j in range(elements):
        for i in range(size):
            solved[i, j] = pushing[i, j]
        _substitute_column(proxies, size, solved, j)
    for j in range(elements):
        free = 0.0
        for a in range(3 if wide else 1):
            free += (direction[j, a] if wide else 1.0) * reading[column[j], a]
        for i in range(size):
            free -= back_of[i, j] * still[i]
        free_of[j] = T * free
        for k in range(elements):
            share = 1.0
            if wide:
                share = 0.0
                for a in range(3):
                    share += direction[j, a] * direction[k, a]
            value = share * yielding[column[j], column[k]]
            for i in range(size):
                value += back_of[i, j] * solved[i, k]
            compliance[j, k] = T * value


@part
def _substitute(factor: Float, size: int, values: Float) -> None:
    """Solves with a Cholesky factor, in place."""
    for i in range(size):
        for k in range(i):
            values[i] -= factor[i, k] * values[k]
        values[i] /= factor[i, i]
    for back in range(size):
        i = size - 1 - back
        for k in range(i + 1, size):
            values[i] -= factor[k, i] * values[k]
        values[i] /= factor[i, i]


@part
def _substitute_column(factor: Float, size: int, values: Float, j: int) -> None:
    """The same for a column of a matrix."""
    for i in range(size):
        for k in range(i):
            values[i, j] -= factor[i, k] * values[k, j]
        values[i, j] /= factor[i, i]
    for back in range(size):
        i = size - 1 - back
        for k in range(i + 1, size):
            values[i, j] -= factor[k, i] * values[k, j]
        values[i, j] /= factor[i, i]


@part
def limit(small: Small, elements: int, account: Float, first: int, tools: int, coarse: float) -> None:
    """Shortens the forces of a tool whose contacts would take all of its account, or more.

    A contact that lets go returns all that is in it, and unfinished sweeps may ask for more. What the forces gain is
    concave in a common factor, so the factor that fits if the motion stayed fits all the more if it changes with them.

    Args:
        small: forces.
        elements: number of elements.
        account: of all tools [J].
        first: the first of these tools.
        tools: how many.
        coarse: how coarse the columns are, which is what the motion may differ by from what the forces were found for.
    """
    most = 1.0 - min(max(coarse, _LEFT), 0.5)
    owner, free, compliance, force = small.owner, small.free, small.compliance, small.force
    for p in range(tools):
        gained = 0.0
        for j in range(elements):
            if owner[j] == p:
                motion = free[j]
                for k in range(elements):
                    motion -= compliance[j, k] * force[k]
                gained += force[j] * motion
        have = max(account[first + p], 0.0)
        if gained < -most * have:
            factor = most * have / -gained
            for j in range(elements):
                if owner[j] == p:
                    force[j] *= factor


@block
def sound(small: Small, elements: int, account: Float, first: int, tools: int, scale: float, measured: bool) -> bool:
    """Whether the contacts' forces are numbers, and no account pays out what it does not have.

    Args:
        small: forces, and rates if `measured`; else the rates are what the small problem says.
        elements: number of elements.
        account: of all tools [J].
        first: the first of these tools.
        tools: how many.
        scale: of the rates, T or more, and 1 if they are motions.
        measured: whether `small.rate` is known.
    """
    owner, rate, free, compliance, force = small.owner, small.rate, small.free, small.compliance, small.force
    for p in range(tools):
        gained, size = 0.0, 0.0
        for j in range(elements):
            if owner[j] == p:
                if measured:
                    motion = scale * rate[j]
                else:
                    motion = free[j]
                    for k in range(elements):
                        motion -= compliance[j, k] * force[k]
                gained += force[j] * motion
                size += abs(force[j] * motion)
        if not (size < np.inf and (gained >= 0.0 or account[first + p] + gained >= -_DEBT * size)):
            return False
    return True


@part
def put_back(
    op: Operator,
    columns: Columns,
    small: Small,
    ports: Ports,
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
        ports: of a modal body.
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
            gain, more = _add_modal(columns, loads, ports, used, held, diagonal, rhs, mean, lanes)
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
    ports: Ports,
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
    form -= _ports_form(ports, held, mean, lanes)
    for i in range(rows):
        for a in range(width):
            y = 0.0
            for c in range(used):
                y += columns.answer[c // 4, i, c % 4] * loads[c, a]
            gain += y * rhs[i, a]
            form += diagonal[i] * y * (2.0 * mean[i, a] + y)
            mean[i, a] += y
    return gain, form + _ports_form(ports, held, mean, lanes)


@part
def _ports_form(ports: Ports, held: int, mean: Float, lanes: tuple[int, ...]) -> float:
    """What ports add to v̂ᵀ A v̂."""
    form = 0.0
    for p in range(held):
        reading = splat(0.0, lanes)
        for i in range(mean.shape[0]):
            reading = reading + ports.shape[p, i] * load(mean, i, lanes)
        form += ports.gain[p] * ports.gain[p] * total(reading * reading)
    return form
