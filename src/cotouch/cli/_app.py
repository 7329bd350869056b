"""The command line: options in, library call, table or JSON out."""

import sys
from pathlib import Path
from typing import Annotated

import typer

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

AsJson = Annotated[
    bool, typer.Option("--json", help="Print one JSON object on standard output and nothing else there.")
]

PagePort = Annotated[
    int | None, typer.Option(help="Of the page; by default 8765, or the next that is free.", show_default=False)
]
PageListen = Annotated[
    str, typer.Option(help="Address of this machine for the page; other than loopback, others can reach it.")
]
_DEMO = 30.0  # [s]


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


@app.command()
def host(
    session: Annotated[Path, typer.Argument(help="A session, TOML.", show_default=False)],
    listen: Annotated[
        str, typer.Option(help="Address of this machine, in numbers, by which the others reach it.")
    ] = "127.0.0.1",
    port: Annotated[
        int | None, typer.Option(help="Of TCP and UDP; by default one that is free.", show_default=False)
    ] = None,
    seconds: Annotated[
        float | None, typer.Option(help="How long; by default until Ctrl-C.", show_default=False)
    ] = None,
    keep: Annotated[
        Path | None,
        typer.Option(help="Keep the session's keys here, to go on with the same invitation.", show_default=False),
    ] = None,
    headless: Annotated[bool, typer.Option("--headless", help="Show no table.")] = False,
    as_json: AsJson = False,
) -> None:
    """Open a session, print the invitation to it, and keep it open."""
    from cotouch.cli._session import host as run

    run(session, listen=listen, port=port, seconds=seconds, keep=keep, headless=headless, as_json=as_json)


@app.command()
def join(
    invitation: Annotated[
        str,
        typer.Argument(help="The line that the host printed, or - to read it from standard input.", show_default=False),
    ],
    name: Annotated[
        str | None, typer.Option(help="That the others see; by default yours on this machine.", show_default=False)
    ] = None,
    device: Annotated[
        str,
        typer.Option(
            help="What moves the copy: scripted (what the session's file says for the seat), none, or a device, such "
            "as simulated:touch; two hands: 'haply:id=1 + haply:id=2'. cotouch devices list shows them all."
        ),
    ] = "scripted",
    seconds: Annotated[
        float | None, typer.Option(help="How long; by default until the end.", show_default=False)
    ] = None,
    listen: Annotated[
        str | None,
        typer.Option(
            help="Address of this machine, in numbers; by default the one that leads to the host.", show_default=False
        ),
    ] = None,
    record: Annotated[Path | None, typer.Option(help="Record into this MCAP file.", show_default=False)] = None,
    headless: Annotated[bool, typer.Option("--headless", help="Show no table.")] = False,
    boards: Annotated[Path | None, typer.Option(hidden=True)] = None,
    unsafe: Annotated[bool, typer.Option("--unsafe", hidden=True)] = False,
    page: Annotated[bool, typer.Option("--page", help="Serve a page for a browser, to see and to take hold.")] = False,
    port: PagePort = None,
    page_listen: PageListen = "127.0.0.1",
    as_json: AsJson = False,
) -> None:
    """Take part in a session."""
    from cotouch.cli._session import join as run

    run(
        invitation,
        name=name,
        hand=device,
        seconds=seconds,
        listen=listen,
        record=record,
        headless=headless,
        boards=boards,
        unsafe=unsafe,
        page=page,
        port=port,
        page_listen=page_listen,
        as_json=as_json,
    )


@app.command()
def measure(
    invitation: Annotated[
        str,
        typer.Argument(help="The line that the host printed, or - to read it from standard input.", show_default=False),
    ],
    seconds: Annotated[float, typer.Option(help="How long to watch.", min=0.5)] = 10.0,
    out: Annotated[
        Path | None, typer.Option(help="Write the network to this TOML file, for cotouch plan.", show_default=False)
    ] = None,
    listen: Annotated[
        str | None,
        typer.Option(
            help="Address of this machine, in numbers; by default the one that leads to the host.", show_default=False
        ),
    ] = None,
    as_json: AsJson = False,
) -> None:
    """Measure how far those who take part in a session are from each other, without taking part."""
    from cotouch.cli._measure import run

    run(invitation, seconds=seconds, listen=listen, out=out, as_json=as_json)


@app.command()
def demo(
    users: Annotated[int, typer.Option(help="How many; the paper has five.")] = 5,
    body: Annotated[
        str | None,
        typer.Option(
            help="point (the paper's), block (in three dimensions) or soft (a cushion); by default soft with a page.",
            show_default=False,
        ),
    ] = None,
    seconds: Annotated[
        float | None,
        typer.Option(
            help="How long, once all are there; by default 30 s, and at a terminal with a page until interrupted.",
            min=1.0,
            show_default=False,
        ),
    ] = None,
    impair: Annotated[
        list[str] | None,
        typer.Option(
            help="What the network does besides: loss=0.1, jitter=0.02 (s), duplication=, reordering=; again for more.",
            show_default=False,
        ),
    ] = None,
    record: Annotated[Path | None, typer.Option(help="Record every user into this folder.", show_default=False)] = None,
    page: Annotated[
        bool | None,
        typer.Option(
            "--page/--no-page",
            help="Serve a page for a browser; by default unless --headless or --json is given.",
            show_default=False,
        ),
    ] = None,
    port: PagePort = None,
    page_listen: PageListen = "127.0.0.1",
    headless: Annotated[bool, typer.Option("--headless", help="Show no table.")] = False,
    as_json: AsJson = False,
) -> None:
    """Play a session on this machine: the paper's five users, its links and delays, a process for each."""
    from cotouch.cli._demo import run
    from cotouch.cli._page import page as paged
    from cotouch.cli._page import watched

    wanted = not (headless or as_json) if page is None else page
    with paged(wanted=wanted, port=port, listen=page_listen) as beside:
        run(
            users=users,
            body=body,
            seconds=_DEMO if seconds is None and not (wanted and watched()) else seconds,
            impair=impair or [],
            record=record,
            headless=headless,
            as_json=as_json,
            beside=beside,
        )


@app.command()
def reproduce(
    out: Annotated[Path, typer.Option(help="Folder for the report.")] = Path("out"),
    as_json: AsJson = False,
) -> None:
    """Repeat the paper: topologies, Theorem 1, the bound, the modes, as one HTML report."""
    from cotouch.cli._reproduce import run

    run(out, as_json=as_json)


@app.command()
def replay(
    file: Annotated[Path, typer.Argument(help="A recording, MCAP.", show_default=False)],
    speed: Annotated[float, typer.Option(help="Seconds of the recording in a second.")] = 1.0,
    start: Annotated[float, typer.Option("--from", help="Where to begin [s].")] = 0.0,
    stop: Annotated[float | None, typer.Option("--to", help="Where to end [s].", show_default=False)] = None,
    as_json: AsJson = False,
) -> None:
    """Play one user's recording: rate, force, books and links as they were; with --json only sum it up."""
    from cotouch.cli._replay import run

    run(file, speed=speed, start=start, stop=stop, as_json=as_json)


@app.command()
def audit(
    files: Annotated[list[Path], typer.Argument(help="Recordings of one session, MCAP.", show_default=False)],
    tolerance: Annotated[
        float | None,
        typer.Option(help="Share of the energy in play that may be rounding (1e-9).", show_default=False, min=0.0),
    ] = None,
    figures: Annotated[Path | None, typer.Option(help="Draw a figure into this folder.", show_default=False)] = None,
    as_json: AsJson = False,
) -> None:
    """Work the energy of a session out anew from its recordings; exit code 1 if it does not add up."""
    from cotouch.cli._audit import run

    if not run(files, figures=figures, tolerance=tolerance, as_json=as_json):
        raise typer.Exit(1)


@app.command()
def export(
    files: Annotated[list[Path], typer.Argument(help="Recordings of one session, MCAP.", show_default=False)],
    out: Annotated[Path, typer.Option(help="The NetCDF file to write.", show_default=False)],
    as_json: AsJson = False,
) -> None:
    """Write the recordings of a session into one NetCDF file, with the names of a simulated run."""
    from cotouch.cli._export import run

    run(files, out=out, as_json=as_json)


devices = typer.Typer(
    no_args_is_help=True,
    help="Haptic devices: which there are, whether they do what they must, what they measure.",
)
app.add_typer(devices, name="devices")
DeviceName = Annotated[
    str, typer.Argument(help="name, name:variant or name:variant,option=value,...", show_default=False)
]
AllowMotion = Annotated[bool, typer.Option("--allow-motion", help="The device may move by itself to calibrate.")]


@devices.command("list")
def devices_list(as_json: AsJson = False) -> None:
    """List the drivers that are installed, and what seems to be connected."""
    from cotouch.cli._devices import show

    show(as_json=as_json)


@devices.command("check")
def devices_check(
    device: DeviceName,
    allow_motion: AllowMotion = False,
    force: Annotated[bool, typer.Option(help="Switch the motors on, for 0.05 N.")] = True,
    as_json: AsJson = False,
) -> None:
    """Check that a device does what every device must; exit code 1 if it does not."""
    from cotouch.cli._devices import check

    if not check(device, allow_motion=allow_motion, force=force, as_json=as_json):
        raise typer.Exit(1)


@devices.command("calibrate")
def devices_calibrate(device: DeviceName, allow_motion: AllowMotion = False, as_json: AsJson = False) -> None:
    """Make a device's places absolute."""
    from cotouch.cli._devices import calibrate

    calibrate(device, allow_motion=allow_motion, as_json=as_json)


@devices.command("monitor")
def devices_monitor(
    device: DeviceName,
    seconds: Annotated[
        float | None, typer.Option(help="How long; by default until Ctrl-C.", show_default=False)
    ] = None,
    as_json: AsJson = False,
) -> None:
    """Show what a device measures, with its motors off."""
    from cotouch.cli._devices import monitor

    monitor(device, seconds=seconds, as_json=as_json)


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
