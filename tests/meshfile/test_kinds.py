"""Valid files that are easily misjudged, each of a cube or a tetrahedron; and files that were cut off.

The files in `data/` were written by VTK 9: a cube of side 1 as six quadrangles, and as strips.
"""

import contextlib
import struct
from pathlib import Path

import meshio
import numpy as np
import pytest
import trimesh
from tests.meshfile.here import parsed_here

from cotouch.body import body_from_surface
from cotouch.errors import BodyError
from cotouch.meshfile import Mesh, is_surface, read_surface, read_tetrahedra
from cotouch.scenario import FileTable

MOST = 1000
CORNERS = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]


@pytest.fixture(autouse=True)
def here(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("cotouch.meshfile._read._answer", parsed_here)


def volume(mesh: Mesh) -> float:
    """Of what the triangles enclose; right only if all of them look outwards."""
    a, b, c = mesh.points[mesh.elements].transpose(1, 0, 2)
    return float(np.einsum("ij,ij", a, np.cross(b, c)) / 6.0)


@pytest.fixture
def text() -> str:
    """A cube as an STL file of words."""
    return trimesh.exchange.stl.export_stl_ascii(trimesh.creation.box((1, 1, 1)))


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("endsolid", "end solid"),
        ("endsolid", "end solid of a name"),
        ("endfacet", "end facet"),
        ("\n", "\r\n"),
        ("end", "END"),
        ("solid", "  solid"),
    ],
)
def test_words_of_stl(tmp_path: Path, text: str, old: str, new: str) -> None:
    path = tmp_path / "a.stl"
    path.write_bytes(text.replace(old, new).encode())
    assert volume(read_surface(path, MOST)) == pytest.approx(1.0)


def test_packed_stl_with_something_behind_it(tmp_path: Path) -> None:
    path = tmp_path / "a.stl"
    path.write_bytes(trimesh.exchange.stl.export_stl(trimesh.creation.box((1, 1, 1))) + b"colour table")
    assert volume(read_surface(path, MOST)) == pytest.approx(1.0)


@pytest.mark.parametrize(("name", "cut"), [("a.stl", 40), ("b.stl", 30), ("a.ply", 20), ("b.ply", 40), ("a.off", 40)])
def test_a_file_that_was_cut_off_says_so(tmp_path: Path, text: str, name: str, cut: int) -> None:
    box = trimesh.creation.box((1, 1, 1))
    whole = {
        "a.stl": text.encode(),
        "b.stl": trimesh.exchange.stl.export_stl(box),
        "a.ply": trimesh.exchange.ply.export_ply(box, encoding="ascii"),
        "b.ply": trimesh.exchange.ply.export_ply(box),
        "a.off": box.export(file_type="off").encode(),
    }[name]
    path = tmp_path / name
    path.write_bytes(whole)
    assert read_surface(path, MOST).elements.shape == (12, 3)
    path.write_bytes(whole[:-cut])
    with pytest.raises(BodyError, match=r"ends|has bytes for only 11|unexpected length|has only \d+ bytes") as caught:
        read_surface(path, MOST)
    assert "module" not in str(caught.value)


@pytest.mark.parametrize("packed", [False, True])
def test_strips_of_ply(tmp_path: Path, packed: bool) -> None:
    """Two strips around a tetrahedron: 0 1 2 3 has two of its triangles, 1 0 3 and 2 3 0 are the others."""
    strips = [0, 2, 1, 3, -1, 1, 0, 3, -1, 0, 2, 3]
    kind = "binary_little_endian" if packed else "ascii"
    properties = "".join(f"property float {axis}\n" for axis in "xyz")
    head = (
        f"ply\nformat {kind} 1.0\nelement vertex 4\n{properties}element tristrips 1\n"
        "property list int int vertex_indices\nend_header\n"
    )
    numbers = np.array(CORNERS, "<f4").tobytes() + struct.pack(f"<{len(strips) + 1}i", len(strips), *strips)
    words = "\n".join(" ".join(map(str, row)) for row in [*CORNERS, [len(strips), *strips]])
    path = tmp_path / "a.ply"
    path.write_bytes(head.encode() + (numbers if packed else words.encode()))
    mesh = read_surface(path, MOST)
    assert sorted(sorted(map(int, one)) for one in mesh.elements) == [[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]]
    assert volume(mesh) == pytest.approx(1.0 / 6.0)


@pytest.mark.parametrize("name", ["quads_ascii_42", "quads_binary_51", "strips_ascii_51", "strips_binary_42"])
def test_surfaces_of_vtk(name: str) -> None:
    path = Path(__file__).parent / "data" / f"{name}.vtk"
    assert is_surface(path)
    mesh = read_surface(path, MOST)
    assert (mesh.points.shape, mesh.elements.shape) == ((24, 3), (12, 3))
    assert volume(mesh) == pytest.approx(1.0)
    with pytest.raises(BodyError, match="is a surface \\(POLYDATA\\) and has no tetrahedra"):
        read_tetrahedra(path, MOST)


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("a.ply", "ply\nformat ascii 1.0\nelement vertex 4\nprop"),
        ("a.vtu", "<?xml version='1.0'?><VTKFile type='Unstruct"),
    ],
)
def test_what_ends_in_its_first_lines_is_blamed_on_the_file(tmp_path: Path, name: str, text: str) -> None:
    path = tmp_path / name
    path.write_text(text, encoding="utf-8")
    with pytest.raises(BodyError, match="it is not as the format asks for, or was cut off"):
        (read_surface if is_surface(path) else read_tetrahedra)(path, MOST)


@pytest.mark.parametrize("cut", [200, 700, 1100])
@pytest.mark.parametrize("name", ["quads_ascii_42", "quads_binary_51", "strips_ascii_51", "strips_binary_42"])
def test_surfaces_of_vtk_that_were_cut_off(tmp_path: Path, name: str, cut: int) -> None:
    path = tmp_path / "a.vtk"
    path.write_bytes((Path(__file__).parent / "data" / f"{name}.vtk").read_bytes()[:cut])
    with contextlib.suppress(BodyError):
        assert volume(read_surface(path, MOST)) == pytest.approx(1.0)  # cut off behind its shape


def test_a_body_of_a_vtk_surface(tmp_path: Path) -> None:
    """A file's kind is what it holds: the table takes what is said of surfaces, and refuses it for tetrahedra."""
    path = Path(__file__).parent / "data" / "quads_ascii_42.vtk"
    body = FileTable.make(source="the body", file=str(path), unit="cm", resolution=4, density=1000.0).build()
    assert float(body.mass.sum()) == pytest.approx(1e-3)
    assert float(body_from_surface(path, unit="cm", resolution=4).mass.sum()) == pytest.approx(1e-3)


def test_xml_in_a_file_that_says_vtk(tmp_path: Path) -> None:
    path = tmp_path / "a.vtk"
    meshio.write(path, meshio.Mesh(np.array(CORNERS, float), [("tetra", [[0, 1, 2, 3]])]), file_format="vtu")
    assert not is_surface(path)
    assert read_tetrahedra(path, MOST).elements.tolist() == [[0, 1, 2, 3]]


# Nodes with numbers of their own, two tetrahedra in groups 7 and 8, a triangle in group 9 and a point in none.
GMSH_1 = """$NOD
5
10 0 0 0
30 1 0 0
20 0 1 0
40 0 0 1
50 1 1 1
$ENDNOD
$ELM
4
1 4 7 1 4 10 30 20 40
2 4 8 1 4 30 20 40 50
3 2 9 2 3 10 30 20
4 15 0 3 1 50
$ENDELM
"""


def test_gmsh_1(tmp_path: Path) -> None:
    path = tmp_path / "a.msh"
    path.write_text(GMSH_1)
    mesh = read_tetrahedra(path, MOST)
    assert mesh.points[mesh.elements[0]].tolist() == CORNERS
    assert mesh.points[mesh.elements[1]].tolist() == [*CORNERS[1:], [1, 1, 1]]
    assert {name: sorted(map(int, members)) for name, members in mesh.sets.items()} == {
        "ref 7": [0, 1, 2, 3],
        "ref 8": [1, 2, 3, 4],
        "ref 9": [0, 1, 2],
    }


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("30 1 0 0\n", "", "it claims 5 nodes but has only 4"),
        ("$ENDELM", "", "it has no complete section \\$ELM"),
        ("20 40 50", "20 40 60", "an element refers to a node that does not exist"),
        ("$ELM\n4", "$ELM\n5", "it claims 5 elements but ends earlier"),
        ("1 4 7 1 4", "1 4 7 1 -4", "it claims 4 elements but ends earlier"),
        ("$ELM\n4", "$ELM\n999999999", "has 999999999 elements but the limit is 1000"),
        ("$NOD\n5", "$NOD\nfive", "cannot be read as MSH: it is not as the format asks for, or was cut off$"),
    ],
)
def test_gmsh_1_that_is_wrong(tmp_path: Path, old: str, new: str, said: str) -> None:
    path = tmp_path / "a.msh"
    path.write_text(GMSH_1.replace(old, new, 1))
    with pytest.raises(BodyError, match=said):
        read_tetrahedra(path, MOST)


def test_what_is_no_surface(tmp_path: Path) -> None:
    path = tmp_path / "a.vtk"
    assert not is_surface(path)
    path.mkdir()
    assert not is_surface(path)
