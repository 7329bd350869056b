"""Whatever a page sends is understood or refused, and nothing else."""

import contextlib
import json
import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.thorough import examples
from tests.web.inside import Do, FrameReceipt, PointerMessage, read_binary, read_text
from tests.web.reader import ack, pointer

from cotouch.errors import PageError
from cotouch.observers import ChooseLinks
from cotouch.web import Hello

single = st.floats(width=32, allow_nan=True, allow_infinity=True)


@settings(max_examples=examples(200))
@given(
    number=st.integers(0, 2**32 - 1),
    slot=st.integers(0, 255),
    action=st.integers(0, 5) | st.integers(0, 255),
    point=st.integers(0, 2**32 - 1),
    target=st.tuples(single, single, single),
    radius=single,
    stiffness=single,
    sent=st.floats(),
    vector=st.tuples(single, single, single),
)
def test_a_pointer_is_what_was_sent_or_refused(number, slot, action, point, target, radius, stiffness, sent, vector):
    turns = action == 4
    sensible = (
        action <= 4
        and all(abs(x) <= (4.0 if turns else 1e4) for x in vector)
        and all(abs(x) <= 1e4 for x in target)
        and 0.0 <= radius <= 1e4
        and 0.0 <= stiffness <= 1e5
        and math.isfinite(sent)
    )
    data = pointer(
        number,
        slot=slot,
        action=action,
        point=point,
        target=target,
        radius=radius,
        stiffness=stiffness,
        sent=sent,
        edge=vector,
    )
    if not sensible:
        with pytest.raises(PageError):
            read_binary(data)
        return
    read = read_binary(data)
    assert isinstance(read, PointerMessage)
    said = read.pointer
    assert (said.number, read.slot, read.point) == (number, slot, point)
    assert said.mode == ("ball", "grab", "free", "blade", "pose")[action]
    assert (said.target, said.radius, said.stiffness) == (target, radius, stiffness)
    none = (0.0, 0.0, 0.0)
    assert (said.edge, said.turn) == ((none, vector) if turns else (vector, none))


@settings(max_examples=examples(200))
@given(st.integers(0, 2**32 - 1), single | st.floats(0.0, 1e3, width=32), st.just(0.0) | single)
def test_an_ack_is_what_was_sent_or_refused(number: int, wait: float, every: float):
    data = ack(number, wait, every)
    if 0.0 <= wait <= 1e3 and (every == 0.0 or 1.0 <= every <= 1e3):
        assert read_binary(data) == FrameReceipt(number, 1e-3 * wait, 1e-3 * every)
        return
    with pytest.raises(PageError, match="the next frame is wanted in"):
        read_binary(data)


@settings(max_examples=examples(300))
@given(st.one_of(st.binary(max_size=60), st.binary(min_size=40, max_size=40).map(lambda b: b"\2" + b[1:])))
def test_bytes_never_do_anything_else(data: bytes):
    with contextlib.suppress(PageError):
        assert isinstance(read_binary(data), PointerMessage | FrameReceipt)


values = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=5),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(max_size=8), inner, max_size=3),
    max_leaves=8,
)
names = st.sampled_from(["type", "version", "token", "slot", "want", "rate", "id", "what", "arguments"])
hellos = st.dictionaries(names, values | st.sampled_from(["hello", "do", "all"]), max_size=8)


@settings(max_examples=examples(300))
@given(st.one_of(st.text(max_size=80), hellos.map(json.dumps), values.map(json.dumps)))
def test_texts_never_do_anything_else(text: str):
    with contextlib.suppress(PageError):
        assert isinstance(read_text(text), Hello | Do)


@pytest.mark.parametrize(
    "text",
    [
        "",
        "[]",
        "[" * 5000,
        '{"type": "hello"}',
        '{"type": "hello", "version": 3, "rate": 0}',
        '{"type": "hello", "version": 3, "rate": NaN}',
        '{"type": "hello", "version": 3, "slot": -1}',
        '{"type": "hello", "version": 3, "slot": 1.5}',
        '{"type": "hello", "version": 3, "extra": 1}',
        '{"type": "do", "what": "cut"}',
        '{"type": "do", "id": 1, "what": "../cut"}',
        '{"type": "do", "id": 1, "what": "cut", "delay": Infinity}',
        '{"type": "do", "id": -1, "what": "cut"}',
        '{"type": "bye"}',
    ],
)
def test_what_no_page_says_is_refused(text: str):
    with pytest.raises(PageError):
        read_text(text)


def test_arguments_stay_as_they_are():
    asked = read_text('{"type": "do", "id": 4, "what": "links", "links": [[0, 1]], "choice": null}')
    assert isinstance(asked, Do)
    assert (asked.id, asked.what, asked.parts) == (4, "links", {"links": [[0, 1]], "choice": None})
    assert asked.command() == ChooseLinks(links=((0, 1),), choice=None)
