"""What of a command depends on the session that carries it out: every mistake is a sentence."""

import math
from collections.abc import Mapping, Sequence

from cotouch.body import Body
from cotouch.errors import SessionError
from cotouch.network import Pair
from cotouch.observers import FARTHEST, MOST_TURN, ChooseLinks, Cut, HandMode, Impair, MoveHand, Pointer

# What a hand can be told in a word, and how that is said.
WORDS: dict[HandMode, str] = {
    "script": "follows the session file's script",
    "free": "lets go",
    "hold": "holds still",
    "pull": "pulls there",
    "wander": "wanders",
    "cut": "cuts there",
    "pose": "leads its tool there",
}


def slot_among(slot: int, own: Sequence[int], name: str = "slot") -> int:
    """A slot, if it is among those that can be told something.

    Args:
        slot: of a command.
        own: slots that may be told.
        name: what messages call it.

    Raises:
        SessionError: it is none of them.
    """
    if slot not in own:
        raise SessionError(f"{name} is {slot}; it must be one of {', '.join(map(str, own))}")
    return slot


def check_hand(command: MoveHand, body: Body, *, cuts: bool) -> None:
    """Sees that there is what a hand is to hold.

    Args:
        command: to a hand.
        body: the shared body.
        cuts: whether its user may cut.

    Raises:
        SessionError: there is not.
    """
    if command.mode == "pose":
        _check_tool(command.node, body, command.slot)
        return
    if command.node >= body.holds:
        raise SessionError(
            f"node is {command.node}; it must be from 0 to {body.holds - 1}, or -1 for the node that is held"
        )
    if command.mode == "cut":
        _check_cuttable(body, cuts)


def _check_tool(node: int, body: Body, slot: int) -> None:
    tools = [part.tool for part in body.tools if part.tool is not None]
    led = sum(tool.owner == slot and bool(tool.grips) for tool in tools)
    if not led:
        raise SessionError("this user has no rigid tool with a hand; the session file says who has one")
    if node >= led:
        raise SessionError(f"node is {node}; with pose it must be from 0 to {led - 1}, or -1 for the first")


def _check_cuttable(body: Body, cuts: bool) -> None:
    if not body.cut_count:
        raise SessionError("the blade cuts nothing here, because the session file has no [cutting] table; add one")
    if not cuts:
        raise SessionError("this user may not cut; cutting.users in the session file says who may")


def checked(pointer: Pointer, body: Body, slot: int, *, cuts: bool) -> Pointer:
    """A pointer that a copy may be handed.

    Args:
        pointer: where the hand is to be.
        body: the shared body.
        slot: of its user.
        cuts: whether its user may cut.

    Raises:
        SessionError: mode or node are none of a pointer's, or a number is not finite.
    """
    if pointer.mode not in {"grab", "ball", "blade", "pose", "free"}:
        raise SessionError(f'the pointer\'s mode is "{pointer.mode}"; it must be grab, ball, blade, pose or free')
    if pointer.mode == "pose":
        _check_tool(pointer.node, body, slot)
    if pointer.mode == "blade":
        _check_cuttable(body, cuts)
    if pointer.mode == "grab" and not 0 <= pointer.node < body.holds:
        raise SessionError(f"the pointer's node is {pointer.node}; it must be from 0 to {body.holds - 1}")
    for name, given, most, unit in (
        ("target", pointer.target, FARTHEST, "m"),
        ("edge", pointer.edge, FARTHEST, "m"),
        ("turn", pointer.turn, MOST_TURN, "rad"),
    ):
        if not all(abs(x) <= most for x in given):
            raise SessionError(f"the pointer's {name} is {given}; it must be 3 numbers, each at most {most:g} {unit}")
    for name, value in (("radius", pointer.radius), ("stiffness", pointer.stiffness)):
        if not 0.0 <= value < math.inf:
            raise SessionError(f"the pointer's {name} is {value}; it must be a number of at least 0")
    return pointer


def ends_of(command: Impair | Cut, users: int) -> Pair:
    """The two users of a path.

    Args:
        command: that names it.
        users: how many slots there are.

    Raises:
        SessionError: there is one of them not.
    """
    return slot_among(command.a, range(users), "a"), slot_among(command.b, range(users), "b")


def links_of(command: ChooseLinks, choices: Mapping[str, Sequence[Pair]], users: int) -> list[Pair]:
    """Links by name, or as pairs of slots.

    Args:
        command: that names them.
        choices: links by name.
        users: how many slots there are.

    Raises:
        SessionError: there is no such choice, or no such slot.
    """
    choice = command.choice
    if choice is None:
        slots = range(users)
        for slot in {slot for pair in command.links or () for slot in pair}:
            slot_among(slot, slots, "a slot of links")
        return sorted({(min(pair), max(pair)) for pair in command.links or ()})
    if choice not in choices:
        known = ", ".join(choices)
        raise SessionError(f"choice is {choice!r}; it must be one of {known}; finding best and worst takes a while")
    if not choices[choice]:
        raise SessionError(f"choice is {choice!r}, but no such links were found; choose others")
    return list(choices[choice])
