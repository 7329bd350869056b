"""What is wrong with a scenario, as one sentence."""

from collections.abc import Generator, Mapping
from contextlib import contextmanager
from typing import cast

from pydantic import ValidationError

from cotouch.errors import InputError, ScenarioError
from cotouch.scenario import (
    _bodies_table,
    _body_tables,
    _channel,
    _rigid_tool_table,
    _tables,
    _tool_tables,
    _traces,
    _world_table,
)

# How pydantic says what would be right.
_SHOULD = "Input should be "


@contextmanager
def refusing(source: str, kind: type[InputError] = ScenarioError) -> Generator[None]:
    """Says in one sentence what the validation of a table finds wrong meanwhile.

    Args:
        source: what is read.
        kind: of the error.
    """
    try:
        yield
    except ValidationError as error:
        raise kind(sentence(error, source)) from None


def sentence(error: ValidationError, source: str) -> str:
    """The first problem of a validation as one sentence: where, what value, what would be right.

    Args:
        error: of pydantic.
        source: what was read.
    """
    problems = error.errors()
    first = problems[0]
    place = _place(first["loc"])
    value = repr(first["input"])
    value = value if len(value) <= 60 else value[:57] + "..."
    message = first["msg"].removeprefix("Value error, ")
    match first["type"]:
        case "extra_forbidden":
            text = f"{place} is not an option that cotouch knows; remove it or correct its name"
        case "missing":
            text = f"{place} is missing"
        case "union_tag_invalid" | "union_tag_not_found" if isinstance(first["input"], list):
            text = f"{place} is a list; it must be one table, [{place}]; several bodies are [[bodies]]"
        case "union_tag_invalid" | "union_tag_not_found":
            given = first["input"]
            kind = cast("Mapping[str, object]", given).get("kind") if isinstance(given, Mapping) else given
            known = ", ".join(f'"{name}"' for name in _body_tables.KINDS[:-1])
            text = f'{place}.kind is {kind!r}; it must be {known} or "{_body_tables.KINDS[-1]}"'
        case "is_instance_of" | "model_type" | "model_attributes_type":
            text = f"{place} is {value}; it must be a table"
        case "int_parsing_size":
            text = f"{place} is {value}; it must be a smaller number"
        case "too_short" | "too_long":
            bound = first.get("ctx", {})
            text = f"{place} is {value}; it must have {_count(bound)}"
        case "value_error":
            # A message that starts with an option's name goes on where the place of its table ends.
            joint = "." if message.split(maxsplit=1)[0].split(".")[0] in _OPTIONS else ": "
            text = f"{place}{joint}{message}" if place else message
        case _ if message.startswith(_SHOULD):
            wanted = message.removeprefix(_SHOULD).replace("a valid i", "an i").replace("a valid ", "a ")
            text = f"{place} is {value}; it must be {wanted}"
        case _:
            text = f"{place} is {value}: {message[:1].lower()}{message[1:]}"
    more = len({_place(problem["loc"]) for problem in problems}) - 1
    return f"{source}: {text}" + (f" (and {more} more such message{'s' * (more > 1)})" if more else "")


def _count(bound: Mapping[str, object]) -> str:
    """How many entries a list must have, from what pydantic says about it."""
    least, most = bound.get("min_length"), bound.get("max_length")
    number = least if least is not None else most
    return f"{'at least' if least is not None else 'at most'} {number} {'entry' if number == 1 else 'entries'}"


def _place(parts: tuple[int | str, ...]) -> str:
    """Where in the file, as a reader would write it; pydantic's names of types are left out."""
    place = ""
    last = max((depth for depth, part in enumerate(parts) if isinstance(part, str)), default=0)
    for depth, part in enumerate(parts):
        if isinstance(part, int):
            place += f"[{part + 1}]"
        elif (depth == 1 and parts[0] == "body") or (depth in {2, 3} and parts[0] == "bodies" and parts[2] == "body"):
            continue  # which sort of body it was taken for
        elif depth in {3, 4} and parts[0] == "tools" and parts[3] == "solid":
            continue
        elif depth == 0 or part in _OPTIONS or (depth == last and not any(mark in part for mark in "[(-")):
            place += f".{part}" if place else part
    for name in ("float", "int", "str", "bool"):
        place = place.removesuffix(f".{name}")
    return place


def _options() -> frozenset[str]:
    known = [
        value
        for module in (
            _tables,
            _bodies_table,
            _body_tables,
            _channel,
            _rigid_tool_table,
            _tool_tables,
            _traces,
            _world_table,
        )
        for value in vars(module).values()
    ]
    tables = [table for table in known if isinstance(table, type) and issubclass(table, _tables.Table)]
    return frozenset(name for table in tables for name in table.model_fields)


_OPTIONS = _options()
