"""The file's index: nothing in memory, and on disk what the library itself would have written."""

import tracemalloc
from pathlib import Path

import pytest
from mcap.reader import make_reader
from mcap.records import ChunkIndex
from tests.recording.inside import ChunkIndices
from tests.recording.test_recorder import header, report, state

from cotouch.recording import Recorder, read_recording


def recorded(path: Path, steps: int = 60) -> Path:
    recorder = Recorder(path, header(), batch=3, buffers=64)
    recorder.setup(10.0, copies=2, neighbours=[1], strength=[1.0], local_damping=[1.0], extra_damping=[0.0])
    for k in range(steps):
        recorder.step(report(k), end=10.0 + 0.01 * (k + 1), T=0.01, state=state())
        if k % 7 == 0:
            recorder.event("coupled", 10.0 + 0.01 * k)
    done = recorder.close()
    assert done.failure is None
    return path


def indices(path: Path) -> list[ChunkIndex]:
    with path.open("rb") as stream:
        summary = make_reader(stream).get_summary()
    assert summary is not None
    return summary.chunk_indexes


def test_the_summary_is_whole(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    kept: list[ChunkIndex] = []
    append = ChunkIndices.append
    monkeypatch.setattr(ChunkIndices, "append", lambda self, index: (kept.append(index), append(self, index)))
    path = recorded(tmp_path / "a.mcap")
    assert len(kept) >= 20
    assert indices(path) == kept  # each as the writer made it
    assert max(len(index.message_index_offsets) for index in kept) >= 2


def test_a_writer_that_keeps_its_index_elsewhere_is_left_alone(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("cotouch.recording._file._INDICES", "not there")
    path = recorded(tmp_path / "a.mcap")
    assert len(indices(path)) >= 20
    assert read_recording(path).steps == 60


def test_memory_does_not_grow_with_the_number_of_chunks(tmp_path: Path) -> None:
    held, chunks = ChunkIndices("zstd", tmp_path), 2000

    def add(first: int) -> None:
        for k in range(first, first + chunks):
            held.append(
                ChunkIndex(
                    chunk_start_offset=k, chunk_length=1, message_start_time=2, message_end_time=3,
                    message_index_length=4, message_index_offsets={1: 5, 2: 1 << 40, 3: 7}, compressed_size=8,
                    uncompressed_size=9, compression="zstd",
                )
            )  # fmt: skip

    add(0)
    tracemalloc.start()
    add(chunks)
    grown, _ = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert grown < chunks  # a byte for each
    assert [index.chunk_start_offset for index in held] == [*range(2 * chunks)]
    assert list(tmp_path.iterdir()) == []  # nothing that a crash could leave there
    held.close()
