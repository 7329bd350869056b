"""What of a body can be cut, as the kernels want it."""

import math
from collections.abc import Sequence

import numpy as np

from cotouch.arrays import Array, Float, Long
from cotouch.body import FACES, Body, Material, cut_skin
from cotouch.errors import UnsupportedError
from cotouch.mechanics._cutting._cut import KINDS, WIDEST, Cutting
from cotouch.mechanics._cutting._matrix import bonds_of
from cotouch.mechanics._materials._arrays import gradients_of, lame_of
from cotouch.mechanics._materials._breaking import SOLIDS
from cotouch.mechanics._model._model import Model

# Edges of an element by its number of corners: pairs that stretch.
EDGES = {
    2: ((0, 1),),
    4: ((0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)),
    8: tuple((i, j) for i in range(8) for j in range(i + 1, 8) if (i ^ j).bit_count() == 1),
}


def cutting_of(model: Model, *, tools: int = 0, decides: Sequence[bool] = ()) -> Cutting | None:
    """The elements of a body that can be cut, of several those of all; None where it cannot.

    Args:
        model: the body.
        tools: how many there are in the arrays of tools that kernels get.
        decides: whether each user's copy cuts by itself; by default all do.

    Raises:
        UnsupportedError: a law that is not this package's own.
    """
    body = model.body
    if model.cut < 0:
        return None
    row = np.arange(body.nodes) if model.order is None else np.argsort(model.order)
    rest = np.zeros((body.nodes, 4))
    rest[row, :3] = body.rest
    own = [_elements(body, part.body.material, part.first) for part in body.parts if part.body.cut_count]
    own = own or [_elements(body, body.material, 0)]
    found: dict[str, Array] = {name: np.concatenate([each[name] for each in own]) for name in own[0]}
    faces, nothing = cut_skin(body), np.zeros(0, dtype=np.int32)
    across = float(np.sqrt(found["area"].mean()))
    corner, tied = (np.where(found[name] < 0, -1, row[found[name]]) for name in ("corner", "tied"))
    limits = [part.body.material for part in body.parts if part.body.cut_count] or [body.material]
    said = limits[0]
    assert said is not None
    return Cutting(
        first=model.cut,
        breaks=bool(min(said.tear, said.strength) < math.inf),
        decides=np.array(decides, dtype=np.int32),
        rest=rest,
        corner=np.ascontiguousarray(corner, dtype=np.int32),
        each=found["each"].astype(np.int32),
        tied=np.ascontiguousarray(tied, dtype=np.int32),
        hold=found["hold"],
        kind=found["kind"].astype(np.int32),
        edge=np.array([pair for size in KINDS for pair in EDGES[size]], dtype=np.int32),
        edges=np.cumsum([0, *(len(EDGES[size]) for size in KINDS)]).astype(np.int32),
        most=np.ascontiguousarray(found["most"]),
        law=found["law"].astype(np.int32),
        strength=float(said.strength),
        lame=found["lame"],
        gradient=found["gradient"],
        toughness=float(said.toughness),
        area=found["area"],
        face=np.array([face for size in KINDS for face in FACES[size]], dtype=np.int32).reshape(-1, 3),
        faces=np.cumsum([0, *(len(FACES[size]) for size in KINDS)]).astype(np.int32),
        pointer=np.zeros(1, dtype=np.int32) if faces is None else faces.pointer.astype(np.int32),
        element=nothing if faces is None else faces.element.astype(np.int32),
        beyond=nothing if faces is None else faces.beyond.astype(np.int32),
        across=across,
        wanted=np.zeros(found["area"].size, dtype=np.int32),
        bonds=bonds_of(model.operator, tied, corner),
        before=np.zeros((model.operator_rows, model.width)),
        blade=np.zeros((tools, 4)),
        spot=np.zeros((max(KINDS) + 4, 4)),
    )


def _elements(body: Body, material: Material | None, first: int) -> dict[str, Array]:
    """What is to be known of each element of one body, whose first node is given; corners as nodes of all."""
    assert material is not None
    if material.faces.size:
        return _faces(body, material, first)
    elements = material.elements + first
    count, size = elements.shape
    if size not in EDGES:
        raise UnsupportedError(f"elements have {size} corners; only elements of 2, 4 or 8 can be cut")
    edge = np.array(EDGES[size])
    ends = body.rest[elements[:, edge]]
    length = np.linalg.norm(ends[:, :, 1] - ends[:, :, 0], axis=2)
    solid = SOLIDS.index(material.model) if material.model in SOLIDS else -1
    limit = np.full(length.shape, float(material.tear))
    if material.solid and solid < 0 and material.strength < math.inf:
        raise UnsupportedError(
            f"strength is {material.strength:g} Pa, but cotouch does not know the principal stress of model "
            f'"{material.model}"; give tear instead'
        )
    if not material.solid:  # k over the length of an edge is the modulus along it
        with np.errstate(divide="ignore"):
            limit = np.minimum(limit, material.strength * length / material.stiffness[:, None])
    most = np.full((count, max(len(pairs) for pairs in EDGES.values())), math.inf)
    most[:, : edge.shape[0]] = (length * (1.0 + limit)) ** 2
    corner = np.full((count, WIDEST), -1)
    corner[:, :size] = elements
    return {
        "corner": corner,
        "each": np.ones(count),
        "tied": np.full((count, 8), -1),
        "hold": np.zeros(count),
        "kind": np.full(count, KINDS.index(size)),
        "most": most,
        "law": np.full(count, solid),
        "lame": np.zeros((count, 3)) if solid < 0 else lame_of(material),
        "gradient": np.zeros((3 * count, 4)) if solid < 0 else gradients_of(body.rest, elements),
        "area": _areas(body, elements, length),
    }


def _faces(body: Body, material: Material, first: int) -> dict[str, Array]:
    """Likewise of faces that open: what is stretched is the line between the middles of the two elements."""
    count, wide = len(material.faces), material.faces.shape[1] // 2
    corner = np.full((count, WIDEST), -1)
    pair = material.elements[material.sides].reshape(count, -1) + first
    corner[:, : pair.shape[1]] = pair
    middle = body.rest[pair].reshape(count, 2, -1, 3).mean(axis=2)
    most = np.full((count, max(len(pairs) for pairs in EDGES.values())), math.inf)
    most[:, 0] = (np.linalg.norm(middle[:, 1] - middle[:, 0], axis=1) * (1.0 + material.tear)) ** 2
    tied = np.full((count, 8), -1)
    tied[:, :wide], tied[:, 4 : 4 + wide] = material.faces[:, :wide] + first, material.faces[:, wide:] + first
    place = body.rest[tied[:, :wide]]
    area = sum(
        (
            0.5 * np.linalg.norm(np.cross(place[:, n] - place[:, 0], place[:, n + 1] - place[:, 0]), axis=1)
            for n in range(1, wide - 1)
        ),
        np.zeros(count),
    )
    return {
        "corner": corner,
        "each": np.full(count, material.elements.shape[1]),
        "tied": tied,
        "hold": material.ties / area,
        "kind": np.full(count, KINDS.index(2)),
        "most": most,
        "law": np.full(count, -1),
        "lame": np.zeros((count, 3)),
        "gradient": np.zeros((3 * count, 4)),
        "area": area,
    }


def _areas(body: Body, elements: Long, length: Float) -> Float:
    """What a cut through each element lays open: a square as long as its edge, or of its volume, (E,) [m²]."""
    if elements.shape[1] == 4:
        edges = body.rest[elements[:, 1:]] - body.rest[elements[:, :1]]
        return (np.abs(np.linalg.det(edges)) / 6.0) ** (2.0 / 3.0)
    return length.mean(axis=1) ** 2
