"""The commands of live sessions and their recordings."""

from pathlib import Path
from typing import Annotated

import typer

from cotouch.cli._options import AsJson, PageListen, PagePort

Invited = Annotated[
    str,
    typer.Argument(help="The line that the host printed, or - to read it from standard input.", show_default=False),
]
OwnAddress = Annotated[
    str | None,
    typer.Option(help="Numeric address of this machine; default: the one that reaches the host.", show_default=False),
]
_DEMO = 30.0  # [s]


def host(
    session: Annotated[Path, typer.Argument(help="Session (TOML).", show_default=False)],
    listen: Annotated[str, typer.Option(help="Numeric address at which others can reach this machine.")] = "127.0.0.1",
    port: Annotated[int | None, typer.Option(help="TCP and UDP port; default: a free one.", show_default=False)] = None,
    seconds: Annotated[
        float | None,
        typer.Option("--duration", help="Duration [s]; default: until Ctrl-C.", min=0.0, show_default=False),
    ] = None,
    key_file: Annotated[
        Path | None,
        typer.Option(
            help="File for the session's keys, so that a restarted host keeps its invitation.", show_default=False
        ),
    ] = None,
    law: Annotated[
        str | None,
        typer.Option(
            help="Link law, overriding the session's: spring (the paper's), paid, wave, tank, tdpa, pspm, or an "
            "installed one.",
            show_default=False,
        ),
    ] = None,
    headless: Annotated[bool, typer.Option("--headless", help="Show no live table.")] = False,
    as_json: AsJson = False,
) -> None:
    """Host a session: print an invitation and keep the session open."""
    from cotouch.cli._session import host as run

    run(
        session,
        listen=listen,
        port=port,
        seconds=seconds,
        key_file=key_file,
        law=law,
        headless=headless,
        as_json=as_json,
    )


def join(
    invitation: Invited,
    name: Annotated[
        str | None, typer.Option(help="Name shown to the others; default: your user name.", show_default=False)
    ] = None,
    device: Annotated[
        str,
        typer.Option(
            help="What moves your copy: scripted (as the session file says), none, or a device such as "
            "simulated:touch; for two hands: 'haply:id=1 + haply:id=2'. See cotouch devices list."
        ),
    ] = "scripted",
    seconds: Annotated[
        float | None,
        typer.Option("--duration", help="Duration [s]; default: until the session ends.", min=0.0, show_default=False),
    ] = None,
    listen: OwnAddress = None,
    record: Annotated[Path | None, typer.Option(help="Record to this MCAP file.", show_default=False)] = None,
    headless: Annotated[bool, typer.Option("--headless", help="Show no table.")] = False,
    mailboxes: Annotated[Path | None, typer.Option(hidden=True)] = None,
    unsafe: Annotated[bool, typer.Option("--unsafe", hidden=True)] = False,
    ordinary: Annotated[bool, typer.Option("--ordinary", hidden=True)] = False,
    page: Annotated[bool, typer.Option("--page", help="Serve a browser page to see and hold the object.")] = False,
    port: PagePort = None,
    page_listen: PageListen = "127.0.0.1",
    as_json: AsJson = False,
) -> None:
    """Join a session."""
    from cotouch.cli._session import join as run

    run(
        invitation,
        name=name,
        hand=device,
        seconds=seconds,
        listen=listen,
        record=record,
        headless=headless,
        mailboxes=mailboxes,
        unsafe=unsafe,
        real_time=not ordinary,
        page=page,
        port=port,
        page_listen=page_listen,
        as_json=as_json,
    )


def measure(
    invitation: Invited,
    seconds: Annotated[float, typer.Option("--duration", help="Duration [s].", min=0.5)] = 10.0,
    out: Annotated[
        Path | None, typer.Option(help="Write the network to this TOML file for cotouch plan.", show_default=False)
    ] = None,
    listen: OwnAddress = None,
    as_json: AsJson = False,
) -> None:
    """Measure the delays between the members of a session.

    Measuring does not take a slot.
    """
    from cotouch.cli._measure import run

    run(invitation, seconds=seconds, listen=listen, out=out, as_json=as_json)


def demo(
    file: Annotated[
        Path | None,
        typer.Argument(
            help="Session (TOML) to play instead; it must define its users' hands or tools.", show_default=False
        ),
    ] = None,
    users: Annotated[
        int | None, typer.Option(help="Number of users; default: the paper's five.", show_default=False)
    ] = None,
    body: Annotated[
        str | None,
        typer.Option(
            help="point (the paper's), block (3D) or soft (a cushion); default: soft with a page, else point.",
            show_default=False,
        ),
    ] = None,
    seconds: Annotated[
        float | None,
        typer.Option(
            "--duration",
            help="Duration [s] once all have joined; default: 30, or until Ctrl-C with a page in a terminal.",
            min=1.0,
            show_default=False,
        ),
    ] = None,
    impair: Annotated[
        list[str] | None,
        typer.Option(
            help="Impairment of the network: loss=0.1, jitter=0.02 (s), duplication=, reordering=; repeatable.",
            show_default=False,
        ),
    ] = None,
    law: Annotated[
        str | None,
        typer.Option(
            help="Link law: spring (the paper's, with its damping), paid, wave, tank, tdpa, pspm, or an installed one; "
            "default: paid, with links between all users.",
            show_default=False,
        ),
    ] = None,
    record: Annotated[Path | None, typer.Option(help="Record every user to this folder.", show_default=False)] = None,
    page: Annotated[
        bool | None,
        typer.Option(
            "--page/--no-page",
            help="Serve a browser page; default: yes, unless --headless or --json is given.",
            show_default=False,
        ),
    ] = None,
    port: PagePort = None,
    page_listen: PageListen = "127.0.0.1",
    headless: Annotated[bool, typer.Option("--headless", help="Show no table.")] = False,
    as_json: AsJson = False,
) -> None:
    """Run a session on this machine, with a process for each user.

    By default these are the paper's five users, with the paper's delays.
    """
    from cotouch.cli._page import page as paged
    from cotouch.cli._page import watched
    from cotouch.cli._progress import ProgressLine

    wanted = not (headless or as_json) if page is None else page
    with ProgressLine(quiet=headless or as_json) as progress:
        progress.say("starting")  # before what the page and the session need is loaded, which takes seconds
        from cotouch.cli._demo import run

        with paged(wanted=wanted, port=port, listen=page_listen, tell=progress.tell) as beside:
            run(
                file=file,
                users=users,
                body=body,
                seconds=_DEMO if seconds is None and not (wanted and watched()) else seconds,
                impair=impair or [],
                law=law,
                record=record,
                headless=headless,
                as_json=as_json,
                progress=progress,
                beside=beside,
            )


def replay(
    file: Annotated[Path, typer.Argument(help="Recording (MCAP).", show_default=False)],
    speed: Annotated[float, typer.Option(help="Playback speed.")] = 1.0,
    start: Annotated[float, typer.Option("--from", help="Start time [s].")] = 0.0,
    stop: Annotated[float | None, typer.Option("--to", help="End time [s].", show_default=False)] = None,
    as_json: AsJson = False,
) -> None:
    """Replay one user's recording.

    Shows rate, force, ledger and links as they were; with --json, prints only a summary.
    """
    from cotouch.cli._replay import run

    run(file, speed=speed, start=start, stop=stop, as_json=as_json)


def audit(
    files: Annotated[list[Path], typer.Argument(help="Recordings of one session (MCAP).", show_default=False)],
    tolerance: Annotated[
        float | None,
        typer.Option(
            help="Error to allow for rounding, as a fraction of the energy in play (default 1e-9).",
            show_default=False,
            min=0.0,
        ),
    ] = None,
    figures: Annotated[Path | None, typer.Option(help="Save a figure to this folder.", show_default=False)] = None,
    as_json: AsJson = False,
) -> None:
    """Check that the energy of a recorded session adds up.

    Recomputes everyone's energy balance from the recordings. The exit code is 1 if it does not close.
    """
    from cotouch.cli._audit import run

    if not run(files, figures=figures, tolerance=tolerance, as_json=as_json):
        raise typer.Exit(1)


def export(
    files: Annotated[list[Path], typer.Argument(help="Recordings of one session (MCAP).", show_default=False)],
    out: Annotated[Path, typer.Option(help="The NetCDF file to write.", show_default=False)],
    as_json: AsJson = False,
) -> None:
    """Write a session's recordings to one NetCDF file.

    Variables have the same names as in a simulated run.
    """
    from cotouch.cli._export import run

    run(files, out=out, as_json=as_json)
