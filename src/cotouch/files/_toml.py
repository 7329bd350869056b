"""Tables as TOML text; the standard library only reads it."""

from collections.abc import Mapping
from typing import cast


def toml_text(tables: Mapping[str, object]) -> str:
    """TOML of tables, which reading makes the same of; None is left out.

    Args:
        tables: numbers, strings, truth values, lists and mappings of them, by name.
    """
    lines: list[str] = []
    headed: list[str] = []
    for name, value in tables.items():
        if isinstance(value, Mapping):
            headed += ["", f"[{name}]", *_entries(cast("Mapping[str, object]", value))]
        elif (entries := list_of(value)) and all(isinstance(entry, Mapping) for entry in entries):
            for entry in cast("list[Mapping[str, object]]", entries):
                headed += ["", f"[[{name}]]", *_entries(entry)]
        elif value is not None:
            lines.append(f"{name} = {_value(value)}")
    return "\n".join([*lines, *headed]).lstrip("\n") + "\n"


def _entries(table: Mapping[str, object]) -> list[str]:
    return [f"{name} = {_value(value)}" for name, value in table.items() if value is not None]


def _value(value: object) -> str:
    match value:
        case bool():
            return "true" if value else "false"
        case str():
            return '"' + "".join(map(_letter, value)) + '"'
        case int() | float():
            return repr(value)
        case Mapping():
            return "{" + ", ".join(_entries(cast("Mapping[str, object]", value))) + "}"
        case list() | tuple():
            return "[" + ", ".join(map(_value, cast("list[object]", value))) + "]"
        case _:
            raise TypeError(f"{value!r} cannot be written as TOML")


def _letter(letter: str) -> str:
    if letter in '"\\':
        return "\\" + letter
    return letter if letter >= " " and letter != "\x7f" else f"\\u{ord(letter):04x}"


def table_of(value: object) -> dict[str, object] | None:
    """A table, as JSON and TOML have them; None where it is anything else."""
    return cast("dict[str, object]", value) if isinstance(value, dict) else None


def list_of(value: object) -> list[object] | None:
    """A list, as JSON and TOML have them; None where it is anything else."""
    return cast("list[object]", value) if isinstance(value, list) else None
