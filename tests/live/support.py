"""Keys, layouts and links that the tests of the sample plane share."""

import contextlib
import os
import random
from collections.abc import Callable

import numpy as np
from tests.samples.memory import MemoryNetwork

from cotouch.samples import (
    Agreement,
    Assembly,
    Heading,
    Identity,
    Layout,
    LinkKeys,
    PathLaw,
    SampleCodec,
    SampleLink,
    SamplePlane,
    SealedLink,
    SendRate,
)

SESSION = b"session of the tests"


def entropy(seed: int) -> Callable[[int], bytes]:
    """Bytes that anybody can guess, the same in every run."""
    return random.Random(seed).randbytes


def identities(count: int = 2) -> list[Identity]:
    return [Identity.make(entropy(1000 + user)) for user in range(count)]


def agreements(
    first: Identity,
    second: Identity,
    *,
    session: tuple[bytes, bytes] = (SESSION, SESSION),
    secret: tuple[bytes, bytes] = (b"", b""),
    connection: tuple[int, int] = (11, 22),
    seed: int = 5,
) -> tuple[Agreement, Agreement]:
    """Both ends of a link, the one that begins first."""
    draw = entropy(seed)
    ends = [
        Agreement(
            identity=mine, other=other, session=session[k], connection=connection[k], entropy=draw, secret=secret[k]
        )
        for k, (mine, other) in enumerate(((first, second.public), (second, first.public)))
    ]
    ends.sort(key=lambda end: not end.initiator)
    return ends[0], ends[1]


def agree(initiator: Agreement, responder: Agreement) -> tuple[LinkKeys, LinkKeys]:
    """Carries the three messages; the keys of both ends."""
    reply = responder.receive(initiator.start())
    assert reply.message is not None, reply.refused
    confirm = initiator.receive(reply.message)
    assert confirm.message is not None, confirm.refused
    assert confirm.keys is not None
    done = responder.receive(confirm.message)
    assert done.keys is not None, done.refused
    return confirm.keys, done.keys


def in_a_fork(child: Callable[[], bool]) -> bool:
    """What a forked process says; it ends without unwinding anything of this one."""
    number = os.fork()
    if number == 0:
        code = 1
        with contextlib.suppress(BaseException):
            code = 0 if child() else 1
        os._exit(code)
    return os.waitstatus_to_exitcode(os.waitpid(number, 0)[1]) == 0


def sealed_pair(seed: int = 5, connection: tuple[int, int] = (11, 22)) -> tuple[SealedLink, SealedLink]:
    """Both ends of a link with keys."""
    ends = SealedLink(), SealedLink()
    for end, keys in zip(ends, agree(*agreements(*identities(), seed=seed, connection=connection)), strict=True):
        end.install(keys)
    return ends


def layout(rows: int = 4, axes: int = 3, **options: object) -> Layout:
    return Layout(rows=rows, width=1 if axes == 1 else 4, axes=axes, **options)  # pyright: ignore[reportArgumentType]


def state_of(shape: Layout, seed: int, size: float = 0.1) -> np.ndarray:
    out = np.zeros((shape.rows, shape.width))
    out[:, : shape.axes] = np.random.default_rng(seed).uniform(-size, size, (shape.rows, shape.axes))
    return out


def heading(step: int = 0, **changes: float) -> Heading:
    values = {"epoch": 3, "sender": 1, "step": step, "stamp": 0.001 * step, "T": 0.001}
    return Heading(**(values | changes))  # pyright: ignore[reportArgumentType]


def datagrams(codec: SampleCodec, state: np.ndarray, head: Heading) -> list[bytes]:
    written = codec.write(state)
    return [codec.datagram(head, chunk, body) for chunk, body in enumerate(written.bodies)]


def planes(
    law: PathLaw, shape: Layout, *, seed: int = 0, rate: float = 1000.0, back: PathLaw | None = None
) -> tuple[MemoryNetwork, list[SamplePlane]]:
    """Two users on a virtual network, keys agreed."""
    network = MemoryNetwork(law=law, seed=seed)
    made: list[SamplePlane] = []
    all_keys = agree(*agreements(*identities()))
    for user, keys in enumerate(all_keys):
        plane = SamplePlane(network.join(f"at {user}"), shape, user=user, epoch=3)
        zero = np.zeros((shape.rows, shape.width))
        link = SampleLink(Assembly(shape, sender=1 - user, initial=zero), rate=SendRate(highest=rate))
        link.seal.install(keys)
        plane.connect(1 - user, link, at=f"at {1 - user}")
        made.append(plane)
    if back is not None:
        network.set("at 1", "at 0", back)
    return network, made
