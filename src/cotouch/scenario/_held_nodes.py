"""Which node of a body a hand holds."""

import numpy as np

from cotouch.body import Body
from cotouch.errors import ScenarioError
from cotouch.scenario._tables import HandTable


def refuse_axes(index: int, at: list[float] | None, body: Body) -> None:
    """Refuses a place that has not the body's number of axes.

    Args:
        index: of the hand, from 0.
        at: its place.
        body: that it holds.

    Raises:
        ScenarioError: it is so.
    """
    if at is not None and len(at) != body.dimension:
        raise ScenarioError(f"hands[{index + 1}].at is {at}; it must be {body.dimension} coordinates [m]")


def held_node(hand: HandTable, index: int, body: Body) -> int:
    """Number of the node that a hand holds, from 1.

    Args:
        hand: of the scenario.
        index: of the hand, from 0.
        body: that it holds.

    Raises:
        ScenarioError: there is no such node, body or place.
    """
    if hand.body is not None:
        return _node_of_part(hand, index, hand.body, body)
    if hand.at is None:
        if hand.node > body.holds:
            raise ScenarioError(f"hands[{index + 1}].node is {hand.node}; the body has nodes 1 to {body.shared}")
        return hand.node
    refuse_axes(index, hand.at, body)
    return 1 + int(np.argmin(np.linalg.norm(body.held_rest - np.array(hand.at), axis=1)))


def _node_of_part(hand: HandTable, index: int, name: str, body: Body) -> int:
    """Number of the node that a hand holds of one of several bodies."""
    names = [part.name for part in body.parts if part.tool is None]
    if name not in names:
        known = ", ".join(f'"{known}"' for known in names) or "none; leave body out"
        raise ScenarioError(f'hands[{index + 1}].body is "{name}"; there are {known}')
    own = body.held_by(names.index(name))
    if hand.at is None:
        if hand.node > own.size:
            raise ScenarioError(f'hands[{index + 1}].node is {hand.node}; "{name}" has nodes 1 to {own.size}')
        return 1 + int(own[hand.node - 1])
    refuse_axes(index, hand.at, body)
    return 1 + int(own[np.argmin(np.linalg.norm(body.held_rest[own] - np.array(hand.at), axis=1))])
