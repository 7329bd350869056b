"""Every format, and everything that a file can be instead of a mesh: one sentence, never an exit, nothing printed."""

import json
import re
import struct
from pathlib import Path
from typing import Any

import meshio
import numpy as np
import pytest
import trimesh
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from tests.body.shapes import block, box, sphere, volume
from tests.meshfile.here import parse_here, promised_elements
from tests.thorough import examples

from cotouch.body import MOST_ELEMENTS, MOST_TRIANGLES, NodeSet, body_from_surface, body_from_tetrahedra
from cotouch.errors import BodyError
from cotouch.meshfile import SURFACES, VOLUMES

SPHERE = sphere(2)
HUGE = 10_000_000


@pytest.fixture(autouse=True)
def here(monkeypatch: pytest.MonkeyPatch) -> None:
    """What its own process adds is tested with it, in `tests/meshfile`."""
    parse_here(monkeypatch)


def written(folder: Path, name: str) -> Path:
    """A sphere in one of the surface formats."""
    path = folder / name
    mesh = trimesh.Trimesh(*SPHERE, process=False)
    mesh.export(path, file_type="stl_ascii" if name.startswith("text") else None)
    return path


@pytest.mark.parametrize("name", ["a.stl", "text.stl", "a.obj", "a.ply", "a.off", "a.glb", "A.STL"])
def test_surface_formats(tmp_path: Path, name: str):
    path = written(tmp_path, name)
    unit: Any = None if name.endswith("glb") else "cm"
    body = body_from_surface(str(path), unit=unit, resolution=6)
    assert body.origin is not None
    scale = 1.0 if unit is None else 1e-6
    assert body.origin.volume == pytest.approx(scale * volume(*SPHERE), rel=1e-5)
    assert all(note.startswith("Its moments of inertia") for note in body.origin.notes[:-1])
    assert promised_elements(path) == len(SPHERE[1])
    with pytest.raises(BodyError, match=f"has {len(SPHERE[1])} triangles but the limit is 100"):
        body_from_surface(path, unit=unit, most_triangles=100)


def test_gltf_is_in_metres(tmp_path: Path):
    path = written(tmp_path, "a.glb")
    assert np.array_equal(body_from_surface(path, unit="m").rest, body_from_surface(path).rest)
    with pytest.raises(BodyError, match=r'the unit of .*a.glb is "mm", but glTF files are always in metres'):
        body_from_surface(path, unit="mm")


def test_a_unit_is_asked_for(tmp_path: Path):
    with pytest.raises(BodyError, match=r"the unit of .*a.stl is not given, and the mesh does not state it"):
        body_from_surface(written(tmp_path, "a.stl"))


@pytest.mark.parametrize(
    ("name", "options"),
    [
        ("a.vtk", {}),
        ("a.vtk", {"binary": False}),
        ("a.vtk", {"file_format": "vtk42"}),
        ("a.vtu", {}),
        ("a.vtu", {"binary": False}),
        ("a.msh", {"file_format": "gmsh"}),
        ("a.msh", {"file_format": "gmsh", "binary": False}),
        ("a.msh", {"file_format": "gmsh22"}),
        ("a.msh", {"file_format": "gmsh22", "binary": False}),
        ("a.mesh", {"file_format": "medit"}),
    ],
)
def test_volume_formats(tmp_path: Path, name: str, options: dict[str, Any], capfd: pytest.CaptureFixture[str]):
    points, elements = block()
    path = tmp_path / name
    meshio.Mesh(points, [("tetra", elements)]).write(path, **options)
    capfd.readouterr()
    body = body_from_tetrahedra(path, unit="m")
    assert capfd.readouterr() == ("", "")
    assert body.origin is not None
    assert (body.nodes, body.origin.elements) == (len(points), len(elements))
    assert body.origin.volume == pytest.approx(0.3 * 0.1 * 0.1)
    assert promised_elements(path) == len(elements)
    with pytest.raises(BodyError, match=f"has {len(elements)} elements but the limit is 10; make it coarser, or raise"):
        body_from_tetrahedra(path, unit="m", most_elements=10)


class TestSets:
    points, elements = block()
    end = np.flatnonzero(points[:, 0] < 1e-9)

    def held(self, path: Path, name: str) -> np.ndarray:
        body = body_from_tetrahedra(path, unit="m", ground=NodeSet(name=name), ground_stiffness=1.0)
        assert body.origin is not None
        return body.origin.held

    def test_marks_on_points(self, tmp_path: Path):
        mark = (self.points[:, 0] < 1e-9).astype(np.int32)
        meshio.Mesh(self.points, [("tetra", self.elements)], point_data={"clamp": mark, "heat": mark * 0.5}).write(
            tmp_path / "a.vtu"
        )
        assert np.array_equal(self.held(tmp_path / "a.vtu", "clamp"), self.end)
        with pytest.raises(BodyError, match='the ground is the set "heat"; the sets of this mesh are: "clamp"'):
            self.held(tmp_path / "a.vtu", "heat")

    def test_physical_groups(self, tmp_path: Path):
        faces = np.array([[self.end[0], self.end[1], self.end[3]]])
        mesh = meshio.Mesh(
            self.points,
            [("triangle", faces), ("tetra", self.elements)],
            cell_data={
                "gmsh:physical": [np.array([7]), np.full(len(self.elements), 8)],
                "gmsh:geometrical": [np.array([1]), np.full(len(self.elements), 1)],
            },
            field_data={"foot": np.array([7, 2]), "whole": np.array([8, 3])},
        )
        mesh.write(tmp_path / "a.msh", file_format="gmsh22", binary=False)
        assert self.held(tmp_path / "a.msh", "foot").tolist() == sorted(faces[0])
        assert self.held(tmp_path / "a.msh", "whole").size == len(self.points)

    def test_references(self, tmp_path: Path):
        marks = np.where(self.points[self.elements][:, :, 0].max(axis=1) < 0.06, 3, 1)
        meshio.Mesh(self.points, [("tetra", self.elements)], cell_data={"medit:ref": [marks]}).write(
            tmp_path / "a.mesh", file_format="medit"
        )
        assert self.held(tmp_path / "a.mesh", "ref 3").size == 18


def test_quadratic_tetrahedra_by_their_corners(tmp_path: Path):
    corners = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], dtype=float)
    middles = [(corners[a] + corners[b]) / 2 for a, b in ((0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3))]
    meshio.Mesh(np.vstack([corners, middles]), [("tetra10", np.arange(10)[None])]).write(tmp_path / "a.vtu")
    body = body_from_tetrahedra(tmp_path / "a.vtu", unit="m")
    assert body.nodes == 4
    assert body.origin is not None
    assert body.origin.notes[:2] == (
        "Quadratic tetrahedra are used by their corners only.",
        "6 points in no tetrahedron left out.",
    )


@pytest.mark.parametrize(
    ("cells", "message"),
    [
        ([("triangle", [[0, 1, 2]])], "has no tetrahedra but 1 triangle; make a tetrahedral mesh of it"),
        ([("hexahedron", [list(range(8))])], "has no tetrahedra but 1 hexahedron"),
        ([("tetra", [[0, 1, 2, 4]]), ("hexahedron", [list(range(8))])], "has 1 hexahedron besides its tetrahedra"),
    ],
)
def test_other_cells_are_refused(tmp_path: Path, cells: Any, message: str):
    meshio.Mesh(box()[0], cells).write(tmp_path / "a.vtk")
    with pytest.raises(BodyError, match=re.escape(message)):
        body_from_tetrahedra(tmp_path / "a.vtk", unit="m")


PNG = b"\x89PNG\r\n\x1a\n" + bytes(range(256)) * 8


@pytest.mark.parametrize("suffix", SURFACES + VOLUMES)
@pytest.mark.parametrize("content", [PNG, b"hello\n", b"solid nothing\nendsolid nothing\n", b"\x00" * 500, b"\n" * 90])
def test_not_a_mesh(tmp_path: Path, suffix: str, content: bytes, capfd: pytest.CaptureFixture[str]):
    path = tmp_path / f"a{suffix}"
    path.write_bytes(content)
    build = body_from_surface if suffix in SURFACES else body_from_tetrahedra
    with pytest.raises(BodyError, match=r"a\.\w+ (cannot be read as|has \d+ points but no tri|has no tetra)") as caught:
        build(path, unit=None if suffix == ".glb" else "m")
    assert "\n" not in str(caught.value)
    assert capfd.readouterr() == ("", "")


@settings(suppress_health_check=[HealthCheck.function_scoped_fixture], max_examples=examples(200))
@given(suffix=st.sampled_from(SURFACES + VOLUMES), cut=st.floats(0.0, 1.0), seed=st.integers(0, 10_000))
def test_damaged_files_never_raise_anything_else(tmp_path: Path, suffix: str, cut: float, seed: int):
    """A file cut off, with a few bytes changed."""
    path = tmp_path / f"whole{suffix}"
    if not path.exists():
        if suffix in SURFACES:
            written(tmp_path, path.name)
        else:
            points, elements = block((2, 1, 1))
            formats = {".msh": "gmsh", ".mesh": "medit"}
            meshio.Mesh(points, [("tetra", elements)]).write(path, file_format=formats.get(suffix))
    rng = np.random.default_rng(seed)
    content = bytearray(path.read_bytes())
    content = content[: max(1, int(cut * len(content)))]
    for place in rng.integers(0, len(content), size=3):
        content[place] = rng.integers(0, 256)
    damaged = tmp_path / f"damaged{suffix}"
    damaged.write_bytes(content)
    build: Any = body_from_surface if suffix in SURFACES else body_from_tetrahedra
    options: Any = {"resolution": 3} if suffix in SURFACES else {}
    try:
        build(damaged, unit=None if suffix == ".glb" else "m", most_nodes=10_000, **options)
    except BodyError as error:
        assert "\n" not in str(error)  # noqa: PT017


def sparse(path: Path, head: bytes, size: int) -> Path:
    """A file of that size that takes no room on the disk."""
    with path.open("wb") as file:
        file.write(head)
        file.truncate(size)
    return path


class TestTooMany:
    """Ten million elements are refused by their number alone: most of these files hold nothing else."""

    def surface(self, path: Path) -> str:
        with pytest.raises(BodyError) as caught:
            body_from_surface(path, unit=None if path.suffix == ".glb" else "mm")
        return str(caught.value)

    def message(self, path: Path) -> str:
        return (
            f"{path} has {HUGE} triangles but the limit is {MOST_TRIANGLES}; make it coarser, or raise most_triangles"
        )

    def test_binary_stl(self, tmp_path: Path):
        path = sparse(tmp_path / "a.stl", b" " * 80 + struct.pack("<I", HUGE), 84 + 50 * HUGE)
        assert self.surface(path) == self.message(path)

    def test_ply_and_off(self, tmp_path: Path):
        head = f"ply\nformat binary_little_endian 1.0\nelement vertex 9\nproperty float x\nelement face {HUGE}\n"
        path = sparse(tmp_path / "a.ply", head.encode(), 1000)
        assert self.surface(path) == self.message(path)
        path = sparse(tmp_path / "a.off", f"OFF # made up\n# more\n9 {HUGE} 0\n".encode(), 1000)
        assert self.surface(path) == self.message(path)

    def test_glb(self, tmp_path: Path):
        tree = {"accessors": [{"count": 3 * HUGE}], "meshes": [{"primitives": [{"indices": 0, "attributes": {}}]}]}
        chunk = json.dumps(tree).encode()
        head = b"glTF" + struct.pack("<II", 2, 20 + len(chunk)) + struct.pack("<I", len(chunk)) + b"JSON" + chunk
        path = sparse(tmp_path / "a.glb", head, len(head))
        assert self.surface(path) == self.message(path)

    def test_text_is_counted_line_by_line(self, tmp_path: Path):
        path = tmp_path / "a.obj"
        path.write_bytes(b"v 0 0 0\n" + b"f 1 1 1\n" * 400_000)
        assert promised_elements(path) == 400_000
        with pytest.raises(BodyError, match="has 400000 triangles but the limit is 300000"):
            body_from_surface(path, unit="m", most_triangles=300_000)
        path = tmp_path / "a.stl"
        path.write_bytes(b"solid x\n" + b"facet\nendfacet\n" * 200_000 + b"endsolid x\n")
        assert promised_elements(path) == 200_000

    @pytest.mark.parametrize(
        ("name", "head"),
        [
            ("a.vtk", f"# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nCELL_TYPES {HUGE}\n"),
            ("a.vtu", f'<VTKFile type="UnstructuredGrid"><Piece NumberOfPoints="4" NumberOfCells="{HUGE}">\n'),
            ("a.msh", f"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Elements\n{HUGE}\n"),
            ("b.msh", f"$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Elements\n1 {HUGE} 1 {HUGE}\n"),
            ("a.mesh", f"MeshVersionFormatted 2\nDimension 3\nTetrahedra\n{HUGE}\n"),
        ],
    )
    def test_tetrahedra(self, tmp_path: Path, name: str, head: str):
        path = sparse(tmp_path / name, head.encode(), 2000)
        with pytest.raises(BodyError) as caught:
            body_from_tetrahedra(path, unit="m")
        limit = f"the limit is {MOST_ELEMENTS}; make it coarser, or raise most_elements"
        assert str(caught.value) == f"{path} has {HUGE} elements but {limit}"

    def test_a_file_too_big_to_be_so_few(self, tmp_path: Path):
        path = sparse(tmp_path / "a.obj", b"v 0 0 0\n", 2_000_000_000)
        assert self.surface(path).startswith(f"{path} has 2000 MB, more than a mesh of {MOST_TRIANGLES} elements needs")


def test_missing_empty_folder_and_suffix(tmp_path: Path):
    with pytest.raises(BodyError, match=r"the mesh .*none.stl cannot be read: No such file"):
        body_from_surface(tmp_path / "none.stl", unit="m")
    (tmp_path / "empty.stl").touch()
    with pytest.raises(BodyError, match=r"the mesh .*empty.stl is empty"):
        body_from_surface(tmp_path / "empty.stl", unit="m")
    (tmp_path / "folder.stl").mkdir()
    with pytest.raises(BodyError, match=r"the mesh .*folder.stl cannot be read: it is a folder"):
        body_from_surface(tmp_path / "folder.stl", unit="m")
    with pytest.raises(BodyError, match=r'ends in ".vtu"; a surface mesh must be one of .stl, .obj'):
        body_from_surface("a.vtu", unit="m")
    with pytest.raises(BodyError, match=r'ends in ".stl"; a tetrahedral mesh must be one of .vtk, .vtu'):
        body_from_tetrahedra("a.stl", unit="m")


def test_points_alone_are_no_surface(tmp_path: Path):
    (tmp_path / "a.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\n")
    with pytest.raises(BodyError, match=r"a.obj (has \d points but no triangles|cannot be read)"):
        body_from_surface(tmp_path / "a.obj", unit="m")
