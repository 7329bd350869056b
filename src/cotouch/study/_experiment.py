"""The paper's experiment: five users hold one object at different places, then let go."""

from dataclasses import dataclass
from typing import TYPE_CHECKING, final

import numpy as np

from cotouch.arrays import Float
from cotouch.network import Network, rightmost_root
from cotouch.simulation import Summary, at_times, settling_time, simulate, summary
from cotouch.study._data import free, holding, names

if TYPE_CHECKING:
    import xarray as xr


# Long enough for the slowest choice of links: 2 % of a step are left after four of its time constants.
RELEASE = 20.0
DURATION = 40.0
PERIOD = 1e-3
# A free decay is read where faster modes have died out and round-off is far: from 8 s to 18 s.
_WINDOW = (8.0, 18.0)
_SAMPLING = 0.1
# Of the prediction: as many damped exponentials in everybody's motion, of which several decay nearly as slowly.
_ORDER = 8


@final
@dataclass(frozen=True, kw_only=True, eq=False)
class Trial:
    """One choice of links, held and released.

    Attributes:
        links: "12 14 23".
        run: the held and released run.
        settling: of position and force while held, and of position after the release [s]; None: not settled.
        force_sum: |sum of forces| at the end of the hold [N].
        forces: at the end of the hold, one for each user [N].
        damping: B_i by the rule [Ns/m].
        predicted: rightmost root of the closed loop [1/s].
        measured: the same, read from a free decay of the simulator [1/s].
    """

    links: str
    run: "xr.Dataset"
    settling: dict[str, float | None]
    force_sum: float
    forces: list[float]
    damping: list[float]
    predicted: complex
    measured: complex

    def numbers(self) -> dict[str, object]:
        """For JSON."""
        return {
            "links": self.links,
            "settling_time_s": self.settling,
            "force_sum_n": self.force_sum,
            "force_n": self.forces,
            "damping_ns_m": self.damping,
            "rate_predicted_1_s": self.predicted.real,
            "rate_measured_1_s": self.measured.real,
            "energy_residual": float(self.run.attrs["energy_residual"]),
        }


@final
@dataclass(frozen=True, kw_only=True, eq=False)
class Experiment:
    """The choices of links that matter: the best, the worst, and what the printed matrix takes for the worst."""

    best: Trial
    worst: Trial
    misjudged: Trial

    def numbers(self) -> dict[str, object]:
        """For JSON."""
        return {name: getattr(self, name).numbers() for name in ("best", "worst", "misjudged")}


def experiment(best: Network, worst: Network, misjudged: Network, *, period: float = PERIOD) -> Experiment:
    """Holds and releases with each.

    Args:
        best: the best choice of links.
        worst: the worst choice.
        misjudged: the worst by the printed matrix, which is not so bad in truth.
        period: length of the steps [s].
    """
    return Experiment(best=_trial(best, period), worst=_trial(worst, period), misjudged=_trial(misjudged, period))


def settling_times(run: "xr.Dataset", held: Summary) -> dict[str, float | None]:
    """When positions and forces have settled in the hold, and how long after the release the copies agree [s].

    Args:
        run: of `holding`.
        held: its summary.
    """
    times = held["settling_time_s"]
    agreement = settling_time(run, start=RELEASE, stop=DURATION)
    return {"position": times["position"], "force": times["force"], "agreement": agreement}


def _trial(network: Network, period: float) -> Trial:
    scenario = holding(network, release=RELEASE, duration=DURATION, period=period)
    run = simulate(scenario)
    held = summary(run, scenario.build_body())
    decay = rightmost_root(network)
    return Trial(
        links=names(network.links),
        run=run,
        settling=settling_times(run, held),
        force_sum=abs(float(held["hold"]["force_sum"])),
        forces=[float(force) for force in held["hold"]["force"]],
        damping=[float(value) for value in held["local_damping"]],
        predicted=decay.root,
        measured=dominant_root(simulate(free(network, duration=_WINDOW[1] + 1.0, period=period))),
    )


def dominant_root(run: "xr.Dataset", window: tuple[float, float] = _WINDOW) -> complex:
    """The slowest mode that is seen in how far users are apart, by linear prediction (Prony's method) [1/s].

    Args:
        run: a result of `simulate`.
        window: to look at, from and to [s].
    """
    times = np.arange(*window, _SAMPLING)
    places: Float = at_times(run, "position", times).reshape(times.size, -1)
    apart: Float = places - places.mean(axis=1, keepdims=True)
    count = times.size - _ORDER
    past = np.concatenate([apart[k : k + count].T.reshape(-1, 1) for k in range(_ORDER)], axis=1)
    following = apart[_ORDER:].T.reshape(-1)
    weights = np.linalg.lstsq(past, following, rcond=None)[0]
    roots = np.log(np.roots(np.concatenate([[1.0], -weights[::-1]])).astype(np.complex128)) / _SAMPLING
    slowest = roots[int(np.argmax(roots.real))]
    return complex(slowest.real, abs(slowest.imag))
