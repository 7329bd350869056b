"""Who moves which user's pointer: of several pages that act for one slot, one."""

from collections import deque
from dataclasses import replace
from typing import Final, final

from cotouch.errors import SessionError
from cotouch.observers import CopyView, Pointer, SessionApi
from cotouch.web._page import Page
from cotouch.web._protocol import PointerMessage

_KEPT: Final = 512  # pointers whose effect is still looked for


@final
class Control:
    """Holds slots for pages, and passes pointers on.

    The stage is told numbers that rise over all pages; what a page gets back are its own.
    """

    def __init__(
        self, api: SessionApi, nodes: list[int], beside: list[list[float]], tools: list[tuple[int, int, int, int]]
    ) -> None:
        """Begins with nobody in control.

        Args:
            api: that is told.
            nodes: which node each drawn point hangs on most.
            beside: from that node to the point, at rest [m].
            tools: that can be held, see `held_tools`.
        """
        self._api, self._nodes, self._beside, self._tools = api, nodes, beside, tools
        self._own = frozenset(api.scene.own)
        self._holders: dict[int, Page] = {}
        self._waiting: dict[int, list[Page]] = {}
        self._held: dict[int, Pointer] = {}  # by slot, where a pointer holds or pushes
        self._number = 0
        self._passed = {slot: deque[tuple[int, int, float, Page]](maxlen=_KEPT) for slot in self._own}

    @property
    def points(self) -> int:
        """How many are drawn."""
        return len(self._nodes)

    def of(self, page: Page) -> str:
        """How it is for a page: "mine", "other" or "none"."""
        holder = None if page.slot is None else self._holders.get(page.slot)
        return "none" if holder is None else "mine" if holder is page else "other"

    def free_for(self, page: Page, slot: int) -> bool:
        """Whether no other page moves the pointer of this slot.

        Args:
            page: whose.
            slot: of a user.
        """
        return self._holders.get(slot, page) is page

    def enter(self, page: Page) -> None:
        """A page begins to act for its slot; it has control if nobody else has."""
        slot = page.slot
        if slot is None or slot not in self._own or not page.acts:
            return
        if slot in self._holders:
            self._waiting.setdefault(slot, []).append(page)
        else:
            self._holders[slot] = page

    def leave(self, page: Page) -> None:
        """A page ends; the one that waits longest has control then."""
        for waiting in self._waiting.values():
            if page in waiting:
                waiting.remove(page)
        for slot in [slot for slot, holder in self._holders.items() if holder is page]:
            self._let_go(slot)
            del self._holders[slot]
            if self._waiting.get(slot):
                self._holders[slot] = self._waiting[slot].pop(0)

    def take(self, page: Page) -> bool:
        """A page takes the control over; whether there is anything to take."""
        slot = page.slot
        if slot is None or slot not in self._own:
            return False
        holder = self._holders.get(slot)
        if holder is not page:
            self._let_go(slot)
            waiting = self._waiting.setdefault(slot, [])
            if page in waiting:
                waiting.remove(page)
            if holder is not None:
                waiting.insert(0, holder)
            self._holders[slot] = page
        return True

    def point(self, page: Page, message: PointerMessage, now: float) -> None:
        """Passes a pointer on at once, if this page has control of that slot.

        Args:
            page: that sent it.
            message: what it sent; its point is one that is drawn.
            now: [s].

        Raises:
            SessionError: the stage does not take it.
        """
        slot, pointer = message.slot, message.pointer
        if self._holders.get(slot) is not page or page.slot != slot:
            return
        if pointer.mode == "grab":
            # A hand takes the drawn point, and what is drawn to it is the node below: with the way between them left
            # in, whoever takes hold would pull already.
            x, y, z = (a - b for a, b in zip(pointer.target, self._beside[message.point], strict=True))
            pointer = replace(pointer, node=self._nodes[message.point], target=(x, y, z))
        elif pointer.mode == "pose":
            own = [
                number for first, last, whose, number in self._tools if first <= message.point < last and whose == slot
            ]
            if not own:
                raise SessionError(
                    f"the pointer's point is {message.point}, which is not on a tool that this user can hold"
                )
            pointer = replace(pointer, node=own[0])
        pointer = replace(pointer, number=self._number + 1)
        self._api.point(slot, pointer)
        self._number += 1
        self._passed[slot].append((self._number, message.pointer.number, now, page))
        self._held.pop(slot, None)
        if pointer.mode != "free":
            self._held[slot] = pointer

    def repeat(self) -> None:
        """Tells the stage again where pointers are that stand still: a hand that hears nothing for long lets go."""
        for slot, pointer in list(self._held.items()):
            self._number += 1
            self._held[slot] = told = replace(pointer, number=self._number)
            if self._passed[slot]:
                _, theirs, came, whose = self._passed[slot][-1]
                self._passed[slot].append((self._number, theirs, came, whose))
            self._api.point(slot, told)

    def echo(self, page: Page, view: CopyView | None, now: float) -> tuple[int, float]:
        """Number of the newest pointer of this page that its copy has used, and how long ago it came [s].

        Args:
            page: whose.
            view: what the copy shows; None: nothing yet.
            now: time [s].
        """
        if view is None or view.slot != page.slot or view.slot not in self._passed:
            return 0, 0.0
        passed = self._passed[view.slot]
        for k in range(len(passed) - 1, -1, -1):
            number, theirs, came, whose = passed[k]
            if number <= view.received and whose is page:
                return theirs, now - came
        return 0, 0.0

    def release(self) -> None:
        """Lets go of everything that a page holds."""
        for slot in list(self._held):
            self._let_go(slot)

    def _let_go(self, slot: int) -> None:
        """So that no hand goes on holding where nobody leads it."""
        if slot in self._held:
            del self._held[slot]
            self._number += 1
            self._api.point(slot, Pointer(number=self._number, mode="free", node=-1, target=(0.0, 0.0, 0.0)))
