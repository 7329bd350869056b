"""Freshest sample against constant indexing delay, buffered and self-paced, on one jittery, lossy channel."""

from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple, final

import numpy as np
from scipy import stats

from cotouch.arrays import Float
from cotouch.network import Network
from cotouch.scenario import Scenario
from cotouch.simulation import discrepancy, prepare, simulate, summary
from cotouch.study._data import holding
from cotouch.study._experiment import DURATION, RELEASE, settling_times

if TYPE_CHECKING:
    import xarray as xr


JITTER = 0.015
LOSS = 0.03
_SEED = 1
# Of the channel, for what the damping comes to.
_SEEDS = tuple(range(1, 9))


@final
@dataclass(frozen=True, kw_only=True, eq=False)
class ModeRun:
    """One way to run the same scenario.

    Attributes:
        mode: the word of the scenario file.
        quantile: given in the file, or None for the mode's own.
        run: the run.
        settling: of position and force while held, and of position after the release [s]; None: not settled.
        damping: B_i [Ns/m].
        pace: steps per second and user.
        late: how often the sample k − N_ij had not arrived, as a share of all samples used.
        gap: RMS distance between a copy and the mean of all [m].
    """

    mode: str
    quantile: float | None
    run: "xr.Dataset"
    settling: dict[str, float | None]
    damping: Float
    pace: float
    late: float
    gap: float

    @property
    def ages(self) -> Float:
        """All ages of samples after the first two seconds, in which there are none to be had yet [s]."""
        receivers = [int(str(name).split("<-")[0]) - 1 for name in self.run["direction"].values]
        time = self.run["time"].values[receivers]
        ages = self.run["age"].values[(time > 2.0) & np.isfinite(self.run["age"].values)]
        return np.asarray(ages, dtype=np.float64)

    def numbers(self) -> dict[str, object]:
        """For JSON."""
        ages = self.ages
        return {
            "mode": self.mode,
            "quantile": self.quantile,
            "largest_damping_ns_m": float(self.damping.max()),
            "age_s": {
                "median": float(np.median(ages)),
                "p99": float(np.quantile(ages, 0.99)),
                "max": float(ages.max()),
            },
            "settling_time_s": self.settling,
            "steps_per_s": self.pace,
            "late": self.late,
            "discrepancy_rms_m": self.gap,
            "energy_residual": float(self.run.attrs["energy_residual"]),
            "passivity_margin_j": float(self.run.attrs["passivity_margin"]),
        }


class Saving(NamedTuple):
    """How many times as much damping a buffer asks for as the freshest sample, over several seeds of the channel.

    Attributes:
        each: for each seed, (seeds,).
        middle: their mean.
        half: half of the 95 % interval of that mean, by Student's t.
    """

    each: Float
    middle: float
    half: float


@final
@dataclass(frozen=True, kw_only=True, eq=False)
class Modes:
    """All ways, "buffered", "self-paced" and "freshest", and "buffered 99 %", whose buffer is sometimes too short.

    Attributes:
        ways: by name.
        direction: the direction whose ages are drawn.
        delay: the constant part of its delay [s].
        seed: of the channel in all runs.
        seeds: of the channels for which `savings` were worked out.
        savings: of "buffered" and "buffered 99 %".
    """

    ways: dict[str, ModeRun]
    direction: str
    delay: float
    seed: int
    seeds: tuple[int, ...]
    savings: dict[str, Saving]

    def numbers(self) -> dict[str, object]:
        """For JSON."""
        return {
            name: way.numbers()
            | (
                {"damping_over_freshest": {"mean": saving.middle, "half_interval": saving.half}}
                if (saving := self.savings.get(name)) is not None
                else {}
            )
            for name, way in self.ways.items()
        }


def modes(network: Network, *, period: float) -> Modes:
    """Runs one scenario in every mode; only `synchronisation` differs between them.

    Args:
        network: users and the links in question.
        period: length of the steps [s].
    """
    base = holding(network, release=RELEASE, duration=DURATION, period=period).replace(
        seed=_SEED, channel={"jitter": {"kind": "uniform", "scale": JITTER}, "loss": LOSS}
    )
    table: dict[str, dict[str, object]] = {
        "buffered": {"mode": "constant"},
        "buffered 99 %": {"mode": "constant", "quantile": 0.99},
        "self-paced": {"mode": "self-paced"},
        "freshest": {"mode": "freshest"},
    }
    ways = {
        name: _way(base.replace(synchronisation={"law": "spring", "damping": "rule", **options}))
        for name, options in table.items()
    }
    largest: dict[str, list[float]] = {name: [] for name in table if name != "self-paced"}
    for seed in _SEEDS:
        for name, found in largest.items():
            asked = base.replace(seed=seed, synchronisation={"law": "spring", "damping": "rule", **table[name]})
            found.append(float(prepare(asked).local_damping.max()))  # the schedule decides; nobody needs to move
    savings = {name: _saving(found, largest["freshest"]) for name, found in largest.items() if name != "freshest"}
    quick = min(network.links, key=lambda link: network.delay[link])
    return Modes(
        ways=ways,
        direction=f"{quick[0] + 1}<-{quick[1] + 1}",
        delay=float(network.delay[quick]),
        seed=_SEED,
        seeds=_SEEDS,
        savings=savings,
    )


def _saving(buffered: list[float], freshest: list[float]) -> Saving:
    each = np.array(buffered) / np.array(freshest)
    half = float(stats.t.ppf(0.975, each.size - 1) * each.std(ddof=1) / each.size**0.5)
    return Saving(each, float(each.mean()), half)


def _way(scenario: Scenario) -> ModeRun:
    run = simulate(scenario)
    held = summary(run, scenario.build_body())
    steps = np.isfinite(run["time"].values).sum(axis=1) - 1
    used = int(np.isfinite(run["age"].values).sum())
    return ModeRun(
        mode=scenario.synchronisation.mode,
        quantile=scenario.synchronisation.quantile,
        run=run,
        settling=settling_times(run, held),
        damping=np.asarray(run["local_damping"].values[:, 0], dtype=np.float64),
        pace=float(steps.mean() / scenario.steps.duration),
        late=float(run.attrs["underruns"]) / used,
        gap=discrepancy(run)["rms"],
    )
