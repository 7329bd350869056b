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
    each, width = len(ready.port_rows(0)), ready.width
    order = sorted(range(len(hands)), key=lambda index: hands[index].user)
    held = [hands[index] for index in order]
    ports = np.zeros((len(hands), each), dtype=np.int32)
    ports[order] = np.arange(ports.size).reshape(ports.shape)
    path_time, path_value, amplitude = [np.zeros(0)], [np.zeros((0, width))], [np.zeros((0, width))]
    for index, hand in zip(order, held, strict=True):
        times, values = _path(hand, f"hands[{index + 1}].path", body.dimension)
        wave = _vector(hand.amplitude, f"hands[{index + 1}].amplitude", body.dimension)
        for own in np.split(np.vstack([wave, values]), each, axis=1):
            lines = np.pad(own, ((0, 0), (0, width - own.shape[1])))
            amplitude.append(lines[:1])
            path_time.append(times)
            path_value.append(lines[1:])

    def of_ports(numbers: list[float]) -> Float:
        return np.repeat(np.array(numbers, dtype=np.float64), each)

    row = np.concatenate([np.zeros(0, dtype=np.int32), *(ready.port_rows(hand.node - 1) for hand in held)])
    return (
        Hands(
            first=np.searchsorted(of_ports([hand.user for hand in held]), np.arange(1, users + 2)).astype(np.int32),
            row=row,
            shape=ready.port_shapes(row),
            stiffness=of_ports([0.0 if hand.kind == "force" else hand.stiffness for hand in held]),
            damping=of_ports([0.0 if hand.kind == "force" else hand.damping for hand in held]),
            begin=of_ports([hand.begin for hand in held]),
            release=of_ports([np.inf if hand.release is None else hand.release for hand in held]),
            forced=np.repeat(np.array([hand.kind == "force" for hand in held], dtype=np.bool_), each),
            path_first=np.cumsum([line.size for line in path_time]).astype(np.int32),
            path_time=np.concatenate(path_time),
            path_value=np.concatenate(path_value),
            amplitude=np.concatenate(amplitude),
            frequency=of_ports([hand.frequency for hand in held]),
            phase=of_ports([hand.phase for hand in held]),
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
