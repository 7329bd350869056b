"""`cotouch body`."""

from pathlib import Path
from typing import TypedDict

import numpy as np
from rich.console import Console
from rich.table import Table

from cotouch.arrays import Float
from cotouch.body import Body
from cotouch.cli._output import literal, new_table, number, print_json, print_note, print_written, working
from cotouch.errors import ScenarioError
from cotouch.files import beside, folder
from cotouch.interrupt import interruptible
from cotouch.meshfile import is_surface
from cotouch.scenario import FileTable, Scenario
from cotouch.simulation import BodyReport, body_report, save_body_figure

# What the options for meshes are where nobody gives them.
_USUAL = {
    "young": 1e4,
    "poisson": 0.3,
    "rayleigh_mass": 0.0,
    "rayleigh_stiffness": 0.0,
    "ground": "none",
    "ground_stiffness": 1e3,
    "ground_damping": 0.0,
}


def run(
    path: Path,
    *,
    figures: Path | None,
    as_json: bool,
    ground: str,
    most: int | None = None,
    **options: object,
) -> None:
    """Reads a mesh, makes the body, and says what was understood; or says what bodies a scenario has.

    Args:
        path: of the file to read: a mesh, or a scenario, which has its own options.
        figures: folder for figures; None: none.
        as_json: whether to print one JSON object and nothing else on standard output.
        ground: what holds the body, as on the command line.
        most: elements that are taken; None: the usual.
        **options: of the library call, as named there.
    """
    if path.suffix.lower() == ".toml":
        _refuse_mesh_options(path, {**options, "ground": ground, "most": most, "figures": figures})
        _tell_scenario(path, as_json=as_json)
        return
    if figures is not None and figures.is_dir():  # it is made only once there is something to draw
        beside(figures, ("body.png",), (path,))
    given = {name: value for name, value in options.items() if value is not None}
    if most is not None:
        given["most_triangles" if is_surface(path) else "most_elements"] = most
    table = FileTable.make(source="the body", file=str(path), ground=_ground(ground), **given)
    with working("Reading the mesh and finding its modes", quiet=as_json):
        body = interruptible(table.build)()
        numbers, fields = interruptible(body_report)(body)
        drawn: list[Path] = []
        if figures is not None:
            drawn.append(save_body_figure(body, numbers, fields, folder(figures)))
    truncation = None if table.modes is None else interruptible(_truncated)(body, table.modes)
    if as_json:
        told = {} if truncation is None else {"truncation": truncation}
        print_json({**numbers, **told, "files": [str(file) for file in drawn]})
        return

    console = Console()
    console.print(_table(numbers, truncation))
    for note in numbers["notes"]:
        print_note(console, "yellow", literal(note))
    print_written(console, drawn)


def _refuse_mesh_options(path: Path, options: dict[str, object]) -> None:
    for name, value in options.items():
        if value is not None and value != _USUAL.get(name):
            raise ScenarioError(
                f'--{name.replace("_", "-")} is {value}, but "{path}" is a scenario, which sets this itself; leave '
                f"the option out"
            )


def _tell_scenario(path: Path, *, as_json: bool) -> None:
    """Prints a row for each of a scenario's bodies."""
    with working("Building the bodies", quiet=as_json):
        body = interruptible(Scenario.read(path).build_body)()
    found = [_of_scenario(one.name, one.body, one.rest()) for one in body.parts] or [_of_scenario("", body, body.rest)]
    if as_json:
        print_json({"file": str(path), "nodes": body.nodes, "bodies": found})
        return

    title = f"{path.name}: {len(found)} bod{'ies' if len(found) > 1 else 'y'}, {body.nodes:,} nodes"
    headings = ("body", "model", "nodes", "skin", "mass", "size", "centre")
    shown = new_table(*headings, title=literal(title), text=len(headings))
    for one in found:
        size, middle = (" × ".join(map(number, one["size_m"])), ", ".join(map(number, one["middle_m"])))
        shown.add_row(
            literal(one["name"]),
            one["model"],
            f"{one['nodes']:,}",
            f"{one['triangles']:,} triangles" if one["triangles"] else "none",
            number(one["mass_kg"], "kg"),
            f"{size} m",
            f"{middle} m",
        )
    Console().print(shown)


class _Row(TypedDict):
    name: str
    model: str
    nodes: int
    triangles: int
    mass_kg: float
    size_m: list[float]
    middle_m: list[float]


def _of_scenario(name: str, body: Body, rest: Float) -> _Row:
    """What one of a scenario's bodies is, and where."""
    skin = body.skin
    seen = rest if skin is None or not skin.vertices.size else _seen(body, rest)
    return {
        "name": name,
        "model": "linear" if body.material is None else body.material.model,
        "nodes": body.nodes,
        "triangles": 0 if skin is None else int(skin.triangles.shape[0]),
        "mass_kg": float(body.mass.sum()) / (1 if body.form == "node" else body.dimension),
        "size_m": (seen.max(axis=0) - seen.min(axis=0)).tolist(),
        "middle_m": (0.5 * (seen.max(axis=0) + seen.min(axis=0))).tolist(),
    }


def _seen(body: Body, rest: Float) -> Float:
    """Where the vertices of its skin are among others, (V, 3) [m]."""
    assert body.skin is not None
    places = body.skin.interpolation(body.nodes) @ rest
    grain = 1e-12 * float(abs(places).max())  # what is below it is rounding
    return (places / grain).round() * grain if grain > 0.0 else places


class _Truncated(TypedDict):
    modes: int
    shapes: int
    contacts: list[int]
    compliance_error: float
    compliance_error_without_residual: float


def _truncated(body: Body, modes: int) -> _Truncated:
    """How far a few modes are off under a fingertip, at nodes all over the skin."""
    assert body.skin is not None
    held = body.skin.nodes[:, 0]
    nodes = np.unique(held[:: max(len(held) // 8, 1)])
    found = body.truncated(modes=modes, contacts=nodes.tolist()).truncation
    assert found is not None
    return {
        "modes": found.modes,
        "shapes": found.shapes.shape[1],
        "contacts": [node + 1 for node in found.contacts],
        "compliance_error": found.error,
        "compliance_error_without_residual": found.error_without,
    }


def _ground(text: str) -> str | dict[str, object]:
    """`z-`, `set:NAME`, `plane:X,Y,Z/NX,NY,NZ[/THICKNESS]`, `box:X,Y,Z/X,Y,Z`, as a scenario's table would say it."""
    kind, colon, rest = text.partition(":")
    if not colon:
        return text
    if kind == "set":
        return {"set": rest}
    try:
        parts = [[float(value) for value in part.split(",")] for part in rest.split("/")]
    except ValueError:
        parts = []
    if kind == "plane" and len(parts) in {2, 3} and len(parts[-1]) == (3 if len(parts) == 2 else 1):
        thickness = {"thickness": parts[2][0]} if len(parts) == 3 else {}
        return {"plane": {"point": parts[0], "normal": parts[1], **thickness}}
    if kind == "box" and len(parts) == 2:
        return {"box": {"low": parts[0], "high": parts[1]}}
    raise ScenarioError(
        f'--ground is "{text}"; it must be none, all, a face such as z-, set:NAME, plane:X,Y,Z/NX,NY,NZ[/THICKNESS] or '
        "box:X,Y,Z/X,Y,Z (in metres)"
    )


def _table(numbers: BodyReport, truncation: _Truncated | None) -> Table:
    shown = new_table("quantity", "value", title=literal(Path(numbers["file"]).name), text=2)
    cells = numbers["kind"] == "surface"
    size = " × ".join(number(extent) for extent in numbers["size_m"])
    shown.add_row("size", f"{size} m (unit: {numbers['unit']})")
    shown.add_row("volume", number(numbers["volume_m3"], "m³"))
    shown.add_row("mass", number(numbers["mass_kg"], "kg"))
    shown.add_row("moments of inertia", ", ".join(number(value) for value in numbers["inertia_kgm2"]) + " kg m²")
    rigid = numbers["model"] == "rigid"
    what = "triangles with edges of" if rigid else "cells of" if cells else "tetrahedra with edges of"
    shown.add_row("nodes", f"{numbers['nodes']:,}")
    shown.add_row("elements", f"{numbers['elements']:,} {what} {number(numbers['spacing_m'], 'm')}")
    shown.add_row("model", "linear elasticity" if numbers["model"] == "elastic" else numbers["model"])
    skin = numbers["skin"]
    if skin is not None:
        shown.add_row("skin", f"{skin['vertices']:,} vertices, {skin['triangles']:,} triangles")
    held = numbers["held_nodes"]
    free = numbers["free_rigid_motions"]
    loose = f", {free} rigid motion{'s' * (free != 1)} free" if free else ""
    shown.add_row("held by", f"the ground at {held:,} node{'s' * (held != 1)}{loose}" if held else f"nothing{loose}")
    heard = ", ".join(number(value, digits=3) for value in numbers["frequencies_hz"])
    each = ", each along all axes" if numbers["times_each"] > 1 else ""
    if not rigid:
        shown.add_row("first modes", f"{heard} Hz{each}")
    if truncation is not None:
        shown.add_row(
            f"{truncation['modes']} modes",
            f"compliance at {len(truncation['contacts'])} skin nodes off by up to "
            f"{100 * truncation['compliance_error_without_residual']:.3g} %; with their static residuals, "
            f"{100 * truncation['compliance_error']:.1g} %",
        )
    return shown
