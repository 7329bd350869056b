"""One NPMI step of one user's copy under synchronisation control, and what it did with energy.

Everything that advances a copy calls `step`: the single peer, the simulator of many, live or not.
"""

from cotouch.arrays import Float
from cotouch.kernels import at, inner, kernel, load, put, splat, store, total
from cotouch.mechanics._linear._operator import (
    DAMPING,
    MASS,
    STIFFNESS,
    WEIGHTS,
    Operator,
    mixed,
    multiply,
    pull,
    row_product,
    taken_off,
)
from cotouch.mechanics._linear._solve import solve_step
from cotouch.mechanics._linear._state import (
    BODY_LOSS,
    ELASTIC,
    EXTRA_LOSS,
    ITERATIONS,
    KINETIC,
    LOCAL_LOSS,
    SUPPLIED,
    Links,
    Ports,
    State,
    Workspace,
)

# Rows handled together, so that they are still in the first-level cache when each link comes to read them.
_BLOCK = 64


@kernel
def step(
    op: Operator,
    state: State,
    links: Links,
    ports: Ports,
    local_damping: Float,
    extra_damping: Float,
    T: float,
    sample: int,
    work: Workspace,
    ledger: Float,
    link_work: Float,
    tolerance: float,
    cap: int,
    lanes: tuple[int, ...],
) -> None:
    """Advances one copy by T: solves `A v̂ = b`, then `x⁺ = x + T v̂`, `v⁺ = 2 v̂ - v` [Lee & Huang 2010, eq. 1, 3].

    Args:
        op: the body's matrices.
        state: of the copy; changed in place.
        links: to the neighbours.
        ports: what holds the copy; `force` is written.
        local_damping: B_i as coefficients over the weights, (weights,).
        extra_damping: B_e likewise, (weights,).
        T: length of the step, > 0 [s].
        sample: slot of `links.samples` that receives x̂, the position at mid-step; negative: none.
        work: scratch.
        ledger: result (LEDGER_COLUMNS,): work supplied at the ports and dissipated by body, local and extra damping
            during the step; kinetic and elastic energy after it [J]; iterations of the solver.
        link_work: result (links,), this copy's entries: work that each link did on it [J].
        tolerance: of the solver.
        cap: on its iterations.
        lanes: fixes the width of a row.
    """
    assemble(op, state, links, ports, local_damping, extra_damping, T, work, lanes)
    ledger[ITERATIONS] = solve_step(op, ports, work, tolerance, 0, cap, lanes)
    ledger[SUPPLIED] = port_work(op, state, ports, T, work.mean, lanes)
    move(op, state, links, T, sample, work, link_work, lanes)
    book_energies(op, state, local_damping, extra_damping, T, work, ledger, lanes)


@kernel
def assemble(
    op: Operator,
    state: State,
    links: Links,
    ports: Ports,
    local_damping: Float,
    extra_damping: Float,
    T: float,
    work: Workspace,
    lanes: tuple[int, ...],
) -> None:
    """Diagonal and family scales of `A = (2/T)M/N + B/N + (T/2)K/N + ...`, and the right-hand side.

    Args:
        op: the body's matrices.
        state: of the copy.
        links: the neighbours' samples.
        ports: what holds the copy.
        local_damping: B_i as coefficients over the weights, (weights,).
        extra_damping: B_e likewise.
        T: length of the step [s].
        work: result: `diagonal`, `scale`, `gain`, `port_gain` and `rhs`.
        lanes: fixes the width of a row.
    """
    rows, weights, families = op.mass.shape[0], op.weight.shape[0], op.entries.shape[0]
    half, inertia = 0.5 * T, 2.0 * op.copy_scale / T
    for w in range(weights):
        work.gain[w] = local_damping[w] + extra_damping[w]
    for link in range(links.slot.shape[0]):
        w = at(links.weight, link)
        put(work.gain, w, at(work.gain, w) + half * at(links.strength, link))
    pushed = links.push.shape[0] > 0
    if pushed:
        for link in range(links.slot.shape[0]):
            w = at(links.weight, link)
            put(work.gain, w, at(work.gain, w) + at(links.brake, link))
    for family in range(families):
        scale = inertia * op.mix[MASS, family] + op.copy_scale * op.mix[DAMPING, family]
        scale += half * op.copy_scale * op.mix[STIFFNESS, family]
        for w in range(weights):
            scale += work.gain[w] * op.mix[WEIGHTS + w, family]
        work.scale[family] = scale

    heavy = mixed(op, MASS)
    for first in range(0, rows, _BLOCK):
        last = min(first + _BLOCK, rows)
        for i in range(first, last):
            own = (
                inertia * at(op.mass, i)
                + op.copy_scale * at(op.damping, i)
                + (half * op.copy_scale) * at(op.stiffness, i)
            )
            if op.taken.shape[0] > 0:
                own += op.copy_scale * taken_off(op, T, i)
            work.diagonal[i] = own
            impulse = load(state.momentum, i, lanes) if heavy else at(op.mass, i) * load(state.velocity, i, lanes)
            store(work.rhs, i, inertia * impulse - op.copy_scale * load(state.tension, i, lanes), lanes)
        for w in range(weights):
            weight, gain = op.weight[w], work.gain[w]
            for i in range(first, last):
                work.diagonal[i] += gain * at(weight, i)
        for link in range(links.slot.shape[0]):
            weight, strength, base = op.weight[links.weight[link]], links.strength[link], links.slot[link] * rows
            for i in range(first, last):
                stretch = load(state.position, i, lanes) - load(links.samples, base + i, lanes)
                store(work.rhs, i, load(work.rhs, i, lanes) - (strength * at(weight, i)) * stretch, lanes)
        if pushed:
            for link in range(links.slot.shape[0]):
                own, base = at(links.weight, link) * rows, link * rows
                for i in range(first, last):
                    push = at(op.weight, own + i) * load(links.push, base + i, lanes)
                    store(work.rhs, i, load(work.rhs, i, lanes) + push, lanes)
    for w in range(weights):
        if mixed(op, WEIGHTS + w):  # what such a weight couples off the diagonal; its diagonal is in already
            for i in range(rows):
                stretch = splat(0.0, lanes)
                for link in range(links.slot.shape[0]):
                    if at(links.weight, link) == w:
                        sample = load(links.samples, at(links.slot, link) * rows + i, lanes)
                        stretch = stretch + at(links.strength, link) * (load(state.position, i, lanes) - sample)
                store(work.stretch, i, stretch, lanes)
            for i in range(rows):
                b = load(work.rhs, i, lanes)
                for family in range(families):
                    coefficient = op.mix[WEIGHTS + w, family]
                    if coefficient != 0.0:
                        b = b - coefficient * row_product(op, family, i, work.stretch, lanes)
                store(work.rhs, i, b, lanes)

    dense = ports.shape.shape[0] > 0
    for p in range(ports.row.shape[0]):
        k, b = at(ports.stiffness, p), at(ports.damping, p)
        gain = b + half * k
        put(work.port_gain, p, gain)
        start, end = load(ports.start, p, lanes), load(ports.end, p, lanes)
        desired = (0.5 * k) * (start + end) + (b / T) * (end - start) + load(ports.push, p, lanes)
        if dense:
            place = splat(0.0, lanes)
            for i in range(rows):
                place = place + at(ports.shape, (p, i)) * load(state.position, i, lanes)
            force = desired - k * place
            for i in range(rows):
                store(work.rhs, i, load(work.rhs, i, lanes) + at(ports.shape, (p, i)) * force, lanes)
        else:
            i = at(ports.row, p)
            put(work.diagonal, i, at(work.diagonal, i) + gain)
            force = desired - k * load(state.position, i, lanes)
            store(work.rhs, i, load(work.rhs, i, lanes) + force, lanes)


@inner
def port_work(op: Operator, state: State, ports: Ports, T: float, mean: Float, lanes: tuple[int, ...]) -> float:
    """Mean force at every port, and the work `T v̂ᵀ f` that they did together.

    Args:
        op: the body's matrices.
        state: of the copy.
        ports: what holds the copy; `force` is written.
        T: length of the step [s].
        mean: v̂, (rows, width) [m/s].
        lanes: fixes the width of a row.
    """
    dense = ports.shape.shape[0] > 0
    supplied = 0.0
    for p in range(ports.row.shape[0]):
        place, rate = splat(0.0, lanes), splat(0.0, lanes)
        if dense:
            for i in range(op.mass.shape[0]):
                place = place + at(ports.shape, (p, i)) * load(state.position, i, lanes)
                rate = rate + at(ports.shape, (p, i)) * load(mean, i, lanes)
        else:
            place, rate = load(state.position, at(ports.row, p), lanes), load(mean, at(ports.row, p), lanes)
        k, b = at(ports.stiffness, p), at(ports.damping, p)
        start, end = load(ports.start, p, lanes), load(ports.end, p, lanes)
        stretch = 0.5 * (start + end) - (place + (0.5 * T) * rate)
        slip = (1.0 / T) * (end - start) - rate
        force = k * stretch + b * slip + load(ports.push, p, lanes)
        store(ports.force, p, force, lanes)
        supplied += T * total(force * rate)
    return supplied


@kernel
def move(
    op: Operator,
    state: State,
    links: Links,
    T: float,
    sample: int,
    work: Workspace,
    link_work: Float,
    lanes: tuple[int, ...],
) -> None:
    """New position, velocity and sample; work of every link; `v̂ᵀ W v̂` of every diagonal weight.

    Args:
        op: the body's matrices.
        state: of the copy; changed in place.
        links: the neighbours' samples.
        T: length of the step [s].
        sample: slot of `links.samples` that receives x̂; negative: none.
        work: `mean` is v̂; `quadratic` is written.
        link_work: result (links,) [J].
        lanes: fixes the width of a row.
    """
    rows, weights = op.mass.shape[0], op.weight.shape[0]
    for link in range(links.slot.shape[0]):
        put(link_work, link, 0.0)
    for w in range(weights):
        work.quadratic[w] = 0.0
    for first in range(0, rows, _BLOCK):
        last = min(first + _BLOCK, rows)
        for link in range(links.slot.shape[0]):
            own = at(links.weight, link) * rows
            base = at(links.slot, link) * rows
            power = splat(0.0, lanes)
            for i in range(first, last):
                rate = load(work.mean, i, lanes)
                middle = load(state.position, i, lanes) + (0.5 * T) * rate
                power = power + at(op.weight, own + i) * (rate * (middle - load(links.samples, base + i, lanes)))
            put(link_work, link, at(link_work, link) - T * at(links.strength, link) * total(power))
        if links.push.shape[0] > 0:
            for link in range(links.slot.shape[0]):
                own, brake = at(links.weight, link) * rows, at(links.brake, link)
                base, power = link * rows, splat(0.0, lanes)
                for i in range(first, last):
                    rate = load(work.mean, i, lanes)
                    force = load(links.push, base + i, lanes) - brake * rate
                    power = power + at(op.weight, own + i) * (rate * force)
                put(link_work, link, at(link_work, link) + T * total(power))
        for i in range(first, last):
            rate = load(work.mean, i, lanes)
            x = load(state.position, i, lanes)
            if sample >= 0:
                store(links.samples, sample * rows + i, x + (0.5 * T) * rate, lanes)
            store(state.position, i, x + T * rate, lanes)
            store(state.velocity, i, 2.0 * rate - load(state.velocity, i, lanes), lanes)
        for w in range(weights):
            weight = op.weight[w]
            square = splat(0.0, lanes)
            for i in range(first, last):
                rate = load(work.mean, i, lanes)
                square = square + at(weight, i) * (rate * rate)
            work.quadratic[w] += total(square)
    for w in range(weights):
        if mixed(op, WEIGHTS + w):  # add what the weight couples off the diagonal; x̂ = x⁺ - ½T v̂
            square = splat(0.0, lanes)
            for i in range(rows):
                coupled = splat(0.0, lanes)
                for family in range(op.entries.shape[0]):
                    coefficient = op.mix[WEIGHTS + w, family]
                    if coefficient != 0.0:
                        coupled = coupled + coefficient * row_product(op, family, i, work.mean, lanes)
                store(work.image, i, coupled, lanes)
                square = square + coupled * load(work.mean, i, lanes)
            work.quadratic[w] += total(square)
            for link in range(links.slot.shape[0]):
                if at(links.weight, link) == w:
                    power = splat(0.0, lanes)
                    for i in range(rows):
                        middle = load(state.position, i, lanes) - (0.5 * T) * load(work.mean, i, lanes)
                        stretch = middle - load(links.samples, at(links.slot, link) * rows + i, lanes)
                        power = power + load(work.image, i, lanes) * stretch
                    put(link_work, link, at(link_work, link) - T * at(links.strength, link) * total(power))


@inner
def book_energies(
    op: Operator,
    state: State,
    local_damping: Float,
    extra_damping: Float,
    T: float,
    work: Workspace,
    ledger: Float,
    lanes: tuple[int, ...],
) -> None:
    """Energies from the new state, losses from the mean velocity; keeps `K x` and `M v` for the next step.

    Args:
        op: the body's matrices.
        state: of the copy; `K x` and `M v` are written.
        local_damping: B_i as coefficients over the weights, (weights,).
        extra_damping: B_e likewise.
        T: length of the step [s].
        work: `mean` is v̂.
        ledger: result (LEDGER_COLUMNS,), as of `step`.
        lanes: fixes the width of a row.
    """
    rows, weights, families = op.mass.shape[0], op.weight.shape[0], op.entries.shape[0]
    heavy = mixed(op, MASS)
    kinetic, elastic, lost = splat(0.0, lanes), splat(0.0, lanes), splat(0.0, lanes)
    for i in range(rows):
        x, v, rate = load(state.position, i, lanes), load(state.velocity, i, lanes), load(work.mean, i, lanes)
        tension = at(op.ground, i) * x
        drag = at(op.damping, i) * rate
        for family in range(families):
            entries, k = op.entries[family], op.mix[STIFFNESS, family]
            stretch, slip = splat(0.0, lanes), splat(0.0, lanes)
            for e in range(at(op.pointer, i), at(op.pointer, i + 1)):
                value, j = at(entries, e), at(op.column, e)
                stretch = stretch + value * (load(state.position, j, lanes) - x)
                slip = slip + value * load(work.mean, j, lanes)
            tension = tension + k * stretch
            drag = drag + op.mix[DAMPING, family] * slip
        momentum = at(op.mass, i) * v
        if heavy:
            for family in range(families):
                momentum = momentum + op.mix[MASS, family] * row_product(op, family, i, state.velocity, lanes)
            store(state.momentum, i, momentum, lanes)
        store(state.tension, i, tension, lanes)
        kinetic = kinetic + v * momentum
        elastic = elastic + x * tension
        lost = lost + rate * drag
    ledger[KINETIC] = 0.5 * op.copy_scale * total(kinetic)
    ledger[ELASTIC] = 0.5 * op.copy_scale * total(elastic)
    ledger[BODY_LOSS] = T * op.copy_scale * total(lost)
    ledger[LOCAL_LOSS] = 0.0
    ledger[EXTRA_LOSS] = 0.0
    for w in range(weights):
        ledger[LOCAL_LOSS] += T * local_damping[w] * work.quadratic[w]
        ledger[EXTRA_LOSS] += T * extra_damping[w] * work.quadratic[w]


@kernel
def settle(op: Operator, state: State, ledger: Float, lanes: tuple[int, ...]) -> None:
    """Fills in `K x`, `M v` and the energies of a state that was just set.

    Args:
        op: of the body.
        state: whose position and velocity were set; the rest is filled in.
        ledger: result (LEDGER_COLUMNS,): the energies [J].
        lanes: fixes the width of a row.
    """
    elastic = splat(0.0, lanes)
    for i in range(op.mass.shape[0]):
        tension = pull(op, i, state.position, lanes)
        store(state.tension, i, tension, lanes)
        elastic = elastic + load(state.position, i, lanes) * tension
    ledger[ELASTIC] = 0.5 * op.copy_scale * total(elastic)
    ledger[KINETIC] = 0.5 * op.copy_scale * multiply(op, MASS, op.mass, state.velocity, state.momentum, lanes)
