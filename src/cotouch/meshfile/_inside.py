"""What runs in the reader's process: it gives up what it could do harm with, then parses, then says what it found."""

import contextlib
import io
import os
import re
import sys
import warnings
from collections.abc import Generator
from pathlib import Path
from types import ModuleType
from typing import BinaryIO, Final

import numpy as np

from cotouch.errors import BodyError
from cotouch.meshfile._mesh import Mesh
from cotouch.meshfile._wire import send

# What the libraries load if it is there, and these formats need not: two thirds of the time that a start takes, and
# much that a hostile file could reach, such as readers of images.
_NOT_NEEDED: Final = (
    "PIL",
    "cascadio",
    "collada",
    "h5py",
    "httpx",
    "jsonschema",
    "lxml",
    "manifold3d",
    "mapbox_earcut",
    "matplotlib",
    "netCDF4",
    "networkx",
    "openctm",
    "pyglet",
    "requests",
    "rtree",
    "scipy",
    "shapely",
    "sympy",
    "vhacdx",
)
# Sentences of Python and of the libraries about their own arrays and words, which say nothing of the file.
_OF_A_LIBRARY: Final = re.compile(
    "array element|cannot reshape|could not (?:convert|be)|invalid literal|buffer|Couldn't read file|Unexpected line"
)


def main(*, file: str, surface: bool, most: int, memory: int, seconds: float) -> None:
    """Reads a file and writes what it holds to standard output.

    Args:
        file: its path.
        surface: whether triangles are wanted, not tetrahedra.
        most: elements.
        memory: that reading it may take, on top of what the libraries do [bytes].
        seconds: of the processor.
    """
    with os.fdopen(os.dup(1), "wb") as out:
        nowhere = os.open(os.devnull, os.O_WRONLY)
        for number in (1, 2):
            os.dup2(nowhere, number)
        reader = reader_of(surface=surface)
        confine(memory, seconds)
        answer(reader, Path(file), most, memory, out)
    os._exit(0)  # nothing of what was made needs to be taken down


def reader_of(*, surface: bool) -> ModuleType:
    """The module that reads such files, with its library loaded."""
    for name in _NOT_NEEDED:
        sys.modules[name] = None  # pyright: ignore[reportArgumentType]
    from cotouch.meshfile import _surfaces, _volumes

    reader = _surfaces if surface else _volumes
    reader.load()
    return reader


def answer(reader: ModuleType, path: Path, most: int, memory: int, out: BinaryIO) -> None:
    """Reads a file and writes what it holds, or why it holds nothing.

    Args:
        reader: module that reads this kind of file.
        path: of the file.
        most: elements that are taken.
        memory: most that may be allocated [bytes].
        out: where it goes.
    """
    found: Mesh | str
    try:
        with _quiet(path):
            found = reader.read(path, most)
        send(out, found)
    except BodyError as refusal:
        send(out, str(refusal))
    except MemoryError:
        send(out, f"cannot be read as {path.suffix[1:].upper()}: that takes more than {memory >> 20} MB of memory")


def confine(memory: int, seconds: float) -> None:
    """Bounds memory and processor time; nothing can be written any more.

    Args:
        memory: most that may be allocated [bytes].
        seconds: of the processor.
    """
    try:
        import resource
    except ImportError:  # not there on Windows; time is bounded by whoever started this
        return
    held = 0
    with contextlib.suppress(OSError, ValueError, IndexError):
        held = int(Path("/proc/self/statm").read_text(encoding="ascii").split()[0]) * resource.getpagesize()
    ends = int(seconds) + 1
    for name, limit in (
        ("RLIMIT_AS", (held or 1 << 30) + memory),
        ("RLIMIT_CPU", ends),
        ("RLIMIT_FSIZE", 0),
        ("RLIMIT_CORE", 0),
    ):
        with contextlib.suppress(OSError, ValueError, AttributeError):
            number = getattr(resource, name)
            hard = resource.getrlimit(number)[1]
            least = limit if hard == resource.RLIM_INFINITY else min(limit, hard)
            # A second later than the signal that says why, there is the one that does not.
            resource.setrlimit(number, (least, least + (name == "RLIMIT_CPU" and least != hard)))


@contextlib.contextmanager
def _quiet(path: Path) -> Generator[None]:
    """Keeps a library quiet: whatever it raises, prints or exits with becomes one sentence."""
    said = io.StringIO()
    try:
        with (
            contextlib.redirect_stdout(said),
            contextlib.redirect_stderr(said),
            warnings.catch_warnings(),
            np.errstate(all="ignore"),
        ):
            warnings.simplefilter("ignore")
            yield
    except (BodyError, MemoryError):
        raise
    except (SystemExit, Exception) as error:
        reason = " ".join(str(error).split())
        if isinstance(error, KeyError):
            reason = f"it has no {reason}"
        if isinstance(error, RecursionError):
            reason = "it is nested too deeply"
        if isinstance(error, SystemExit) or not reason:
            reason = next((line.strip() for line in said.getvalue().splitlines() if line.strip()), type(error).__name__)
        nothing = isinstance(error, NameError | AttributeError | TypeError | ImportError | IndexError | UnicodeError)
        if nothing or _OF_A_LIBRARY.search(reason):
            reason = "it is not as the format asks for, or was cut off"
        raise BodyError(f"cannot be read as {path.suffix[1:].upper()}: {reason[:160]}") from error
