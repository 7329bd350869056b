"""What a member's process writes for those who watch on the same machine, and what it is told by them.

Two mailboxes for each member: `NAME.view`, written by the member's process between two steps, and `NAME.orders`,
    written
by the process that shows it. Both have fixed sizes, so neither end ever waits or allocates much.
"""

import math
from collections.abc import Generator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import final
from urllib.parse import quote

import numpy as np
import numpy.typing as npt

from cotouch.arrays import Float
from cotouch.body import Body
from cotouch.mailbox import Fields
from cotouch.observers._commands import HAND_MODES
from cotouch.observers._session_api import Emulated, Pointer
from cotouch.processes import MemoryFolder
from cotouch.scenario import Scenario

# Columns of `ledger`, [J] but the last: greatest residual of a step, as a share of the energy in play.
LEDGER_COLUMNS = ("supplied", "lost", "linked", "energy", "initial", "residual")
# Columns of `links`, NaN where there is none: age of the sample, with the offset of the clocks [s]; work of the link on
# the copy so far [J]; force of its spring [N]; tank of its guard [J]; state of its guard.
LINKS = ("age", "work", "force", "tank", "state")
# Columns of `laws`: see `Emulated`.
LAWS = ("delay", "jitter", "loss", "cut")
# Bytes, UTF-8, of what is wrong with a recording.
TROUBLE = 200
# A copy that went further than this many radii of the body away from rest ran away: far enough that everybody saw it
# shake, and so near that it is back within seconds.
RUNAWAY = 2.0
# Radius of a body without extent [m].
_POINT = 0.1


def size_of(body: Body) -> float:
    """Radius of the body at rest about its centre, 0.1 m for a point [m]."""
    rest = np.asarray(body.rest if body.skin is None else body.skin.vertices)
    middle = 0.5 * (rest.min(axis=0) + rest.max(axis=0))
    radius = float(np.linalg.norm(rest - middle, axis=1).max(initial=0.0))
    return radius if radius > 0.0 else _POINT


def hands_of(scenario: Scenario) -> int:
    """Most hands that any slot of the session shows: one that can be told, and what its file says beyond the first."""
    counts = [0] * scenario.network.size
    for one in (*scenario.hands, *scenario.tools):
        if 1 <= one.user <= len(counts):
            counts[one.user - 1] += 1
    return max(1, *counts)


def view_fields(body: Body, *, users: int, hands: int) -> Fields:
    """The fields that a member shows.

    Args:
        body: the shared object.
        users: slots of the session.
        hands: see `hands_of`.
    """
    nodes, axes = body.rest.shape
    return {
        "slot": ((), "i4"),  # -1: none yet
        "time": ((), "f8"),  # end of the step, monotonic clock [s]
        "step": ((), "i8"),
        "period": ((), "f8"),  # length of the step [s]
        "displacement": ((nodes, axes), "f4"),  # [m]
        "cut": ((body.cut_count,), "i1"),  # who decided to cut each element, from 1; 0: it is whole
        "known": ((users,), "i1"),  # whose state is known
        "neighbours": ((users, nodes, axes), "f4"),  # as this member knows them [m]
        "ages": ((users,), "f8"),  # of these [s]
        "hands": ((), "i4"),  # how many of the following count
        "mode": ((hands,), "i4"),
        "node": ((hands,), "i4"),
        "target": ((hands, 3), "f4"),
        "place": ((hands, 3), "f4"),
        "force": ((hands, 3), "f4"),
        "radius": ((hands,), "f4"),
        "edge": ((hands, 3), "f4"),
        "received": ((), "i8"),  # number of the newest pointer
        "ledger": ((len(LEDGER_COLUMNS),), "f8"),
        "links": ((users, len(LINKS)), "f8"),
        "damping": ((), "f8"),  # share in force
        "caught": ((), "i8"),  # number of the order of damping that a runaway ended; 0: none
        "recording": ((), "i8"),  # number of the recording under way, or still being written; 0: none
        "recorded": ((), "i8"),  # number of the last one that came to its end, good or bad
        "recorded_steps": ((), "i8"),  # in that one
        "recorded_trouble": ((), f"S{TROUBLE}"),  # what is wrong with it; empty: nothing
    }


def order_fields(users: int) -> Fields:
    """What a member is told.

    Args:
        users: slots of the session.
    """
    return {
        "hand": ((), "i8"),  # rises with every order to the hand
        "pointer": ((), "i8"),  # number of the pointer that it comes from; 0: none
        "mode": ((), "i4"),
        "node": ((), "i4"),
        "target": ((3,), "f8"),
        "start": ((3,), "f8"),
        "edge": ((3,), "f8"),
        "turn": ((3,), "f8"),
        "radius": ((), "f8"),
        "stiffness": ((), "f8"),
        "laws": ((users, users, len(LAWS)), "f8"),  # to, from
        "impaired": ((), "i8"),  # rises with every change of the laws
        "fraction": ((), "f8"),
        "lease": ((), "f8"),  # until when a share below 1 holds, monotonic clock [s]; said anew while somebody is there
        "damped": ((), "i8"),  # rises with every order of damping
        "recording": ((), "i8"),  # number of the newest recording that was ordered; 0: none was
        "recording_on": ((), "i1"),  # whether it is to go on
    }


@final
@dataclass(frozen=True, kw_only=True)
class HandCommand(Pointer):
    """What a hand is told to do: as a pointer does, whose node may be -1 for what is held now.

    Attributes:
        pointer: number of the pointer that it comes from; 0: none.
        start: where a blade is put down [m].
    """

    pointer: int = 0
    start: tuple[float, float, float] = (0.0, 0.0, 0.0)


def hand_command_of(orders: dict[str, npt.NDArray[np.generic]]) -> HandCommand:
    """The order to the hand on a mailbox; a mode that there is not is "free"."""
    mode = int(orders["mode"].item())
    return HandCommand(
        number=int(orders["hand"].item()),
        pointer=int(orders["pointer"].item()),
        mode=HAND_MODES[mode] if 0 <= mode < len(HAND_MODES) else "free",
        node=int(orders["node"].item()),
        target=_three(orders["target"]),
        radius=_positive(orders["radius"].item()),
        stiffness=_positive(orders["stiffness"].item()),
        start=_three(orders["start"]),
        edge=_three(orders["edge"]),
        turn=_three(orders["turn"]),
    )


def _three(given: npt.NDArray[np.generic]) -> tuple[float, float, float]:
    x, y, z = (float(value) if math.isfinite(value) else 0.0 for value in given.tolist())
    return x, y, z


def laws_of(scenario: Scenario, *, emulate: bool) -> Float:
    """What a session's file puts on its paths, (users, users, 4): to, from, columns `LAWS`.

    Args:
        scenario: of the session.
        emulate: whether it is put on.
    """
    users = scenario.network.size
    laws = np.zeros((users, users, len(LAWS)))
    if emulate:
        channel = scenario.channel
        laws[:, :, 0] = scenario.network.delay
        laws[:, :, 1] = 0.0 if channel.jitter is None else channel.jitter.scale
        laws[:, :, 2] = channel.loss
        laws[np.arange(users), np.arange(users)] = 0.0
    return laws


def emulated(law: Float) -> Emulated:
    """One entry of `laws`."""
    delay, jitter, loss, cut = law.tolist()
    return Emulated(delay=delay, jitter=jitter, loss=loss, cut=bool(cut))


@final
@dataclass(frozen=True)
class MailboxFolder:
    """Where some members' mailboxes are.

    Attributes:
        path: an existing, private folder.
    """

    path: Path

    def view(self, name: str) -> Path:
        """Board that a member writes."""
        return self.path / f"{quote(name, safe='')}.view"

    def orders(self, name: str) -> Path:
        """Board that it reads."""
        return self.path / f"{quote(name, safe='')}.orders"

    def recording(self, name: str, number: int, life: int) -> Path:
        """File of a recording; a process that began anew does not go on with the file of the one before.

        Args:
            name: of the member.
            number: of the recording, from 1.
            life: how often the process began.
        """
        return self._recordings / f"{quote(name, safe='')}.{number}.{life}.mcap"

    def recordings(self, number: int) -> list[Path]:
        """Files of a recording, of all members here."""
        return sorted(self._recordings.glob(f"*.{number}.*.mcap"))

    @property
    def _recordings(self) -> Path:
        return self.path / "recordings"


@contextmanager
def mailbox_folder() -> Generator[MailboxFolder]:
    """A private folder for mailboxes, in memory if possible, and one for recordings, on disk."""
    with MemoryFolder() as folder, TemporaryDirectory(prefix="cotouch-") as disk:
        mailboxes = MailboxFolder(folder.path)
        (mailboxes.path / "recordings").symlink_to(disk, target_is_directory=True)
        yield mailboxes


def _positive(value: float) -> float:
    return value if math.isfinite(value) and value > 0.0 else 0.0
