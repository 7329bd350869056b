"""Options that several commands share."""

from typing import Annotated

import typer

AsJson = Annotated[bool, typer.Option("--json", help="Print one JSON object, and nothing else, to standard output.")]

Dask = Annotated[
    str | None,
    typer.Option(help="Run on the workers of this Dask scheduler: tcp://host:8786.", show_default=False),
]

PagePort = Annotated[
    int | None, typer.Option(help="Port of the page; default: 8765 or the next free port.", show_default=False)
]
PageListen = Annotated[
    str, typer.Option(help="Address of the page; unless it is a loopback address, others can reach it.")
]
