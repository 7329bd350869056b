"""The server over its sockets: who is let in, what it gives, how it starts and stops."""

import asyncio
import http.client
import io
import json
import logging
import socket
import threading
import time
import xml.etree.ElementTree as ET
import zipfile
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import psutil
import pytest
import segno
from tests.web.fake_session_api import FakeSessionApi
from tests.web.reader import packed
from tests.web.visitor import PATIENCE, visit
from websockets.exceptions import InvalidStatus

from cotouch import __version__
from cotouch.errors import SessionError, TransportError
from cotouch.web import PORT, PageAddress, PageServer

PAGE = "<!doctype html><title>page</title>"


@pytest.fixture(scope="module")
def static(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("static")
    (folder / "index.html").write_text(PAGE)
    (folder / "app.js").write_text("1")
    (folder / ".secret.js").write_text("2")
    (folder / "notes.py").write_text("3")
    (folder.parent / "outside.js").write_text("4")
    return folder


@pytest.fixture(scope="module")
def api() -> FakeSessionApi:
    return FakeSessionApi("3d")


@pytest.fixture(scope="module")
def server(api: FakeSessionApi, static: Path) -> Iterator[PageServer]:
    with PageServer(api, port=0, static=static) as running:
        yield running


def get(server: PageServer, path: str, **headers: str) -> http.client.HTTPResponse:
    connection = http.client.HTTPConnection("127.0.0.1", server.port, timeout=PATIENCE)
    own = {name.replace("_", "-"): value for name, value in headers.items()}
    connection.putrequest("GET", path, skip_host="Host" in own)
    for name, value in own.items():
        connection.putheader(name, value)
    connection.endheaders()
    response = connection.getresponse()
    response.content = response.read()  # type: ignore[attr-defined]
    connection.close()
    return response


class TestFiles:
    def test_the_page_and_its_headers(self, server: PageServer):
        page = get(server, "/")
        assert (page.status, page.content.decode()) == (200, PAGE)
        policy = page.headers["Content-Security-Policy"]
        assert "default-src 'self'" in policy
        assert "frame-ancestors 'none'" in policy
        assert page.headers["Referrer-Policy"] == "no-referrer"
        assert page.headers["X-Content-Type-Options"] == "nosniff"
        assert page.headers["X-Frame-Options"] == "DENY"
        assert page.headers["Content-Type"] == "text/html; charset=utf-8"
        assert "server" not in page.headers

    def test_is_sent_once(self, server: PageServer):
        first = get(server, "/app.js")
        again = get(server, "/app.js", If_None_Match=first.headers["ETag"])
        assert (first.status, first.headers["Cache-Control"], again.status, again.content) == (
            200,
            "no-cache",
            304,
            b"",
        )

    @pytest.mark.parametrize(
        "path",
        [
            "/none.js",
            "/.secret.js",
            "/notes.py",
            "/../outside.js",
            "/%2e%2e%2foutside.js",
            "/..%5coutside.js",
            "/nul%00.js",
            pytest.param(f"/{'a' * 5_000}.js", id="a name that no disk takes"),
        ],
    )
    def test_nothing_else_is_given(self, server: PageServer, path: str):
        assert get(server, path).status == 404


class TestUnfinishedRequests:
    def test_keep_nobody_out(self, server: PageServer, monkeypatch: pytest.MonkeyPatch):
        """150 that never end; whoever asks for something gets it, and the oldest of them made room."""
        monkeypatch.setattr("cotouch.web._connection._REQUEST", 2.0 * PATIENCE)  # not because they took too long
        started = [socket.create_connection(("127.0.0.1", server.port), PATIENCE) for _ in range(150)]
        try:
            for one in started:
                one.sendall(b"GET / HTTP/1.1\r\nHost: 127.0")
            assert get(server, "/").status == 200
            with visit(server) as page:
                page.frame()
            assert ended(started[0])
            assert ended(started[150 - 64])  # as many are kept
        finally:
            for one in started:
                one.close()

    def test_end_after_a_while(self, server: PageServer, monkeypatch: pytest.MonkeyPatch):
        monkeypatch.setattr("cotouch.web._connection._REQUEST", 0.2)
        with socket.create_connection(("127.0.0.1", server.port), PATIENCE) as silent:
            assert ended(silent)
        monkeypatch.setattr("cotouch.web._connection._REQUEST", 3.0)
        with socket.create_connection(("127.0.0.1", server.port), PATIENCE) as again:
            again.sendall(f"GET / HTTP/1.1\r\nHost: 127.0.0.1:{server.port}\r\n\r\nGET /a".encode())
            assert again.recv(100).startswith(b"HTTP/1.1 200")
            assert ended(again)

    def test_and_answers_that_nobody_takes(self, api: FakeSessionApi, monkeypatch: pytest.MonkeyPatch, tmp_path: Path):
        monkeypatch.setattr("cotouch.web._connection._STUCK", 0.2)
        (tmp_path / "big.txt").write_bytes(b"a" * 20_000_000)
        with PageServer(api, port=0, static=tmp_path) as server, socket.socket() as stuck:
            stuck.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
            stuck.connect(("127.0.0.1", server.port))
            stuck.sendall(f"GET /big.txt HTTP/1.1\r\nHost: 127.0.0.1:{server.port}\r\n\r\n".encode())
            assert stuck.recv(20).startswith(b"HTTP/1.1 200")
            assert let_go(stuck)
            monkeypatch.setattr("cotouch.web._connection._STUCK", 600.0)
            fine = get(server, "/big.txt")
            assert (fine.status, len(fine.content)) == (200, 20_000_000)


class TestWhoIsLetIn:
    @pytest.mark.parametrize("path", ["/", "/app.js", "/qr.svg", "/recording.zip", "/nothing"])
    def test_not_by_a_foreign_name(self, server: PageServer, path: str):
        assert get(server, path, Host="evil.example:80").status == 403
        assert get(server, path, Origin="http://evil.example").status == 403

    @pytest.mark.parametrize("origin", ["http://evil.example", "null", None, "http://127.0.0.1:1"])
    def test_no_foreign_page(self, server: PageServer, origin: str | None):
        with pytest.raises(InvalidStatus) as refused, visit(server, origin=origin):
            pass
        assert refused.value.response.status_code == 403

    def test_no_socket_by_a_foreign_name(self, server: PageServer):
        """As after DNS rebinding: the connection comes to loopback, and the name is the attacker's, twice."""
        with socket.create_connection(("127.0.0.1", server.port), PATIENCE) as raw:
            raw.sendall(
                b"GET /ws HTTP/1.1\r\nHost: evil.example\r\nOrigin: http://evil.example\r\nConnection: Upgrade\r\n"
                b"Upgrade: websocket\r\nSec-WebSocket-Version: 13\r\n"
                b"Sec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\n\r\n"
            )
            assert raw.recv(100).startswith(b"HTTP/1.1 403")

    @pytest.mark.parametrize("token", ["", "?token=", "?token=wrong", "?token=%00"])
    def test_no_invitation_or_recording_without_token(self, server: PageServer, token: str):
        assert get(server, f"/qr.svg{token}").status == 403
        assert get(server, f"/recording.zip{token}").status == 403

    def test_the_token_is_in_no_request_and_no_log(self, server: PageServer, caplog: pytest.LogCaptureFixture):
        assert f"/#token={server.token}" in server.url
        assert server.token not in server.address
        with caplog.at_level(logging.DEBUG):
            get(server, f"/qr.svg?token={server.token}")
            with visit(server) as page:
                page.frame()
        assert [record for record in caplog.records if server.token in record.getMessage()] == []

    def test_only_loopback_listens(self, server: PageServer):
        mine = [c for c in psutil.Process().net_connections("inet") if c.status == psutil.CONN_LISTEN]
        assert [c.laddr.ip for c in mine if c.laddr.port == server.port] == ["127.0.0.1"]


class TestWithToken:
    def test_qr_code_of_the_page(self, api: FakeSessionApi, monkeypatch: pytest.MonkeyPatch):
        monkeypatch.setattr(PageAddress, "elsewhere", "http://192.0.2.7:8765/")
        with PageServer(api, port=0) as server, visit(server) as page, visit(server, token=None) as watching:
            assert page.text("scene")["page"] == "http://192.0.2.7:8765/"
            assert watching.text("scene")["page"] is None
            code = get(server, f"/qr.svg?token={server.token}&user=3")
            assert (code.status, code.headers["Content-Type"]) == (200, "image/svg+xml")
            assert code.headers["Cache-Control"] == "no-store"
            wanted = io.BytesIO()
            segno.make_qr(f"http://192.0.2.7:8765/?user=3#token={server.token}", error="l").save(wanted, kind="svg")
            path = "{http://www.w3.org/2000/svg}path"
            assert drawn(code.content).findall(path)[-1].attrib["d"] == drawn(wanted.getvalue()).find(path).attrib["d"]
            assert get(server, f"/qr.svg?token={server.token}&user=9").status == 404

    def test_no_qr_code_of_a_page_that_nobody_else_reaches(self, server: PageServer):
        assert get(server, f"/qr.svg?token={server.token}").status == 404
        with visit(server) as page:
            assert page.text("scene")["page"] is None

    def test_where_others_find_the_page(self):
        for listen, wanted in (("127.0.0.1", None), ("127.0.0.2", None), ("::1", None)):
            at = PageAddress(listen=listen, port=0)
            assert at.elsewhere == wanted
            at.close()

    def test_recording(self, server: PageServer, api: FakeSessionApi):
        assert get(server, f"/recording.zip?token={server.token}").status == 404
        with visit(server) as page:
            assert page.text("state")["recording"]["state"] == "off"
            assert head(server, f"/recording.zip?token={server.token}") == 404
            assert page.do("record", on=True)["ok"]
            assert page.text("state", lambda m: m["recording"]["state"] == "on")
            assert page.do("record", 2, on=False)["ok"]
            done = page.text("state", lambda m: m["recording"]["state"] == "done")["recording"]
            assert done["files"][0] == ["Ann.mcap", 18]
            assert head(server, f"/recording.zip?token={server.token}") == 200
        archive = get(server, f"/recording.zip?token={server.token}")
        assert archive.headers["Content-Disposition"] == 'attachment; filename="cotouch-recording.zip"'
        with zipfile.ZipFile(io.BytesIO(archive.content)) as kept:
            assert "Ann.mcap" in kept.namelist()

    def test_scene(self, server: PageServer, api: FakeSessionApi):
        body = api.scene.body
        with visit(server) as page:
            scene = page.text("scene")
        assert (scene["version"], scene["dimension"]) == (__version__, 3)
        assert scene["users"][1] == {"slot": 1, "name": "Ben"}
        assert (scene["own"], scene["acts"]) == ([0, 1, 2, 3, 4], True)
        assert (scene["invitation"], scene["may"]) == (api.scene.invitation, sorted(api.scene.may))
        np.testing.assert_allclose(packed(scene["nodes"]["rest"], "<f4", 3), body.rest, rtol=1e-6)
        np.testing.assert_allclose(packed(scene["skin"]["rest"], "<f4", 3), body.skin.vertices, rtol=1e-6, atol=1e-9)
        np.testing.assert_array_equal(packed(scene["skin"]["triangles"], "<u4", 3), body.skin.triangles)
        nearest = packed(scene["skin"]["node"], "<u4", 1)[:, 0]
        best = body.skin.weights.max(axis=1)
        weight = np.where(body.skin.nodes == nearest[:, None], body.skin.weights, 0.0).max(axis=1)
        np.testing.assert_array_equal(weight, best)
        assert scene["radius"] >= np.linalg.norm(body.skin.vertices - np.array(scene["centre"]), axis=1).max() - 1e-9

    def test_a_body_without_skin_has_edges_and_three_coordinates(self):
        with PageServer(FakeSessionApi("1d"), port=0) as other, visit(other) as page:
            scene, frame = page.text("scene"), page.frame()
        assert (scene["dimension"], scene["skin"], scene["edges"]) == (1, None, "")
        assert packed(scene["nodes"]["rest"], "<f4", 3).shape == (1, 3)
        assert frame.points == 1
        assert not frame.copies[0].displacement[:, 1:].any()


class TestStartAndStop:
    def test_two_runs_differ_and_a_port_can_be_used_again(self):
        with PageServer(FakeSessionApi("1d"), port=0) as first, visit(first) as page:
            one = page.text("scene")["started"]
        with PageServer(FakeSessionApi("1d"), port=first.port) as second, visit(second) as page:
            two = page.text("scene")["started"]
        assert (one != two, first.token != second.token, len(first.token) >= 32) == (True, True, True)

    def test_stops_with_pages_that_listen_and_pages_that_do_not(self):
        """The thread ends long before `close` gives up waiting for it."""
        before = set(threading.enumerate())
        server = PageServer(FakeSessionApi("big"), port=0)
        own = f"http://127.0.0.1:{server.port}"
        stuck = socket.create_connection(("127.0.0.1", server.port), PATIENCE)
        try:
            stuck.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
            stuck.sendall(
                f"GET /ws HTTP/1.1\r\nHost: {own[7:]}\r\nOrigin: {own}\r\nConnection: Upgrade\r\nUpgrade: websocket\r\n"
                "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\n\r\n".encode()
            )
            hello = json.dumps({"type": "hello", "version": 3}).encode()
            stuck.sendall(bytes([0x81, 0x80 | len(hello)]) + b"\0\0\0\0" + hello)
            with visit(server) as page:
                page.frame()
                server.close()
                code, _ = page.closed()
        finally:
            stuck.close()
            server.close()
        assert code == 1012  # "service restart": the page tries again
        assert not [thread for thread in set(threading.enumerate()) - before if thread.name == "cotouch-page"]
        with pytest.raises(ConnectionRefusedError):
            socket.create_connection(("127.0.0.1", server.port), 1.0).close()

    def test_pages_are_told_how_it_ended(self, static: Path):
        api = FakeSessionApi("1d")
        with PageServer(api, port=0, static=static) as server, visit(server) as page, visit(server) as other:
            page.text("state")
            other.text("state")
            api.ended = True
            server.close()
            for visitor in (page, other):
                visitor.acknowledge = False  # nobody hears it
                visitor.closed()
                assert [text for text in visitor.texts if text["type"] == "state"][-1]["ended"]

    def test_a_port_that_was_asked_for_is_not_another(self):
        with (
            PageServer(FakeSessionApi("1d"), port=0) as server,
            pytest.raises(TransportError, match=f"port {server.port}"),
        ):
            PageServer(FakeSessionApi("1d"), port=server.port)

    def test_the_next_free_port_if_none_was_asked_for(self):
        with PageServer(FakeSessionApi("1d")) as one, PageServer(FakeSessionApi("1d")) as two:
            assert PORT <= one.port < two.port < PORT + 20

    @pytest.mark.parametrize(("listen", "port"), [("127.0.0.1", 70_000), ("no such name.", 0)])
    def test_what_cannot_be(self, listen: str, port: int):
        with pytest.raises(SessionError):
            PageServer(FakeSessionApi("1d"), listen=listen, port=port)

    def test_a_port_is_held_before_there_is_anything_to_serve(self):
        at = PageAddress(port=0)
        with socket.create_connection(("127.0.0.1", at.port), PATIENCE) as early:
            early.sendall(f"GET /none HTTP/1.1\r\nHost: 127.0.0.1:{at.port}\r\n\r\n".encode())
            with PageServer(FakeSessionApi("1d"), at=at) as server:
                assert server.port == at.port
                assert early.recv(100).startswith(b"HTTP/1.1 404")

    def test_what_is_written_to_a_page_goes_out_at_once(self):
        """Else a frame after a shorter message lies until that one is acknowledged (Nagle)."""
        at = PageAddress(port=0)
        at_once: list[int] = []

        async def serve() -> None:
            async def met(_: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
                at_once.append(writer.get_extra_info("socket").getsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY))
                writer.close()

            async with await asyncio.start_server(met, sock=at.socket):
                reader, writer = await asyncio.open_connection("127.0.0.1", at.port)
                await reader.read()
                writer.close()

        asyncio.run(serve())
        at.close()
        assert at_once
        assert at_once[0] != 0

    def test_a_ticket_is_good_once(self, server: PageServer):
        ticket = server.ticket()
        assert server.token not in ticket
        path = ticket.removeprefix(server.address.rstrip("/"))
        first, second = get(server, path), get(server, path)
        assert (first.status, first.headers["Location"]) == (303, f"/#token={server.token}")
        assert (second.status, second.headers["Location"]) == (303, "/")
        assert get(server, "/open").headers["Location"] == "/"

    def test_elsewhere_only_when_told(self):
        with PageServer(FakeSessionApi("1d"), listen="127.0.0.2", port=0) as server:
            assert server.local
            assert get_status("127.0.0.2", server.port, "127.0.0.2") == 404  # let in; this folder may have no page
            assert get_status("127.0.0.2", server.port, "evil.example") == 403


def drawn(picture: bytes) -> ET.Element:
    return ET.fromstring(picture)


def ended(connection: socket.socket) -> bool:
    """Whether the server closes it, within the patience of its socket."""
    try:
        while connection.recv(65_536):
            pass
    except ConnectionResetError:
        pass
    return True


def let_go(connection: socket.socket) -> bool:
    """Whether the server, in this process, gives its end up; the client is not told before it reads on."""
    for _ in range(600):
        ends = {one.raddr for one in psutil.Process().net_connections("tcp")}
        if connection.getsockname() not in ends:
            return True
        time.sleep(0.1)
    return False


def head(server: PageServer, path: str) -> int:
    connection = http.client.HTTPConnection("127.0.0.1", server.port, timeout=PATIENCE)
    connection.request("HEAD", path)
    status = connection.getresponse().status
    connection.close()
    return status


def get_status(address: str, port: int, host: str) -> int:
    connection = http.client.HTTPConnection(address, port, timeout=PATIENCE)
    connection.request("GET", "/none", headers={"Host": host})
    status = connection.getresponse().status
    connection.close()
    return status
