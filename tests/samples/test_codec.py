"""What is written is read, with the rounding that was reported; whatever else arrives is refused with a reason."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.live.support import datagrams, heading, layout, state_of

from cotouch.errors import SessionError
from cotouch.peer import LinkHeader
from cotouch.samples import HEAD_BYTES, MOST_BYTES, OVERHEAD, Chunk, Layout, Refusal, SampleCodec

ENCODINGS = ["float64", "float32", "float16"]
OFFSETS = {"flags": 2, "epoch": 4, "sender": 8, "rows": 10, "first": 12, "step": 24, "stamp": 32, "T": 40, "echo": 48}
OFFSETS |= {"held": 56, "age": 64, "worst": 72, "given": 80, "guard": 88, "starved": 91, "state": 92}


def read(codec: SampleCodec, payload: bytes) -> Chunk | Refusal:
    return codec.read(payload, epoch=3, sender=1)


times = st.floats(-1e10, 1e10)
spans = st.floats(0.0, 1e10)
headings = st.builds(
    lambda stamp, T, echo, held, ages, flags, received, header: heading(
        step=received[1], stamp=stamp, T=T, echo=echo, held=held, age=min(ages), worst=max(ages), flags=flags,
        received_newest=received[0], received_count=received[2], header=LinkHeader(*header),
    ),
    times, st.floats(1e-9, 10.0), times, spans, st.tuples(times, times), st.integers(0, 7),
    st.tuples(st.integers(0, 2**32 - 1), st.integers(0, 2**40), st.integers(0, 2**32 - 1)),
    st.tuples(
        st.integers(0, 2), st.integers(0, 255), st.integers(0, 255), st.floats(0.0, 1e12), st.booleans()
    ),
)  # fmt: skip


@given(
    rows=st.integers(1, 600),
    axes=st.integers(1, 3),
    encoding=st.sampled_from(ENCODINGS),
    head=headings,
    seed=st.integers(0, 99),
)
def test_round_trip(rows: int, axes: int, encoding: str, head, seed: int):
    shape = layout(rows, axes, encoding=encoding)
    codec, state = SampleCodec(shape), state_of(shape, seed, size=10.0 ** (seed % 8 - 4))
    written = codec.write(state)
    back, seen = np.full((rows, axes), np.nan), 0
    for k, payload in enumerate(datagrams(codec, state, head)):
        assert len(payload) + OVERHEAD <= MOST_BYTES
        chunk = read(codec, payload)
        assert isinstance(chunk, Chunk)
        assert chunk.heading == head
        assert chunk.chunk == k
        back[shape.span(k)] = chunk.values
        error = np.abs(chunk.values - state[shape.span(k), :axes]).max()
        assert error == written.error[k]
        assert error <= shape.rounding(np.abs(state[shape.span(k)]).max())
        seen += len(chunk.values)
    assert seen == rows
    assert np.array_equal(back, written.state[:, :axes])
    assert encoding != "float64" or np.array_equal(back, state[:, :axes])
    assert not written.state[:, axes:].any()


@pytest.mark.parametrize("encoding", ENCODINGS)
def test_the_rounding_bound_is_reached_and_holds_down_to_nothing(encoding: str):
    """Random numbers of every size; the bound is not far above what they show."""
    shape = layout(1, 1, encoding=encoding)
    rng = np.random.default_rng(0)
    worst = 0.0
    for magnitude in (1e-300, 1e-9, 1e-7, 1e-3, 1.0, 1e3):
        exact = rng.uniform(-magnitude, magnitude, 5000)
        error = np.abs(exact.astype(shape.dtype).astype(np.float64) - exact).max()
        bound = shape.rounding(magnitude)
        assert error <= bound
        worst = max(worst, error / bound) if bound else worst
    assert encoding == "float64" or worst > 0.9


def test_reduced_coordinates_report_what_they_leave_out():
    rng = np.random.default_rng(1)
    basis = np.linalg.qr(rng.normal(size=(300, 20)))[0]
    shape = layout(300, 3, encoding="float32", basis=basis)
    codec, state = SampleCodec(shape), state_of(shape, 2)
    written = codec.write(state)
    assert len(written.bodies) == shape.chunks == 1
    chunk = read(codec, codec.datagram(heading(), 0, written.bodies[0]))
    out = np.zeros_like(state)
    shape.expand(chunk.values, out)
    assert np.array_equal(out, written.state)
    assert written.error[0] == np.abs(out - state).max() > 0.01
    assert np.allclose(out[:, :3], basis @ (basis.T @ state[:, :3]), atol=1e-6)


@pytest.mark.parametrize("encoding", ENCODINGS)
def test_every_truncation_and_extension_is_refused(encoding: str):
    codec = SampleCodec(layout(5, 3, encoding=encoding))
    (payload,) = datagrams(codec, state_of(codec.layout, 0), heading())
    for size in range(len(payload)):
        assert read(codec, payload[:size]) in {Refusal.SHORT, Refusal.SIZE}
    assert read(codec, payload + b"\0") is Refusal.SIZE
    assert isinstance(read(codec, payload), Chunk)


@pytest.mark.parametrize("at", range(HEAD_BYTES))
def test_every_change_of_the_head_is_refused_or_means_something_else(at: int):
    """No byte of it is without meaning; none of them crashes the reader."""
    codec = SampleCodec(layout(100, 3))
    payload = datagrams(codec, state_of(codec.layout, 0), heading(7, age=1.0, worst=2.0, held=0.5, echo=1.5))[1]
    good = read(codec, payload)
    for value in range(256):
        changed = bytearray(payload)
        if changed[at] == value:
            continue
        changed[at] = value
        result = read(codec, bytes(changed))
        assert isinstance(result, Refusal) or result.heading != good.heading or result.chunk != good.chunk


BAD = [
    ("flags", "<H", 8, Refusal.FLAGS),
    ("epoch", "<I", 2, Refusal.EPOCH),
    ("epoch", "<I", 4, Refusal.EPOCH),
    ("sender", "<H", 2, Refusal.SENDER),
    ("rows", "<H", 0, Refusal.RANGE),
    ("rows", "<H", 43, Refusal.RANGE),
    ("rows", "<H", 65535, Refusal.RANGE),
    ("first", "<I", 1, Refusal.RANGE),
    ("first", "<I", 4_294_967_295, Refusal.RANGE),
    ("first", "<I", 135, Refusal.RANGE),
    ("first", "<I", 90, Refusal.RANGE),
    ("step", "<Q", 2**40 + 1, Refusal.INDEX),
    *[("state", "<d", value, Refusal.STATE) for value in (math.nan, math.inf, -math.inf, 1.0000001e4, 1e308)],
    *[
        (name, "<d", value, Refusal.TIME)
        for name in ("stamp", "T", "echo", "held", "age", "worst")
        for value in (math.nan, math.inf, -math.inf, 1e300, -1e300)
    ],
    ("T", "<d", 0.0, Refusal.TIME),
    ("T", "<d", -0.001, Refusal.TIME),
    ("T", "<d", 11.0, Refusal.TIME),
    ("held", "<d", -1e-9, Refusal.TIME),
    ("age", "<d", 0.1, Refusal.TIME),  # above the worst
    ("guard", "<B", 3, Refusal.GUARD),
    ("guard", "<B", 255, Refusal.GUARD),
    ("starved", "<B", 2, Refusal.GUARD),
    ("given", "<d", -1e-9, Refusal.GUARD),
    ("given", "<d", math.nan, Refusal.GUARD),
    ("given", "<d", 1.1e12, Refusal.GUARD),
]


@pytest.mark.parametrize(("name", "form", "value", "reason"), BAD)
def test_what_cannot_be_is_refused_by_name(name: str, form: str, value: float, reason: Refusal):
    import struct

    codec = SampleCodec(layout(100, 3))
    payload = bytearray(datagrams(codec, state_of(codec.layout, 0), heading(7))[0])
    struct.pack_into(form, payload, OFFSETS[name], value)
    assert read(codec, bytes(payload)) is reason


@pytest.mark.parametrize("place", [0, 1, 131])
@pytest.mark.parametrize("value", [math.nan, math.inf, 1e5])
def test_one_bad_number_among_many_is_found(place: int, value: float):
    codec = SampleCodec(layout(44, 3))
    (payload,) = datagrams(codec, state_of(codec.layout, 0), heading())
    state = np.frombuffer(payload, offset=HEAD_BYTES).copy()
    state[place] = value
    assert read(codec, payload[:HEAD_BYTES] + state.tobytes()) is Refusal.STATE


@pytest.mark.parametrize("encoding", ENCODINGS)
def test_all_at_the_limit_passes_whatever_the_rounding(encoding: str):
    shape = layout(40, 3, encoding=encoding, limit=0.1)
    codec = SampleCodec(shape)
    (payload,) = datagrams(codec, np.full((40, 4), 0.1), heading())
    assert isinstance(read(codec, payload), Chunk)


@pytest.mark.parametrize("value", [math.nan, math.inf, 10001.0])
def test_what_no_receiver_takes_is_not_sent(value: float):
    codec = SampleCodec(layout(4, 3))
    state = state_of(codec.layout, 0)
    state[2, 1] = value
    assert codec.write(state) is Refusal.STATE


def test_padding_never_travels():
    codec = SampleCodec(layout(4, 3))
    state = state_of(codec.layout, 0)
    state[:, 3] = math.nan
    assert isinstance(codec.write(state).bodies, list)


def test_another_coding_is_refused():
    payload = datagrams(SampleCodec(layout(4, 3)), np.zeros((4, 4)), heading())[0]
    assert read(SampleCodec(layout(4, 3, encoding="float32")), payload) is Refusal.ENCODING


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"rows": 0}, "0 rows"),
        ({"axes": 5}, "5 axes"),
        ({"encoding": "int8"}, "coding 'int8'"),
        ({"limit": 0.0}, "limit is 0.0"),
        ({"limit": math.nan}, "limit is nan"),
        ({"encoding": "float16", "limit": 1e5}, "limit is 100000.0"),
        ({"basis": np.ones((3, 1))}, "basis has the shape"),
        ({"basis": np.ones((4, 2))}, "independent columns"),
        ({"rows": 900, "basis": np.eye(900)[:, :200]}, "200 coordinates; 44 fit"),
    ],
)
def test_a_layout_that_cannot_be_is_named(options: dict[str, object], message: str):
    with pytest.raises(SessionError, match=message):
        Layout(**({"rows": 4, "width": 4, "axes": 3} | options))


@given(st.binary(max_size=1300))
def test_noise_is_refused_and_nothing_raised(noise: bytes):
    codec = SampleCodec(layout(100, 3))
    assert isinstance(read(codec, noise), Refusal)
    assert isinstance(read(codec, b"\1\0\0\0\3\0\0\0\1\0\x2d\0\0\0\0\0" + noise), Refusal | Chunk)


@pytest.mark.parametrize("encoding", ENCODINGS)
@pytest.mark.parametrize("rows", [1, 5, 16, 17, 40])
def test_the_limit_holds_for_few_numbers_as_for_many(rows: int, encoding: str):
    shape = layout(rows, 1, encoding=encoding, limit=1000.0)
    codec = SampleCodec(shape)
    (payload,) = datagrams(codec, np.zeros((rows, shape.width)), heading())
    size = shape.dtype.itemsize
    for at in (0, rows - 1):
        for value, fits in ((1000.0, True), (-1000.0, True), (-0.0, True), (1000.6, False), (-1000.6, False)):
            there = HEAD_BYTES + at * size
            changed = payload[:there] + np.array(value, dtype=shape.dtype).tobytes() + payload[there + size :]
            assert (read(codec, changed) is Refusal.STATE) != fits
        for value in (math.nan, -math.nan, math.inf, -math.inf):
            changed = payload[:there] + np.array(value, dtype=shape.dtype).tobytes() + payload[there + size :]
            assert read(codec, changed) is Refusal.STATE
