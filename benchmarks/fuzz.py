"""Mutated datagrams, control messages and page commands through all that reads them: nothing may crash, or be believed.

`nice -n 19 python -m benchmarks.fuzz --count 10000000 --write`. Every part has a share of the count and a seed of its
own, so that a crash can be had again.
"""

import argparse
import random
import traceback
from collections.abc import Callable
from time import process_time
from typing import NamedTuple

import numpy as np
from tests.live.support import (
    agreements,
    datagrams,
    entropy,
    heading,
    identities,
    layout,
    planes,
    sealed_pair,
    state_of,
)

from benchmarks._report import Row, add_write, finish
from cotouch.control import MessageReader, MessageWriter, Presence, SignedMessage
from cotouch.errors import PageError
from cotouch.members import Coordinator, Entry, LinkStatus, Roster, SessionFile, Status, write_message
from cotouch.members._messages import Decided, Join, NameOwner, read_message
from cotouch.members._succession import Belief, signed
from cotouch.samples import Address, Chunk, Opened, PathLaw, SampleCodec
from cotouch.traversal import Candidate, CandidateKind, read_offer, write_offer
from cotouch.web._protocol import read_binary, read_text

SHORT = 20_000
SESSION = bytes(range(32))
WHO = identities(5)
_BODY = [1.0, 2.0]
_WORDS = (
    b"\xff" * 8, b"\0" * 8, b"\0\0\0\0\0\0\xf8\x7f", b"\1\0\0\0\0\0\xf0\x7f", b"\x80\0\0\0\0\0\0\0",
    b"1e999", b"NaN", b"-1", b"4503599627370496", b"null", b"[[[[", b"{}", b'"', b"true", b"\\ud800", b"0.5",
)  # fmt: skip


def mutated(rng: random.Random, good: list[bytes]) -> bytes:
    """Noise, noise behind a true beginning, or a true one that was flipped, cut, spliced, lengthened or rewritten."""
    kind, base = rng.randrange(8), bytearray(rng.choice(good))
    at = rng.randrange(len(base))
    match kind:
        case 0:
            return rng.randbytes(rng.randrange(300))
        case 1:
            return bytes(base[:at]) + rng.randbytes(rng.randrange(200))
        case 2:
            for _ in range(rng.randrange(1, 9)):
                base[rng.randrange(len(base))] ^= 1 << rng.randrange(8)
        case 3:
            del base[at:]
        case 4:
            base[at:] = rng.choice(good)[at:]
        case 5:
            base += rng.randbytes(rng.randrange(1, 50))
        case 6:
            word = rng.choice(_WORDS)
            base[at : at + len(word)] = word
        case _:
            word = rng.choice(_WORDS)
            base[at : at + rng.randrange(1, 12)] = word
    return bytes(base)


class Part(NamedTuple):
    """One reader.

    Attributes:
        name: of what is read.
        fraction: of all messages.
        good: messages that it takes, to be mutated.
        take: reads one, and raises if more than a refusal came of it.
    """

    name: str
    fraction: float
    good: list[bytes]
    take: Callable[[bytes], object]


def samples(encoding: str) -> Part:
    """A sample's payload, as a member could seal it."""
    shape = layout(12, 3, encoding=encoding)
    codec = SampleCodec(shape)
    good = [
        one for step in range(5) for one in datagrams(codec, state_of(shape, step), heading(step, flags=3, worst=2.0))
    ]

    def take(raw: bytes) -> None:
        found = codec.read(raw, epoch=3, sender=1)
        if isinstance(found, Chunk):
            assert np.isfinite(found.values).all(), "numbers that are none were taken"

    return Part(f"samples of a member, {encoding}", 0.12, good, take)


def sealed() -> Part:
    """Datagrams from outside: none may open but those that were sealed."""
    one, two = sealed_pair()
    good = [one.seal(bytes(300)) or b"" for _ in range(20)]

    def take(raw: bytes) -> None:
        assert raw in good or not isinstance(two.open(raw, 0.0), Opened), "a forged datagram was opened"

    return Part("sealed datagrams", 0.2, good, take)


def plane() -> Part:
    """Payloads that a member seals, through all of the sample plane."""
    shape = layout(12, 3)
    network, users = planes(PathLaw(), shape, rate=500.0)
    link, held = users[0].links[1], users[1].links[0]
    good = [
        one
        for step in range(4)
        for one in datagrams(SampleCodec(shape), state_of(shape, step), heading(step, sender=0, flags=3))
    ]

    def take(raw: bytes) -> None:
        network.now += 0.001
        users[0]._transport.send(1, link.seal.seal(raw[:1000]) or b"")
        users[1].poll(network.now)
        assert np.abs(held.assembly.state).max() <= shape.limit, "a state beyond the limit was taken"

    return Part("samples through the plane", 0.03, good, take)


def control(fraction: float, *, limited: bool) -> Part:
    """Signed messages; limited as from a flood, and without a limit, so that each comes to its signature."""
    reader = MessageReader(WHO[0].public, SESSION, **({} if limited else {"rate": 1e12, "burst": 1e12}))
    good = [
        MessageWriter(one, SESSION, started=1 << 62).write(topic, bytes(size), to)
        for one in WHO[1:]
        for topic, size, to in (("link.keys", 90, WHO[0].public), ("roster", 300, None), ("x", 0, None))
    ]
    clock = [0.0]

    def take(raw: bytes) -> None:
        clock[0] += 1e-4
        assert raw in good or not isinstance(reader.read(raw, clock[0]), SignedMessage), "a forged message was believed"

    return Part(f"control messages{', a flood' if limited else ', each looked at'}", fraction, good, take)


def agreement() -> Part:
    """The three messages of an agreement on keys."""
    one, two = agreements(*identities())
    hello = one.start()
    good = [hello, two.receive(hello).message or hello]

    def take(raw: bytes) -> None:
        for end in (one, two):
            assert raw in good or end.receive(raw).keys is None, "keys of a forged message were taken"

    return Part("agreements", 0.004, good, take)


def presence() -> Part:
    """Beats: who is not there is not made so."""
    one, two = (Presence(who, SESSION, entropy(k)) for k, who in enumerate(WHO[:2]))
    good = [beat for k in range(6) if (beat := two.beat(float(k))) is not None]
    clock = [10.0]

    def take(raw: bytes) -> None:
        clock[0] += 1e-3
        one.receive(raw, clock[0])
        assert not one.present(clock[0]), "somebody was made present"

    return Part("presence", 0.02, good, take)


def commanded() -> list[Part]:
    """Rosters, wishes, statuses and candidates, as whoever is invited may write them."""
    host, ann = WHO[0], WHO[1]
    members = [Entry(slot=k, name=f"user {k}", key=one.public.hex()) for k, one in enumerate(WHO[1:4])]
    names = [NameOwner(name=entry.name, key=entry.key) for entry in members]
    root = Roster(epoch=5, members=members, links=[(0, 1), (1, 2)], names=names)
    chain = [signed(host, host.public, root), signed(ann, host.public, root.model_copy(update={"epoch": 6}))]
    belief = Belief(host.public)
    belief.receive(Decided(chain=chain[:1]), host.public, frozenset())
    session = SessionFile.from_toml("[session]\nusers = 3\n")
    decider = Coordinator(session, fingerprint=_BODY)
    decider.adopt(root, 0.0)
    everybody = frozenset(one.public for one in WHO)

    def roster(raw: bytes) -> None:
        decided = read_message(Decided, raw)
        if decided is not None:
            belief.receive(decided, ann.public, everybody)
            assert belief.roster.owners() == root.owners(), "a forged roster was believed"

    def received(topic: str) -> Callable[[bytes], None]:
        def take(raw: bytes) -> None:
            decider.receive(SignedMessage(ann.public, topic, raw, direct=True), 0.0)
            assert len(decider.roster.members) == 3, "somebody took a place"

        return take

    link = LinkStatus(slot=1, state="coupled", age_sum=0.1, budget=0.2, round_trip=0.03)
    status = Status(slot=0, links=[link], round_trips=[(1, 0.1)], roster=root.digest)
    desired = Join(name="user 0", fingerprint=_BODY, version="1")
    offers = [
        write_offer(bytes(range(16)), [Candidate(CandidateKind.LOCAL, Address("192.0.2.1", 7000 + k))])
        for k in range(3)
    ]
    return [
        Part("rosters", 0.03, [write_message(Decided(chain=chain)), write_message(Decided(chain=chain[:1]))], roster),
        Part("statuses", 0.04, [write_message(status)], received("status")),
        Part("requests to take part", 0.03, [write_message(desired)], received("join")),
        Part("candidates", 0.02, offers, read_offer),
    ]


def pages() -> list[Part]:
    """What a page may send."""
    from tests.web.reader import ack, pointer

    texts = [
        b'{"type": "hello", "version": 1, "token": "abc", "slot": 1, "rate": 60}',
        b'{"type": "do", "id": 4, "what": "links", "links": [[0, 1]], "choice": null}',
        b'{"type": "do", "id": 5, "what": "damping", "share": 0.5}',
    ]

    def binary(raw: bytes) -> None:
        try:
            read_binary(raw)
        except PageError:
            return

    def text(raw: bytes) -> None:
        try:
            read_text(raw.decode("utf-8", "replace"))
        except PageError:
            return

    return [
        Part("pointers and acknowledgements of a page", 0.1, [pointer(1, slot=1), ack(1, 5.0, 16.0)], binary),
        Part("commands of a page", 0.1, texts, text),
    ]


def parts() -> list[Part]:
    """All readers; their shares come to one, about."""
    codings = [samples(encoding) for encoding in ("float64", "float32", "float16")]
    signatures = [control(0.07, limited=True), control(0.006, limited=False), agreement(), presence()]
    return [*codings, sealed(), plane(), *signatures, *commanded(), *pages()]


def measure(count: int = SHORT, seed: int = 1) -> list[Row]:
    """Tries so many messages.

    Args:
        count: how many, about.
        seed: of all parts.
    """
    rows, tried, crashes, began = list[Row](), 0, list[str](), process_time()
    for part in parts():
        rng, many = random.Random(f"{seed} {part.name}"), max(1, round(count * part.fraction))
        bad = 0
        for k in range(many):
            raw = mutated(rng, part.good)
            try:
                part.take(raw)
            except Exception:  # noqa: BLE001 - any at all is what is looked for
                bad += 1
                if len(crashes) < 20:
                    crashes.append(f"{part.name}, message {k} of seed {seed}: {traceback.format_exc(limit=-1)}")
        tried += many
        rows.append(Row("fuzz", f"{part.name}: crashes or forgeries that were believed", str(bad), "0", f"{many:,}"))
    seconds = process_time() - began
    print(*crashes, sep="\n", end="\n" if crashes else "")
    total = sum(int(row.value) for row in rows)
    note = f"seed {seed}, {tried / seconds:,.0f} a second of one core"
    return [
        Row("fuzz", f"{tried:,} mutated messages: crashes or forgeries that were believed", str(total), "0", note),
        *rows,
    ]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=SHORT, help="messages (10,000,000 for the record)")
    parser.add_argument("--seed", type=int, default=1)
    add_write(parser)
    options = parser.parse_args()
    finish(measure(options.count, options.seed), write=options.write)


if __name__ == "__main__":
    main()
