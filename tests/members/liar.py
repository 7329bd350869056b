"""A member with all keys of its own that says what it likes: on its links, and to everybody."""

import json
import math
from collections import deque
from collections.abc import Callable
from typing import Any

import numpy as np
from tests.members.lie import LIMIT, MOST, Lie
from tests.samples.budgets import made_up, with_amounts
from tests.session.world import Person, entropy

from cotouch.errors import SessionError
from cotouch.members import Decided, Decision, Former, Status, genuine, write_message
from cotouch.peer import Message, Sample
from cotouch.samples import Heading, Identity, SampleCodec, SampleLink, SamplePlane

BUDGET = "link.budget"  # what ends say of their ages
SIGNED = b"cotouch roster 1\0"  # stands before what a roster's signature is over
BEYOND = 1 << 52  # a number that no roster may have


class Liar:
    """What a member's copy and its control plane say, replaced."""

    def __init__(self, person: Person, lie: Lie) -> None:
        self.person, self.lie = person, lie
        self.failed: Exception | None = None  # then it says nothing any more
        self.sent = 0
        self._rng = np.random.default_rng(lie.seed)
        self._hooked: object = None
        self._plane: SamplePlane | None = None
        self._codec: SampleCodec | None = None
        self._asked: dict[str, Any] | None = None
        self._before: dict[int, tuple[float, np.ndarray]] = {}
        self._given = 0.0
        self._company: list[Any] = []
        self._said = 0.0
        self.host_died: float | None = None
        self.message: Callable[[Message], Message] = lambda told: told  # what it makes of what its law says
        self._beats = deque[bytes](maxlen=64)
        controls = person.world.controls
        self._carry, controls.carry = controls.carry, self._intercept
        self._turn, person.turn = person.turn, self._guarded_turn
        self._send, person.control.send = person.control.send, self._say

    @property
    def lying(self) -> bool:
        return self.person.world.now >= self.lie.since

    def _guarded_turn(self, now: float) -> None:
        if self.failed is not None:
            return
        try:
            self._turn(now)
            self._hook()
            if self.lying:
                self._talk(now)
        except Exception as error:  # noqa: BLE001
            self.failed = error

    def check(self) -> None:
        """Raises what it failed by, for it would show nothing any more; unless it was sent away."""
        if self.failed is not None and not isinstance(self.failed, SessionError):
            raise self.failed

    def _hook(self) -> None:
        copy = self.person.member.replica
        if copy is not None and copy is not self._hooked:
            self._hooked = copy
            plane = self._plane = copy._plane
            self._codec = SampleCodec(plane.layout)
            true = plane.send
            plane.send = lambda now, sample, T, mean=None: (
                self._tell(now, sample, T) if self.lying else true(now, sample, T, mean)
            )

    # -- samples -----------------------------------------------------------------------------------------------------

    def _tell(self, now: float, sample: Sample, T: float) -> None:
        plane, codec, lie = self._plane, self._codec, self.lie
        assert plane is not None
        assert codec is not None
        if self._rng.random() < lie.silence:
            return
        self._given += lie.given
        for nth, (other, link) in enumerate(plane.links.items()):
            for more in range(lie.burst):
                self.sent += 1
                heading = self._heading(link, sample, T, now, more)
                place = np.clip(
                    self._place(other, link, sample, now, -1.0 if lie.faces and nth % 2 else 1.0), -LIMIT, LIMIT
                )
                written = codec.write(place)
                told = codec.told(None if link.law is None else self.message(link.law.message))
                for chunk, body in enumerate(written.bodies):
                    sealed = link.seal.seal(codec.datagram(heading, chunk, body, told[chunk]))
                    if sealed is not None:
                        self.person.carrier.send(other, sealed)

    def _place(self, other: int, link: SampleLink, sample: Sample, now: float, face: float) -> np.ndarray:
        lie, theirs = self.lie, link.assembly.state
        then, before = self._before.get(other, (now, theirs))
        speed = (theirs - before) / (now - then) if now > then else np.zeros_like(theirs)
        if now > then + 0.004 or other not in self._before:
            self._before[other] = now, theirs.copy()
        path_state = (
            np.ones_like(theirs)
            if lie.pattern == 0
            else np.random.default_rng(lie.pattern).choice([-1.0, 1.0], theirs.shape)
        )
        size = face * lie.size
        match lie.law:
            case "place":
                return size * path_state
            case "swing":
                return size * math.sin(2.0 * math.pi * lie.rate * now) * path_state
            case "noise":
                return size * self._rng.uniform(-1.0, 1.0, theirs.shape)
            case "push":  # as a damper that is none
                return theirs + face * lie.lead * speed
            case "chase":
                return theirs + size * np.sign(speed)
            case "drift":
                return sample.position + face * lie.rate * max(0.0, now - lie.since) * path_state
            case "mirror":
                return -face * theirs * lie.rate
            case _:
                return sample.position

    def _heading(self, link: SampleLink, sample: Sample, T: float, now: float, more: int) -> Heading:
        lie, rng = self.lie, self._rng
        true = link.heading(self._plane.epoch, sample, T, now)
        header, since = true.header, now - lie.since
        state = int(rng.integers(0, 3)) if lie.state == -2 else lie.state
        epoch = {"true": header.epoch, "cycle": 1 + (sample.index // 3) % 255, "fixed": 7}[lie.epoch]
        header = header._replace(
            state=header.state if lie.state == -1 else state,
            epoch=epoch,
            known_epoch=link.assembly.header.epoch
            if lie.received and hasattr(link.assembly, "header")
            else header.known_epoch,
            given=min(self._given + header.given, 1e12),
            starved=header.starved if lie.starved < 0 else bool(lie.starved),
        )
        step = sample.index * lie.burst + more
        step = {
            "true": step,
            "stride": 1000 * step,
            "jump": step + (1 << 40),
            "back": max(0, (1 << 20) - step),
            "last": 1 << 53,
        }[lie.index]
        echo = {
            "true": true.echo,
            "none": true.echo,
            "future": 9e9,
            "old": -9e9,
            "random": float(rng.normal(0.0, 1e3)),
        }[lie.echo]
        off = 0.0 if math.isnan(lie.age) else lie.age
        age = max(-MOST, min(MOST, true.age + off))
        return true._replace(
            step=step,
            stamp=max(-1e10, min(1e10, true.stamp + lie.stamp + lie.drift * since)),
            flags=true.flags & ~(2 if math.isnan(lie.age) else 0) & ~(1 if lie.echo == "none" else 0),
            echo=echo,
            held=max(0.0, min(1e10, true.held + lie.held)),
            age=age,
            worst=max(age, min(MOST, true.worst + off)),
            header=header,
        )

    # -- messages ----------------------------------------------------------------------------------------------------

    def _say(self, topic: str, body: bytes, *, to: bytes | None = None) -> None:
        lie = self.lie
        if topic == "join":
            self._asked = json.loads(body)
        commanded = self.lying and not (lie.toggle and self._rng.random() < 0.5)
        if topic == BUDGET and commanded and not (math.isnan(lie.ask) and math.isnan(lie.grant)):
            ask, grant = (None if math.isnan(said) else said for said in (lie.ask, lie.grant))
            body = with_amounts(body, ask, grant)
        self._send(topic, body, to=to)

    def _talk(self, now: float) -> None:
        if now - self._said < 0.1:
            return
        self._said = now
        for name in self.lie.talk:
            getattr(self, f"_{name}")(now)

    def _rosters(self, now: float) -> None:
        """As if it decided: signed by it, after what the host had said."""
        del now
        world, chain = self.person.world, self.person.member._belief.chain
        if not chain:
            return
        roster, own = chain[-1].roster, self.person.identity.public.hex()
        stranger = Identity.make(entropy(76_999)).public.hex()
        others = [entry for entry in roster.members if entry.key != own]
        harms: list[dict[str, Any]] = [
            {"links": []},
            {"epoch": BEYOND},
            {"epoch": roster.epoch + (1 << 16), "links": []},
            {"members": [entry for entry in roster.members if entry.key == own], "links": []},
            {"members": [*others, *(e for e in roster.members if e.key == own)]},
            {"names": [], "members": [e.model_copy(update={"key": stranger}) for e in others]},
            {"members": [e.model_copy(update={"start": "f" * 16}) for e in roster.members]},
            {"members": [e.model_copy(update={"name": "nobody at all"}) if e in others else e for e in roster.members]},
            {"banned": [entry.key for entry in others]},
            {"former": [Former(key=stranger, slots=tuple(e.slot for e in roster.members))]},
        ]
        change = {"epoch": min(roster.epoch + 1, BEYOND)} | harms[int(self._rng.integers(0, len(harms)))]
        said = roster.model_copy(update=change)  # unchecked, as is what is made of it
        host = world.host_identity.public
        signature = self.person.identity.sign(SIGNED + host + write_message(said)).hex()
        decision = Decision.model_construct(roster=said, signer=own, signature=signature)
        assert genuine(decision, host)
        for commanded in ([*chain[:1], decision], [decision], [*chain, decision]):
            self._send("roster", write_message(Decided.model_construct(chain=commanded)))

    def _joins(self, now: float) -> None:
        """Others of its own, under the names of those who are there."""
        if now >= 1.5:
            self._crowded(now)

    def _crowded(self, now: float) -> None:
        del now
        world, own = self.person.world, self._asked
        if own is None:
            return
        if len(self._company) < 8:
            identity = Identity.make(entropy(77_000 + len(self._company)))
            self._company.append(world.controls.join(identity))
            world.directory[identity.public] = f"crowd {len(self._company)}"
        for at, control in enumerate(self._company):
            name = ("Ann", "Ben", "nobody", f"crowd {at}")[at % 4]
            control.send("join", json.dumps(own | {"name": name}).encode())
            control.poll()

    def _statuses(self, now: float) -> None:
        del now
        status = Status(
            slot=self.person.member.slot or 0,
            supplied=-1e12,
            energy=1e12,
            damping=-1e12,
            round_trips=[(0, 1e6), (1, 0.0)],
        )
        self._send("status", write_message(status))

    def _keys(self, now: float) -> None:
        del now
        for key in self._others():
            self._send("link.keys", self._rng.bytes(int(self._rng.integers(0, 300))), to=key)

    def _budgets(self, now: float) -> None:
        """Straight from the generator: any bits."""
        del now
        for key in self._others():
            for body in made_up(self._rng):
                self._send(BUDGET, body, to=key)

    def _garbage(self, now: float) -> None:
        del now
        for topic in ("roster", "refused", "end", "way.ping", "link.budget", "status", "seen", "join"):
            self._send(topic, self._rng.bytes(int(self._rng.integers(0, 500))))

    def _leave(self, now: float) -> None:
        del now
        self._send("leave", b"")

    def _files(self, now: float) -> None:
        del now
        self.person.control.offered[self.person.world.session.digest] = b"another session"

    def _crown(self, now: float) -> None:
        """It decides, where the host is dead and it comes first; also as no rule allows."""
        self._kill_host()
        self._rosters(now)

    def _ghost(self, now: float) -> None:
        """What showed that the host is there is said again once it is dead."""
        del now
        self._kill_host()
        for raw in list(self._beats)[-20:]:
            self.person.world.controls.carry(self.person.identity.public, None, raw, beat=True)
            bent = bytearray(raw)
            bent[int(self._rng.integers(0, len(bent)))] ^= 1 << int(self._rng.integers(0, 8))
            self.person.world.controls.carry(self.person.identity.public, None, bytes(bent), beat=True)

    def _kill_host(self) -> None:
        if self.person.world.host is not None:
            self.person.world.kill_host()
            self.host_died = self.person.world.now

    def _intercept(self, sender: bytes, to: bytes | None, message: bytes, *, beat: bool = False) -> None:
        if beat and sender == self.person.world.host_identity.public:
            self._beats.append(message)
        self._carry(sender, to, message, beat=beat)

    def _others(self) -> list[bytes]:
        own = self.person.identity.public.hex()
        return [bytes.fromhex(entry.key) for entry in self.person.member.roster.members if entry.key != own]
