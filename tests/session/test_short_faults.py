"""Faults of a few seconds in a session of real processes: nobody leaves, and all are coupled again as they were.

How long that takes is asked on a virtual clock (test_recovery.py); here the control plane, its leases and its
connections are the real ones.
"""

import signal
import time
from pathlib import Path

import pytest
from tests.live.emulator.star import Star, obstacle
from tests.session.session_api import LIFE, api, everywhere, judged
from tests.session.test_networks import FORCE, THREE

from cotouch.recording import Recording
from cotouch.samples import PathLaw

no_star = obstacle()
pytestmark = [pytest.mark.slow, pytest.mark.skipif(no_star is not None, reason=f"no emulated network: {no_star}")]
FAULT = 3.0


def test_a_process_that_stood_still_and_other_addresses(tmp_path: Path) -> None:
    names = ["Ann", "Ben", "Cleo"]
    began: dict[str, float] = {}
    with Star(5, seconds=LIFE) as star:
        everywhere(lambda i, j: PathLaw(delay=0.01), star, range(5))
        with api(star, tmp_path, THREE, names) as played:
            for name in names:
                played.join(name)
            coupled = played.coupled(*names, links=3)
            played.wait(coupled, "not coupled")
            number = played.epoch()
            before = played.guardings()

            def again(what: str) -> None:
                nonlocal before
                played.wait(lambda: played.guardings() > before and coupled(), f"not coupled again after {what}")
                before = played.guardings()

            began["stop"] = time.monotonic()
            cleo = played.members["Cleo"]
            cleo.send_signal(signal.SIGSTOP)
            time.sleep(FAULT)
            cleo.send_signal(signal.SIGCONT)
            again("a process that stood still")

            time.sleep(FAULT)  # another fault before the control plane is whole would be a longer one

            began["move"] = time.monotonic()
            star.move(2)
            star.move(1)
            again("other addresses")
            # Whoever is not seen any more is out after 6 s; so nobody was.
            time.sleep(7.0)
            played.wait(coupled, "not coupled in the end")
            assert played.epoch() == number
            said = {name: played.stop(name) for name in names}
    recordings = judged(played, said, FORCE)
    assert {link["path_state"] for one in said.values() for link in one["status"]["links"]} == {"direct"}
    for recording in recordings:
        assert not {path_state for _, path_state in paths(recording) if path_state == "relayed"}
        if recording.name != "Ann":  # of those who moved, everybody's address is another
            assert any(time > began["move"] for time, _ in paths(recording))


def paths(recording: Recording) -> list[tuple[float, str]]:
    """How neighbours were reached, and since when."""
    return [(event.time, str(event.fields["reason"])) for event in recording.events if event.kind == "path"]
