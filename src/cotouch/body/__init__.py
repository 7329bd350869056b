"""The shared object, and builders for it."""

from cotouch.body._body import Body
from cotouch.body._builders import MOST_NODES, GridModel, chain, lattice, point
from cotouch.body._cells import CORNERS
from cotouch.body._checks import Matrix, SumOfSquares
from cotouch.body._closed_surface import closed_surface
from cotouch.body._cut_away import cut_away
from cotouch.body._cut_faces import with_faces
from cotouch.body._cut_skin import FACES, CutSkin, cut_skin, drawn_skin
from cotouch.body._eigenspaces import canonical
from cotouch.body._from_surface import MOST_TRIANGLES, body_from_surface
from cotouch.body._from_tetrahedra import MOST_ELEMENTS, body_from_tetrahedra
from cotouch.body._ground import Held, NodeNumbers, NodeSet, NodesInBox, NodesNearPlane
from cotouch.body._material import Frame, Material, add_solid_law, solid_laws
from cotouch.body._mesh_material import SurfaceModel, is_solid_model, solid_models
from cotouch.body._origin import Origin
from cotouch.body._part import DrawnPart, Part, ToolBody, drawn_parts, drawn_tools, grip_shares, pulls_of
from cotouch.body._reading import Unit
from cotouch.body._repair import winding
from cotouch.body._rigid import rigid_body, scaled
from cotouch.body._shapes import rigid_box, rigid_cylinder, rigid_sphere, turning
from cotouch.body._skin import Skin
from cotouch.body._statics import lowest_modes
from cotouch.body._strains import SIGNS, axial, frame_of, shares_of, strain_law, turn_vectors
from cotouch.body._together import Placed, joined, together
from cotouch.body._truncation import Truncation

__all__ = [
    "CORNERS",
    "FACES",
    "MOST_ELEMENTS",
    "MOST_NODES",
    "MOST_TRIANGLES",
    "SIGNS",
    "Body",
    "CutSkin",
    "DrawnPart",
    "Frame",
    "GridModel",
    "Held",
    "Material",
    "Matrix",
    "NodeNumbers",
    "NodeSet",
    "NodesInBox",
    "NodesNearPlane",
    "Origin",
    "Part",
    "Placed",
    "Skin",
    "SumOfSquares",
    "SurfaceModel",
    "ToolBody",
    "Truncation",
    "Unit",
    "add_solid_law",
    "axial",
    "body_from_surface",
    "body_from_tetrahedra",
    "canonical",
    "chain",
    "closed_surface",
    "cut_away",
    "cut_skin",
    "drawn_parts",
    "drawn_skin",
    "drawn_tools",
    "frame_of",
    "grip_shares",
    "is_solid_model",
    "joined",
    "lattice",
    "lowest_modes",
    "point",
    "pulls_of",
    "rigid_body",
    "rigid_box",
    "rigid_cylinder",
    "rigid_sphere",
    "scaled",
    "shares_of",
    "solid_laws",
    "solid_models",
    "strain_law",
    "together",
    "turn_vectors",
    "turning",
    "winding",
    "with_faces",
]
