"""A whole session on this machine as a stage: its host in this process, and a process for each user."""

import time
from collections import deque
from collections.abc import Callable, Mapping
from concurrent.futures import Future, ThreadPoolExecutor
from pathlib import Path
from typing import Any, final

from cotouch.errors import NetworkError, SessionError
from cotouch.session import _wishes
from cotouch.session._boards import BoardFolder
from cotouch.session._desk import Desk
from cotouch.session._file import SessionFile
from cotouch.session._jobs import Jobs
from cotouch.session._links import Pair
from cotouch.session._open import OpenHost
from cotouch.session._planner import notable_links
from cotouch.session._process import MemberProcess
from cotouch.session._recording import RecordingDesk
from cotouch.session._replica import Replica
from cotouch.session._stage import CopyView, Overview, Pointer, Scene
from cotouch.session._told import usual_stiffness
from cotouch.session._watch import Event

_MOST_EVENTS = 200
# Choices of links that were looked for and not found.
_NONE_FOUND: dict[str, list[Pair]] = {"best": [], "worst": []}


@final
class DemoStage:
    """Implements `Stage`.

    `start`, `tick` and `close` belong to the loop that moves the session.

    Attributes:
        opened: the host.
        members: a process for each user, by name; of one that was revived, the last.
        acted: whether somebody changed how the session goes, so that its end says little.
    """

    def __init__(
        self,
        session: SessionFile,
        opened: OpenHost,
        replica: Replica,
        boards: BoardFolder,
        *,
        record: Path | None = None,
    ) -> None:
        """Prepares the session; nobody takes part yet.

        Args:
            session: with scripted hands.
            opened: its host.
            replica: the body as built here.
            boards: where members are shown and told things.
            record: an existing folder for a recording of each user's whole part.

        Raises:
            InputError: a board cannot be made.
        """
        self.opened = opened
        self.members: dict[str, MemberProcess] = {}
        self.acted = False
        self._session, self._boards, self._record = session, boards, record
        self._names = list(session.scenario.network.users)
        self._desk = Desk(boards, session, self._names)
        self._tapes = RecordingDesk(boards, self._desk)
        self._jobs = Jobs()
        own = tuple(range(len(self._names)))
        self._scene = Scene(
            title=session.scenario.title or "cotouch",
            users=tuple(self._names),
            body=replica.body,
            own=own,
            may=frozenset({"hand", "impair", "cut", "kill", "revive", "links", "damping", "record"}),
            invitation=opened.invitation.encode(),
            stiffness=usual_stiffness(replica.scenario, 0),
        )
        self._events = deque[Event](maxlen=_MOST_EVENTS)
        self._killed = set[str]()
        self._loosened = set[str]()  # hands that let go while damping is lowered
        self._share, self._ordered = 1.0, 0  # of the damping, and the number of that order
        self._lives = dict.fromkeys(self._names, 0)
        self._pool = ThreadPoolExecutor(1, thread_name_prefix="cotouch choices")
        self._planned: Future[dict[str, list[Pair]]] | None = None
        self._choices: dict[str, list[Pair]] = {"start": sorted(session.scenario.network.links)}
        self._overview = self._looked(0.0)

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
        for name, member in self.members.items():
            if name not in self._killed and not member.running:
                self._killed.add(name)
                self._desk.forget(name)
                self._say(now, f"{name}'s process ended: {member.complaint() or 'without a word'}")
        self._catch(now)
        if self._planned is not None and self._planned.done():
            found = self._planned.result() if self._planned.exception() is None else {}
            self._choices |= _NONE_FOUND | found
            self._planned = None
        self._tapes.turn(now, [name for name in self._names if name not in self._killed])
        self._overview = self._looked(now)

    def choose_links(self) -> None:
        """Begins to look for the best and the worst links; they are among the choices once they are found."""
        if len(self._names) > 1 and self._session.scenario.network.links:
            self._planned = self._pool.submit(notable_links, self._session)
        else:
            self._choices |= _NONE_FOUND

    def close(self) -> None:
        """Ends every process and lets go of everything."""
        self._jobs.close()
        self._pool.shutdown(wait=False, cancel_futures=True)
        for member in self.members.values():
            member.close()
        self._tapes.close()
        self._desk.close()

    def _begin(self, name: str) -> None:
        options = ["--name", name, "--headless", "--boards", str(self._boards.path), "--unsafe"]
        if self._record is not None:
            life = self._lives[name]
            path = self._record / (f"{name}.mcap" if not life else f"{name} {life + 1}.mcap")
            options += ["--record", str(path)]
        self._lives[name] += 1
        before = self.members.get(name)
        if before is not None:
            before.close()
        self.members[name] = MemberProcess(self.opened.invitation, options, as_json=True)
        self._killed.discard(name)

    def _catch(self, now: float) -> None:
        """Gives everybody their damping back where a copy ran away."""
        if self._share >= 1.0:
            return
        for name in self._names:
            # Others may have been caught by an earlier order a moment after the first was.
            if self._desk.number(name, "caught") == self._ordered:
                self._say(now, f"ALARM: {name}'s copy ran away; everybody's damping is back")
                self._damp(1.0)
                return

    def _looked(self, now: float) -> Overview:
        watch = self.opened.host.watch
        events = sorted([*watch.events, *self._events], key=lambda event: event.time)
        return Overview(
            roster=watch.roster,
            statuses={seat: seen.status for seat, seen in watch.members.items() if seen.status is not None},
            alive={seat: name in self.members and name not in self._killed for seat, name in enumerate(self._names)},
            emulated=self._desk.emulated(),
            choices=dict(self._choices),
            damping=self._share,
            recording=self._tapes.since(now),
            events=events[-_MOST_EVENTS:],
            ended=watch.ended,
        )

    def _say(self, now: float, text: str) -> None:
        self._events.append(Event(now, text))

    # -- any thread --------------------------------------------------------------------------------------------------

    @property
    def scene(self) -> Scene:
        """What does not change."""
        return self._scene

    def views(self) -> Mapping[int, CopyView]:
        """The newest of every copy that can be seen, by seat."""
        return self._desk.views()

    def overview(self) -> Overview:
        """How things were at the last `tick`."""
        return self._overview

    def point(self, seat: int, pointer: Pointer) -> None:
        """Moves a user's pointer; see `Stage.point`.

        Raises:
            SessionError: no such seat, or a number is wrong.
        """
        name = self._names[_wishes.seat_of({"seat": seat}, self._scene.own)]
        self._desk.point(name, _wishes.checked(pointer, self._scene.body))

    def do(self, what: str, arguments: Mapping[str, Any]) -> str:
        """See `Stage.do`; waits for the loop where it has to do it.

        Raises:
            SessionError: it cannot be done.
        """
        doing: dict[str, Callable[[Mapping[str, Any]], str]] = {
            "hand": self._do_hand,
            "impair": self._do_impair,
            "cut": self._do_cut,
            "kill": lambda given: self._jobs.ask(lambda: self._do_kill(given)),
            "revive": lambda given: self._jobs.ask(lambda: self._do_revive(given)),
            "links": lambda given: self._jobs.ask(lambda: self._do_links(given)),
            "damping": lambda given: self._jobs.ask(lambda: self._do_damping(given)),
            "record": lambda given: self._jobs.ask(lambda: self._do_record(given)),
        }
        if what not in doing:
            raise SessionError(f'"{what}" is nothing that can be done here; it must be one of {", ".join(doing)}')
        return doing[what](arguments)

    def recorded(self) -> bytes | None:
        """The last finished recording as a ZIP archive of MCAP files; None before there is one."""
        return self._tapes.archive

    def _do_hand(self, given: Mapping[str, Any]) -> str:
        name = self._names[_wishes.seat_of(given, self._scene.own)]
        mode, node, to = _wishes.hand_of(given, self._scene.body)
        self._desk.hand(name, mode, node=node, to=to)
        return f"{name} {_wishes.WORDS[mode]}"

    def _do_impair(self, given: Mapping[str, Any]) -> str:
        a, b = _wishes.pair_of(given, len(self._names))
        law = _wishes.law_of(given)
        for to, of in ((a, b), (b, a)):
            self._desk.impair(to, of, **law)
        units = {"delay": ("ms", 1e3), "jitter": ("ms", 1e3), "loss": ("%", 1e2)}
        told = ", ".join(f"{name} {units[name][1] * value:g} {units[name][0]}" for name, value in law.items())
        self.acted = True
        return f"{self._names[a]} - {self._names[b]}: {told}, each way"

    def _do_cut(self, given: Mapping[str, Any]) -> str:
        a, b = _wishes.pair_of(given, len(self._names))
        on = _wishes.flag_of(given)
        for to, of in ((a, b), (b, a)):
            self._desk.impair(to, of, cut=float(on))
        self.acted = True
        said = f"the path {self._names[a]} - {self._names[b]} is {'cut' if on else 'there again'}"
        self._say(time.monotonic(), said)
        return said

    def _do_kill(self, given: Mapping[str, Any]) -> str:
        name = self._names[_wishes.seat_of(given, self._scene.own)]
        member = self.members.get(name)
        if member is None or name in self._killed:
            raise SessionError(f"{name} does not run on this machine")
        self._killed.add(name)
        member.kill()
        self._desk.forget(name)
        self.acted = True
        said = f"{name}'s process was killed; the seat is free for whoever joins as {name}"
        self._say(time.monotonic(), said)
        return said

    def _do_revive(self, given: Mapping[str, Any]) -> str:
        name = self._names[_wishes.seat_of(given, self._scene.own)]
        if name in self.members and name not in self._killed:
            raise SessionError(f"{name} runs already")
        self._begin(name)
        return f"{name} joins again"

    def _do_links(self, given: Mapping[str, Any]) -> str:
        links = _wishes.links_of(given, self._choices, len(self._names))
        try:
            self.opened.host.choose(links)
        except NetworkError as error:
            raise SessionError(str(error)) from error
        self.acted = True
        pairs = ", ".join(f"{a + 1}-{b + 1}" for a, b in self.opened.host.roster.links)
        return f"linked are {pairs or 'none'}"

    def _do_damping(self, given: Mapping[str, Any]) -> str:
        share = _wishes.share_of(given)
        self._damp(share)
        now = time.monotonic()
        if share < 1.0:
            self.acted = True
            self._say(now, f"ALARM: damping is {100.0 * share:.2g} % of what passivity needs; this is not passive")
            return f"damping is {100.0 * share:.2g} % of what passivity needs, and no link is guarded"
        self._say(now, "damping is what passivity needs, and links are guarded")
        return "damping is what passivity needs, and links are guarded"

    def _damp(self, share: float) -> None:
        """Hands of the file let go meanwhile: holding damps, and would hide what is to be seen."""
        self._share = share
        if share < 1.0:
            scripted = [name for name in self._names if self._desk.mode(name) == "script"]
            self._loosened.update(scripted)
            for name in scripted:
                self._desk.hand(name, "free")
        else:
            for name in self._loosened:
                if self._desk.mode(name) == "free":
                    self._desk.hand(name, "script")
            self._loosened.clear()
        self._ordered = self._desk.damping(share)

    def _do_record(self, given: Mapping[str, Any]) -> str:
        return self._tapes.switch(_wishes.flag_of(given), time.monotonic())
