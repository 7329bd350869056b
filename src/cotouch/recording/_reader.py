"""Reading a recording, whole or cut off: up to the last batch that is as it was written."""

import io
import json
import struct
from collections.abc import Generator
from pathlib import Path
from typing import Any

import zstandard
from mcap.exceptions import EndOfFile, McapError
from mcap.records import Attachment, Channel, Chunk, Footer, McapRecord, Message, Metadata, Schema
from mcap.stream_reader import StreamReader, breakup_chunk

from cotouch.errors import RecordingError
from cotouch.files import read_bytes
from cotouch.recording._columns import Batch, unpack
from cotouch.recording._file import BODY, CONFIGURATION, EVENTS, METADATA, STEPS
from cotouch.recording._header import RecordHeader
from cotouch.recording._recording import RecordedEvent, Recording, recording_of

# It is read as a whole.
_MOST_BYTES = 16 << 30
# No batch of ours comes near it; what a broken or hostile file asks for must not be made.
_MOST_CHUNK = 1 << 30
_BROKEN = (McapError, struct.error, ValueError, EOFError, OSError, KeyError, zstandard.ZstdError, IndexError)


def read_recording(path: str | Path) -> Recording:
    """Reads a recording.

    Args:
        path: of the MCAP file; it may be cut off anywhere behind its head.

    Raises:
        RecordingError: it cannot be read, is none of ours, or ends before its first step.
    """
    data = read_bytes(Path(path), "recording", RecordingError, _MOST_BYTES)
    try:
        return _recording(data, str(path))
    except RecordingError as error:
        raise RecordingError(f"{path}: {error}") from None


def _recording(data: bytes, name: str) -> Recording:
    metadata: dict[str, str] | None = None
    attachments: dict[str, bytes] = {}
    topics: dict[int, str] = {}
    batches: list[Batch] = []
    events: list[RecordedEvent] = []
    broken: str | None = "it ends before its index"
    try:
        for record in _records(data):
            if isinstance(record, Metadata) and record.name == METADATA:
                metadata = dict(record.metadata)
            elif isinstance(record, Attachment):
                attachments[record.name] = record.data
            elif isinstance(record, Channel):
                topics[record.id] = record.topic
            elif isinstance(record, Message):
                topic = topics.get(record.channel_id)
                if topic == STEPS:
                    batches.append(unpack(record.data))
                elif topic == EVENTS:
                    events.append(_event(record.data))
            elif isinstance(record, Footer):
                broken = None
    except EndOfFile:
        pass
    except _BROKEN as error:
        broken = f"it breaks off: {str(error) or type(error).__name__}"
    if metadata is None or CONFIGURATION not in attachments or BODY not in attachments:
        raise RecordingError("it is not a cotouch recording, or ends within its header")
    header = RecordHeader.read(metadata, attachments[CONFIGURATION], attachments[BODY])
    return recording_of(name, header, batches, events, broken)


def _records(data: bytes) -> Generator[McapRecord]:
    """Records in order, those inside of a chunk only if its checksum fits."""
    stream = StreamReader(io.BytesIO(data), emit_chunks=True, record_size_limit=len(data))
    for record in stream.records:
        if not isinstance(record, Chunk):
            if not isinstance(record, Schema):
                yield record
            continue
        if record.compression == "zstd" and zstandard.frame_content_size(record.data) > _MOST_CHUNK:
            raise RecordingError(f"a chunk says that it holds more than {_MOST_CHUNK} bytes")
        yield from breakup_chunk(record, validate_crc=True)


def _event(data: bytes) -> RecordedEvent:
    fields: dict[str, Any] = json.loads(data)
    return RecordedEvent(
        kind=str(fields.pop("kind")), time=float(fields.pop("time")), first=int(fields.pop("first")), fields=fields
    )
