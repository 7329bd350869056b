"""One step written out densely from theory.md, sections 1 and 2, with nothing taken from `cotouch.mechanics`.

Everything is a vector of nd numbers, node by node, and a matrix nd x nd.
"""

from dataclasses import dataclass

import numpy as np
from tests.mechanics.support import Array, Scene

from cotouch.body import Body


@dataclass
class Outcome:
    """What one step does; fields (n, d), energies in J."""

    position: Array
    velocity: Array
    mean_velocity: Array
    mean_position: Array
    forces: Array
    supplied: float
    body_loss: float
    local_loss: float
    extra_loss: float
    links_did: Array
    kinetic: float
    elastic: float


def wide(matrix: Array, body: Body) -> Array:
    """A matrix or link weight of the body as nd x nd."""
    n, d = body.nodes, body.dimension
    rows = matrix.shape[0]
    if rows == n * d:
        return matrix
    return np.kron(matrix, np.eye(d)) if rows == n else np.kron(np.eye(n), matrix)


def matrices(scene: Scene) -> tuple[Array, Array, Array, list[Array]]:
    """M/N, B/N, K/N and the link weights (the identity first)."""
    body = scene.body
    own = [wide(matrix.toarray(), body) / scene.copies for matrix in (body.mass, body.damping, body.stiffness)]
    weights = [np.eye(body.nodes * body.dimension), *(wide(np.asarray(weight), body) for weight in scene.weights)]
    return own[0], own[1], own[2], weights


def energies(scene: Scene, position: Array, velocity: Array) -> tuple[float, float]:
    """½‖v‖² in M/N and ½‖x − x_d‖² in K/N."""
    M, _, K, _ = matrices(scene)
    x, v = position.ravel(), velocity.ravel()
    return 0.5 * v @ M @ v, 0.5 * x @ K @ x


def held_energy(scene: Scene, position: Array, velocity: Array, T: float) -> float:
    """In the springs to the neighbours' samples and to the ends of the ports at the start, and on its way to dampers.

    The latter is what they would turn into heat if the body went on as it does. A light body soon moves as a stiff
    damper's end does, and their force, of the small difference of two speeds, is known no better than that.
    """
    d = scene.body.dimension
    weights = matrices(scene)[3]
    total = 0.0
    for spring in scene.springs:
        gap = (position - spring.sample).ravel()
        total += 0.5 * spring.strength * gap @ weights[spring.weight] @ gap
    for port in scene.ports:
        gap = position[port.node] - np.broadcast_to(port.start, d)
        slip = np.broadcast_to(np.asarray(port.end) - port.start, d) / T - velocity[port.node]
        total += 0.5 * port.stiffness * gap @ gap + T * port.damping * slip @ slip
    return total


def picks(scene: Scene) -> list[Array]:
    """For every port the matrix (d, nd) that reads its node."""
    n, d = scene.body.nodes, scene.body.dimension
    return [np.kron(np.eye(n)[[port.node]], np.eye(d)) for port in scene.ports]


def dense_system(scene: Scene, T: float) -> tuple[Array, Array]:
    """A and b of `A v̂ = b`."""
    d = scene.body.dimension
    M, B, K, W = matrices(scene)
    x, v = scene.position.ravel(), scene.velocity.ravel()
    A = (2.0 / T) * M + B + (T / 2.0) * K + control_damping(scene, scene.local_damping)
    A = A + control_damping(scene, scene.extra_damping)
    b = (2.0 / T) * M @ v - K @ x
    for spring in scene.springs:
        K_ij = spring.strength * W[spring.weight]
        A = A + (T / 2.0) * K_ij
        b = b - K_ij @ (x - spring.sample.ravel())
    for port, H in zip(scene.ports, picks(scene), strict=True):
        start, end = np.broadcast_to(port.start, d), np.broadcast_to(port.end, d)
        A = A + H.T @ H * (port.damping + T / 2.0 * port.stiffness)
        pull = port.stiffness * (0.5 * (start + end) - H @ x) + port.damping * (end - start) / T
        b = b + H.T @ (pull + port.push)
    return A, b


def control_damping(scene: Scene, coefficients: Array) -> Array:
    """Coefficients over the weights as one matrix nd x nd."""
    weights = matrices(scene)[3]
    return sum((c * w for c, w in zip(coefficients, weights, strict=False)), np.zeros_like(weights[0]))


def dense_step(scene: Scene, T: float) -> Outcome:
    n, d = scene.body.nodes, scene.body.dimension
    _, B, _, W = matrices(scene)
    x, v = scene.position.ravel(), scene.velocity.ravel()
    A, b = dense_system(scene, T)
    mean = np.linalg.solve(A, b)

    middle = x + 0.5 * T * mean
    forces = np.array(
        [
            port.stiffness * (0.5 * (np.broadcast_to(port.start, d) + np.broadcast_to(port.end, d)) - H @ middle)
            + port.damping * ((np.broadcast_to(port.end, d) - np.broadcast_to(port.start, d)) / T - H @ mean)
            + port.push
            for port, H in zip(scene.ports, picks(scene), strict=True)
        ]
    ).reshape(-1, d)
    position, velocity = x + T * mean, 2.0 * mean - v
    kinetic, elastic = energies(scene, position, velocity)
    return Outcome(
        position=position.reshape(n, d),
        velocity=velocity.reshape(n, d),
        mean_velocity=mean.reshape(n, d),
        mean_position=middle.reshape(n, d),
        forces=forces,
        supplied=T * sum(force @ (H @ mean) for force, H in zip(forces, picks(scene), strict=True)),
        body_loss=T * mean @ B @ mean,
        local_loss=T * mean @ control_damping(scene, scene.local_damping) @ mean,
        extra_loss=T * mean @ control_damping(scene, scene.extra_damping) @ mean,
        links_did=np.array(
            [
                -T * mean @ (spring.strength * W[spring.weight]) @ (middle - spring.sample.ravel())
                for spring in scene.springs
            ]
        ),
        kinetic=kinetic,
        elastic=elastic,
    )
