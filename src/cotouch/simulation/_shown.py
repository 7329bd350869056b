"""From a run to its animation."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, TypedDict

import numpy as np

from cotouch.arrays import Array, Bool, Float, Long
from cotouch.body import Body, CutSkin, DrawnPart, Skin, cut_away, cut_skin, drawn_parts, drawn_tools
from cotouch.errors import ScenarioError
from cotouch.mechanics import Shape
from cotouch.scenario import DrawnTexture, TextureTable, WorldTable
from cotouch.simulation._animation import Animation, PortTracks, ToolTracks, UserSeries
from cotouch.simulation._metrics import distances, felt
from cotouch.simulation._run_tables import BodyEntry, RunTables, tables_of

if TYPE_CHECKING:
    import xarray as xr

    from cotouch.scenario import Scenario


# A browser draws no more pictures a second, and nobody watches more of them; places of all users in all frames that a
# page and the memory of a small machine hold.
_RATE = 60.0
_MOST_FRAMES = 1200
_MOST_PLACES = 6_000_000
_LARGEST = 1e6


class _Drawn(TypedDict, total=False):
    """What an `Animation` draws of a body."""

    skin: Skin
    displacement: Array
    parts: Sequence[DrawnPart]
    spans: Float
    vertices: Array
    rest: Float
    edges: Long


def frame_rate(scenario: "Scenario") -> float:
    """How many frames a second an animation of a scenario should have: 60, fewer for long runs and big bodies [Hz]."""
    body = scenario.build_body()
    places = max(body.nodes, 0 if body.skin is None else body.skin.vertices.shape[0]) * scenario.network.size
    duration = scenario.steps.duration
    return max(min(_RATE, _MOST_FRAMES / duration, _MOST_PLACES / (places * duration)), 1.0 / duration)


def animation(run: "xr.Dataset", body: Body) -> Animation:
    """What a run looked like.

    Args:
        run: a result of `simulate` with frames (`record.frames`).
        body: of the run.

    Returns:
        Every user's copy with its tools and hands and what they feel, and how far each copy is from the mean of all. A
        body with a skin is drawn as that, any other as nodes, joined where springs join them.

    Raises:
        ScenarioError: the run has no frames, or it is of another body.
    """
    if "frame_position" not in run:
        raise ScenarioError("the run has no frames; set record.frames in the scenario, in Hz")
    frames = run["frame_position"].values
    sound = np.flatnonzero(~(np.abs(frames) < _LARGEST).all(axis=(1, 2, 3)))  # a run that diverged is shown until then
    frames = frames[: sound[0] if sound.size else None]
    if frames.shape[2:] != body.rest.shape:
        raise ScenarioError(
            f"the run's body has {frames.shape[2]} nodes and {frames.shape[3]} axes, this one {body.nodes} and "
            f"{body.dimension}; give the body of the run"
        )
    when = run["frame"].values[: frames.shape[0]].astype(np.float64)
    tables = tables_of(run)
    apart = distances(frames[:, :, : body.shared], _debris(run, body, when)[:, :, : body.shared])
    return Animation(
        title=run.attrs["title"],
        users=[str(name) for name in run["user"].values],
        time=when,
        tools=_tools(run, tables, when),
        ports=_ports(run, tables, when, frames, body),
        links=[(a - 1, b - 1) for a, b in tables["network"]["links"]],
        series=[UserSeries(name="Discrepancy", unit="m", values=np.fmax.reduce(apart, axis=2))],
        shapes=_shapes(tables.get("world", {})),
        texture=_texture(tables.get("contact", {})),
        **_drawn(run, tables, frames, body),
    )


def _drawn(run: "xr.Dataset", tables: RunTables, frames: Array, body: Body) -> _Drawn:
    """What is drawn of all copies: the skin that is left, the whole skin, or nodes and springs."""
    bodies = tables.get("bodies", [])
    moved = frames - body.rest.astype(np.float32)
    if "cut_time" in run and (faces := cut_skin(body)) is not None:
        return {
            "skin": faces.skin,
            "displacement": moved,
            "spans": _in_their_copies(body, _spans(run, faces), faces),
            "parts": drawn_parts(body, _colours(bodies), faces),
        }
    if body.skin is None or not body.skin.triangles.size:
        return {"vertices": frames, "rest": body.rest, "edges": _edges(body)}
    shape: _Drawn = {"skin": body.skin, "displacement": moved, "parts": drawn_parts(body, _colours(bodies))}
    if body.tools:
        always = np.empty((frames.shape[1], body.skin.triangles.shape[0], 2))
        always[...] = -np.inf, np.inf
        shape["spans"] = _in_their_copies(body, always)
    return shape


def _debris(run: "xr.Dataset", body: Body, when: Float) -> Bool:
    """Which nodes of each copy have lost their last element, (frames, users, nodes)."""
    if "cut_time" not in run:
        return np.zeros((when.size, run.sizes["user"], body.nodes), dtype=np.bool_)
    cut = np.nan_to_num(run["cut_time"].values, nan=np.inf)
    return when[:, None, None] >= np.stack([cut_away(body, own) for own in cut])


def _spans(run: "xr.Dataset", faces: CutSkin) -> Float:
    """When each triangle of each copy is there, (users, triangles, 2) [s]."""
    cut = np.nan_to_num(run["cut_time"].values, nan=np.inf)
    begin = np.where(faces.beyond < 0, -np.inf, cut[:, np.maximum(faces.beyond, 0)])
    end = np.full((cut.shape[0], faces.beyond.size), np.inf)
    of = np.repeat(np.arange(faces.beyond.size), np.diff(faces.pointer))
    for user, times in enumerate(cut):
        np.minimum.at(end[user], of, times[faces.element])
    return np.stack([begin, end], axis=-1)


def _in_their_copies(body: Body, spans: Float, faces: CutSkin | None = None) -> Float:
    """When each triangle of each copy is there, (users, triangles, 2) [s]: a tool only in its user's."""
    skin = body.skin if faces is None else faces.skin
    assert skin is not None
    corner = skin.triangles[:, 0]
    for first, last, owner in drawn_tools(body, faces):
        own = (corner >= first) & (corner < last)
        for user in range(spans.shape[0]):
            if user != owner:
                spans[user, own, 1] = -np.inf
    return spans


def _shapes(world: dict[str, object]) -> list[Shape]:
    return [obstacle.shape for obstacle in WorldTable.model_validate(world).obstacles()]


def _texture(contact: dict[str, object]) -> DrawnTexture | None:
    """What lies on the skin; a picture is read again."""
    given = contact.get("texture")
    return None if given is None else TextureTable.model_validate(given).drawn()


def _colours(bodies: list[BodyEntry]) -> list[str | None]:
    """Of each body; one that was made in Python has its own."""
    return [one.get("color") for one in bodies for _ in range(one.get("copies", 1))]


def _edges(body: Body) -> Long:
    """Pairs of nodes that a spring joins, (E, 2)."""
    per = 1 if body.form == "node" else body.dimension
    springs = body.stiffness_int.tocoo()
    known = springs.data != 0.0
    pairs = np.stack([springs.coords[0][known] // per, springs.coords[1][known] // per], axis=1)
    return np.unique(pairs[pairs[:, 0] < pairs[:, 1]], axis=0)


def _tools(run: "xr.Dataset", tables: RunTables, when: Float) -> ToolTracks | None:
    tools = tables.get("tools", [])
    if not tools:
        return None
    owner = [tool["user"] - 1 for tool in tools]
    return ToolTracks(
        owner=owner,
        centre=_at(run, owner, run["tool_position"].values, when),
        radius=[0.5 * tool["thickness"] if tool["kind"] == "blade" else tool["radius"] for tool in tools],
        axis=[tool["axis"] if tool["kind"] == "blade" else [0.0, 0.0, 0.0] for tool in tools],
        tip=[[0.0, 0.0, 0.0] if tool["kind"] == "blade" else tool["axis"] or [0.0, 0.0, 0.0] for tool in tools],
        force=_at(run, owner, felt(run), when),
    )


def _ports(run: "xr.Dataset", tables: RunTables, when: Float, frames: Array, body: Body) -> PortTracks | None:
    hands = tables["hands"]
    tools = tables.get("rigid_tools", [])
    if not hands and not tools:
        return None
    owner = [hand["user"] - 1 for hand in hands]
    node, shares = [hand["node"] - 1 for hand in hands], body.held_shares
    # Of what is rigid, places are held.
    place = frames[:, owner, node] if shares is None else np.einsum("hn,fhna->fha", shares[node], frames[:, owner])
    force = _at(run, owner, run["hand_force"].values, when)
    if tools:
        movers = [tool["user"] - 1 for tool in tools]
        place = np.concatenate([place, _at(run, movers, run["rigid_position"].values, when)], axis=1)
        force = np.concatenate([force, _at(run, movers, run["rigid_force"].values, when)], axis=1)
        owner += movers
    return PortTracks(owner=owner, place=place, force=force)


def _at(run: "xr.Dataset", owner: list[int], values: Float, when: Float) -> Float:
    """Values at the times of frames, straight between the steps of each thing's user, (frames, things, axes)."""
    result = np.zeros((when.size, len(owner), values.shape[-1]))
    for thing, user in enumerate(owner):
        time = run["time"].values[user]
        known = np.isfinite(time)
        for axis in range(values.shape[-1]):
            result[:, thing, axis] = np.interp(when, time[known], values[thing, known, axis])
    return result
