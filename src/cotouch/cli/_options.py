"""Options that several commands share."""

from typing import Annotated

import typer

AsJson = Annotated[
    bool, typer.Option("--json", help="Print one JSON object on standard output and nothing else there.")
]

Dask = Annotated[
    str | None,
    typer.Option(help="Let the workers of this Dask scheduler compute: tcp://host:8786.", show_default=False),
]

PagePort = Annotated[
    int | None, typer.Option(help="Port of the page; default: 8765 or the next free one.", show_default=False)
]
PageListen = Annotated[str, typer.Option(help="Address of the page; others can reach any but loopback.")]
