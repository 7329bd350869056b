"""A small body of a material that a hand turns about its middle, in a session on a virtual clock."""

from collections.abc import Iterable

import numpy as np

SHAPE, SPACING = (3, 3, 3), 0.01
CORNERS = ((0, 0, 0), (2, 2, 0), (0, 2, 2), (2, 0, 2))


def turning(angle: float, seconds: float, *, user: int = 1, stiffness: float = 100.0) -> str:
    """Hands at four corners that turn the body about the z axis through its middle."""
    tables: list[str] = []
    for corner in CORNERS:
        arm = (np.array(corner) - 1.0) * SPACING
        path = [
            [float(seconds * s), *(_turned(arm, angle * s) - arm).round(7).tolist()] for s in np.linspace(0.0, 1.0, 25)
        ]
        node = 1 + (corner[0] * SHAPE[1] + corner[1]) * SHAPE[2] + corner[2]
        tables.append(
            f"[[hands]]\nuser = {user}\nnode = {node}\npath = {path}\nstiffness = {stiffness}\ndamping = 1.0\n"
        )
    return "".join(tables)


def session(model: str, *, users: int = 3, hands: str = "", more: str = "") -> str:
    """Its file; with springs, for `paid` jerks so light a body that closing a step may take more than 1 %."""
    return f"""
[session]
users = {users}
spring = 20.0
wait_for_peers = 20.0
{more}
[body]
kind = "lattice"
shape = {list(SHAPE)}
spacing = {SPACING}
mass = 0.1
stiffness = 60.0
damping = 0.02
{model}
[steps]
rate = 250
[synchronisation]
law = "spring"
{hands}"""


def volumes(positions: Iterable[np.ndarray], rest: np.ndarray) -> list[float]:
    """Of the box between the outermost corners, beside that at rest."""
    found: list[float] = []
    for moved in positions:
        x = (rest + moved).reshape(*SHAPE, 3)
        edges = [x[2, 0, 0] - x[0, 0, 0], x[0, 2, 0] - x[0, 0, 0], x[0, 0, 2] - x[0, 0, 0]]
        found.append(float(np.linalg.det(edges)) / (2.0 * SPACING) ** 3)
    return found


def _turned(arm: np.ndarray, angle: float) -> np.ndarray:
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]]) @ arm
