"""Pages and their server: what they are sent, what they may do, and which of them leads a hand."""

import asyncio
import contextlib
import json
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.thorough import examples
from tests.web.fake_session_api import FakeSessionApi
from tests.web.inside import VERSION, Access, FrameReceipt, Hub, Page
from tests.web.reader import ack, pointer
from tests.web.visitor import Visitor, visit
from websockets.exceptions import ConnectionClosed

from cotouch.errors import SessionError
from cotouch.observers import Cut, Pointer
from cotouch.web import Hello, PageServer

WORDS = ["hand", "impair", "cut", "kill", "revive", "links", "damping", "record", "control"]


@pytest.fixture
def api() -> FakeSessionApi:
    return FakeSessionApi("3d")


@pytest.fixture
def server(api: FakeSessionApi) -> Iterator[PageServer]:
    with PageServer(api, port=0) as running:
        yield running


def control(page: Visitor, how: str) -> None:
    page.text("state", lambda m: m["control"] == how)


class TestFrames:
    def test_come_with_every_copy(self, server: PageServer):
        with visit(server) as page:
            first, second = page.frame(), page.frame()
        assert sorted(second.copies) == [0, 1, 2, 3, 4]
        assert second.number > first.number
        assert second.time > first.time >= 0.0
        assert second.points == 1924

    def test_come_with_one_copy_if_that_is_asked_for(self, server: PageServer):
        with visit(server, want="mine", slot=3) as page:
            assert sorted(page.frame().copies) == [3]

    def test_no_more_than_two_on_the_way_and_then_the_newest(self, server: PageServer):
        with visit(server, hello=False) as slow, visit(server) as quick:
            slow.acknowledge = False
            slow.hello()
            for _ in range(5):
                slow.text("state")
            assert len(slow.frames) == 2
            newest = quick.frame(lambda f: f.number > slow.frames[-1].number + 20).number
            slow.say(ack(slow.frames[0].number))
            assert slow.frame().number > newest - 2
            for _ in range(5):
                slow.text("state")
            assert len(slow.frames) == 3
            slow.say(ack(slow.frames[-1].number))  # of all before it, too
            slow.frame()
            slow.frame()

    def test_a_page_that_takes_nothing_gets_the_newest_when_it_does(self):
        """What is handed over while a frame is on its way out replaces what waits."""

        class Socket:
            def __init__(self) -> None:
                self.sent: list[Any] = []
                self.open = asyncio.Event()

            async def send_bytes(self, data: bytes) -> None:
                self.sent.append(data)
                await self.open.wait()

            async def send_text(self, data: str) -> None:
                self.sent.append(data)

        async def play() -> tuple[list[Any], int]:
            socket = Socket()
            page = Page(socket)  # type: ignore[arg-type]
            sender = asyncio.create_task(page.send_all())
            for number in range(5):
                page.offer(number, bytes([number]), float(number))
                page.show(f"state {number}")
                await asyncio.sleep(0)
                await asyncio.sleep(0)
            socket.open.set()
            for _ in range(10):
                await asyncio.sleep(0)
            sender.cancel()
            await asyncio.gather(sender, return_exceptions=True)
            return socket.sent, page.skipped

        sent, skipped = asyncio.run(play())
        assert sent == [b"\0", "state 4", b"\4"]
        assert skipped == 3

    @given(
        sent=st.floats(0.0, 0.02),
        wait=st.floats(0.0, 0.5),
        every=st.floats(1e-3, 0.5),
        period=st.floats(1 / 240, 0.2),
    )
    def test_the_next_is_due_when_a_screen_wants_it_and_not_too_early(self, sent, wait, every, period):
        page = Page(None)  # type: ignore[arg-type]
        now = 7.0
        page.period, page.due = period, now - sent
        page.offer(1, b"", now - sent)
        page.acknowledged(FrameReceipt(1, 0.0, 0.0), now)
        assert page.due == now - sent + period  # as long as the screen is not known
        page.acknowledged(FrameReceipt(1, wait, every), now)
        pictures = (page.due - now - wait) / every
        assert pictures == pytest.approx(round(pictures), abs=1e-6)
        soonest = now - sent + 0.65 * period
        assert page.due >= max(now + wait, soonest) - 1e-9
        assert page.due < max(now + wait, soonest + every) + 1e-9

    def test_come_when_a_screen_wants_them(self):
        """A little sooner or later than they would by themselves, which is after 0.1 s less what the last one took."""

        async def play(wanted: float) -> list[float]:
            times: list[float] = []
            api = FakeSessionApi("1d")
            api.views = dict  # of which a frame is made at once
            hub, page = Hub(api, Access(listen="127.0.0.1", token="t" * 32)), Page(None)  # type: ignore[arg-type]
            offer = page.offer

            def offered(number: int, frame: bytes, now: float) -> None:
                offer(number, frame, now)
                times.append(now)
                asyncio.get_running_loop().call_soon(hub.acknowledged, page, FrameReceipt(number, wanted, 0.4))

            page.offer = offered
            hub.enter(page)
            hub.hello(page, Hello(type="hello", version=VERSION, rate=10.0))
            while len(times) < 4:
                await asyncio.sleep(0.01)
            hub.leave(page)
            hub.close()
            return times

        for wanted in np.arange(0.086, 0.104, 0.002):
            gaps = np.diff(asyncio.run(play(wanted)))
            assert gaps.min() >= wanted - 0.0006

    def test_a_copy_that_is_gone_is_not_shown(self, server: PageServer):
        with visit(server) as page:
            assert page.do("kill", slot=2)["ok"]
            assert sorted(page.frame(lambda f: len(f.copies) < 5).copies) == [0, 1, 3, 4]
            state = page.text("state", lambda m: m["members"]["2"]["alive"] is False)
            assert not state["members"]["2"]["here"]


class TestPointer:
    def test_reaches_the_stage_and_comes_back(self, server: PageServer, api: FakeSessionApi):
        with visit(server) as page:
            scene = page.text("scene")
            page.say(pointer(77, point=1500, target=(0.2, 0.1, 0.3), stiffness=80.0))
            frame = page.frame(lambda f: f.echo == 77)
            assert frame.copies[0].mode == "grab"
            assert frame.waited_us > 0
            slot, commanded = api.pointers[0]
            assert (slot, commanded.mode, commanded.stiffness) == (0, "grab", 80.0)
            skin = api.scene.body.skin
            best = skin.nodes[1500][skin.weights[1500].argmax()]
            assert commanded.node == best == frame.copies[0].node
            # The node goes as far beside the target as it is beside the point at rest: taking hold does not pull.
            beside = skin.vertices[1500] - api.scene.body.rest[best]
            assert np.abs(beside).max() > 1e-4
            assert commanded.target == pytest.approx(tuple(np.array([0.2, 0.1, 0.3]) - beside), abs=1e-7)
            assert scene["skin"]["vertices"] == frame.points
            page.say(pointer(78, action=0, radius=0.02))
            assert page.frame(lambda f: f.echo == 78).copies[0].mode == "ball"
            page.say(pointer(79, action=2))
            assert page.frame(lambda f: f.echo == 79).copies[0].mode == "free"
            assert page.text("state", lambda m: m["members"]["0"]["hand"] == "free")

    def test_that_stands_still_is_told_again(self, server: PageServer, api: FakeSessionApi):
        with visit(server) as page:
            page.say(pointer(5, point=9, target=(0.1, 0.0, 0.0)))
            for _ in range(4):
                page.text("state")
            commanded = [p for slot, p in api.pointers if slot == 0]
            assert len(commanded) >= 3
            assert [p.number for p in commanded] == sorted({p.number for p in commanded})
            assert {(p.mode, p.node, p.target) for p in commanded} == {("grab", commanded[0].node, commanded[0].target)}
            assert page.frame().echo == 5
            page.say(pointer(6, action=2))
            page.frame(lambda f: f.echo == 6)
            count = len(api.pointers)
            for _ in range(3):
                page.text("state")
            assert len(api.pointers) == count

    def test_of_a_page_that_goes_lets_go(self, server: PageServer, api: FakeSessionApi):
        with visit(server) as page, visit(server, slot=1) as other:
            page.say(pointer(1))
            page.frame(lambda f: f.echo == 1)
            page.connection.close()
            other.text("state", lambda m: m["pages"] == 1)
            assert api.pointers[-1][1].mode == "free"

    def test_of_a_page_that_is_served_when_the_server_stops_lets_go(self, api: FakeSessionApi):
        with PageServer(api, port=0) as server, visit(server) as page:
            page.say(pointer(1))
            page.frame(lambda f: f.echo == 1)
            server.close()
        assert api.pointers[-1][1].mode == "free"

    def test_that_the_stage_does_not_take_is_explained(self, server: PageServer, api: FakeSessionApi):
        def refuse(slot: int, pointer: Pointer) -> None:
            raise SessionError("too far away")

        api.point = refuse  # type: ignore[method-assign]
        with visit(server) as page:
            page.say(pointer(1))
            assert page.text("answer") == {"type": "answer", "id": 0, "ok": False, "text": "too far away"}
            page.frame()


class TestToken:
    @pytest.mark.parametrize("token", [None, "", "wrong"])
    def test_without_it_a_page_watches_and_no_more(self, server: PageServer, api: FakeSessionApi, token: str | None):
        with visit(server, token=token) as page:
            scene = page.text("scene")
            assert (scene["invitation"], scene["may"], scene["acts"]) == (None, [], False)
            assert api.scene.invitation not in json.dumps(page.texts)
            for number, what in enumerate(WORDS, 1):
                commanded = page.do(what, number, slot=0, mode="free", a=0, b=1, on=True, fraction=0.5, choice="best")
                assert not commanded["ok"]
                assert "token" in commanded["text"]
            page.say(pointer(1))
            page.say(pointer(2))
            page.text("answer", lambda m: m["id"] == 0)
            page.frame()
            assert page.text("state")["control"] == "none"
        assert (api.pointers, api.done) == ([], [])

    def test_may_come_later(self, server: PageServer):
        with visit(server, token=None) as page:
            page.text("scene")
            page.hello(token=server.token, slot=0)
            assert page.text("scene")["acts"]
            control(page, "mine")


class TestControl:
    def test_of_two_pages_for_one_slot_one_leads(self, server: PageServer, api: FakeSessionApi):
        with visit(server) as one:
            control(one, "mine")
            with visit(server) as two:
                control(two, "other")
                two.say(pointer(1))
                two.frame()
                two.frame()
                assert api.pointers == []
                commanded = two.do("kill", slot=4)
                assert not commanded["ok"]
                assert "control" in commanded["text"]
                one.say(pointer(50))
                one.frame(lambda f: f.echo == 50)
                assert two.do("control")["ok"]
                control(two, "mine")
                control(one, "other")
                assert api.pointers[-1][1].mode == "free"  # what the first held was let go
                two.say(pointer(1))
                two.frame(lambda f: f.echo == 1)
                assert api.pointers[-1][1].mode == "grab"
                assert two.frames[-1].echo == 1
                count = len(api.pointers)
                one.say(pointer(51, target=(9.0, 0.0, 0.0)))
                one.frame()
                one.frame()
                assert (9.0, 0.0, 0.0) not in [p.target for _, p in api.pointers[count:]]
            control(one, "mine")

    def test_numbers_rise_over_pages(self, server: PageServer, api: FakeSessionApi):
        with visit(server) as one:
            one.say(pointer(1000))
            one.frame(lambda f: f.echo == 1000)
        with visit(server) as two:
            control(two, "mine")
            two.say(pointer(1))
            two.frame(lambda f: f.echo == 1)
        numbers = [p.number for _, p in api.pointers]
        assert numbers == sorted(set(numbers))

    def test_different_slots_have_different_pages(self, server: PageServer, api: FakeSessionApi):
        with visit(server, slot=0) as one, visit(server, slot=1) as two:
            control(one, "mine")
            control(two, "mine")
            one.say(pointer(3, slot=0))
            two.say(pointer(4, slot=1))
            one.frame(lambda f: f.echo == 3)
            two.frame(lambda f: f.echo == 4)
            two.say(pointer(5, slot=0))  # not its own
            two.frame()
            two.frame()
            commanded = one.do("hand", slot=1, mode="free")
            assert not commanded["ok"]
            assert "user 2" in commanded["text"]
            assert one.do("hand", 2, slot=2, mode="hold")["ok"]
        assert {(slot, p.mode) for slot, p in api.pointers} == {(0, "grab"), (1, "grab"), (0, "free"), (1, "free")}

    def test_saying_hello_again_keeps_it_and_another_slot_does_not(self, server: PageServer, api: FakeSessionApi):
        with visit(server) as one, visit(server) as two:
            control(two, "other")
            one.say(pointer(1))
            one.frame(lambda f: f.echo == 1)
            one.hello(token=server.token, slot=0, rate=5)
            two.text("state")
            control(two, "other")
            assert {p.mode for _, p in api.pointers} == {"grab"}
            one.hello(token=server.token, slot=3)
            control(two, "mine")
            control(one, "mine")
            assert api.pointers[-1][1].mode == "free"
        assert [m["type"] for m in one.texts].count("scene") == 1


class TestDo:
    def test_what_is_asked_for_is_done_and_said(self, server: PageServer, api: FakeSessionApi):
        with visit(server) as page:
            commanded = page.do("cut", 9, a=3, b=1, on=True)
            assert (commanded["ok"], commanded["text"]) == (True, "the link of Dan and Ben is cut")
            assert page.text("state", lambda m: m["emulated"]["1-3"]["cut"] and m["ends"]["3-1"]["state"] == "guarded")
        assert api.done == [Cut(a=3, b=1, on=True)]

    @pytest.mark.parametrize(
        ("what", "arguments", "word"),
        [
            ("cut", {"a": 0}, "missing"),
            ("damping", {"fraction": 7}, "fraction is 7; it must be above 0"),
            ("fly", {}, '"fly"'),
        ],
    )
    def test_what_cannot_be_done_is_explained(self, server: PageServer, what: str, arguments: dict, word: str):
        with visit(server) as page:
            commanded = page.do(what, **arguments)
            assert not commanded["ok"]
            assert word in commanded["text"]

    def test_a_stage_that_breaks_does_not_leave_the_page_waiting(self, server: PageServer, api: FakeSessionApi):
        def broken(command: object) -> str:
            raise ZeroDivisionError("secret")

        api.do = broken  # type: ignore[method-assign]
        with visit(server) as page:
            commanded = page.do("cut", a=0, b=1, on=True)
            assert (commanded["ok"], "secret" in commanded["text"]) == (False, False)
            page.frame()

    def test_lowered_damping_is_told(self, server: PageServer):
        with visit(server) as page:
            assert page.text("state")["verdict"]["level"] == "good"
            assert page.do("damping", fraction=0.4)["ok"]
            state = page.text("state", lambda m: m["damping"] == 0.4)
            assert state["verdict"]["level"] == "bad"
            assert "not safe" in state["verdict"]["text"]


@pytest.fixture(scope="module")
def still() -> Iterator[PageServer]:
    with PageServer(FakeSessionApi("1d"), port=0) as running:
        yield running


# Of what may be right.
_LENGTHS = {len(pointer(1)), len(ack(1))}


class TestMalformed:
    @settings(max_examples=examples(40))
    @given(
        st.one_of(
            st.binary(max_size=80).filter(
                lambda b: len(b) not in {len(pointer(1)), len(ack(1))} or b[:1] not in b"\2\3"
            ),
            st.text(max_size=80).filter(lambda t: not t.isdigit()),
        )
    )
    def test_closes_with_a_reason(self, still: PageServer, message: bytes | str):
        self.refused(still, message)

    @pytest.mark.parametrize(
        "message",
        [
            pointer(1, point=1),
            pointer(1, action=5),
            json.dumps({"type": "hello", "version": VERSION + 1}),
            json.dumps({"type": "hello", "version": VERSION, "slot": 9}),
            json.dumps({"type": "do", "id": 1, "what": "kill!"}),
        ],
        ids=["point", "action", "version", "slot", "command"],
    )
    def test_well_formed_but_out_of_range(self, still: PageServer, message: bytes | str):
        self.refused(still, message)

    @staticmethod
    def refused(still: PageServer, message: bytes | str) -> None:
        with visit(still) as page:
            page.say(message)
            code, reason = page.closed()
        assert code == 1008
        assert reason

    @pytest.mark.parametrize("first", [ack(1), pointer(1), '{"type": "do", "id": 1, "what": "cut"}'])
    def test_before_a_hello_nothing_counts(self, still: PageServer, first: bytes | str):
        with visit(still, hello=False) as page:
            page.say(first)
            error = page.text("error")
            assert "hello" in error["text"]
            assert page.closed()[0] == 1008

    def test_a_page_of_another_version_is_told(self, still: PageServer):
        with visit(still, version=VERSION + 1) as page:
            assert f"version {VERSION + 1}" in page.text("error")["text"]
            assert page.closed()[0] == 1008

    def test_what_is_too_long_is_not_read(self, still: PageServer):
        with visit(still) as page:
            page.say("[" * 20_000)
            assert page.closed()[0] == 1009

    @pytest.mark.parametrize(("message", "count"), [(ack(0), 4_000), ('{"type": "do", "id": 1, "what": "no"}', 400)])
    def test_too_many(self, still: PageServer, message: bytes | str, count: int):
        with visit(still) as page:
            with contextlib.suppress(ConnectionClosed):
                for _ in range(count):
                    page.connection.send(message)
            code, reason = page.closed()
        assert (code, "too many" in reason) == (1008, True)

    def test_others_go_on(self, still: PageServer):
        with visit(still) as watching:
            with visit(still, slot=1) as page:
                page.say(b"nonsense")
                page.closed()
            watching.frame()
            assert watching.text("state", lambda m: m["pages"] == 1)

    def test_too_many_pages(self, still: PageServer):
        with visit(still) as first:
            first.frame()
            others = [visit(still) for _ in range(15)]
            pages = [other.__enter__() for other in others]
            try:
                pages[-1].frame()
                with visit(still) as late:
                    code, reason = late.closed()
                assert (code, "16 pages" in reason) == (1008, True)
            finally:
                for other in others:
                    other.__exit__(None, None, None)
            first.text("state", lambda m: m["pages"] == 1)
