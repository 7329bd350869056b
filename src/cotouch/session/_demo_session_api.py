"""A whole session on this machine as a stage: its host in this process, and a process for each user."""

import math
import os
import re
import time
from pathlib import Path
from typing import assert_never, final
from urllib.parse import quote

import numpy as np

from cotouch.errors import NetworkError, SessionError
from cotouch.hands import usual_stiffness
from cotouch.members import Roster, SessionFile, SharedModel
from cotouch.network import Pair
from cotouch.observers import (
    ChildCall,
    ChooseLinks,
    Cut,
    Doable,
    Expel,
    Impair,
    Kill,
    LoweredDamping,
    MailboxFolder,
    Overview,
    Revive,
    Scene,
    SetDamping,
)
from cotouch.session import _requests
from cotouch.session._open import OpenHost
from cotouch.session._planner import notable_links
from cotouch.session._process import MemberProcess
from cotouch.session._steered import SteeredMembers

# Where no hand exerts more than this, and nobody acts for so long, hands begin to wander [N, s].
_AT_REST, _QUIET = 0.01, 20.0


def file_name(name: str, life: int) -> str:
    """Of a user's recording: no name leads out of the folder, and no two names share a file.

    What a file system takes amiss is escaped, and so is what counts lives.

    Args:
        name: of the user.
        life: how often its process was started before.
    """
    shown = re.sub(r'[%#/\\:*?"<>|]', lambda letter: quote(letter[0], safe=""), name)
    return f"{shown}.mcap" if not life else f"{shown} #{life + 1}.mcap"


def cores() -> int:
    """Processors that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


# Choices of links that were looked for and not found.
_NONE_FOUND: dict[str, list[Pair]] = {"best": [], "worst": []}


@final
class DemoSessionApi(SteeredMembers):
    """Implements `SessionApi`.

    `start`, `tick` and `close` belong to the loop that moves the session.

    Attributes:
        opened: the host.
        members: a process for each user, by name; of one that was revived, the last.
        acted: whether somebody changed how the session goes, so that its end says little.
        lowered: whether somebody lowered the damping.
    """

    def __init__(
        self,
        session: SessionFile,
        opened: OpenHost,
        replica: SharedModel,
        mailboxes: MailboxFolder,
        *,
        record: Path | None = None,
        rouse: bool = False,
    ) -> None:
        """Prepares the session; nobody takes part yet.

        Args:
            session: with scripted hands.
            opened: its host.
            replica: the body as built here.
            mailboxes: where members are shown and told things.
            record: an existing folder for a recording of each user's whole part.
            rouse: whether hands wander where somebody looks, nobody acts and everything rests.

        Raises:
            InputError: a mailbox cannot be made.
        """
        super().__init__(session, replica.body, mailboxes, list(session.scenario.network.users))
        self.opened = opened
        self.members: dict[str, MemberProcess] = {}
        self.acted = self.lowered = False
        self._mailboxes, self._record = mailboxes, record
        own = tuple(range(len(self._names)))
        # Other laws pay for what they do, and take no damping that could be lowered.
        damped: set[Doable] = {"damping"} if session.law == "spring" else set()
        known: set[Doable] = {"hand", "impair", "cut", "kill", "revive", "expel", "links", "record"}
        self._scene = Scene(
            title=session.scenario.title or "cotouch",
            users=tuple(self._names),
            body=replica.body,
            own=own,
            may=frozenset(known | damped),
            invitation=opened.invitation.encode(),
            stiffness=usual_stiffness(replica.scenario, 0),
            shapes=replica.shapes,
            colours=replica.colours,
            texture=replica.texture,
        )
        self._rouses, self._roused = rouse, set[str]()  # hands that wander by themselves
        self._stirred = self._acted = -math.inf  # when something moved, and when somebody acted last [s]
        self._killed = set[str]()
        self._keys: dict[str, str] = {}  # by which members that were started here are known
        self._damping = LoweredDamping(self._commands, self._names, self._say)
        self._lives = dict.fromkeys(self._names, 0)
        self._planned: ChildCall[dict[str, list[Pair]]] | None = None
        self._choosing = self._seen = False  # whether choices are to be looked for, and whether anybody sees them
        self._choices: dict[str, list[Pair]] = {"start": sorted(session.scenario.network.links)}
        self._overview = self._looked(time.monotonic())

    # -- the loop ----------------------------------------------------------------------------------------------------

    def start(self) -> None:
        """Starts a process for every user."""
        for name in self._names:
            self._begin(name)

    def tick(self, now: float) -> None:
        """Moves the session on; to be called some fifty times a second.

        Args:
            now: on the monotonic clock [s].
        """
        self.opened.service(now)
        self._jobs.turn()
        ended = self.opened.host.watch.ended
        running = [name for name, member in self.members.items() if name not in self._killed and member.running]
        self._recording.turn(now, running, ended=ended)
        for name, member in self.members.items():
            if name not in self._killed and not member.running:
                self._killed.add(name)
                if not ended:  # else all leave, and what they showed last is the session's last moment
                    self._commands.forget(name)
                    self._say(now, f"{name}'s process ended: {member.complaint() or 'it gave no message'}")
        self._damping.turn(now)
        if self._rouses and self._seen:
            self._rouse(now)
        self._choose()
        self._overview = self._looked(now)

    def choose_links(self) -> None:
        """Begins to look for the best and the worst links once anybody looks: they are among the choices when found."""
        if len(self._names) > 1 and self._session.scenario.network.links:
            self._choosing = True
        else:
            self._choices |= _NONE_FOUND

    def close(self) -> None:
        """Ends every process and lets go of everything."""
        self._jobs.close()
        if self._planned is not None:
            self._planned.kill()
        for member in self.members.values():
            member.close()
        self._commands.close()

    def _choose(self) -> None:
        if self._choosing and self._seen:
            self._choosing, self._planned = False, ChildCall(notable_links, self._session)
        if self._planned is not None and self._planned.done:
            try:
                found = self._planned.result()
            except SessionError:
                found = {}
            self._choices |= _NONE_FOUND | found
            self._planned = None

    def _begin(self, name: str) -> None:
        options = ["--name", name, "--headless", "--mailboxes", str(self._mailboxes.path), "--unsafe"]
        if len(self._names) >= cores():
            options.append("--ordinary")  # else they leave nothing to the page and to whoever looks at it
        if self._record is not None:
            options += ["--record", str(self._record / file_name(name, self._lives[name]))]
        self._lives[name] += 1
        before = self.members.get(name)
        if before is not None:
            before.close()
        self.members[name] = MemberProcess(self.opened.invitation, options, as_json=True)
        self._killed.discard(name)

    def _rouse(self, now: float) -> None:
        """Lets hands that do nothing wander once all has come to rest, until somebody acts."""
        if self._roused:
            if self._acted < self._stirred:
                return
            for name in self._roused:
                if self._commands.mode(name) == "wander":
                    self._commands.hand(name, "script")
            self._roused.clear()
            self._stirred = now
        forces = [np.linalg.norm(hand.force) for view in self.views().values() for hand in view.hands]
        quiet = self._damping.fraction >= 1.0 and bool(forces) and max(forces) <= _AT_REST
        if not quiet or self._stirred == -math.inf:
            self._stirred = now
        if now - max(self._stirred, self._acted) < _QUIET:
            return
        self._roused = {name for name in self._names if self._commands.mode(name) in {"script", "free"}}
        for name in self._roused:
            self._commands.hand(name, "wander")
        self._stirred = now

    def _looked(self, now: float) -> Overview:
        watch = self.opened.host.watch
        return self._look(
            now,
            watch,
            alive=self._alive(watch.roster),
            ended=watch.ended,
            choices=self._choices,
            emulated=True,
            damping=self._damping.fraction,
        )

    def _alive(self, roster: Roster) -> dict[int, bool]:
        """Whether each user's process runs here; without those whose slots somebody elsewhere has."""
        keys = {entry.name: entry.key for entry in roster.members}
        alive: dict[int, bool] = {}
        for slot, name in enumerate(self._names):
            runs = name in self.members and name not in self._killed
            if runs and name in keys:
                self._keys[name] = keys[name]
            if runs or keys.get(name) in {None, self._keys.get(name)}:
                alive[slot] = runs
        return alive

    # -- any thread --------------------------------------------------------------------------------------------------

    @property
    def scene(self) -> Scene:
        """What does not change."""
        return self._scene

    def overview(self) -> Overview:
        """How things were at the last `tick`."""
        self._seen = True
        return self._overview

    def _do_more(self, command: Impair | Cut | Kill | Revive | Expel | ChooseLinks | SetDamping) -> str:
        match command:
            case Impair():
                return self._impair(command)
            case Cut():
                return self._cut(command)
            case _:
                return self._jobs.ask(lambda: self._do_in_loop(command))

    def _do_in_loop(self, command: Kill | Revive | Expel | ChooseLinks | SetDamping) -> str:
        match command:
            case Kill():
                return self._kill(self._name_of(command.slot))
            case Revive():
                return self._revive(self._name_of(command.slot))
            case Expel():
                return self._expel(command.slot)
            case ChooseLinks():
                return self._link(command)
            case SetDamping():
                return self._damp(command.fraction)
            case _:
                assert_never(command)

    def _acts(self) -> None:
        self._acted = time.monotonic()

    def _name_of(self, slot: int) -> str:
        return self._names[_requests.slot_among(slot, self._scene.own)]

    def hold_damping(self, on: bool) -> None:
        """Says whether whoever lowered the damping is still there; see `SessionApi.hold_damping`."""
        self._damping.hold(on)

    def _impair(self, command: Impair) -> str:
        a, b = _requests.ends_of(command, len(self._names))
        changes = command.changes()
        for to, of in ((a, b), (b, a)):
            self._commands.impair(to, of, **changes)
        units = {"delay": ("ms", 1e3), "jitter": ("ms", 1e3), "loss": ("%", 1e2)}
        told = ", ".join(f"{name} {units[name][1] * value:g} {units[name][0]}" for name, value in changes.items())
        self.acted = True
        return f"{self._names[a]} - {self._names[b]}: {told}, each way"

    def _cut(self, command: Cut) -> str:
        a, b = _requests.ends_of(command, len(self._names))
        for to, of in ((a, b), (b, a)):
            self._commands.impair(to, of, cut=float(command.on))
        self.acted = True
        return self._told(f"the path {self._names[a]} - {self._names[b]} is {'cut' if command.on else 'restored'}")

    def _kill(self, name: str) -> str:
        if name not in self.members or name in self._killed:
            raise SessionError(f"{name} is not running on this machine")
        self._end(name)
        return self._told(f"{name}'s process was killed; its slot is kept for it")

    def _end(self, name: str) -> None:
        self._killed.add(name)
        self.members[name].kill()
        self._commands.forget(name)
        self.acted = True

    def _expel(self, slot: int) -> str:
        """Of whoever was started here only the place is freed, so that it can come back; others are sent away."""
        name = self._name_of(slot)
        elsewhere = slot not in self._alive(self.opened.host.roster)
        self.opened.host.coordinator.expel(name, ban=elsewhere)
        if name in self.members and name not in self._killed:
            self._end(name)
        self.acted = True
        return self._told(
            f"{name} was expelled for the rest of the session" if elsewhere else f"the slot of {name} is free"
        )

    def _revive(self, name: str) -> str:
        if name in self.members and name not in self._killed:
            raise SessionError(f"{name} is already running")
        self._begin(name)
        return f"{name} joins again"

    def _link(self, command: ChooseLinks) -> str:
        links = _requests.links_of(command, self._choices, len(self._names))
        try:
            self.opened.host.coordinator.choose(links)
        except NetworkError as error:
            raise SessionError(str(error)) from error
        self.acted = True
        pairs = ", ".join(f"{a + 1}-{b + 1}" for a, b in self.opened.host.roster.links)
        return f"links are now {pairs or 'none'}"

    def _damp(self, fraction: float) -> str:
        self._damping.give(fraction)
        if fraction < 1.0:
            self.acted = self.lowered = True
            self._told(f"ALARM: damping is {100.0 * fraction:.2g} % of what passivity needs; this is not passive")
            return f"damping is {100.0 * fraction:.2g} % of what passivity needs, and no link is guarded"
        return self._told("damping is what passivity needs, and links are guarded")

    def _told(self, text: str) -> str:
        """Of what has just been done: what everybody who looks on reads is the answer, too."""
        self._say(time.monotonic(), text)
        return text
