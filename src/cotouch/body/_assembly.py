"""A body of a mesh's parts: nodes, masses and springs, what holds them, and the skin."""

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import TypeAlias

import numpy as np
import numpy.typing as npt
import scipy.sparse as sp

from cotouch.arrays import Long
from cotouch.body._body import Body
from cotouch.body._checks import SumOfSquares, at_least_zero
from cotouch.body._ground import Held, free_motions, held_nodes, rounded_face
from cotouch.body._material import Material
from cotouch.body._origin import Origin
from cotouch.body._pieces import Float
from cotouch.body._skin import Skin
from cotouch.errors import BodyError

MeshSource: TypeAlias = str | Path | tuple[npt.ArrayLike, npt.ArrayLike]


def put_together(
    *,
    rest: Float,
    masses: Float,
    springs: sp.csr_array,
    dampers: sp.csr_array,
    alpha: float,
    beta: float,
    ground: Held,
    ground_stiffness: float,
    ground_damping: float,
    slack: float,
    sets: Mapping[str, Long],
    skin: Skin,
    origin: Origin,
    notes: list[str],
    material: Material | None,
) -> Body:
    """The body of these parts; what holds it are springs to the ground, so that they are diagonal.

    Args:
        rest: its nodes, (n, 3) [m].
        masses: of the nodes [kg].
        springs: its stiffness.
        dampers: what goes with that in the damping.
        alpha: of the damping α M + β K [1/s].
        beta: likewise [s].
        ground: which nodes are held.
        ground_stiffness: of each of these [N/m].
        ground_damping: of each of these [Ns/m].
        slack: within which a node is on a plane or in a box [m].
        sets: named sets of nodes.
        skin: that it carries.
        origin: where it comes from; what holds it, and the notes, are added.
        notes: likewise, in sentences; of the ground some are added.
        material: None for one of fixed springs.

    Raises:
        BodyError: what holds it cannot be.
    """
    at_least_zero(ground_stiffness=ground_stiffness, ground_damping=ground_damping)
    held = held_nodes(ground, rest, slack=slack, spacing=origin.spacing, sets=sets)
    rounded = rounded_face(ground, rest, held)
    if rounded is not None:
        notes.append(rounded)
    if held.size and ground_stiffness == 0.0 and ground_damping == 0.0:
        raise BodyError(f"the ground holds {held.size} nodes with ground_stiffness 0; give it in N/m for each node")
    turning = springs.shape[0] == 3 * rest.shape[0] or (material is not None and material.model != "linear")
    free = free_motions(rest, held if ground_stiffness > 0.0 else held[:0], turning=turning)
    if free == (6 if turning else 3):
        notes.append("Nothing holds it: when pushed, it flies off. Give ground and ground_stiffness to hold it.")
    elif free:
        notes.append(f"The ground leaves {free} rigid motion{'s' * (free != 1)} free.")
    grip = np.zeros(rest.shape[0])
    grip[held] = 1.0
    return Body(
        mass=sp.diags_array(masses),
        rest=rest,
        damping_int=SumOfSquares(dampers) if dampers.nnz and abs(dampers).max() > 0.0 else None,
        damping_ext=sp.diags_array(alpha * masses + grip * (ground_damping + beta * ground_stiffness)),
        stiffness_int=SumOfSquares(springs),
        stiffness_ext=sp.diags_array(grip * ground_stiffness),
        skin=skin,
        origin=replace(origin, held=held, free=free, notes=tuple(notes)),
        material=material,
    )


def name_of(source: object) -> str:
    """What messages call a source."""
    return str(source) if isinstance(source, str | Path) else "arrays"
