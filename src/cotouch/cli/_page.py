"""`--page`: the page of a session, beside what the command does."""

import os
import sys
import threading
import webbrowser
from collections.abc import Callable, Generator
from contextlib import AbstractContextManager, contextmanager
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from cotouch.observers import SessionApi
    from cotouch.web import PageAddress


def desktop() -> bool:
    """Whether somebody sits at a terminal of this machine who has a screen for a browser."""
    if not sys.stderr.isatty():
        return False
    if sys.platform in {"darwin", "win32"}:
        return "SSH_CONNECTION" not in os.environ
    return bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))


def watched() -> bool:
    """Whether somebody is there who can interrupt."""
    return sys.stderr.isatty()


@contextmanager
def page(
    *, wanted: bool, port: int | None, listen: str, tell: Callable[[str], None]
) -> "Generator[Callable[[SessionApi], AbstractContextManager[object]] | None]":
    """Takes the page's port at once; gives what serves a stage there, or None where no page is wanted.

    Args:
        wanted: whether there is to be a page.
        port: to serve at; None: the usual one, or the next that is free.
        listen: address of this machine.
        tell: is told where the page is, in a sentence.

    Raises:
        SessionError: the address or the port makes no sense.
        TransportError: the port is taken, or not allowed.
    """
    if not wanted:
        yield None
        return
    from cotouch.web import PageAddress

    at = PageAddress(listen=listen, port=port)
    try:
        yield lambda api: _served(api, at, tell)
    finally:
        at.close()


@contextmanager
def _served(api: "SessionApi", at: "PageAddress", tell: Callable[[str], None]) -> Generator[None]:
    from cotouch.web import PageServer

    with PageServer(api, at=at) as server:
        tell(f"the page is at {server.url}")
        if not server.local:
            tell(
                f"others can reach {at.listen} and watch this session; anyone with the address and its token, "
                "which is sent unencrypted, can take part"
            )
        if desktop():
            threading.Thread(target=_open, args=(server.ticket(),), name="cotouch browser", daemon=True).start()
        yield


def _open(address: str) -> None:
    """Shows the page in a browser with a window; one in the terminal would take it away."""
    try:
        browser = webbrowser.get()
        if type(browser) is not webbrowser.GenericBrowser:
            browser.open(address)
    except (webbrowser.Error, OSError):
        return
