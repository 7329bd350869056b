"""A stage of made-up motion: what a page can be shown without members, links or kernels.

Every user draws the body at a handle of its own. A copy shows the sum of all handles' bumps, each as old as the
shortest way through the links; so delays, cuts and users who are gone are seen as they would be.
"""

import atexit
import heapq
import math
import shutil
import tempfile
import threading
import time
from bisect import bisect_right
from collections import deque
from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any, Literal

import numpy as np

from cotouch.body import Body, Placed, Skin, ToolBody, chain, lattice, point, rigid_box, together
from cotouch.errors import SessionError
from cotouch.members import Entry, LinkStatus, Roster, SessionEvent, Status
from cotouch.network import Pair
from cotouch.observers import (
    ChooseLinks,
    Command,
    CopyView,
    Cut,
    Doable,
    Emulated,
    Expel,
    HandMode,
    HandView,
    Impair,
    Kill,
    MoveHand,
    Overview,
    Pointer,
    RecordingState,
    Revive,
    Scene,
    SetDamping,
    SetRecording,
)

NAMES = ("Ann", "Ben", "Cleo", "Dan", "Eve")
# The paper's one-way delays from user j to user i [s], and its fastest links.
DELAYS = (
    (0.0, 0.1, 0.8, 0.8, 1.0),
    (0.05, 0.0, 0.05, 0.05, 0.8),
    (0.8, 0.04, 0.0, 0.05, 0.8),
    (0.8, 0.04, 0.05, 0.0, 0.05),
    (1.0, 0.8, 0.8, 0.04, 0.0),
)
BEST: list[Pair] = [(0, 1), (0, 3), (1, 2), (1, 3), (2, 3), (3, 4)]
WORST: list[Pair] = [(0, 2), (0, 4), (1, 4), (2, 4), (0, 3), (2, 3)]
STEP = 0.002
SHARED = 2e-3  # what every copy gave up when the others came [J]
KEPT = 3.0  # of the handles' past [s]
KINDS = ("1d", "chain", "2d", "bare", "3d", "big", "tool")
MAY: frozenset[Doable] = frozenset({"hand", "impair", "cut", "kill", "revive", "expel", "links", "damping", "record"})
Kind = Literal["1d", "chain", "2d", "bare", "3d", "big", "tool"]


def soft_body(rings: int) -> Body:
    """A pear-like blob of about 2 rings² vertices on a lattice of 8 x 5 x 5 nodes."""
    spacing = 0.02
    grid = lattice((8, 5, 5), mass=1.0, stiffness=60.0, spacing=spacing, ground="x-", ground_stiffness=60.0)
    around = 2 * rings
    turn = np.linspace(0.0, 2.0 * math.pi, around, endpoint=False)
    along = np.linspace(0.0, math.pi, rings + 2)[1:-1]
    radius = np.sin(along) * (1.0 - 0.28 * np.cos(along)) / 1.1
    size, centre = 0.5 * spacing * np.array([7.0, 4.0, 4.0]) * 0.98, 0.5 * spacing * np.array([7.0, 4.0, 4.0])
    sides = np.stack(
        [
            np.broadcast_to(-np.cos(along)[:, None], (rings, around)),
            radius[:, None] * np.cos(turn),
            radius[:, None] * np.sin(turn),
        ],
        axis=-1,
    ).reshape(-1, 3)
    vertices = centre + size * np.concatenate([sides, [[-1.0, 0.0, 0.0], [1.0, 0.0, 0.0]]])
    a = (np.arange(rings - 1)[:, None] * around + np.arange(around)).ravel()
    b = (np.arange(rings - 1)[:, None] * around + (np.arange(around) + 1) % around).ravel()
    first, last = np.arange(around), (rings - 1) * around + np.arange(around)
    south, north = rings * around, rings * around + 1
    triangles = np.concatenate(
        [
            np.stack([a, a + around, b], axis=1),
            np.stack([b, a + around, b + around], axis=1),
            np.stack([np.full(around, south), first, np.roll(first, -1)], axis=1),
            np.stack([np.full(around, north), np.roll(last, -1), last], axis=1),
        ]
    )
    corners = vertices[triangles[:, 0]], vertices[triangles[:, 1]], vertices[triangles[:, 2]]
    if np.einsum("ij,ij->", corners[0] - centre, np.cross(corners[1] - corners[0], corners[2] - corners[0])) < 0.0:
        triangles = triangles[:, ::-1]
    nodes, weights = _trilinear(vertices / spacing, (8, 5, 5))
    return Body(
        mass=grid.mass,
        rest=grid.rest,
        damping_int=grid.damping_int,
        stiffness_int=grid.stiffness_int,
        stiffness_ext=grid.stiffness_ext,
        skin=Skin(vertices=vertices, triangles=triangles, nodes=nodes, weights=weights),
    )


def _trilinear(places: np.ndarray, shape: tuple[int, int, int]) -> tuple[np.ndarray, np.ndarray]:
    low = np.clip(np.floor(places).astype(int), 0, np.array(shape) - 2)
    part = places - low
    nodes, weights = [], []
    for corner in np.ndindex(2, 2, 2):
        at = low + corner
        nodes.append((at[:, 0] * shape[1] + at[:, 1]) * shape[2] + at[:, 2])
        weights.append(np.prod(np.where(corner, part, 1.0 - part), axis=1))
    table = np.stack(weights, axis=1)
    return np.stack(nodes, axis=1), table / table.sum(axis=1, keepdims=True)


def made_body(kind: Kind) -> Body:
    """1d: a point; chain: seven; 2d: a sheet, bare: a block, neither with a skin; 3d: 2,000 vertices; big: 20,000.

    tool: a die, and a bar of Ann's above it.
    """
    if kind == "tool":
        handle = np.array([0.0, 0.0, 0.05])
        held = tuple(
            (handle + 0.01 * np.array(sign)).tolist() for sign in ((1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1))
        )
        tool = ToolBody(owner=0, copies=5, grips=tuple(map(tuple, held)))
        bar = Placed(body=rigid_box([0.1, 0.02, 0.02], mass=0.1), name="bar", at=(0.0, 0.0, 0.05), tool=tool)
        return together([Placed(body=rigid_box([0.06, 0.06, 0.06], mass=0.1), name="die"), bar])
    if kind == "chain":
        return chain(7, stiffness=60.0, spacing=0.03)
    if kind in {"2d", "bare"}:
        grid = lattice((9, 6) if kind == "2d" else (7, 4, 4), mass=1.0, stiffness=60.0, spacing=0.02)
        return Body(mass=grid.mass, rest=grid.rest, damping_int=grid.damping_int, stiffness_int=grid.stiffness_int)
    return point() if kind == "1d" else soft_body(31 if kind == "3d" else 100)


class Handle:
    """What one user draws: a mass on a spring to its place and one to the hand."""

    def __init__(self, slot: int, node: int, reach: float) -> None:
        self.slot, self.node, self.reach = slot, node, reach
        self.mode: HandMode = "wander"
        self.offset, self.speed, self.target = np.zeros(3), np.zeros(3), np.zeros(3)
        self.force = np.zeros(3)
        self.stiffness, self.radius = 60.0, 0.0
        self.supplied = self.lost = 0.0
        self.past: deque[tuple[float, int, np.ndarray]] = deque(maxlen=int(KEPT / 0.01))
        self.moved = 0.0

    def step(self, now: float, dimension: int, rest: np.ndarray) -> None:
        if self.mode in {"wander", "script"}:
            wave = now * (0.5 + 0.13 * self.slot) + 1.7 * self.slot
            self.target = rest + self.reach * np.array([math.sin(wave), math.sin(0.7 * wave), math.cos(0.9 * wave)])
        self.force = np.zeros(3)
        if self.mode != "free":
            self.force = self.stiffness * (self.target - rest - self.offset)
            if dimension == 1:
                self.force[1:] = 0.0
        damped = 3.0 * self.speed
        self.speed = self.speed + STEP / 0.2 * (self.force - 20.0 * self.offset - damped)
        moved = STEP * self.speed
        self.offset = np.clip(self.offset + moved, -0.15, 0.15)
        self.supplied += float(self.force @ moved)
        self.lost += STEP * float(damped @ self.speed)


class FakeSessionApi:
    """A `Stage`; moves when it is looked at, as far as the clock went.

    Attributes:
        pointers: all that came, newest last.
        done: what was asked for by `do`.
        choices: sets of links by name.
        ended: whether it says that the session is over.
        recording_since: when the recording began; None: there is none [s].
    """

    def __init__(
        self,
        kind: Kind = "3d",
        *,
        clock: Callable[[], float] = time.monotonic,
        age: float = 0.0,
        stands: Mapping[str, object] | None = None,
    ) -> None:
        body = made_body(kind)
        scene = Scene(
            title="Five users, one object (made-up motion)",
            users=NAMES,
            body=body,
            own=(0, 1, 2, 3, 4),
            may=MAY,
            invitation="cotouch1:a-made-up-invitation-that-nobody-can-use",
        )
        self._scene = replace(scene, **(stands or {}))
        self.clock, self.age = clock, age  # age: how old the newest views are said to be [s]
        self.pointers: list[tuple[int, Pointer]] = []
        self.done: list[Command] = []
        self.ended = False
        self._lock = threading.Lock()
        self._rest = np.zeros((body.nodes, 3))
        self._rest[:, : body.dimension] = body.rest
        high = float(self._rest[:, 0].max())
        self._reach = 0.08 if body.dimension == 1 else 0.035
        self._sigma = 0.03
        self._handles = [
            Handle(slot, self._near((high * (0.55 + 0.11 * slot), 0.08 * (slot % 2), 0.02 * slot)), self._reach)
            for slot in range(5)
        ]
        self._start = self._now = clock()
        self._received = dict.fromkeys(range(5), 0)
        self._links = list(BEST)
        self._emulated = {
            (i, j): Emulated(delay=DELAYS[i][j]) for i in range(5) for j in range(5) if i != j
        }  # fmt: skip
        self._alive = dict.fromkeys(range(5), True)
        self.choices: dict[str, list[Pair]] = {"best": list(BEST), "worst": list(WORST), "start": list(BEST)}
        self._damping, self._wobble = 1.0, 0.0
        self.recording_since: float | None = None
        self.recording_state = RecordingState()
        self.files: tuple[Path, ...] = ()
        self.away = set[int]()  # slots of copies that are farther away than samples can tell
        self.elsewhere = set[int]()  # slots that somebody at another computer has
        self.held: list[bool] = []  # what was said of the lowered damping
        self.loop_age = 0.0  # how long ago whoever moves the session looked [s]
        self._events = deque[SessionEvent](maxlen=50)
        for name in NAMES:
            self._say(f"{name} joined")

    @property
    def scene(self) -> Scene:
        return self._scene

    def views(self) -> Mapping[int, CopyView]:
        with self._lock:
            self._advance()
            return {slot: self._view(slot) for slot in range(5) if self._alive[slot]}

    def point(self, slot: int, pointer: Pointer) -> None:
        with self._lock:
            self.pointers.append((slot, pointer))
            handle = self._handles[slot]
            if pointer.mode == "grab" and (handle.mode != "grab" or handle.node != pointer.node):
                handle.node, handle.offset, handle.speed = pointer.node, np.zeros(3), np.zeros(3)
            handle.mode = pointer.mode
            handle.target = np.array(pointer.target)
            if self._scene.body.dimension == 1:
                handle.target[1:] = 0.0
            handle.radius = pointer.radius if pointer.mode == "ball" else 0.0
            if pointer.mode == "ball":
                handle.node = self._near(pointer.target)
            handle.stiffness = pointer.stiffness or handle.stiffness
            self._received[slot] = pointer.number

    def overview(self) -> Overview:
        with self._lock:
            self._advance()
            here = [slot for slot in range(5) if self._alive[slot]]
            roster = Roster(
                epoch=1,
                members=[Entry(slot=slot, name=NAMES[slot], key=f"{slot:064x}") for slot in here],
                links=[pair for pair in sorted(self._links) if set(pair) <= set(here)],
            )
            recording = self.recording_state
            if self.recording_since is not None:
                recording = recording._replace(seconds=self._now - self.recording_since)
            return Overview(
                time=self.clock() - self.loop_age,
                roster=roster,
                statuses={slot: self.status(slot, roster) for slot in range(5)},
                alive={slot: alive for slot, alive in self._alive.items() if slot not in self.elsewhere},
                emulated=dict(self._emulated),
                choices=dict(self.choices),
                damping=self._damping,
                recording=recording,
                events=list(self._events),
                left=False,
                ended=self.ended,
            )

    def do(self, command: Command) -> str:
        with self._lock:
            self.done.append(command)
            text = self._do(command)
            self._say(text)
            return text

    def _do(self, command: Command) -> str:
        match command:
            case MoveHand():
                return self._move_hand(command)
            case Impair():
                for pair in self._pairs(command.a, command.b):
                    self._emulated[pair] = replace(self._emulated[pair], **command.changes())
                return f"the way between {NAMES[command.a]} and {NAMES[command.b]} is changed"
            case Cut():
                for pair in self._pairs(command.a, command.b):
                    self._emulated[pair] = replace(self._emulated[pair], cut=command.on)
                return (
                    f"the link of {NAMES[command.a]} and {NAMES[command.b]} is {'cut' if command.on else 'whole again'}"
                )
            case Kill():
                return self._live(command.slot, False)
            case Expel():
                self.elsewhere.discard(command.slot)
                return self._live(command.slot, False)
            case Revive():
                return self._live(command.slot, True)
            case ChooseLinks():
                if command.links is not None:
                    self._links = sorted({(min(pair), max(pair)) for pair in command.links})
                    return f"{len(self._links)} links, as you chose them"
                assert command.choice is not None
                self._links = list(self.choices[command.choice])
                return f"links: {command.choice}"
            case SetDamping():
                self._damping = command.fraction
                return f"damping is {100 * command.fraction:.0f} % of what the rule needs"
            case SetRecording():
                return self._record(command.on)

    def hold_damping(self, on: bool) -> None:
        self.held.append(on)
        if not on:
            with self._lock:
                self._damping = 1.0
                self._say("the page that lowered the damping is gone")

    def recorded(self) -> tuple[Path, ...]:
        return self.files

    def _move_hand(self, command: MoveHand) -> str:
        handle = self._handles[command.slot]
        if command.mode == "pull":
            handle.node = command.node if command.node >= 0 else handle.node
            handle.target = np.array(command.to, float)
        elif command.mode == "hold":
            handle.target = self._rest[handle.node] + handle.offset
        handle.mode, handle.radius = command.mode, 0.0
        return f"{NAMES[handle.slot]}'s hand: {command.mode}"

    def _live(self, slot: int, alive: bool) -> str:
        if self._alive[slot] == alive:
            raise SessionError(f"{NAMES[slot]} {'is there already' if alive else 'is gone already'}")
        self._alive[slot] = alive
        handle = self._handles[slot]
        handle.offset, handle.speed, handle.force = np.zeros(3), np.zeros(3), np.zeros(3)
        return f"{NAMES[slot]} {'came back' if alive else 'was killed'}"

    def _record(self, on: bool) -> str:
        number = self.recording_state.number
        if on:
            self.recording_since = self._now
            self.recording_state = RecordingState(state="on", number=number + 1)
            return "recording"
        folder = Path(tempfile.mkdtemp(prefix="cotouch-"))
        atexit.register(shutil.rmtree, folder, ignore_errors=True)
        for name in NAMES:
            (folder / f"{name}.mcap").write_bytes(b"\x89MCAP0\r\n made up\r\n")
        self.files = tuple(sorted(folder.glob("*.mcap")))
        seconds = self._now - (self.recording_since or self._now)
        self.recording_since = None
        named = tuple((path.name, path.stat().st_size) for path in self.files)
        text = f"{len(named)} files of {seconds:.1f} s"
        self.recording_state = RecordingState(state="done", number=number, seconds=seconds, text=text, files=named)
        return "recorded"

    def _pairs(self, a: int, b: int) -> tuple[Pair, Pair]:
        if max(a, b) > 4:
            raise SessionError(f"a and b are {a} and {b}; they must be two of the slots 0 to 4")
        return (a, b), (b, a)

    def _say(self, text: str) -> None:
        self._events.append(SessionEvent(self._now, text))

    def _near(self, place: Any) -> int:
        return int(np.argmin(np.sum((self._rest - np.array(place)) ** 2, axis=1)))

    def _advance(self) -> None:
        if self.ended:
            return
        wanted = self.clock()
        self._now = max(self._now, wanted - 0.1)  # after a pause it goes on from there
        while self._now + STEP <= wanted:
            self._now += STEP
            for handle in self._handles:
                if self._alive[handle.slot]:
                    handle.step(self._now - self._start, self._scene.body.dimension, self._rest[handle.node])
                if self._now - handle.moved >= 0.01:
                    handle.moved = self._now
                    handle.past.append((self._now, handle.node, handle.offset.copy()))
            growth = 1.2 * (0.8 - self._damping)
            self._wobble = min(0.03, max(1e-5, self._wobble) * math.exp(STEP * growth))

    def _paths(self, to: int) -> dict[int, float]:
        """Shortest delay from every user to one, through links that are whole."""
        best, queue = {to: 0.0}, [(0.0, to)]
        while queue:
            cost, i = heapq.heappop(queue)
            if cost > best[i]:
                continue
            for a, b in self._links:
                for near, far in ((a, b), (b, a)):
                    path_state = self._emulated.get((near, far))
                    if near == i and path_state is not None and not path_state.cut and self._alive[far]:
                        total = cost + path_state.delay + 0.005
                        if total < best.get(far, math.inf):
                            best[far] = total
                            heapq.heappush(queue, (total, far))
        return best

    def _view(self, slot: int) -> CopyView:
        body = self._scene.body
        field = np.zeros((body.nodes, 3))
        for other, delay in self._paths(slot).items():
            handle = self._handles[other]
            node, offset = handle.node, handle.offset
            if delay and handle.past:
                at = bisect_right(handle.past, self._now - delay, key=lambda entry: entry[0]) - 1
                _, node, offset = handle.past[max(at, 0)]
            if body.nodes == 1:
                field[0] += offset / 5 if other != slot else offset
                continue
            away = np.sum((self._rest - self._rest[node]) ** 2, axis=1)
            field += np.exp(-away / (2.0 * self._sigma**2))[:, None] * offset
        if self._wobble > 1e-4:
            field[:, 0] += self._wobble * math.sin(9.0 * (self._now - self._start) + slot)
        handle, now = self._handles[slot], self._now - self.age
        place = self._rest[handle.node] + field[handle.node]
        hand = HandView(
            mode=handle.mode,
            node=-1 if handle.mode in {"free", "ball", "pose"} else handle.node,
            target=handle.target.astype(np.float32),
            place=(handle.target if handle.mode == "ball" else place).astype(np.float32),
            force=handle.force.astype(np.float32),
            radius=handle.radius,
        )
        energy = 0.1 * float(handle.speed @ handle.speed) + 10.0 * float(handle.offset @ handle.offset)
        return CopyView(
            slot=slot,
            time=now,
            step=round((self._now - self._start) / STEP),
            displacement=field[:, : body.dimension].astype(np.float32),
            direct=True,
            hands=(hand,),
            supplied=handle.supplied,
            lost=handle.lost,
            linked=handle.lost + energy - handle.supplied,
            energy=energy,
            received=self._received[slot],
        )

    def status(self, slot: int, roster: Roster) -> Status:
        handle = self._handles[slot]
        links: list[LinkStatus] = []
        for other in roster.neighbours(slot) if self._alive[slot] else []:
            path_state, back = self._emulated[slot, other], self._emulated[other, slot]
            both = path_state.delay + back.delay + 0.004
            links.append(
                LinkStatus(
                    slot=other,
                    state="guarded" if path_state.cut else "coupled",
                    age=path_state.delay + 0.002,
                    age_sum=both,
                    budget=1.1 * both + 0.02,
                    round_trip=both,
                    loss=1.0 if path_state.cut else path_state.loss,
                    rate=500.0,
                    force=0.0 if path_state.cut else float(np.linalg.norm(handle.force)) / 3,
                    difference=float(np.linalg.norm(handle.offset - self._handles[other].offset)),
                    guarded=int(path_state.cut),
                )
            )
        energy = 0.1 * float(handle.speed @ handle.speed) + 10.0 * float(handle.offset @ handle.offset)
        return Status(
            slot=slot,
            epoch=roster.epoch,
            time=self._now - self._start,
            steps=round((self._now - self._start) / STEP),
            rate=500.0,
            nominal_period=0.002,
            longest_period=0.0031,
            missed=3,
            busy=0.12,
            force=float(np.linalg.norm(handle.force)),
            position=[float(x) for x in handle.offset[: self._scene.body.dimension]],
            supplied=handle.supplied,
            lost=handle.lost,
            linked=handle.lost + energy - handle.supplied + SHARED,
            rescaled=-SHARED,
            energy=energy,
            residual=3e-16,
            damping=40.0 * self._damping,
            drag=2.0,
            braked=0.022,
            moved=0.01,
            damping_margin=1.12 * self._damping - 1.0,
            links=links,
            unsent=slot in self.away,
            round_trips=[(j, DELAYS[slot][j] + DELAYS[j][slot]) for j in range(5) if j != slot],
        )
