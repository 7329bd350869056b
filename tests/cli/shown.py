"""What a host's terminal shows."""

from io import StringIO

from rich.console import Console
from tests.session.world import World

from cotouch.cli._table import view


def shown(world: World, *, width: int = 200) -> str:
    """The table of a session, now."""
    assert world.host is not None
    text = StringIO()
    Console(file=text, width=width).print(view(world.host.watch, world.now, title="t", started=0.0))
    return text.getvalue()
