"""What `SessionApi.do` is asked for, checked: every mistake is a sentence."""

import math
from collections.abc import Mapping, Sequence
from typing import Any, TypeGuard

from cotouch.body import Body
from cotouch.errors import SessionError
from cotouch.members import Pair
from cotouch.observers import HandMode, Pointer

# What a hand can be told in a word, and how that is said.
WORDS: dict[HandMode, str] = {
    "script": "goes on as the session's file says",
    "free": "lets go",
    "hold": "holds still",
    "pull": "pulls there",
    "wander": "wanders",
}
# Most that may be emulated [s].
_LONGEST = 5.0
# A place farther from rest than this is a mistake [m].
_FARTHEST = 1e4


def slot_of(arguments: Mapping[str, Any], own: Sequence[int], name: str = "slot") -> int:
    """A slot among those that can be told something.

    Args:
        arguments: of the request.
        own: slots that may be told.
        name: of the argument.

    Raises:
        SessionError: it is none.
    """
    slot = arguments.get(name)
    if isinstance(slot, bool) or not isinstance(slot, int) or slot not in own:
        raise SessionError(f"{name} is {slot}; it must be one of {', '.join(map(str, own))}")
    return slot


def hand_of(arguments: Mapping[str, Any], body: Body) -> tuple[HandMode, int, tuple[float, float, float] | None]:
    """Mode, node (-1: as it is) and place of an order to a hand.

    Args:
        arguments: of the request.
        body: the shared body.

    Raises:
        SessionError: one of them cannot be.
    """
    mode, node, to = arguments.get("mode"), arguments.get("node"), arguments.get("to")
    if mode not in WORDS:
        raise SessionError(f"mode is {mode!r}; it must be one of {', '.join(WORDS)}")
    if node is None:
        node = -1
    if isinstance(node, bool) or not isinstance(node, int) or not -1 <= node < body.holds:
        raise SessionError(f"node is {node}; it must be from 0 to {body.holds - 1}, or -1 for what is held")
    if to is None and mode == "pull":
        raise SessionError("to is missing; pull needs 3 numbers")
    return mode, node, None if to is None else place_of(to, "to")


def place_of(value: object, name: str) -> tuple[float, float, float]:
    """Three numbers.

    Args:
        value: what was given.
        name: what messages call it.

    Raises:
        SessionError: they are not.
    """
    entries = list(value) if isinstance(value, list | tuple) else []  # pyright: ignore[reportUnknownVariableType, reportUnknownArgumentType]
    if len(entries) != 3 or not all(_finite(entry) for entry in entries):
        raise SessionError(f"{name} is {value}; it must be 3 numbers, each at most {_FARTHEST:g} m")
    x, y, z = (float(entry) for entry in entries)
    return x, y, z


def checked(pointer: Pointer, body: Body) -> Pointer:
    """A pointer that a copy may be handed.

    Args:
        pointer: where the hand is to be.
        body: the shared body.

    Raises:
        SessionError: mode or node are none of a pointer's, or a number is not finite.
    """
    if pointer.mode not in {"grab", "ball", "free"}:
        raise SessionError(f'the pointer\'s mode is "{pointer.mode}"; it must be grab, ball or free')
    if pointer.mode == "grab" and not 0 <= pointer.node < body.holds:
        raise SessionError(f"the pointer's node is {pointer.node}; it must be from 0 to {body.holds - 1}")
    place_of(list(pointer.target), "the pointer's target")
    for name in ("radius", "stiffness"):
        value = getattr(pointer, name)
        if not 0.0 <= value < math.inf:
            raise SessionError(f"the pointer's {name} is {value}; it must be a number of at least 0")
    return pointer


def pair_of(arguments: Mapping[str, Any], users: int) -> Pair:
    """Two slots, `a` and `b`.

    Args:
        arguments: of the request.
        users: how many slots there are.

    Raises:
        SessionError: they are not.
    """
    slots = tuple(range(users))
    a, b = slot_of(arguments, slots, "a"), slot_of(arguments, slots, "b")
    if a == b:
        raise SessionError(f"a and b are both {a}; a path has two ends")
    return a, b


def law_of(arguments: Mapping[str, Any]) -> dict[str, float]:
    """What is named of delay, jitter and loss.

    Raises:
        SessionError: one is out of range, or none is named.
    """
    law: dict[str, float] = {}
    for name, most, unit in (("delay", _LONGEST, " s"), ("jitter", _LONGEST, " s"), ("loss", 1.0, "")):
        value = arguments.get(name)
        if value is None:
            continue
        if not _finite(value) or not 0.0 <= value <= most:
            raise SessionError(f"{name} is {value}; it must be from 0 to {most:g}{unit}")
        law[name] = float(value)
    if not law:
        raise SessionError("nothing is named; name delay, jitter or loss")
    return law


def flag_of(arguments: Mapping[str, Any]) -> bool:
    """`on`.

    Raises:
        SessionError: it is neither true nor false.
    """
    on = arguments.get("on")
    if not isinstance(on, bool):
        raise SessionError(f"on is {on}; it must be true or false")
    return on


def fraction_of(arguments: Mapping[str, Any]) -> float:
    """`fraction` of the damping.

    Raises:
        SessionError: it is not above 0 and at most 1.
    """
    fraction = arguments.get("fraction")
    if not _finite(fraction) or not 0.0 < fraction <= 1.0:
        raise SessionError(f"share is {fraction}; it must be above 0 and at most 1")
    return float(fraction)


def links_of(arguments: Mapping[str, Any], choices: Mapping[str, Sequence[Pair]], users: int) -> list[Pair]:
    """Links by name, or as pairs of slots.

    Args:
        arguments: of the request.
        choices: links by name.
        users: how many slots there are.

    Raises:
        SessionError: there is no such choice, or a pair is none.
    """
    choice, links = arguments.get("choice"), arguments.get("links")
    if choice is not None:
        if choice not in choices:
            known = ", ".join(choices)
            raise SessionError(f"choice is {choice!r}; it must be one of {known}; best and worst take a while to find")
        if not choices[choice]:
            raise SessionError(f"choice is {choice!r}, but no such links were found; choose others")
        return list(choices[choice])
    found: set[Pair] = set()
    for entry in links if isinstance(links, list) else [None]:  # pyright: ignore[reportUnknownVariableType]
        if not isinstance(entry, list | tuple) or len(entry) != 2:  # pyright: ignore[reportUnknownArgumentType]
            raise SessionError(f"links has the entry {entry}; it must be a list of pairs of slots")
        a, b = pair_of({"a": entry[0], "b": entry[1]}, users)
        found.add((min(a, b), max(a, b)))
    return sorted(found)


def _finite(value: object) -> TypeGuard[float]:
    return isinstance(value, int | float) and not isinstance(value, bool) and abs(value) <= _FARTHEST
