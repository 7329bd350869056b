"""Files made to harm their reader: a sentence, little memory, little time, and the process that asked goes on."""

import json
import os
import re
import struct
import subprocess
import sys
import threading
import time
import zlib
from base64 import b64encode
from pathlib import Path

import pytest

from cotouch.body import body_from_surface, body_from_tetrahedra
from cotouch.errors import BodyError


def said(path: Path, content: bytes) -> str:
    path.write_bytes(content)
    with pytest.raises(BodyError) as caught:
        body_from_surface(path) if path.suffix == ".glb" else body_from_tetrahedra(path, unit="m")
    text = str(caught.value)
    assert "\n" not in text
    return text.removeprefix(f"{path} ")


def glb(tree: object) -> bytes:
    chunk = tree if isinstance(tree, bytes) else json.dumps(tree).encode()
    chunk += b" " * (-len(chunk) % 4)
    return b"glTF" + struct.pack("<III", 2, 20 + len(chunk), len(chunk)) + b"JSON" + chunk


# Reads a mesh in a process of its own, because the system tells only the most memory that any child ever had.
MEASURED = """
import resource, sys
from cotouch.body import body_from_tetrahedra
from cotouch.errors import BodyError
try:
    body_from_tetrahedra(sys.argv[1], unit="m")
except BodyError as error:
    print(str(error).removeprefix(sys.argv[1] + " "))
print(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss >> 10)
"""


def test_a_hundred_bytes_that_mean_a_hundred_million_points(tmp_path: Path) -> None:
    head = b"# vtk DataFile Version 3.0\nx\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 500 500 400\nORIGIN 0 0 0\n"
    assert said(tmp_path / "a.vtk", head + b"SPACING 1 1 1\n") == (
        "is a STRUCTURED_POINTS, which has neither tetrahedra nor triangles of its own; it must be an "
        "UNSTRUCTURED_GRID or POLYDATA"
    )


def test_a_compressed_gigabyte(tmp_path: Path) -> None:
    """What it comes to is only known when it is there: the limit on memory holds."""
    size, part = 1 << 30, bytes(1 << 20)
    packer = zlib.compressobj(9)
    first, again = (packer.compress(part) + packer.flush(zlib.Z_FULL_FLUSH) for _ in range(2))
    end = packer.flush()[:-4] + struct.pack(">I", (size % 65521 << 16) + 1)  # Adler's sum of so many zeros
    block = first + again * ((size >> 20) - 1) + end
    data = b64encode(struct.pack("<4I", 1, size, 0, len(block))) + b64encode(block)
    head = (
        b'<VTKFile type="UnstructuredGrid" version="0.1" byte_order="LittleEndian" compressor="vtkZLibDataCompressor">'
        b'<UnstructuredGrid><Piece NumberOfPoints="4" NumberOfCells="1"><Points>'
        b'<DataArray type="Float64" NumberOfComponents="3" format="binary">'
    )
    tail = b"</DataArray></Points></Piece></UnstructuredGrid></VTKFile>"
    path = tmp_path / "a.vtu"
    path.write_bytes(head + data + tail)
    done = subprocess.run([sys.executable, "-c", MEASURED, str(path)], capture_output=True, text=True, check=True)
    text, most = done.stdout.splitlines()
    assert re.fullmatch(r"cannot be read as VTU: that takes more than \d{3} MB of memory", text)
    assert int(most) < 800  # MB


@pytest.mark.parametrize(
    ("tree", "word"),
    [
        ({"accessors": [{}], "meshes": [{"primitives": [{"indices": 0}]}]}, "cannot be read as GLB: it has no"),
        (b'{"a":' + b"[" * 100_000 + b"]" * 100_000 + b"}", "cannot be read as GLB: it is nested too deeply"),
        (
            {
                "scenes": [{"nodes": [0]}],
                "nodes": [{"mesh": 0}],
                "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
                "accessors": [
                    {"count": 900_000, "type": "VEC3", "componentType": 5126},
                    {"count": 2_999_997, "type": "SCALAR", "componentType": 5125},
                ],
            },
            "claims 900000 points and 999999 triangles, but has only ",
        ),
        (
            {
                "scenes": [{"nodes": list(range(20_000))}],
                "nodes": [{"mesh": 0}] * 20_000,
                "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
                "accessors": [{"count": 300, "type": "VEC3", "componentType": 5126}],
            },
            "has 2000000 triangles but the limit is 1000000",
        ),
    ],
)
def test_glb(tmp_path: Path, tree: object, word: str) -> None:
    assert word in said(tmp_path / "a.glb", glb(tree))


def test_one_node_with_a_great_number(tmp_path: Path) -> None:
    nodes = b"$Nodes\n1 1 1 1\n2 1 0 1\n999999999999\n0 0 0\n$EndNodes\n"
    cells = b"$Elements\n1 1 1 1\n3 1 4 1\n1 1 1 1 1\n$EndElements\n"
    text = said(tmp_path / "a.msh", b"$MeshFormat\n4.1 0 8\n$EndMeshFormat\n" + nodes + cells)
    assert text == "cannot be read as MSH: that takes more than 384 MB of memory"


@pytest.mark.parametrize("name", ["a.stl", "a.vtk"])
def test_a_pipe_is_not_waited_for(tmp_path: Path, name: str) -> None:
    os.mkfifo(tmp_path / name)
    answers: list[str] = []

    def read() -> None:
        try:
            body_from_surface(tmp_path / name, unit="m") if name == "a.stl" else body_from_tetrahedra(
                tmp_path / name, unit="m"
            )
        except BodyError as error:
            answers.append(str(error))

    thread = threading.Thread(target=read, daemon=True)
    thread.start()
    thread.join(20.0)
    if thread.is_alive():  # let it go on to its end
        os.close(os.open(tmp_path / name, os.O_WRONLY | os.O_NONBLOCK))
        time.sleep(0.1)
    assert answers == [f"the mesh {tmp_path / name} cannot be read: it is a pipe; name an ordinary file"]
