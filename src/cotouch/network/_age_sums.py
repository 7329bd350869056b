"""How far back in time the two ends of every link see each other: what the damping has to cover."""

import math
from dataclasses import dataclass
from typing import Literal, TypeAlias, final

import numpy as np
import numpy.typing as npt

from cotouch.arrays import Float, Long
from cotouch.errors import NetworkError
from cotouch.network._checks import numbers, one_user
from cotouch.network._network import Network

Basis: TypeAlias = Literal["age", "index"]


@final
@dataclass(frozen=True, eq=False)
class AgeSums:
    """Sum of ages of every link and how the plain rule shares it between its two ends.

    Let the ends of a link keep `B_i >= sum_j c_ij K_ij`. The delayed part of the spring's work at i is bounded by
    products `|a_i| |b_j| <= rho/2 |a_i|^2 + 1/(2 rho) |b_j|^2`, whatever rho > 0, so the shares of its two ends are
    valid if and only if this bound proves them: `c_ij c_ji >= reach_ij^2`. Shares `reach_ij d_j/d_i` with any d > 0 are
    of that kind, and no others are ever needed: the smallest largest damping and the smallest sum are both among them.

    * Ages: the samples that i uses are at most `age_ij` old, so `reach_ij = (age_ij + age_ji)/2`, and the plain rule
      has d = 1.
    * Index delays: i moves by `s_i = T_i v_i` in a step, and against a neighbour held back by `N_ij` steps this does
      the work `s_i K (s_j(k)/2 + s_j(k-1) + ... + s_j(k-N_ij)/2)`: `N_ij` products. The damper takes `s_i B_i s_i /
      T_i(k)`, at least `s_i B_i s_i / T_i` with `T_i` the longest period of user i. So fractions are valid when `c_ij
      c_ji >= ((N_ij + N_ji)/2)^2 T_i T_j`, which makes `reach_ij = (N_ij + N_ji)/2 sqrt(T_i T_j)`. The rule of the
      paper, `B_i >= sum_j (N_ij + N_ji)/2 T_j K_ij` with the *neighbour's* period, has `d_i = sqrt(T_i)`; one's own
      period instead, `d_i = 1/sqrt(T_i)`, is just as valid; mixing the two over one link is not. [Lee & Huang 2010,
      Theorem 1]

    Attributes:
        seconds: (N, N) symmetric sums of ages in s, 0 where not linked.
        fractions: (N,) the weights d > 0 of the plain rule.
        basis: what the sums were made from.
    """

    seconds: Float
    fractions: Float
    basis: Basis


def age_sums_of(
    network: Network,
    *,
    ages: npt.ArrayLike | None = None,
    index_delay: npt.ArrayLike | None = None,
    periods: npt.ArrayLike | None = None,
) -> AgeSums:
    """Age sums from ages, or from index delays and periods; from neither, the delays of the network count as ages.

    Args:
        network: its links count.
        ages: (N, N) s, [i][j] the greatest age of a sample of j at the end of the step of i that uses it; the sample's
            time is the middle of the step of j that it is the mean of. (Where all users step at one constant period T,
            T/2 may be deducted, and `N_ij` steps are an age of `N_ij T`.)
        index_delay: (N, N) whole steps, at least 0, [i][j] from j to i. Left out while `periods` is given, it is the
            delay of the network rounded up to steps of the one common period.
        periods: s, the longest step of every user: one number for all, or (N,).

    Raises:
        NetworkError: both kinds given, index delays without periods, wrong shapes or values.
    """
    if ages is not None:
        if index_delay is not None or periods is not None:
            raise NetworkError("ages are given together with index_delay or periods; give one kind")
        seconds = _pairwise(network, "ages", ages, "s")
        return AgeSums((seconds + seconds.T) / 2, np.ones(network.size), "age")
    if index_delay is None and periods is None:
        return age_sums_of(network, ages=network.delay)
    if periods is None:
        raise NetworkError("index_delay is given without periods; give the longest step of the users in seconds")
    longest = check_periods(network, periods)
    steps = index_delays_of(network, index_delay, longest)
    root = np.sqrt(longest)
    return AgeSums((steps + steps.T) / 2 * np.outer(root, root), root, "index")


def check_periods(network: Network, periods: npt.ArrayLike) -> Float:
    """Periods (N,) in s from one number for all or one for each; finite and above 0.

    Args:
        network: of the users.
        periods: one number or (N,) [s].
    """
    values = numbers("periods", periods)
    if values.shape not in ((), (network.size,)):
        raise NetworkError(
            f"periods has shape {values.shape}; it must be one number or one for each of {network.size} users"
        )
    values = np.broadcast_to(values, (network.size,))
    for i in map(int, np.flatnonzero(~(np.isfinite(values) & (values > 0)))):
        raise NetworkError(
            f"periods: {one_user(network.users, i)} has {values[i]:g} s; a period must be finite and above 0"
        )
    return values


def index_delays_of(network: Network, index_delay: npt.ArrayLike | None, periods: Float) -> Long:
    """Index delays (N, N), 0 off the links: those given, or those that the common period makes of the delays.

    Args:
        network: of the users.
        index_delay: (N, N) in steps; None: what the delays come to.
        periods: of the users, (N,) [s].
    """
    if index_delay is None:
        if np.ptp(periods) > 0:
            raise NetworkError(
                "periods differ between users; give index_delay, which then does not follow from the delays"
            )
        return network.index_delays(float(periods[0]))
    steps = _pairwise(network, "index_delay", index_delay, "steps")
    for i, j in np.argwhere(steps != np.round(steps)):
        raise NetworkError(
            f"index_delay from {one_user(network.users, int(j))} to {one_user(network.users, int(i))} is "
            f"{steps[i, j]:g}; it must be a whole number of steps"
        )
    return steps.astype(np.int64)


def _pairwise(network: Network, name: str, values: npt.ArrayLike, unit: str) -> Float:
    """(N, N) numbers, finite and at least 0 on the links, 0 elsewhere."""
    matrix = numbers(name, values)
    size = network.size
    if matrix.shape != (size, size):
        raise NetworkError(f"{name} has shape {matrix.shape}; for {size} users it must be ({size}, {size})")
    for link in network.links:
        for i, j in (link, link[::-1]):
            if not (math.isfinite(matrix[i, j]) and matrix[i, j] >= 0):
                raise NetworkError(
                    f"{name} from {one_user(network.users, j)} to {one_user(network.users, i)} is "
                    f"{matrix[i, j]:g} {unit}; it must be finite and at least 0"
                )
    return np.where(network.adjacency() > 0, matrix, 0.0)
