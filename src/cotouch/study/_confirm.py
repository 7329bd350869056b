"""The rate at which a simulated loop comes to rest, to hold against its rightmost root."""

import math

import numpy as np

from cotouch.arrays import Complex, Float
from cotouch.errors import NetworkError, UnsupportedError
from cotouch.network import Network, rule_damping
from cotouch.scenario import Scenario
from cotouch.simulation import simulate

# Steps in the shortest delay, in a time constant of the slowest mode, and in that of the quickest spring.
_IN_DELAY, _IN_CONSTANT, _IN_SPRING = 40, 500, 20
_MOST_STEPS = 2_000_000
# The window of the fit, in time constants of the slowest mode.
_BEGIN, _END = 12.0, 22.0
# Samples kept of the window, and how many of them make one column of the fit.
_SAMPLES, _DEPTH = 400, 80
# Singular values, and shares of the motion at the middle of the window, below which there is only round-off.
_ROUND_OFF, _FRACTION = 1e-9, 1e-4
# The window without its beginning, which tells less, must show the same rate to this share of it.
_ALIKE = 0.1


def confirmed(
    network: Network, rate: float, *, mass: float = 1.0, damping: float = 0.0, stiffness: float = 0.0
) -> float:
    """Rate of the slowest mode, as a free decay in the simulator shows it [1/s].

    Copies of a point let go apart, at rest, with the rule's damping in constant mode. The velocities are a sum of
    exponentials; the slowest of those that are there is what comes back (Ho-Kalman: the shift between two block Hankel
    matrices of all users' velocities). The expected rate only sets step and duration and levels the data; it does not
    draw the result to itself.

    Args:
        network: connected; springs without weights.
        rate: 1/s, below 0, what `rightmost_root` says.
        mass: kg of the whole object.
        damping: Ns/m of the object.
        stiffness: N/m of the object.

    Raises:
        NetworkError: the rate is not below 0, or the network is not connected.
        UnsupportedError: the delays and springs are so much quicker than the slowest mode that the run would be too
            long, or the run shows no clear decay, or modes that decay too much alike.
    """
    if not (math.isfinite(rate) and rate < 0):
        raise NetworkError(f"rate is {rate:g} 1/s; it must be finite and below 0, or there is no decay to confirm")
    if not network.is_connected():
        raise NetworkError("the links leave separate groups of users, which never agree; link them")
    period = _period(network, rate, mass)
    duration = _END / -rate
    if duration / period > _MOST_STEPS:
        raise UnsupportedError(
            f"a free decay at {rate:g} 1/s takes {duration / period:.2g} steps of {period:.2g} s; at most "
            f"{_MOST_STEPS} are simulated"
        )
    every = max(1, round((_END - _BEGIN) / _SAMPLES / -rate / period))
    run = simulate(_scenario(network, duration, period, every, mass, damping, stiffness))
    velocity = np.asarray(run["velocity"].values[:, :, 0, 0], dtype=np.float64)
    time = np.asarray(run["time"].values[0], dtype=np.float64)
    kept = (time >= _BEGIN / -rate) & np.isfinite(velocity).all(axis=0)
    levelled = velocity[:, kept] * np.exp(-rate * (time[kept] - time[kept][0]))
    found = _slowest(levelled, every * period)
    later = _slowest(levelled[:, levelled.shape[1] // 4 :], every * period)
    if abs(found - later) > _ALIKE * abs(rate + found):
        raise UnsupportedError(
            f"modes decay too similarly to identify the slowest: a run shows {rate + found:.4g} 1/s, and without its "
            f"beginning {rate + later:.4g} 1/s"
        )
    return rate + found


def _period(network: Network, rate: float, mass: float) -> float:
    """A step that the shortest delay is a whole number of, short beside delays, springs, and the slowest mode."""
    delays = np.array([d for i, j in network.links for d in (network.delay[i, j], network.delay[j, i]) if d > 0])
    pull = float(network.linked_spring().sum(axis=1).max()) * network.size / mass
    longest = min(1.0 / -rate / _IN_CONSTANT, 1.0 / math.sqrt(pull) / _IN_SPRING)
    if not len(delays):
        return longest
    shortest = float(delays.min())
    return shortest / math.ceil(max(shortest / longest, _IN_DELAY))


def _scenario(
    network: Network, duration: float, period: float, every: int, mass: float, damping: float, stiffness: float
) -> Scenario:
    # No two alike, no pattern that a mode could be blind to, and mean 0 so that the translation has little to do.
    start = np.sin(1.0 + np.arange(network.size) ** 2)
    rule = rule_damping(network, ages=network.delay)[:, 0].tolist()
    return Scenario.make(
        network=network,
        body={"kind": "point", "mass": mass, "damping": damping, "stiffness": stiffness},
        steps={"duration": duration, "period": period},
        synchronisation={"law": "spring", "mode": "constant", "damping": rule},
        initial={"position": (start - start.mean()).tolist()},
        record={"every": every},
    )


def _slowest(signals: Float, step: float) -> float:
    """Largest real part (1/s) of the exponentials that signals (users, samples) are sums of."""
    columns = signals.shape[1] - _DEPTH
    scale = float(np.abs(signals).max(initial=0.0))
    if columns < _DEPTH or not 0 < scale < math.inf:
        raise UnsupportedError(
            "the simulated run shows no decay: the copies exceeded the floating-point range, or are at rest"
        )
    hankel = np.concatenate([signals[:, d : d + columns + 1] for d in range(_DEPTH)]) / scale
    left, sizes, right = np.linalg.svd(hankel[:, :-1], full_matrices=False)
    rank = max(1, int(np.count_nonzero(sizes > _ROUND_OFF * sizes[0])))
    shift = (left[:, :rank].T @ hankel[:, 1:] @ right[:rank].T) / sizes[:rank]
    values = np.linalg.eigvals(shift).astype(np.complex128)
    values = values[np.abs(values) > 1e-3]
    # Each counts from that end of the window where it is largest, so that no power exceeds 1, whatever the value.
    count: int = signals.shape[1]
    logs: Complex = np.log(values)
    largest = np.where(logs.real > 0.0, count - 1, 0)
    fractions, *_ = np.linalg.lstsq(
        np.exp(logs * (np.arange(count)[:, None] - largest)), signals.T / scale, rcond=1e-12
    )
    # How much of each there is at the middle.
    present = np.abs(fractions).max(axis=1) * np.exp(logs.real * (count // 2 - largest))
    # Beside the motion there, not beside each other: two that nearly coincide have large shares of opposite signs.
    middle = np.abs(signals[:, columns // 2 :]).max() / scale
    clear = values[present > _FRACTION * middle]
    if not len(clear):
        raise UnsupportedError("the simulated run shows no exponential decay above round-off")
    return float(np.log(np.abs(clear)).max()) / step
