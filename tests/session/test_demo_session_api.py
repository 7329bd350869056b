"""A session of processes on this machine that is shown, and told what to do, as a page would."""

import shutil
import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from tests.session.test_planner import Here

from cotouch.control import Invitation
from cotouch.errors import SessionError
from cotouch.members import Entry, Roster, SessionFile, SharedModel
from cotouch.observers import (
    ChooseLinks,
    Cut,
    Expel,
    HandView,
    Impair,
    Kill,
    MoveHand,
    Pointer,
    Revive,
    SetDamping,
    SetRecording,
    mailbox_folder,
)
from cotouch.recording import audit, read_recording
from cotouch.session import DemoSessionApi, demo_session, member_session_api, play

USERS = """
[session]
[network]
users = {names}
spring = {springs}
delay = {springs}
"""
# What any wait is bounded by; only a child that compiles on a busy machine takes more than a tenth of it [s].
_PATIENCE = 300.0


def place(api: DemoSessionApi, slot: int) -> float:
    view = api.views().get(slot)
    return np.nan if view is None else float(view.displacement[0, 0])


def states(api: DemoSessionApi, a: int, b: int) -> set[str]:
    """Of both ends of a link; "unknown" of a member that has not been heard of lately."""
    statuses = api.overview().statuses
    ends = (
        {link.slot: link.state for link in statuses[one].links}.get(two)
        for one, two in ((a, b), (b, a))
        if one in statuses
    )
    found = [state for state in ends if state is not None]
    return {*found, *(["unknown"] if len(found) < 2 else [])}


def coupled(api: DemoSessionApi) -> bool:
    overview = api.overview()
    ends = [link.state for status in overview.statuses.values() for link in status.links]
    return len(overview.statuses) == 3 and len(ends) == 6 and set(ends) == {"coupled"}


class Shake:
    """What copies do while they run away: how often they turned, and energy at first and at most [J]."""

    def __init__(self) -> None:
        self.turns, self.first, self.most = 0, 0.0, 0.0
        self._before: tuple[float, float] = (0.0, 0.0)

    def sees(self, api: DemoSessionApi) -> bool:
        energy = sum(view.energy for view in api.views().values())
        self.first = self.first or energy
        self.most = max(self.most, energy)
        now, (earlier, last) = place(api, 0), self._before
        if now != last:
            self.turns += (last - earlier) * (now - last) < 0.0
            self._before = (last, now)
        return True


class Script:
    """Steps that each wait for something; moved on by the session's own loop."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.steps: Iterator[Callable[[], bool]] | None = None
        self.waiting: Callable[[], bool] | None = None
        self.until = float("inf")
        self.done = False
        self.number = 0
        self.holds = True  # whether somebody is there who lowered the damping

    def __call__(self, api: DemoSessionApi, now: float) -> None:
        if self.steps is None:
            self.steps = self.play(api)
        if self.done:
            return
        if self.holds:
            api.hold_damping(True)
        if self.waiting is not None and not self.waiting():
            commanded = [f"{event.text}" for event in api.overview().events]
            assert now < self.until, (self.waiting.__code__.co_firstlineno, commanded, api.overview().statuses)
            return
        self.waiting = next(self.steps, None)
        self.until = now + _PATIENCE
        self.done = self.waiting is None

    def point(self, api: DemoSessionApi, slot: int, x: float) -> None:
        self.number += 1
        api.point(slot, Pointer(number=self.number, mode="grab", node=0, target=(x, 0.0, 0.0)))

    def play(self, api: DemoSessionApi) -> Iterator[Callable[[], bool]]:
        yield lambda: len(api.views()) == 3 and all(view.direct for view in api.views().values())
        # Who is not the loop waits for it.
        said: list[str] = []
        thread = threading.Thread(target=lambda: said.append(api.do(ChooseLinks(links=((0, 1), (1, 2), (0, 2))))))
        thread.start()
        yield lambda: bool(said)
        assert said == ["links are now 1-2, 1-3, 2-3"]
        for to, of in ((0, 1), (1, 2), (0, 2)):
            api.do(Impair(a=to, b=of, delay=0.02))
        yield lambda: coupled(api)

        before = [place(api, slot) for slot in range(3)]
        moved: dict[int, float] = {}

        def dragged() -> bool:
            self.point(api, 0, before[0] + 0.3)
            for slot in range(3):
                if place(api, slot) - before[slot] > 0.02:
                    moved.setdefault(slot, api.views()[slot].time)
            return len(moved) == 3

        yield dragged
        assert moved[0] < min(moved[1], moved[2])
        assert api.views()[0].hands[0].mode == "grab"
        far = place(api, 0)
        api.do(MoveHand(slot=0, mode="free"))
        yield lambda: place(api, 0) < far - 0.01
        assert api.views()[0].hands[0].mode == "free"

        api.do(Cut(a=0, b=1, on=True))
        yield lambda: "guarded" in states(api, 0, 1)
        assert api.overview().emulated[0, 1].cut
        api.do(Cut(a=0, b=1, on=False))
        yield lambda: states(api, 0, 1) == {"coupled"}

        api.do(SetDamping(fraction=0.5))
        yield lambda: all((status.damping_margin or 0.0) < -0.4 for status in api.overview().statuses.values())
        assert any("not passive" in event.text for event in api.overview().events)
        api.do(SetDamping(fraction=1.0))
        yield lambda: all((status.damping_margin or 0.0) > -1e-9 for status in api.overview().statuses.values())

        # All copies run away in the end, are caught, and calm down; nobody's process dies of it.
        api.do(MoveHand(slot=0, mode="pull", node=0, to=(0.03, 0.0, 0.0)))
        yield lambda: place(api, 0) > 0.005
        api.do(MoveHand(slot=0, mode="free"))
        assert api.do(SetDamping(fraction=0.01)) == "damping is 1 % of what passivity needs, and no link is guarded"
        shake = Shake()
        yield lambda: shake.sees(api) and api.overview().damping == 1.0
        assert shake.turns >= 2
        assert shake.most > 10.0 * shake.first
        assert sum("ran away" in event.text for event in api.overview().events) == 1
        yield lambda: sum(view.energy for view in api.views().values()) < 1e-3 * shake.most
        assert all(api.overview().alive.values())
        # Who ran away a moment after the first ends no later order.
        api.do(SetDamping(fraction=0.6))
        since = time.monotonic()
        yield lambda: time.monotonic() > since + 0.5
        assert api.overview().damping == 0.6
        api.do(SetDamping(fraction=1.0))
        yield lambda: coupled(api)

        assert api.recorded() == ()
        began = time.monotonic()
        api.do(SetRecording(on=True))
        with pytest.raises(SessionError, match="under way"):
            api.do(SetRecording(on=True))
        yield lambda: api.overview().recording.seconds > 1.0
        recording_state = api.overview().recording
        assert (recording_state.state, recording_state.number) == ("on", 1)
        assert recording_state.seconds < time.monotonic() - began
        api.do(SetRecording(on=False))
        yield lambda: api.overview().recording.state == "done"
        recording_state = api.overview().recording
        assert recording_state.troubles == ()
        assert recording_state.text.startswith("3 files of 1.")
        assert [(path.name, path.stat().st_size) for path in api.recorded()] == list(recording_state.files)
        for path in api.recorded():
            assert path.stat().st_mode & 0o777 == 0o600
            shutil.copy(path, self.folder)
        # The shortest that there can be is kept, too: a step of everybody.
        api.do(SetRecording(on=True))
        api.do(SetRecording(on=False))
        yield lambda: api.overview().recording.state == "done"
        assert (api.overview().recording.number, api.overview().recording.troubles) == (2, ())
        assert [read_recording(path).steps >= 1 for path in api.recorded()] == [True] * 3

        api.do(Kill(slot=2))
        with pytest.raises(SessionError, match="is not running"):
            api.do(Kill(slot=2))
        yield lambda: not api.overview().alive[2]
        invitation = api.scene.invitation
        assert invitation is not None
        visitor = Visitor(invitation, "Cleo")
        yield lambda: not visitor.thread.is_alive()
        assert visitor.failure is None, visitor.failure
        api.do(Revive(slot=2))
        yield lambda: api.overview().alive[2] and 2 in api.views() and api.views()[2].direct
        yield lambda: {"best", "worst", "start"} <= api.overview().choices.keys()
        best = api.overview().choices["best"]
        api.do(ChooseLinks(choice="best"))
        yield lambda: sorted(api.overview().roster.links) == sorted(best)


class Visitor:
    """Somebody who takes a slot over from another computer, with a page of its own."""

    def __init__(self, invitation: str, name: str) -> None:
        self.failure: str | None = None
        self.thread = threading.Thread(target=self.run, args=(Invitation.decode(invitation), name))
        self.thread.start()

    def run(self, invitation: Invitation, name: str) -> None:
        end = time.monotonic() + _PATIENCE
        number, moved, others = 0, False, False
        try:
            with member_session_api(invitation, name=name, listen="127.0.0.1", options=["--device", "none"]) as api:
                while time.monotonic() < end and not (moved and others):
                    api.tick(time.monotonic())
                    if api.slot is not None:
                        number += 1
                        pointer = Pointer(number=number, mode="grab", node=0, target=(0.2, 0.0, 0.0))
                        api.point(api.slot, pointer)
                        views = api.views()
                        moved |= views[api.slot].hands[0].force[0] > 0.5
                        others |= any(not view.direct for view in views.values())
                    time.sleep(0.02)
                assert api.scene.own == (2,)
                assert api.scene.may == {"hand", "record"}
            assert moved
            assert others
        except Exception as error:
            self.failure = repr(error)
            raise


def test_what_a_page_can_do(tmp_path: Path) -> None:
    script = Script(tmp_path)
    outcome = play(
        demo_session(users=3, seconds=None, law="spring"), seconds=None, each=script, stopped=lambda: script.done
    )
    recordings = [read_recording(path) for path in sorted(tmp_path.glob("*.mcap"))]
    assert {recording.name for recording in recordings} == {"Ann", "Ben", "Cleo"}
    result = audit(recordings)
    assert result.holds, result.verdict
    # How many steps a busy machine makes of its second is another matter.
    assert all(recording.time[-1] - recording.time[0] > 0.5 for recording in recordings)
    assert all(recording.steps > 10 for recording in recordings)
    assert outcome.residual < 1e-9
    assert outcome.complaints == []


class QuietHost:
    """A host that nobody joins by itself."""

    def __init__(self) -> None:
        self.expelled: list[tuple[str, bool]] = []
        self.host = SimpleNamespace(
            watch=SimpleNamespace(events=[], roster=Roster(), members={}, left=False, ended=False),
            roster=Roster(),
            coordinator=SimpleNamespace(
                choose=lambda links: None, expel=lambda name, ban: self.expelled.append((name, ban))
            ),
        )
        self.invitation = SimpleNamespace(encode=lambda: "invitation")

    def service(self, now: float) -> None:
        pass


def test_links_are_looked_for_only_once_somebody_looks_and_the_search_ends_with_the_stage() -> None:
    """In a process of its own: it may have to compile for a minute, and nothing waits for that."""
    session = demo_session(users=3)
    opened: Any = QuietHost()
    with mailbox_folder() as mailboxes:
        api = DemoSessionApi(session, opened, SharedModel.build(session), mailboxes)
        before = set(children())
        api.choose_links()
        for now in range(3):
            api.tick(float(now))
        assert set(children()) == before
        assert set(api.overview().choices) == {"start"}
        api.tick(3.0)
        (child,) = set(children()) - before
        api.close()
        assert child not in children()
    assert not [thread for thread in threading.enumerate() if not thread.daemon and thread.name.startswith("cotouch")]


def test_of_the_paper_s_network_the_best_links_are_those_that_it_starts_with(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("cotouch.session._demo_session_api.ChildCall", Here)
    session = demo_session(law="spring")
    opened: Any = QuietHost()
    with mailbox_folder() as mailboxes:
        api = DemoSessionApi(session, opened, SharedModel.build(session), mailboxes)
        api.choose_links()
        api.overview()
        api.tick(0.0)
        choices = api.overview().choices
        api.close()
    assert choices["best"] == choices["start"] == [(0, 1), (0, 3), (1, 2), (1, 3), (2, 3), (3, 4)]
    assert choices["worst"] == [(0, 2), (0, 3), (1, 2), (1, 4), (2, 3), (2, 4)]


class StandIn:
    """A member's process that is none."""

    running = True

    def kill(self) -> None:
        self.running = False

    close = kill


def test_whoever_came_from_elsewhere_is_sent_away_and_the_place_of_a_process_here_is_freed() -> None:
    session = demo_session(users=3)
    opened: Any = QuietHost()
    with mailbox_folder() as mailboxes:
        api = DemoSessionApi(session, opened, SharedModel.build(session), mailboxes)
        for name in ("Ann", "Ben", "Cleo"):
            api.members[name] = StandIn()  # type: ignore[assignment]
        keys = {"Ann": "a" * 64, "Ben": "b" * 64, "Cleo": "c" * 64}

        def here() -> None:
            members = [Entry(slot=slot, name=name, key=key) for slot, (name, key) in enumerate(keys.items())]
            opened.host.watch.roster = opened.host.roster = Roster(members=members)
            api.tick(0.0)

        def asked(slot: int) -> str:
            said: list[str] = []
            thread = threading.Thread(target=lambda: said.append(api.do(Expel(slot=slot))))
            thread.start()
            while thread.is_alive():
                api.tick(0.0)
            return said[0]

        here()
        assert api.overview().alive == {0: True, 1: True, 2: True}
        assert asked(1) == "the slot of Ben is free"
        assert opened.expelled == [("Ben", False)]
        assert not api.members["Ben"].running
        assert api.overview().alive == {0: True, 1: False, 2: True}
        keys["Ben"] = "d" * 64  # somebody from elsewhere
        here()
        assert api.overview().alive == {0: True, 2: True}
        assert asked(1) == "Ben was expelled for the rest of the session"
        assert opened.expelled[1:] == [("Ben", True)]
        api.close()


@pytest.mark.parametrize(("cores", "real_time"), [(2, False), (3, False), (4, True)])
def test_members_leave_a_processor_to_the_page(cores: int, real_time: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    """With real-time priority on every core they would starve the page's server, which comes up beside them."""
    begun: list[list[str]] = []

    def member(invitation: object, options: list[str], *, as_json: bool) -> StandIn:
        begun.append(options)
        return StandIn()

    monkeypatch.setattr("cotouch.session._demo_session_api.MemberProcess", member)
    monkeypatch.setattr("cotouch.session._demo_session_api.cores", lambda: cores)
    session = demo_session(users=3)
    opened: Any = QuietHost()
    with mailbox_folder() as mailboxes:
        api = DemoSessionApi(session, opened, SharedModel.build(session), mailboxes)
        api.start()
        assert ["--ordinary" not in options for options in begun] == [real_time] * 3
        api.close()


def test_a_demo_is_called_by_how_many_it_has() -> None:
    titles = {users: demo_session(users=users).scenario.title for users in (1, 2, 5, 12)}
    assert titles == {
        1: "One user, one object",
        2: "Two users, one object",
        5: "Five users, one object",
        12: "12 users, one object",
    }


def test_hands_wander_where_all_rests_and_nobody_acts(monkeypatch: pytest.MonkeyPatch) -> None:
    session = demo_session(users=2)
    opened: Any = QuietHost()
    with mailbox_folder() as mailboxes:
        api = DemoSessionApi(session, opened, SharedModel.build(session), mailboxes, rouse=True)
        now, force = 1000.0, 0.5
        monkeypatch.setattr("cotouch.session._demo_session_api.time.monotonic", lambda: now)
        hand = lambda: HandView(force=np.array([force, 0.0, 0.0], np.float32))  # noqa: E731
        monkeypatch.setattr(api, "views", lambda: {0: SimpleNamespace(hands=[hand()])})

        def wait(seconds: float) -> list[str]:
            nonlocal now
            for _ in range(round(10 * seconds)):
                now += 0.1
                api.tick(now)
            return [api._commands.mode(name) for name in ("Ann", "Ben")]

        assert wait(30.0) == ["script", "script"]
        force = 0.0
        assert wait(30.0) == ["script", "script"]  # nobody looks
        api.overview()
        force = 0.5
        assert wait(30.0) == ["script", "script"]  # something happens
        force = 0.0
        assert wait(19.0) == ["script", "script"]
        api.do(MoveHand(slot=1, mode="hold"))  # somebody acts
        assert wait(19.0) == ["script", "hold"]
        assert wait(2.0) == ["wander", "hold"]  # what somebody asked for stays
        force = 0.5
        assert wait(30.0) == ["wander", "hold"]
        api.point(0, Pointer(number=1, mode="grab", node=0, target=(0.1, 0.0, 0.0)))
        assert wait(1.0) == ["grab", "hold"]
        api.close()


def children() -> list[int]:
    """Processes that this one started and that still run."""
    found: list[int] = []
    for task in Path("/proc/self/task").iterdir():
        found += [int(pid) for pid in (task / "children").read_text(encoding="utf-8").split()]
    return found


@pytest.mark.parametrize(
    ("body", "law", "has", "links"),
    [
        ("point", None, "paid", 10),
        ("block", None, "paid", 10),
        ("point", "spring", "spring", 6),
        ("point", "wave", "wave", 6),
    ],
)
def test_it_has_the_default_law_where_all_are_linked_over_paths_that_are_short_enough(
    body: str, law: str | None, has: str, links: int
) -> None:
    session = demo_session(body=body, law=law)
    assert (session.law, len(session.scenario.network.links)) == (has, links)


@pytest.mark.parametrize(("law", "lowered"), [("spring", True), ("paid", False)])
def test_damping_is_offered_only_where_it_keeps_links_safe(law: str, lowered: bool) -> None:
    session = demo_session(users=3, law=law)
    opened: Any = QuietHost()
    with mailbox_folder() as mailboxes:
        api = DemoSessionApi(session, opened, SharedModel.build(session), mailboxes)
        assert ("damping" in api.scene.may) == lowered
        api.close()


def test_a_name_leads_no_recording_out_of_its_folder(monkeypatch: pytest.MonkeyPatch) -> None:
    """Names come from the session's file, which may be somebody else's."""
    begun: list[list[str]] = []

    def member(invitation: object, options: list[str], *, as_json: bool) -> StandIn:
        begun.append(options)
        return StandIn()

    monkeypatch.setattr("cotouch.session._demo_session_api.MemberProcess", member)
    names = ["../../x", "/etc/x", "a\\b", "..", "Ann 2", "Ann #2", "100%", "a/b", "a%2Fb", "a:b", "Zoë B", "Ann"]
    session = SessionFile.from_toml(USERS.format(names=names, springs=(1.0 - np.eye(len(names))).tolist()))
    opened: Any = QuietHost()
    with mailbox_folder() as mailboxes:
        api = DemoSessionApi(session, opened, SharedModel.build(session), mailboxes, record=Path("rec"))
        api.start()
        api.start()  # as after a crash of each
        api.close()
    files = [Path(options[options.index("--record") + 1]) for options in begun]
    assert {file.parent for file in files} == {Path("rec")}
    assert len(set(files)) == 2 * len(names)
    assert [file.name for file in files[len(names) - 2 : len(names)]] == ["Zoë B.mcap", "Ann.mcap"]
    assert files[-1].name == "Ann #2.mcap"
