"""Device couplings that other installed packages bring: every process finds the same ones, a device's servo too.

An entry point of the group `cotouch.couplings` names a `DeviceCoupling`, under the coupling's own name::

    [project.entry-points."cotouch.couplings"]
    slipping = "my_coupling:SLIPPING"
"""

from collections.abc import Iterable
from importlib.metadata import entry_points

from cotouch.errors import DeviceError
from cotouch.mechanics import DeviceCoupling, device_couplings, register_coupling

GROUP = "cotouch.couplings"


def installed_coupling(name: str, *, what: str = "coupling", others: Iterable[str] = ()) -> DeviceCoupling:
    """The coupling of a name: one that is known here, else one of an installed package.

    Args:
        name: of the coupling.
        what: messages call it.
        others: names that are right here besides, for messages.

    Raises:
        DeviceError: there is none of this name, it cannot be loaded, or it is no coupling.
    """
    known = device_couplings()
    if name in known:
        return known[name]
    entries = {entry.name: entry for entry in entry_points(group=GROUP)}
    if name not in entries:
        names = dict.fromkeys([*known, *sorted(entries), *others])
        raise DeviceError(f'{what} is "{name}"; it must be one of {", ".join(names)}')
    try:
        loaded: object = entries[name].load()
    except Exception as error:  # a package of others may fail in any way
        raise DeviceError(f'the coupling "{name}" cannot be loaded: {error}') from error
    if not isinstance(loaded, DeviceCoupling):
        raise DeviceError(
            f'the coupling "{name}" is a {type(loaded).__name__}; it must be a cotouch.mechanics.DeviceCoupling'
        )
    if loaded.name != name:
        raise DeviceError(f'the coupling "{name}" calls itself "{loaded.name}"; its entry point must have this name')
    return register_coupling(loaded)
