"""The perceptual codec on the wire: what is held is what the sender went on from; lies are refused."""

import random
import struct
import sys

import numpy as np
import pytest
from tests.live.support import heading, layout, planes
from tests.samples.memory import MemoryNetwork
from tests.samples.test_fuzz import mutated

from cotouch.errors import SessionError
from cotouch.laws import PAID, SPRING, Law
from cotouch.peer import Codec as Perceptual
from cotouch.peer import ContentForm, LinkHeader, Sample
from cotouch.samples import (
    MOST_BYTES,
    OVERHEAD,
    Assembly,
    Chunk,
    Coded,
    CodedLink,
    Layout,
    PathLaw,
    Refusal,
    SampleCodec,
    SamplePlane,
)

T = 0.002
HOW = Perceptual(deadband=0.1, quantum=1e-5, hold=8)


def coded_layout(rows: int, law: Law = SPRING, how: Perceptual = HOW) -> Layout:
    coarse = law.coarse
    return layout(
        rows, 3, form=ContentForm(how, law), fields=len(law.sends), coarse=coarse, scalars=len(law.sends_scalars)
    )


def coded_planes(path: PathLaw, shape: Layout) -> tuple[MemoryNetwork, list[SamplePlane]]:
    network, users = planes(path, shape, rate=500.0)
    for plane in users:
        for other, link in plane.links.items():
            link.coded = CodedLink(shape, np.ones(shape.rows), sender=other)
            account = link.coded.encoder.account
            assert account is not None
            account.window = 0.05
    return network, users


def speed(rows: int, k: int) -> np.ndarray:
    """Even for a tenth of a second, then another."""
    out = np.zeros((rows, 4))
    out[:, :3] = np.random.default_rng(k // 50).normal(0.0, 0.1, (rows, 3))
    return out


@pytest.mark.parametrize("rows", [4, 100])
def test_what_is_held_is_what_the_sender_went_on_from(rows: int) -> None:
    """To the last bit, row by row, over a path that loses, repeats and reorders; and it is as new as its stamp."""
    shape = coded_layout(rows)
    network, users = coded_planes(PathLaw(delay=0.01, jitter=0.01, loss=0.1, duplication=0.2, reordering=0.3), shape)
    told: list[list[np.ndarray]] = [[], []]
    x = np.zeros((2, rows, 4))
    goes_on = 0
    for k in range(600):
        network.now = (k + 1) * T
        for plane in users:
            user = plane.user
            plane.poll(network.now)
            plane.stepped(network.now)
            link, mean = plane.links[1 - user], speed(rows, k + 1000 * user)
            assert link.coded is not None
            sample = Sample(sender=user, index=k, stamp=(k + 0.5) * T, position=x[user] + 0.5 * T * mean)
            plane.send(network.now, sample, T, mean)
            x[user] += T * mean
            base = link.coded.encoder._base
            assert base is not None
            told[user].append(shape.form.at(base, sample.stamp, T)[0][0].reshape(rows, 3))
            goes_on += 0 < link.said < 255
            held = link.assembly
            for at, index in enumerate(held.indices):
                if index >= 0:
                    assert held.stamps[at] == (index + 0.5) * T
                    assert np.array_equal(held.state[shape.span(at), :3], told[1 - user][index][shape.span(at)])
    assert goes_on > 200
    for plane in users:
        link = plane.links[1 - plane.user]
        assert set(link.refused) <= {Refusal.REPLAYED, Refusal.STALE, Refusal.BASELESS}
        assert link.refused[Refusal.BASELESS] > 0
        assert link.sent.datagrams > 0.0
        assert 0.0 < link.sent.saved < 1.0


def test_an_unchanged_sample_is_as_new_as_its_stamp() -> None:
    shape = coded_layout(4)
    network, users = coded_planes(PathLaw(delay=0.01), shape)
    x = np.zeros((4, 4))
    mean = speed(4, 0)
    for k in range(60):
        network.now = (k + 1) * T
        for plane in users:
            plane.poll(network.now)
            plane.stepped(network.now)
            sample = Sample(sender=plane.user, index=k, stamp=(k + 0.5) * T, position=x + 0.5 * T * mean)
            plane.send(network.now, sample, T, mean)
        x += T * mean
        if k > 10:
            assert users[0].links[1].ages.age == pytest.approx(0.01 + 0.5 * T, abs=1.01 * T)
    coded = users[0].links[1].coded
    assert coded is not None
    assert coded.encoder.unchanged > 3 * coded.encoder.contents


@pytest.mark.parametrize("quantum", [0.0, 1e-5])
def test_all_fields_of_a_law_get_through(quantum: float) -> None:
    """Sums and numbers that are not rounded to the last bit; values no larger than they were; nothing given twice."""
    how = Perceptual(deadband=0.1, quantum=quantum, hold=8)
    shape = coded_layout(40, PAID, how)
    codec, ends = SampleCodec(shape), [CodedLink(shape, np.ones(40), sender=1) for _ in range(2)]
    held = Assembly(shape, sender=1, initial=np.zeros((40, 4)))
    rng = np.random.default_rng(0)
    steady, fields = rng.normal(0, 1.0, (len(PAID.sends), 40, 4)), np.zeros((len(PAID.sends), 40, 4))
    steady[:, :, 3] = 0.0
    energies = [PAID.sends_scalars.index(name) for name in PAID.energies]
    sums = [PAID.sends.index(name) for name in PAID.sums]
    w, p, q = (PAID.sends.index(name) for name in ("w", "P", "Q"))
    once = np.zeros((40, 4))
    numbers, full = np.arange(float(len(PAID.sends_scalars))), 0
    for k in range(60):
        fields = fields + T * steady
        fields[list(PAID.coarse)] = steady[list(PAID.coarse)]
        once += T * steady[w]
        fields[p], fields[q] = once, fields[q] + T * (once - steady[q]) - 0.5 * T * T * steady[w]
        numbers = numbers.copy()
        numbers[energies] += 1e-4
        message = fields.reshape(len(PAID.sends), -1), numbers
        sample = Sample(sender=1, index=k, stamp=k * T, position=fields[0], message=message)
        numbers[PAID.sends_scalars.index("T")] = 0.001 * (1 + k % 3)
        head = heading(k, stamp=k * T, T=0.001 * (1 + k % 3))
        said = ends[0].say(codec, head, sample, steady[0], head.T, exact=False)
        full += len(said) == shape.chunks > 1
        for datagram in said:
            assert len(datagram) + OVERHEAD <= MOST_BYTES
            read = codec.read(datagram, epoch=3, sender=1)
            assert isinstance(read, Coded)
            chunks = ends[1].hear(codec, read)
            assert isinstance(chunks, list)
            for chunk in chunks:
                assert held.take(chunk) is None
        got = held.choose(0)
        assert got.message is not None
        assert got.index == k
        assert (got.message[1][energies] <= numbers[energies]).all()
        assert got.message[1][PAID.sends_scalars.index("T")] == pytest.approx(head.T, rel=1e-7)
        told = got.message[0].reshape(fields.shape)
        if len(said) > 1:
            assert (np.abs(told[list(PAID.coarse)]) <= np.abs(fields[list(PAID.coarse)])).all()
            late = numbers - got.message[1]
            assert (late[energies] <= 0.5001e-4).all()
            assert np.array_equal(np.delete(late, energies), np.zeros(late.size - len(energies)))
            exact = np.array_equal(told[sums], fields[sums])
            assert exact if quantum == 0.0 else np.abs(told[sums] - fields[sums]).max() <= 0.5001 * quantum
    assert 0 < full < 40


def spoken(shape: Layout, brief: bool) -> bytes:
    head = heading(9, stamp=0.009, header=LinkHeader(2, 1, 1, 0.5))
    return SampleCodec(shape).coded(head, None, b"\x03", brief=brief)


@pytest.mark.parametrize(
    ("at", "form", "value", "reason"),
    [
        (0, "<B", 4, Refusal.VERSION),
        (2, "<I", 4, Refusal.EPOCH),
        (6, "<H", 2, Refusal.SENDER),
        (8, "<B", 3, Refusal.GUARD),
        (11, "<B", 2, Refusal.GUARD),
        (12, "<Q", 2**40 + 1, Refusal.INDEX),
        (20, "<d", float("nan"), Refusal.TIME),
        (20, "<d", 1e300, Refusal.TIME),
        (28, "<f", 0.0, Refusal.TIME),
        (28, "<f", 11.0, Refusal.TIME),
        (32, "<d", -0.0, Refusal.GUARD),
        (32, "<d", float("nan"), Refusal.GUARD),
        (40, "<B", 0, Refusal.RANGE),
        (40, "<B", 9, Refusal.RANGE),
        (40, "<B", 255, Refusal.RANGE),
    ],
)
def test_a_brief_heading_that_cannot_be_is_refused_by_name(at: int, form: str, value: float, reason: Refusal) -> None:
    shape = coded_layout(4)
    payload = bytearray(spoken(shape, brief=True))
    read = SampleCodec(shape).read(bytes(payload), epoch=3, sender=1)
    assert isinstance(read, Coded)
    assert read.heading.header == LinkHeader(2, 1, 1, 0.5)
    struct.pack_into(form, payload, at, value)
    assert SampleCodec(shape).read(bytes(payload), epoch=3, sender=1) is reason


def test_words_without_a_base_change_nothing_and_are_bounded() -> None:
    """A neighbour that says for ever that what never came goes on, in whatever order."""
    shape = coded_layout(40)
    codec, link = SampleCodec(shape), CodedLink(shape, np.ones(40), sender=1)
    rng, blocks = random.Random(0), 0
    for k in range(6000):
        index = rng.choice([k + 300, rng.randrange(1 << 40), rng.randrange(9, 300)])
        head = heading(index, stamp=0.001 * k)
        assert link.hear(codec, Coded(head, None, bytes([rng.randrange(1, 9)]))) is Refusal.BASELESS
        if k in {2000, 5999}:
            now = sys.getallocatedblocks()
            assert not blocks or now - blocks < 500
            blocks = now
    # A content behind all that is taken as what it is.
    x = np.full((40, 4), 0.1)
    sample = Sample(sender=1, index=7, stamp=0.007, position=x)
    good = [codec.read(d, epoch=3, sender=1) for d in link.say(codec, heading(7), sample, 0.0 * x, T, exact=True)]
    for read in good:
        assert isinstance(read, Coded)
        chunks = link.hear(codec, read)
        assert isinstance(chunks, list)
        assert np.array_equal(chunks[0].values, x[shape.span(chunks[0].chunk), :3])
    # What goes on beyond the limit, by a rate or a stamp that nobody has, is not taken either.
    fast = Sample(sender=1, index=8, stamp=0.008, position=x + 8.0)
    for datagram in link.say(codec, heading(8, stamp=0.008), fast, 0.0 * x, T, exact=True):
        read = codec.read(datagram, epoch=3, sender=1)
        assert isinstance(read, Coded)
        link.hear(codec, read)
    assert link.hear(codec, Coded(heading(9, stamp=1e9), None, b"\x01")) is Refusal.STATE


def test_a_members_noise_is_finite_and_bounded() -> None:
    """Sealed, so that it gets as far as it can."""
    rng, shape = random.Random(1), coded_layout(100)
    network, users = coded_planes(PathLaw(), shape)
    link, codec = users[0].links[1], SampleCodec(shape)
    good = [spoken(shape, brief=True), spoken(shape, brief=False)]
    for step in range(4):
        x = np.full((100, 4), 0.01 * step)
        sample = Sample(sender=0, index=step, stamp=0.001 * step, position=x)
        coded = users[0].links[1].coded
        assert coded is not None
        good += coded.say(codec, heading(step, sender=0, flags=3, age=1.0, worst=2.0), sample, x, T, exact=step % 2 > 0)
    for k in range(2500):
        network.now = 0.001 * (k + 1)
        sealed = link.seal.seal(mutated(rng, good)[: MOST_BYTES - OVERHEAD])
        assert sealed is not None
        network["at 0"].send(1, sealed)
        users[1].poll(network.now)
        users[1].stepped(network.now)
    held = users[1].links[0]
    assert np.abs(held.assembly.state).max() <= shape.limit
    expected = {Refusal.SHORT, Refusal.VERSION, Refusal.ENCODING, Refusal.RANGE, Refusal.SIZE, Refusal.BASELESS}
    assert expected <= set(held.refused)


def test_a_session_without_codec_takes_no_coded_words() -> None:
    plain = SampleCodec(layout(4, 3))
    assert plain.read(spoken(coded_layout(4), brief=True), epoch=3, sender=1) is Refusal.SHORT
    assert plain.read(spoken(coded_layout(4), brief=False), epoch=3, sender=1) is Refusal.ENCODING
    with pytest.raises(SessionError, match="perceptual codec"):
        layout(4, 3, form=ContentForm(HOW, SPRING), encoding="float32")
    assert not isinstance(SampleCodec(coded_layout(4)).read(bytes(93), epoch=3, sender=1), Chunk)
