"""The small problem that a step with tools comes down to: contacts and proxies, with the body as a few columns.

With v̂₀ the body's motion under guessed contact forces, X = A⁻¹ H its columns, the motion is `v̂ = v̂₀ + X load`; the
load of a contact is the guess minus its force, that of a grasp its spring's pull towards the proxy. Everything that
contacts and proxies need to know is `Hᵀ v̂₀` and `Hᵀ X`, few numbers both. X is taken as it is, not as it should be:
the forces then fit the motion that comes out, even if the solver of the columns stopped early.
"""
# pyright: reportArgumentType=false, reportReturnType=false

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from cotouch.arrays import Float
from cotouch.mechanics._columns import Columns, read_column
from cotouch.mechanics._kernel import block, part
from cotouch.mechanics._modal_ports import factorise

Int = npt.NDArray[np.int32]
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
                    fraction = gain * along if wide else gain
                    push -= fraction * yielding[own, column[j]]
                    back -= fraction * yielding[column[j], own]
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
            fraction = 1.0
            if wide:
                fraction = 0.0
                for a in range(3):
                    fraction += direction[j, a] * direction[k, a]
            value = fraction * yielding[column[j], column[k]]
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
