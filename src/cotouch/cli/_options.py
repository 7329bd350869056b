"""Options that several commands share."""

from typing import Annotated

import typer

AsJson = Annotated[
    bool, typer.Option("--json", help="Print one JSON object on standard output and nothing else there.")
]

PagePort = Annotated[
    int | None, typer.Option(help="Of the page; by default 8765, or the next that is free.", show_default=False)
]
PageListen = Annotated[
    str, typer.Option(help="Address of this machine for the page; other than loopback, others can reach it.")
]
