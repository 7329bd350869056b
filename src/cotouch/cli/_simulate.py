"""`cotouch simulate`."""

from pathlib import Path
from typing import TYPE_CHECKING, Any

from cotouch.cli._output import folder, number, print_json, working, writable

if TYPE_CHECKING:
    from rich.table import Table


def run(path: Path, *, out: Path | None, figures: Path | None, as_json: bool) -> None:
    """Runs a scenario, writes what was asked for, prints a summary."""
    from cotouch.simulation import Scenario, save, summary
    from cotouch.simulation import simulate as simulate_scenario

    scenario = Scenario.read(path)
    if out is not None:
        writable(out)
    if figures is not None:
        folder(figures)
    with working("Simulating (the first run of all compiles the kernels, for about half a minute)", quiet=as_json):
        result = simulate_scenario(scenario)
    if out is not None:
        save(result, out)
    drawn: list[Path] = []
    if figures is not None:
        from cotouch.simulation import save_figures

        drawn = save_figures(result, figures)
    figures_of_run = summary(result, scenario.build_body())
    if as_json:
        written = [str(file) for file in ([out] if out else []) + drawn]
        print_json({**figures_of_run, "files": written})
        return
    from rich.console import Console

    console = Console()
    origin = scenario.build_body().origin
    if origin is not None:
        for note in origin.notes:
            console.print(f"  [yellow]•[/yellow] {Path(origin.source).name}: {note}", highlight=False, soft_wrap=True)
    console.print(_users(scenario.network.users, figures_of_run))
    console.print(_books(figures_of_run))
    for file in ([out] if out else []) + drawn:
        console.print(f"  wrote {file}", highlight=False)


def _users(names: tuple[str, ...], figures: dict[str, Any]) -> "Table":
    from rich.box import SIMPLE_HEAD
    from rich.table import Table

    held = figures["hold"]
    table = Table(box=SIMPLE_HEAD, title=figures["title"], title_justify="left", title_style="bold")
    table.add_column("user")
    for heading in ("damping B\nNs/m", f"x at {held['time_s']:g} s\nm", "f there\nN", "x at the end\nm"):
        table.add_column(heading, justify="right")
    rows = zip(
        names,
        figures["local_damping"],
        held["position"],
        held["force"],
        figures["final"]["position"],
        strict=True,
    )
    for name, *values in rows:
        table.add_row(name, *(_short(value) for value in values))
    return table


def _short(value: Any) -> str:
    """A number, or the first few of many."""
    while isinstance(value, list) and len(value) == 1:  # pyright: ignore[reportUnknownArgumentType]
        value = value[0]  # pyright: ignore[reportUnknownVariableType]
    if not isinstance(value, list):
        return number(float(value), digits=5)
    if value and not isinstance(value[0], list):
        return " ".join(number(float(entry), digits=3) for entry in value)  # pyright: ignore[reportUnknownVariableType, reportUnknownArgumentType]
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
    verdict = "passive" if margin >= -1e-10 * energy["in_play"] else "[red]not passive[/red]"
    grid.add_row("  passivity", f"{verdict}: margin {number(margin, 'J')}")
    ages = figures["age_s"]
    grid.add_row("  age of samples", f"{number(ages['mean'], 's')} mean, {number(ages['max'], 's')} max")
    if figures["underruns"]:
        grid.add_row("  [yellow]underruns[/yellow]", f"{figures['underruns']}: no certificate covers them")
    return grid
