"""Between a stage and the pages that show it: when who is sent what, and what becomes of what they ask for."""

import asyncio
import contextlib
import json
import secrets
import time
from collections.abc import Callable, Coroutine, Mapping
from concurrent.futures import ThreadPoolExecutor
from typing import Final, final

from cotouch.errors import CotouchError, PageError
from cotouch.observers import Command, CopyView, MoveHand, SessionApi, SetDamping
from cotouch.version import __version__
from cotouch.web._access import Access
from cotouch.web._control import Control
from cotouch.web._frames import FrameEncoder
from cotouch.web._page import Page
from cotouch.web._protocol import VERSION, Do, FrameReceipt, Hello, PointerMessage
from cotouch.web._scene import beside_nodes, held_tools, nodes_of_points, scene_message, state_message

# Pages with the token, without it, and that have not said yet what they are: each kind has places of its own, so that
# whoever may only watch keeps nobody out who may act.
MOST_PAGES: Final = 16
_RATE, _RATE_OF_BIG, _BIG = 60.0, 30.0, 10_000  # frames a second; above so many points
_STATE = 0.2  # between two states [s]
# Frames that are due within so long are made in one pass; a timer may wake so much too early [s].
_TOGETHER, _EARLY = 0.003, 0.0005
_ASKED: Final = 8  # answers that one page may wait for at a time
_COMPLAIN: Final = 1.0  # between two sentences on pointers that a stage does not take [s]
# A page that runs acknowledges several frames a second, seen or not. One that says nothing for so long hangs, or its
# network does: it holds nothing and lowers nothing any more [s].
_SILENT: Final = 3.0
_WATCH_ONLY = "this page may only watch: open the address with the token, as cotouch printed it"


@final
class Hub:
    """See the module; lives in the server's event loop.

    Attributes:
        scene: of the stage; does not change.
        address: where other devices find the page, without the token; None: they do not.
        started: names this run of the server.
        frames: made so far.
    """

    def __init__(
        self,
        api: SessionApi,
        access: Access,
        *,
        address: str | None = None,
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        """Prepares to serve a stage.

        Args:
            api: what is shown.
            access: who may act.
            address: where other devices find the page, without the token; None: they do not.
            clock: that the stage's copies go by [s].
        """
        self.api, self.access, self.scene, self.address = api, access, api.scene, address
        self.started = secrets.token_hex(8)
        self.frames = 0
        self._clock, self._start = clock, clock()
        self._encoder = FrameEncoder(self.scene.body)
        body = self.scene.body
        self._control = Control(api, nodes_of_points(body).tolist(), beside_nodes(body).tolist(), held_tools(body))
        self._period = 1.0 / (_RATE if self._encoder.points <= _BIG else _RATE_OF_BIG)
        self._pages: list[Page] = []
        self._scenes: dict[bool, str] = {}
        self._timer: asyncio.TimerHandle | None = None
        self._state_timer: asyncio.TimerHandle | None = None
        self._work = ThreadPoolExecutor(1, thread_name_prefix="cotouch-page-asks")
        self._tasks = set[asyncio.Task[None]]()
        self._lowering: Page | None = None  # that has the damping lowered
        self._closed = False

    def enter(self, page: Page) -> bool:
        """A page connects; False if too many have yet to say what they are."""
        if sum(other.hello is None for other in self._pages) >= MOST_PAGES or self._closed:
            return False
        self._pages.append(page)
        return True

    def leave(self, page: Page) -> None:
        """A page is gone."""
        self._pages.remove(page)
        self._control.leave(page)
        self._lapse(page)
        if not self._pages:
            for timer in (self._timer, self._state_timer):
                if timer is not None:
                    timer.cancel()
            self._timer = self._state_timer = None

    def hello(self, page: Page, message: Hello) -> None:
        """A page says what it is.

        Args:
            page: whose.
            message: what the page said.

        Raises:
            PageError: it is of another version, acts for a slot that there is not, or there are too many of its kind.
        """
        scene = self.scene
        if message.version != VERSION:
            raise PageError(
                f"the page speaks version {message.version}, cotouch {__version__} version {VERSION}; reload"
            )
        if message.slot is not None and message.slot >= len(scene.users):
            raise PageError(f"the page's slot is {message.slot}; there are 0 to {len(scene.users) - 1}")
        acts = self.access.token_right(message.token)
        first = page.hello is None
        if first or (message.slot, acts) != (page.slot, page.acts):
            like = sum(other.hello is not None and other.acts == acts for other in self._pages if other is not page)
            if like >= MOST_PAGES:
                raise PageError(
                    f"{MOST_PAGES} pages {'with' if acts else 'without'} the token are already open; close one"
                )
            if not first:
                self._control.leave(page)
            before, page.acts = page.acts, acts
            page.hello = message
            self._control.enter(page)
            if first or before != acts:
                self._tell_scene(page)
        page.hello = message
        page.period = max(self._period, 1.0 / message.rate)
        page.due = self._clock()
        self._show_state()
        self._schedule()

    def _tell_scene(self, page: Page) -> None:
        if page.acts not in self._scenes:
            told = scene_message(
                self.scene, version=__version__, started=self.started, acts=page.acts, page=self.address
            )
            self._scenes[page.acts] = json.dumps(told)
        page.scene(self._scenes[page.acts])

    def received(self, page: Page) -> None:
        """A page said something."""
        page.received = self._clock()
        if page.lapsed:
            page.lapsed = False
            self._control.enter(page)

    def pointed(self, page: Page, message: PointerMessage) -> None:
        """A page moves its pointer.

        Args:
            page: whose.
            message: what the page said.

        Raises:
            PageError: it points at something that is not drawn.
        """
        if message.point >= self._control.points:
            raise PageError(f"the pointer's point is {message.point}; there are 0 to {self._control.points - 1}")
        now = self._clock()
        if not page.acts:
            if not page.told_why:
                page.told_why = True
                page.tell(type="answer", id=0, ok=False, text=_WATCH_ONLY)
            return
        try:
            self._control.point(page, message, now)
        except CotouchError as error:
            if now - page.complained >= _COMPLAIN:
                page.complained = now
                page.tell(type="answer", id=0, ok=False, text=str(error))

    def acknowledged(self, page: Page, taken: FrameReceipt) -> None:
        """A page has taken a frame.

        Args:
            page: whose.
            taken: what the page said of it.
        """
        page.acknowledged(taken, self._clock())
        self._schedule()

    def asked(self, page: Page, message: Do) -> None:
        """A page asks for something; it is answered when it is done.

        Args:
            page: whose.
            message: what the page said.
        """
        try:
            command = self._allowed(page, message)
        except CotouchError as error:
            page.tell(type="answer", id=message.id, ok=False, text=str(error))
            return
        if command is None:
            took = self._control.take(page)
            text = (
                "this page has control" if took else "this page acts for no user here, so there is no control to take"
            )
            page.tell(type="answer", id=message.id, ok=took, text=text)
            self._show_state()
        else:
            page.answering += 1
            self._spawn(self._do(page, message.id, command))

    async def farewell(self) -> None:
        """Tells every page how things are at the end; returns when all that was handed over is out."""
        self._show_state()
        await asyncio.gather(*(page.idle.wait() for page in self._pages))

    def close(self) -> None:
        """Lets go of everything; no page is let in any more."""
        self._closed = True
        self._control.release()
        if self._lowering is not None:
            self._lapse(self._lowering)
        self._work.shutdown(wait=False, cancel_futures=True)

    def _allowed(self, page: Page, message: Do) -> Command | None:
        """What a page wants and may have; None: the control.

        Raises:
            CotouchError: it may not, or it is no command.
        """
        if not page.acts:
            raise PageError(_WATCH_ONLY)
        if message.control:
            return None
        if message.what not in self.scene.may:
            can = ", ".join(sorted(self.scene.may)) or "nothing"
            raise PageError(f'"{message.what}" is not possible here; possible are {can}')
        if self._control.of(page) == "other":
            raise PageError("another page has control; take over first")
        command = message.command()
        if isinstance(command, MoveHand) and not self._control.free_for(page, command.slot):
            raise PageError(f"another page moves the hand of user {command.slot + 1}")
        if page.answering >= _ASKED:
            raise PageError(f"{_ASKED} commands of this page are still running; wait until one is done")
        return command

    def _lapse(self, page: Page) -> None:
        """A page is gone, or no better: what it lowered is restored at once."""
        if self._lowering is not page:
            return
        self._lowering = None
        self.api.hold_damping(False)

    def _watch_pages(self, now: float) -> None:
        """Takes control from pages that hang, and goes on lowering for one that does not."""
        for page in self._pages:
            if page.hello is not None and not page.lapsed and now - page.received > _SILENT:
                page.lapsed = True
                self._control.leave(page)
        page = self._lowering
        if page is None:
            return
        if page.lapsed or not page.acts or self._control.of(page) == "other":
            self._lapse(page)
        else:
            self.api.hold_damping(True)

    def _spawn(self, work: Coroutine[object, object, None]) -> None:
        task = asyncio.get_running_loop().create_task(work)
        self._tasks.add(task)
        task.add_done_callback(self._tasks.discard)

    async def _do(self, page: Page, number: int, command: Command) -> None:
        loop = asyncio.get_running_loop()
        try:
            text = await loop.run_in_executor(self._work, self.api.do, command)
            ok = True
        except CotouchError as error:
            ok, text = False, str(error)
        except Exception as error:  # noqa: BLE001 - a page must not wait for ever for whatever went wrong
            ok, text = False, f"{command.what} failed inside cotouch: {type(error).__name__}"
        if ok and isinstance(command, SetDamping):
            self._lowering = page if command.fraction < 1.0 else None
            if page not in self._pages:  # it left meanwhile
                self._lapse(page)
        page.answering -= 1
        page.tell(type="answer", id=number, ok=ok, text=text)
        if self._pages:
            self._show_state()

    def _schedule(self) -> None:
        """Sees to it that the next frame that is due is made in time."""
        due = min((page.due for page in self._pages if page.takes()), default=None)
        if due is None or self._closed:
            return
        wait = max(due - self._clock() - _EARLY, 0.0)  # the loop wakes up to 1 ms late
        loop = asyncio.get_running_loop()
        if self._timer is not None:
            if self._timer.when() <= loop.time() + wait:
                return
            self._timer.cancel()
        self._timer = loop.call_later(wait, self._tick)

    def _tick(self) -> None:
        """Makes the frames that are due, in one pass, and hands them over."""
        self._timer = None
        now = self._clock()
        takes = [page for page in self._pages if page.takes()]
        if any(page.due <= now + _EARLY for page in takes):
            due = [page for page in takes if page.due <= now + _TOGETHER]
            views = self._views()
            wanted = {page: _slots(page, views) for page in due}
            watched = set[int]().union(*(_slots(page, views) for page in self._pages if page.hello is not None))
            self._encoder.update(views, watched)
            now = self._clock()
            self.frames += 1
            for page, slots in wanted.items():
                view = None if page.slot is None else views.get(page.slot)
                echo, waited = self._control.echo(page, view, now)
                frame = self._encoder.frame(
                    slots, number=self.frames, time=now, start=self._start, echo=echo, waited=waited
                )
                page.offer(self.frames, frame, now)
        self._schedule()

    def _views(self) -> Mapping[int, CopyView]:
        """The newest copies; none while the session comes or goes."""
        try:
            return self.api.views()
        except (CotouchError, OSError):
            return {}

    def _show_state(self) -> None:
        """Tells every page how things are, now and from now on."""
        if self._state_timer is not None:
            self._state_timer.cancel()
        loop = asyncio.get_running_loop()
        self._state_timer = loop.call_later(_STATE, self._show_state)
        self._watch_pages(self._clock())
        with contextlib.suppress(CotouchError):
            self._control.repeat()
        overview = self.api.overview()
        common = state_message(
            overview,
            self._views(),
            now=self._clock(),
            start=self._start,
            control="",
            pages=len(self._pages),
        )
        told: dict[str, str] = {}
        for page in self._pages:
            if page.hello is not None:
                control = self._control.of(page)
                if control not in told:
                    told[control] = json.dumps(common | {"control": control})
                page.show(told[control])


def _slots(page: Page, views: Mapping[int, CopyView]) -> frozenset[int]:
    """Whose copies a page is sent."""
    hello = page.hello
    if hello is None:
        return frozenset()
    return frozenset(views) if hello.want == "all" or hello.slot is None else frozenset({hello.slot})
