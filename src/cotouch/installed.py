"""What other installed packages add, by their entry points: every process finds the same, a member's and a servo's too.

An entry point names an object under the object's own name::

    [project.entry-points."cotouch.laws"]
    ahead = "my_law:AHEAD"

Groups are `cotouch.devices`, `cotouch.laws`, `cotouch.contact_laws`, `cotouch.couplings` and `cotouch.materials`.
"""

import sys
from functools import cache
from importlib.metadata import EntryPoint, entry_points
from typing import TypeVar

from cotouch.errors import InputError

T = TypeVar("T")


def _found(group: str, name: str) -> list[EntryPoint]:
    """Entry points of a name that name different things; of those that name the same, the first package's."""
    found = sorted((entry for entry in entry_points(group=group) if entry.name == name), key=_package, reverse=True)
    return list({entry.value: entry for entry in found}.values())


def _package(entry: EntryPoint) -> str:
    return entry.value if entry.dist is None else entry.dist.name


@cache
def _packages(group: str, name: str, path: tuple[str, ...]) -> tuple[str, ...]:
    """Packages with an entry point of this name, of those on a path; it is asked often and packages do not change."""
    del path
    return tuple(map(_package, _found(group, name)))


def check_own_name(group: str, name: str, *, what: str, error: type[InputError]) -> None:
    """Refuses a package that wants the name of something of cotouch's own, which would be taken instead.

    Args:
        group: of entry points, in which cotouch has none itself.
        name: of what cotouch has.
        what: it is, for messages.
        error: is raised.

    Raises:
        InputError: an installed package has an entry point of this name.
    """
    for package in _packages(group, name, tuple(sys.path)):
        raise error(
            f'the {what} "{name}" is cotouch\'s own, but the package {package} brings one of this name; it must have '
            "another"
        )


def cause_of(error: BaseException) -> str:
    """Why something of others failed, in a line; the kind of the error, if it says no more.

    Args:
        error: of any kind.
    """
    return next((line for line in str(error).splitlines() if line.strip()), type(error).__name__)


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
        InputError: several packages have one, it cannot be loaded, or is something else.
    """
    found = _found(group, name)
    if not found:
        return None
    if len(found) > 1:
        packages = " and ".join(sorted(map(_package, found)))
        raise error(f'the {what} "{name}" is brought by the packages {packages}; uninstall all but one of them')
    try:
        loaded: object = found[0].load()
    except (Exception, SystemExit) as cause:  # a package of others may fail in any way
        raise error(f'the {what} "{name}" cannot be loaded: {cause_of(cause)}') from cause
    if not isinstance(loaded, kind):
        wanted = "class" if kind is type else f"{'.'.join(kind.__module__.split('.')[:2])}.{kind.__name__}"
        raise error(f'the {what} "{name}" is a {type(loaded).__name__}; it must be a {wanted}')
    return loaded
