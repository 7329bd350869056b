"""The command line: options in, library call, table or JSON out."""

import sys
from pathlib import Path
from typing import Annotated

import typer

from cotouch.cli import _live_commands as live
from cotouch.cli._device_commands import devices
from cotouch.cli._options import AsJson
from cotouch.errors import CotouchError

app = typer.Typer(
    name="cotouch",
    help="Hold, push and deform one virtual object together over any packet network, stably, and feel each other.",
    no_args_is_help=True,
    pretty_exceptions_enable=False,
    add_completion=False,
    rich_markup_mode=None,  # plain help: loading rich for it costs half of the start-up time
    context_settings={"help_option_names": ["-h", "--help"]},
)


def _version(wanted: bool) -> None:
    if wanted:
        from cotouch import __version__

        typer.echo(f"cotouch {__version__}")
        raise typer.Exit


@app.callback()
def _main(
    version: Annotated[
        bool, typer.Option("--version", help="Print the version.", callback=_version, is_eager=True)
    ] = False,
) -> None:
    del version


@app.command()
def simulate(
    scenario: Annotated[Path, typer.Argument(help="A scenario, TOML.", show_default=False)],
    out: Annotated[
        Path | None, typer.Option(help="Write the whole run to this NetCDF file.", show_default=False)
    ] = None,
    figures: Annotated[Path | None, typer.Option(help="Draw figures into this folder.", show_default=False)] = None,
    animation: Annotated[
        Path | None,
        typer.Option(help="Write the run in three dimensions as this HTML page.", show_default=False),
    ] = None,
    as_json: AsJson = False,
) -> None:
    """Run a scenario of many virtual peers and say how it went."""
    from cotouch.cli._simulate import run

    run(scenario, out=out, figures=figures, animation=animation, as_json=as_json)


@app.command()
def certify(
    network: Annotated[Path, typer.Argument(help="A network or scenario, TOML.", show_default=False)],
    period: Annotated[float, typer.Option(help="Length of the steps [s].", min=1e-9)] = 1e-3,
    damping: Annotated[
        str | None,
        typer.Option(
            help="Check this instead of designing: B in Ns/m, one number or one per user.", show_default=False
        ),
    ] = None,
    as_json: AsJson = False,
) -> None:
    """Work out the damping that keeps a network passive, by each method, and say what each one covers."""
    from cotouch.cli._certify import run

    run(network, period=period, damping=damping, as_json=as_json)


@app.command()
def body(
    file: Annotated[
        Path, typer.Argument(help="A mesh: STL, OBJ, PLY, OFF, GLB, VTK, VTU, .msh or .mesh.", show_default=False)
    ],
    unit: Annotated[
        str | None, typer.Option(help="Of the file: m, mm, cm or in; only GLB says it itself.", show_default=False)
    ] = None,
    resolution: Annotated[
        int | None,
        typer.Option(help="Surfaces: cells along the longest side (default 12).", show_default=False),
    ] = None,
    model: Annotated[
        str | None,
        typer.Option(help="springs (default of surfaces) or elastic (default of tetrahedra).", show_default=False),
    ] = None,
    young: Annotated[float, typer.Option(help="Young's modulus [Pa].")] = 1e4,
    poisson: Annotated[float, typer.Option(help="Poisson's ratio.")] = 0.3,
    density: Annotated[float, typer.Option(help="[kg/m³].")] = 1000.0,
    ground: Annotated[
        str,
        typer.Option(
            help="What is held: none, all, a face such as z-, set:NAME, plane:X,Y,Z/NX,NY,NZ[/THICKNESS] or "
            "box:X,Y,Z/X,Y,Z, in metres."
        ),
    ] = "none",
    ground_stiffness: Annotated[float, typer.Option(help="Of each held node [N/m].")] = 1e3,
    part: Annotated[
        int | None, typer.Option(help="Which of several parts; the biggest is 1.", show_default=False)
    ] = None,
    modes: Annotated[
        int | None,
        typer.Option(help="Also say how good so many modes would be at a contact.", show_default=False),
    ] = None,
    most: Annotated[
        int | None, typer.Option(help="Refuse files with more triangles or tetrahedra.", show_default=False)
    ] = None,
    figures: Annotated[Path | None, typer.Option(help="Draw a figure into this folder.", show_default=False)] = None,
    as_json: AsJson = False,
) -> None:
    """Make a body of a mesh and say what was understood: repairs, size, mass, first modes, what holds it."""
    from cotouch.cli._body import run

    run(
        file,
        figures=figures,
        as_json=as_json,
        unit=unit,
        resolution=resolution,
        model=model,
        young=young,
        poisson=poisson,
        density=density,
        ground=ground,
        ground_stiffness=ground_stiffness,
        part=part,
        modes=modes,
        most=most,
    )


@app.command()
def plan(
    network: Annotated[Path, typer.Argument(help="A network or scenario, TOML.", show_default=False)],
    links: Annotated[int, typer.Option(help="How many links.", show_default=False)],
    objective: Annotated[str, typer.Option(help="What is to be small: consensus, decay or damping.")] = "consensus",
    convention: Annotated[str, typer.Option(help="Of the consensus: equation or matrix.")] = "equation",
    time_unit: Annotated[float, typer.Option(help="Of the consensus [s].")] = 0.01,
    rounding: Annotated[str, typer.Option(help="Of delays to time units: exact, nearest or up.")] = "exact",
    must: Annotated[
        list[str] | None, typer.Option(help="Links that must be, as 1-2; again for more.", show_default=False)
    ] = None,
    never: Annotated[
        list[str] | None, typer.Option(help="Links that may not be, as 1-3; again for more.", show_default=False)
    ] = None,
    max_degree: Annotated[int | None, typer.Option(help="Most links of one user.", show_default=False)] = None,
    mass: Annotated[
        float | None, typer.Option(help="Of the object [kg], instead of the file's; else 1.", show_default=False)
    ] = None,
    damping: Annotated[
        float | None, typer.Option(help="Of the object [Ns/m], instead of the file's; else 0.", show_default=False)
    ] = None,
    stiffness: Annotated[
        float | None, typer.Option(help="Of the object [N/m], instead of the file's; else 0.", show_default=False)
    ] = None,
    top: Annotated[int, typer.Option(help="How many of the best to show.")] = 5,
    method: Annotated[str, typer.Option(help="auto, enumerate, bound or local.")] = "auto",
    seconds: Annotated[float | None, typer.Option(help="Time budget [s].", show_default=False)] = None,
    seed: Annotated[int, typer.Option(help="Of the random starts of the local search.")] = 0,
    dask: Annotated[
        str | None, typer.Option(help="Share the work with this Dask scheduler, tcp://host:port.", show_default=False)
    ] = None,
    tune_springs: Annotated[
        float | None,
        typer.Option(
            help="Then tune the springs of the best choice, with no user's damping above this [Ns/m].",
            show_default=False,
        ),
    ] = None,
    figures: Annotated[Path | None, typer.Option(help="Draw figures into this folder.", show_default=False)] = None,
    as_json: AsJson = False,
) -> None:
    """Find the links that serve an objective best, and say how sure that is."""
    from cotouch.cli._plan import run

    run(
        network,
        must=must or [],
        never=never or [],
        tune=tune_springs,
        figures=figures,
        as_json=as_json,
        links=links,
        objective=objective,
        convention=convention,
        time_unit=time_unit,
        rounding=rounding,
        max_degree=max_degree,
        mass=mass,
        damping=damping,
        stiffness=stiffness,
        top=top,
        method=method,
        seconds=seconds,
        seed=seed,
        dask=dask,
    )


for command in (live.host, live.join, live.measure, live.demo):
    app.command()(command)


@app.command()
def reproduce(
    out: Annotated[Path, typer.Option(help="Folder for the report.")] = Path("out"),
    as_json: AsJson = False,
) -> None:
    """Repeat the paper: topologies, Theorem 1, the bound, the modes, as one HTML report."""
    from cotouch.cli._reproduce import run

    run(out, as_json=as_json)


for command in (live.replay, live.audit, live.export):
    app.command()(command)
app.add_typer(devices, name="devices")


def main() -> None:
    """Runs the command; what the user got wrong is one sentence and exit code 2."""
    try:
        app()
    except CotouchError as error:
        sys.stderr.write(f"cotouch: {error}\n")
        sys.exit(2)
    except KeyboardInterrupt:
        sys.stderr.write("cotouch: interrupted\n")
        sys.exit(130)
