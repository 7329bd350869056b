"""The page in the browser, and the server that it comes from."""

from cotouch.web._address import PORT, PageAddress
from cotouch.web._protocol import Hello, TakeControl
from cotouch.web._server import PageServer
from cotouch.web._verdict import judged

__all__ = ["PORT", "Hello", "PageAddress", "PageServer", "TakeControl", "judged"]
