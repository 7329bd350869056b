"""The exact test of passivity for constant index delays and one constant period of all users. **Beyond** the paper.

With `v` sinusoidal at the angle theta per step, `x = v/(j Omega)`, `Omega = (2/T) tan(theta/2)`, and the port i of the
synchronisation control takes `B_i v_i + sum_j K_ij (v_i - v_j e^(-j theta N_ij))/(j Omega)`. The Hermitian part of that
is `H = diag(B) + C(theta)` with, on a link,

    C_ij = K_ij sin(theta (N_ij + N_ji)/2)/Omega e^(j theta (N_ji - N_ij)/2)
         = T/2 K_ij sum over l from -N_ij to N_ji of w_l e^(j theta l),   w_l = 1, at the two ends 1/2.

The control is N-port passive if and only if H is positive semidefinite for all theta from 0 to pi. (The integrator's
pole at 0 adds the stiffness matrix P, which is positive semidefinite. Damping of the body itself comes on top and is
not counted.)

The search over theta is certain: the largest eigenvalue is a convex function of the matrix, so between two angles it is
at most the larger of its values there plus h^2/8 times a bound on the norm of C''. Intervals whose bound lies below the
best value are dropped, the others halved. The sum above bounds C'' everywhere, its closed form does better far from 0.
"""

from dataclasses import dataclass
from typing import final

import numpy as np
import numpy.typing as npt

from cotouch.arrays import Complex, Float, Long
from cotouch.errors import NetworkError, UnsupportedError
from cotouch.interrupt import check
from cotouch.network._age_sums import check_periods, index_delays_of
from cotouch.network._gains import coefficients, damping_matrices, inverse_roots, link_matrices, single_weight
from cotouch.network._network import Network

# What is returned is never on the wrong side of the truth, and at most this far from it, relative to the scale of C.
TOLERANCE = 1e-11
_FIRST_INTERVALS = 64
# Bisections; a hundred would reach the last bit of theta. Fewer only widen the returned bound.
_HALVINGS = 60
_MOST_INTERVALS = 200_000
# Complex numbers in one batch of matrices: 64 MB.
_BATCH = 4_000_000
# Largest block matrix when springs have different weights.
_MOST_ROWS = 256


@final
@dataclass(frozen=True, eq=False)
class _Family:
    """The matrices `-C(theta) - constant` of which the largest eigenvalue is sought.

    Attributes:
        ends: (links, 2) users.
        blocks: (links, r, r) `K_ij`, perhaps scaled from both sides.
        norms: (links,) spectral norms of the blocks.
        forth: (links,) `N_ij`.
        back: (links,) `N_ji`.
        period: T in s.
        constant: (N, r, r) block diagonal.
    """

    ends: Long
    blocks: Float
    norms: Float
    forth: Long
    back: Long
    period: float
    constant: Float

    def top(self, theta: Float) -> Float:
        """Largest eigenvalue at every angle."""
        size, rows = self.constant.shape[:2]
        chunk = max(1, _BATCH // (size * rows) ** 2)
        parts = [np.linalg.eigvalsh(-self.matrices(theta[k : k + chunk]))[:, -1] for k in range(0, len(theta), chunk)]
        return np.concatenate(parts).astype(np.float64)

    def matrices(self, theta: Float) -> Complex:
        """`C(theta) + constant`: (len(theta), N r, N r)."""
        size, rows = self.constant.shape[:2]
        half = theta[:, None] / 2
        total = self.forth + self.back
        with np.errstate(divide="ignore", invalid="ignore"):
            ratio = np.where(half > 0, np.sin(total * half) / np.tan(half), total)
        entry = self.period / 2 * ratio * np.exp(1j * half * (self.back - self.forth))
        matrix = np.zeros((len(theta), size, rows, size, rows), dtype=np.complex128)
        matrix[:, np.arange(size), :, np.arange(size), :] = self.constant[:, None]
        for link, (i, j) in enumerate(self.ends):
            block = entry[:, link, None, None] * self.blocks[link]
            matrix[:, i, :, j, :] = block
            matrix[:, j, :, i, :] = block.conj().transpose(0, 2, 1)
        return matrix.reshape(len(theta), size * rows, size * rows)

    def bounds(self, theta: Float) -> tuple[Float, Float]:
        """Bounds on the norms of C and of C'' at all angles from each theta to pi."""
        half = theta[:, None] / 2
        a, b = self.forth.astype(np.float64), self.back.astype(np.float64)
        with np.errstate(divide="ignore", invalid="ignore"):
            cot, square = 1 / np.tan(half), 1 / (2 * np.sin(half) ** 2)
            size = np.minimum(a + b, cot)
            far = (cot * (a**2 + b**2) + 2 * (a + b) * square + 2 * cot * square) / 2
        near = (2 * a**3 + a + 2 * b**3 + b) / 6
        bend = np.minimum(near, np.where(half > 0, far, np.inf))
        return self._row_sums(size), self._row_sums(bend)

    def _row_sums(self, values: Float) -> Float:
        """Largest row sum of the symmetric matrices with `T/2 |K_ij| values`, which bounds their spectral norm."""
        values = self.period / 2 * self.norms * values
        rows = np.zeros((len(values), len(self.constant)))
        for link, (i, j) in enumerate(self.ends):
            rows[:, i] += values[:, link]
            rows[:, j] += values[:, link]
        return rows.max(axis=1)


def exact_scaling(
    network: Network, *, index_delay: npt.ArrayLike | None = None, period: float, damping: npt.ArrayLike
) -> float:
    """Smallest factor on all damping with which the exact test still passes; below 1 the damping given passes.

    Args:
        network: linked users.
        index_delay: (N, N) steps, [i][j] from j to i; None rounds the delays of the network up to steps.
        period: T in s, common to all users and constant.
        damping: (N, 1 + number of weights) coefficients, or (N,); see `damping_for`.

    Returns:
        The factor, never too small and at most 1e-9 (relative) too large. 0 without delays to cover; inf when a user
        has no damping on a link with delay.

    Raises:
        NetworkError: inputs of the wrong shape or range.
        UnsupportedError: different weights on the springs, and more than 256 rows in all.
    """
    family = _family(network, index_delay, period, damping, scaled=True)
    return 0.0 if not len(family.ends) else np.inf if not np.isfinite(family.norms).all() else _largest(family)


def exact_margin(
    network: Network, *, index_delay: npt.ArrayLike | None = None, period: float, damping: npt.ArrayLike
) -> float:
    """Smallest eigenvalue of H(theta) over all theta from 0 to pi, in Ns/m: passive where it is at least 0.

    Arguments and errors as for `exact_scaling`. Never too large, and at most 1e-9 of the largest damping or of the
    reach of the springs too small.

    Args:
        network: of the users.
        index_delay: (N, N) in steps; None: what the delays come to.
        period: of all users [s].
        damping: of the users [Ns/m].
    """
    beta = coefficients(network, damping)
    family = _family(network, index_delay, period, beta, scaled=False)
    smallest = -_largest(family)
    weight = single_weight(network, beta)
    if not weight:
        return smallest
    # H is a scalar problem times the weight: the sign decides which eigenvalue of the weight counts.
    low, high = np.linalg.eigvalsh(network.weights[weight - 1])[[0, -1]]
    return smallest * float(low if smallest >= 0 else high)


def sync_hermitian(
    network: Network,
    theta: npt.ArrayLike,
    *,
    index_delay: npt.ArrayLike | None = None,
    period: float,
    damping: npt.ArrayLike,
) -> Complex:
    """H(theta) at the given angles: (len(theta), N r, N r) Ns/m; other arguments and errors as for `exact_scaling`.

    Where one weight serves all links and all damping, r = 1 and the matrices are to be multiplied by that weight.

    Args:
        network: of the users.
        theta: angles, from 0 to pi.
        index_delay: (N, N) in steps; None: what the delays come to.
        period: of all users [s].
        damping: of the users [Ns/m].
    """
    family = _family(network, index_delay, period, damping, scaled=False)
    return family.matrices(np.atleast_1d(np.array(theta, dtype=np.float64)))


def _family(
    network: Network, index_delay: npt.ArrayLike | None, period: float, damping: npt.ArrayLike, *, scaled: bool
) -> _Family:
    periods = check_periods(network, period)
    if np.ndim(period):
        raise NetworkError("period is a list; the exact test needs one common period in seconds")
    steps = index_delays_of(network, index_delay, periods)
    beta = coefficients(network, damping)
    weight = single_weight(network, beta)
    ends = np.array(network.links, dtype=np.int64).reshape(-1, 2)
    if weight is None:
        own, blocks = damping_matrices(network, beta), link_matrices(network)
        rows = network.size * own.shape[1]
        if rows > _MOST_ROWS:
            raise UnsupportedError(
                f"springs with different weights make the exact test a problem of {rows} rows; "
                f"it takes at most {_MOST_ROWS}: use one common weight, or the rule"
            )
    else:
        own = beta[:, weight, None, None]
        blocks = network.spring[ends[:, 0], ends[:, 1], None, None]
    forth, back = steps[ends[:, 0], ends[:, 1]], steps[ends[:, 1], ends[:, 0]]
    if scaled:
        late = forth + back > 0
        ends, blocks, forth, back = ends[late], blocks[late], forth[late], back[late]
        root = inverse_roots(own)
        with np.errstate(invalid="ignore"):
            blocks = root[ends[:, 0]] @ blocks @ root[ends[:, 1]]
        own = np.zeros_like(own)
    finite = np.isfinite(blocks).all(axis=(1, 2))
    norms = np.full(len(blocks), np.inf)
    norms[finite] = np.linalg.norm(blocks[finite], ord=2, axis=(1, 2))
    return _Family(ends, blocks, norms, forth, back, float(periods[0]), own)


def _largest(family: _Family) -> float:
    """Upper bound, tight to `TOLERANCE`, on the largest eigenvalue over all angles from 0 to pi."""
    theta = np.linspace(0.0, np.pi, _FIRST_INTERVALS + 1)
    value = family.top(theta)
    low, high, at_low, at_high = theta[:-1], theta[1:], value[:-1], value[1:]
    # The constant part shifts the envelope of C by at most its own largest eigenvalue of the other sign.
    shift = -float(np.linalg.eigvalsh(family.constant)[:, 0].min())
    best = float(value.max())
    scale = float(family.bounds(np.zeros(1))[0][0]) if len(family.ends) else 0.0
    slack = TOLERANCE * max(scale, abs(best), float(np.abs(family.constant).max()))
    if not len(family.ends):
        return best
    for _ in range(_HALVINGS):
        check()
        size, bend = family.bounds(low)
        upper = np.minimum(np.maximum(at_low, at_high) + bend * (high - low) ** 2 / 8, size + shift)
        keep = upper > best + slack
        if not keep.any():
            return best + slack
        low, high, at_low, at_high = low[keep], high[keep], at_low[keep], at_high[keep]
        if len(low) > _MOST_INTERVALS:
            return float(upper.max())
        middle = (low + high) / 2
        at_middle = family.top(middle)
        best = max(best, float(at_middle.max()))
        low, high = np.concatenate([low, middle]), np.concatenate([middle, high])
        at_low, at_high = np.concatenate([at_low, at_middle]), np.concatenate([at_middle, at_high])
    size, bend = family.bounds(low)
    upper = np.minimum(np.maximum(at_low, at_high) + bend * (high - low) ** 2 / 8, size + shift)
    return float(max(best, upper.max()))
