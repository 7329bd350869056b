"""What a parsed file or message holds, by its kind: where types that nobody checked become types."""

from typing import Any, cast


def table_of(value: object) -> dict[str, Any] | None:
    """A table, as JSON and TOML have them; None where it is anything else."""
    return cast("dict[str, Any]", value) if isinstance(value, dict) else None


def list_of(value: object) -> list[Any] | None:
    """A list, as JSON and TOML have them; None where it is anything else."""
    return cast("list[Any]", value) if isinstance(value, list) else None
