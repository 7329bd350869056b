"""Which tables of a scenario name a file."""

from collections.abc import Mapping

from cotouch.files import list_of, table_of


def tables_with_file(tables: Mapping[str, object], *, pictures: bool = True) -> list[tuple[dict[str, object], str]]:
    """The tables that name a file, and the file.

    Args:
        tables: of a scenario, as TOML has them.
        pictures: whether those of textures count.
    """
    inner = [("world", "meshes"), ("channel", "trace")] + [("contact", "texture")] * pictures
    given = [tables.get(name) for name in ("body", "bodies", "tools")]
    given += [(table_of(tables.get(table)) or {}).get(name) for table, name in inner]
    found = [table_of(one) for some in given for one in list_of(some) or [some]]
    return [(table, file) for table in found if table is not None and isinstance((file := table.get("file")), str)]
