"""Which devices there are: every installed package can add some, ours do it the same way.

An entry point of the group `cotouch.devices` names a `Driver`::

    [project.entry-points."cotouch.devices"]
    pantograph = "my_package:PANTOGRAPH"

Loading one must be quick and need no vendor's library; `Device.open` is where those are loaded.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from importlib import import_module
from typing import final

from cotouch.device import DeviceSpec
from cotouch.errors import DeviceError
from cotouch.haptics._device import Device, lacks
from cotouch.installed import cause_of, installed, installed_names

GROUP = "cotouch.devices"
Option = str | int | float | bool


def _nothing() -> Sequence[str]:
    """Cannot be said."""
    return ()


@final
@dataclass(frozen=True, kw_only=True)
class Driver:
    """How to reach devices of one kind.

    Attributes:
        name: as in the registry.
        summary: what it is, in one line.
        make: gives a device that is not open yet, from options by keyword; raises `DeviceError` for one that it does
            not know or that is out of range.
        spec: nominal limits, without opening anything.
        variants: what may stand after a colon, as in `simulated:phantom`; it becomes the option `variant`.
        options: name and meaning of the others.
        watchdog: what the device does by itself when the program that drives it dies, in a sentence.
        halt: takes all force away from another process, given the same options, while or after a first one drives the
            device; None where only one process can reach it. It must not block for longer than 50 ms, may be called
            often and does not raise.
        present: says in a few words each which devices seem to be connected; () where that cannot be said.
        tested: against what, in a few words.
    """

    name: str
    summary: str
    make: Callable[..., Device]
    spec: DeviceSpec
    variants: tuple[str, ...] = ()
    options: Mapping[str, str] = field(default_factory=dict[str, str])
    watchdog: str
    halt: Callable[..., None] | None = None
    present: Callable[[], Sequence[str]] = _nothing
    tested: str = ""


@final
@dataclass(frozen=True)
class DeviceChoice:
    """A device as somebody chose it.

    Attributes:
        name: of the driver.
        options: for `Driver.make`.
    """

    name: str
    options: Mapping[str, Option] = field(default_factory=dict[str, Option])

    @classmethod
    def read(cls, text: str) -> "DeviceChoice":
        """Reads `name`, `name:variant` or `name:variant,option=value,...`; the variant may be left out.

        Raises:
            DeviceError: it is none of these.
        """
        name, _, rest = text.partition(":")
        options: dict[str, Option] = {}
        for index, part in enumerate(rest.split(",") if rest else []):
            key, equals, value = part.partition("=")
            key = key.strip()
            if not equals and index == 0 and key:
                options["variant"] = key
            elif equals and key.isidentifier() and key not in options:
                options[key] = _value(value.strip())
            else:
                raise DeviceError(f'device is "{text}"; it must be name, name:variant or name:variant,option=value,...')
        if not name.strip():
            raise DeviceError(f'device is "{text}"; it must begin with the name of a driver')
        return cls(name.strip(), options)


def _value(text: str) -> Option:
    for kind in (int, float):
        try:
            return kind(text)
        except ValueError:
            continue
    return {"true": True, "false": False}.get(text.lower(), text)


def device_names() -> list[str]:
    """Names of all installed drivers, sorted."""
    return installed_names(GROUP)


def driver(name: str) -> Driver:
    """A driver by its name or, during development, by `module/ATTRIBUTE`: `my_package.devices/PANTOGRAPH`.

    Args:
        name: of an entry point in the group `cotouch.devices`, or a place in a module.

    Raises:
        DeviceError: there is none of this name, it cannot be loaded, or it is no driver.
    """
    if "/" not in name:
        found = installed(GROUP, name, Driver, what="driver", error=DeviceError)
        if found is None:
            raise DeviceError(f'device is "{name}"; it must be one of {", ".join(device_names()) or "none: reinstall"}')
        if found.name != name:
            raise DeviceError(f'the driver "{name}" calls itself "{found.name}"; its entry point must have this name')
        return found
    module, _, attribute = name.partition("/")
    try:
        loaded: object = getattr(import_module(module), attribute)
    except (Exception, SystemExit) as error:  # a driver of others may fail in any way
        raise DeviceError(f'the driver "{name}" cannot be loaded: {cause_of(error)}') from error
    if not isinstance(loaded, Driver):
        raise DeviceError(f'the driver "{name}" is a {type(loaded).__name__}; it must be a cotouch.haptics.Driver')
    return loaded


def make_device(name: str, **options: Option) -> Device:
    """A device, not yet open.

    Args:
        name: of its driver.
        options: of the driver.

    Raises:
        DeviceError: there is no such driver, or an option is wrong.
    """
    chosen = driver(name)
    wrong = [key for key in options if key != "variant" and key not in chosen.options]
    if wrong:
        allowed = ", ".join(chosen.options) or "none"
        raise DeviceError(f'the device "{name}" has no option "{wrong[0]}"; its options: {allowed}')
    variant = options.get("variant")
    if variant is not None and variant not in chosen.variants:
        allowed = ", ".join(chosen.variants) or "none"
        raise DeviceError(f'the device "{name}" has no variant "{variant}"; its variants: {allowed}')
    try:
        return chosen.make(**options)
    except DeviceError:
        raise
    except Exception as error:  # a driver of others may fail in any way
        raise DeviceError(
            f'the device "{name}" cannot be made: {cause_of(error)} ({type(error).__name__}); its driver must refuse '
            "options that are wrong with a DeviceError"
        ) from error


def open_device(name: str, **options: Option) -> Device:
    """An open device with its motors off.

    Args:
        name: of its driver.
        options: of the driver.

    Raises:
        DeviceError: there is no such driver, an option is wrong, or the device does not open.
    """
    device = make_device(name, **options)
    missing = lacks(device)
    if missing:
        raise DeviceError(
            f'the device "{name}" has no {", ".join(missing)}; it must have every member of cotouch.haptics.Device'
        )
    try:
        device.open()
    except BaseException:
        device.close()
        raise
    return device
