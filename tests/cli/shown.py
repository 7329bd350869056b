"""What a host's terminal shows."""

from io import StringIO

from rich.console import Console
from tests.cli.inside import view
from tests.session.world import World

from cotouch.members import SessionWatch


def table(watch: SessionWatch, now: float, *, width: int = 200) -> str:
    """The table of what is seen of a session."""
    text = StringIO()
    Console(file=text, width=width).print(view(watch, now, title="t", started=0.0))
    return text.getvalue()


def shown(world: World, *, width: int = 200) -> str:
    """The table of a session, now."""
    assert world.host is not None
    return table(world.host.watch, world.now, width=width)
