"""What does not change, and what changes now and then, as messages for a page."""

import base64
from collections.abc import Mapping

import numpy as np
import numpy.typing as npt

from cotouch.arrays import Float
from cotouch.body import Body, CutSkin, cut_skin, drawn_parts, drawn_skin, drawn_tools
from cotouch.device import NOTICED_DRAG
from cotouch.mechanics import shape_table
from cotouch.members import Status, law_felt
from cotouch.observers import CopyView, Overview, Scene
from cotouch.web._verdict import judged

_EVENTS = 40  # of the last
_MOST_EDGES = 60_000


def scene_message(
    scene: Scene, *, version: str, started: str, acts: bool, page: str | None = None
) -> dict[str, object]:
    """The scene, as JSON's values.

    Args:
        scene: of the stage.
        version: of cotouch.
        started: names this run of the server.
        acts: whether the page has the token; else it may do nothing and isn't told the invitation.
        page: where other devices find the page, without the token; None: they do not.
    """
    body = scene.body
    rest = np.zeros((body.holds, 3), np.float64)
    rest[:, : body.dimension] = body.held_rest
    faces = cut_skin(body) if body.cut_count else None
    skin = body.skin if faces is None else faces.skin
    drawn = rest if skin is None else skin.vertices
    low, high = drawn.min(axis=0, initial=np.inf), drawn.max(axis=0, initial=-np.inf)
    centre = 0.5 * (low + high)
    return {
        "type": "scene",
        "title": scene.title,
        "version": version,
        "dimension": body.dimension,
        "users": [{"slot": slot, "name": name} for slot, name in enumerate(scene.users)],
        "own": list(scene.own),
        "may": sorted(scene.may) if acts else [],
        "acts": acts,
        "invitation": scene.invitation if acts else None,
        "page": page if acts else None,
        "nodes": {"count": body.holds, "rest": _packed(rest, "<f4")},
        "skin": None
        if skin is None
        else {
            "vertices": skin.vertices.shape[0],
            "rest": _packed(skin.vertices, "<f4"),
            "triangles": _packed(skin.triangles, "<u4"),
            "node": _packed(nodes_of_points(body), "<u4"),
        },
        "cutting": _cutting(body, faces),
        "edges": None if skin is not None else _packed(_edges(body), "<u4"),
        "parts": drawn_parts(body, scene.colours, faces),
        "texture": None if scene.texture is None else scene.texture.table(),
        "obstacles": [shape_table(shape) for shape in scene.shapes],
        "radius": float(np.linalg.norm(drawn - centre, axis=1).max(initial=0.0)),
        "centre": centre.tolist(),
        "stiffness": scene.stiffness,
        "started": started,
    }


def nodes_of_points(body: Body) -> npt.NDArray[np.integer]:
    """The node that carries most of each drawn point, (points,); of tools none that there is."""
    if body.rigid and body.skin is not None:
        every = np.arange(body.shared, body.shared + int(body.skin.vertices.shape[0]))
        return _no_tools(body, every)
    skin = drawn_skin(body)
    if skin is None:
        return np.arange(body.nodes)
    best = np.argmax(skin.weights, axis=1)
    return _no_tools(body, np.take_along_axis(skin.nodes, best[:, None], axis=1)[:, 0])


def _no_tools(body: Body, nodes: npt.NDArray[np.integer]) -> npt.NDArray[np.integer]:
    """The same, and `Body.holds` for points of tools, which nobody can hold there."""
    for first, last, _ in drawn_tools(body, cut_skin(body) if body.cut_count else None) if body.tools else ():
        nodes[first:last] = body.holds
    return nodes


def held_tools(body: Body) -> list[tuple[int, int, int, int]]:
    """First and one past the last of the drawn points of each tool that can be held, its user, and its number."""
    found: list[tuple[int, int, int, int]] = []
    first = 0
    for part in drawn_parts(body, (), cut_skin(body) if body.cut_count else None) if body.tools else ():
        last = first + part["vertices"]
        if "tool" in part:
            found.append((first, last, part["tool"]["slot"], part["tool"]["number"]))
        first = last
    return found


def beside_nodes(body: Body) -> Float:
    """From each drawn point's node to the point, at rest, (points, 3) [m]."""
    skin = drawn_skin(body)
    if skin is None:
        return np.zeros((body.nodes, 3))
    rest = np.zeros((body.holds + 1, 3))
    rest[: body.holds, : body.dimension] = body.held_rest
    return np.asarray(skin.vertices) - rest[nodes_of_points(body)]


def state_message(
    overview: Overview,
    views: Mapping[int, CopyView],
    *,
    now: float,
    start: float,
    control: str,
    pages: int,
) -> dict[str, object]:
    """How things are, as JSON's values.

    Args:
        overview: of the stage.
        views: of its copies, for what hands do.
        now: by the clock of the stage [s].
        start: what times count from [s].
        control: "mine", "other" or "none".
        pages: how many watch.
    """
    here = {entry.slot for entry in overview.roster.members}
    members: dict[str, object] = {}
    ends: dict[str, object] = {}
    for slot in sorted(here | set(overview.statuses) | set(overview.alive)):
        status = overview.statuses.get(slot)
        view = views.get(slot)
        members[str(slot)] = (status or Status(slot=slot)).model_dump() | {
            "known": status is not None,
            "here": slot in here,
            "alive": overview.alive.get(slot),
            "hand": _told(view),
            "cut": None if view is None or view.cut is None else _packed(np.packbits(view.cut != 0), "|u1"),
            "cut_by": [] if view is None or view.cut is None else np.bincount(view.cut).tolist(),
        }
        for link in () if status is None else status.links:
            ends[f"{slot}-{link.slot}"] = link.model_dump()
    return {
        "type": "state",
        "time": now - start,
        "age": max(now - overview.time, 0.0),
        "members": members,
        "links": [list(pair) for pair in overview.roster.links],
        "ends": ends,
        "emulated": {f"{to}-{of}": vars(path_state) for (to, of), path_state in overview.emulated.items()},
        "choices": {name: [list(pair) for pair in pairs] for name, pairs in overview.choices.items()},
        "damping": overview.damping,
        "law": _law(overview),
        "recording": overview.recording._asdict(),
        "events": [{"time": event.time - start, "text": event.text} for event in list(overview.events)[-_EVENTS:]],
        "verdict": vars(judged(overview)),
        "control": control,
        "pages": pages,
        "ended": overview.ended,
    }


def _law(overview: Overview) -> dict[str, object] | None:
    """Which law the links have, and what is felt of it; None before anybody moves."""
    here = {entry.slot for entry in overview.roster.members}
    found = law_felt([status for slot, status in sorted(overview.statuses.items()) if slot in here])
    return None if found is None else {**vars(found), "noticed": NOTICED_DRAG}


def _told(view: CopyView | None) -> str | None:
    """What a hand does; None where it is led on another computer, so that nobody here knows."""
    if view is not None and view.hands:
        return view.hands[0].mode
    return "free" if view is None or view.direct else None


def _cutting(body: Body, faces: CutSkin | None) -> dict[str, object] | None:
    """What the drawn triangles of a body that can be cut hang on; see `CutSkin`."""
    if faces is None:
        return None
    return {
        "elements": body.cut_count,
        "pointer": _packed(faces.pointer, "<u4"),
        "element": _packed(faces.element, "<u4"),
        "beyond": _packed(faces.beyond, "<i4"),
    }


def _packed(array: npt.ArrayLike, kind: str) -> str:
    return base64.b64encode(np.ascontiguousarray(array, dtype=kind).tobytes()).decode("ascii")


def _edges(body: Body) -> np.ndarray:
    """Pairs of nodes that springs join, (pairs, 2)."""
    rows = 1 if body.form == "node" else body.dimension  # of a node
    pairs = np.stack(body.stiffness_int.tocoo().coords, axis=1) // rows
    upper = np.unique(pairs[pairs[:, 0] < pairs[:, 1]], axis=0)
    return upper[:_MOST_EDGES]
