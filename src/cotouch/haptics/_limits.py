"""What the safety chain holds a device to, and why each number is what it is."""

from dataclasses import dataclass, fields
from math import inf, isfinite
from typing import final

from cotouch.device import DeviceSpec
from cotouch.errors import DeviceError

# Where a vendor says nothing: what a relaxed hand still opposes with ease [N].
UNKNOWN_FORCE = 2.0


@final
@dataclass(frozen=True, kw_only=True)
class SafetyLimits:
    """Thresholds of the safety chain, each of which can only be moved to the safe side; see `of`.

    Attributes:
        force: largest [N]. Half of what the device can do, or 2 N where that is unknown: enough to feel a wall, and a
            fault in what computes it stays below what the hand is used to from this device. At most the device's own.
        rise: shortest time from nothing to the largest force [s]. 10 ms: a contact still feels hard, but a jump of the
            full force becomes a push. At least that.
        ramp: from enabling, or after any removal, to the full force [s]. 0.5 s: longer than it takes to notice and let
            go (0.15 to 0.2 s). At least 0.2 s.
        fade_after: silence of the peer after which its force fades [s]. 20 ms: two steps of a peer at 100 Hz. At most
            that.
        zero_after: silence after which nothing of it is left [s]. 80 ms: whatever fails, force must be gone within
            100 ms, and a loop or a process may have to wait for its turn. At most that.
        speed: above which the motors go off until somebody re-arms them [m/s]. 1.5 m/s: hands on a desk stay below
            1 m/s, and a device that lost its hand does not. At most that.
        radius: of the ball in which the device moves freely; a spring leads back into it [m]. The workspace's: beyond
            it the joints come to their stops. At most that.
        wall: stiffness of that spring [N/m]. Half of what the device renders well. At most all of it.
        continuous: force that may stay [N]: what the vendor allows for long, or half the largest force. At most that.
        heat: time constant of what heats the motors, ∫F² [s]. 10 s: short among windings of small motors. At most that.

    Raises:
        DeviceError: never by itself; `of` checks.
    """

    force: float
    rise: float = 0.01
    ramp: float = 0.5
    fade_after: float = 0.02
    zero_after: float = 0.08
    speed: float = 1.5
    radius: float = inf
    wall: float = 0.0
    continuous: float = inf
    heat: float = 10.0

    @classmethod
    def of(cls, spec: DeviceSpec, **wanted: float) -> "SafetyLimits":
        """Limits for a device.

        Args:
            spec: the device's own limits; what is 0 or not finite in it is unknown.
            wanted: some of the attributes, each only towards the safe side of the default, but `force` and `wall` up to
                the device's own.

        Raises:
            DeviceError: one of them is unknown, no number, or beyond what is safe.
        """
        most = _known(spec.force, UNKNOWN_FORCE)
        default = min(0.5 * most, most) if most == spec.force else UNKNOWN_FORCE
        force = _within("force", wanted.pop("force", default), 0.0, most, "N")
        lasting = min(_known(spec.continuous_force, 0.5 * most), most)
        stiff = _known(spec.stiffness, 0.0)
        radius = _known(spec.workspace, inf)
        ranges = {
            "rise": (0.01, 0.01, inf, "s"),
            "ramp": (0.5, 0.2, inf, "s"),
            "fade_after": (0.02, 1e-3, 0.02, "s"),
            "zero_after": (0.08, 1e-3, 0.08, "s"),
            "speed": (1.5, 1e-3, 1.5, "m/s"),
            "radius": (radius, 0.0, radius, "m"),
            "wall": (0.5 * stiff, 0.0, stiff, "N/m"),
            "continuous": (lasting, 0.0, lasting, "N"),
            "heat": (10.0, 0.1, 10.0, "s"),
        }
        unknown = sorted(set(wanted) - set(ranges))
        if unknown:
            names = ", ".join(field.name for field in fields(cls))
            raise DeviceError(f'there is no safety limit "{unknown[0]}"; safety limits are {names}')
        chosen = {
            name: default if name not in wanted else _within(name, wanted[name], least, largest, unit)
            for name, (default, least, largest, unit) in ranges.items()
        }
        if chosen["zero_after"] < chosen["fade_after"]:
            raise DeviceError(
                f"the safety limit zero_after is {chosen['zero_after']:g} s; it must not be before fade_after, "
                f"{chosen['fade_after']:g} s"
            )
        return cls(force=force, **chosen)


def _known(value: float, otherwise: float) -> float:
    return value if isfinite(value) and value > 0.0 else otherwise


def _within(name: str, value: float, least: float, most: float, unit: str) -> float:
    if isinstance(value, int | float) and isfinite(value) and least <= value <= most:  # pyright: ignore[reportUnnecessaryIsInstance]
        return float(value)
    bounds = f"at least {least:g}" + ("" if most == inf else f" and at most {most:g}")
    raise DeviceError(f"the safety limit {name} is {value} {unit}; for this device it must be {bounds}")
