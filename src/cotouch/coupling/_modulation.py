"""What joins a device to its proxy without making energy: passive set-position modulation, virtual coupling.

**Passive set-position modulation** (PSPM) [Lee & Huang 2010] holds a spring from a place q (the device's tip, or on the
other side the proxy) to a *set position* ȳ and moves ȳ towards the desired position y only as far as there is energy
for it. Both sides do this with `modulate`; they differ only in how they know what energy there is:

* *Device side, sampled.* A force F_k held between two servo ticks does exactly the work F_k·(q_{k+1} - q_k), whatever
  the device did in between. With the spring's energy S_k = ½k‖q_k - ȳ_k‖² and the tank E_k after tick k, what is there
  at tick k + 1 is

      R = S_k + E_k - F_k·(q_{k+1} - q_k) + (what the other side sent) - (charge of the encoder) + (declared damping)

  F holds the injected damping too, so its work is in the same product. As the servo gets quicker, R becomes the formula
  of the continuous spring, `½k‖q - ȳ_old‖² + E + ΔE_in + D`.
* *Proxy side, implicit.* The step's own spring does exactly the work of its energy, so R = ½k‖q̄ - y⁺‖² + E + b‖ŵ‖²T +
  (what the device side sent).

A tick may have taken more than there was: R < 0 is a debt, the spring is off until it is repaid, and no force at all
acts while the debt exceeds the reserve. `modulation_bound` says how deep it can get; that is the d² of two-port
passivity.

**Energy between the sides** travels as the total sent since the start. A message that is lost, repeated or overtaken
then changes nothing but how soon the energy arrives: `credit`.
"""

from math import inf, isfinite

from cotouch.errors import DeviceError
from cotouch.kernels import kernel


@kernel
def modulate(potential: float, available: float, cap: float) -> tuple[float, float, float]:
    """How far the set position may move from the place towards the desired position: `ȳ = q + fraction (y - q)`.

    Args:
        potential: P = ½k‖q - y‖², the spring's energy if the desired position came true; infinite or NaN: the desired
            position is ignored [J].
        available: R, the energy that there is [J]; negative: a debt.
        cap: Ē, what the tank keeps at most [J].

    Returns:
        The share in [0, 1], the tank E afterwards (negative: the debt), what goes to the other side [J]. The energy of
        the spring is then share² P, and share² P + E + sent = R.
    """
    if not available > 0.0:
        return 0.0, available, 0.0
    if not potential < inf:
        return 0.0, available, 0.0
    if potential > available:
        return (available / potential) ** 0.5, 0.0, 0.0
    rest = available - potential
    sent = max(rest - cap, 0.0)
    return 1.0, rest - sent, sent


@kernel
def credit(total: float, seen: float) -> float:
    """What a message adds that says "`total` joules in all"; `seen` is the largest total known so far [J].

    Args:
        total: that the message says [J].
        seen: the largest so far [J].
    """
    return total - seen if total > seen else 0.0


def modulation_bound(
    *,
    stiffness: float,
    damping: float,
    period: float,
    speed: float,
    reserve: float = 0.0,
    force: float = 0.0,
    resolution: float = 0.0,
    axes: int = 1,
) -> float:
    """The most energy that the device side of PSPM can ever have given away beyond what it was given [J].

    From R >= 0 one tick takes at most `(k s + b‖v̂‖)‖Δq‖ - ½k s² <= ½k‖Δq‖² + b‖v̂‖‖Δq‖`, for any stretch s. A debt
    that is within the reserve can grow by the damping force alone, a deeper one not at all. With a quantised encoder,
    summation by parts adds ½ resolution per axis for each change of the force, charged at the tick after it: at worst
    the change that led into debt (twice the force) and the one that switched the force off, or its last value.

    Args:
        stiffness: k, >= 0 [N/m].
        damping: b, >= 0 [Ns/m].
        period: longest servo period, > 0 [s].
        speed: highest speed of the tip as measured, >= 0 [m/s]; of a device with joints, of J(θ) Δθ from tick to tick.
        reserve: debt up to which the damping force stays on, >= 0 [J].
        force: highest force, >= 0 [N]; matters with a resolution.
        resolution: of the encoder, >= 0 [m].
        axes: measured axes.
    """
    spring = 0.5 * stiffness * (speed * period) ** 2
    return max(spring, reserve) + damping * speed**2 * period + 1.5 * resolution * force * axes**0.5


def unseen_place(resolution: float) -> float:
    """Farthest that a tip may be from where the encoders of its three axes have it: half a step on each [m].

    Args:
        resolution: of each axis, >= 0 [m].
    """
    return 0.5 * 3.0**0.5 * resolution


def virtual_coupling_limit(
    *,
    device_damping: float,
    period: float,
    damping: float = 0.0,
    ages: float = 0.0,
    weight: float = 1.0,
    spread: float = 1.0,
    unseen: float = 0.0,
    dry: float = 0.0,
    shortest: float | None = None,
) -> float:
    """The stiffest spring-damper to the proxy that stays passive behind a sampled servo [N/m]; negative: none does.

    With the force `-[k (q_k - y⁺) + b (v_k - ŵ)]` held over a period T on the device, and its opposite acting on the
    proxy in the body's step over the same time, the coupling makes at most `½k(‖Δq‖² - ‖Δy‖²) + b‖Δq‖²/T` in a period
    [after Colgate & Schenkel 1997]. The device's own damping pays if it is at least `½k T + ½b (1 + spread)`. Where
    device and body have clocks of their own, each end has its own damper and the spring's samples have ages, which the
    age rule adds as `½k ages · weight`; the proxy then needs `½k ages / weight` of its own.

    An encoder shifts the place by up to `unseen` and the velocity by up to `2 unseen / T`, hence the force by up to
    `(k + 2b/T) unseen`. What that does on the device its dry friction pays for, if it is no less; with one axis, b = 0
    and steps of Δ in the encoder this is `k <= 2 dry / Δ` [Abbott & Okamura 2005; Diolaiti et al. 2006]. What it does
    on the proxy nobody pays for: at most `(k + 2b/T) unseen` times the proxy's path.

    Args:
        device_damping: the device's physical viscous damping, >= 0 [Ns/m].
        period: longest servo period, > 0 [s].
        damping: b, >= 0 [Ns/m].
        ages: largest age of the proxy's position at the device, plus that of the device's at the proxy, each at the end
            of its use, >= 0 [s]; 0 if the body's step tells the force.
        weight: d of the age rule, > 0.
        spread: longest period beside the one before it, >= 1.
        unseen: farthest that the tip may be from where the encoders have it, >= 0 [m].
        dry: the device's physical Coulomb friction, >= 0 [N]; matters with `unseen`.
        shortest: servo period, > 0 [s]; None: as the longest.

    Raises:
        DeviceError: an argument is out of range.
    """
    shortest = period if shortest is None else shortest
    for name, value, least, strict in (
        ("device_damping", device_damping, 0.0, False),
        ("period", period, 0.0, True),
        ("damping", damping, 0.0, False),
        ("ages", ages, 0.0, False),
        ("weight", weight, 0.0, True),
        ("spread", spread, 1.0, False),
        ("unseen", unseen, 0.0, False),
        ("dry", dry, 0.0, False),
        ("shortest", shortest, 0.0, True),
    ):
        if not (isfinite(value) and (value > least if strict else value >= least)):
            raise DeviceError(
                f"{name} is {value:g}; it must be finite and {'above' if strict else 'at least'} {least:g}"
            )
    sampled = (device_damping - 0.5 * damping * (1.0 + spread)) / (0.5 * period + 0.5 * ages * weight)
    return sampled if unseen == 0.0 else min(sampled, dry / unseen - 2.0 * damping / shortest)


def checked_virtual_coupling(
    *,
    stiffness: float,
    device_damping: float,
    period: float,
    damping: float = 0.0,
    ages: float = 0.0,
    weight: float = 1.0,
    spread: float = 1.0,
    unseen: float = 0.0,
    dry: float = 0.0,
    shortest: float | None = None,
    lower: bool = False,
) -> float:
    """A stiffness that is passive: the given one, or with `lower` the limit if that is less [N/m].

    Args:
        stiffness: k, > 0 [N/m].
        device_damping: as for `virtual_coupling_limit`, like all that follow but the last.
        period: longest servo period [s].
        damping: b [Ns/m].
        ages: sum of the largest ages [s].
        weight: d of the age rule.
        spread: longest period beside the one before it.
        unseen: by the encoders [m].
        dry: Coulomb friction [N].
        shortest: servo period [s].
        lower: take the limit where the stiffness exceeds it.

    Raises:
        DeviceError: the stiffness is above the limit and may not be lowered, or no stiffness is passive.
    """
    if not (isfinite(stiffness) and stiffness > 0.0):
        raise DeviceError(f"the virtual coupling's stiffness is {stiffness:g} N/m; it must be finite and above 0")
    limit = virtual_coupling_limit(
        device_damping=device_damping, period=period, damping=damping, ages=ages, weight=weight, spread=spread
    )
    coarse = virtual_coupling_limit(
        device_damping=device_damping,
        period=period,
        damping=damping,
        ages=ages,
        weight=weight,
        spread=spread,
        unseen=unseen,
        dry=dry,
        shortest=shortest,
    )
    if limit > 0.0 and coarse < limit and not (stiffness <= coarse or (lower and coarse > 0.0)):
        upto = f"is passive up to {coarse:g} N/m; lower it" if coarse > 0.0 else "is passive with none; refine them"
        raise DeviceError(
            f"the virtual coupling's stiffness is {stiffness:g} N/m; a device whose encoders may miss {unseen:.3g} m "
            f"of its place, with {dry:g} N of dry friction to pay for it, {upto} or use PSPM"
        )
    limit = min(limit, coarse)
    if limit <= 0.0:
        raise DeviceError(
            f"the virtual coupling's damping is {damping:g} Ns/m, but the device's own {device_damping:g} Ns/m can pay "
            f"for less than {2.0 * device_damping / (1.0 + spread):g} Ns/m; lower it or use PSPM"
        )
    if stiffness <= limit:
        return stiffness
    if lower:
        return limit
    raise DeviceError(
        f"the virtual coupling's stiffness is {stiffness:g} N/m; a device with {device_damping:g} Ns/m of its own and "
        f"a servo period of {period:g} s is passive up to {limit:g} N/m; lower it or use PSPM"
    )
