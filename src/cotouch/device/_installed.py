"""Device couplings, with those that other installed packages bring; see `cotouch.installed`."""

from collections.abc import Iterable
from functools import cache

from cotouch.coupling import DeviceCoupling, conform_coupling, device_couplings, register_coupling
from cotouch.errors import DeviceError
from cotouch.installed import check_own_name, installed, installed_names
from cotouch.kernels import written_here

GROUP = "cotouch.couplings"


def installed_coupling(name: str, *, what: str = "coupling", others: Iterable[str] = ()) -> DeviceCoupling:
    """The coupling of a name: one that is known here, else one of an installed package.

    Args:
        name: of the coupling.
        what: messages call it.
        others: names that are right here besides, for messages.

    Raises:
        DeviceError: there is none of this name, it cannot be loaded, it is no coupling, or it breaks the interface; or
            it is cotouch's own, and a package brings one of the same name.
    """
    known = device_couplings()
    if name in known:
        if written_here(known[name].device):
            check_own_name(GROUP, name, what="coupling", error=DeviceError)
            return known[name]
        return _conforming(known[name])
    loaded = installed(GROUP, name, DeviceCoupling, what="coupling", error=DeviceError)
    if loaded is None:
        names = dict.fromkeys([*known, *installed_names(GROUP), *others])
        raise DeviceError(f'{what} is "{name}"; it must be one of {", ".join(names)}')
    if loaded.name != name:
        raise DeviceError(f'the coupling "{name}" calls itself "{loaded.name}"; its entry point must have this name')
    return register_coupling(_conforming(loaded))


def _conforming(law: DeviceCoupling) -> DeviceCoupling:
    for broken in _broken(law):
        raise DeviceError(f'the coupling "{law.name}" breaks the interface: {broken}')
    return law


@cache
def _broken(law: DeviceCoupling) -> tuple[str, ...]:
    """What it breaks; tried once, as devices ask for their couplings again and again."""
    return tuple(conform_coupling(law))
