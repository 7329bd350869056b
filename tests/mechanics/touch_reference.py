"""One step with tools written out densely from theory.md, section 4: one matrix for body and proxies, then Newton.

Only the places of contacts are taken from the kernels; `test_collide.py` holds these against brute force.
"""

from dataclasses import dataclass

import numpy as np
from tests.mechanics.reference import dense_system
from tests.mechanics.touching import Array, TouchedCopy

from cotouch.mechanics import GRASP


@dataclass
class Touched:
    """What one step with tools does; fields (n, 3) and (tools, 3)."""

    position: Array
    velocity: Array
    place: Array
    rate: Array
    touch_force: Array
    drive_force: Array
    pushing: Array
    account: Array


@dataclass
class Before:
    """What a step starts from, as the kernels are about to change it."""

    position: Array
    velocity: Array
    place: Array
    rate: Array
    account: Array
    held: list[list[tuple[int, Array]]]


def remember(copy: TouchedCopy) -> Before:
    tools = copy.tools
    held = [
        [
            (int(tools.hold[t, c]), tools.offset[t * tools.hold.shape[1] + c, :3].copy())
            for c in range(max(int(tools.held[t]), 0))
        ]
        for t in range(tools.mass.size)
    ]
    return Before(
        copy.copy.position,
        copy.copy.velocity,
        tools.place[:, :3].copy(),
        tools.rate[:, :3].copy(),
        tools.account.copy(),
        held,
    )


def carried(copy: TouchedCopy, vertex: int) -> Array:
    """The matrix (3, 3 n) that reads a vertex of the skin."""
    skin, n = copy.body.skin, copy.body.nodes
    row = np.zeros(n)
    if skin is None:
        row[vertex] = 1.0
    else:
        np.add.at(row, skin.nodes[vertex], skin.weights[vertex])
    return np.kron(row[None], np.eye(3))


def held_reader(copy: TouchedCopy, what: int) -> Array:
    """Of what a grasp holds: a node, or a vertex of the skin in a modal basis."""
    if copy.surface.hold_row.shape[1] == 0:
        return carried(copy, what)
    return np.kron(np.eye(copy.body.nodes)[[what]], np.eye(3))


def law(k: Array, e: Array, d: Array, a: Array) -> tuple[Array, Array]:
    """Force and slope of the contacts."""
    force, slope = np.zeros_like(d), np.zeros_like(d)
    for i in range(d.size):
        p, q = max(e[i] + d[i], 0.0), max(e[i], 0.0)
        if e[i] > 0.0 and e[i] + d[i] > 0.0:
            f, g = k[i] * (e[i] + 0.5 * d[i]), 0.5 * k[i]
        elif d[i] == 0.0:
            f, g = k[i] * q, 0.5 * k[i]
        else:
            f = 0.5 * k[i] * (p * p - q * q) / d[i]
            g = (k[i] * p - f) / d[i]
        damp = max(1.0 + a[i] * d[i], 0.0)
        force[i], slope[i] = f * damp, g * damp + (f * a[i] if damp > 0.0 else 0.0)
    return force, slope


def newton(k: Array, e: Array, a: Array, free: Array, R: Array) -> Array:
    """Forces by a damped semismooth Newton method over d."""
    d = free.copy()
    size = np.abs(free).max() + np.abs(e).max() + 1e-300

    def left(d: Array) -> Array:
        return d - free + R @ law(k, e, d, a)[0]

    for _ in range(500):
        f, slope = law(k, e, d, a)
        wrong = d - free + R @ f
        if np.abs(wrong).max() <= 1e-16 * size:
            break
        move = -np.linalg.solve(np.eye(d.size) + R * slope, wrong)
        barycentric = 1.0
        while barycentric > 1e-6 and np.linalg.norm(left(d + barycentric * move)) > (
            1 - 1e-4 * barycentric
        ) * np.linalg.norm(wrong):
            barycentric *= 0.5
        d = d + barycentric * move
    return law(k, e, d, a)[0]


def touched_step(copy: TouchedCopy, before: Before, T: float) -> Touched:
    """The step that `copy` has just made from `before`, worked out densely. Without friction."""
    tools, scene = copy.tools, copy.scene
    number, size = tools.mass.size, 3 * copy.body.nodes
    scene = type(scene)(**{**vars(scene), "position": before.position, "velocity": before.velocity})
    A_body, b_body = dense_system(scene, T)
    total = size + 3 * number
    A, b = np.zeros((total, total)), np.zeros(total)
    A[:size, :size], b[:size] = A_body, b_body

    def proxy(t: int) -> Array:
        return np.eye(total)[size + 3 * t : size + 3 * t + 3]

    start, end = tools.drive_start[:, :3], tools.drive_end[:, :3]
    for t in range(number):
        own, k, c = proxy(t), tools.drive_stiffness[t], tools.drive_damping[t]
        A += own.T @ own * (2.0 * tools.mass[t] / T + 0.5 * T * k + c)
        pull = k * (0.5 * (start[t] + end[t]) - before.place[t]) + c * (end[t] - start[t]) / T + tools.push[t, :3]
        b += own.T @ (2.0 * tools.mass[t] / T * before.rate[t] + pull)
    ports: list[tuple[int, Array, Array]] = []
    for t in range(number):
        if tools.mode[t] != GRASP:
            continue
        k, c = tools.grip_stiffness[t], tools.grip_damping[t]
        for what, offset in before.held[t]:
            H = np.zeros((3, total))
            H[:, :size] = held_reader(copy, what)
            apart = H - proxy(t)
            stretch = H[:, :size] @ before.position.ravel() - before.place[t] - offset
            A += apart.T @ apart * (c + 0.5 * T * k)
            b -= apart.T @ (k * stretch)
            ports.append((t, apart, stretch))

    found, count = copy.touch.found, copy.count
    G = np.zeros((count, total))
    k, e, a = np.zeros(count), found.depth[:count].copy(), np.zeros(count)
    for i in range(count):
        t, n = int(found.tool[i]), found.normal[i, :3]
        vertices = copy.surface.corner[found.triangle[i]]
        reader = sum(
            (s * carried(copy, int(v)) for s, v in zip(found.barycentric[i, :3], vertices, strict=True)), np.zeros(1)
        )
        G[i, :size] = n @ reader
        G[i] -= n @ proxy(t)
        k[i], a[i] = tools.stiffness[t], tools.loss[t] / T
    for t in range(number):
        own = (found.tool[:count] == t) & (e > 0.0)
        desired = 0.5 * float(k[own] @ e[own] ** 2)
        if desired > max(before.account[t], 0.0):
            e[own] *= np.sqrt(max(before.account[t], 0.0) / desired)
    modes = np.eye(size)
    if copy.model.modes is not None:
        modes = copy.model.modes if copy.model.full else np.kron(copy.model.modes, np.eye(3))
    basis = np.zeros((total, modes.shape[1] + 3 * number))
    basis[:size, : modes.shape[1]] = modes
    basis[size:, modes.shape[1] :] = np.eye(3 * number)
    inverse = basis @ np.linalg.solve(basis.T @ A @ basis, basis.T)
    R, free = T * G @ inverse @ G.T, T * G @ inverse @ b
    force = newton(k, e, a, free, R) if count else np.zeros(0)
    mean = inverse @ (b - G.T @ force)
    v, w = mean[:size].reshape(-1, 3), mean[size:].reshape(-1, 3)

    touch_force = np.zeros((number, 3))
    account = before.account.copy()
    for i in range(count):
        touch_force[int(found.tool[i])] += force[i] * found.normal[i, :3]
        account[int(found.tool[i])] += T * force[i] * float(G[i] @ mean)
    for t, apart, stretch in ports:
        rate = apart @ mean
        k_grip, c_grip = tools.grip_stiffness[t], tools.grip_damping[t]
        touch_force[t] += k_grip * (stretch + 0.5 * T * rate) + c_grip * rate
    middle = before.place + 0.5 * T * w
    k_drive, c_drive = tools.drive_stiffness[:, None], tools.drive_damping[:, None]
    drive = k_drive * (0.5 * (start + end) - middle) + c_drive * ((end - start) / T - w) + tools.push[:, :3]
    return Touched(
        position=before.position + T * v,
        velocity=2.0 * v - before.velocity,
        place=before.place + T * w,
        rate=2.0 * w - before.rate,
        touch_force=touch_force,
        drive_force=drive,
        pushing=force,
        account=account,
    )
