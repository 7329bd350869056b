"""Mutated mesh files for the record: does ever anything come but a body or one sentence, and what does it cost?

`python -m benchmarks.meshes --count 2000`: so many of every format, each by a forked process in place of the fresh one
that a user's file gets, confined alike; a body is made of what comes out of it in one more. Every case is drawn from
(seed, format, number) alone, so that a single one can be run again with `--only FORMAT NUMBER`.
"""

import argparse
import os
import pickle
import re
import resource
import signal
import tempfile
import time
import traceback
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

import meshio
import numpy as np
import trimesh

from cotouch.body import MOST_ELEMENTS, MOST_TRIANGLES, Body, body_from_surface, body_from_tetrahedra
from cotouch.errors import BodyError
from cotouch.meshfile import SURFACES, VOLUMES, Mesh, _inside, _surfaces, _volumes
from cotouch.meshfile._read import budget
from cotouch.meshfile._wire import receive

SEED: Final = 2026
# Numbers that readers stumble over, as text and in four and eight bytes.
_TEXT: Final = (b"-1", b"0", b"1e999", b"nan", b"2147483648", b"99999999999", b"9" * 5000, b"1e-320", b"-inf", b"3.5")
_NUMBERS: Final = (0, 1, 255, 65536, 2**31 - 1, 2**31, 2**32 - 1, 2**53, 2**62, 2**63 - 1, 2**64 - 1)
_WORDS: Final = (b"[" * 4000, b"<a>" * 4000, b"{", b"\n", b"\r\n", b" " * 3000, b"\xff\xfe", b"%s%n", b"\x00" * 64)


@dataclass(frozen=True)
class Case:
    """What one file came to.

    Attributes:
        name: format and number.
        outcome: "body", "sentence" or what should not be.
        seconds: of reading and of making the body.
        memory: the larger of the two processes' [MB].
    """

    name: str
    outcome: str
    seconds: tuple[float, float]
    memory: int


def whole(folder: Path) -> dict[str, list[bytes]]:
    """Good files of every format and way of writing it."""
    sphere: Any = trimesh.creation.icosphere(subdivisions=2)
    found: dict[str, list[bytes]] = {}
    for suffix in SURFACES:
        ways = [None, "stl_ascii"] if suffix == ".stl" else [None]
        for way in ways:
            sphere.export(folder / f"a{suffix}", file_type=way)
            found.setdefault(suffix, []).append((folder / f"a{suffix}").read_bytes())
    sphere.export(folder / "a.ply", encoding="ascii")
    found[".ply"].append((folder / "a.ply").read_bytes())
    side = np.arange(4)
    points = np.stack(np.meshgrid(side, side, side, indexing="ij"), -1).reshape(-1, 3).astype(float)
    at = np.arange(64).reshape(4, 4, 4)
    c = [at[a : 3 + a, b : 3 + b, d : 3 + d].ravel() for a in (0, 1) for b in (0, 1) for d in (0, 1)]
    parts = ((0, 1, 3, 7), (0, 1, 5, 7), (0, 2, 3, 7), (0, 2, 6, 7), (0, 4, 5, 7), (0, 4, 6, 7))
    cells = np.concatenate([np.stack([c[k] for k in part], 1) for part in parts])
    mesh = meshio.Mesh(points, [("tetra", cells)], point_data={"clamp": (points[:, 0] < 1).astype(np.int32)})
    for suffix, options in (
        (".vtk", {}),
        (".vtk", {"binary": False}),
        (".vtk", {"file_format": "vtk42"}),
        (".vtu", {}),
        (".vtu", {"binary": False}),
        (".vtu", {"compression": None}),
        (".msh", {"file_format": "gmsh"}),
        (".msh", {"file_format": "gmsh", "binary": False}),
        (".msh", {"file_format": "gmsh22"}),
        (".msh", {"file_format": "gmsh22", "binary": False}),
        (".mesh", {"file_format": "medit"}),
    ):
        mesh.write(folder / f"a{suffix}", **options)
        found.setdefault(suffix, []).append((folder / f"a{suffix}").read_bytes())
    return found


def mutated(content: bytes, rng: np.random.Generator) -> bytes:
    """A file with one to four things wrong, mostly one."""
    data = bytearray(content)
    for _ in range(min(int(rng.geometric(0.6)), 4)):
        size = max(len(data), 1)
        at, length = int(rng.integers(size)), int(rng.integers(1, 64))
        match rng.integers(8):
            case 0:
                for place in rng.integers(size, size=rng.integers(1, 9)):
                    data[place : place + 1] = bytes([rng.integers(256)])
            case 1:
                del data[at : at + length * int(rng.integers(1, 40))]
            case 2:
                data[at:at] = data[at : at + length * 16] * int(rng.integers(1, 8))
            case 3:
                del data[at:]
            case 4 | 5:
                digits = list(re.finditer(rb"-?\d+\.?\d*(?:[eE][-+]?\d+)?", bytes(data[: 1 << 14])))
                if digits:  # those of a head more often than those of the numbers themselves
                    chosen = digits[min(int(rng.exponential(12.0)), len(digits) - 1)]
                    data[chosen.start() : chosen.end()] = _TEXT[rng.integers(len(_TEXT))]
            case 6:
                wide = 4 * int(rng.integers(1, 3))
                value = _NUMBERS[rng.integers(len(_NUMBERS))] % (1 << 8 * wide)
                place = at if rng.integers(2) else min(int(rng.exponential(60.0)), size)
                data[place : place + wide] = value.to_bytes(wide, ("little", "big")[rng.integers(2)])
            case _:
                data[at:at] = _WORDS[rng.integers(len(_WORDS))]
    return bytes(data) or b"\n"


def forked(work: Callable[[int], None], most: float) -> tuple[int, bytes, float, int]:
    """Runs it in a forked process that gets a pipe: how that ended, what it wrote, its time, its memory [MB]."""
    end, begin = os.pipe()
    started = time.perf_counter()
    process = os.fork()
    if process == 0:
        os.close(end)
        try:
            signal.alarm(int(most))
            work(begin)
        except BaseException:  # noqa: BLE001 - whatever it is, it is told
            os.write(begin, traceback.format_exc().encode()[-4000:])
            os._exit(9)
        os._exit(0)
    os.close(begin)
    with os.fdopen(end, "rb") as pipe:
        said = pipe.read()
    _, status, used = os.wait4(process, 0)
    return os.waitstatus_to_exitcode(status), said, time.perf_counter() - started, used.ru_maxrss >> 10


def tried(folder: Path, suffix: str, number: int, content: bytes) -> Case:
    """Reads one file, and makes a body of what was read."""
    path = folder / f"a{suffix}"
    path.write_bytes(content)
    surface = suffix in SURFACES
    most = MOST_TRIANGLES if surface else MOST_ELEMENTS
    memory, seconds = budget(len(content))

    def read(out: int) -> None:
        _inside.confine(memory, seconds)
        with os.fdopen(out, "wb") as stream:
            _inside.answer(_surfaces if surface else _volumes, path, most, memory, stream)

    code, said, reading, held = forked(read, 200.0)
    name = f"{suffix} {number}"
    try:
        with tempfile.TemporaryFile() as file:
            file.write(said)
            file.seek(0)
            mesh = receive(file, 3 if surface else 4, memory)
    except ValueError:
        # What a user is told of a reader that ended so is a sentence too, but it should be rare.
        return Case(
            name, f"sentence: ended with {code}" if code < 0 else f"READER {code} {said!r}", (reading, 0.0), held
        )
    if not isinstance(mesh, Mesh):
        return Case(name, "sentence", (reading, 0.0), held)
    source = (mesh.points, mesh.elements)

    def build(out: int) -> None:
        try:
            unit: Any = "m"
            body: Body = (
                body_from_surface(source, unit=unit, resolution=4)
                if surface
                else body_from_tetrahedra(source, unit=unit)
            )
            os.write(out, pickle.dumps((body.nodes, "body")))
        except BodyError as error:
            os.write(out, pickle.dumps((0, "sentence" if "\n" not in str(error) else "TWO LINES")))

    code, answer, building, more = forked(build, 120.0)
    if code:
        return Case(name, f"BUILDER {code} {answer.decode(errors='replace')}", (reading, building), max(held, more))
    return Case(name, pickle.loads(answer)[1], (reading, building), max(held, more))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=100, help="of every format")
    parser.add_argument("--only", nargs=2, metavar=("FORMAT", "NUMBER"))
    options = parser.parse_args()
    cases: list[Case] = []
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        files = whole(folder)
        _surfaces.load(), _volumes.load()
        for suffix in SURFACES + VOLUMES:
            for number in range(options.count):
                if options.only and (suffix, str(number)) != tuple(options.only):
                    continue
                rng = np.random.default_rng([SEED, (SURFACES + VOLUMES).index(suffix), number])
                good = files[suffix]
                cases.append(tried(folder, suffix, number, mutated(good[number % len(good)], rng)))
                if not cases[-1].outcome.startswith(("body", "sentence")) or options.only:
                    print(cases[-1], flush=True)
            mine = [case for case in cases if case.name.startswith(f"{suffix} ")]
            if mine:
                counts = Counter(case.outcome.split(" ")[0] for case in mine)
                slow = max(mine, key=lambda case: sum(case.seconds))
                large = max(mine, key=lambda case: case.memory)
                print(
                    f"{suffix}: {dict(counts)}; slowest {slow.name} {slow.seconds}; "
                    f"largest {large.name} {large.memory} MB"
                    f" of {resource.getrusage(resource.RUSAGE_SELF).ru_maxrss >> 10} MB to begin with",
                    flush=True,
                )


if __name__ == "__main__":
    main()
