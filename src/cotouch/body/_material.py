"""What a body is made of where it does more than follow a linear law: it turns, bends far, or is heavy."""

from dataclasses import dataclass, field
from math import inf
from typing import Literal, TypeAlias, final, get_args

import numpy as np

from cotouch.arrays import Float, Long, extents
from cotouch.body._strains import frame_of
from cotouch.errors import BodyError
from cotouch.installed import check_own_name, installed

Frame: TypeAlias = Literal["fixed", "floating"]

# Corners of an element of each model; those without elements take the body's own matrices.
_CORNERS = {"spring-network": 2, "cells": 8, "rigid": 4}
_WITHOUT = ("linear", "floating", "several")
# Laws of tetrahedra, and what each needs Poisson's ratio to be above.
_SOLIDS = {"corotated": -1.0, "st-venant-kirchhoff": -1.0, "neo-hookean": 0.0}
_OWN = frozenset(_SOLIDS)
# Entry points of those that other packages bring.
GROUP = "cotouch.materials"


def add_solid_law(name: str, *, poisson_above: float = -1.0) -> None:
    """Makes a law of tetrahedra known by its name; see `cotouch.mechanics.register_solid`, which does the rest.

    Args:
        name: as `model`.
        poisson_above: what Poisson's ratio must be above.
    """
    _SOLIDS[name] = poisson_above


def solid_laws() -> tuple[str, ...]:
    """Names of all laws of tetrahedra."""
    return tuple(_SOLIDS)


def is_solid_law(name: str) -> bool:
    """Whether a name is that of a law of tetrahedra; one of an installed package is loaded.

    Args:
        name: of a model.

    Raises:
        BodyError: it cannot be loaded, or registers no material of this name; or it is cotouch's own, and a package
            brings one of the same name.
    """
    if name in _OWN:
        check_own_name(GROUP, name, what="material", error=BodyError)
    elif name not in _SOLIDS:
        loaded = installed(GROUP, name, object, what="material", error=BodyError)  # its module registers it
        if loaded is not None and name not in _SOLIDS:
            raise BodyError(
                f'the material "{name}" has an entry point, but its module registers none of this name; '
                "register_solid must get the name of the entry point"
            )
    return name in _SOLIDS


def least_poisson(model: str) -> float:
    """What Poisson's ratio must be above.

    Args:
        model: of a material.
    """
    return _SOLIDS.get(model, -1.0)


def cuttable_models() -> str:
    """Models of which elements can be taken away so that the skin closes, in words."""
    return ", ".join(f'"{name}"' for name in ("cells", *_SOLIDS))


@final
@dataclass(frozen=True, eq=False, kw_only=True)
class Material:
    """The law that a body's inner forces follow, in place of `K x`.

    Attributes:
        model: "linear": K and B as they are. "floating": K and B in one frame that turns with the body.
            "spring-network": springs `½ k (l - L)²`. "cells": cubes that turn, `⅛ k Σ ‖d - R h n‖²` over the edges.
            Of tetrahedra: "corotated": `μ ‖F - R‖² + ½ λ (tr RᵀF - 3)²`. "st-venant-kirchhoff": `μ ‖E‖² + ½ λ (tr E)²`.
            "neo-hookean": stable, `½ μ (‖F‖² - 3) - μ (J - 1) + ½ (λ + μ) (J - 1)²`. "rigid": four nodes that keep
            their distances, see `rigid_body`. "several": each part of the body has a material of its own.
        elements: nodes of springs (E, 2), cubes (E, 8; corner `4a + 2b + c` lies at (a, b, c)) or tetrahedra (E, 4).
        stiffness: of each spring, or of the spring along an edge that four such cubes share, or m ω² of what is rigid,
            (E,) [N/m].
        young: of tetrahedra, one for all or (E,) [Pa].
        poisson: of tetrahedra, likewise.
        viscosity: η: dampers of η times the stiffness, which no rotation feels; not of models without elements, whose
            dampers are the body's; of tetrahedra one for all or
            (E,) [s].
        gravity: acceleration that the whole body has where it is, (3,) [m/s²]; see `Body.with_gravity`.
        cuttable: whether its elements can be cut; see `Body.with_cutting`.
        tear: strain at which an element breaks: how much its most stretched edge is longer than at rest, as a share.
        strength: largest tensile stress that an element bears, of tetrahedra the greatest principal one, of springs and
            cubes that along an edge, as force over the area at rest [Pa].
        toughness: what a blade pays for new area [J/m²].
        faces: faces that open in place of elements: the nodes of the element on the one side, then of that on the
            other, (F, 2 m); none: whole elements are cut. See `with_faces`.
        sides: which two elements these are, (F, 2).
        ties: stiffness of the spring of no length at each corner of a face, (F,) [N/m].
        part: the share of a node of the body without faces which each node has, by which links pull at it, (n,), or
            (0,).
    """

    model: str
    elements: Long = field(default_factory=lambda: np.zeros((0, 0), dtype=np.int64))
    stiffness: Float = field(default_factory=lambda: np.zeros(0))
    young: float | Float = 0.0
    poisson: float | Float = 0.0
    viscosity: float | Float = 0.0
    gravity: tuple[float, float, float] = (0.0, 0.0, 0.0)
    cuttable: bool = False
    tear: float = inf
    strength: float = inf
    toughness: float = 0.0
    faces: Long = field(default_factory=lambda: np.zeros((0, 0), dtype=np.int64))
    sides: Long = field(default_factory=lambda: np.zeros((0, 2), dtype=np.int64))
    ties: Float = field(default_factory=lambda: np.zeros(0))
    part: Float = field(default_factory=lambda: np.zeros(0))

    @property
    def solid(self) -> bool:
        """Whether its elements are tetrahedra with a law of their own."""
        return self.model in _SOLIDS

    @property
    def closes(self) -> bool:
        """Whether it can be cut so that its skin closes around what is left: cubes and tetrahedra."""
        return self.solid or self.model == "cells"

    def check(self, rest: Float) -> None:
        """Whether it fits a body.

        Args:
            rest: shape at rest, (n, d) [m].

        Raises:
            BodyError: a value is out of its range, an element names a node that there is not, or is turned inside out.
        """
        known = (*_WITHOUT, *_CORNERS, *_SOLIDS)
        if self.model not in known and not is_solid_law(self.model):
            raise BodyError(f'model is "{self.model}"; it must be one of {", ".join(known)}')
        nodes, dimension = rest.shape
        viscosity = _first_bad(self.viscosity, 0.0, inf, least=True)
        if viscosity is not None:
            raise BodyError(f"viscosity is {viscosity}; it must be a finite number of at least 0 s")
        for name in ("young", "poisson", "viscosity"):
            shape = np.shape(getattr(self, name))
            if shape not in {(), (self.elements.shape[0],)} or (shape and not self.solid):
                raise BodyError(f"{name} holds {extents(shape)} numbers; it must be one, or of tetrahedra one each")
        if len(self.gravity) != 3 or not np.isfinite(self.gravity).all():
            raise BodyError(f"gravity is {self.gravity}; it must be three finite numbers [m/s²]")
        if dimension < 2 and self.model != "linear":
            raise BodyError(f'model is "{self.model}", but the body has one axis; a body that turns needs 2 or 3')
        corners = 4 if self.solid else _CORNERS.get(self.model)
        if self.cuttable and not (self.closes or self.model == "spring-network"):
            raise BodyError(
                f'cutting takes away elements, but model is "{self.model}", which has none; take one of '
                f'"spring-network", {cuttable_models()}'
            )
        if self.cuttable and not self.tear > 0.0:
            raise BodyError(f"tear is {self.tear}; it must be a strain above 0, a share of the length at rest")
        if self.cuttable and not self.strength > 0.0:
            raise BodyError(f"strength is {self.strength}; it must be a stress above 0 Pa")
        if not 0.0 <= self.toughness < inf:
            raise BodyError(f"toughness is {self.toughness}; it must be a finite number of at least 0 J/m²")
        if self.faces.size:
            self._check_faces(nodes)
        if corners is None:
            return
        if corners != 2 and dimension != 3:
            raise BodyError(f'model is "{self.model}", but the body has {dimension} axes; it must have 3')
        if self.elements.ndim != 2 or self.elements.shape[1] != corners or not self.elements.shape[0]:
            given = extents(self.elements.shape)
            raise BodyError(f'elements is {given}; model "{self.model}" needs rows of {corners} nodes')
        if self.elements.min() < 0 or self.elements.max() >= nodes:
            wrong = int(self.elements.min() if self.elements.min() < 0 else self.elements.max())
            raise BodyError(f"elements names node index {wrong}; this body has nodes 0 to {nodes - 1}")
        if self.model == "rigid" and np.array_equal(self.elements, [[0, 1, 2, 3]]) and nodes == 4:
            if not abs(np.linalg.det(frame_of(rest))) > 0.0:
                raise BodyError("the four nodes of a rigid body lie in a plane; they must span a volume")
        elif self.model == "rigid":
            raise BodyError(f"a rigid body has {nodes} nodes; it must have 4, which form its one element")
        elif corners == 4:
            self._check_solid(rest)
            return
        good = np.isfinite(self.stiffness) & (self.stiffness >= 0.0)
        if self.stiffness.shape != (self.elements.shape[0],) or not good.all():
            wrong = self.stiffness[~good][:1] if self.stiffness.shape == good.shape else self.stiffness.shape
            raise BodyError(
                f'stiffness holds {wrong}; model "{self.model}" needs a finite number >= 0 N/m for each element'
            )

    def _check_faces(self, nodes: int) -> None:
        """Of a recording, too."""
        count, wide = self.faces.shape[0], {4: 6, 8: 8}.get(self.elements.shape[-1], 0)
        shapes = self.faces.shape, self.sides.shape, self.ties.shape, self.part.shape
        if not self.cuttable or shapes != ((count, wide), (count, 2), (count,), (nodes,)):
            raise BodyError(f"faces are given by arrays of {shapes}; they do not fit a body of {nodes} nodes")
        inside = self.faces.min() >= 0 and self.faces.max() < nodes
        inside &= bool(self.sides.min() >= 0 and self.sides.max() < self.elements.shape[0])
        if not (
            inside and np.all((self.ties >= 0.0) & (self.ties < inf)) and np.all((self.part > 0.0) & (self.part <= 1.0))
        ):
            raise BodyError("faces name nodes or elements that do not exist, or a tie or part is out of range")

    def _check_solid(self, rest: Float) -> None:
        least = least_poisson(self.model)
        poisson, young = _first_bad(self.poisson, least, 0.5), _first_bad(self.young, 0.0, inf)
        if poisson is not None:
            raise BodyError(f'poisson is {poisson}; with model "{self.model}" it must be above {least:g} and below 0.5')
        if young is not None:
            raise BodyError(f"young is {young}; it must be more than 0 Pa")
        edges = rest[self.elements[:, 1:]] - rest[self.elements[:, :1]]
        volumes = np.linalg.det(edges) / 6.0
        bad = np.flatnonzero(volumes <= 0.0)
        if bad.size:
            number = int(bad[0])
            raise BodyError(
                f"tetrahedron {number + 1} is turned inside out (volume {volumes[number]:.3g} m³); swap two nodes"
            )


def _first_bad(value: float | Float, low: float, high: float, *, least: bool = False) -> float | None:
    """The first number that is not between two others; `least`: it may be the lower one."""
    numbers = np.atleast_1d(np.asarray(value, dtype=np.float64))
    bad = numbers[~(((numbers >= low) if least else (numbers > low)) & (numbers < high))]
    return float(bad[0]) if bad.size else None


def linear_material(frame: str) -> Material | None:
    """The material of a body that keeps its own matrices; None where it follows them as they are.

    Raises:
        BodyError: there is no such frame.
    """
    if frame not in get_args(Frame):
        raise BodyError(f'frame is "{frame}"; it must be "fixed" or "floating"')
    return None if frame == "fixed" else Material(model="floating")
