"""`cotouch simulate`."""

from pathlib import Path
from typing import TypedDict

import numpy as np
import xarray as xr
from rich.console import Console
from rich.table import Table

from cotouch.cli._output import (
    literal,
    new_table,
    number,
    print_columns,
    print_json,
    print_note,
    print_written,
    working,
)
from cotouch.files import NETCDF, beside, check_writable, folder, list_of
from cotouch.interrupt import interruptible
from cotouch.scenario import Scenario
from cotouch.simulation import (
    FIGURES,
    HTML,
    Judged,
    Numbers,
    RigidToolSummary,
    Summary,
    ToolSummary,
    frame_rate,
    save,
    save_figures,
    summary,
)
from cotouch.simulation import animation as animation_of
from cotouch.simulation import simulate as simulate_scenario

# Waiting that takes less than this of the rate asked for is not worth a word.
_AS_ASKED = 0.99


def run(
    path: Path, *, out: Path | None, figures: Path | None, animation: Path | None, law: str | None, as_json: bool
) -> bool:
    """Runs a scenario, writes what was asked for, prints a summary; whether it came to its end without diverging.

    Args:
        path: of the file to read.
        out: file to write; None: none.
        figures: folder for figures; None: none.
        animation: HTML file to write; None: none.
        law: of the links, instead of the scenario's; None: the scenario's.
        as_json: whether to print one JSON object and nothing else on standard output.
    """
    scenario = Scenario.read(path)
    if law is not None:
        scenario = scenario.replace(synchronisation__law=law)
    read = (path, *scenario.files())
    if out is not None:
        check_writable(out, NETCDF, read)
    if figures is not None:
        beside(folder(figures), [f"{name}.png" for name in FIGURES], read)
    if animation is not None:
        check_writable(animation, HTML, read)
        if scenario.record.frames is None:
            scenario = scenario.replace(record__frames=interruptible(frame_rate)(scenario))
    wait = "a minute and a half" if scenario.tools else "half a minute"
    with working(f"Simulating; the first run compiles for about {wait}", quiet=as_json):
        result = simulate_scenario(scenario)
    written: list[Path] = []
    if out is not None:
        save(result, out)
        written.append(out)
    if figures is not None:
        written += save_figures(result, figures)
    if animation is not None:
        written.append(animation_of(result, scenario.build_body()).write(animation))
    figures_of_run, closure = interruptible(summary)(result, scenario.build_body()), closure_of(result)
    cuts = cuts_of(result)
    if as_json:
        told = {name: each for name, each in (("closure", closure), ("cuts", cuts)) if each is not None}
        print_json({**figures_of_run, **told, "files": [str(file) for file in written]})
        return figures_of_run["finished"]

    console = Console()
    origin = scenario.build_body().origin
    if origin is not None:
        for note in origin.notes:
            print_note(console, "yellow", f"{literal(Path(origin.source).name)}: {literal(note)}")
    if "tools" in figures_of_run:
        console.print(literal(figures_of_run["title"]), style="bold", highlight=False)
        console.print(_tools(scenario.network.users, figures_of_run))
    else:
        _users(console, scenario.network.users, figures_of_run)
    _rigid_tools(console, scenario.network.users, figures_of_run.get("rigid_tools", []))
    console.print(_ledger(figures_of_run, closure, cuts))
    print_written(console, written)
    return figures_of_run["finished"]


class Closure(TypedDict):
    """Work of closing each user's steps; by what it changed velocities at most, and how often by more than 1 %."""

    work_j: list[float]
    largest_factor: float
    alarms: int


def closure_of(result: xr.Dataset) -> Closure | None:
    """What balanced the steps of a body that bends or turns far; None of a linear one."""
    if "closure" not in result:
        return None
    return {
        "work_j": [float(work) for work in result["closure"].max("step") - result["closure"].min("step")],
        "largest_factor": float(result["closure_factor"].max()),
        "alarms": int(result["closure_alarms"].max("step").sum()),
    }


def _closure(closure: Closure | None, grid: Table) -> None:
    """Balanced energy proves no forces; by how much velocities were changed for it does."""
    if closure is not None:
        largest, alarms = closure["largest_factor"], closure["alarms"]
        told = f"; [yellow]{alarms} steps by more than 1 %: use shorter steps[/yellow]" if alarms else ""
        grid.add_row("  closure", f"changed velocities by at most {largest:.1e}{told}")


class Cuts(TypedDict):
    """How many elements each user's copy lost, of how many, and what they held."""

    elements: list[int]
    of: int
    energy_j: list[float]


def cuts_of(result: xr.Dataset) -> Cuts | None:
    """What was cut of a body that can be; None of another."""
    if "cut" not in result:
        return None
    return {
        "elements": [int(count) for count in result["cut_elements"].max("step")],
        "of": result.sizes["element"],
        "energy_j": [float(held) for held in result["cut"].max("step")],
    }


def _cuts(cuts: Cuts | None, grid: Table) -> None:
    """Of the copy that lost most."""
    if cuts is not None:
        most = max(cuts["elements"])
        held = f", which held at most {number(max(cuts['energy_j']), 'J')}" if most else ""
        grid.add_row("  cut", f"{most:,} of {cuts['of']:,} elements{held}")


def _users(console: Console, names: tuple[str, ...], figures: Summary) -> None:
    held = figures["hold"]
    columns: list[tuple[str, list[Numbers]]] = [
        ("damping\nNs/m", figures["local_damping"]),
        (f"position at {held['time_s']:g} s\nm", held["position"]),
        ("force then\nN", held["force"]),
        ("position at the end\nm", figures["final"]["position"]),
    ]
    told = [(heading, [_short(value) for value in values]) for heading, values in columns]
    print_columns(console, figures["title"], names, told)


def _rigid_tools(console: Console, names: tuple[str, ...], tools: list[RigidToolSummary]) -> None:
    """What the hands on rigid tools felt, a line for each."""
    for tool in tools:
        felt = f"{number(tool['peak_force_n'], digits=3)} N and {number(tool['peak_torque_nm'], digits=3)} Nm"
        name = literal(names[tool["user"] - 1])
        console.print(f"  {name} holds a tool ({tool['kind']}) and feels at most {felt}", highlight=False)


def _tools(names: tuple[str, ...], figures: Summary) -> Table:
    """With tools: what each of them felt instead of where nodes are, of which there are many."""
    table = new_table("user", "damping\nNs/m")
    table.add_column("tool", no_wrap=True)
    for heading in ("felt N\npeak", "\nmean", "contacts\nmost", "\ntime s"):
        table.add_column(heading, justify="right")
    for i, name in enumerate(names):
        start = [literal(name), _short(figures["local_damping"][i])]
        own = [tool for tool in figures.get("tools", []) if tool["user"] == i + 1]
        for tool in own:
            count, node = tool["most_contacts"], "" if tool["kind"] == "touch" else " nodes"
            contacts = (
                number(tool["mean_force_n"], digits=3),
                f"{count}{node[:-1] if count == 1 else node}",
                number(tool["contact_time_s"], digits=3),
            )
            table.add_row(
                *start,
                f"{tool['kind']}, {tool['device']}" if tool["device"] else tool["kind"],
                number(tool["peak_force_n"], digits=3),
                *(contacts if tool["kind"] != "blade" else ("–",) * len(contacts)),  # it touches and holds nothing
            )
            start = ["", ""]
        if not own:
            table.add_row(*start, *[""] * 5)
    return table


def _paces(figures: Summary) -> str | None:
    """Who steps more slowly than asked because it waits for others; None where nobody does."""
    asked, taken = (np.atleast_1d(figures["rate_hz"][name]) for name in ("asked", "taken"))
    slow = np.flatnonzero(taken < _AS_ASKED * asked)
    if not slow.size:
        return None
    i = int(slow[np.argmin(taken[slow] / asked[slow])])
    text = (
        f"user {i + 1} takes {number(float(taken[i]), digits=4)} steps a second instead of "
        f"{number(float(asked[i]), digits=4)}, because it waits for the others"
    )
    if slow.size > 1:
        text += f", as do{'es' * (slow.size == 2)} {slow.size - 1} more user{'s' * (slow.size > 2)}"
    text += "; steps are that much longer"
    behind = float(np.max(figures["behind_s"]))
    return text + (f". Copies were up to {number(behind, 's', digits=3)} behind and caught up" if behind > 0.0 else "")


def _coupling(tools: list[ToolSummary]) -> str | None:
    """Whether the couplings of all devices were passive, with the one that came nearest to its bound."""
    coupled = [tool["coupling"] for tool in tools if "coupling" in tool]
    if not coupled:
        return None
    bad = sum(not coupling["passive"] for coupling in coupled)
    excess, bound = max(
        ((coupling["excess_j"], coupling["bound_j"]) for coupling in coupled), key=lambda pair: pair[0] - pair[1]
    )
    verdict = f"[red]{bad} of {len(coupled)} not passive[/red]" if bad else "passive"
    given, most = number(excess, "J", digits=3), number(bound, "J", digits=3)
    return f"{verdict}: gave at most {given} more than it received; bound {most}"


def _hot(tools: list[ToolSummary]) -> list[str]:
    """Devices that could not do for long what they did in the run."""
    return [
        f"user {tool['user']}'s {tool['device']} exerted {number(tool['rms_force_n'], 'N', digits=3)} rms, more than "
        f"the {number(most, 'N', digits=3)} that its motors can sustain"
        for tool in tools
        if "rms_force_n" in tool and (most := tool.get("continuous_force_n")) is not None and tool["rms_force_n"] > most
    ]


def _law(judged: Judged, rounding: float) -> str:
    """What the links made, and whether that is what their law promises."""
    made, seed = (value if value > rounding else 0.0 for value in (judged["made_j"], judged["initial_energy_j"]))
    text = f"{judged['law']}: created {number(made, 'J', digits=3)}"
    if judged["promised"] and not judged["kept"]:
        return f"[red]{text}, but guarantees at most {number(seed, 'J', digits=3)}[/red]"
    promise = "at most" if judged["promised"] else "guarantees nothing; its initial energy is"
    return f"{text}, {promise} {number(seed, 'J', digits=3)}"


def _short(value: Numbers) -> str:
    """A number, or the first few of many."""
    while (entries := list_of(value)) is not None and len(entries) == 1:
        value = entries[0]
    if entries is None:
        return number(float(value), digits=5)
    if value and not isinstance(value[0], list):
        entries = [float(entry) for entry in value]  # pyright: ignore[reportUnknownArgumentType, reportUnknownVariableType]
        least = 1e-6 * max(map(abs, entries))  # what is only rounding beside the others is nothing
        return " ".join(number(entry if abs(entry) > least else 0.0, digits=3) for entry in entries)
    return f"{len(value)} nodes"  # pyright: ignore[reportUnknownArgumentType]


def _ledger(figures: Summary, closure: Closure | None, cuts: Cuts | None) -> Table:
    settling = figures["settling_time_s"]
    grid = Table.grid(padding=(0, 3))
    grid.add_column(style="dim")
    grid.add_column()
    held = figures["hold"]
    energy = figures["energy_j"]
    grid.add_row("  mode", f"{figures['mode']}, {figures['steps']} steps in {figures['duration_s']:g} s")
    paces = _paces(figures)
    if paces is not None:
        grid.add_row("  pace", paces)
    if not figures["finished"]:
        grid.add_row("  [red]diverged[/red]", "the motion exceeded the floating-point range; the run stops there")
    grid.add_row(
        "  settling", f"position {number(settling['position'], 's')}, force {number(settling['force'], 's')} (2 %)"
    )
    apart = figures["discrepancy_m"]
    grid.add_row(
        "  apart", f"{number(apart['rms'], 'm')} rms, {number(apart['p99'], 'm')} p99, {number(apart['max'], 'm')} max"
    )
    if held["force_imbalance"] is not None:
        grid.add_row("  |Σf − K(x̄−x_d)|", f"{number(held['force_imbalance'], 'N')} at {held['time_s']:g} s")
    grid.add_row(
        "  energy",
        f"supplied {number(energy['supplied'], 'J')}, dissipated {number(energy['dissipated'], 'J')}, "
        f"stored {number(energy['stored'], 'J')}, added by delay {number(energy['delay_work'], 'J')}",
    )
    grid.add_row("  residual", f"{figures['energy_residual']:.1e} of the energy in play")
    _closure(closure, grid)
    _cuts(cuts, grid)
    margin = figures["passivity_margin_j"]
    rounding = 1e-10 * energy["in_play"]
    verdict = "passive" if margin >= -rounding else "[red]not passive[/red]"
    told = f"{verdict}: margin {number(margin if abs(margin) > rounding else 0.0, 'J')}"
    if figures["judge"]["law"] == "spring":
        told += f"; the links' damping took {number(figures['slack_j']['at_end'], 'J')} more than delays added"
    grid.add_row("  passivity", told)
    grid.add_row("  law", _law(figures["judge"], rounding))
    coupling = _coupling(figures.get("tools", []))
    if coupling is not None and "device_residual" in figures:
        grid.add_row("  devices", coupling)
        for told in _hot(figures.get("tools", [])):
            grid.add_row("  [yellow]motors[/yellow]", told)
        grid.add_row("  device residual", f"{figures['device_residual']:.1e} of the energy in play")
    ages = figures["age_s"]
    grid.add_row("  age of samples", f"{number(ages['mean'], 's')} mean, {number(ages['max'], 's')} max")
    if "codec" in figures:
        said = figures["codec"]
        grid.add_row(
            "  codec",
            f"{number(said['full_hz'], digits=3)} full samples/s to each neighbour, "
            f"{number(said['unchanged_hz'], digits=3)} one-byte samples/s, {number(said['bytes_hz'], digits=3)} B/s",
        )
    if figures["underruns"]:
        grid.add_row("  [yellow]underruns[/yellow]", f"{figures['underruns']}: no certificate covers them")
    return grid
