"""What these tests take from inside the room: nothing else here imports its private modules."""

from cotouch.recording._columns import SCALARS, STATES, VECTORS, Batch, description, pack, unpack
from cotouch.recording._disk import RawFile, make
from cotouch.recording._file import ChunkIndices
from cotouch.recording._findings import findings_of
from cotouch.recording._links import align
from cotouch.recording._material import RecordedMaterial
from cotouch.recording._motion import motions
from cotouch.recording._outside import Outside
from cotouch.recording._outside import _begun as begun
from cotouch.recording._recording import recording_of
from cotouch.recording._stopped import before_stop, stopped_rows

__all__ = [
    "SCALARS",
    "STATES",
    "VECTORS",
    "Batch",
    "ChunkIndices",
    "Outside",
    "RawFile",
    "RecordedMaterial",
    "align",
    "before_stop",
    "begun",
    "description",
    "findings_of",
    "make",
    "motions",
    "pack",
    "recording_of",
    "stopped_rows",
    "unpack",
]
