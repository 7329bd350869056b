"""What the commands print."""

import json
import math
import sys
from collections.abc import Generator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from cotouch.errors import ScenarioError


def print_json(value: dict[str, Any]) -> None:
    """Prints one JSON object on standard output; what is not finite becomes null, which JSON has."""
    sys.stdout.write(json.dumps(_finite(value), indent=2) + "\n")


def _finite(value: Any) -> Any:
    if isinstance(value, dict):
        return {str(key): _finite(entry) for key, entry in value.items()}  # pyright: ignore[reportUnknownVariableType]
    if isinstance(value, list | tuple):
        return [_finite(entry) for entry in value]  # pyright: ignore[reportUnknownVariableType]
    if isinstance(value, float) and not math.isfinite(value):
        return None
    return value


def number(value: float | None, unit: str = "", digits: int = 4) -> str:
    """A number for a table."""
    if value is None:
        return "not settled"
    return f"{value:.{digits}g}" + (f" {unit}" if unit else "")


def folder(path: Path) -> Path:
    """Makes a folder for output.

    Raises:
        ScenarioError: it cannot be made.
    """
    try:
        path.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise ScenarioError(f"the folder {path} cannot be made: {error.strerror}") from error
    return path


def writable(path: Path) -> None:
    """Refuses a file that cannot be written, before the work that would fill it.

    Raises:
        ScenarioError: its folder does not exist, or it is a folder itself.
    """
    if path.is_dir():
        raise ScenarioError(f"{path} is a folder; name a file")
    if not path.absolute().parent.is_dir():
        raise ScenarioError(f"the folder of {path} does not exist; make it first")


@contextmanager
def working(text: str, *, quiet: bool) -> Generator[None]:
    """Shows on standard error that something is going on."""
    if quiet or not sys.stderr.isatty():
        yield
        return
    from rich.console import Console

    with Console(stderr=True).status(text):
        yield
