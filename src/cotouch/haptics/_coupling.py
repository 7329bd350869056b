"""What is said of the coupling between a device and what it moves: beside a device's name, or in a session's file."""

from collections.abc import Mapping
from dataclasses import asdict, dataclass, fields, replace
from math import inf, isfinite
from typing import Any, Final, Literal, final

from cotouch.coupling import checked_toll, encoder_toll, opening_energy
from cotouch.device import DeviceSpec, installed_coupling
from cotouch.errors import DeviceError
from cotouch.haptics._ends import WINDOW, EndOptions, checked
from cotouch.haptics._registry import DeviceChoice, Option
from cotouch.haptics._turning import ARM, at_arm
from cotouch.haptics._virtual import checked_virtual, virtual_limit

Scale = float | Literal["fit"]
# Scales beyond these make a device's tremble a leap of the body, or hide the body behind its encoders.
LEAST_SCALE, MOST_SCALE = 0.01, 100.0
# What a choice may say beside the options of its driver.
COUPLING: Mapping[str, str] = {
    "coupling": "pspm, or virtual for a plain spring and damper where the device's own friction allows it",
    "stiffness": "of the coupling [N/m]",
    "damping": "of the coupling [Ns/m]",
    "friction": "viscous friction that the device itself certainly has; with coupling=virtual [Ns/m]",
    "coulomb": "dry friction that the device itself certainly has; with coupling=virtual [N]",
    "ages": "sum of the ages of the positions that both ends know of each other; with coupling=virtual, 0.01 [s]",
    "weight": "above 1, the device pays more for old positions, below 1 the proxy; with coupling=virtual, 1",
    "scale": "the body moves this many times as far as the device, which feels this many times the force; or fit",
    "tool": "which tool of the user it moves, from 1",
    "turning_stiffness": "of the coupling to a rigid tool's orientation; for a device that renders torques [Nm/rad]",
    "turning_damping": "likewise [Nms/rad]",
}
_PARAMETERS: Final = ("friction", "coulomb", "ages", "weight")
_USUAL: Final = "pspm"
# A handle weighs little: with 1 Nm/rad, one that nobody holds swings with positions that are 10 ms old [Nm/rad].
_TURNING: Final = 0.5
# What is meant for any law.
_ANY_LAW: Final = ("scale", "tool", "turning_stiffness", "turning_damping")


@final
@dataclass(frozen=True, kw_only=True)
class CouplingChoice:
    """What somebody chose for a coupling; None: nothing chosen.

    Attributes:
        law: see `EndOptions`; "pspm" if nothing is said.
        stiffness: 500 N/m, or what the device renders well, what its encoders leave to a tank, or is passive with a
            virtual coupling, if that is less.
        damping: 2 Ns/m, or what the device renders well if that is less; none with a virtual coupling.
        friction: of the device itself, for a virtual coupling; 0 Ns/m.
        coulomb: its dry friction, likewise; 0 N.
        ages: of places, likewise; 0.01 s.
        weight: of the age rule, likewise; 1.
        scale: metres of the body per metre of the device, 0.01 to 100; the device then feels so many times the force,
            so that power is the same at both; "fit": as much as lets its workspace span the body. 1.
        tool: of the user, from 1. The first that no other device of the user has.
        turning_stiffness: of the coupling of turning, which is PSPM whatever the law; 0.5 Nm/rad, or what the device
            renders well if that is less.
        turning_damping: 0.005 Nms/rad, or what the device renders well if that is less.
    """

    law: str | None = None
    stiffness: float | None = None
    damping: float | None = None
    friction: float | None = None
    coulomb: float | None = None
    ages: float | None = None
    weight: float | None = None
    scale: Scale | None = None
    tool: int | None = None
    turning_stiffness: float | None = None
    turning_damping: float | None = None

    def __post_init__(self) -> None:
        """Checks what was said.

        Raises:
            DeviceError: a number is out of range, or has no effect with this law.
        """
        law = installed_coupling(self.law or _USUAL)
        for name in ("stiffness", "damping", "turning_stiffness", "turning_damping", *_PARAMETERS):
            value = getattr(self, name)
            if value is not None and not (isfinite(value) and value >= 0.0):
                raise DeviceError(f"the coupling's {name} is {value:g}; it must be a number of at least 0")
            if value is not None and name in _PARAMETERS and name not in law.parameters:
                raise DeviceError(
                    f"{name} is given, but with coupling={law.name} it has no effect; leave it out, or use "
                    "coupling=virtual"
                )
        if isinstance(self.scale, int | float) and not LEAST_SCALE <= self.scale <= MOST_SCALE:
            raise DeviceError(f"scale is {self.scale:g}; it must be from {LEAST_SCALE:g} to {MOST_SCALE:g}, or fit")
        if self.tool is not None and self.tool < 1:
            raise DeviceError(f"tool is {self.tool}; tools of a user are numbered from 1")

    def over(self, below: "CouplingChoice") -> "CouplingChoice":
        """What was said here, and where nothing was, what was said below.

        Another law takes nothing of the coupling below: its numbers were meant for that one.
        """
        if None not in {self.law, below.law} and self.law != below.law:
            below = replace(_NOTHING, **{name: getattr(below, name) for name in _ANY_LAW})
        said = {field.name: getattr(self, field.name) for field in fields(self)}
        return replace(below, **{name: value for name, value in said.items() if value is not None})

    def options(self, spec: DeviceSpec, *, period: float, force: float) -> EndOptions:
        """The coupling of a device, for both ends.

        Args:
            spec: of the device.
            period: of the servo [s].
            force: largest that the safety chain lets through, at which a virtual coupling saturates [N].

        Raises:
            DeviceError: it does not fit the device.
        """
        usual = EndOptions()
        stiffness = min(usual.stiffness, spec.stiffness)
        law = installed_coupling(self.law or _USUAL)
        pays = "friction" in law.parameters
        said = {name: getattr(self, name) for name in _PARAMETERS}
        damping = 0.0 if pays else min(usual.damping, spec.damping)
        options = usual._replace(
            law=law.name,
            stiffness=stiffness if self.stiffness is None or pays else self.stiffness,
            damping=damping if self.damping is None else self.damping,
            most=force,
            **{name: value for name, value in said.items() if value is not None},
        )
        if not pays:
            return _with_toll(checked(options, spec), spec, lower=self.stiffness is None)
        if self.stiffness is None:
            # Where encoders leave nothing, the sentence is about them, not about a stiffness that nobody gave.
            limits = [virtual_limit(options, period=period, resolution=fine) for fine in (spec.resolution, 0.0)]
            limit = next((limit for limit in limits if limit > 0.0), stiffness)
            options = options._replace(stiffness=min(stiffness, limit))
        else:
            options = options._replace(stiffness=self.stiffness)
        return checked_virtual(checked(options, spec), spec, period=period)

    def turning(self, spec: DeviceSpec, *, period: float, torque: float) -> EndOptions | None:
        """The coupling of turning, for both ends, as for places at the arm; None for a device that renders no torque.

        Args:
            spec: of the device.
            period: of the servo [s].
            torque: largest that the safety chain lets through [Nm].

        Raises:
            DeviceError: it does not fit the device.
        """
        stiffness, damping = self.turning_stiffness, self.turning_damping
        if spec.torque <= 0.0:
            if stiffness is not None or damping is not None:
                raise DeviceError(
                    f"turning_stiffness or turning_damping is given, but {spec.name} renders no torque; leave it out"
                )
            return None
        if stiffness is not None and stiffness > spec.turning_stiffness:
            raise DeviceError(
                f"the coupling's turning_stiffness is {stiffness:g} Nm/rad; {spec.name} renders at most "
                f"{spec.turning_stiffness:g} Nm/rad"
            )
        square, arc = ARM * ARM, at_arm(spec)
        at_the_arm = CouplingChoice(
            stiffness=(min(_TURNING, spec.turning_stiffness) if stiffness is None else stiffness) / square,
            damping=None if damping is None else damping / square,
        )
        try:
            options = at_the_arm.options(arc, period=period, force=torque / ARM)
        except DeviceError as error:
            raise DeviceError(f"of turning, taken as arcs at {1e3 * ARM:g} mm: {error}") from None
        # Nobody turns with more than what the motors may render: the tanks need not begin with more.
        spring, damper = options.stiffness, options.damping
        toll = encoder_toll(stiffness=spring, damping=damper, window=WINDOW, resolution=arc.resolution)
        begun = opening_energy(toll=toll, stiffness=spring, cap=options.cap, force=options.most)
        return options._replace(initial_energy=begun)

    def plain(self) -> dict[str, object]:
        """As JSON has it."""
        return asdict(self)


_NOTHING: Final = CouplingChoice()


def _with_toll(options: EndOptions, spec: DeviceSpec, *, lower: bool) -> EndOptions:
    """A coupling whose tanks pay for the device's encoders, and whose dampers pay for how old places are.

    Args:
        options: of the coupling.
        spec: of the device.
        lower: lower a stiffness that is too much.

    Raises:
        DeviceError: it is too much, or any is.
    """
    # A spring to places of an age a swings like one with a damping of -½ k a; both ends have a damper.
    limit = 4.0 * options.damping / options.ages if options.ages > 0.0 else inf
    if options.stiffness > limit and not lower:
        raise DeviceError(
            f"the coupling's stiffness is {options.stiffness:g} N/m, but with a damping of {options.damping:g} Ns/m "
            f"and positions {1e3 * options.ages:g} ms old it oscillates above {limit:g} N/m; lower it, or state more "
            f"damping"
        )
    fine = spec.resolution
    stiffness, damping = min(options.stiffness, limit), options.damping
    stiffness = checked_toll(stiffness=stiffness, damping=damping, window=WINDOW, resolution=fine, lower=lower)
    toll = encoder_toll(stiffness=stiffness, damping=damping, window=WINDOW, resolution=fine)
    begun = opening_energy(toll=toll, stiffness=stiffness, cap=options.cap)
    return options._replace(stiffness=stiffness, initial_energy=begun)


def coupling_of(choice: DeviceChoice) -> tuple[DeviceChoice, CouplingChoice]:
    """Takes the options of a coupling out of a choice.

    Args:
        choice: such as `haply:coupling=virtual,friction=0.8,scale=3`.

    Returns:
        What is left for the driver, and what was said.

    Raises:
        DeviceError: it is no coupling that there is, no number, out of range, or has no effect with this law.
    """
    options = {key: value for key, value in choice.options.items() if key not in COUPLING}
    said = {key: value for key, value in choice.options.items() if key in COUPLING}
    found: dict[str, Any] = {}
    if (law := said.pop("coupling", None)) is not None:
        found["law"] = installed_coupling(str(law)).name
    for name, value in said.items():
        found[name] = _said(name, value)
    return DeviceChoice(choice.name, options), CouplingChoice(**found)


def _said(name: str, value: Option) -> float | int | str:
    if name == "scale" and value == "fit":
        return value
    number = isinstance(value, int | float) and not isinstance(value, bool) and isfinite(value)
    if name == "tool":
        if not isinstance(value, int) or isinstance(value, bool):
            raise DeviceError(f"tool is {value}; tools of a user are numbered from 1")
        return value
    if name == "scale" and not number:
        raise DeviceError(f"scale is {value}; it must be from {LEAST_SCALE:g} to {MOST_SCALE:g}, or fit")
    if not number:
        raise DeviceError(f"the coupling's {name} is {value}; it must be a number of at least 0")
    return float(value)
