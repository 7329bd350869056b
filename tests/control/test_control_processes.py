"""Members as processes of their own: the host killed, one cut off without it, all together again."""

import json
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from pathlib import Path

import pytest
from tests.live.support import entropy, identities

from cotouch.control import Endpoint, Invitation, free_port
from cotouch.samples import Identity

MEMBER = Path(__file__).parents[1] / "live" / "member.py"


class Process:
    """A member; see `member.py`."""

    def __init__(self, folder: Path, invitation: Invitation, identity: Identity, **more: str) -> None:
        self.key = identity.public.hex()
        config = folder / f"{self.key[:8]}.json"
        given = {"invitation": invitation.encode(), "secret": identity.secret.hex(), "seconds": 600.0}
        config.write_text(json.dumps(given | more))
        self.process = subprocess.Popen(
            [sys.executable, str(MEMBER), str(config)], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
        )

    def read(self) -> dict[str, list[str]]:
        assert self.process.stdout
        return json.loads(self.process.stdout.readline())

    def ask(self, **asked: str) -> dict[str, list[str]]:
        assert self.process.stdin
        self.process.stdin.write(json.dumps(asked) + "\n")
        self.process.stdin.flush()
        return self.read()

    def end(self) -> None:
        self.process.send_signal(signal.SIGCONT)
        assert self.process.stdin
        assert self.process.stdout
        self.process.stdin.close()
        try:
            self.process.wait(10.0)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
        self.process.stdout.close()


@pytest.fixture
def start(tmp_path: Path) -> Iterator[Callable[..., Process]]:
    with ExitStack() as stack:

        def begin(invitation: Invitation, identity: Identity, **more: str) -> Process:
            process = Process(tmp_path, invitation, identity, **more)
            stack.callback(process.end)
            return process

        yield begin


def until(done: Callable[[], bool]) -> None:
    end = time.monotonic() + 60.0
    while not done():
        if time.monotonic() > end:
            pytest.fail("it did not come within a minute")
        time.sleep(0.1)


def meet(members: list[Process]) -> None:
    """Waits until all see and hear all others, and nobody else."""
    keys = {member.key for member in members}

    def met() -> bool:
        told = [(member.key, member.ask()) for member in members]
        return all(set(one["present"]) == set(one["hears"]) == keys - {key} for key, one in told)

    until(met)


@pytest.mark.slow
def test_the_others_go_on_without_the_host(start: Callable[..., Process]):
    who = identities(4)
    at = Endpoint("127.0.0.1", free_port())
    made = Invitation.make(session="killed", host=who[0].public, digest=bytes(32), endpoints=(at,), entropy=entropy(1))
    members = [start(made, one) for one in who]
    for member in members:
        assert member.read()["here"] == member.key
    meet(members)
    host, others = members[0], members[1:]

    host.process.kill()
    host.process.wait()
    meet(others)
    others[0].ask(to=others[1].key, say="without the host")
    until(lambda: others[1].ask()["direct"] == ["without the host"])

    # Cut off for longer than the lease, while nobody has a host to dial: one is above and one below it in the order
    # that says who introduces.
    others.sort(key=lambda member: member.key)
    cut, rest = others[1], [others[0], others[2]]
    cut.process.send_signal(signal.SIGSTOP)
    meet(rest)
    cut.process.send_signal(signal.SIGCONT)
    meet(others)

    again = start(made, who[0])
    again.read()
    meet([again, *others])
    assert all(member.ask()["refused"] == {} == member.ask()["dropped"] for member in [again, *others])


def test_without_the_secret_nobody_joins(start: Callable[..., Process]):
    """Same host, same name, same place, another secret: neither sees the other, while the invited meet."""
    who = identities(3)
    at = Endpoint("127.0.0.1", free_port())
    made, other = (
        Invitation.make(session="secret", host=who[0].public, digest=bytes(32), endpoints=(at,), entropy=entropy(seed))
        for seed in (1, 2)
    )
    host, uninvited, invited = start(made, who[0]), start(other, who[1]), start(made, who[2])
    for member in (host, uninvited, invited):
        member.read()
    meet([host, invited])
    for _ in range(5):
        time.sleep(0.1)
        assert uninvited.ask()["present"] == uninvited.ask()["hears"] == []
    meet([host, invited])
