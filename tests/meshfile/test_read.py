"""However the reader's process ends, its end is a mesh or a sentence, and nothing of it stays."""

import io
import struct
import threading
from pathlib import Path

import numpy as np
import psutil
import pytest
from tests.body.shapes import sphere
from tests.meshfile.inside import START, receive, send

from cotouch.errors import BodyError
from cotouch.meshfile import Mesh, read_surface


@pytest.fixture
def ball(tmp_path: Path) -> Path:
    points, triangles = sphere(1)
    path = tmp_path / "a.obj"
    lines = [f"v {x} {y} {z}" for x, y, z in points] + [f"f {a} {b} {c}" for a, b, c in triangles + 1]
    path.write_text("\n".join(lines) + "\n")
    return path


def children() -> set[int]:
    """This process's own, those that ended unwaited for included."""
    return {child.pid for child in psutil.Process().children()}


def ended(monkeypatch: pytest.MonkeyPatch, ball: Path, script: str, seconds: float = 20.0) -> str:
    """What is said of a reader that does this instead."""
    monkeypatch.setattr("cotouch.meshfile._read._START", script)
    monkeypatch.setattr("cotouch.meshfile._read.budget", lambda size: (64 << 20, seconds))
    before = children()
    with pytest.raises(BodyError) as caught:
        read_surface(ball, 1000)
    assert children() == before, "it is gone, and was waited for"
    return str(caught.value).removeprefix(f"{ball} cannot be read as OBJ: ")


def test_ends_of_a_reader(monkeypatch: pytest.MonkeyPatch, ball: Path) -> None:
    assert ended(monkeypatch, ball, "import os; os.kill(os.getpid(), 11)") == "its reader ended with signal 11"
    assert ended(monkeypatch, ball, "raise SystemExit(3)") == "its reader ended with code 3"
    killed = "that takes more than 64 MB of memory or 20 s"
    assert ended(monkeypatch, ball, "import os; os.kill(os.getpid(), 9)") == killed
    assert ended(monkeypatch, ball, "import time; time.sleep(1000)", 0.1) == "that takes longer than 0 s"
    assert ended(monkeypatch, ball, "print('{}')") == "its reader gave no answer"
    assert ended(monkeypatch, ball, "print('x' * 10_000_000)").startswith("its reader ended with code ")
    half = 'print(\'{"points": 9, "elements": [1, 3], "sets": [], "notes": []}\')'
    assert ended(monkeypatch, ball, half) == "its reader gave no answer"


def test_processor_time_is_limited(monkeypatch: pytest.MonkeyPatch, ball: Path) -> None:
    confined = START.replace("main(**given)", "confine(given['memory'], 0); any(iter(int, 1))")
    script = confined.replace("import main", "import confine")
    assert ended(monkeypatch, ball, script, 60.0) == "that takes longer than 60 s"


def test_a_reader_can_write_nothing(monkeypatch: pytest.MonkeyPatch, ball: Path) -> None:
    spoilt = str(ball.parent / "spoilt")
    confined = START.replace("main(**given)", f"confine(1 << 28, 9); open({spoilt!r}, 'w').write('x')")
    assert ended(monkeypatch, ball, confined.replace("import main", "import confine")) == "its reader gave no answer"
    assert not Path(spoilt).read_bytes()


def test_from_threads_and_from_another_folder(ball: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """What lies about in the folder that one works in is not taken for a library."""
    monkeypatch.chdir(ball.parent)
    (ball.parent / "trimesh.py").write_text("raise SystemExit('taken')")
    found: list[Mesh] = []
    threads = [threading.Thread(target=lambda: found.append(read_surface(Path(ball.name), 1000))) for _ in range(3)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert [mesh.elements.shape for mesh in found] == [(32, 3)] * 3


class TestWire:
    mesh = Mesh(
        points=np.arange(12.0).reshape(4, 3),
        elements=np.arange(4)[None],
        sets={"foot": np.array([1, 3]), "": np.zeros(0, dtype=np.int64)},
        notes=("one",),
    )

    def sent(self) -> bytes:
        out = io.BytesIO()
        send(out, self.mesh)
        return out.getvalue()

    def test_there_and_back(self) -> None:
        again = receive(io.BytesIO(self.sent()), 4, 1000)
        assert isinstance(again, Mesh)
        assert np.array_equal(again.points, self.mesh.points)
        assert np.array_equal(again.elements, self.mesh.elements)
        assert {name: chosen.tolist() for name, chosen in again.sets.items()} == {"foot": [1, 3], "": []}
        assert again.notes == ("one",)

    def test_nothing_is_believed(self) -> None:
        whole = self.sent()
        for cut in range(len(whole)):
            with pytest.raises(ValueError, match="no answer"):
                receive(io.BytesIO(whole[:cut]), 4, 1000)
        for width, most in ((3, 1000), (4, 100)):
            with pytest.raises(ValueError, match="no answer"):
                receive(io.BytesIO(whole), width, most)
        far = whole[:-16] + struct.pack("<2q", 1, 4)
        with pytest.raises(ValueError, match="no answer"):
            receive(io.BytesIO(far), 4, 1000)
        for head in (
            b'{"points": 1e400, "elements": [1, 4], "sets": [], "notes": []}',
            b'{"points": -1, "elements": [1, 4], "sets": [], "notes": []}',
            b'{"points": 99999999999, "elements": [1, 4], "sets": [], "notes": []}',
            b'{"points": 0, "elements": [1], "sets": [], "notes": []}',
            b'{"points": 0, "elements": [0, 4], "sets": 7, "notes": []}',
            b"7",
            b"[" * 100_000,
        ):
            with pytest.raises(ValueError, match="no answer"):
                receive(io.BytesIO(head + b"\n"), 4, 1000)
