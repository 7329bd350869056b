"""Random and mutated datagrams through all that reads them: no crash, no state change, no memory growth."""

import gc
import random
import sys

import numpy as np
import pytest
from tests.live.support import datagrams, heading, layout, planes, state_of
from tests.samples.memory import MemoryNetwork

from cotouch.peer import Sample
from cotouch.samples import MOST_BYTES, OVERHEAD, Chunk, Opened, PathLaw, Refusal, SampleCodec, SamplePlane


def mutated(rng: random.Random, good: list[bytes]) -> bytes:
    """Noise, noise behind a true beginning, or a true one that was flipped, cut, spliced or lengthened."""
    kind, base = rng.randrange(7), bytearray(rng.choice(good))
    match kind:
        case 0:
            return rng.randbytes(rng.randrange(MOST_BYTES + 1))
        case 1:
            return bytes(base[: rng.randrange(32)]) + rng.randbytes(rng.randrange(MOST_BYTES - 32))
        case 2:
            for _ in range(rng.randrange(1, 9)):
                base[rng.randrange(len(base))] ^= 1 << rng.randrange(8)
        case 3:
            del base[rng.randrange(len(base)) :]
        case 4:
            cut = rng.randrange(len(base))
            base[cut:] = rng.choice(good)[cut:]
        case 5:
            base += rng.randbytes(rng.randrange(1, 50))
        case _:
            at = rng.randrange(len(base))
            base[at : at + 8] = rng.choice((b"\xff" * 8, b"\0" * 8, b"\0\0\0\0\0\0\xf8\x7f", b"\1\0\0\0\0\0\xf0\x7f"))
    return bytes(base)


def going_on(network: MemoryNetwork, users: list[SamplePlane], steps: range, *, alone: bool = False) -> list[object]:
    """Steps of both, or of the second alone; and what the second, at whom the noise comes, says and knows in them."""
    out: list[object] = []
    carry = network.carry

    def overheard(sender: str, receiver: str, payload: bytes) -> None:
        out.append((sender, receiver, payload))
        carry(sender, receiver, payload)

    network.carry = overheard
    (link,) = users[1].links.values()
    for k in steps:
        network.now = 0.002 * (k + 1)
        for plane in users[:0:-1] if alone else users[::-1]:
            plane.poll(network.now)
            plane.stepped(network.now)
            sample = Sample(sender=plane.user, index=k, stamp=network.now - 0.001, position=state_of(plane.layout, k))
            plane.send(network.now, sample, 0.002)
        ages, rate, held = link.ages, link.rate, link.assembly
        out.append((held.state.tobytes(), tuple(held.stamps), tuple(held.indices), link.asked, link.ahead))
        out.append((link.seal.received, link.seal.epoch, link.seal.sealed, rate.rate, rate.trend, rate.loss))
        out.append((ages.own, ages.worst_sum, ages.sum_quantile(0.5), ages.shortest_path, ages.impossible))
    network.carry = carry
    return out


def begun() -> tuple[MemoryNetwork, list[SamplePlane], list[bytes]]:
    """Two after a few steps, and what the first sealed besides, which somebody keeps from the second."""
    # What the second says is lost now and then, so that its rate has something to find out.
    network, users = planes(PathLaw(), layout(100, 3), rate=500.0, back=PathLaw(loss=0.2))
    going_on(network, users, range(10))
    users[1].poll(network.now)
    seal = users[0].links[1].seal
    return network, users, [datagram for _ in range(8) for datagram in [seal.seal(bytes(600))] if datagram]


def outside(count: int, *, alone: bool) -> None:
    """From the network, where nobody has the keys; a receiver goes on to the bit as one that never heard the noise."""
    rng = random.Random(count)
    network, users, captured = begun()
    noise = network.join("noise")
    noise.follow(1, "at 1")
    blocks = 0
    taken = sum(users[1].links[0].refused.values()) + sum(users[1].refused.values())
    for round_ in range(count // 1000):
        for _ in range(1000):
            datagram = mutated(rng, captured)
            if datagram not in captured:
                noise.send(1, datagram)
        assert users[1].poll(network.now) == 0
        if round_ in {4, count // 1000 - 1}:
            gc.collect()
            now = sys.getallocatedblocks()
            assert not blocks or now - blocks < 2000
            blocks = blocks or now
    refused = users[1].links[0].refused + users[1].refused
    assert sum(refused.values()) - taken == noise.traffic.sent
    assert {Refusal.SHORT, Refusal.VERSION, Refusal.CONNECTION, Refusal.EPOCH_OF_KEYS, Refusal.FORGED} <= set(refused)
    undisturbed, others, _ = begun()
    disturbed = going_on(network, users, range(10, 610), alone=alone)
    assert disturbed == going_on(undisturbed, others, range(10, 610), alone=alone)
    # What was kept was not used up by noise that says its number.
    assert all(isinstance(users[1].links[0].seal.open(datagram, network.now), Opened) for datagram in captured)


def inside(count: int) -> None:
    """From a member, who seals what it likes: what is refused changes nothing, what is taken is finite and bounded."""
    rng = random.Random(count)
    for encoding in ("float64", "float32", "float16"):
        shape = layout(100, 3, encoding=encoding)
        codec = SampleCodec(shape)
        good = [
            datagram
            for step in range(5)
            for datagram in datagrams(
                codec, state_of(shape, step), heading(step, age=1.0, worst=2.0, echo=0.5, held=0.1)
            )
        ]
        reasons = set()
        for _ in range(count // 3):
            result = codec.read(mutated(rng, good), epoch=3, sender=1)
            if isinstance(result, Chunk):
                assert np.abs(result.values).max() <= max(shape.limit, float(np.array(shape.limit, shape.dtype)))
                assert result.values.shape == (len(range(100)[shape.span(result.chunk)]), 3)
            else:
                reasons.add(result)
        expected = {Refusal.SHORT, Refusal.VERSION, Refusal.ENCODING, Refusal.FLAGS, Refusal.EPOCH, Refusal.SENDER}
        assert (
            expected | {Refusal.RANGE, Refusal.SIZE, Refusal.INDEX, Refusal.TIME, Refusal.GUARD, Refusal.STATE}
            == reasons
        )


@pytest.mark.parametrize("alone", [False, True])
def test_noise_from_outside(alone: bool):
    """Whether the other end is heard afterwards, or never again."""
    outside(20_000, alone=alone)


def test_noise_from_a_member():
    inside(30_000)


def test_a_members_noise_through_the_whole_plane():
    """Sealed, so that it gets as far as it can: the link and its neighbour's estimates stay finite."""
    rng = random.Random(1)
    shape = layout(100, 3)
    network, users = planes(PathLaw(), shape, rate=500.0)
    link = users[0].links[1]
    good = [
        datagram
        for step in range(4)
        for datagram in datagrams(
            SampleCodec(shape), state_of(shape, step), heading(step, sender=0, flags=3, age=1.0, worst=2.0)
        )
    ]
    for k in range(8000):
        network.now = 0.001 * (k + 1)
        payload = mutated(rng, good)[: MOST_BYTES - OVERHEAD]
        sealed = link.seal.seal(payload)
        network["at 0"].send(1, sealed)
        users[1].poll(network.now)
        users[1].stepped(network.now)
        users[1].send(network.now, Sample(sender=1, index=k, stamp=network.now, position=state_of(shape, 0)), 0.001)
    held = users[1].links[0]
    assert np.abs(held.assembly.state).max() <= shape.limit
    assert np.isfinite([held.rate.rate, held.ages.worst_sum or 0.0, held.ages.shortest_path or 0.0]).all()
    assert 20.0 <= held.rate.rate <= 500.0


@pytest.mark.slow
def test_a_million_datagrams():
    outside(500_000, alone=False)
    inside(500_000)


def test_opened_is_what_was_sealed_even_after_noise():
    _, users = planes(PathLaw(), layout(4, 3))
    rng = random.Random(2)
    one, two = users[0].links[1].seal, users[1].links[0].seal
    for k in range(2000):
        good = one.seal(k.to_bytes(4, "big"))
        for _ in range(3):
            assert isinstance(two.open(mutated(rng, [good]) + b"", 0.0), Refusal | Opened)
        assert two.received[0] <= k
