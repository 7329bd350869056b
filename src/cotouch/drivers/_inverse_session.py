"""What we say to the Inverse Service, and how its workspace must be set for that.

A session of the service has a view of its own of every device: axes (basis), where it is mounted and how large its
workspace is (mount, or a preset of it), and a transform on top of that which scenes move about. Haply Hub keeps these
by the profile's name, applies them again by itself, and changes them while we run. With a scale, position times force
is no power in our metres. So we ask for all of them, read them back, and go on looking.
"""

import json
from collections.abc import Iterator, Mapping
from math import isfinite

from cotouch.arrays import Float
from cotouch.files import table_of

PROFILE = "org.cotouch:hand"
# Origin at the device's base, arm in front: what the middle of the workspace is measured from.
_PRESETS = ("defaults", "arm_front")
# "custom" is what a mount that was asked for is called.
_MOUNTED = (*_PRESETS, "custom")
_AXES = "XYZ"
# Rounding of the service [m, share of a rotation, share of a scale].
_SLACK = 1e-4
_IDENTITY = '{"position":{"x":0,"y":0,"z":0},"rotation":{"w":1,"x":0,"y":0,"z":0},"scale":{"x":1,"y":1,"z":1}}'
_PLAIN = {"position": (0.0, 0.0, 0.0), "rotation": (0.0, 0.0, 0.0), "scale": (1.0, 1.0, 1.0)}
_FULL = '"force_render_full_state":{}'
_CONFIGURE = f'"configure":{{"profile":{{"name":"{PROFILE}"}},"basis":{{"permutation":"{_AXES}"}}}}'
# Each by itself, as a preset and a mount in one message are refused.
_PLEAS = {
    "preset": f'"configure":{{"preset":{{"preset":"{_PRESETS[0]}"}}}}',
    "mount": f'"configure":{{"mount":{{"transform":{_IDENTITY}}}}}',
    "transform": f'"commands":{{"set_transform":{{"transform":{_IDENTITY}}}}}',
    "basis": f'"configure":{{"basis":{{"permutation":"{_AXES}"}}}}',
}


def greeting(identity: str | None) -> bytes:
    """The first message, with which a session says who it is and how it wants to see a device.

    Args:
        identity: `device_id` of the device; None: only to be told everything.
    """
    plea = "" if identity is None else f',"inverse3":[{{"device_id":{json.dumps(identity)},{_PLEAS["preset"]}}}]'
    return f'{{"session":{{{_CONFIGURE},{_FULL}}}{plea}}}'.encode()


def asking() -> bytes:
    """Asks to be told everything, and nothing else."""
    return f'{{"session":{{{_FULL}}}}}'.encode()


def plea(identity: str, what: str) -> bytes:
    """Asks for one of the settings that `deviations` names, and to be told everything again.

    Args:
        identity: of the device.
        what: name of the setting.
    """
    return f'{{"session":{{{_FULL}}},"inverse3":[{{"device_id":{json.dumps(identity)},{_PLEAS[what]}}}]}}'.encode()


def command(identity: str, force: Float, *, first: bool = False, full: bool = False) -> bytes:
    """Tells a force.

    Args:
        identity: `device_id` of the device.
        force: in the service's axes [N].
        first: whether it is the first message of the session.
        full: whether to be told everything in return.
    """
    x, y, z = force.tolist()
    parts = [_CONFIGURE] * first + [_FULL] * full
    session = f'"session":{{{",".join(parts)}}},' if parts else ""
    return (
        f'{{{session}"inverse3":[{{"device_id":{json.dumps(identity)},"commands":{{"set_cursor_force":'
        f'{{"values":{{"x":{x:.6g},"y":{y:.6g},"z":{z:.6g}}}}}}}}}]}}'
    ).encode()


def deviations(config: Mapping[str, object], state: Mapping[str, object]) -> dict[str, str]:
    """How a workspace differs from what was asked for: the setting, and what it is, in words.

    Args:
        config: of the device, in a full frame; empty in a lean one.
        state: of the device.
    """
    return dict(_deviations(config, state))


def _deviations(config: Mapping[str, object], state: Mapping[str, object]) -> Iterator[tuple[str, str]]:
    axes = config.get("basis")
    permutation = axes if (table := table_of(axes)) is None else table.get("permutation")
    if permutation is not None and permutation != _AXES:
        yield "basis", f"axes {permutation}"
    mounted = "mount" in config
    preset = config.get("preset")
    preset = preset if (table := table_of(preset)) is None else table.get("preset")
    if preset is not None and preset not in (_MOUNTED if mounted else _PRESETS):
        yield "preset", f'preset "{preset}"'
    if mounted and (how := _unlike(config["mount"])):
        yield "mount", f"mount with {how}"
    if how := _unlike(state.get("transform")):
        yield "transform", f"transform with {how}"


def _unlike(transform: object) -> str:
    """What a transform does to places, in words; empty for nothing. What is left out does nothing."""
    if transform is None:
        return ""
    table = table_of(transform)
    if table is None:
        return "no numbers"
    inner = table_of(table.get("transform"))
    table = table if inner is None else inner
    for name, plain in _PLAIN.items():
        given = table.get(name)
        if given is None:
            continue
        numbers = _numbers(given, plain)
        if not all(abs(value - usual) <= _SLACK for value, usual in zip(numbers, plain, strict=True)):
            said = ", ".join(f"{value:.4g}" for value in numbers)
            return f"{name} ({said})"
    return ""


def _numbers(given: object, plain: tuple[float, ...]) -> list[float]:
    table = table_of(given)
    if table is None:
        return [float("nan")] * len(plain)
    found: list[float] = []
    for axis, usual in zip("xyz", plain, strict=True):
        value = table.get(axis, usual)
        number = float(value) if isinstance(value, int | float) and not isinstance(value, bool) else float("nan")
        found.append(number if isfinite(number) else float("nan"))
    return found
