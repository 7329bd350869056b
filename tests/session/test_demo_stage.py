"""A session of processes on this machine that is shown, and told what to do, as a page would."""

import io
import threading
import time
import zipfile
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import pytest

from cotouch.errors import SessionError
from cotouch.live import Invitation
from cotouch.recording import audit, read_recording
from cotouch.session import DemoStage, Pointer, demo_session, member_stage, play

# What any wait is bounded by; what is waited for takes a tenth of it [s].
_PATIENCE = 60.0


def place(stage: DemoStage, seat: int) -> float:
    view = stage.views().get(seat)
    return np.nan if view is None else float(view.displacement[0, 0])


def states(stage: DemoStage, a: int, b: int) -> set[str]:
    statuses = stage.overview().statuses
    return {link.state for one, two in ((a, b), (b, a)) for link in statuses[one].links if link.seat == two}


def coupled(stage: DemoStage) -> bool:
    overview = stage.overview()
    ends = [link.state for status in overview.statuses.values() for link in status.links]
    return len(overview.statuses) == 3 and len(ends) == 6 and set(ends) == {"coupled"}


class Shake:
    """What copies do while they run away: how often they turned, and energy at first and at most [J]."""

    def __init__(self) -> None:
        self.turns, self.first, self.most = 0, 0.0, 0.0
        self._before: tuple[float, float] = (0.0, 0.0)

    def sees(self, stage: DemoStage) -> bool:
        energy = sum(view.energy for view in stage.views().values())
        self.first = self.first or energy
        self.most = max(self.most, energy)
        now, (earlier, last) = place(stage, 0), self._before
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

    def __call__(self, stage: DemoStage, now: float) -> None:
        if self.steps is None:
            self.steps = self.play(stage)
        if self.done:
            return
        if self.waiting is not None and not self.waiting():
            told = [f"{event.text}" for event in stage.overview().events]
            assert now < self.until, (self.waiting.__code__.co_firstlineno, told, stage.overview().statuses)
            return
        self.waiting = next(self.steps, None)
        self.until = now + _PATIENCE
        self.done = self.waiting is None

    def point(self, stage: DemoStage, seat: int, x: float) -> None:
        self.number += 1
        stage.point(seat, Pointer(number=self.number, mode="grab", node=0, target=(x, 0.0, 0.0)))

    def play(self, stage: DemoStage) -> Iterator[Callable[[], bool]]:
        yield lambda: len(stage.views()) == 3 and all(view.direct for view in stage.views().values())
        # Who is not the loop waits for it.
        said: list[str] = []
        thread = threading.Thread(target=lambda: said.append(stage.do("links", {"links": [[0, 1], [1, 2], [0, 2]]})))
        thread.start()
        yield lambda: bool(said)
        assert said == ["linked are 1-2, 1-3, 2-3"]
        for to, of in ((0, 1), (1, 2), (0, 2)):
            stage.do("impair", {"a": to, "b": of, "delay": 0.02})
        yield lambda: coupled(stage)

        before = [place(stage, seat) for seat in range(3)]
        moved: dict[int, float] = {}

        def dragged() -> bool:
            self.point(stage, 0, before[0] + 0.3)
            for seat in range(3):
                if place(stage, seat) - before[seat] > 0.02:
                    moved.setdefault(seat, stage.views()[seat].time)
            return len(moved) == 3

        yield dragged
        assert moved[0] < min(moved[1], moved[2])
        assert stage.views()[0].hands[0].mode == "grab"
        far = place(stage, 0)
        stage.do("hand", {"seat": 0, "mode": "free"})
        yield lambda: place(stage, 0) < far - 0.01
        assert stage.views()[0].hands[0].mode == "free"

        stage.do("cut", {"a": 0, "b": 1, "on": True})
        yield lambda: "guarded" in states(stage, 0, 1)
        assert stage.overview().emulated[0, 1].cut
        stage.do("cut", {"a": 0, "b": 1, "on": False})
        yield lambda: states(stage, 0, 1) == {"coupled"}

        stage.do("damping", {"share": 0.5})
        yield lambda: all((status.certificate or 0.0) < -0.4 for status in stage.overview().statuses.values())
        assert any("not passive" in event.text for event in stage.overview().events)
        stage.do("damping", {"share": 1.0})
        yield lambda: all((status.certificate or 0.0) > -1e-9 for status in stage.overview().statuses.values())

        # All copies run away in the end, are caught, and calm down; nobody's process dies of it.
        stage.do("hand", {"seat": 0, "mode": "pull", "node": 0, "to": [0.03, 0.0, 0.0]})
        yield lambda: place(stage, 0) > 0.005
        stage.do("hand", {"seat": 0, "mode": "free"})
        assert stage.do("damping", {"share": 0.01}) == "damping is 1 % of what passivity needs, and no link is guarded"
        shake = Shake()
        yield lambda: shake.sees(stage) and stage.overview().damping == 1.0
        assert shake.turns >= 2
        assert shake.most > 10.0 * shake.first
        assert sum("ran away" in event.text for event in stage.overview().events) == 1
        yield lambda: sum(view.energy for view in stage.views().values()) < 1e-3 * shake.most
        assert all(stage.overview().alive.values())
        # Who ran away a moment after the first ends no later order.
        stage.do("damping", {"share": 0.6})
        since = time.monotonic()
        yield lambda: time.monotonic() > since + 0.5
        assert stage.overview().damping == 0.6
        stage.do("damping", {"share": 1.0})
        yield lambda: coupled(stage)

        assert stage.recorded() is None
        stage.do("record", {"on": True})
        with pytest.raises(SessionError, match="under way"):
            stage.do("record", {"on": True})
        began = time.monotonic()
        yield lambda: time.monotonic() > began + 1.0
        assert stage.overview().recording == pytest.approx(time.monotonic() - began, abs=0.5)
        stage.do("record", {"on": False})
        yield lambda: stage.recorded() is not None
        archive = stage.recorded()
        assert archive is not None
        zipfile.ZipFile(io.BytesIO(archive)).extractall(self.folder)

        stage.do("kill", {"seat": 2})
        with pytest.raises(SessionError, match="does not run"):
            stage.do("kill", {"seat": 2})
        yield lambda: not stage.overview().alive[2]
        invitation = stage.scene.invitation
        assert invitation is not None
        visitor = Visitor(invitation, "Cleo")
        yield lambda: not visitor.thread.is_alive()
        assert visitor.failure is None, visitor.failure
        stage.do("revive", {"seat": 2})
        yield lambda: stage.overview().alive[2] and 2 in stage.views() and stage.views()[2].direct
        yield lambda: {"best", "worst", "start"} <= stage.overview().choices.keys()
        best = stage.overview().choices["best"]
        stage.do("links", {"choice": "best"})
        yield lambda: sorted(stage.overview().roster.links) == sorted(best)


class Visitor:
    """Somebody who takes a seat over from another computer, with a page of its own."""

    def __init__(self, invitation: str, name: str) -> None:
        self.failure: str | None = None
        self.thread = threading.Thread(target=self.run, args=(Invitation.decode(invitation), name))
        self.thread.start()

    def run(self, invitation: Invitation, name: str) -> None:
        end = time.monotonic() + _PATIENCE
        number, moved, others = 0, False, False
        try:
            with member_stage(invitation, name=name, listen="127.0.0.1", options=["--device", "none"]) as stage:
                while time.monotonic() < end and not (moved and others):
                    stage.tick(time.monotonic())
                    if stage.seat is not None:
                        number += 1
                        pointer = Pointer(number=number, mode="grab", node=0, target=(0.2, 0.0, 0.0))
                        stage.point(stage.seat, pointer)
                        views = stage.views()
                        moved |= views[stage.seat].hands[0].force[0] > 0.5
                        others |= any(not view.direct for view in views.values())
                    time.sleep(0.02)
                assert stage.scene.own == (2,)
                assert stage.scene.may == {"hand", "record"}
            assert moved
            assert others
        except Exception as error:
            self.failure = repr(error)
            raise


def test_what_a_page_can_do(tmp_path: Path) -> None:
    script = Script(tmp_path)
    outcome = play(demo_session(users=3, seconds=None), seconds=None, each=script, stopped=lambda: script.done)
    recordings = [read_recording(path) for path in sorted(tmp_path.glob("*.mcap"))]
    assert {recording.name for recording in recordings} == {"Ann", "Ben", "Cleo"}
    result = audit(recordings)
    assert result.holds, result.verdict
    assert all(recording.steps > 100 for recording in recordings)
    assert outcome.residual < 1e-9
    assert outcome.complaints == []
