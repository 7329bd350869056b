"""A session without processes, sockets or clocks: members on one virtual clock, over networks in memory."""

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import final

import numpy as np
from tests.control.memory import MemoryControl, MemoryControlNetwork
from tests.samples.memory import MemoryNetwork, MemoryTransport

from cotouch.control import SignedMessage
from cotouch.hands import CommandedHand, DeviceHand
from cotouch.haptics import ServoLink
from cotouch.mechanics import Model
from cotouch.members import (
    Admission,
    Decision,
    Hand,
    Host,
    Member,
    NoHand,
    Planner,
    Replica,
    ScriptedHand,
    SessionFile,
    SessionRecorder,
    SharedModel,
    Slot,
    StepRecorder,
    path_laws,
)
from cotouch.observers import CommandClient, MailboxFolder, TelemetryPublisher
from cotouch.peer import StepReport
from cotouch.samples import Identity, ImpairedTransport, PathLaw, Transport
from cotouch.traversal import PathState

_SERVICE = 0.02


def entropy(seed: int):
    rng = np.random.default_rng(seed)
    return rng.bytes


@final
class MemoryPaths:
    """Members of one process that know each other's addresses; for tests."""

    def __init__(
        self,
        transport: Transport,
        directory: Mapping[bytes, str],
        *,
        path: Callable[[str], float | None] = lambda address: None,
    ) -> None:
        """Wraps a transport.

        Args:
            transport: over a memory network.
            directory: address of each member by its public key.
            path: time there and back to an address [s].
        """
        self._transport = transport
        self._directory = directory
        self._path = path
        self._at: dict[int, str] = {}

    def introduce(self, neighbour: int, member: bytes) -> None:
        """Follows it to its address.

        Args:
            neighbour: the user's slot.
            member: public key of its member.
        """
        self._at[neighbour] = self._directory[member]
        self._transport.follow(neighbour, self._at[neighbour])

    def round_trip(self, neighbour: int) -> float | None:
        """As it was told."""
        return self._path(self._at[neighbour]) if neighbour in self._at else None

    def take(self, message: SignedMessage) -> bool:
        """Nothing is said about ways."""
        return False

    def path_state(self, neighbour: int) -> PathState:
        """Always direct."""
        return PathState.DIRECT


@final
class Steps:
    """What a copy tells of its steps, handed on to who records it.

    Attributes:
        last: the report of the newest; None before the first.
    """

    def __init__(self, recorder: StepRecorder | None) -> None:
        self.last: StepReport | None = None
        self._recorder = recorder

    @property
    def begun(self) -> bool:
        return self._recorder is not None and self._recorder.begun

    @property
    def failure(self) -> str | None:
        return None if self._recorder is None else self._recorder.failure

    def setup(self, copy: Replica, now: float) -> None:
        if self._recorder is not None:
            self._recorder.setup(copy, now)

    def step(self, copy: Replica, report: StepReport, now: float, T: float) -> None:
        self.last = report
        if self._recorder is not None:
            self._recorder.step(copy, report, now, T)

    def event(self, kind: str, time: float, **fields: object) -> None:
        if self._recorder is not None:
            self._recorder.event(kind, time, **fields)


class Person:
    """A member, and what of it the world moves.

    Attributes:
        carrier: what carries its samples.
        paths: to the others.
        hand: what moves its copy; None before there is one.
        device: what it says of its device.
        steps: of its copy.
    """

    def __init__(
        self, world: "World", name: str, *, moves: bool, offset: float, identity: Identity | None = None
    ) -> None:
        self.name = name
        self.world = world
        world.count += 1
        made = entropy(1000 * world.seed + world.count)
        self.identity = identity or Identity.make(made)
        self.control: MemoryControl = world.controls.join(self.identity)
        address = f"{name} {world.count}"
        world.directory[self.identity.public] = address
        self.samples: MemoryTransport = world.samples.join(address)
        self.offset = offset
        carrier: Transport = self.samples
        self.impaired = None
        if world.session.options.emulate or world.mailboxes is not None:
            carrier = self.impaired = ImpairedTransport(self.samples, {}, clock=lambda: world.now, seed=world.count)
        self.carrier = carrier
        self.paths = MemoryPaths(carrier, world.directory, path=lambda other: world.path(address, other))
        self.hand: Hand | None = None
        self.device: Callable[[], str] = str
        self.session_recorder = None
        if world.folder is not None:
            path = world.folder / f"{name} {world.count}.mcap"
            world.recordings.append(path)
            self.session_recorder = SessionRecorder(path, world.session, world.replica, name=name, waits=True)
        self.telemetry = None
        if world.mailboxes is not None:
            self.telemetry = TelemetryPublisher(
                world.mailboxes, name, world.session, world.replica, unsafe=world.unsafe, recorder=self.session_recorder
            )
        told: StepRecorder | None = self.session_recorder if self.telemetry is None else self.telemetry
        self.steps = Steps(world.tape or told)
        self.member = Member(
            session=world.session,
            replica=world.replica,
            control=self.control,
            paths=self.paths,
            transport=carrier,
            host=world.host_identity.public,
            name=name,
            version="test",
            hand=self._made_hand if moves else lambda slot, model: NoHand(model),
            entropy=made,
            secret=b"secret",
            recorder=self.steps,
            device=self._device,
        )
        self.alive = True
        self.next = world.now
        self.last = world.now
        self.service = world.now
        self.stalled_until = 0.0

    def _device(self) -> str:
        return self.device()

    def _made_hand(self, slot: int, model: Model) -> Hand:
        self.hand = self._new_hand(slot, model)
        return self.hand

    def _new_hand(self, slot: int, model: Model) -> Hand:
        session, replica = self.world.session, self.world.replica
        if self.impaired is not None and session.options.emulate:
            for other, law in path_laws(session.scenario, slot).items():
                self.impaired.set(other, law)
        if self.telemetry is not None:
            hand = CommandedHand(Slot.of(session, replica, slot, model), requests=self.telemetry.requests)
            self.telemetry.holds(hand, slot, commanded=True)
            return hand
        if self.name in self.world.devices:
            return DeviceHand(Slot.of(session, replica, slot, model), link=self.world.devices[self.name])
        return ScriptedHand(Slot.of(session, replica, slot, model))

    @property
    def copy(self) -> Replica:
        assert self.member.replica is not None
        return self.member.replica

    @property
    def position(self) -> np.ndarray:
        peer = self.copy.peer
        assert peer is not None
        return peer.model.to_nodes(peer.state.position)

    def states(self) -> dict[int, str]:
        return {link.slot: link.state for link in self.copy.status(self.world.now).links}

    def turn(self, now: float) -> None:
        if now < self.next or now < self.stalled_until:
            return
        slot = self.member.slot
        period = self.world.session.period(slot or 0)
        T = min(now - self.last, self.world.session.options.max_step)
        self.last = now
        self.next = now + period * self.world.rng.uniform(0.9, 1.1)
        if T > 0.0:
            self.member.step(now, T)
        if now >= self.service:
            self.service = now + _SERVICE
            self.member.service(now)
            if self.telemetry is not None:
                self.telemetry.service(now, slot, self.impaired)
                if self.member.replica is not None:
                    self.member.replica.give_damping(self.telemetry.damping, now)


class World:
    """Host, members and both networks."""

    def __init__(
        self,
        text: str,
        *,
        seed: int = 0,
        law: PathLaw | None = None,
        tick: float = 5e-4,
        folder: Path | None = None,
        mailboxes: MailboxFolder | None = None,
        planner: Planner | None = None,
        unsafe: bool = True,
        tape: StepRecorder | None = None,
    ) -> None:
        self.folder = folder
        self.tape = tape  # is told of all members' steps, in place of their recordings
        self.unsafe = unsafe
        self.mailboxes = mailboxes
        self.recordings: list[Path] = []
        self.session = SessionFile.from_toml(text)
        self.replica = SharedModel.build(self.session)
        self.seed = seed
        self.rng = np.random.default_rng(seed)
        self.tick = tick
        self.now = 0.0
        self.count = 0
        self.samples = MemoryNetwork(law=law or PathLaw(delay=0.005), seed=seed)
        self.controls = MemoryControlNetwork(delay=0.01, seed=seed)
        self.directory: dict[bytes, str] = {}
        self.host_identity = Identity.make(entropy(seed + 7))
        self.host_control = self.controls.join(self.host_identity)
        self.kept: list[Decision] = []
        self.planner = planner
        self.host: Host | None = self.made_host(None)
        names = self.session.scenario.network.users
        self.commands = None if mailboxes is None else CommandClient(mailboxes, self.session, list(names))
        self.people: list[Person] = []
        self.gone: list[Person] = []
        self.devices: dict[str, ServoLink] = {}  # by name of who holds one

    def made_host(self, kept: Decision | None) -> Host:
        admission = Admission(self.session, fingerprint=self.replica.fingerprint)
        keep = self.kept.append
        return Host(self.session, self.host_control, planner=self.planner, admission=admission, kept=kept, keep=keep)

    def revive_host(self, kept: Decision | None) -> None:
        """The host is started again, with what it kept."""
        self.host_control = self.controls.join(self.host_identity)
        self.host = self.made_host(kept)

    def join(self, name: str, *, moves: bool = True, stranger: bool = False) -> Person:
        """Somebody comes; who was here under this name comes back with its key, if it is no stranger to that."""
        kept = next((person.identity for person in reversed(self.gone) if person.name == name), None)
        identity = None if stranger else kept
        person = Person(self, name, moves=moves, offset=float(self.rng.uniform(-1e3, 1e3)), identity=identity)
        self.people.append(person)
        return person

    def kill(self, person: Person) -> None:
        self.controls.kill(person.identity.public)
        self._out(person)

    def leave(self, person: Person) -> None:
        person.member.leave()
        person.control.close()
        self._out(person)

    def kill_host(self) -> None:
        self.controls.kill(self.host_identity.public)
        self.host = None

    def _out(self, person: Person) -> None:
        person.samples.close()
        if person.session_recorder is not None:
            person.session_recorder.close()
        if person.telemetry is not None:
            person.telemetry.close()
            assert self.commands is not None
            self.commands.forget(person.name)
        person.alive = False
        self.people.remove(person)
        self.gone.append(person)

    def paths(self, one: Person, other: Person, law: PathLaw, *, both: bool = True) -> None:
        """Another law between two."""
        self.samples.set(one.samples.address, other.samples.address, law)
        if both:
            self.samples.set(other.samples.address, one.samples.address, law)

    def path(self, one: str, other: str) -> float | None:
        """There and back between two addresses, as pings would find it; None where they do not get through."""
        laws = self.samples.law(one, other), self.samples.law(other, one)
        return None if any(law.down for law in laws) else sum(law.delay for law in laws)

    def run(self, seconds: float) -> None:
        for _ in range(round(seconds / self.tick)):
            self.now += self.tick
            self.samples.now = self.controls.now = self.now
            if self.host is not None:
                self.host.service(self.now)
            for person in self.people:
                person.turn(self.now)

    def until(self, done, seconds: float) -> None:
        end = self.now + seconds
        while not done():
            assert self.now < end, f"not within {seconds} s"
            self.run(0.05)

    def all_coupled(self) -> bool:
        return all(
            p.member.replica is not None and p.copy.peer is not None and set(p.states().values()) <= {"coupled"}
            for p in self.people
        )

    def apart(self) -> float:
        places = [person.position for person in self.people]
        return max(float(np.abs(a - b).max()) for a in places for b in places)

    def check(self) -> None:
        """Everybody's ledger, and that of the whole: of those who left, too."""
        everybody = [p for p in (*self.people, *self.gone) if p.member.replica is not None and p.copy.peer is not None]
        seeds = 0.0
        for person in everybody:
            totals = person.copy.totals
            assert totals.alarms == 0
            assert totals.residual < 1e-10
            seeds += person.copy.initial_energies
        supplied = sum(p.copy.totals.supplied + p.copy.totals.initial + p.copy.totals.depth for p in everybody)
        risen = sum(max(0.0, p.copy.totals.rescaled) for p in everybody)
        assert supplied + seeds + risen >= -1e-9
