"""The command line: options in, library call, table or JSON out."""

import sys
from pathlib import Path
from typing import Annotated

import typer

from cotouch.cli import _live_commands as live
from cotouch.cli._device_commands import devices
from cotouch.cli._interrupted import INTERRUPTED, say_interrupted
from cotouch.cli._options import AsJson, Dask
from cotouch.cli._standard import interrupts, warnings_as_sentences
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
        from cotouch.version import __version__

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
    scenario: Annotated[Path, typer.Argument(help="Scenario (TOML).", show_default=False)],
    out: Annotated[
        Path | None, typer.Option(help="Write the whole run to this NetCDF file.", show_default=False)
    ] = None,
    figures: Annotated[Path | None, typer.Option(help="Save figures to this folder.", show_default=False)] = None,
    animation: Annotated[
        Path | None,
        typer.Option(help="Write a 3D animation of the run to this HTML file.", show_default=False),
    ] = None,
    law: Annotated[
        str | None,
        typer.Option(
            help="Link law, overriding the scenario's: spring (the paper's), paid, wave ...", show_default=False
        ),
    ] = None,
    as_json: AsJson = False,
) -> None:
    """Simulate a scenario and summarise the run.

    All users are virtual, and so is the network between them.
    """
    from cotouch.cli._simulate import run

    if not run(scenario, out=out, figures=figures, animation=animation, law=law, as_json=as_json):
        raise typer.Exit(1)


@app.command()
def feel(
    scenario: Annotated[Path, typer.Argument(help="Scenario (TOML).", show_default=False)],
    user: Annotated[int, typer.Option(help="The user whose hand it is.", min=1)] = 1,
    others: Annotated[str, typer.Option(help="What the other hands do: free or holding.")] = "free",
    law: Annotated[str | None, typer.Option(help="Link law, overriding the scenario's.", show_default=False)] = None,
    figures: Annotated[Path | None, typer.Option(help="Save the Bode plot to this folder.", show_default=False)] = None,
    measure: Annotated[bool, typer.Option(help="Simulate as well as predict.")] = True,
    as_json: AsJson = False,
) -> None:
    """Report what a hand feels: drag, mass and stiffness.

    Also shows the impedance over frequency, predicted and measured.
    """
    from cotouch.cli._laboratory import feel as run

    run(scenario, user=user, others=others, law=law, figures=figures, measure=measure, as_json=as_json)


@app.command()
def sweep(
    scenario: Annotated[Path, typer.Argument(help="Scenario (TOML).", show_default=False)],
    vary: Annotated[
        list[str],
        typer.Option(
            help="OPTION=VALUES: link.delay=0.01:0.1:10, synchronisation.law=spring,wave; repeatable.",
            show_default=False,
        ),
    ],
    out: Annotated[
        Path | None, typer.Option(help="Folder for results; an interrupted sweep resumes.", show_default=False)
    ] = None,
    dask: Dask = None,
    jobs: Annotated[int, typer.Option(help="Parallel runs; -1: one per core.", min=-1)] = -1,
    as_json: AsJson = False,
) -> None:
    """Run a scenario for every combination of option values."""
    from cotouch.cli._laboratory import sweep as run

    run(scenario, vary=vary, out=out, dask=dask, jobs=jobs, as_json=as_json)


@app.command()
def compare(
    study: Annotated[Path, typer.Argument(help="Study (TOML): laws, networks, tasks, users.", show_default=False)],
    out: Annotated[
        Path, typer.Option(help="Folder for results and report; an interrupted study resumes.", show_default=False)
    ],
    dask: Dask = None,
    jobs: Annotated[int, typer.Option(help="Parallel cells; -1: one per core.", min=-1)] = -1,
    as_json: AsJson = False,
) -> None:
    """Compare link laws and write a report.

    All laws are tuned alike and judged on the same networks, tasks and numbers of users.
    """
    from cotouch.cli._compare import run

    run(study, out=out, dask=dask, jobs=jobs, as_json=as_json)


@app.command()
def certify(
    network: Annotated[Path, typer.Argument(help="Network or scenario (TOML).", show_default=False)],
    period: Annotated[float, typer.Option(help="Step length [s].", min=1e-9)] = 1e-3,
    damping: Annotated[
        str | None,
        typer.Option(
            help="Check this damping instead of designing it: B in Ns/m, one number or one per user.",
            show_default=False,
        ),
    ] = None,
    as_json: AsJson = False,
) -> None:
    """Compute the damping that keeps a network passive.

    There are several methods; the report says what each one guarantees.
    """
    from cotouch.cli._certify import run

    run(network, period=period, damping=damping, as_json=as_json)


@app.command()
def body(
    file: Annotated[
        Path,
        typer.Argument(
            help="Mesh: STL, OBJ, PLY, OFF, GLB, VTK, VTU, .msh or .mesh; or a scenario, .toml.", show_default=False
        ),
    ],
    unit: Annotated[
        str | None,
        typer.Option(
            help="Length unit of the file: m, mm, cm or in; only GLB files state their own.", show_default=False
        ),
    ] = None,
    resolution: Annotated[
        int | None,
        typer.Option(help="For surfaces: cells along the longest side (default 12).", show_default=False),
    ] = None,
    model: Annotated[
        str | None,
        typer.Option(
            help="springs (default for surfaces), elastic (default for tetrahedra), or a material such as neo-hookean.",
            show_default=False,
        ),
    ] = None,
    frame: Annotated[str | None, typer.Option(help="floating (default) or fixed.", show_default=False)] = None,
    young: Annotated[float, typer.Option(help="Young's modulus [Pa].")] = 1e4,
    poisson: Annotated[float, typer.Option(help="Poisson's ratio.")] = 0.3,
    stiffness: Annotated[
        float | None,
        typer.Option(help="Stiffness of each spring, instead of Young's modulus [N/m].", show_default=False),
    ] = None,
    density: Annotated[float | None, typer.Option(help="Density [kg/m³]; by default 1000.", show_default=False)] = None,
    mass: Annotated[
        float | None, typer.Option(help="Total mass, instead of a density [kg].", show_default=False)
    ] = None,
    rayleigh_mass: Annotated[float, typer.Option(help="α in the damping α M + β K [1/s].")] = 0.0,
    rayleigh_stiffness: Annotated[float, typer.Option(help="β in that damping [s].")] = 0.0,
    ground: Annotated[
        str,
        typer.Option(
            help="What is held in place: none, all, a face such as z-, set:NAME, plane:X,Y,Z/NX,NY,NZ[/THICKNESS] or "
            "box:X,Y,Z/X,Y,Z, in metres."
        ),
    ] = "none",
    ground_stiffness: Annotated[float, typer.Option(help="Stiffness of each held node [N/m].")] = 1e3,
    ground_damping: Annotated[float, typer.Option(help="Damping of each held node [Ns/m].")] = 0.0,
    part: Annotated[
        int | None, typer.Option(help="Which of several parts to use; the largest is 1.", show_default=False)
    ] = None,
    modes: Annotated[
        int | None,
        typer.Option(help="Also report how accurate this many modes would be at a contact.", show_default=False),
    ] = None,
    most: Annotated[
        int | None, typer.Option(help="Refuse files with more triangles or tetrahedra than this.", show_default=False)
    ] = None,
    most_nodes: Annotated[
        int | None, typer.Option(help="Refuse bodies with more nodes than this.", show_default=False)
    ] = None,
    figures: Annotated[Path | None, typer.Option(help="Save a figure to this folder.", show_default=False)] = None,
    as_json: AsJson = False,
) -> None:
    """Build a body from a mesh and describe it.

    The report covers repairs, size, mass, first modes and supports. Given a scenario, it lists the scenario's bodies.
    """
    from cotouch.cli._body import run

    run(
        file,
        figures=figures,
        as_json=as_json,
        unit=unit,
        resolution=resolution,
        model=model,
        frame=frame,
        young=young,
        poisson=poisson,
        stiffness=stiffness,
        density=density,
        mass=mass,
        rayleigh_mass=rayleigh_mass,
        rayleigh_stiffness=rayleigh_stiffness,
        ground=ground,
        ground_stiffness=ground_stiffness,
        ground_damping=ground_damping,
        part=part,
        modes=modes,
        most=most,
        most_nodes=most_nodes,
    )


@app.command()
def plan(
    network: Annotated[
        Path | None, typer.Argument(help="A network or scenario, TOML; not needed with --delays.", show_default=False)
    ] = None,
    links: Annotated[
        str, typer.Option(help='Number of links: 6, a range such as 4-8, or "at most 8".', show_default=False)
    ] = "",
    objective: Annotated[
        str | None,
        typer.Option(
            help="What to minimise: consensus, decay, damping, drag or feel; decay if delays are not whole time units.",
            show_default="consensus",
        ),
    ] = None,
    convention: Annotated[str, typer.Option(help="Form of the consensus model: equation or matrix.")] = "equation",
    time_unit: Annotated[float, typer.Option(help="Time unit of the consensus model [s].")] = 0.01,
    rounding: Annotated[str, typer.Option(help="Rounding of delays to time units: exact, nearest or up.")] = "exact",
    require: Annotated[
        list[str] | None,
        typer.Option(help="A required link, as 1-2 or Ann-Ben; repeatable.", show_default=False),
    ] = None,
    forbid: Annotated[
        list[str] | None,
        typer.Option(help="A forbidden link, as 1-3 or Ann-Ben; repeatable.", show_default=False),
    ] = None,
    max_degree: Annotated[
        int | None, typer.Option(help="Maximum number of links per user.", show_default=False)
    ] = None,
    damping_limit: Annotated[
        float | None, typer.Option(help="Maximum damping of any user [Ns/m].", show_default=False)
    ] = None,
    drag_limit: Annotated[
        float | None, typer.Option(help="Maximum total drag over all users [Ns/m].", show_default=False)
    ] = None,
    lost: Annotated[
        str, typer.Option(help="Judge each choice after its worst single loss of: nothing, link or user.")
    ] = "nothing",
    mass: Annotated[
        float | None, typer.Option(help="Mass of the object [kg]; default: the file's, else 1.", show_default=False)
    ] = None,
    damping: Annotated[
        float | None,
        typer.Option(help="Damping of the object [Ns/m]; default: the file's, else 0.", show_default=False),
    ] = None,
    stiffness: Annotated[
        float | None,
        typer.Option(help="Stiffness of the object [N/m]; default: the file's, else 0.", show_default=False),
    ] = None,
    top: Annotated[int, typer.Option(help="Number of best choices to show.")] = 5,
    method: Annotated[str, typer.Option(help="Method: auto, enumerate, bound or local.")] = "auto",
    seconds: Annotated[float | None, typer.Option("--time-limit", help="Time limit [s].", show_default=False)] = None,
    seed: Annotated[int, typer.Option(help="Seed of the local search's random starts.")] = 0,
    dask: Dask = None,
    delays: Annotated[
        list[Path] | None,
        typer.Option(
            help="CSV table of all users' round trips [ms]; repeat for further measurements.", show_default=False
        ),
    ] = None,
    pick: Annotated[
        str | None, typer.Option(help="Use only these users of the table: NAME,NAME,...", show_default=False)
    ] = None,
    spring: Annotated[float, typer.Option(help="Stiffness of every link, with --delays [N/m].")] = 50.0,
    quantile: Annotated[
        float, typer.Option(help="Which quantile of a pair's measured round trips to use; 1 is the longest.")
    ] = 1.0,
    tune_springs: Annotated[
        float | None,
        typer.Option(
            help="Also tune the springs, with no user's damping above this [Ns/m].",
            show_default=False,
        ),
    ] = None,
    figures: Annotated[Path | None, typer.Option(help="Save figures to this folder.", show_default=False)] = None,
    as_json: AsJson = False,
) -> None:
    """Find the best links, and say whether they are proved to be so."""
    from cotouch.cli._plan import run

    run(
        network,
        require=require or [],
        forbid=forbid or [],
        links=links,
        delays=delays or [],
        pick=pick,
        spring=spring,
        quantile=quantile,
        tune=tune_springs,
        figures=figures,
        as_json=as_json,
        objective=objective,
        convention=convention,
        time_unit=time_unit,
        rounding=rounding,
        max_degree=max_degree,
        damping_limit=damping_limit,
        drag_limit=drag_limit,
        lost=lost,
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
    """Reproduce the paper in one HTML report.

    The report covers topologies, Theorem 1, the bound and what happens below it, and much more.
    """
    from cotouch.cli._reproduce import run

    run(out, as_json=as_json)


for command in (live.replay, live.audit, live.export):
    app.command()(command)
app.add_typer(devices, name="devices")


def main() -> None:
    """Runs the command; what the user got wrong is one sentence and exit code 2."""
    try:
        with interrupts(), warnings_as_sentences():
            app(prog_name="cotouch")
    except CotouchError as error:
        sys.stderr.write(f"cotouch: {error}\n")
        sys.exit(2)
    except MemoryError:
        sys.stderr.write("cotouch: not enough memory; make the run shorter or the body coarser\n")
        sys.exit(2)
    except SystemExit as end:
        if end.code == INTERRUPTED:  # typer makes this of a KeyboardInterrupt, without a word
            say_interrupted()
        raise
