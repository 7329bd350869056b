"""`cotouch host` and `cotouch join`."""

import os
import signal
import sys
import time
from collections.abc import Callable, Generator
from contextlib import AbstractContextManager, ExitStack, contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from cotouch.cli._console import Console
from cotouch.cli._output import print_json, say
from cotouch.cli._page import page as paged
from cotouch.errors import SessionError
from cotouch.files import check_writable

if TYPE_CHECKING:
    from sys import UnraisableHookArgs

    from cotouch.control import Invitation
    from cotouch.members import Participation, ParticipationOutcome, SessionWatch
    from cotouch.session import MemberSessionApi

_POLL = 0.02
_REDRAW = 4.0  # times a second


def host(
    file: Path,
    *,
    listen: str,
    port: int | None,
    seconds: float | None,
    key_file: Path | None,
    law: str | None,
    headless: bool,
    as_json: bool,
) -> None:
    """Opens a session and keeps it open.

    Args:
        file: of the session.
        listen: address to listen at.
        port: to listen at; None: the next that is free.
        seconds: ends after so long [s]; None: does not.
        key_file: file that keeps the host's keys and roster; None: none.
        law: of the links, instead of the file's; None: the file's.
        headless: whether to show no table.
        as_json: whether to print one JSON object and nothing else on standard output.
    """

    def tell(text: str) -> None:
        if not as_json:
            say(text)

    if sys.stderr.isatty():
        tell("opening the session ...")  # before what takes seconds to load
    from cotouch.members import SessionFile
    from cotouch.session import open_host

    session = SessionFile.read(file, law=law)
    with stop_signals() as stopped, open_host(session, listen=listen, port=port, key_file=key_file) as opened:
        while (
            opened.host.coordinator.admission.fingerprint is None and not stopped()
        ):  # nobody is invited to a body that is wrong
            opened.service(time.monotonic())
            time.sleep(_POLL)
        line = opened.invitation.encode()
        if as_json:
            print_json({"invitation": line, "session": session.digest.hex(), "law": session.law})
            sys.stdout.flush()
        else:
            sys.stdout.write(f"{line}\n")
            sys.stdout.flush()
            sys.stderr.write("to join, run cotouch join - and paste the line above; anyone who has it can take part\n")
            sys.stderr.flush()
        title = session.scenario.title or file.stem
        with shown(lambda: opened.host.watch, title=title, invitation=line, quiet=headless or as_json) as redraw:
            end = None if seconds is None else time.monotonic() + seconds
            console = Console(opened.host)
            tell(f"ready, link law {session.law}; nobody has joined yet")
            while not stopped() and (end is None or time.monotonic() < end):
                opened.service(time.monotonic())
                console.service(time.monotonic())
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
    mailboxes: Path | None = None,
    unsafe: bool = False,
    real_time: bool = True,
    page: bool = False,
    port: int | None = None,
    page_listen: str = "127.0.0.1",
) -> None:
    """Takes part in a session.

    Args:
        invitation: as the host printed it.
        name: of the user; None: the first that is free.
        hand: what it does.
        seconds: ends after so long [s]; None: does not.
        listen: address to listen at; None: one that fits the invitation.
        record: file to record into; None: none.
        headless: whether to show no table.
        as_json: whether to print one JSON object and nothing else on standard output.
        mailboxes: folder of shared memory; None: none.
        unsafe: whether damping may be lowered.
        real_time: whether to ask for real-time priority.
        page: whether to serve a page.
        port: to listen at; None: the next that is free.
        page_listen: address of the page.
    """
    from cotouch.control import Invitation
    from cotouch.members import Participation
    from cotouch.session import identity_folder
    from cotouch.session import join as take_part
    from cotouch.version import __version__

    device = hand if hand not in {"scripted", "none"} else None
    if device is not None:
        _known_device(device)
    if record is not None:
        check_writable(record)
    decoded = Invitation.decode(typed() if invitation == "-" else invitation)
    part = Participation(
        name=name or _own_name(),
        version=__version__,
        hand="none" if hand == "none" else "scripted",
        device=device,
        seconds=seconds,
        listen=listen,
        record=record,
        mailboxes=mailboxes,
        identities=identity_folder(),
        unsafe=unsafe,
        real_time=real_time,
    )
    if page:
        if as_json:
            raise SessionError(
                "--page and --json cannot be combined, because with a page a separate process takes part; drop one"
            )
        with paged(wanted=True, port=port, listen=page_listen, tell=say) as beside:
            assert beside is not None
            staged(decoded, beside, part, quiet=headless)
        return
    if not (headless or as_json) and sys.stdout.isatty():
        _with_table(decoded, part)
        return
    parent = os.getppid()
    with stop_signals() as stopped:
        taken = take_part(
            decoded,
            part,
            warn=say,
            say=lambda text: None if as_json else say(text if text.startswith("ready") else f"{text} ..."),
            # Whoever shows it and tells it what to do has gone.
            stopped=lambda: stopped() or (part.mailboxes is not None and os.getppid() != parent),
        )
    if as_json:
        print_json(numbers(taken))
    else:
        sys.stdout.write(sentence(taken) + "\n")
    if taken.trouble is not None:
        say(f"the recording {record} {taken.trouble}")
        sys.exit(1)


def numbers(taken: "ParticipationOutcome") -> dict[str, object]:
    """How taking part went, for JSON; the user is numbered from 1, slots in the status from 0."""
    status = taken.status
    return {
        "name": taken.name,
        "user": None if taken.slot is None else taken.slot + 1,
        "ended": taken.why,
        "status": None if status is None else status.model_dump(),
        "pace": dict(taken.pace),
        "recorded_steps": taken.recorded,
        "recording_trouble": taken.trouble,
        "device": None if taken.device is None else dict(taken.device),
    }


def sentence(taken: "ParticipationOutcome") -> str:
    """How taking part went, for people."""
    status = taken.status
    why = "the host ended the session; " if taken.why == "ended" else ""
    if status is None or not status.steps:
        return f"{why}{taken.name} did not get to take part"
    return (
        f"{why}{taken.name} took {status.steps} steps in {status.time:.1f} s, {status.missed} missed; the ledger "
        f"balances to {status.residual:.1e} of the energy in play; link law {status.law}"
        + ("" if taken.recorded is None else f"; {taken.recorded} steps were recorded")
    )


@contextmanager
def stop_signals() -> Generator[Callable[[], bool]]:
    """Lets Ctrl-C, SIGTERM and a terminal that goes away end a loop in order.

    A second one, or one before the loop looks, interrupts at once. Python drops what is raised while it tidies up
    behind a compiler, say; so a signal is kept in mind even then, and the loop ends as soon as it looks.
    """
    asked: list[int] = []
    looking: list[bool] = []

    def ask(number: int, frame: object) -> None:  # noqa: ARG001
        asked.append(number)
        if len(asked) > 1 or not looking:
            raise KeyboardInterrupt

    def stopped() -> bool:
        if not looking:
            looking.append(True)
        return bool(asked)

    numbers = [signal.SIGINT, signal.SIGTERM]
    if sys.platform != "win32" and signal.getsignal(signal.SIGHUP) != signal.SIG_IGN:  # nohup wants it ignored
        numbers.append(signal.SIGHUP)
    before = {number: signal.signal(number, ask) for number in numbers}
    told, sys.unraisablehook = sys.unraisablehook, _but_interrupts(sys.unraisablehook)
    try:
        yield stopped
    finally:
        sys.unraisablehook = told
        for number, handler in before.items():
            signal.signal(number, handler)


def _but_interrupts(tell: Callable[["UnraisableHookArgs"], object]) -> Callable[["UnraisableHookArgs"], None]:
    """Tells what Python dropped, unless it is a signal, which is kept in mind.

    Args:
        tell: of all that Python drops.
    """
    return lambda dropped: None if issubclass(dropped.exc_type, KeyboardInterrupt) else (tell(dropped), None)[1]


@contextmanager
def shown(
    watch: "Callable[[], SessionWatch]", *, title: str, invitation: str | None = None, quiet: bool
) -> Generator[Callable[[], None]]:
    """A live table on standard error; gives a function to be called often, which draws now and then.

    Args:
        watch: gives what there is to show.
        title: of the table.
        invitation: to show; None: none.
        quiet: whether to show nothing.
    """
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


def _with_table(invitation: "Invitation", part: "Participation") -> None:
    """Takes part in a process of its own, so that drawing never makes a step late, and shows the session here."""
    from cotouch.session import MemberProcess, watching

    options = ["--name", part.name, "--headless", *_options(part)]
    options += [] if part.listen is None else ["--listen", part.listen]
    with stop_signals() as stopped, watching(invitation, listen=part.listen) as watch:
        child = MemberProcess(invitation, options)
        try:
            with shown(lambda: watch, title=invitation.session, quiet=False) as redraw:
                while child.running and not stopped():
                    watch.service(time.monotonic())
                    redraw()
                    time.sleep(_POLL)
        finally:
            code = child.stop()
            sys.stdout.write(child.said())
    if code:
        sys.exit(code)


def staged(
    invitation: "Invitation",
    beside: "Callable[[MemberSessionApi], AbstractContextManager[object]]",
    part: "Participation",
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
    from cotouch.session import member_session_api

    with (
        stop_signals() as stopped,
        member_session_api(invitation, name=part.name, listen=part.listen, options=_options(part)) as api,
        shown(lambda: api.watch, title=invitation.session, quiet=quiet) as redraw,
        ExitStack() as serving,
    ):
        served = False
        while not api.over and not stopped():
            api.tick(time.monotonic())
            if not served and api.slot is not None:
                served = True
                serving.enter_context(beside(api))
            redraw()
            time.sleep(_POLL)
        serving.close()
        code, said = api.close()
        troubles, kept = api.recording_left()
    sys.stdout.write(said)  # below the table
    for text in (*troubles, *([] if kept is None else [kept])):
        say(text)
    if code or troubles:
        sys.exit(code or 1)


def _options(part: "Participation") -> list[str]:
    """Of the process that takes part."""
    options = ["--device", part.device or part.hand]
    for flag, value in (("--duration", part.seconds), ("--record", part.record)):
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
        known = ", ".join(["scripted (as the session file says)", "none", *device_names()])
        raise SessionError(f'--device is "{text}"; it must be one of {known}')


def typed() -> str:
    """The invitation from standard input; who sits there is told what is waited for."""
    if sys.stdin.isatty():
        say("paste the invitation and press Enter:")
    return sys.stdin.readline()
