"""The perceptual codec: what one end says is what the other makes of it, and its errors are paid for."""

import re
from collections.abc import Callable
from importlib import import_module
from itertools import pairwise
from pathlib import Path
from typing import TypeAlias

import numpy as np
import pytest

from cotouch.arrays import Float
from cotouch.laws import ONCE, PAID, SPRING, WAVE, Law, law_named
from cotouch.peer import (
    FULL,
    ROUNDED,
    Codec,
    ContentForm,
    CopyMemory,
    Decoder,
    Encoder,
    FreshestLink,
    LawLink,
    Message,
    Sample,
)

# What a law tells after a step of a number and a mean velocity.
Told: TypeAlias = Callable[[int, Float], Message]

T = 0.001
SHAPE = (2, 1)
QUANTUM = 1e-3
ONES = np.ones(2)
# A push beside an even force, and in which step it comes [Ns].
JERK, JERKS = 0.01, 103


def motion(rng: np.random.Generator, steps: int) -> Float:
    """Velocities of two rows: moves, rests, shakes."""
    v = np.zeros((steps, 2, 1))
    at = 0
    while at < steps:
        span = int(rng.integers(5, 120))
        time = np.arange(min(span, steps - at))[:, None, None] * T
        match int(rng.integers(4)):
            case 0:
                v[at : at + span] = rng.normal(0, 0.1, (1, 2, 1))
            case 1:
                v[at : at + span] = rng.normal(0, 0.1, (1, 2, 1)) * np.sin(rng.uniform(5, 400) * time)
            case 2:
                v[at : at + span] = rng.normal(0, 0.02, (time.size, 2, 1))
            case _:
                pass
        at += span
    return v


def said(encoder: Encoder, v: Float, message: Told | None = None, start: float = 0.0) -> list[tuple[Sample, bytes]]:
    """Samples of a motion, and what the encoder says of each."""
    x = np.full(SHAPE, start)
    result: list[tuple[Sample, bytes]] = []
    for k, mean in enumerate(v):
        told = (np.zeros((0, 2)), np.zeros(0)) if message is None else message(k, mean)
        sample = Sample(sender=1, index=k, stamp=(k + 0.5) * T, position=x + 0.5 * T * mean, message=told)
        result.append((sample, encoder.encode(sample, mean, T)[0]))
        x = x + T * mean
    return result


def energies(rng: np.random.Generator, law: Law) -> Told:
    """Messages whose fields and numbers are arbitrary, and whose energies only grow."""
    fields, numbers = np.zeros((len(law.sends), 2)), np.zeros(len(law.sends_scalars))
    own = [law.sends_scalars.index(name) for name in law.energies]
    steady = rng.normal(0, 1.0, (len(law.sends), 2))

    def message(_k: int, _mean: Float) -> Message:
        if rng.random() < 0.05:
            steady[:] = rng.normal(0, 1.0, steady.shape)
        fields[...] += T * steady
        if law.origin_force is not None:  # its integrals follow from it
            hand = law.origin_force
            fields[[law.sends.index(name) for name in (hand.force, hand.integral, hand.double)]] = 0.0
        numbers[own] += T * rng.uniform(0.0, 0.02, len(own)) * (rng.random() < 0.9)
        if rng.random() < 0.3:  # just below a step of the quantum, where a quotient is rounded up
            numbers[own] = np.nextafter(np.ceil(numbers[own] / QUANTUM) * QUANTUM, 0.0)
        return fields.copy(), numbers.copy()

    return message


@pytest.mark.parametrize("quantum", [0.0, 1e-4])
def test_whatever_a_neighbour_does_the_senders_damping_has_paid_for_it(quantum: float) -> None:
    """The neighbour that gets most out of an error e moves by e/ε; samples are lost, late and repeated on their way."""
    codec = Codec(deadband=0.3, quantum=quantum, age=0.002)
    unchanged = rounded = 0
    for seed in range(8):
        rng = np.random.default_rng(seed)
        v = motion(rng, 400)
        law, delay = SPRING, float(rng.choice([0.0, 0.004, 0.02]))
        lost = rng.random(len(v)) < rng.choice([0.0, 0.2])
        arrival = np.where(lost, np.inf, (np.arange(len(v)) + 1) * T + delay + rng.exponential(0.003, len(v)))
        # No sample in use is older than the last one that came with all that it may go on from.
        whole = [arrival[max(m - codec.hold, 0) : m + 1].max() for m in range(len(v))]
        age, newest = 0.0, -0.5
        for k in range(len(v)):
            newest = max([newest, *(m for m in range(int(newest + 1), k) if whole[m] <= (k + 1) * T)])
            age = max(age, (k + 0.5 - newest) * T)
        encoder = Encoder(ContentForm(codec, law), ONES, SHAPE, age)
        decoder = Decoder(ContentForm(codec, law), SHAPE, 1)
        words = said(encoder, v)
        used, balance = Sample(sender=1, index=-1, stamp=0.0, position=np.zeros(SHAPE)), 0.0
        for k in range(len(v)):
            balance += 0.5 * T * codec.age * float((v[k] ** 2).sum())
            for m in np.flatnonzero((arrival > k * T) & (arrival <= (k + 1) * T)):
                sample, data = words[m]
                heard = decoder.decode(sample.index, sample.stamp, T, data)
                if heard is not None and heard.index > used.index:
                    used = heard
            error = used.position - words[used.index][0].position if used.index >= 0 else np.zeros(SHAPE)
            balance -= 0.5 * T / codec.age * float((error**2).sum())
            assert balance >= -1e-18
        unchanged += encoder.unchanged
        rounded += sum(data[0] == 255 and len(data) > 1 for _, data in words)
    assert unchanged > 800
    assert (rounded > 100) == (quantum > 0.0)


@pytest.mark.parametrize("law", [WAVE, PAID])
@pytest.mark.parametrize("quantum", [0.0, QUANTUM])
def test_no_energy_is_told_that_was_not_given(law: Law, quantum: float) -> None:
    codec = Codec(deadband=0.2, quantum=quantum)
    own = [law.sends_scalars.index(name) for name in law.energies]
    for seed in range(4):
        rng = np.random.default_rng(seed)
        encoder, decoder = (
            Encoder(ContentForm(codec, law), ONES, SHAPE, 1.0),
            Decoder(ContentForm(codec, law), SHAPE, 1),
        )
        for sample, data in said(encoder, motion(rng, 200), energies(rng, law)):
            heard = decoder.decode(sample.index, sample.stamp, T, data)
            assert heard is not None
            assert heard.message is not None
            assert sample.message is not None
            assert (heard.message[1][own] <= sample.message[1][own]).all()
        assert encoder.unchanged > 20


def test_what_is_said_in_one_byte_is_within_the_deadband() -> None:
    codec = Codec(deadband=0.1, hold=50)
    v = np.full((200, 2, 1), 0.1)
    v[100:] *= 1.05
    v[150:] *= 1.5
    encoder, decoder = Encoder(ContentForm(codec, WAVE), ONES, SHAPE, 1.0), Decoder(ContentForm(codec, WAVE), SHAPE, 1)
    still = (np.ones((1, 2)), np.array([1.0]))
    words = said(encoder, v, lambda _k, _mean: still)
    contents = [k for k, (_, data) in enumerate(words) if len(data) > 1]
    # The first two find the speed; after that every 51st, for 5 % more is not worth saying; half as much again is.
    assert contents[:4] == [0, 1, 52, 103]
    assert 150 < contents[4] <= 160
    for sample, data in words:
        heard = decoder.decode(sample.index, sample.stamp, T, data)
        assert heard is not None
        off = np.linalg.norm(heard.position - sample.position)
        assert off <= 0.1 * 0.16 * np.sqrt(2) * (codec.hold + 1) * T
        assert heard.index == sample.index


def test_a_content_that_is_lost_takes_with_it_what_goes_on_from_it() -> None:
    codec = Codec(deadband=0.1)
    v = np.full((30, 2, 1), 0.1)
    v[10:] = -0.1
    encoder, decoder = Encoder(ContentForm(codec, WAVE), ONES, SHAPE, 1.0), Decoder(ContentForm(codec, WAVE), SHAPE, 1)
    words = said(encoder, v, lambda _k, _mean: (np.zeros((1, 2)), np.zeros(1)))
    lost = max(k for k, (_, data) in enumerate(words) if len(data) > 1 and k < 20)
    assert len(words[lost + 3][1]) == 1
    heard = [decoder.decode(s.index, s.stamp, T, data) for s, data in words[:lost]]
    assert all(sample is not None for sample in heard)
    late = [decoder.decode(s.index, s.stamp, T, data) for s, data in words[lost + 1 : lost + 4]]
    assert late == [None, None, None]
    # It comes after all: what waited for it counts.
    found = decoder.decode(lost, words[lost][0].stamp, T, words[lost][1])
    assert found is not None
    assert found.index == lost + 3
    assert found.content == lost


def test_repeated_and_old_words_change_nothing() -> None:
    codec = Codec(deadband=0.1, hold=5)
    encoder, decoder = (
        Encoder(ContentForm(codec, SPRING), ONES, SHAPE, 1.0),
        Decoder(ContentForm(codec, SPRING), SHAPE, 1),
    )
    words = said(encoder, motion(np.random.default_rng(3), 60))
    for sample, data in words:
        decoder.decode(sample.index, sample.stamp, T, data)
    first = next((s, data) for s, data in words if len(data) > 1)
    assert decoder.decode(first[0].index, first[0].stamp, T, first[1]) is None


def test_nonsense_makes_nothing() -> None:
    codec = Codec(deadband=0.1, quantum=1e-4, hold=5)
    decoder = Decoder(ContentForm(codec, ONCE), SHAPE, 1)
    rng = np.random.default_rng(0)
    good = said(
        Encoder(ContentForm(codec, ONCE), ONES, SHAPE, 1.0),
        np.zeros((1, 2, 1)),
        lambda _k, _m: (np.zeros((1, 2)), np.ones(1)),
    )
    whole = good[0][1]
    nan = bytes([0]) + np.full(9, np.nan).tobytes()
    for data in (b"", b"\x00", b"\x01", b"\x06", b"\xff", whole[:-1], whole + b"\x00", nan, b"\x07" + whole[1:]):
        assert decoder.decode(3, 0.003, T, data) is None
    assert decoder.decode(-1, 0.0, T, whole) is None
    assert decoder.decode(0, float("nan"), T, whole) is None
    assert decoder.decode(0, 0.0005, T, whole) is not None
    assert decoder.decode(6, 0.0065, T, b"\x06") is None  # longer than anything goes on
    assert decoder.decode(5, 0.0055, T, b"\x05") is not None
    for _ in range(300):
        data = rng.integers(0, 256, int(rng.integers(0, 90)), dtype=np.uint8).tobytes()
        heard = decoder.decode(int(rng.integers(0, 50)), float(rng.uniform(0, 0.05)), T, data)
        assert heard is None or np.isfinite(heard.position).all()


def test_a_velocity_counts_once_and_is_never_larger_than_it_was() -> None:
    codec = Codec(deadband=0.3, quantum=1e-3)
    encoder, decoder = Encoder(ContentForm(codec, ONCE), ONES, SHAPE, 0.01), Decoder(ContentForm(codec, ONCE), SHAPE, 1)
    rng = np.random.default_rng(1)
    heard: list[Sample] = []
    for sample, data in said(encoder, motion(rng, 300), lambda _k, mean: (mean.reshape(1, 2), np.full(1, T))):
        found = decoder.decode(sample.index, sample.stamp, T, data)
        assert found is not None
        assert found.message is not None
        assert sample.message is not None
        if len(data) > 1:
            assert (np.abs(found.message[0]) <= np.abs(sample.message[0])).all()
        heard.append(found)
    assert all(b.content == a.content or b.content == b.index for a, b in pairwise(heard))
    assert encoder.unchanged > 30


def test_a_law_is_told_that_a_continued_sample_is_not_new() -> None:
    """`once` uses a velocity once, however often it is said that it goes on."""
    import_module("numba.experimental.function_type")  # kernels that are loaded bring it along; here is none
    start = Sample(sender=1, index=-1, stamp=0.0, position=np.zeros(SHAPE))
    memory = CopyMemory(ONCE, 2)
    link = LawLink(FreshestLink(start), law=ONCE, parameters=np.array([2.0]), memory=memory, side=0, copies=2)
    target, push = np.zeros(SHAPE), np.zeros(SHAPE)
    link.attach(spring=50.0, place=(0, 1), weight=np.ones(2), target=target, push=push)
    pushes: list[float] = []
    for index, content in ((0, 0), (1, 0), (5, 0), (6, 6), (9, 7)):
        message = np.ones((1, 2)), np.full(1, T)
        sample = Sample(sender=1, index=index, stamp=0.0, position=np.zeros(SHAPE), message=message, content=content)
        assert link.offer(sample)
        link.before(link.choose(0), 0.01, T, np.zeros(SHAPE), np.zeros(SHAPE))
        pushes.append(float(push[0, 0]))
    assert pushes == [2.0, 0.0, 0.0, 2.0, 2.0]


def test_an_account_gives_out_what_it_earned_and_no_more() -> None:
    """To a sender that errs as much as it may, and a neighbour that uses the worst sample that it may."""
    age, window = 0.002, 0.015
    codec, rng = Codec(deadband=0.1, age=age), np.random.default_rng(0)
    account = Encoder(ContentForm(codec, SPRING), ONES, SHAPE, window).account
    assert account is not None
    errors: list[float] = []
    earned = cost = 0.0
    for k in range(1500):
        square = float(rng.exponential()) if rng.random() < 0.02 else 0.0
        account.earn(square, k * T, T)
        earned += T * age * square
        error = next((size for size in np.geomspace(1e-4, 1e-12, 33).tolist() if account.affords(size, T)), 0.0)
        account.spend(error, k * T, T)
        errors.append(error)
        cost += T * max(errors[-round(window / T) :]) / age
        assert cost <= earned * (1.0 + 1e-9)
    assert cost > 0.8 * earned


def pulls_evenly(force: float, k: float, far: float) -> Told:
    """What `paid` tells of a spring that always pulls with the same force, far from the origin, and once with a jerk.

    Args:
        force: of the spring on each row [N].
        k: its stiffness [N/m].
        far: how far rows are from the origin at first [m].
    """
    place, sums = np.full(2, far), np.zeros((2, 2))

    def message(step: int, mean: Float) -> Message:
        w = force + k * (place + 0.5 * T * mean.ravel())
        place[:] += T * mean.ravel()
        sums[1] += T * sums[0] + 0.5 * T * T * w
        sums[0] += T * w + (JERK if step == JERKS else 0.0)
        fields, numbers = np.zeros((len(PAID.sends), 2)), np.zeros(len(PAID.sends_scalars))
        for name, field in (("w", w), ("P", sums[0]), ("Q", sums[1])):
            fields[PAID.sends.index(name)] = field
        numbers[PAID.sends_scalars.index("k")] = k
        return fields, numbers

    return message


def test_a_hands_force_is_judged_by_what_it_is_where_the_copy_is() -> None:
    """However far the origin is: the force that a neighbour works out stays within the deadband."""
    codec, w_at, p_at = Codec(deadband=0.1), PAID.sends.index("w"), PAID.sends.index("P")
    v = np.full((300, 2, 1), 0.05)
    v[150:] = 0.0
    counts: list[int] = []
    for far in (0.0, 10.0):
        encoder, decoder = (
            Encoder(ContentForm(codec, PAID), ONES, SHAPE, 1.0),
            Decoder(ContentForm(codec, PAID), SHAPE, 1),
        )
        jerked = False
        for sample, data in said(encoder, v, pulls_evenly(1.0, 300.0, far), far):
            heard = decoder.decode(sample.index, sample.stamp, T, data)
            assert heard is not None
            assert heard.message is not None
            assert sample.message is not None
            off = heard.message[0] - sample.message[0]
            assert np.linalg.norm(off[w_at]) <= 0.1 * np.sqrt(2.0) + 1e-3
            assert np.linalg.norm(off[p_at]) <= 0.1 * np.sqrt(2.0) * T * codec.hold
            jerked = jerked or (sample.index == JERKS and len(data) > 1)
        assert jerked
        counts.append(encoder.contents)
    assert 15 <= counts[0] < 150
    assert counts[1] == pytest.approx(counts[0], abs=2)


def test_a_hand_that_holds_at_the_origin_is_still_a_hand_when_it_is_rounded() -> None:
    """`paid` takes a force at the origin of exactly 0 for none, so that no rounding may make one."""
    codec, w_at = Codec(deadband=0.1, quantum=1e-5), PAID.sends.index("w")
    encoder, decoder = Encoder(ContentForm(codec, PAID), ONES, SHAPE, 1.0), Decoder(ContentForm(codec, PAID), SHAPE, 1)
    for tiny in (-1e-12, 1e-12):
        message = np.zeros((len(PAID.sends), 2)), np.zeros(len(PAID.sends_scalars))
        message[0][w_at, 0] = tiny
        index = 0 if tiny < 0.0 else 1
        sample = Sample(sender=1, index=index, stamp=(index + 0.5) * T, position=np.zeros(SHAPE), message=message)
        (data,) = encoder.encode(sample, np.zeros(SHAPE), T)
        assert encoder.said in {ROUNDED, 1}
        heard = decoder.decode(index, sample.stamp, T, data)
        assert heard is not None
        assert heard.message is not None
        force = heard.message[0][w_at]
        assert 0.0 < abs(force[0]) <= codec.quantum
        assert force[1] == 0.0


def test_the_bytes_that_the_documents_give_are_those_of_contents() -> None:
    text = (Path(__file__).parents[2] / "docs" / "codec.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\| `(\w+)` \|.*\| (\d+), (\d+), (\d+)(?: bytes)? \|$", text, re.MULTILINE)
    assert len({name for name, *_ in rows}) == 8
    for name, *sizes in rows:
        law = law_named(name)
        form = ContentForm(Codec(deadband=0.1, quantum=QUANTUM), law)
        plain = 3 * (8 * (1 + len(law.sums)) + 4 * len(law.coarse)) + 8 * len(law.sends_scalars)
        assert [form.size(FULL, 3), form.size(ROUNDED, 3), plain] == [int(size) for size in sizes], name
