"""What a parsed file or message holds, by its kind: where types that nobody checked become types."""

from typing import cast


def table_of(value: object) -> dict[str, object] | None:
    """A table, as JSON and TOML have them; None where it is anything else."""
    return cast("dict[str, object]", value) if isinstance(value, dict) else None


def list_of(value: object) -> list[object] | None:
    """A list, as JSON and TOML have them; None where it is anything else."""
    return cast("list[object]", value) if isinstance(value, list) else None
