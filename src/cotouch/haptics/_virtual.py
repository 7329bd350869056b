"""Which virtual couplings are passive on a real device; the law itself is `coupling/_virtual.py`.

What a sampled spring makes has to be paid by friction that is really there
(`cotouch.mechanics.virtual_coupling_limit`). The device pays from its own

    friction  ≥  ½ k · 3T  +  ½ b (1 + spread)  +  ½ k ages · weight

T a tick of the servo: a force is decided on while the one before acts, so it is used until two ticks after its place
was measured, and what that makes is three halves of k T. The velocity is a mean over the window, so a place counts in
it at most `spread = 1 + T / window` times. `ages` is how old the proxy's place may be when the device stops using it,
plus the device's at the proxy; the proxy pays its share with a drag, which is felt. Encoders put the tip up to `unseen`
beside its place and falsify the force by `(k + 2b / window) unseen`; dry friction has to be no less. A stiffness beyond
either is refused. What friction a device has nobody but its owner can say; the default is none, so that none is
assumed.

Whatever is not as it was said, the passivity observer holds the motors' work to what both ends' accounts allow, and
switches them off where it is not kept.
"""

from cotouch.coupling import unseen_place, virtual_coupling_limit
from cotouch.device import DeviceSpec
from cotouch.errors import DeviceError
from cotouch.haptics._ends import WINDOW, EndOptions

# Ticks that a place of the device is held and waited for: a force is decided on while the one before still acts.
_HELD = 3.0


def virtual_limit(options: EndOptions, *, period: float, resolution: float) -> float:
    """The stiffest spring for which a device's own friction pays [N/m]; 0 or negative if there is none.

    Args:
        options: of the coupling, whose stiffness does not matter.
        period: of the servo, > 0 [s].
        resolution: of the tip's place, >= 0 [m].

    Raises:
        DeviceError: a number is out of range.
    """
    return virtual_coupling_limit(
        device_damping=options.friction,
        period=_HELD * period,
        damping=options.damping,
        ages=options.ages,
        weight=options.weight,
        spread=1.0 + period / WINDOW,
        unseen=unseen_place(resolution),
        dry=options.coulomb,
        shortest=WINDOW,
    )


def checked_virtual(options: EndOptions, spec: DeviceSpec, *, period: float) -> EndOptions:
    """Checks that a virtual coupling is passive on a device, and returns it.

    Args:
        options: of the coupling.
        spec: of the device, for messages.
        period: of the servo, > 0 [s].

    Raises:
        DeviceError: the device's own friction cannot pay for it.
    """
    limit = virtual_limit(options, period=period, resolution=0.0)
    coarse = virtual_limit(options, period=period, resolution=spec.resolution)
    if options.friction == 0.0:
        raise DeviceError(
            f"the friction of {spec.name} is 0 Ns/m, and a virtual coupling depends on it; state the real one, as in "
            "friction=0.5, or use coupling=pspm"
        )
    if limit <= 0.0:
        most = 2.0 * options.friction / (2.0 + period / WINDOW)
        raise DeviceError(
            f"the virtual coupling's damping is {options.damping:g} Ns/m; {spec.name} with a friction of "
            f"{options.friction:g} Ns/m pays for less than {most:.3g} Ns/m, so lower it or use coupling=pspm"
        )
    if options.stiffness > limit:
        raise DeviceError(
            f"the virtual coupling's stiffness is {options.stiffness:g} N/m; {spec.name} with a friction of "
            f"{options.friction:g} Ns/m, ticks of {1e3 * period:g} ms and positions {1e3 * options.ages:g} ms old is "
            f"passive up to {limit:.4g} N/m, so lower it or use coupling=pspm"
        )
    if options.stiffness > coarse:
        upto = f"up to {coarse:.4g} N/m" if coarse > 0.0 else "with none"
        raise DeviceError(
            f"the virtual coupling's stiffness is {options.stiffness:g} N/m; {spec.name} knows its position to "
            f"{1e3 * spec.resolution:g} mm and with a dry friction of {options.coulomb:g} N is passive {upto}, so "
            "lower it, state its real dry friction, as in coulomb=0.1, or use coupling=pspm"
        )
    return options
