"""Has a mesh file read by a process that has little memory and little time, and can do nothing else."""

import contextlib
import json
import os
import signal
import subprocess
import sys
import threading
from pathlib import Path
from typing import BinaryIO, Final, cast

from cotouch.errors import BodyError
from cotouch.files import look
from cotouch.meshfile._legacy import vtk_kind
from cotouch.meshfile._mesh import SURFACES, VOLUMES, Mesh
from cotouch.meshfile._wire import receive

# No format stores an element, with its share of the points, in less; a bigger file is refused unread.
_LEAST_BYTES: Final = 600
# What a reader may take: the libraries need up to so many bytes for one of the file's. A compressed file may come to
# several times its size, but a small one to no more than the share that all have.
_MEMORY, _MEMORY_EACH, _MOST_MEMORY = 384 << 20, 24, 8 << 30
# Of the processor, and at most on the clock [s]; a million triangles as text take 15 s.
_SECONDS, _SECONDS_EACH, _WAIT = 20.0, 0.4e-6, 4.0

_START: Final = "import sys, json; given = json.loads(sys.argv[1]); sys.path[:0] = given.pop('path')\n" + (
    "from cotouch.meshfile._inside import main; main(**given)"
)
# Threads of linear algebra, and an arena for each, would take address space that nobody uses.
_ALONE: Final = dict.fromkeys(("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS", "MALLOC_ARENA_MAX"), "1")


def is_surface(path: Path) -> bool:
    """Whether a mesh file is one of a surface: by the end of its name, and a VTK file by what it says it holds."""
    suffix = path.suffix.lower()
    with contextlib.suppress(OSError):
        return suffix in SURFACES or (suffix == ".vtk" and path.is_file() and vtk_kind(path) == "POLYDATA")
    return False


def read_surface(path: Path, most: int) -> Mesh:
    """Triangles of an STL, OBJ, PLY, OFF or GLB file, or of a VTK file that holds POLYDATA.

    Args:
        path: of the file.
        most: elements that are taken.

    Raises:
        BodyError: it is missing, of another kind, not a mesh, or has more than `most` triangles.
    """
    return _read(path, (*SURFACES, ".vtk"), "a surface mesh", 3, most)


def read_tetrahedra(path: Path, most: int) -> Mesh:
    """Tetrahedra and named sets of a VTK, VTU, Gmsh or MEDIT file.

    Args:
        path: of the file.
        most: elements that are taken.

    Raises:
        BodyError: it is missing, of another kind, not a mesh, has no tetrahedra, or more than `most` elements.
    """
    return _read(path, VOLUMES, "a tetrahedral mesh", 4, most)


def _read(path: Path, suffixes: tuple[str, ...], what: str, corners: int, most: int) -> Mesh:
    if path.suffix.lower() not in suffixes:
        raise BodyError(f'{path} ends in "{path.suffix}"; {what} must be one of {", ".join(suffixes)}')
    size = look(path, "mesh", BodyError).st_size
    if size == 0:
        raise BodyError(f"the mesh {path} is empty")
    if size > most * _LEAST_BYTES + (1 << 20):
        raise BodyError(
            f"{path} has {size / 1e6:.0f} MB, more than a mesh of {most} elements needs; make it coarser, or raise "
            "the limit on elements"
        )
    return _answer(path, corners, most, *budget(size))


def budget(size: int) -> tuple[int, float]:
    """Memory [bytes] and processor time [s] for reading a file of so many bytes."""
    return min(_MEMORY + _MEMORY_EACH * size, _MOST_MEMORY), _SECONDS + _SECONDS_EACH * size


def _answer(path: Path, corners: int, most: int, memory: int, seconds: float) -> Mesh:
    """What the reader says; however it ends, it ends within the time, and its end is a mesh or a sentence."""
    home = str(Path(__file__).resolve().parents[2])
    given = {
        "surface": corners == 3,
        "path": [home, *(place for place in sys.path if place)],
        "file": str(path.absolute()),
        "most": most,
        "memory": memory,
        "seconds": seconds,
    }
    kind = path.suffix[1:].upper()
    try:
        process = subprocess.Popen(  # noqa: S603
            [sys.executable, "-I", "-S", "-c", _START, json.dumps(given)],
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            env={**os.environ, **_ALONE},
        )
    except OSError as error:
        raise BodyError(f"the mesh {path} cannot be read: no process can be started ({error.strerror})") from error
    late = threading.Event()

    def end() -> None:
        late.set()
        process.kill()

    clock = threading.Timer(_WAIT * seconds, end)
    clock.daemon = True
    clock.start()
    pipe = cast(BinaryIO, process.stdout)
    said: Mesh | str | None = None
    try:
        with pipe, contextlib.suppress(ValueError, MemoryError):
            said = receive(pipe, corners, memory)
        process.wait()  # what still writes finds nobody reading
    finally:
        process.kill()
        process.wait()
        clock.cancel()
    if isinstance(said, Mesh):
        return said
    if said is None:
        said = f"cannot be read as {kind}: {_end(process.returncode, memory, seconds, late=late.is_set())}"
    raise BodyError(f"{path} {said}")


def _end(code: int, memory: int, seconds: float, *, late: bool) -> str:
    """Why a reader that said nothing ended."""
    if late or -code in {getattr(signal, "SIGXCPU", 0), getattr(signal, "SIGALRM", 0)}:
        return f"that takes longer than {seconds:.0f} s"
    if code == 0:
        return "its reader gave no answer"
    if -code == getattr(signal, "SIGKILL", 0):
        return f"that takes more than {memory >> 20} MB of memory or {seconds:.0f} s"
    return f"its reader ended with {f'signal {-code}' if code < 0 else f'code {code}'}"
