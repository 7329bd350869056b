"""What other installed packages add, by their entry points: every process finds the same, a member's and a servo's too.

An entry point names an object under the object's own name::

    [project.entry-points."cotouch.laws"]
    ahead = "my_law:AHEAD"

Groups are `cotouch.devices`, `cotouch.laws`, `cotouch.contact_laws`, `cotouch.couplings` and `cotouch.materials`.
"""

from importlib.metadata import entry_points
from typing import TypeVar

from cotouch.errors import InputError

T = TypeVar("T")


def installed_names(group: str) -> list[str]:
    """Names of all entry points of a group, sorted; nothing is loaded."""
    return sorted({entry.name for entry in entry_points(group=group)})


def installed(group: str, name: str, kind: type[T], *, what: str, error: type[InputError]) -> T | None:
    """What an installed package has of this name; None: none has.

    Args:
        group: of entry points.
        name: of the entry point.
        kind: type that it must have.
        what: it is, for messages.
        error: is raised.

    Raises:
        InputError: it cannot be loaded, or is something else.
    """
    found = next((entry for entry in entry_points(group=group) if entry.name == name), None)
    if found is None:
        return None
    try:
        loaded: object = found.load()
    except Exception as cause:  # a package of others may fail in any way
        raise error(f'the {what} "{name}" cannot be loaded: {cause}') from cause
    if not isinstance(loaded, kind):
        wanted = "class" if kind is type else f"{'.'.join(kind.__module__.split('.')[:2])}.{kind.__name__}"
        raise error(f'the {what} "{name}" is a {type(loaded).__name__}; it must be a {wanted}')
    return loaded
