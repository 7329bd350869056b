"""`cotouch host` and `cotouch join`."""

import os
import signal
import sys
import time
from collections.abc import Callable, Generator
from contextlib import AbstractContextManager, ExitStack, contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

from cotouch.cli._output import print_json, writable
from cotouch.cli._page import page as paged
from cotouch.errors import SessionError

if TYPE_CHECKING:
    from cotouch.live import Invitation
    from cotouch.session import MemberStage, Part, Taken, Watch

_POLL = 0.02
_REDRAW = 4.0  # times a second


def host(
    file: Path,
    *,
    listen: str,
    port: int | None,
    seconds: float | None,
    keep: Path | None,
    headless: bool,
    as_json: bool,
) -> None:
    """Opens a session and keeps it open."""
    from cotouch.session import SessionFile, open_host

    session = SessionFile.read(file)
    with interruptible() as stopped, open_host(session, listen=listen, port=port, keep=keep) as opened:
        line = opened.invitation.encode()
        if as_json:
            print_json({"invitation": line, "session": session.digest.hex()})
            sys.stdout.flush()
        else:
            sys.stdout.write(f"{line}\n")
            sys.stdout.flush()
            sys.stderr.write("join with: cotouch join INVITATION (the line above; whoever has it can take part)\n")
        title = session.scenario.title or file.stem
        with shown(lambda: opened.host.watch, title=title, invitation=line, quiet=headless or as_json) as redraw:
            end = None if seconds is None else time.monotonic() + seconds
            while not stopped() and (end is None or time.monotonic() < end):
                opened.service(time.monotonic())
                redraw()
                time.sleep(_POLL)
        opened.host.end()


def join(
    invitation: str,
    *,
    name: str | None,
    hand: str,
    seconds: float | None,
    listen: str | None,
    record: Path | None,
    headless: bool,
    as_json: bool,
    boards: Path | None = None,
    unsafe: bool = False,
    page: bool = False,
    port: int | None = None,
    page_listen: str = "127.0.0.1",
) -> None:
    """Takes part in a session."""
    from cotouch import __version__
    from cotouch.live import Invitation
    from cotouch.session import Part
    from cotouch.session import join as take_part

    device = hand if hand not in {"scripted", "none"} else None
    if device is not None:
        _known_device(device)
    if record is not None:
        writable(record)
    decoded = Invitation.decode(sys.stdin.readline() if invitation == "-" else invitation)
    part = Part(
        name=name or _own_name(),
        version=__version__,
        hand="none" if hand == "none" else "scripted",
        device=device,
        seconds=seconds,
        listen=listen,
        record=record,
        boards=boards,
        unsafe=unsafe,
    )
    if page:
        if as_json:
            raise SessionError("--page and --json are given; with a page a process of its own takes part, so drop one")
        with paged(wanted=True, port=port, listen=page_listen) as beside:
            assert beside is not None
            staged(decoded, beside, part, quiet=headless)
        return
    if not (headless or as_json) and sys.stdout.isatty():
        _with_table(decoded, part)
        return
    parent = os.getppid()
    with interruptible() as stopped:
        taken = take_part(
            decoded,
            part,
            warn=_warn,
            say=lambda text: None if as_json else _say(text),
            # Whoever shows it and tells it what to do has gone.
            stopped=lambda: stopped() or (part.boards is not None and os.getppid() != parent),
        )
    if as_json:
        print_json(numbers(taken))
    else:
        sys.stdout.write(sentence(taken) + "\n")


def numbers(taken: "Taken") -> dict[str, Any]:
    """How taking part went, for JSON; the user is numbered from 1, seats in the status from 0."""
    status = taken.status
    return {
        "name": taken.name,
        "user": None if taken.seat is None else taken.seat + 1,
        "ended": taken.why,
        "status": None if status is None else status.model_dump(),
        "pace": dict(taken.pace),
        "recorded_steps": taken.recorded,
        "device": None if taken.device is None else dict(taken.device),
    }


def sentence(taken: "Taken") -> str:
    """How taking part went, for people."""
    status = taken.status
    if status is None or not status.steps:
        return f"{taken.name} did not come to take part"
    return (
        f"{taken.name} took {status.steps} steps in {status.time:.1f} s, {status.missed} of them late; the books "
        f"balance to {status.residual:.1e} of the energy in play"
        + ("" if taken.recorded is None else f"; {taken.recorded} steps are recorded")
    )


@contextmanager
def interruptible() -> Generator[Callable[[], bool]]:
    """Lets SIGINT and SIGTERM end a loop in order; a second one interrupts at once."""
    asked: list[int] = []

    def ask(number: int, frame: object) -> None:
        del frame
        if asked:
            raise KeyboardInterrupt
        asked.append(number)

    before = {number: signal.signal(number, ask) for number in (signal.SIGINT, signal.SIGTERM)}
    try:
        yield lambda: bool(asked)
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)


@contextmanager
def shown(
    watch: "Callable[[], Watch]", *, title: str, invitation: str | None = None, quiet: bool
) -> Generator[Callable[[], None]]:
    """A live table on standard error; gives a function to be called often, which draws now and then."""
    if quiet or not sys.stderr.isatty():
        yield lambda: None
        return
    from rich.console import Console
    from rich.live import Live

    from cotouch.cli._table import view

    started, drawn = time.monotonic(), [-float("inf")]
    with Live(console=Console(stderr=True), auto_refresh=False, transient=False) as live:

        def redraw() -> None:
            now = time.monotonic()
            if now - drawn[0] >= 1.0 / _REDRAW:
                drawn[0] = now
                live.update(view(watch(), now, title=title, started=started, invitation=invitation), refresh=True)

        yield redraw


def _with_table(invitation: "Invitation", part: "Part") -> None:
    """Takes part in a process of its own, so that drawing never makes a step late, and shows the session here."""
    from cotouch.session import MemberProcess, watching

    options = ["--name", part.name, "--headless", *_options(part)]
    options += [] if part.listen is None else ["--listen", part.listen]
    with interruptible() as stopped, watching(invitation, listen=part.listen) as watch:
        child = MemberProcess(invitation, options)
        try:
            with shown(lambda: watch, title=invitation.session, quiet=False) as redraw:
                while child.running and not stopped():
                    watch.service(time.monotonic())
                    redraw()
                    time.sleep(_POLL)
        finally:
            code = child.stop()
    if code:
        sys.exit(code)


def staged(
    invitation: "Invitation",
    beside: "Callable[[MemberStage], AbstractContextManager[object]]",
    part: "Part",
    *,
    quiet: bool,
) -> None:
    """Takes part in a process of its own, with a stage here.

    Args:
        invitation: to the session.
        beside: entered with the stage once the own copy moves, and left before it closes; a page's server, say.
        part: how.
        quiet: whether to show no table.
    """
    from cotouch.session import member_stage

    with (
        interruptible() as stopped,
        member_stage(invitation, name=part.name, listen=part.listen, options=_options(part)) as stage,
        shown(lambda: stage.watch, title=invitation.session, quiet=quiet) as redraw,
        ExitStack() as serving,
    ):
        served = False
        while not stage.over and not stopped():
            stage.tick(time.monotonic())
            if not served and stage.seat is not None:
                served = True
                serving.enter_context(beside(stage))
            redraw()
            time.sleep(_POLL)
        serving.close()
        code = stage.close()
    if code:
        sys.exit(code)


def _options(part: "Part") -> list[str]:
    """Of the process that takes part."""
    options = ["--device", part.device or part.hand]
    for flag, value in (("--seconds", part.seconds), ("--record", part.record)):
        options += [] if value is None else [flag, str(value)]
    return options


def _own_name() -> str:
    try:
        return os.getlogin()[:32] or "guest"
    except OSError:
        return "guest"


def _known_device(text: str) -> None:
    """Refuses a device that there is not, before anything is opened.

    Raises:
        SessionError: it is none; the sentence names all that there are.
    """
    from cotouch.haptics import device_names
    from cotouch.session import device_choices

    names = [choice.name for choice in device_choices(text) if "/" not in choice.name]
    if not set(names) <= set(device_names()):
        known = ", ".join(["scripted (what the session's file says)", "none", *device_names()])
        raise SessionError(f'--device is "{text}"; it must be one of {known}')


def _warn(text: str) -> None:
    sys.stderr.write(f"cotouch: {text}\n")
    sys.stderr.flush()


def _say(text: str) -> None:
    if sys.stderr.isatty():
        sys.stderr.write(f"cotouch: {text} ...\n")
