"""The page in the browser: what it shows, and the server that it comes from."""

from cotouch.web._server import PORT, PageServer
from cotouch.web._verdict import Verdict, judged

__all__ = ["PORT", "PageServer", "Verdict", "judged"]
