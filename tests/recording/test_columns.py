"""Batches as bytes: there and back, and nothing believed of what is not a batch."""

import re
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.recording.inside import SCALARS, STATES, VECTORS, Batch, description, pack, unpack
from tests.thorough import examples

from cotouch.errors import RecordingError
from cotouch.peer import LinkState


def batch(steps: int, links: int, states: int, seed: int = 0) -> Batch:
    rng = np.random.default_rng(seed)
    columns = {name: rng.normal(size=steps) for name in SCALARS}
    columns["index"] = np.arange(steps, dtype=np.int64)
    columns["link_work"] = rng.normal(size=(steps, links))
    columns["link_state"] = rng.integers(0, 4, (steps, links)).astype(np.int8)
    columns["force"] = rng.normal(size=(steps, 2, 3))
    columns["state_row"] = np.sort(rng.choice(steps, states, replace=False)).astype(np.int32)
    columns["position"] = rng.normal(size=(states, 4, 3))
    columns["own"] = rng.normal(size=(steps, 5))
    return Batch(tuple(range(3, 3 + links)), columns)


@given(st.integers(1, 20), st.integers(0, 3), st.data())
def test_there_and_back(steps: int, links: int, data: st.DataObject) -> None:
    original = batch(steps, links, data.draw(st.integers(0, steps)))
    again = unpack(pack(original))
    assert again.neighbours == original.neighbours
    assert set(again.columns) == set(original.columns)
    for name, values in original.columns.items():
        assert np.array_equal(again.columns[name], values)
        assert again.columns[name].dtype == values.dtype


@settings(max_examples=examples(300))
@given(st.data())
def test_broken_bytes_are_refused_or_are_a_batch(data: st.DataObject) -> None:
    good = bytearray(pack(batch(6, 2, 3)))
    for _ in range(data.draw(st.integers(1, 8))):
        good[data.draw(st.integers(0, len(good) - 1))] = data.draw(st.integers(0, 255))
    del good[data.draw(st.integers(0, len(good))) :]
    try:
        found = unpack(bytes(good))
    except RecordingError:
        return
    count = found.columns["time"].size
    assert all(values.shape[0] == count for name, values in found.columns.items() if name not in STATES)


def test_sizes_that_contradict_each_other_are_refused() -> None:
    one = batch(6, 2, 3)
    for name, values in (
        ("age", np.zeros((6, 3))),
        ("time", np.zeros(5)),
        ("state_row", np.array([0, 1, 6], dtype=np.int32)),
        ("state_row", np.array([2, 1, 3], dtype=np.int32)),
    ):
        with pytest.raises(RecordingError):
            unpack(pack(Batch(one.neighbours, {**one.columns, name: values})))


def test_every_column_is_described() -> None:
    text = description({"own": ("J", "mine")}).decode()
    for name in (*SCALARS, *VECTORS, *STATES, "own"):
        assert f'"{name}"' in text
    assert "little-endian" in text


def test_every_kind_of_event_is_documented() -> None:
    root = Path(__file__).parents[2]
    source = "\n".join(path.read_text() for path in (root / "src" / "cotouch").rglob("*.py"))
    kinds = set(re.findall(r'\.event\(\s*"(\w+)"', source)) | {state.name.lower() for state in LinkState}
    assert {"path", "cut", "beyond", "guarded", "coupled"} <= kinds
    table = (root / "docs" / "recording.md").read_text().split("### Events")[1].split("## ")[0]
    assert not {kind for kind in kinds if f"`{kind}`" not in table}
