"""Device couplings, with those that other installed packages bring; see `cotouch.installed`."""

from collections.abc import Iterable

from cotouch.coupling import DeviceCoupling, device_couplings, register_coupling
from cotouch.errors import DeviceError
from cotouch.installed import installed, installed_names

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
    loaded = installed(GROUP, name, DeviceCoupling, what="coupling", error=DeviceError)
    if loaded is None:
        names = dict.fromkeys([*known, *installed_names(GROUP), *others])
        raise DeviceError(f'{what} is "{name}"; it must be one of {", ".join(names)}')
    if loaded.name != name:
        raise DeviceError(f'the coupling "{name}" calls itself "{loaded.name}"; its entry point must have this name')
    return register_coupling(loaded)
