"""`cotouch feel` and `cotouch sweep`."""

import sys
from collections.abc import Sequence
from pathlib import Path

from rich.console import Console

from cotouch.cli._compare import CELLS, RESULTS
from cotouch.cli._output import counting, literal, new_table, number, print_json, print_written, working
from cotouch.errors import ScenarioError, printable
from cotouch.files import beside, folder, write_netcdf
from cotouch.laboratory import SWEPT, impedance, impedance_figure, values_of
from cotouch.laboratory import sweep as sweep_scenario
from cotouch.scenario import Scenario

_FIGURE = "impedance.png"


def feel(
    path: Path, *, user: int, others: str, law: str | None, figures: Path | None, measure: bool, as_json: bool
) -> None:
    """What a hand feels: drag, mass, stiffness, and impedance over frequency.

    Args:
        path: of the scenario.
        user: whose hand, from 1.
        others: what the other hands do: "free" or "holding".
        law: instead of the scenario's; None: its own.
        figures: folder for the Bode plot; None: none is drawn.
        measure: simulate, beside predicting.
        as_json: print JSON instead of a table.
    """
    scenario = Scenario.read(path)
    if law is not None:
        scenario = scenario.replace(synchronisation__law=law)
    if others not in {"free", "holding"}:
        raise ScenarioError(f'--others is "{others}"; it must be "free" or "holding"')
    if figures is not None:
        beside(folder(figures), [_FIGURE], (path, *scenario.files()))
    with working("Exciting the hand, one frequency at a time ...", quiet=as_json):
        found = impedance(scenario, user, others="free" if others == "free" else "holding", measured=measure)
    written = [] if figures is None else [impedance_figure(found, figures / _FIGURE)]
    columns = {str(name): found[name].values.tolist() for name in found.data_vars}
    if as_json:
        attrs = {str(name): value for name, value in found.attrs.items()}
        frequency = found["frequency"].values.tolist()
        print_json({**attrs, "frequency_hz": frequency, **columns, "files": [str(file) for file in written]})
        return

    console = Console()
    console.print(
        f"Law {literal(found.attrs['law'])}: what user {user} feels, others {others}", style="bold", highlight=False
    )
    kinds = ["predicted", "measured"] if measure else ["predicted"]
    table = new_table("", *kinds)
    for quantity, unit in (("drag", "Ns/m"), ("mass", "kg"), ("stiffness", "N/m")):
        values = [found.attrs[f"{kind}_{quantity}"] for kind in kinds]
        table.add_row(f"{quantity} [dim]{unit}[/dim]", *(_known(value) for value in values))
    console.print(table)
    table = new_table("Hz", *(f"impedance {kind}\nNs/m" for kind in kinds), text=0)
    for index, frequency in enumerate(found["frequency"].values.tolist()):
        parts = [(columns[f"{kind}_real"][index], columns[f"{kind}_imag"][index]) for kind in kinds]
        table.add_row(number(frequency, digits=3), *(_complex(*part) for part in parts))
    console.print(table)
    print_written(console, written)


def _known(value: float) -> str:
    return number(value, digits=3) if value == value else "–"  # noqa: PLR0124  (not a number)


def _complex(real: float, imaginary: float) -> str:
    return f"{real:.3g} {'-' if imaginary < 0.0 else '+'} {abs(imaginary):.3g}j" if real == real else "–"  # noqa: PLR0124


def sweep(path: Path, *, vary: Sequence[str], out: Path | None, dask: str | None, jobs: int, as_json: bool) -> None:
    """A scenario at every combination of options; runs that are in the folder `out` are not done again.

    Args:
        path: of the scenario.
        vary: options as OPTION=VALUES.
        out: folder of all runs; None: nothing is written.
        dask: address of a Dask scheduler whose workers compute instead.
        jobs: how many runs are done at once; -1: one per core.
        as_json: print JSON instead of a table.
    """
    scenario = Scenario.read(path)
    if out is not None:
        beside(folder(out), [RESULTS], (path, *scenario.files()))
    options: dict[str, list[float | str]] = {}
    for text in vary:
        option, equals, values = text.partition("=")
        if not equals or not option or not values:
            raise ScenarioError(f'--vary is "{text}"; it must be OPTION=VALUES, as in link.delay=0.01:0.1:10')
        if option in options:
            raise ScenarioError(f"--vary names {option} twice; give all its values in one --vary")
        options[option] = values_of(values)
    store = None if out is None else out / CELLS
    with counting("Compiling the kernels", {"run": "Running every combination"}, quiet=as_json) as progress:
        found = sweep_scenario(scenario, options, store=store, jobs=jobs, dask=dask, progress=progress)
    if out is not None:
        write_netcdf(found, out / RESULTS, "result")
    rows = found.to_dataframe().reset_index().to_dict("records")
    if as_json:
        print_json({"runs": rows, "units": {name: unit for name, (unit, _) in SWEPT.items()}})
        return

    units = {name: unit for name, (unit, _) in SWEPT.items() if name != "finished"}
    # A narrow column has a word of its name in a row.
    headings = ("\n".join([*name.removeprefix("law_").split("_"), unit]) for name, unit in units.items())
    listed = new_table(*map(literal, options), *headings, text=len(options))
    for row in rows:
        cells = [_cell(row[option]) for option in options]
        if row["problem"]:
            listed.add_row(*cells, "–")
            continue
        numbers = [number(float(row[name]), digits=3) for name in units]
        active = row["made"] > row["law_initial_energy"] + 1e-9 or not row["finished"]
        listed.add_row(*cells, *numbers, style="red" if active else None)
    Console().print(listed)
    for problem in sorted({row["problem"] for row in rows} - {""}):
        sys.stdout.write(f"  – {printable(problem)}\n")
    if out is not None:
        sys.stdout.write(f"  wrote {printable(str(out / RESULTS))}\n")


def _cell(value: object) -> str:
    return number(value) if isinstance(value, float) else literal(value)
