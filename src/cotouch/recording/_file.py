"""The file of a recording: MCAP, a chunk for every batch, flushed, so that it can be cut off anywhere."""

import contextlib
import json
import struct
import tempfile
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Final, cast, final

import numpy as np
from mcap.records import ChunkIndex
from mcap.writer import CompressionType, Writer

from cotouch.arrays import Array
from cotouch.errors import RecordingError
from cotouch.recording._columns import Batch, description, pack
from cotouch.recording._disk import NewFile
from cotouch.recording._header import RecordHeader

PROFILE: Final = "cotouch"
METADATA: Final = "cotouch"
CONFIGURATION: Final = "configuration.json"
BODY: Final = "body.npz"
STEPS, EVENTS, LEDGER = "/steps", "/events", "/ledger"
ENCODING: Final = "cotouch-columns"

_EVENT_SCHEMA: dict[str, object] = {
    "type": "object",
    "title": "cotouch.Event",
    "properties": {
        "kind": {
            "type": "string",
            "description": "setup, gap, joined, left, guarded, coupled, budget, way, alarm, ...",
        },
        "time": {"type": "number", "description": "on the user's monotonic clock [s]"},
        "first": {"type": "integer", "description": "index of the first step after it"},
    },
    "required": ["kind", "time", "first"],
}
_NUMBER = {"type": "number"}
_LEDGER_SCHEMA: dict[str, object] = {
    "type": "object",
    "title": "cotouch.Ledger",
    "description": "sums over one batch of steps; energies in J, times in s",
    "properties": {
        **{name: {"type": "integer"} for name in ("first", "last")},
        **dict.fromkeys(("begin", "end", "supplied", "lost", "stored", "residual"), _NUMBER),
        "links": {
            "type": "array",
            "items": {
                "type": "object",
                "properties": {
                    "neighbour": {"type": "integer"},
                    **dict.fromkeys(("work", "age_min", "age_max"), _NUMBER),
                },
            },
        },
    },
}

# Where the writer keeps what its summary will say of every chunk, until the end.
_INDICES = "_Writer__chunk_indices"
_ENTRY, _MESSAGES = struct.Struct("<7QB"), struct.Struct("<HQ")


@final
class ChunkIndices:
    """What a summary says of every chunk, kept on disk until the end: memory does not grow as a recording does."""

    def __init__(self, compression: str, folder: Path) -> None:
        """Starts without chunks.

        Args:
            compression: of all of them.
            folder: where there is room; the file has no name there, and goes with the process.

        Raises:
            OSError: there is none.
        """
        self._compression = compression
        self._packed = tempfile.TemporaryFile(dir=folder)  # noqa: SIM115

    def append(self, index: ChunkIndex) -> None:
        """Adds a chunk.

        Raises:
            OSError: the disk is full.
        """
        offsets = index.message_index_offsets
        self._packed.write(
            _ENTRY.pack(
                index.chunk_start_offset,
                index.chunk_length,
                index.message_start_time,
                index.message_end_time,
                index.message_index_length,
                index.compressed_size,
                index.uncompressed_size,
                len(offsets),
            )
        )
        for channel, offset in offsets.items():
            self._packed.write(_MESSAGES.pack(channel, offset))

    def __iter__(self) -> Iterator[ChunkIndex]:
        """All chunks, as the writer made them; no more can be added then."""
        self._packed.seek(0)
        while entry := self._packed.read(_ENTRY.size):
            start, length, first, last, messages, compressed, size, count = _ENTRY.unpack(entry)
            yield ChunkIndex(
                chunk_start_offset=start,
                chunk_length=length,
                message_start_time=first,
                message_end_time=last,
                message_index_length=messages,
                message_index_offsets=dict(_MESSAGES.iter_unpack(self._packed.read(count * _MESSAGES.size))),
                compressed_size=compressed,
                uncompressed_size=size,
                compression=self._compression,
            )

    def close(self) -> None:
        """Gives the room back."""
        self._packed.close()


@final
class RecordingFile:
    """Writes batches and events; used by one thread.

    Raises:
        RecordingError: the head cannot be written; then there is no file.
    """

    def __init__(self, file: NewFile, header: RecordHeader) -> None:
        self._file = file
        self._offset = header.offset
        self._writer = writer = Writer(file, compression=CompressionType.ZSTD, chunk_size=1 << 62)  # pyright: ignore[reportArgumentType]  # it writes, tells and flushes
        self._indices: ChunkIndices | None = None
        try:
            held = vars(writer)
            if held.get(_INDICES) == []:  # a writer that keeps them elsewhere only takes more memory
                held[_INDICES] = self._indices = ChunkIndices("zstd", file.path.parent)
            writer.start(profile=PROFILE, library=header.metadata()["version"])
            writer.add_metadata(METADATA, header.metadata())
            begun = self._ns(header.monotonic)
            configuration = json.dumps(dict(header.configuration)).encode()
            writer.add_attachment(begun, begun, CONFIGURATION, "application/json", configuration)
            writer.add_attachment(begun, begun, BODY, "application/x-npz", header.body.to_bytes())
            schema = writer.register_schema("cotouch.Steps", ENCODING, description(dict(header.columns)))
            self._steps = writer.register_channel(STEPS, ENCODING, schema)
            self._events = self._json_channel(EVENTS, _EVENT_SCHEMA)
            self._ledger = self._json_channel(LEDGER, _LEDGER_SCHEMA)
            file.keep()
        except OSError as error:
            file.discard()
            if self._indices is not None:
                self._indices.close()
            reason = error.strerror or error
            raise RecordingError(f"the recording {file.path} cannot be written: {reason}") from error

    def batch(self, batch: Batch) -> None:
        """Adds a batch and its ledger."""
        time = self._ns(float(batch.columns["time"][-1]))
        sequence = int(batch.columns["index"][0]) & 0xFFFF_FFFF
        self._writer.add_message(self._steps, time, pack(batch), time, sequence)
        self._writer.add_message(self._ledger, time, json.dumps(_ledger(batch)).encode(), time, sequence)

    def event(self, fields: Mapping[str, object]) -> None:
        """Adds an event; what JSON has no word for is written as text."""
        time = self._ns(float(cast("float", fields["time"])))
        self._writer.add_message(self._events, time, json.dumps(fields, default=_plain).encode(), time)

    def flush(self) -> None:
        """Hands everything to the operating system, so that the end of this process cannot take it back.

        Raises:
            OSError: it does not take it.
        """
        self._writer.flush()
        self._file.keep()

    def finish(self) -> None:
        """Writes the index and closes.

        Raises:
            OSError: the index does not fit any more; what was flushed can be read without it.
        """
        self.flush()
        self._writer.finish()
        self._file.keep()
        self._close()

    def abandon(self) -> None:
        """Closes after an error: cut off behind what was flushed last."""
        self._file.cut()
        with contextlib.suppress(OSError):
            self._close()

    def _close(self) -> None:
        try:
            self._file.close()
        finally:
            if self._indices is not None:
                with contextlib.suppress(OSError):
                    self._indices.close()

    def _json_channel(self, topic: str, schema: dict[str, object]) -> int:
        number = self._writer.register_schema(str(schema["title"]), "jsonschema", json.dumps(schema).encode())
        return self._writer.register_channel(topic, "json", number)

    def _ns(self, time: float) -> int:
        return max(0, round((time + self._offset) * 1e9))


def _ledger(batch: Batch) -> dict[str, object]:
    columns = batch.columns
    lost = sum(float(columns[name].sum()) for name in ("body_loss", "local_loss", "extra_loss", "touch_loss", "cut"))
    stored = sum(float(columns[name][-1]) for name in ("kinetic", "elastic", "proxy", "touch_stored"))
    return {
        "first": int(columns["index"][0]),
        "last": int(columns["index"][-1]),
        "begin": float(columns["time"][0] - columns["period"][0]),
        "end": float(columns["time"][-1]),
        "supplied": float(columns["supplied"].sum() + columns["drive_work"].sum()),
        "lost": lost,
        "stored": stored,
        "residual": float(columns["residual"].sum()),
        "links": [
            {
                "neighbour": neighbour,
                "work": float(columns["link_work"][:, at].sum()),
                "age_min": float(columns["age"][:, at].min()),
                "age_max": float(columns["age"][:, at].max()),
            }
            for at, neighbour in enumerate(batch.neighbours)
        ],
    }


def _plain(value: object) -> object:
    if isinstance(value, np.ndarray | np.generic):
        return cast("Array", value).tolist()
    return str(value)
