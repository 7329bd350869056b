"""What is kept: whole, for its owner alone, and only as it was signed."""

import json
import os
import stat
from pathlib import Path

import pytest
from tests.members.test_succession import BEN, HOST, MEMBERS, ROOT, api, root
from tests.session.inside import KeptHost, KeptIdentity, identity_of, keep_host, kept_host
from tests.session.world import entropy

from cotouch.control import Endpoint, Invitation
from cotouch.errors import OutputError, SessionError, TransportError
from cotouch.members import Participation, SessionFile

SESSION = SessionFile.from_toml("[session]\nusers = 3\n[body]\nmass = 0.5\n")
INVITATION = Invitation.make(
    session="kept",
    digest=SESSION.digest,
    host=HOST.public,
    endpoints=(Endpoint("127.0.0.1", 7447),),
    entropy=entropy(1),
)


def test_a_host_is_kept_with_what_it_signed_last(tmp_path: Path) -> None:
    path = tmp_path / "host.json"
    for kept in (KeptHost(HOST, INVITATION, None), KeptHost(HOST, INVITATION, root())):
        keep_host(path, kept)
        assert kept_host(path, SESSION) == kept
        assert stat.S_IMODE(path.stat().st_mode) == 0o600
    assert [entry.name for entry in tmp_path.iterdir()] == ["host.json"]


def test_a_roster_that_the_host_did_not_sign_is_not_gone_on_from(tmp_path: Path) -> None:
    path = tmp_path / "host.json"
    keep_host(path, KeptHost(HOST, INVITATION, root()))
    kept = json.loads(path.read_text())
    kept["decided"]["roster"]["members"][0]["key"] = "e" * 64
    kept["decided"]["roster"]["names"] = []
    path.write_text(json.dumps(kept))
    with pytest.raises(SessionError, match="did not sign"):
        kept_host(path, SESSION)
    keep_host(path, KeptHost(HOST, INVITATION, api(BEN, ROOT)))
    with pytest.raises(SessionError, match="did not sign"):
        kept_host(path, SESSION)
    keep_host(path, KeptHost(BEN, INVITATION, None))  # whose invitation names another
    with pytest.raises(SessionError, match="another session"):
        kept_host(path, SESSION)
    keep_host(path, KeptHost(HOST, INVITATION, None))
    other = SessionFile.from_toml("[session]\nusers = 4\n")
    with pytest.raises(SessionError, match="another session"):
        kept_host(path, other)
    for text in ("", "{}", "[" * 10_000, "null", "é"):
        path.write_bytes(text.encode("latin-1"))
        with pytest.raises(SessionError, match="does not hold the keys"):
            kept_host(path, SESSION)


def test_what_cannot_be_written_leaves_what_was_there(tmp_path: Path) -> None:
    path = tmp_path / "host.json"
    keep_host(path, KeptHost(HOST, INVITATION, None))
    before = path.read_bytes()
    with pytest.raises(OutputError, match="name too long"):
        keep_host(tmp_path / ("x" * 300), KeptHost(HOST, INVITATION, None))
    assert path.read_bytes() == before
    assert [entry.name for entry in tmp_path.iterdir()] == ["host.json"]
    assert len(MEMBERS) == 3


def test_who_comes_back_is_who_it_was_and_two_at_once_are_two(tmp_path: Path) -> None:
    folder = tmp_path / "state" / "identities"
    one = KeptIdentity(folder, b"session", "Ann", entropy(1))
    beside = KeptIdentity(folder, b"session", "Ann", entropy(2))
    assert beside.identity != one.identity
    beside.close()
    one.close()  # as a killed process does
    again = KeptIdentity(folder, b"session", "Ann", entropy(3))
    assert again.identity == one.identity
    other = KeptIdentity(folder, b"session", "Ben", entropy(4))
    elsewhere = KeptIdentity(folder, b"another", "Ann", entropy(5))
    assert len({again.identity.public, other.identity.public, elsewhere.identity.public}) == 3
    assert {stat.S_IMODE(path.stat().st_mode) for path in folder.iterdir()} == {0o600}
    for kept in (again, other, elsewhere):
        kept.close()


def test_a_broken_identity_is_made_anew_and_a_folder_that_is_none_is_said(tmp_path: Path) -> None:
    one = KeptIdentity(tmp_path, b"session", "Ann", entropy(1))
    one.close()
    for path in tmp_path.glob("*.json"):
        path.write_text('{"identity": "00"}')
    again = KeptIdentity(tmp_path, b"session", "Ann", entropy(2))
    assert again.identity != one.identity
    again.close()
    (tmp_path / "file").write_text("")
    with pytest.raises(TransportError, match="your identity cannot be stored in"):
        KeptIdentity(tmp_path / "file", b"session", "Ann", entropy(1))


def test_a_key_that_cannot_be_kept_keeps_nobody_out(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    warned: list[str] = []
    part = Participation(name="Ann", version="test", identities=tmp_path / "file")
    with identity_of(INVITATION, part, warned.append) as identity:
        assert len(identity.public) == 32
    assert len(warned) == 1
    assert warned[0].endswith("after a crash, use another name")


def test_an_identity_of_another_week_is_let_go_of(tmp_path: Path) -> None:
    for name in ("old", "new"):
        KeptIdentity(tmp_path, name.encode(), "Ann", entropy(1)).close()
        for path in tmp_path.glob("*.json") if name == "old" else ():
            os.utime(path, (0, 0))
    assert len(list(tmp_path.glob("*.json"))) == len(list(tmp_path.glob("*.lock"))) == 1
