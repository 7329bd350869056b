"""Several bodies as one: their nodes side by side, nothing between them but what contact does."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import final

import numpy as np
import scipy.sparse as sp

from cotouch.body._body import Body
from cotouch.body._checks import SumOfSquares
from cotouch.body._material import Material
from cotouch.body._part import Part, ToolBody, never_meet
from cotouch.body._shapes import OFF, three, turning
from cotouch.body._skin import joined_skins
from cotouch.errors import BodyError, UnsupportedError

_MATRICES = ("mass", "damping_int", "damping_ext", "stiffness_int", "stiffness_ext")
_INNER = ("damping_int", "stiffness_int")
# Extents that differ by less than this share are the same.
_SAME = 0.01


@final
@dataclass(frozen=True, eq=False, kw_only=True)
class Placed:
    """A body among others, and where it is at rest.

    Attributes:
        body: in three dimensions, with a skin.
        name: of its own.
        at: where the middle of its extents comes to, (3,) [m]; None: it stays where it is.
        turn: how it is turned about that middle: along the axis of turning, as long as the angle, (3,) [rad].
        tool: whose tool it is; None: it is shared.
    """

    body: Body
    name: str
    at: tuple[float, float, float] | None = None
    turn: tuple[float, float, float] = (0.0, 0.0, 0.0)
    tool: ToolBody | None = None


def together(bodies: Sequence[Placed]) -> Body:
    """Several bodies as one, whose nodes are those of all, one after the other.

    They share mass, weight and links like any body, and meet each other by their skins.

    Args:
        bodies: at least one, each with a name of its own.

    Raises:
        BodyError: there is none, two have one name, or a place is not finite.
        UnsupportedError: a body has no skin, is truncated, or is several itself.

    Examples:
        >>> from cotouch.body import lattice
        >>> block = lattice((2, 2, 2), model="cells", stiffness=100.0)
        >>> pair = together([Placed(body=block, name="low"), Placed(body=block, name="high", at=(0.005, 0.005, 0.05))])
        >>> pair.nodes, [part.name for part in pair.parts]
        (16, ['low', 'high'])
    """
    if not bodies:
        raise BodyError("there are no bodies; give at least one")
    parts: list[Part] = []
    first = 0
    for placed in bodies:
        _check(placed, [part.name for part in parts])
        parts.append(_part(placed, first))
        first += placed.body.nodes
    _refuse_same(parts)
    return joined(parts)


def joined(parts: Sequence[Part]) -> Body:
    """The body that has these parts.

    Args:
        parts: one after the other.
    """
    full = any(part.body.form == "full" for part in parts)
    matrices = {name: _joined(parts, name, full) for name in _MATRICES}
    return Body(
        rest=np.concatenate([part.rest() for part in parts]),
        skin=joined_skins([part.carrying(part.skin()) for part in parts]),
        material=Material(model="several"),
        parts=tuple(parts),
        mass=matrices["mass"],
        damping_int=SumOfSquares(matrices["damping_int"]),
        damping_ext=matrices["damping_ext"],
        stiffness_int=SumOfSquares(matrices["stiffness_int"]),
        stiffness_ext=matrices["stiffness_ext"],
    )


def _refuse_same(parts: Sequence[Part]) -> None:
    """Two bodies in just one place have no depth in each other, as each point of the one lies on the other's skin."""
    boxes = [(part.rest().min(axis=0), part.rest().max(axis=0)) for part in parts]
    for k, (low, high) in enumerate(boxes):
        for j in range(k):
            if never_meet(parts[j], parts[k]):
                continue
            apart = max(np.abs(low - boxes[j][0]).max(), np.abs(high - boxes[j][1]).max())
            if apart <= _SAME * float((high - low).max()):
                raise BodyError(f'bodies "{parts[j].name}" and "{parts[k].name}" overlap; move one of them')


def _check(placed: Placed, names: list[str]) -> None:
    body, name = placed.body, placed.name
    if not name or name in names:
        what = f'two bodies are named "{name}"' if name else "a body has an empty name"
        raise BodyError(f"{what}; each needs a different name")
    if body.parts:
        raise UnsupportedError(f'body "{name}" consists of several bodies; list them one by one')
    if body.truncation is not None:
        raise UnsupportedError(f'body "{name}" is truncated to a few modes; among several bodies, leave modes out')
    if body.dimension != 3 or body.skin is None or not body.skin.triangles.size:
        what = f"has {body.dimension} axes" if body.dimension != 3 else "has no skin"
        raise UnsupportedError(f'body "{name}" {what}; bodies meet by their skins, so take it from a mesh or a lattice')
    if not np.ptp(body.skin.vertices, axis=0).all():
        raise UnsupportedError(
            f'body "{name}" is a sheet of one layer, which has no inside; bodies and meshes meet by how deep they are '
            "in each other, so give it two layers of nodes"
        )
    size = float(np.ptp(body.rest, axis=0).max())
    three(
        f'at of body "{name}"',
        placed.at or (0.0, 0.0, 0.0),
        OFF * size,
        f" of at most {OFF * size:.3g} m, a million times its size",
    )
    turning(placed.turn, f'turn of body "{name}"')


def _part(placed: Placed, first: int) -> Part:
    low, high = placed.body.rest.min(axis=0), placed.body.rest.max(axis=0)
    middle = 0.5 * (low + high)
    turn = turning(placed.turn)
    goal = middle if placed.at is None else np.asarray(placed.at, dtype=np.float64)
    return Part(
        name=placed.name, body=placed.body, first=first, turn=turn, shift=goal - turn @ middle, tool=placed.tool
    )


def _joined(parts: Sequence[Part], name: str, full: bool) -> sp.csr_array:
    blocks: list[sp.csr_array] = []
    for part in parts:
        matrix: sp.csr_array = getattr(part.body, name)
        if full and part.body.form == "node":
            matrix = sp.csr_array(sp.kron(matrix, sp.eye_array(3)))
        elif full and np.any(part.turn != np.eye(3)):
            turn = sp.kron(sp.eye_array(part.body.nodes), part.turn)
            matrix = sp.csr_array(turn @ matrix @ turn.T)
            matrix = sp.csr_array(0.5 * (matrix + matrix.T))
            if name not in _INNER:
                matrix = sp.csr_array(sp.diags_array(matrix.diagonal()))
        blocks.append(matrix)
    return sp.csr_array(sp.block_diag(blocks, format="csr"))
