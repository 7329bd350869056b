"""Tools that are rigid bodies: the bodies among the others, and what holds them.

A pose is held at four points about the handle, alternate corners of a cube, each by a quarter of the spring. With half
its side a the hand has the stiffness k of place, and 2 a² k of turning, the same about every axis.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import final

import numpy as np

from cotouch.arrays import Float, Int
from cotouch.body import SIGNS, Body, Part, Placed, ToolBody, scaled, shares_of, turning
from cotouch.errors import ScenarioError
from cotouch.interaction import Hands
from cotouch.mechanics import Model
from cotouch.scenario._rigid_tool_table import PoseHand, RigidToolTable

# Between waypoints the four points go straight for at most such an angle [rad], so that they keep their distances to
# 4e-5; and a path has at most so many pieces.
# A light tool with a lever would yield as a spring does: its strains swing so many times as fast as of other bodies.
_FIRM = 4.0
# They are solved for at once, together with others that are rigid.
_MOST_RIGID = 12
_STRAIGHT, _MOST = np.radians(1.0), 100_000


@final
@dataclass(frozen=True, kw_only=True, eq=False)
class RigidTool:
    """A tool that is a rigid body.

    Attributes:
        user: whose it is, from 0.
        part: among the bodies.
        handle: where the hand holds it at rest, (3,) [m].
        ports: that hold it, (4,), or (0,) where nothing does; with a device (5,): its handle, and ways from there.
        shares: how much of each of its masses a port's point follows, (ports, 4).
        hand: what moves it; None: nothing does.
    """

    user: int
    part: Part
    handle: Float
    ports: Int
    shares: Float
    hand: PoseHand | None

    @property
    def mass(self) -> float:
        """Of each of its four masses [kg]."""
        assert self.part.tool is not None
        return float(self.part.body.mass.diagonal()[0]) / self.part.tool.copies


def placed_tools(tables: Sequence[RigidToolTable], numbers: Sequence[int], users: int) -> list[Placed]:
    """The bodies of tools, to be put behind the others.

    Args:
        tables: of them.
        numbers: which of [[tools]] each is, from 1.
        users: how many there are.

    Raises:
        ScenarioError: a tool names a user that is not there.
        BodyError: a shape is wrong.
    """
    result: list[Placed] = []
    for number, table in zip(numbers, tables, strict=True):
        if table.user > users:
            raise ScenarioError(f"tools[{number}].user is {table.user}; the network has users 1 to {users}")
        handle = np.asarray(table.at) + np.asarray(table.handle)
        points = np.zeros((0, 3)) if table.hand is None else _points(table.hand, handle)
        grips = tuple((float(x), float(y), float(z)) for x, y, z in points)
        result.append(
            Placed(
                body=scaled(table.build(), mass=users, rate=_FIRM),
                name=f"tools[{number}]",
                at=(table.at[0], table.at[1], table.at[2]),
                turn=(table.turn[0], table.turn[1], table.turn[2]),
                tool=ToolBody(owner=table.user - 1, copies=users, grips=grips),
            )
        )
    return result


def refuse_unfit(body: Body, name: str) -> None:
    """Refuses rigid tools where they cannot be.

    Args:
        body: with them.
        name: of the first of them.

    Raises:
        ScenarioError: it is so.
    """
    rigid = sum(part.body.rigid for part in body.parts)
    if rigid > _MOST_RIGID:
        raise ScenarioError(f"{name} is one of {rigid} rigid bodies; with rigid tools there are at most {_MOST_RIGID}")


def with_tools(
    hands: Hands,
    ports: Int,
    tables: Sequence[RigidToolTable],
    ready: Model,
    user: int | None = None,
    *,
    devices: bool = False,
) -> tuple[Hands, Int, list[RigidTool]]:
    """Ports that hold tools beside those of hands, ordered by user; ports of each hand; and the tools.

    Args:
        hands: without those of tools.
        ports: of each hand, (hands, ports per hand).
        tables: of the tools.
        ready: the body with the tools as its last parts, for the kernels.
        user: whose tools only, from 0; None: those of all.
        devices: whether simulated devices lead the handles of tools that have some; else hands move these themselves.

    Raises:
        ScenarioError: a path turns too far.
    """
    users, old, body = hands.first.size - 1, hands.row.size, ready.body
    owner = np.repeat(np.arange(users), np.diff(hands.first)).tolist()
    columns = [np.stack([hands.stiffness, hands.damping, hands.begin, hands.release, hands.frequency, hands.phase])]
    shapes = [hands.shape]
    held_paths = pairwise(hands.path_first.tolist())
    paths: list[tuple[Float, Float]] = [(hands.path_time[a:b], hands.path_value[a:b]) for a, b in held_paths]
    held: list[Float] = []
    every = zip(tables, body.tools, strict=True)
    both = [(table, part) for table, part in every if user is None or table.user == user + 1]
    handles = [np.asarray(table.at) + np.asarray(table.handle) for table, _ in both]
    for (table, part), handle in zip(both, handles, strict=True):
        held.append(np.zeros((0, 4)))
        if table.hand is None:
            continue
        assert part.tool is not None
        points, own = np.array(part.tool.grips), table.hand
        held[-1] = shares_of(part.rest(), points)
        release = np.inf if own.release is None else own.release
        column = [[own.stiffness / 4.0, own.damping / 4.0, own.begin, release, 0.0, 0.0]] * 4
        led = devices and table.device is not None
        if led:  # the coupling writes what pulls the handle
            middle = held[-1].mean(axis=0)
            held[-1] = np.concatenate([middle[None], held[-1] - middle])
            column = [[0.0, 0.0, 0.0, np.inf, 0.0, 0.0], *column]
            paths.append((np.zeros(1), np.zeros((1, 4))))
        shape = np.zeros((len(column), body.nodes))
        shape[:, rows_of(part, ready)] = held[-1]
        shapes.append(shape)
        columns.append(np.array(column).T)
        owner += [table.user - 1] * len(column)
        paths += _paths(own, points - handle, part.name, goes=not led)
    new = len(owner) - old
    order = np.argsort(owner, kind="stable")
    place = np.argsort(order).astype(np.int32)
    stiffness, damping, begin, release, frequency, phase = (
        np.ascontiguousarray(line[order]) for line in np.concatenate(columns, axis=1)
    )
    paths = [paths[int(p)] for p in order]
    made = Hands(
        first=np.searchsorted(np.array(owner)[order], np.arange(users + 1)).astype(np.int32),
        row=np.concatenate([hands.row, np.zeros(new, dtype=np.int32)])[order],
        shape=np.ascontiguousarray(np.concatenate(shapes)[order]),
        stiffness=stiffness,
        damping=damping,
        begin=begin,
        release=release,
        forced=np.concatenate([hands.forced, np.zeros(new, dtype=np.bool_)])[order],
        path_first=np.cumsum([0, *(time.size for time, _ in paths)]).astype(np.int32),
        path_time=np.concatenate([np.zeros(0), *(time for time, _ in paths)]),
        path_value=np.concatenate([np.zeros((0, hands.path_value.shape[1])), *(value for _, value in paths)]),
        amplitude=np.ascontiguousarray(np.pad(hands.amplitude, ((0, new), (0, 0)))[order]),
        frequency=frequency,
        phase=phase,
    )
    found: list[RigidTool] = []
    for (table, part), handle, shares in zip(both, handles, held, strict=True):
        own = place[old : old + shares.shape[0]]
        old += own.size
        whose = table.user - 1
        found.append(RigidTool(user=whose, part=part, handle=handle, ports=own, shares=shares, hand=table.hand))
    return made, place[ports], found


def rows_of(part: Part, ready: Model) -> Int:
    """Rows of the kernels of one of several bodies.

    Args:
        part: the body.
        ready: all of them.
    """
    nodes = np.arange(part.first, part.last)
    return (nodes if ready.order is None else np.argsort(ready.order)[nodes]).astype(np.int32)


def _points(hand: PoseHand, handle: Float) -> Float:
    """Where a hand holds a tool, (4, 3) [m]."""
    return handle + np.sqrt(hand.turning_stiffness / (2.0 * hand.stiffness)) * SIGNS


def _paths(hand: PoseHand, about: Float, name: str, *, goes: bool) -> list[tuple[Float, Float]]:
    """Times and displacements of the four points; unless it goes, as if it only turned."""
    given = hand.poses()
    turned = np.linalg.norm(np.diff(given[:, 4:], axis=0), axis=1)
    pieces = np.maximum(np.ceil(turned / _STRAIGHT), 1.0)
    if pieces.sum() > _MOST:
        raise ScenarioError(
            f"{name}.hand.path turns by {turned.sum():.3g} rad in total; it must be at most {_MOST // 60}"
        )
    steps = [np.linspace(0.0, 1.0, int(count) + 1)[1:, None] for count in pieces]
    finer = [given[:1], *(a + share * (b - a) for (a, b), share in zip(pairwise(given), steps, strict=True))]
    poses = np.concatenate(finer)
    turns = np.stack([turning(pose) for pose in poses[:, 4:].tolist()])
    result: list[tuple[Float, Float]] = []
    for point in about:
        value = np.zeros((poses.shape[0], 4))
        value[:, :3] = turns @ point - point
        if goes:
            value[:, :3] += poses[:, 1:4]
        result.append((poses[:, 0].copy(), value))
    return result
