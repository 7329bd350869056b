"""What who watches from the same machine sees of copies, and may ask for: the page's side of a session.

A stage is used by two threads: whoever moves the session, and the server of a page. All its methods may be called by
either.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Literal, NamedTuple, Protocol, final

import numpy as np
import numpy.typing as npt

from cotouch.arrays import Single
from cotouch.body import Body
from cotouch.mechanics import Shape
from cotouch.members import Roster, SessionEvent, Status
from cotouch.network import Pair
from cotouch.observers._commands import Command, Doable, HandMode
from cotouch.scenario import DrawnTexture


@final
@dataclass(frozen=True, kw_only=True)
class Scene:
    """What does not change.

    Attributes:
        title: of the session.
        users: names, by slot.
        body: the shared object; its places at rest, dimension and skin.
        own: slots whose copies are moved by processes of this stage; only their hands can be told anything.
        may: which commands `SessionApi.do` carries out here.
        invitation: with which others take part; None if this stage does not give it away.
        stiffness: of a hand, unless a pointer says another [N/m].
        shapes: of what stands still around the object.
        colours: of each of several bodies, as "#rrggbb"; None: one of its own.
        texture: on the skin of what is shared; None: it is smooth.
    """

    title: str
    users: tuple[str, ...]
    body: Body
    own: tuple[int, ...]
    may: frozenset[Doable]
    invitation: str | None = None
    stiffness: float = 100.0
    shapes: tuple[Shape, ...] = ()
    colours: tuple[str | None, ...] = ()
    texture: DrawnTexture | None = None


@final
@dataclass(frozen=True, kw_only=True, eq=False)
class HandView:
    """What a hand is doing.

    Attributes:
        mode: see `HandMode`.
        node: that it holds; -1: none.
        target: where the hand is, (3,) [m]; in 1-D the first counts.
        place: of what it holds or pushes with (node or proxy), (3,) [m].
        force: of the hand on the object, (3,) [N]; the hand feels the opposite.
        radius: of the ball that pushes; 0 where it holds [m].
        edge: of its blade, from `place` to the other end, (3,); 0: it has none [m].
    """

    mode: HandMode = "free"
    node: int = -1
    target: Single = field(default_factory=lambda: np.zeros(3, np.float32))
    place: Single = field(default_factory=lambda: np.zeros(3, np.float32))
    force: Single = field(default_factory=lambda: np.zeros(3, np.float32))
    radius: float = 0.0
    edge: Single = field(default_factory=lambda: np.zeros(3, np.float32))


@final
@dataclass(frozen=True, kw_only=True, eq=False)
class CopyView:
    """One copy at a moment.

    Attributes:
        slot: whose.
        time: of the end of its step, on this machine's monotonic clock [s].
        step: number.
        displacement: of every node, (nodes, dimension) [m].
        direct: whether its own process told it; else it is what a neighbour knows of it, as old as its link.
        hands: of this user; the first is the pointer's, if it has one.
        supplied: by its hands so far [J].
        lost: in its dampers so far [J].
        linked: work of its links on it so far [J].
        energy: kinetic and elastic [J].
        received: number of the newest pointer that this step knows of.
        cut: who decided to cut each element, from 1, 0 of those that are whole, (elements,); None where that is not
            known, or the body cannot be cut.
    """

    slot: int
    time: float
    step: int
    displacement: Single
    direct: bool
    hands: Sequence[HandView]
    supplied: float = 0.0
    lost: float = 0.0
    linked: float = 0.0
    energy: float = 0.0
    received: int = 0
    cut: npt.NDArray[np.int8] | None = None


@dataclass(frozen=True, kw_only=True)
class Pointer:
    """Where a pointer is; the newest counts.

    Attributes:
        number: rises.
        mode: "grab", "ball", "blade", "pose" or "free".
        node: to hold, with "grab"; with "pose" which of the user's rigid tools, from 0.
        target: (3,) [m].
        radius: of the ball [m].
        stiffness: of the hand [N/m]; 0: as it was.
        edge: of the blade, from `target` to the other end, (3,) [m].
        turn: of the rigid tool from its start, along the axis of turning, as long as the angle, (3,) [rad].
    """

    number: int
    mode: HandMode
    node: int
    target: tuple[float, float, float]
    radius: float = 0.0
    stiffness: float = 0.0
    edge: tuple[float, float, float] = (0.0, 0.0, 0.0)
    turn: tuple[float, float, float] = (0.0, 0.0, 0.0)


@final
@dataclass(frozen=True, kw_only=True)
class Emulated:
    """The impairment of samples from one user to another, on top of the real network.

    Attributes:
        delay: [s].
        jitter: scale of what comes on top of the delay [s].
        loss: share.
        cut: whether nothing gets through.
    """

    delay: float = 0.0
    jitter: float = 0.0
    loss: float = 0.0
    cut: bool = False


class RecordingState(NamedTuple):
    """A recording that was requested here.

    Attributes:
        state: off: none was yet. on. ending: files are being finished. done: they can be had. failed: there are none.
        number: of the order, from 1.
        seconds: how long it is, so far [s].
        text: what came of it, in a sentence.
        files: name and size [bytes] of each.
        troubles: what is wrong with it, in sentences, at once; empty: nothing.
    """

    state: Literal["off", "on", "ending", "done", "failed"] = "off"
    number: int = 0
    seconds: float = 0.0
    text: str = ""
    files: tuple[tuple[str, int], ...] = ()
    troubles: tuple[str, ...] = ()


@final
@dataclass(frozen=True, kw_only=True)
class Overview:
    """What changes now and then.

    Attributes:
        time: when whoever moves the session looked [s].
        roster: who is there, and who is linked to whom.
        statuses: what members said last, by slot.
        alive: whether the process of a slot runs here; only of `Scene.own`, and not where somebody elsewhere has the
            slot.
        emulated: by ordered pair (to, from), where anything is emulated or can be.
        choices: named sets of links that can be chosen: "best", "worst", "start"; one that is not there is still being
            worked out, and an empty one was not found.
        damping: share of what the rule needs that copies are given; 1 unless somebody lowered it.
        recording: the last that was ordered.
        events: newest last.
        left: whether somebody took a part of the session's ledger along, who left or began anew.
        ended: whether the session is over; all the rest is then as it was in its last moment.
    """

    time: float
    roster: Roster
    statuses: Mapping[int, Status]
    alive: Mapping[int, bool]
    emulated: Mapping[tuple[int, int], Emulated]
    choices: Mapping[str, Sequence[Pair]]
    damping: float
    recording: RecordingState
    events: Sequence[SessionEvent]
    left: bool
    ended: bool


class SessionApi(Protocol):
    """All that a page may see of a session and request of it; see the module."""

    @property
    def scene(self) -> Scene:
        """What does not change."""
        ...

    def views(self) -> Mapping[int, CopyView]:
        """The newest of every copy that can be seen, by slot."""
        ...

    def overview(self) -> Overview:
        """How things are."""
        ...

    def point(self, slot: int, pointer: Pointer) -> None:
        """Moves a user's pointer; takes effect with the next step of its copy.

        A pointer that holds or pushes is to be told again at least twice a second, also where it stands still: a hand
        that hears nothing of it for a second lets go, because whoever held it has gone.

        Args:
            slot: of `Scene.own`.
            pointer: where to.
        """
        ...

    def do(self, command: Command) -> str:
        """Does one of `Scene.may`, and says in a sentence what was done; may wait for the session's loop.

        Args:
            command: what to do.

        Raises:
            SessionError: it cannot be done; says why.
        """
        ...

    def hold_damping(self, on: bool) -> None:
        """Says whether whoever lowered the damping is still there.

        Args:
            on: True: to be said again at least once a second, or all damping is back; False: it is back at once.
        """
        ...

    def recorded(self) -> Sequence[Path]:
        """Files of the last recording that came to its end, MCAP; empty before there is one."""
        ...
