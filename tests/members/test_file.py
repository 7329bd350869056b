import json
from pathlib import Path

import pytest

from cotouch.errors import NetworkError, ScenarioError, SessionError
from cotouch.members import SessionFile

TETRAHEDRON = """OFF
4 4 6
0 0 0
0.1 0 0
0 0.1 0
0 0 0.1
3 0 2 1
3 0 1 3
3 1 2 3
3 0 3 2
"""
SLOTS = "[session]\nusers = 4\n"


def test_an_example_is_a_session_too() -> None:
    session = SessionFile.read("examples/five-users.toml")
    assert session.slots == 5
    assert session.named
    assert session.period(2) == 0.001
    assert not session.files


def test_slots_without_names_have_equal_springs() -> None:
    session = SessionFile.from_toml(SLOTS + "spring = 25.0\n[steps]\nrate = 200\n")
    network = session.scenario.network
    assert network.size == session.slots == 4
    assert not session.named
    assert (network.spring.sum(axis=1) == 75.0).all()
    assert session.period(3) == 1 / 200


@pytest.mark.parametrize(
    ("given", "law"),
    [
        ("", "paid"),
        ("tank = 0.1\n", "spring"),
        ('encoding = "float32"\n', "spring"),
        ('[synchronisation]\ndamping = "rule"\n', "spring"),
        ('[synchronisation]\nlaw = "wave"\n', "wave"),
    ],
)
def test_its_law_travels_with_it(given: str, law: str, tmp_path: Path) -> None:
    """Another version may have another default."""
    session = SessionFile.from_toml(SLOTS + given)
    assert session.law == law
    assert json.loads(session.content)["law"] == (None if law == "wave" else law)
    again = SessionFile.from_content(session.content, session.files, folder=tmp_path)
    assert again.law == again.scenario.synchronisation.law == law
    assert SessionFile.from_toml(SLOTS, law="spring").law == "spring"


def test_it_travels_with_its_mesh(tmp_path: Path) -> None:
    here, there = tmp_path / "here", tmp_path / "there"
    (here / "shapes").mkdir(parents=True)
    there.mkdir()
    (here / "shapes" / "t.off").write_text(TETRAHEDRON)
    (here / "s.toml").write_text(SLOTS + '[body]\nfile = "shapes/t.off"\nunit = "m"\nresolution = 4\n')
    session = SessionFile.read(here / "s.toml")
    needed = SessionFile.needed(session.content)
    assert set(needed) == {"t.off"}
    (here / "shapes" / "t.off").unlink()
    again = SessionFile.from_content(session.content, session.files, folder=there)
    assert again.digest == session.digest
    assert again.scenario.build_body().nodes > 4


AROUND = """[[bodies]]
name = "one"
file = "shapes/t.off"
unit = "m"
model = "rigid"
at = [0.0, 0.0, 0.4]
[[world.meshes]]
file = "{file}"
unit = "m"
scale = 2.0
"""


def test_it_travels_with_meshes_of_several_bodies_and_of_what_stands_still(tmp_path: Path) -> None:
    here, there = tmp_path / "here", tmp_path / "there"
    (here / "shapes").mkdir(parents=True)
    there.mkdir()
    for name in ("shapes/t.off", "floor.off", "t.off"):
        (here / name).write_text(TETRAHEDRON)
    (here / "s.toml").write_text(SLOTS + AROUND.format(file="floor.off"))
    session = SessionFile.read(here / "s.toml")
    assert set(SessionFile.needed(session.content)) == {"t.off", "floor.off"}
    for name in ("shapes/t.off", "floor.off"):
        (here / name).unlink()
    again = SessionFile.from_content(session.content, session.files, folder=there)
    assert again.scenario.build_body().nodes == 4
    assert len(again.scenario.world.obstacles()) == 1
    (here / "shapes" / "t.off").write_text(TETRAHEDRON)
    with pytest.raises(SessionError, match="files are sent without their folders, so give them different names"):
        SessionFile.from_toml(SLOTS + AROUND.format(file="t.off"), folder=here)


def test_the_digest_tells_another_mesh(tmp_path: Path) -> None:
    (tmp_path / "t.off").write_text(TETRAHEDRON)
    text = SLOTS + '[body]\nfile = "t.off"\nunit = "m"\n'
    before = SessionFile.from_toml(text, folder=tmp_path).digest
    (tmp_path / "t.off").write_text(TETRAHEDRON.replace("0.1 0 0", "0.2 0 0"))
    assert SessionFile.from_toml(text, folder=tmp_path).digest != before


@pytest.mark.parametrize(
    ("text", "error", "said"),
    [
        ("", SessionError, "neither session.users nor [network]"),
        ("[session]\nusers = 0\n", SessionError, "session.users is 0"),
        ("[session]\nusers = 4\nsprings = 3\n", SessionError, "session.springs is not an option"),
        (SLOTS + 'links = "given"\nreplan = true\n', SessionError, 'session.replan is for links = "plan"'),
        (SLOTS + "[network]\n", SessionError, "leave one of them out"),
        (SLOTS + "[steps]\nrandom = {low = 0.001, high = 0.002}\n", ScenarioError, "in a session, give a period"),
        (SLOTS + '[synchronisation]\ndamping = "exact"\n', ScenarioError, "'exact'"),
        (SLOTS + "[synchronisation]\ndamping = [1.0, 2.0]\n", ScenarioError, "[1.0, 2.0]"),
        (SLOTS + '[synchronisation]\nlaw = "once"\n', ScenarioError, 'law is "once"; a live session needs "spring"'),
        (SLOTS + "[synchronisation]\ndamping_scale = 0.5\n", ScenarioError, "below 1 nothing is guaranteed"),
        (
            SLOTS + 'encoding = "float16"\n[channel]\ncodec = {deadband = 0.1}\n',
            ScenarioError,
            'channel.codec is given and session.encoding is "float16"',
        ),
        (
            SLOTS + '[channel]\ncodec = {}\n[synchronisation]\nmode = "constant"\n',
            ScenarioError,
            'channel.codec is given, but synchronisation.mode is "constant"',
        ),
        (
            SLOTS + "[contact]\ntexture = {file = 'a.png', size = [1, 1], height = 1e-4}\n",
            ScenarioError,
            "give heights",
        ),
        ('[network]\nusers = ["a"]\n', NetworkError, "spring"),
        ("x = ", SessionError, "is not TOML"),
    ],
)
def test_what_is_wrong_is_said(text: str, error: type[Exception], said: str) -> None:
    with pytest.raises(error) as caught:
        SessionFile.from_toml(text)
    assert said in str(caught.value)


def test_a_missing_mesh_is_named(tmp_path: Path) -> None:
    with pytest.raises(SessionError, match=r"no\.stl cannot be read"):
        SessionFile.from_toml(SLOTS + '[body]\nfile = "no.stl"\nunit = "m"\n', folder=tmp_path)


@pytest.mark.parametrize(
    "content",
    [
        b"",
        b"[]",
        b"{}",
        json.dumps({"format": "cotouch session 3", "text": "", "files": {}}).encode(),
        json.dumps({"format": "cotouch session 3", "law": None, "text": "", "files": {"../x": "00" * 32}}).encode(),
        json.dumps({"format": "cotouch session 3", "law": None, "text": "", "files": {"x": "00"}}).encode(),
        json.dumps({"format": "cotouch session 3", "law": None, "text": "", "files": {"..": "00" * 32}}).encode(),
        json.dumps({"format": "cotouch session 3", "law": None, "text": 3, "files": {}}).encode(),
    ],
)
def test_what_travelled_is_checked(content: bytes) -> None:
    with pytest.raises(SessionError, match="cannot be read"):
        SessionFile.needed(content)
