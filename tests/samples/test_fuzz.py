"""Random and mutated datagrams through all that reads them: no crash, no state change, no memory growth."""

import gc
import random
import sys

import numpy as np
import pytest
from tests.live.support import datagrams, heading, layout, planes, state_of

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


def state_now(plane: SamplePlane) -> tuple[object, ...]:
    """All that a refused datagram must not change; counters of refusals are left out."""
    (link,) = plane.links.values()
    window = link.seal._receiving[0].window
    ages, rate = link.ages, link.rate
    return (
        link.assembly.state.tobytes(), tuple(link.assembly.stamps), tuple(link.assembly.indices), link._newest,
        link.asked,
        link.seal.received, tuple(window._ring), link.seal.epoch, link.seal.sealed,
        ages.own, ages.worst_sum, ages.shortest_path, ages.impossible, len(ages._others),
        rate.rate, rate.trend, rate._started, rate._received, dict(plane._transport._neighbours),
    )  # fmt: skip


def outside(count: int) -> None:
    """From the network, where nobody has the keys."""
    rng = random.Random(count)
    shape = layout(100, 3)
    network, users = planes(PathLaw(), shape, rate=500.0)
    for k in range(10):
        network.now = 0.002 * (k + 1)
        for plane in users:
            plane.poll(network.now)
            plane.stepped(network.now)
            sample = Sample(sender=plane.user, index=k, stamp=network.now - 0.001, position=state_of(shape, k))
            plane.send(network.now, sample, 0.002)
    users[1].poll(network.now)
    link = users[0].links[1]
    captured = [datagram for _ in range(8) for datagram in [link.seal.seal(bytes(600))] if datagram]
    noise = network.join("noise")
    noise.follow(1, "at 1")
    before, blocks = state_now(users[1]), 0
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
    assert state_now(users[1]) == before
    refused = users[1].links[0].refused + users[1].refused
    assert sum(refused.values()) - taken == noise.traffic.sent
    assert {Refusal.SHORT, Refusal.VERSION, Refusal.CONNECTION, Refusal.EPOCH_OF_KEYS, Refusal.FORGED} <= set(refused)


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


def test_noise_from_outside():
    outside(20_000)


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
        users[0]._transport.send(1, sealed)
        users[1].poll(network.now)
        users[1].stepped(network.now)
        users[1].send(network.now, Sample(sender=1, index=k, stamp=network.now, position=state_of(shape, 0)), 0.001)
    held = users[1].links[0]
    assert np.abs(held.assembly.state).max() <= shape.limit
    assert np.isfinite([held.rate.rate, held.ages.worst_sum or 0.0, held.ages.shortest_path or 0.0]).all()
    assert 20.0 <= held.rate.rate <= 500.0


@pytest.mark.slow
def test_a_million_datagrams():
    outside(500_000)
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
