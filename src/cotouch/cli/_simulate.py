"""`cotouch simulate`."""

from pathlib import Path
from typing import TYPE_CHECKING, Any

from cotouch.cli._output import folder, number, print_json, working, writable

if TYPE_CHECKING:
    from rich.table import Table


def run(path: Path, *, out: Path | None, figures: Path | None, animation: Path | None, as_json: bool) -> None:
    """Runs a scenario, writes what was asked for, prints a summary."""
    from cotouch.scenario import Scenario
    from cotouch.simulation import frame_rate, save, summary
    from cotouch.simulation import simulate as simulate_scenario

    scenario = Scenario.read(path)
    if out is not None:
        writable(out)
    if figures is not None:
        folder(figures)
    if animation is not None:
        writable(animation)
        if scenario.record.frames is None:
            scenario = scenario.replace(record__frames=frame_rate(scenario))
    wait = "a minute and a half" if scenario.tools else "half a minute"
    with working(f"Simulating (the first run of all compiles the kernels, for about {wait})", quiet=as_json):
        result = simulate_scenario(scenario)
    written: list[Path] = []
    if out is not None:
        save(result, out)
        written.append(out)
    if figures is not None:
        from cotouch.simulation import save_figures

        written += save_figures(result, figures)
    if animation is not None:
        from cotouch.simulation import animation as animation_of

        written.append(animation_of(result, scenario.build_body()).write(animation))
    figures_of_run = summary(result, scenario.build_body())
    if as_json:
        print_json({**figures_of_run, "files": [str(file) for file in written]})
        return
    from rich.console import Console

    console = Console()
    origin = scenario.build_body().origin
    if origin is not None:
        for note in origin.notes:
            console.print(f"  [yellow]•[/yellow] {Path(origin.source).name}: {note}", highlight=False, soft_wrap=True)
    console.print(figures_of_run["title"], style="bold", highlight=False, markup=False)
    console.print((_tools if "tools" in figures_of_run else _users)(scenario.network.users, figures_of_run))
    console.print(_books(figures_of_run))
    for file in written:
        console.print(f"  wrote {file}", highlight=False, soft_wrap=True)


def _users(names: tuple[str, ...], figures: dict[str, Any]) -> "Table":
    from rich.box import SIMPLE_HEAD
    from rich.table import Table

    held = figures["hold"]
    table = Table(box=SIMPLE_HEAD)
    table.add_column("user")
    columns: list[tuple[str, list[Any]]] = [
        ("damping B\nNs/m", figures["local_damping"]),
        (f"x at {held['time_s']:g} s\nm", held["position"]),
        ("f there\nN", held["force"]),
        ("x at the end\nm", figures["final"]["position"]),
    ]
    for heading, _ in columns:
        table.add_column(heading, justify="right")
    for name, *values in zip(names, *(values for _, values in columns), strict=True):
        table.add_row(name, *(_short(value) for value in values))
    return table


def _tools(names: tuple[str, ...], figures: dict[str, Any]) -> "Table":
    """With tools: what each of them felt instead of where nodes are, of which there are many."""
    from rich.box import SIMPLE_HEAD
    from rich.table import Table

    table = Table(box=SIMPLE_HEAD)
    table.add_column("user")
    table.add_column("damping B\nNs/m", justify="right")
    table.add_column("tool", no_wrap=True)
    for heading in ("felt N\npeak", "\nmean", "contacts\nat most", "\nfor s"):
        table.add_column(heading, justify="right")
    for i, name in enumerate(names):
        start = [name, _short(figures["local_damping"][i])]
        own = [tool for tool in figures["tools"] if tool["user"] == i + 1]
        for tool in own:
            count, node = tool["most_contacts"], "" if tool["kind"] == "touch" else " nodes"
            table.add_row(
                *start,
                f"{tool['kind']}, {tool['device']}" if tool["device"] else tool["kind"],
                number(tool["peak_force_n"], digits=3),
                number(tool["mean_force_n"], digits=3),
                f"{count}{node[:-1] if count == 1 else node}",
                number(tool["contact_time_s"], digits=3),
            )
            start = ["", ""]
        if not own:
            table.add_row(*start, *[""] * 5)
    return table


def _coupling(tools: list[dict[str, Any]]) -> str | None:
    """Whether the couplings of all devices were passive, with the one that came nearest to its bound."""
    coupled = [
        (tool["coupling"]["excess_j"], tool["coupling"]["bound_j"], tool) for tool in tools if "coupling" in tool
    ]
    if not coupled:
        return None
    bad = sum(not tool["coupling"]["passive"] for *_, tool in coupled)
    excess, bound, _ = max(coupled, key=lambda entry: entry[0] - entry[1])
    verdict = f"[red]{bad} of {len(coupled)} not passive[/red]" if bad else "passive"
    given, most = number(excess, "J", digits=3), number(bound, "J", digits=3)
    return f"{verdict}: gave at most {given} more than it got, bound {most}"


def _short(value: Any) -> str:
    """A number, or the first few of many."""
    while isinstance(value, list) and len(value) == 1:  # pyright: ignore[reportUnknownArgumentType]
        value = value[0]  # pyright: ignore[reportUnknownVariableType]
    if not isinstance(value, list):
        return number(float(value), digits=5)
    if value and not isinstance(value[0], list):
        entries = [float(entry) for entry in value]  # pyright: ignore[reportUnknownArgumentType, reportUnknownVariableType]
        least = 1e-6 * max(map(abs, entries))  # what is only rounding beside the others is nothing
        return " ".join(number(entry if abs(entry) > least else 0.0, digits=3) for entry in entries)
    return f"{len(value)} nodes"  # pyright: ignore[reportUnknownArgumentType]


def _books(figures: dict[str, Any]) -> "Table":
    from rich.table import Table

    settling = figures["settling_time_s"]
    grid = Table.grid(padding=(0, 3))
    grid.add_column(style="dim")
    grid.add_column()
    held = figures["hold"]
    energy = figures["energy_j"]
    grid.add_row("  mode", f"{figures['mode']}, {figures['steps']} steps in {figures['duration_s']:g} s")
    if not figures["finished"]:
        grid.add_row("  [red]diverged[/red]", "the motion left the range of floating point; the run stops there")
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
    margin = figures["passivity_margin_j"]
    rounding = 1e-10 * energy["in_play"]
    verdict = "passive" if margin >= -rounding else "[red]not passive[/red]"
    grid.add_row("  passivity", f"{verdict}: margin {number(margin if abs(margin) > rounding else 0.0, 'J')}")
    coupling = _coupling(figures.get("tools", []))
    if coupling is not None:
        grid.add_row("  devices", coupling)
        grid.add_row("  their residual", f"{figures['device_residual']:.1e} of the energy in play")
    ages = figures["age_s"]
    grid.add_row("  age of samples", f"{number(ages['mean'], 's')} mean, {number(ages['max'], 's')} max")
    if figures["underruns"]:
        grid.add_row("  [yellow]underruns[/yellow]", f"{figures['underruns']}: no certificate covers them")
    return grid
