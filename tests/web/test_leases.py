"""What a page holds ends with it: control, what its pointer holds, damping that it lowered. On a clock of its own."""

import asyncio
import json
from collections.abc import Awaitable, Callable
from typing import Any

import pytest
from tests.web.fake_session_api import FakeSessionApi, Kind
from tests.web.inside import MOST_PAGES, VERSION, Access, Do, Hub, Page, PointerMessage, held_tools, read_binary
from tests.web.reader import pointer

from cotouch.errors import PageError
from cotouch.web import Hello

GRAB, FREE, POSE = 1, 2, 4
LONG, SHORT = 3.1, 0.2  # a page that is silent for so long hangs, or not [s]


class Told:
    """Stands for a page's socket, and keeps what the page was told last of how things are."""

    def __init__(self) -> None:
        self.state: dict[str, Any] = {}

    async def send_text(self, text: str) -> None:
        message = json.loads(text)
        if message["type"] == "state":
            self.state = message

    async def send_bytes(self, frame: bytes) -> None:
        """No frame is looked at here."""


class Room:
    """A hub whose pages have no sockets."""

    def __init__(self, kind: Kind = "1d") -> None:
        self.now = 0.0
        self.api = FakeSessionApi(kind, clock=lambda: self.now)
        self.hub = Hub(self.api, Access(listen="127.0.0.1", token="a token"), clock=lambda: self.now)
        self.number = 0
        self.told: dict[Page, Told] = {}
        self._sending: list[asyncio.Task[None]] = []

    def come(self, slot: int = 0) -> Page:
        told: Any = Told()
        page = Page(told)
        self.told[page] = told
        self._sending.append(asyncio.create_task(page.send_all()))
        assert self.hub.enter(page)
        self.hub.received(page)
        token = self.hub.access.token
        self.hub.hello(page, Hello(type="hello", version=VERSION, token=token, slot=slot))
        return page

    def watch(self) -> Page:
        page = Page(None)  # pyright: ignore[reportArgumentType]
        assert self.hub.enter(page)
        try:
            self.hub.hello(page, Hello(type="hello", version=VERSION))
        except PageError:
            self.hub.leave(page)  # as the server does
            raise
        return page

    def wait(self, seconds: float, *talking: Page) -> None:
        """Time passes; these go on talking, and the others are silent."""
        for _ in range(round(seconds / 0.1)):
            self.now += 0.1
            for page in talking:
                self.hub.received(page)
            self.tell()

    def tell(self) -> None:
        """Somebody comes who only watches, and goes: all are told how things are."""
        self.hub.leave(self.watch())

    def point(self, page: Page, action: int, point: int = 0) -> None:
        self.number += 1
        self.hub.received(page)
        message = read_binary(pointer(self.number, slot=page.slot or 0, action=action, point=point))
        assert isinstance(message, PointerMessage)
        self.hub.pointed(page, message)

    def held(self) -> bool:
        """Whether a pointer holds the body now, as the stage was told last."""
        return bool(self.api.pointers) and self.api.pointers[-1][1].mode != "free"

    async def ask(self, page: Page, what: str, **arguments: object) -> None:
        self.hub.received(page)
        self.hub.asked(page, Do(type="do", id=1, what=what, parts=arguments))
        await self.answered(page)

    async def answered(self, page: Page) -> None:
        """Waits until all is done that a page asked for."""
        while page.answering:
            await asyncio.sleep(0.001)

    async def lower(self, page: Page, fraction: float = 0.5) -> None:
        await self.ask(page, "damping", fraction=fraction)
        assert self.api.overview().damping == fraction

    @property
    def damping(self) -> float:
        return self.api.overview().damping

    async def control(self, page: Page) -> str:
        """Who has control of the page's slot, as it is told itself."""
        self.tell()
        await page.idle.wait()
        return self.told[page].state["control"]

    def close(self) -> None:
        for sending in self._sending:
            sending.cancel()
        self.hub.close()


def play(story: Callable[[Room], Awaitable[None]], kind: Kind = "1d") -> None:
    async def run() -> None:
        room = Room(kind)
        try:
            await story(room)
        finally:
            room.close()

    asyncio.run(run())


def test_damping_comes_back_with_the_end_of_the_page_that_lowered_it() -> None:
    async def story(room: Room) -> None:
        ann, ben = room.come(0), room.come(1)
        await room.lower(ann)
        room.hub.leave(ben)  # another's end is nothing to it
        assert room.damping == 0.5
        room.hub.leave(ann)
        assert room.damping == 1.0
        assert room.api.held[-1] is False

    play(story)


def test_damping_comes_back_from_a_page_that_hangs_and_stays_while_it_talks() -> None:
    async def story(room: Room) -> None:
        ann, ben = room.come(0), room.come(1)
        await room.lower(ann)
        room.wait(3.0 * LONG, ann, ben)
        assert room.damping == 0.5
        assert room.api.held[-5:] == [True] * 5  # said again and again: the stage's own lease would end
        room.wait(SHORT, ben)
        assert room.damping == 0.5
        room.wait(LONG, ben)
        assert room.damping == 1.0
        room.api.held.clear()
        room.wait(LONG, ann, ben)  # it comes back, and what it lowered does not
        assert room.damping == 1.0
        assert room.api.held == []

    play(story)


def test_damping_that_a_page_put_back_is_nobodys_to_hold() -> None:
    async def story(room: Room) -> None:
        ann = room.come(0)
        await room.lower(ann)
        await room.lower(ann, 1.0)
        room.api.held.clear()
        room.wait(1.0, ann)
        room.hub.leave(ann)
        assert room.api.held == []

    play(story)


def test_damping_that_is_lowered_for_a_page_that_left_meanwhile_comes_back() -> None:
    async def story(room: Room) -> None:
        ann = room.come(0)
        room.come(1)
        room.hub.asked(ann, Do(type="do", id=1, what="damping", parts={"fraction": 0.5}))
        room.hub.leave(ann)
        await room.answered(ann)
        assert room.damping == 1.0

    play(story)


def test_damping_comes_back_when_another_takes_control_and_when_the_hub_closes() -> None:
    async def story(room: Room) -> None:
        ann, other = room.come(0), room.come(0)
        await room.lower(ann)
        await room.ask(other, "control")
        room.wait(SHORT, ann, other)
        assert room.damping == 1.0
        await room.lower(other)
        room.hub.close()
        assert room.damping == 1.0

    play(story)


def test_control_goes_to_who_waits_when_a_page_ends_or_hangs() -> None:
    async def story(room: Room) -> None:
        ann, other, third = room.come(), room.come(), room.come()
        assert [await room.control(page) for page in (ann, other, third)] == ["mine", "other", "other"]
        room.point(ann, GRAB)
        assert room.held()
        room.hub.leave(ann)
        assert not room.held()
        assert [await room.control(page) for page in (other, third)] == ["mine", "other"]
        room.point(other, GRAB)
        room.wait(SHORT, third)
        assert await room.control(other) == "mine"
        room.wait(LONG, third)
        assert not room.held()
        assert [await room.control(page) for page in (other, third)] == ["other", "mine"]
        room.wait(SHORT, other, third)  # it talks again: it waits, and has control when it is free
        room.hub.leave(third)
        assert await room.control(other) == "mine"
        room.point(other, GRAB)
        assert room.held()

    play(story)


def test_a_rigid_tool_is_led_for_its_user_alone() -> None:
    async def story(room: Room) -> None:
        (first, last, slot, number) = held_tools(room.api.scene.body)[0]
        assert (slot, number) == (0, 0)
        ann, ben = room.come(0), room.come(1)
        with pytest.raises(PageError, match=f"there are 0 to {last - 1}"):
            room.point(ann, POSE, last)
        room.point(ben, POSE, first)
        room.point(ann, POSE, first - 1)  # of the die
        assert not room.api.pointers
        room.point(ann, POSE, first)
        assert [(slot, told.mode, told.node) for slot, told in room.api.pointers] == [(0, "pose", 0)]
        room.hub.leave(ann)
        assert not room.held()

    play(story, "tool")


def test_a_page_that_hung_alone_has_control_again_when_it_talks() -> None:
    async def story(room: Room) -> None:
        ann = room.come()
        room.point(ann, GRAB)
        room.wait(LONG)
        assert await room.control(ann) == "none"
        assert not room.held()
        room.point(ann, GRAB)
        assert await room.control(ann) == "mine"
        assert room.held()
        room.point(ann, FREE)
        assert not room.held()
        room.point(ann, GRAB)
        room.wait(LONG)  # and it may hang once more
        assert await room.control(ann) == "none"
        assert not room.held()

    play(story)


def test_a_page_that_acts_for_another_slot_lets_go_of_the_one_before() -> None:
    async def story(room: Room) -> None:
        ann = room.come(0)
        room.point(ann, GRAB)
        room.hub.hello(ann, Hello(type="hello", version=VERSION, token=room.hub.access.token, slot=2))
        assert not room.held()
        assert await room.control(room.come(0)) == "mine"
        assert await room.control(ann) == "mine"

    play(story)


def test_one_page_that_is_left_is_sent_states_and_none_costs_nothing() -> None:
    async def story(room: Room) -> None:
        loop = asyncio.get_running_loop()
        later, timers = loop.call_later, list[asyncio.TimerHandle]()

        def call_later(*what: Any, **more: Any) -> asyncio.TimerHandle:
            timers.append(later(*what, **more))
            return timers[-1]

        loop.call_later = call_later
        ann, ben = room.come(0), room.come(1)
        room.hub.leave(ann)
        assert not all(timer.cancelled() for timer in timers)
        await ben.idle.wait()
        told = room.told[ben]
        told.state = {}
        async with asyncio.timeout(30.0):
            while not told.state:  # without anybody's doing
                await asyncio.sleep(0.01)
        timers[:] = [timer for timer in timers if timer.when() > loop.time()]
        room.hub.leave(ben)
        assert all(timer.cancelled() for timer in timers)

    play(story)


def test_who_waited_and_left_gets_nothing_and_who_takes_over_finds_nothing_held() -> None:
    async def story(room: Room) -> None:
        ann, other, third = room.come(), room.come(), room.come()
        room.hub.leave(other)
        room.point(ann, GRAB)
        await room.ask(third, "control")
        assert not room.held()
        assert [await room.control(page) for page in (ann, third)] == ["other", "mine"]
        room.hub.leave(third)
        assert await room.control(ann) == "mine"
        room.hub.leave(ann)
        last = room.come()
        assert await room.control(last) == "mine"
        room.point(last, GRAB)
        room.hub.close()
        assert not room.held()

    play(story)


def test_a_page_that_waits_and_leaves_is_not_next() -> None:
    async def story(room: Room) -> None:
        ann, other, third = room.come(), room.come(), room.come()
        room.hub.leave(other)
        room.hub.leave(ann)
        assert await room.control(third) == "mine"

    play(story)


def test_who_may_only_watch_keeps_nobody_out_who_may_act() -> None:
    async def story(room: Room) -> None:
        watching = [room.watch() for _ in range(MOST_PAGES)]
        with pytest.raises(PageError, match="16 pages without the token are already open"):
            room.watch()
        acting = [room.come() for _ in range(MOST_PAGES)]
        with pytest.raises(PageError, match="16 pages with the token are already open"):
            room.come()
        assert all(page.hello is not None for page in watching + acting)

    play(story)


def test_too_many_that_say_nothing_are_not_taken() -> None:
    async def story(room: Room) -> None:
        silent = [Page(None) for _ in range(MOST_PAGES + 1)]  # pyright: ignore[reportArgumentType]
        assert [room.hub.enter(page) for page in silent] == [True] * MOST_PAGES + [False]
        room.hub.leave(silent[0])
        room.come()

    play(story)
