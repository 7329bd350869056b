"""Members whose addresses change: real processes in namespaces, each with a listener of its own."""

import json
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest
from tests.live.emulator.star import Star, obstacle
from tests.live.support import entropy, identities
from tests.session.session_api import everywhere

from cotouch.control import Endpoint, Invitation
from cotouch.samples import PathLaw

no_star = obstacle()
pytestmark = pytest.mark.skipif(no_star is not None, reason=f"no emulated network: {no_star}")
MEMBER = Path(__file__).with_name("member.py")
PATIENCE = 60.0


def until(done: Callable[[], object], what: Callable[[], str]) -> None:
    end = time.monotonic() + PATIENCE
    while not done():
        assert time.monotonic() < end, what()
        time.sleep(0.1)


def test_members_that_moved_find_each_other_and_need_no_host_for_it(tmp_path: Path) -> None:
    """Zenoh itself keeps the address that it began with: two who moved were never together again without the host."""
    who = identities(3)
    with Star(3, seconds=3 * PATIENCE) as star:
        everywhere(lambda i, j: PathLaw(delay=0.01), star, range(3))
        at = Endpoint(star.address(0), 7000)
        made = Invitation.make(
            session="moved", host=who[0].public, digest=bytes(32), endpoints=(at,), entropy=entropy(1)
        )
        members = {}
        for user, one in enumerate(who):
            given = {"invitation": made.encode(), "secret": one.secret.hex(), "seconds": 3 * PATIENCE}
            given["listen"] = str(at) if user == 0 else "reachable"
            (tmp_path / f"{user}.json").write_text(json.dumps(given))
            members[one.public.hex()] = star.start(user, [sys.executable, str(MEMBER), str(tmp_path / f"{user}.json")])
        try:

            def told(**asked: str) -> dict[str, dict[str, list[str]]]:
                for process in members.values():
                    process.stdin.write(json.dumps(asked) + "\n")
                    process.stdin.flush()
                return {key: json.loads(process.stdout.readline()) for key, process in members.items()}

            def meet() -> None:
                def met() -> bool:
                    return all(
                        set(one["present"]) == set(one["hears"]) == members.keys() - {key}
                        for key, one in told().items()
                    )

                until(met, lambda: f"not together: {told()}")

            for process in members.values():
                process.stdout.readline()
            meet()
            lived = told()
            for user in (1, 2):
                star.move(user)
            # What was said before may still be under way: this can only be heard at the new addresses.
            told(beat="moved")
            meet()
            host = members.pop(who[0].public.hex())
            host.kill()
            host.communicate()
            meet()
            assert all(one["refused"] == lived[key]["refused"] for key, one in told().items())
        finally:
            for process in members.values():
                process.kill()
                process.communicate()
