"""Damping that makes the users passive together, and how to share it between them.

The form of every result here, which the simulator consumes: an array `beta` of shape (N, 1 + number of weights) in
Ns/m, column 0 for the identity and column 1 + w for `network.weights[w]`, so that

    B_i = beta[i, 0] I + sum_w beta[i, 1 + w] network.weights[w].

Springs without weights use column 0 alone. `damping_matrices` makes the matrices (see `_gains`).
"""

from typing import Literal, TypeAlias, TypeVar, get_args

import numpy as np
import numpy.typing as npt

from cotouch.arrays import Float
from cotouch.errors import NetworkError
from cotouch.network._age_sums import AgeSums, age_sums_of, check_periods, index_delays_of
from cotouch.network._checks import numbers, one_user
from cotouch.network._exact import exact_scaling
from cotouch.network._network import Network

# One link, or many.
Amount = TypeVar("Amount", float, Float)

CertificateMethod: TypeAlias = Literal["rule", "minimax", "sum", "exact"]


def link_damping(spring: Amount, ages: Amount) -> Amount:
    """What a link asks of the damping at each of its ends, by the age rule: `½ K (a_ij + a_ji)` [Ns/m].

    Args:
        spring: K, of one link or of many, >= 0 [N/m].
        ages: of the samples in both directions together, likewise, >= 0 [s].
    """
    return 0.5 * spring * ages


def damping_for(
    network: Network,
    method: CertificateMethod,
    *,
    ages: npt.ArrayLike | None = None,
    index_delay: npt.ArrayLike | None = None,
    periods: npt.ArrayLike | None = None,
    costs: npt.ArrayLike | None = None,
    weights: npt.ArrayLike | None = None,
) -> Float:
    """Smallest damping that a method certifies: (N, 1 + number of weights) Ns/m, see the head of this module.

    Args:
        network: linked users.
        method: "rule" (`rule_damping`), "minimax": the largest `B_i` is smallest (`minimax_fractions`), "sum": `sum_i
            costs_i B_i` is smallest, or "exact": the rule scaled down until the exact test only just passes, for
            constant index delays and one constant period alone.
        ages: (N, N) s; as for `age_sums_of`.
        index_delay: (N, N) steps; as for `age_sums_of`.
        periods: s, one or (N,); as for `age_sums_of`.
        costs: (N,) of the users' damping, > 0, for "sum" alone; None: all the same.
        weights: (N,) > 0, for "rule" alone: moves its damping between the ends of links, `B_i = sum_j g_ij K_ij
            d_j/d_i` with what the plain rule has there as g; the greater a user's, the less damping it has, and the
            more its neighbours. None: the plain rule.

    Raises:
        NetworkError: an unknown method, or inputs that it does not take.
    """
    if method not in get_args(CertificateMethod):
        raise NetworkError(f'method is "{method}"; it must be "rule", "minimax", "sum" or "exact"')
    if costs is not None and method != "sum":
        raise NetworkError(f'costs are given with method "{method}"; only method "sum" has costs')
    if weights is not None and method != "rule":
        raise NetworkError(f'weights are given with method "{method}"; only method "rule" has weights')
    if method == "exact":
        if ages is not None or periods is None:
            raise NetworkError(
                'method "exact" needs the common period and takes no ages; give periods, and index_delay if known'
            )
        longest = check_periods(network, periods)
        if np.ptp(longest) > 0:
            raise NetworkError(
                f"periods run from {longest.min():g} s to {longest.max():g} s; the exact test needs one common period"
            )
        steps = index_delays_of(network, index_delay, longest)
        rule = rule_damping(network, index_delay=steps, periods=longest)
        return rule * exact_scaling(network, index_delay=steps, period=float(longest[0]), damping=rule)
    age_sums = age_sums_of(network, ages=ages, index_delay=index_delay, periods=periods)
    d = method_fractions(network, age_sums, method, costs=costs)
    return shared(network, age_sums, d if weights is None else d * _positive(network, "weights", weights))


def method_fractions(
    network: Network, age_sums: AgeSums, method: CertificateMethod, *, costs: npt.ArrayLike | None = None
) -> Float:
    """Weights d (N,) of a method that is not "exact".

    Of "sum": every link adds `reach_ij K_ij (c_i d_j/d_i + c_j d_i/d_j)`, at least `2 reach_ij K_ij sqrt(c_i c_j)`, and
    `d_i = sqrt(c_i)` reaches that on all links at once. With equal costs and ages it is the plain rule: nothing has a
    smaller sum. For index delays g is not symmetric, the age sum is (see `Reach`), and the same holds.

    Args:
        network: of the users.
        age_sums: of both ends' ages on the links.
        method: any but "exact".
        costs: of the users' damping, (N,) > 0; None: the same.
    """
    if method == "rule":
        return age_sums.fractions
    if method == "minimax":
        return minimax_fractions(network, age_sums)
    return np.ones(network.size) if costs is None else np.sqrt(_positive(network, "costs", costs))


def rule_damping(
    network: Network,
    *,
    ages: npt.ArrayLike | None = None,
    index_delay: npt.ArrayLike | None = None,
    periods: npt.ArrayLike | None = None,
) -> Float:
    """The plain rule [Lee & Huang 2010, Theorem 1], and the age rule in its likeness; arguments as for `damping_for`.

    Index delays: `B_i = sum_j (N_ij + N_ji)/2 T_j K_ij`; ages: `B_i = sum_j (age_ij + age_ji)/2 K_ij`.

    Args:
        network: of the users.
        ages: (N, N) [s].
        index_delay: (N, N) in steps.
        periods: of the users, with index delays [s].
    """
    return damping_for(network, "rule", ages=ages, index_delay=index_delay, periods=periods)


def shared(network: Network, age_sums: AgeSums, d: Float) -> Float:
    """The rule with damping moved between the ends of links: coefficients of `B_i = sum_j reach_ij K_ij d_j/d_i`.

    Any weights are valid, because only `c_ij c_ji` of a link's two shares matters and d cancels in it (see `Reach`);
    for index delays with different periods too, where a link's shares `(N_ij + N_ji)/2 T_j` are not symmetric.

    Args:
        network: of the users.
        age_sums: of both ends' ages on the links.
        d: weights of the users, (N,) > 0; the greater, the less damping this user and the more its neighbours carry.
    """
    fractions = age_sums.seconds * network.linked_spring() * d / d[:, None]
    beta = np.zeros((network.size, 1 + len(network.weights)))
    for w in range(beta.shape[1]):
        beta[:, w] = np.where(network.weight_of == w - 1, fractions, 0.0).sum(axis=1)
    return beta


def minimax_fractions(network: Network, age_sums: AgeSums) -> Float:
    """Perron vector of `reach_ij K_ij` in every connected component: these weights make the largest `B_i` smallest.

    With `G_ij = reach_ij K_ij` the users of a connected component all get `B_i = (G d)_i / d_i = lambda`, the Perron
    eigenvalue of G, with d its Perron vector. Nothing does better, not even shares chosen for every link alone: with
    `c_ij c_ji >= reach_ij^2`, `sum_i d_i^2 B_i >= sum over links of 2 G_ij d_i d_j = lambda sum_i d_i^2`. (For weights
    d alone this is the Collatz-Wielandt formula.) With weighted springs the sum of a user's coefficients is what is
    levelled.

    Args:
        network: of the users.
        age_sums: of both ends' ages on the links.
    """
    load = age_sums.seconds * network.linked_spring()
    d = np.ones(network.size)
    # Links with an age sum of 0 carry nothing and must not join two components into one.
    loaded = network.with_links([link for link in network.links if load[link] > 0])
    for component in loaded.components():
        users = list(component)
        if len(users) > 1:
            d[users] = np.abs(np.linalg.eigh(load[np.ix_(users, users)])[1][:, -1])
    return d


def _positive(network: Network, name: str, values: npt.ArrayLike) -> Float:
    array = numbers(name, values)
    if array.shape != (network.size,):
        raise NetworkError(f"{name} has shape {array.shape}; it must be ({network.size},), one for each user")
    for i in map(int, np.flatnonzero(~(np.isfinite(array) & (array > 0)))):
        raise NetworkError(f"{name} of {one_user(network.users, i)} is {array[i]:g}; it must be finite and above 0")
    return array
