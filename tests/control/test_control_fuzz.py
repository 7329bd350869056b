"""Random and mutated control messages through all that reads them: no crash, no state change, no memory growth."""

import gc
import random
import sys

import pytest
from tests.live.support import entropy, identities

from cotouch.control import MOST_BODY, MessageReader, MessageRefusal, MessageWriter, SignedMessage
from cotouch.samples import Identity

SESSION = bytes(range(32))
WHO = identities(4)


def said() -> list[bytes]:
    """What members say and nobody has heard yet: as new as can be, so that only the signature is between."""
    out = list[bytes]()
    for one in WHO[1:]:
        writer = MessageWriter(one, SESSION, started=1 << 62)
        for size in (0, 30, 400):
            out += [writer.write("link.keys", bytes(size), WHO[0].public), writer.write("roster", bytes(size))]
    return out


def mutated(rng: random.Random, good: list[bytes]) -> bytes:
    """Noise, noise behind a true beginning, or a true one that was flipped, cut, spliced, lengthened or renamed."""
    base = bytearray(rng.choice(good))
    match rng.randrange(8):
        case 0:
            return rng.randbytes(rng.randrange(600))
        case 1:
            return bytes(base[: rng.randrange(90)]) + rng.randbytes(rng.randrange(300))
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
        case 6:
            base[4:36] = rng.choice((*(one.public for one in WHO), rng.randbytes(32), bytes(32)))
        case _:
            at = rng.randrange(len(base))
            base[at : at + 8] = rng.choice((b"\xff" * 8, b"\0" * 8, b"\0\0\0\0\0\0\0\1", b"\x80\0\0\0\0\0\0\0"))
    return bytes(base)


def check_state(reader: MessageReader, now: float) -> None:
    """Two said one thing each, which is all that counts: there is room for one more who says something true."""
    for one in WHO[1:3]:
        writer = MessageWriter(one, SESSION, started=1)
        assert reader.read(writer.write("hello", b""), now) is MessageRefusal.REPLAYED
        assert isinstance(reader.read(writer.write("hello", b""), now), SignedMessage)
    newcomer = MessageWriter(Identity.make(entropy(9)), SESSION, started=1)
    assert isinstance(reader.read(newcomer.write("hello", b""), now), SignedMessage)
    late = MessageWriter(WHO[3], SESSION, started=1)
    assert reader.read(late.write("hello", b""), now) is MessageRefusal.STRANGERS


def noise(count: int, monkeypatch: pytest.MonkeyPatch, *, limited: bool) -> None:
    monkeypatch.setattr("cotouch.control._sign._MOST_SENDERS", 3)
    rng = random.Random(count)
    reader = MessageReader(WHO[0].public, SESSION, **({} if limited else {"rate": 1e12, "burst": 1e12}))
    for one in WHO[1:3]:
        reader.read(MessageWriter(one, SESSION, started=1).write("hello", b""), 0.0)
    good = said()
    known = set(good)
    blocks, refused = 0, 0
    for k in range(count):
        message = mutated(rng, good)
        if message not in known:
            assert isinstance(reader.read(message, 1e-5 * k), MessageRefusal)
            refused += 1
        if k in {count // 5, count - 1}:
            del message
            gc.collect()
            now = sys.getallocatedblocks()
            assert not blocks or now - blocks < 500
            blocks = blocks or now
    assert sum(reader.refused.values()) == refused
    assert {MessageRefusal.SIZE, MessageRefusal.VERSION, MessageRefusal.NOT_OURS} <= set(reader.refused)
    assert limited or {MessageRefusal.OWN, MessageRefusal.TOPIC, MessageRefusal.FORGED} <= set(reader.refused)
    assert limited is (MessageRefusal.RATE in reader.refused)
    check_state(reader, 1e-5 * count + 60.0)
    # And it still hears who is heard.
    assert isinstance(reader.read(good[0], 1e-5 * count + 60.0), SignedMessage)


def test_noise_that_is_checked(monkeypatch: pytest.MonkeyPatch):
    noise(20_000, monkeypatch, limited=False)


def test_a_flood_of_noise(monkeypatch: pytest.MonkeyPatch):
    noise(100_000, monkeypatch, limited=True)


def test_long_noise():
    reader = MessageReader(WHO[0].public, SESSION)
    writer = MessageWriter(WHO[1], SESSION, started=1)
    for size in (MOST_BODY + 1, 2 * MOST_BODY, 1 << 24):
        assert reader.read(writer.write("long", bytes(size)), 0.0) is MessageRefusal.SIZE


@pytest.mark.slow
def test_a_million_messages(monkeypatch: pytest.MonkeyPatch):
    noise(900_000, monkeypatch, limited=True)
    noise(100_000, monkeypatch, limited=False)
