"""How fast the first-order consensus model mixes [Lee & Huang 2010, section IV]."""

import math
from dataclasses import dataclass
from typing import final

import numpy as np
import scipy.fft

from cotouch.errors import NetworkError, UnsupportedError
from cotouch.network._lags import Convention, Rounding, consensus_lags, cycle_period
from cotouch.network._network import Network
from cotouch.network._types import ComplexArray, FloatArray, IntArray

# Samples of a circle per degree of the polynomial. Neighbouring roots are about 2 pi / degree apart, so this
# resolves the phase between them.
_SAMPLES_PER_DEGREE = 8
_CIRCLES = 60
# Less than half a turn between samples leaves no doubt which way the phase turned.
_CLEAR_TURN = 2.0
# Irrational, so that shrinking circles don't come back to the same place.
_SHRINK = 0.618
# Roots closer together than this are one root found twice.
_SAME = 1e-9
# Largest lifted matrix for the dense fallback: below ten seconds.
_DENSE_ROWS = 3000
_NEWTON_STEPS = 50
_PLAIN_STEPS = 12
# Samples of the small circle on which coinciding roots are counted.
_CIRCLE = 32


@final
@dataclass(frozen=True)
class Mixing:
    """How fast information spreads.

    Attributes:
        value: second largest |eigenvalue| of the lifted J, 0 to 1; smaller is faster; exactly 1 when periodic.
        period: gcd of the delays of all cycles in time units; above 1, users echo each other forever and never agree.
        time_constant_s: seconds in which what is left to agree on falls by e; inf when periodic, 0 when `value` is 0.
    """

    value: float
    period: int
    time_constant_s: float


def mixing(
    network: Network, *, time_unit: float, convention: Convention = "equation", rounding: Rounding = "exact"
) -> Mixing:
    """Mixing of the consensus model `p_i(k+1) = sum_j W_ij p_j(k+1-N_ij)`, `W_ij = K_ij / sum_j K_ij`.

    J has the eigenvalues z with `det(I - W_ij z^-N_ij) = 0` [Lee & Huang 2010, section IV]. In w = 1/z this is a
    polynomial whose coefficients one Fourier transform gives; the root w = 1 is divided out; the argument principle
    counts the roots in a circle, and Newton finds as many: the count shows that none was missed.

    Args:
        network: connected, at least 2 users. Of springs with weights the strengths count.
        time_unit: seconds of one step of the model.
        convention: "equation" (lag `N_ij`, at least 1) or "matrix" (lag `N_ij + 1`): the printed equation and the
            printed J differ by that step.
        rounding: "exact" refuses delays that are not whole numbers of time units; "nearest" and "up" round them.

    Raises:
        NetworkError: not connected, fewer than 2 users, or a delay that the time unit or the convention does not allow.
        UnsupportedError: too large and too ill-conditioned for the polynomial, which no ordinary network is.
    """
    if network.size < 2:
        raise NetworkError("the network has 1 user; mixing needs at least 2")
    if not network.is_connected():
        raise NetworkError(
            f"the links leave {len(network.components())} separate groups of users, which never agree; link them"
        )
    lags = consensus_lags(network, time_unit=time_unit, convention=convention, rounding=rounding)
    period = cycle_period(lags)
    if period > 1:
        return Mixing(value=1.0, period=period, time_constant_s=math.inf)
    spring = network.linked_spring()
    value = _second_modulus(spring / spring.sum(axis=1, keepdims=True), lags)
    return Mixing(value=value, period=period, time_constant_s=-time_unit / math.log(value) if value > 0 else 0.0)


def second_eigenvalue(
    network: Network, *, time_unit: float, convention: Convention = "equation", rounding: Rounding = "exact"
) -> float:
    """Second largest |eigenvalue| of the lifted J: the `value` of `mixing`, which explains the arguments and errors."""
    return mixing(network, time_unit=time_unit, convention=convention, rounding=rounding).value


def lifted_matrix(weights: FloatArray, lags: IntArray) -> FloatArray:
    """The chain as one square matrix, keeping of each user only the history that others still need.

    Args:
        weights: (N, N) row-stochastic.
        lags: (N, N) in steps, at least 1 where `weights` is not 0.

    Returns:
        (n, n) with n the sum over users of their longest outgoing lag. Its eigenvalues are those of the printed J but
        for zeros.
    """
    history = np.maximum(lags.max(axis=0), 1)
    first = np.concatenate([[0], np.cumsum(history)])
    matrix = np.zeros((int(first[-1]), int(first[-1])))
    for i in range(len(lags)):
        for j in np.flatnonzero(lags[i]):
            matrix[first[i], first[j] + lags[i, j] - 1] += weights[i, j]
        for age in range(1, int(history[i])):
            matrix[first[i] + age, first[i] + age - 1] = 1.0
    return matrix


def _second_modulus(weights: FloatArray, lags: IntArray) -> float:
    """Second largest |eigenvalue| of an aperiodic chain, from the smallest root but 1 of its polynomial in 1/z."""
    degree_bound = int(lags.max(axis=0).sum())
    coefficients = _reduced_polynomial(weights, lags, degree_bound)
    if len(coefficients) < 2:
        return 0.0
    smallest = _smallest_root(coefficients, weights, lags)
    if smallest is not None:
        return 1.0 / smallest
    if degree_bound > _DENSE_ROWS:
        raise UnsupportedError(
            f"the lifted matrix has {degree_bound} rows and eigenvalues too close to tell apart; "
            "choose a larger time unit"
        )
    return float(np.sort(np.abs(np.linalg.eigvals(lifted_matrix(weights, lags))))[-2])


def _reduced_polynomial(weights: FloatArray, lags: IntArray, degree_bound: int) -> FloatArray:
    """Coefficients, ascending in w, of `det(I - W_ij w^N_ij) / (1 - w)`."""
    count = scipy.fft.next_fast_len(degree_bound + 1, real=True)
    w = np.exp(-2j * np.pi * np.arange(count // 2 + 1) / count)
    coefficients = scipy.fft.irfft(np.linalg.det(np.eye(len(lags)) - _powers(w, weights, lags)), count)
    reduced = np.cumsum(coefficients)[:degree_bound]
    significant = np.flatnonzero(np.abs(reduced) > 1e-13 * np.abs(reduced).max())
    return reduced[: int(significant[-1]) + 1]


def _powers(w: ComplexArray, weights: FloatArray, lags: IntArray) -> ComplexArray:
    """`W_ij w^N_ij` for every w: (len(w), N, N)."""
    return weights * w[:, None, None] ** lags


def _smallest_root(coefficients: FloatArray, weights: FloatArray, lags: IntArray) -> float | None:
    """Smallest |root| of the reduced polynomial; None if it cannot be told for certain.

    Newton starts where its step is locally shortest on a circle. The roots it finds are divided out; then the phase of
    what is left turns slowly along the circle, and by the argument principle counts the roots inside that were missed.
    """
    degree = len(coefficients) - 1
    order = np.arange(degree + 1)
    count = 2 * scipy.fft.next_fast_len(_SAMPLES_PER_DEGREE * (degree + 1) // 2 + 16)
    # The upper half of the unit circle; the coefficients are real, so the lower half mirrors it.
    unit = np.exp(2j * np.pi * np.arange(count // 2 + 1) / count)
    low, high, growing = 0.0, 1.0 / degree, True
    for _ in range(_CIRCLES):
        # A real transform runs clockwise; its conjugate is the value on the upper half circle of radius e^high.
        radius = math.exp(high)
        scaled = coefficients * np.exp(high * order)
        value, slope = scipy.fft.rfft(scaled, count).conj(), scipy.fft.rfft(scaled * order, count).conj()
        step = value / slope
        starts = _local_minima(np.abs(step))
        found = _newton(radius * (unit - unit * step)[starts], weights, lags)
        for copies in (np.ones(len(found), dtype=np.int64), None):
            times = copies if copies is not None else _multiplicities(found, weights, lags)
            left = value / _product(unit, found / radius, times)
            turns = np.angle(left[1:] / left[:-1])
            clear = np.abs(turns).max() < _CLEAR_TURN
            missed = round(float(turns.sum() / np.pi))
            if clear and missed == 0:
                break
        inside = found[np.abs(found) < radius]
        if clear and missed == 0 and inside.size:
            return float(np.abs(inside).min())
        if clear and missed == 0 and growing:
            low, high = high, 2 * high
        else:
            growing = False
            high = low + (high - low) * _SHRINK
    return None


def _local_minima(size: FloatArray) -> IntArray:
    padded = np.concatenate([[np.inf], size, [np.inf]])
    return np.flatnonzero((size <= padded[:-2]) & (size <= padded[2:]))


def _product(unit: ComplexArray, roots: ComplexArray, times: IntArray) -> ComplexArray:
    """The polynomial with these roots, and the conjugates of those that are not real, on samples of the unit circle."""
    product = np.ones_like(unit)
    for root, count in zip(roots, times, strict=True):
        product = product * (unit - root) ** count
        if abs(root.imag) > _SAME:
            product = product * (unit - root.conjugate()) ** count
    return product


def _multiplicities(roots: ComplexArray, weights: FloatArray, lags: IntArray) -> IntArray:
    """How many roots coincide at each of `roots`, by the logarithmic derivative around it."""
    if not roots.size:
        return np.zeros(0, dtype=np.int64)
    apart = np.abs(roots[:, None] - np.concatenate([roots, roots.conj(), [1.0]])[None, :])
    apart[apart <= _SAME] = np.inf
    radius = np.minimum(apart.min(axis=1) / 3, 1e-2 / lags.max())
    around = np.exp(2j * np.pi * np.arange(_CIRCLE) / _CIRCLE)
    w = (roots[:, None] + radius[:, None] * around).ravel()
    powers = _powers(w, weights, lags)
    ratio = -np.einsum("wij,wji->w", np.linalg.inv(np.eye(len(lags)) - powers), lags * powers) / w
    return np.rint((ratio.reshape(len(roots), -1) * radius[:, None] * around).mean(axis=1).real).astype(np.int64)


def _newton(w: ComplexArray, weights: FloatArray, lags: IntArray) -> ComplexArray:
    """Different roots, but w = 1, with Im >= 0, that Newton on `det(I - P)` itself reaches from the starts `w`."""
    identity = np.eye(len(lags))
    found: list[complex] = []
    for turn in range(_NEWTON_STEPS):
        w = w[(np.abs(np.abs(w) - 1.0) < 1.0) & (np.abs(w - 1.0) > _SAME)]
        if not w.size:
            break
        powers = _powers(w, weights, lags)
        if turn >= _PLAIN_STEPS:
            # Roots that symmetric users share attract the determinant slowly, its smallest singular value fast.
            left, sizes, right = np.linalg.svd(identity - powers)
            slope = -np.einsum("wi,wij,wj->w", left[:, :, -1].conj(), lags * powers, right[:, -1].conj()) / w
            with np.errstate(divide="ignore", over="ignore", invalid="ignore"):
                step = sizes[:, -1] / slope
            w = _step(w, step, found)
            continue
        try:
            inverse = np.linalg.inv(identity - powers)
        except np.linalg.LinAlgError:
            w = w * (1.0 + 1e-14)  # One of them is a root to the last bit: step off it.
            continue
        # The logarithmic derivative of det(I - P) in w is -trace((I - P)^-1 P'), less that of 1 - w.
        step = 1.0 / (-np.einsum("wij,wji->w", inverse, lags * powers) / w - 1.0 / (w - 1.0))
        if turn == _PLAIN_STEPS - 1:
            # What still strides goes nowhere near; the count notices if that was wrong.
            near = np.abs(step) < 0.1 / lags.max()
            w, step = w[near], step[near]
        w = _step(w, step, found)
    return np.array(found, dtype=np.complex128)


def _step(w: ComplexArray, step: ComplexArray, found: list[complex]) -> ComplexArray:
    """Moves `w`, puts what has converged and is new into `found`, and returns the rest."""
    w = w - step
    converged = np.abs(step) <= 1e-12 * np.abs(w)
    for root in w[converged]:
        upper = complex(root.real, abs(root.imag))
        if all(abs(upper - other) > _SAME for other in found):
            found.append(upper)
    return w[~converged & np.isfinite(w)]
