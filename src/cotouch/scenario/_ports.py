"""From tables of hands to ports."""

import numpy as np
import numpy.typing as npt

from cotouch.arrays import Float, Int
from cotouch.body import Body
from cotouch.errors import ScenarioError
from cotouch.interaction import Hands
from cotouch.mechanics import Model
from cotouch.scenario._tables import HandTable


def ports_of(hands: list[HandTable], users: int, body: Body, ready: Model) -> tuple[Hands, Int]:
    """Ports of all hands, ordered by user, and which ports belong to which hand, (hands, ports per hand).

    Args:
        hands: of the scenario.
        users: how many there are.
        body: that they hold.
        ready: the same for the kernels.

    Raises:
        ScenarioError: a hand names a user or node that is not there, or its path does not fit the body.
    """
    for index, hand in enumerate(hands, start=1):
        if hand.user > users:
            raise ScenarioError(f"hands[{index}].user is {hand.user}; the network has users 1 to {users}")
        if hand.node > body.holds:
            raise ScenarioError(f"hands[{index}].node is {hand.node}; the body has nodes 1 to {body.shared}")
    width = ready.width
    entries: list[tuple[int, int, int, int]] = []  # user, hand, axis (or -1: all), row
    for index, hand in enumerate(hands):
        rows = ready.port_rows(hand.node - 1)
        entries += [(hand.user - 1, index, axis if rows.size > 1 else -1, int(row)) for axis, row in enumerate(rows)]
    entries.sort(key=lambda entry: entry[0])
    count = len(entries)
    owner = np.array([entry[0] for entry in entries], dtype=np.int32)
    row = np.array([entry[3] for entry in entries], dtype=np.int32)
    forced = np.zeros(count, dtype=np.bool_)
    numbers = np.zeros((6, count))  # stiffness, damping, begin, release, frequency, phase
    amplitude = np.zeros((count, width))
    path_first, path_time, path_value = [0], [np.zeros(0)], [np.zeros((0, width))]
    ports = np.zeros((len(hands), len(ready.port_rows(0))), dtype=np.int32)
    filled = np.zeros(len(hands), dtype=np.int64)
    for p, (_, index, axis, _) in enumerate(entries):
        hand = hands[index]
        forced[p] = hand.kind == "force"
        release = np.inf if hand.release is None else hand.release
        stiffness = 0.0 if forced[p] else hand.stiffness
        damping = 0.0 if forced[p] else hand.damping
        numbers[:, p] = stiffness, damping, hand.begin, release, hand.frequency, hand.phase
        times, values = _path(hand, f"hands[{index + 1}].path", body.dimension)
        wave = _vector(hand.amplitude, f"hands[{index + 1}].amplitude", body.dimension)
        pick = slice(None) if axis < 0 else slice(axis, axis + 1)
        used = values[:, pick].shape[1]
        padded = np.zeros((times.size, width))
        padded[:, :used] = values[:, pick]
        amplitude[p, :used] = wave[pick]
        path_time.append(times)
        path_value.append(padded)
        path_first.append(path_first[-1] + times.size)
        ports[index, filled[index]] = p
        filled[index] += 1
    stiffness, damping, begin, release, frequency, phase = (np.ascontiguousarray(line) for line in numbers)
    return (
        Hands(
            first=np.searchsorted(owner, np.arange(users + 1)).astype(np.int32),
            row=row,
            shape=ready.port_shapes(row),
            stiffness=stiffness,
            damping=damping,
            begin=begin,
            release=release,
            forced=forced,
            path_first=np.array(path_first, dtype=np.int32),
            path_time=np.concatenate(path_time),
            path_value=np.ascontiguousarray(np.concatenate(path_value)),
            amplitude=amplitude,
            frequency=frequency,
            phase=phase,
        ),
        ports,
    )


def _path(hand: HandTable, name: str, dimension: int) -> tuple[Float, Float]:
    """Times and places of a path."""
    path = hand.path
    if isinstance(path, list) and path and isinstance(path[0], list):
        rows = [row for row in path if isinstance(row, list)]
        for row in rows:
            if len(row) != 1 + dimension:
                raise ScenarioError(f"{name} has the waypoint {row}; it must be a time and {dimension} numbers")
        table = np.array(rows, dtype=np.float64)
        return np.ascontiguousarray(table[:, 0]), np.ascontiguousarray(table[:, 1:])
    return np.zeros(1), _vector(path, name, dimension)[None, :]


def _vector(value: npt.ArrayLike, name: str, dimension: int) -> Float:
    numbers = np.atleast_1d(np.asarray(value, dtype=np.float64))
    if numbers.shape == (dimension,):
        return numbers
    if not np.any(numbers):
        return np.zeros(dimension)
    raise ScenarioError(f"{name} is {value}; the body has {dimension} axes, so it must be {dimension} numbers")
