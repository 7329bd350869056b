"""Files that come with the package."""

from importlib.resources import files
from pathlib import Path

from cotouch.errors import CotouchError


def shipped(room: str, name: str, error: type[CotouchError]) -> Path:
    """A file beside its room where the package is installed, in `examples/` where the sources are.

    Args:
        room: whose file it is.
        name: of the file.
        error: class of what is raised.

    Raises:
        CotouchError: of the given class: it is in neither place.
    """
    for folder in (Path(str(files("cotouch"))) / room, Path(__file__).resolve().parents[3] / "examples"):
        if (folder / name).is_file():
            return folder / name
    raise error(f"{name} is neither beside cotouch.{room} nor in the examples of the sources; reinstall cotouch")
