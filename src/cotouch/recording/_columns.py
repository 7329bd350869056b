"""What a recording holds for every step, and how a batch of steps becomes bytes: one array after the other.

A batch is: length of the heading (uint32), heading (JSON, UTF-8, spaces up to a multiple of 8 bytes), arrays. All
numbers are little-endian, arrays in C order, one after the other in the order of the heading. The heading says name,
type and shape of each; the first extent is the number of steps, for state_row, position, velocity and middle that of
the steps whose state was kept.
"""

import json
import math
import struct
from typing import NamedTuple

import numpy as np

from cotouch.arrays import Array
from cotouch.errors import RecordingError

# One number for each step, in the order in which the recorder packs them.
SCALARS: dict[str, tuple[str, str]] = {
    "index": ("1", "k, the number of the step, from 0"),
    "time": ("s", "end of the step on the user's monotonic clock"),
    "period": ("s", "length of the step"),
    "supplied": ("J", "work done at the ports"),
    "body_loss": ("J", "dissipated by the body's own dampers"),
    "local_loss": ("J", "dissipated by the damping B_i of the synchronisation"),
    "extra_loss": ("J", "dissipated by the extra damping B_e"),
    "kinetic": ("J", "kinetic energy after the step"),
    "elastic": ("J", "elastic energy after the step"),
    "drive_work": ("J", "work done on the proxies by what pulls them"),
    "touch_work": ("J", "work done on the body by contacts and grasps"),
    "touch_loss": ("J", "dissipated in contacts and grasps"),
    "proxy": ("J", "kinetic energy of the proxies after the step"),
    "touch_stored": ("J", "energy in contacts and grasps after the step"),
    "residual": ("J", "energy that the step's ledger does not explain"),
    "iterations": ("1", "of the solver"),
    "closure": (
        "J",
        "work of the velocity correction that closed the step of a body with a material; in no other column",
    ),
    "closure_factor": ("1", "relative change of the velocity by it, |beta - 1|"),
    "shortened": ("1", "fraction of the step that was given up to close it"),
    "world_loss": ("J", "of body_loss: dissipated in friction and damping at obstacles and between bodies"),
    "world_stored": ("J", "of elastic: held by obstacles and between bodies after the step"),
    "cut": ("J", "lost after the step with the elements that were cut then"),
}
CLOSING = "closing"
JAMMED = "jammed"
# More than one number for each step: unit, meaning, extents after the first.
VECTORS: dict[str, tuple[str, str, str]] = {
    "force": ("N", "mean force of the step at every port", "ports, axes"),
    CLOSING: (
        "1, m/s",
        "of several bodies: factor on the velocity of each, and the velocity about which it acted",
        "bodies, 4",
    ),
    JAMMED: (
        "m/s",
        "velocity about which bodies, then tools, lost half of their motion after the step, as a tool jammed; else NaN",
        "bodies + tools, 3",
    ),
    "link_work": ("J", "work that each link did on the copy", "links"),
    "age": ("s", "of each link's sample at the end of the step, by uncorrected clocks", "links"),
    "used": (
        "1",
        "index of each link's sample; -1 before the first, -2 mixed from several, -3 not given",
        "links",
    ),
    "link_state": ("1", "of each link's end: 0 guarded, 1 ready, 2 coupled", "links"),
    "tool_position": ("m", "position of every proxy after the step", "tools, 3"),
    "tool_velocity": ("m/s", "velocity of every proxy after the step", "tools, 3"),
    "drive_force": ("N", "mean force of what pulls each proxy", "tools, 3"),
    "touch_force": ("N", "mean force of contacts or grasp on each proxy", "tools, 3"),
}
# Every m-th step only; `state_row` says which steps of the batch these are.
STATES: dict[str, tuple[str, str, str]] = {
    "state_row": ("1", "row of the batch that the state belongs to", ""),
    "position": ("m", "position after the step, from rest, in the rows of the model", "rows, axes"),
    "velocity": ("m/s", "velocity after the step", "rows, axes"),
    "middle": ("m", "position at mid-step: the sample sent to the neighbours", "rows, axes"),
}
# Extra columns of links with a guard that an audit knows (`cotouch.peer.GuardLedger`); all but two are sums so far.
GUARDS: dict[str, tuple[str, str]] = {
    "tank": ("J", "energy in the tank of each link after the step"),
    "potential": ("J", "energy in the spring of each link at the start of the step"),
    "credited": ("J", "dissipated energy that went to the tank of each link"),
    "taken": ("J", "what the tank of each link got from the other end and from the copy's other links"),
    "given": ("J", "what the tank of each link gave to these"),
    "paid": ("J", "what the tank of each link paid for moving the spring's end, and for rounding"),
    "discarded": ("J", "what the tank of each link could not hold or keep"),
    "injected": ("J", "what moving its end put into the spring of each link"),
}
# Likewise; of these, what went over the link.
EXCHANGE: dict[str, tuple[str, str]] = {
    "sent": ("J", "what the tank of each link gave to the other end"),
    "received": ("J", "what the tank of each link got from the other end"),
}
# One number for each step, of a session: what its links' tanks got of what a newcomer may have to come to the others.
ADVANCED = "advanced"
# Likewise, of links with a perceptual codec: how the step's sample was said to the neighbour; see `cotouch.peer`.
SAID = "said"
HOW_SAID = (
    "1",
    "how the step was sent to each neighbour: 0 in full, 255 rounded, 1 to 254 as continued for so many steps, -1 not",
)
UNSAID = -3
_TYPES = ("<f8", "<f4", "<i8", "<i4", "|i1")
_LENGTH = struct.Struct("<I")
_MOST_COLUMNS = 1000


class Batch(NamedTuple):
    """Some steps in a row.

    Attributes:
        neighbours: users at the other ends of the links, in the order of the columns' entries.
        columns: by name; the first extent is the number of steps, for `STATES` that of the states.
    """

    neighbours: tuple[int, ...]
    columns: dict[str, Array]


def pack(batch: Batch) -> bytes:
    """A batch as bytes."""
    arrays = {
        name: np.ascontiguousarray(values, dtype=values.dtype.newbyteorder("<"))
        for name, values in batch.columns.items()
    }
    heading = {
        "neighbours": list(batch.neighbours),
        "columns": [[name, values.dtype.str, list(values.shape)] for name, values in arrays.items()],
    }
    text = json.dumps(heading, separators=(",", ":")).encode()
    text += b" " * (-(len(text) + _LENGTH.size) % 8)
    return b"".join([_LENGTH.pack(len(text)), text, *(values.tobytes() for values in arrays.values())])


def unpack(data: bytes) -> Batch:
    """The inverse of `pack`; believes nothing that the bytes say about themselves.

    Raises:
        RecordingError: they are not a batch.
    """
    try:
        (length,) = _LENGTH.unpack_from(data)
        heading = json.loads(data[_LENGTH.size : _LENGTH.size + length])
        neighbours = tuple(int(user) for user in heading["neighbours"])
        described = [(str(name), str(kind), tuple(map(int, shape))) for name, kind, shape in heading["columns"]]
    except (struct.error, ValueError, KeyError, TypeError) as error:
        raise RecordingError(f"a batch of {len(data)} bytes has no readable header: {error}") from None
    if len(described) > _MOST_COLUMNS:
        raise RecordingError(f"a batch says it has {len(described)} columns; at most {_MOST_COLUMNS} are read")
    columns: dict[str, Array] = {}
    offset = _LENGTH.size + length
    for name, kind, shape in described:
        if kind not in _TYPES or not shape or min(shape) < 0:
            raise RecordingError(f"column {name!r} of a batch has type {kind} and shape {shape}; types are {_TYPES}")
        size = math.prod(shape) * np.dtype(kind).itemsize
        if offset + size > len(data):
            raise RecordingError(f"column {name!r} of a batch takes {size} bytes, more than remain")
        columns[name] = np.frombuffer(data, kind, math.prod(shape), offset).reshape(shape)
        offset += size
    steps = {
        values.shape[0] for name, values in columns.items() if name not in STATES
    }  # extra columns have a row for every step as well
    states = {values.shape[0] for name, values in columns.items() if name in STATES}
    if len(steps) > 1 or len(states) > 1 or not {"index", "time", "period"} <= set(columns):
        raise RecordingError("the columns of a batch have different lengths, or it has no index, time and period")
    links = [columns[name] for name in ("link_work", "age", "used", "link_state", SAID, *GUARDS) if name in columns]
    if any(values.ndim != 2 or values.shape[1] != len(neighbours) for values in links):
        raise RecordingError(f"a batch has {len(neighbours)} links, but columns of another width")
    rows = columns.get("state_row", np.zeros(0))
    if rows.size and not (rows.min() >= 0 and rows.max() < columns["time"].size and np.all(np.diff(rows) > 0)):
        raise RecordingError("the states of a batch belong to steps that it does not have")
    return Batch(neighbours, columns)


def description(extra: dict[str, tuple[str, str]]) -> bytes:
    """The schema of the channel of steps: what a batch is, and unit and meaning of every column, as JSON."""
    columns = {
        **{name: {"unit": unit, "meaning": meaning} for name, (unit, meaning) in SCALARS.items()},
        **{
            name: {"unit": unit, "meaning": meaning, "extents": extents}
            for name, (unit, meaning, extents) in (VECTORS | STATES).items()
        },
        **{name: {"unit": unit, "meaning": meaning} for name, (unit, meaning) in extra.items()},
    }
    return json.dumps({"encoding": (__doc__ or "").strip(), "columns": columns}, indent=1).encode()
