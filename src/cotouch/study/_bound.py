"""What happens below the damping bound: first hands can get energy out, then held copies diverge, then free ones."""

from dataclasses import dataclass
from typing import TYPE_CHECKING, final

import numpy as np
from scipy import optimize

from cotouch.arrays import Float
from cotouch.network import Network, exact_scaling, rightmost_root, rule_damping
from cotouch.simulation import simulate
from cotouch.study._attack import CORNERS, Attack, worst_force
from cotouch.study._data import free
from cotouch.study._experiment import dominant_root

if TYPE_CHECKING:
    import xarray as xr


_SCALES = np.geomspace(0.08, 1.5, 36)
_DURATION = 20.0
# Where what grows has left all else behind [s].
_LATE = (10.0, 19.0)
# Above the critical scale, so that the copies alone come to rest; below it, so that they don't.
_BETWEEN = 1.3
_BELOW = 0.7
# Passive hands that make the best network of the paper's five users diverge where it is stable alone: springs of
# 100 N/m, damped by nothing, at every other user. Found by trying all sets of users with five stiffnesses.
_HELD = (1, 3, 5)
_HAND = 100.0
# Shares of the damping that the exact test asks for, down to half the rule.
_ATTACKED = (("rule", 1.0), ("exact", 1.0), ("exact", 0.9), ("rule", 0.5))


@final
@dataclass(frozen=True, kw_only=True, eq=False)
class Bound:
    """Thresholds as shares of the rule's damping, and runs on either side.

    Attributes:
        exact: the exact test's: below, some hands get energy out.
        critical: where the rightmost root of the free closed loop crosses zero.
        frequency: of that root [rad/s].
        scales: shares at which the roots were looked at.
        rates: real part of the rightmost root there, by network [1/s].
        runs: by name: "rule", "alone" and "held" (both at the scale `between`), "below".
        fractions: damping of each run as a share of the rule's.
        growth: rate of the slowest mode of each run, read from its positions or, where hands hold, its energy [1/s].
        roots: what the rightmost root says of the runs that nobody holds [1/s].
        attacks: by method and share of that method's damping, what the worst hands get out.
        held: users who hold in the run "held", numbered from 1.
        hand: stiffness of their hands [N/m].
    """

    exact: float
    critical: float
    frequency: float
    scales: Float
    rates: dict[str, Float]
    runs: "dict[str, xr.Dataset]"
    fractions: dict[str, float]
    growth: dict[str, float]
    roots: dict[str, float]
    attacks: dict[tuple[str, float], Attack]
    held: tuple[int, ...]
    hand: float

    @property
    def as_expected(self) -> bool:
        """Stable by the rule; between the thresholds stable alone and not in hands; below them not at all."""
        stable = self.growth["rule"] < 0.0 and self.growth["alone"] < 0.0
        least = {key: attack.least for key, attack in self.attacks.items()}
        passive = all((value >= 0.0) == (fraction >= 1.0) for (_, fraction), value in least.items())
        return stable and self.growth["held"] > 0.0 and self.growth["below"] > 0.0 and passive

    def numbers(self) -> dict[str, object]:
        """For JSON."""
        return {
            "exact_scale": self.exact,
            "critical_scale": self.critical,
            "critical_frequency_rad_s": self.frequency,
            "growth_1_s": {
                name: {"fraction": self.fractions[name], "rate": rate} for name, rate in self.growth.items()
            },
            "growth_predicted_1_s": self.roots,
            "worst_force_j": {f"{fraction:g} x {method}": a.least for (method, fraction), a in self.attacks.items()},
            "as_expected": self.as_expected,
        }


def bound(best: Network, worst: Network, *, period: float, corners: int = CORNERS) -> Bound:
    """Goes below the bound on the best network; roots of the worst one beside it.

    Args:
        best: the best choice of links.
        worst: the worst choice.
        period: length of the steps [s].
        corners: of the worst force; see `worst_force`.
    """
    rule = rule_damping(best, index_delay=best.index_delays(period), periods=period)
    networks = {"best": best, "worst": worst}
    critical = critical_scale(best)
    fractions = {"rule": 1.0, "alone": _BETWEEN * critical, "held": _BETWEEN * critical, "below": _BELOW * critical}
    hands = [{"user": user, "path": 0.0, "stiffness": _HAND} for user in _HELD]
    runs = {
        name: simulate(
            free(
                best, duration=_DURATION, period=period, damping_scale=fraction, hands=hands if name == "held" else None
            )
        )
        for name, fraction in fractions.items()
    }
    return Bound(
        exact=exact_scaling(best, index_delay=best.index_delays(period), period=period, damping=rule),
        critical=critical,
        frequency=abs(rightmost_root(best, sync_damping=critical * _delay_damping(best)).root.imag),
        scales=_SCALES,
        rates={name: _rates(network, _SCALES) for name, network in networks.items()},
        runs=runs,
        fractions=fractions,
        growth={name: _growth(run) if name == "held" else _slowest(run) for name, run in runs.items()},
        roots={
            name: rightmost_root(best, sync_damping=fraction * _delay_damping(best)).rate
            for name, fraction in fractions.items()
            if name != "held"
        },
        attacks={
            (method, fraction): worst_force(
                best, period=max(period, 5e-3), corners=corners, damping=method, damping_scale=fraction
            )
            for method, fraction in _ATTACKED
        },
        held=_HELD,
        hand=_HAND,
    )


def critical_scale(network: Network) -> float:
    """Largest share of the rule's damping at which the free closed loop does not come to rest."""
    rule = _delay_damping(network)

    def rate(scale: float) -> float:
        return rightmost_root(network, sync_damping=scale * rule).rate

    low = 1.0
    while rate(low) < 0.0 and low > 1e-3:
        low /= 1.5
    return float(optimize.brentq(rate, low, 1.5 * low, xtol=1e-9))


def _delay_damping(network: Network) -> Float:
    """The rule's B_i with the delays as ages [Ns/m]."""
    return rule_damping(network)[:, 0]


def _rates(network: Network, scales: Float) -> Float:
    rule = _delay_damping(network)
    return np.array([rightmost_root(network, sync_damping=scale * rule).rate for scale in scales])


def _slowest(run: "xr.Dataset") -> float:
    """Rate of the slowest mode, by linear prediction [1/s]."""
    energy = run["stored"].values
    return (dominant_root(run) if energy[-1] < energy[0] else dominant_root(run, _LATE)).real


def _growth(run: "xr.Dataset") -> float:
    """Rate of growth of the amplitude, from the peaks of the energy [1/s]."""
    time, energy = run["tick_time"].values, run["stored"].values
    end = float(time[-1])
    # A decay reaches round-off, which says nothing, so it is read early; growth is read late, when one mode has won.
    early, late = (0.2, 0.4) if energy[-1] < energy[0] else (0.6, 0.9)
    before, after = (
        energy[(time > fraction * end) & (time <= (fraction + 0.1) * end)].max() for fraction in (early, late)
    )
    return float(np.log(after / before) / 2.0 / ((late - early) * end))
