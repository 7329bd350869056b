"""Whole sessions over emulated networks: host and members are processes in namespaces, everything is recorded.

Control and samples go through the same star. Faults follow each other within one session, to save the starts.
"""

import contextlib
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from tests.live.emulator.star import Star, obstacle
from tests.live.test_networks import DELAY, LINKS
from tests.session.session_api import LIFE, PATIENCE, Stage, apart, api, calmest, everywhere, judged

from cotouch.peer import LinkState
from cotouch.recording import Recording
from cotouch.samples import PathLaw

no_star = obstacle()
pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(no_star is not None, reason=f"no emulated network: {no_star}"),
]

ROOT = Path(__file__).parents[2]
FORCE = 20.0
NEAR = 8e-3  # after faults that took copies 20 mm apart and more [m]
# One hand, which goes back and forth and rests in between.
HAND = """
[session]
window = 4.0
force_limit = {force}
per_address = 5  # on a busy machine several join before the host has seen their addresses
[[hands]]
user = 1
path = [{path}]
stiffness = 60.0
damping = 2.0
"""


def hand(rest: float) -> str:
    places = [f"[{t}, {x}]" for k in range(120) for t, x in (((rest + 0.5) * k, 0.1 * (k % 2)),) for t, x in (
        (t, x), (t + rest, x))]  # fmt: skip
    return HAND.format(path=", ".join(places), force=FORCE)


WINDOW = 2.0
# The jitter takes short links' budgets to three times what they were. Rates that were halved take longer to come back,
# and until then what samples are older by for that is in budgets. How long it takes is asked on a virtual clock
# (test_recovery.py), where nothing else is at work.
WIDE = 1.5
CYCLE = 5.9
FAULTS = {"jitter": {"jitter": 0.2}, "reordering": {"reordering": 0.5, "hold": 0.05}, "loss": {"loss": 0.3}}


def papers() -> str:
    text = (ROOT / "examples" / "live.toml").read_text()
    table = text[: text.index("[session]")].replace("rate = 500", "rate = 100")
    return table + hand(5.0).replace("window = 4.0", f"window = {WINDOW}")


THREE = """
title = "Three users"
[network]
users = ["Ann", "Ben", "Cleo"]
spring = [[0, 60, 60], [60, 0, 60], [60, 60, 0]]
delay = [[0, 0.01, 0.01], [0.01, 0, 0.01], [0.01, 0.01, 0]]
[body]
mass = 1.0
[steps]
rate = 200
[synchronisation]
law = "spring"
""" + hand(3.5)


def test_the_papers_network_with_jitter_reordering_and_loss(tmp_path: Path) -> None:
    names = ["Ann", "Ben", "Cleo", "Dan", "Eve"]
    times: dict[str, tuple[float, float, float]] = {}

    def paths(**more: float) -> None:
        everywhere(lambda i, j: PathLaw(delay=DELAY[i][j], **more), star, range(5))

    with Star(7, seconds=LIFE) as star:
        for user in range(5):  # to host and spectator paths are short and clean
            for other in (5, 6):
                star.set(user, other, PathLaw(delay=0.02))
                star.set(other, user, PathLaw(delay=0.02))
        paths()
        with api(star, tmp_path, papers(), names) as played:
            for name in names:
                played.join(name)
            together = played.coupled(*names, links=len(LINKS))
            played.wait(together, "not all came together")
            before: dict[tuple[str, int], float] = {}

            def as_before() -> bool:
                now = played.budgets()
                return together() and all(now.get(end, np.inf) <= WIDE * total for end, total in before.items())

            since = stretch(played, as_before, "not together for long enough")
            before |= played.budgets()
            for what, law in FAULTS.items():
                began = time.monotonic()
                paths(**law)
                time.sleep(4.0)
                paths()
                ended = time.monotonic()
                times[what] = began, ended, stretch(played, as_before, f"not as before after {what}")
            said = {name: played.stop(name) for name in names}
    recordings = judged(played, said, FORCE)
    # In each stretch the hand goes once and rests. Long ages need much damping: copies are always on their way.
    near, calm = farthest(recordings, since), calmest(recordings, since, since + CYCLE)
    assert near < 0.04
    for what, (began, ended, again) in times.items():
        if what == "jitter":  # the other two may stay within what the budgets leave
            assert guarded(recordings, began + 0.5, ended) > 0.02
        assert guarded(recordings, again, again + CYCLE) < 0.25, what  # one end of ten, all the time, and a little
        assert farthest(recordings, again) < WIDE * near, what  # damping follows budgets, and copies are apart by it
        assert calmest(recordings, again, again + CYCLE) < max(1.5 * calm, 0.5 * NEAR), what


def stretch(played: Stage, holds: Callable[[], bool], words: str) -> float:
    """Waits until something holds before and after the hand went once and rested; returns since when.

    Samples of a machine that has other work to do are late, which guards links: then once more, until one end at most
    was guarded meanwhile.
    """
    end = time.monotonic() + 2.0 * PATIENCE
    while True:
        played.wait(holds, words)
        since, before = time.monotonic(), played.guardings()
        time.sleep(CYCLE)
        with contextlib.suppress(AssertionError):
            played.wait(holds, words, patience=1.0)
            if played.guardings() <= before + 1:
                return since
        assert time.monotonic() < end, words


def farthest(recordings: list[Recording], since: float) -> float:
    """Most that copies are apart while the hand goes once and rests."""
    return float(apart(recordings, np.arange(since, since + CYCLE, 0.01)).max())


def guarded(recordings: list[Recording], begin: float, end: float) -> float:
    """Share of their time in which ends of links were guarded."""
    phases = [
        r.columns["link_state"][(r.columns["time"] > begin) & (r.columns["time"] < end)].ravel() for r in recordings
    ]
    return float((np.concatenate(phases) == LinkState.GUARDED).mean())


def test_partition_one_way_outage_crash_of_a_member_and_of_the_host(tmp_path: Path) -> None:
    names = ["Ann", "Ben", "Cleo"]
    clean = PathLaw(delay=0.01)
    times: dict[str, float] = {}

    def settled(what: str) -> None:
        played.wait(played.coupled(*names, links=3), f"not all came together after {what}")
        times[what] = time.monotonic()
        time.sleep(4.5)

    with Star(5, seconds=LIFE) as star:
        everywhere(lambda i, j: clean, star, range(5))
        with api(star, tmp_path, THREE, names) as played:
            for name in names:
                played.join(name)
            settled("the start")

            everywhere(lambda i, j: PathLaw(down=True) if 2 in {i, j} else clean, star, range(5))
            cut = time.monotonic()
            time.sleep(4.0)
            everywhere(lambda i, j: clean, star, range(5))
            healed = time.monotonic()
            settled("the partition")

            star.set(0, 1, PathLaw(down=True))
            time.sleep(3.0)
            star.set(0, 1, clean)
            settled("the outage one way")

            played.members["Cleo"].kill()
            played.members["Cleo"].wait(10)
            killed = time.monotonic()
            played.join("Cleo")
            played.wait(played.recordings["Cleo"][1].exists, "Cleo did not come back")
            settled("the crash")

            played.host.kill()
            played.host.wait(10)
            time.sleep(3.0)
            settled("the end of the host")
            said = {name: played.stop(name) for name in names}
    recordings = judged(played, said, FORCE)
    assert [recording.name for recording in recordings] == ["Ann", "Ben", "Cleo", "Cleo"]
    assert recordings[2].broken is not None
    assert recordings[2].columns["time"][-1] > killed - 0.6  # readable up to its last batch
    lost = recordings[0].columns["link_state"][:, recordings[0].neighbours.index(2)]
    during = (recordings[0].columns["time"] > cut + 0.5) & (recordings[0].columns["time"] < healed)
    assert set(lost[during]) == {LinkState.GUARDED}
    moved = apart(recordings[:3], np.arange(cut + 0.5, healed, 0.01))
    assert moved.max() > 2.5 * NEAR  # what recovers below
    for what, since in times.items():
        there = [r for r in recordings if r.columns["time"][0] < since and r.columns["time"][-1] > since + 4.0]
        assert len(there) == 3, what
        assert calmest(there, since, since + 4.0) < NEAR, what
