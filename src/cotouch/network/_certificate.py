"""What a damping guarantees, by which argument, for which way of running."""

from dataclasses import dataclass
from typing import Literal, TypeAlias, final

import numpy as np
import numpy.typing as npt

from cotouch.arrays import Float
from cotouch.network._age_sums import AgeSums, Basis, age_sums_of, check_periods, index_delays_of
from cotouch.network._damping import CertificateMethod, damping_for, method_fractions, minimax_fractions
from cotouch.network._exact import exact_scaling
from cotouch.network._gains import coefficients, damping_matrices, inverse_roots, link_matrices, single_weight
from cotouch.network._network import Network

Mode: TypeAlias = Literal["constant", "self-paced", "freshest"]

# Damping that was designed to sit on the bound may fall this much short of it in round-off.
_ROUND_OFF = 1e-9

_COVERS: dict[Basis | Literal["exact"], tuple[str, tuple[Mode, ...]]] = {
    "age": (
        "any rates, jitter, loss, duplication and reordering, as long as steps last as long as they simulate and no "
        "sample is older than its declared age at the end of the step that uses it; constant indexing delay too where "
        "its samples stay within that age",
        ("constant", "freshest"),
    ),
    "index": (
        "constant indexing delays with every user's step changing freely up to the declared maximum, fixed or "
        "self-paced; not the freshest sample",
        ("constant", "self-paced"),
    ),
    "exact": (
        "constant indexing delays with one constant step common to all users, nothing else: no jitter, no individual "
        "rates",
        ("constant",),
    ),
}


@final
@dataclass(frozen=True, eq=False)
class Certificate:
    """One argument that a damping keeps the users N-port passive together.

    Attributes:
        method: "rule": each user alone keeps the plain rule; "weighted": some weights d make the rule hold; "minimax"
            and "sum": the damping is the smallest largest or the smallest sum with weights; "exact": H(theta) is
            positive semidefinite.
        basis: what was declared: ages or index delays.
        covers: the ways of running it holds for, in words.
        modes: the same for programs, among "constant", "self-paced" and "freshest".
        damping: (N, 1 + number of weights) Ns/m, coefficients of the identity and of `network.weights`.
        holds: whether the argument goes through, up to round-off.
        margin: the part of all damping that could be given up together; 0.2 means that 80 % of it would do, -0.25 that
            it takes 125 %, -inf that some user on a delayed link has none. 1 when nothing needs damping.
        user_margin: (N,) the part of its damping that each user alone could give up; None for "exact", and for weights
            that fail or stand exactly on the bound it is `margin` for all.
        link_margin: (links,) by which part of itself the age sum (age or delay, both directions together) of each link
            alone could grow, in the order of `network.links`; inf where it is 0. None and equal for all as for
            `user_margin`.
    """

    method: CertificateMethod | Literal["weighted"]
    basis: Basis
    covers: str
    modes: tuple[Mode, ...]
    damping: Float
    holds: bool
    margin: float
    user_margin: Float | None
    link_margin: Float | None


def certify(
    network: Network,
    *,
    ages: npt.ArrayLike | None = None,
    index_delay: npt.ArrayLike | None = None,
    periods: npt.ArrayLike | None = None,
    damping: npt.ArrayLike | None = None,
) -> dict[str, Certificate]:
    """Certificates by each method: for a damping given, or for the smallest damping that each method finds.

    Args:
        network: linked users.
        ages: (N, N) s, the greatest age of the samples; see `age_sums_of`. Without ages and periods the delays of the
            network count as ages.
        index_delay: (N, N) steps; None with `periods` given rounds the delays of the network up to steps.
        periods: s, the longest step, one or (N,).
        damping: (N, 1 + number of weights) or (N,) Ns/m to check; None designs it.

    Returns:
        By method. Designed: "rule", "minimax", "sum"; checked: "rule", "weighted" (the best weights, so this decides
        what the rule with weights can prove). From index delays with one common period also "exact".

    Raises:
        NetworkError: inputs that contradict each other or are out of range.
        UnsupportedError: the exact test of different weights is too large.
    """
    age_sums = age_sums_of(network, ages=ages, index_delay=index_delay, periods=periods)
    result: dict[str, Certificate] = {}
    if damping is None:
        methods: tuple[CertificateMethod, ...] = ("rule", "minimax", "sum")
        for method in methods:
            beta = damping_for(network, method, ages=ages, index_delay=index_delay, periods=periods)
            d = method_fractions(network, age_sums, method)
            result[method] = _certificate(method, age_sums, beta, _check_fractions(network, age_sums, beta, d))
    else:
        beta = coefficients(network, damping)
        result["rule"] = _certificate(
            "rule", age_sums, beta, _check_fractions(network, age_sums, beta, age_sums.fractions)
        )
        result["weighted"] = _certificate("weighted", age_sums, beta, _check_best(network, age_sums, beta))
    if periods is not None and np.ptp(longest := check_periods(network, periods)) == 0:
        steps = index_delays_of(network, index_delay, longest)
        beta = (
            damping_for(network, "exact", index_delay=steps, periods=longest)
            if damping is None
            else coefficients(network, damping)
        )
        margin = 1.0 - exact_scaling(network, index_delay=steps, period=float(longest[0]), damping=beta)
        result["exact"] = _certificate("exact", age_sums, beta, (margin, None, None))
    return result


_Margins: TypeAlias = tuple[float, Float | None, Float | None]


def _certificate(
    method: CertificateMethod | Literal["weighted"], age_sums: AgeSums, beta: Float, margins: _Margins
) -> Certificate:
    covers, modes = _COVERS["exact" if method == "exact" else age_sums.basis]
    margin, user, link = margins
    return Certificate(
        method=method,
        basis=age_sums.basis,
        covers=covers,
        modes=modes,
        damping=beta,
        holds=margin >= -_ROUND_OFF,
        margin=margin,
        user_margin=user,
        link_margin=link,
    )


def _check_fractions(network: Network, age_sums: AgeSums, beta: Float, d: Float) -> _Margins:
    """Each user's damping against what the rule with weights d asks of it, as matrices."""
    own, springs = damping_matrices(network, beta), link_matrices(network)
    fractions = age_sums.seconds * d / d[:, None]
    need = np.zeros_like(own)
    for link, (i, j) in enumerate(network.links):
        need[i] += fractions[i, j] * springs[link]
        need[j] += fractions[j, i] * springs[link]
    user = 1.0 - _relative_norm(own, need)
    growth = np.full(len(network.links), np.inf)
    for link, (i, j) in enumerate(network.links):
        for a, b in ((i, j), (j, i)):
            if fractions[a, b] > 0:
                spare = _least_ratio(own[a] - need[a], fractions[a, b] * springs[link])
                growth[link] = min(growth[link], spare)
    return float(user.min()), user, growth


def _relative_norm(own: Float, need: Float) -> Float:
    """Largest eigenvalue of `own^(-1/2) need own^(-1/2)` for every user; 0 where nothing is needed."""
    ratio = np.zeros(len(own))
    root = inverse_roots(own)
    for i in range(len(own)):
        if need[i].any():
            ratio[i] = np.linalg.eigvalsh(root[i] @ need[i] @ root[i])[-1] if np.isfinite(root[i]).all() else np.inf
    return ratio


def _least_ratio(spare: Float, unit: Float) -> float:
    """Largest t with `spare - t unit` still positive semidefinite."""
    root = inverse_roots(unit[None])[0]
    return float(np.linalg.eigvalsh(root @ spare @ root)[0])


def _check_best(network: Network, age_sums: AgeSums, beta: Float) -> _Margins:
    """Whether any weights are known to do: all of them where one spring weight serves all, else three good choices."""
    best = _check_weighted(network, age_sums, beta)
    if single_weight(network, beta) is None:
        for d in (age_sums.fractions, minimax_fractions(network, age_sums)):
            other = _check_fractions(network, age_sums, beta, d)
            best = other if other[0] > best[0] else best
    return best


def _check_weighted(network: Network, age_sums: AgeSums, beta: Float) -> _Margins:
    """Whether any weights d make `B_i >= sum_j reach_ij K_ij d_j/d_i`.

    With `Q_ij = reach_ij |B_i^(-1/2) K_ij B_j^(-1/2)|` they exist where the Perron eigenvalue of Q is at most 1 (and
    only there, when one weight serves all). Then `M = I - Q` and its inverse say what one user or one link can spare:
    user i the part `1/(M^-1)_ii`, a link the growth `1/((M^-1)_ij + sqrt((M^-1)_ii (M^-1)_jj))` of Q_ij.
    """
    root = inverse_roots(damping_matrices(network, beta))
    springs = link_matrices(network)
    q = np.zeros((network.size, network.size))
    for link, (i, j) in enumerate(network.links):
        if age_sums.seconds[i, j] > 0:
            bare = not (np.isfinite(root[i]).all() and np.isfinite(root[j]).all())
            norm = np.inf if bare else np.linalg.norm(root[i] @ springs[link] @ root[j], ord=2)
            q[i, j] = q[j, i] = age_sums.seconds[i, j] * norm
    load = np.array([q[i, j] for i, j in network.links])
    if not np.isfinite(q).all():
        return -np.inf, np.full(network.size, -np.inf), np.full(len(load), -np.inf)
    largest = float(np.linalg.eigvalsh(q)[-1])
    margin = 1.0 - largest
    if margin <= _ROUND_OFF:
        growth = 1.0 / largest - 1.0
        return margin, np.full(network.size, margin), np.where(load > 0, growth, np.inf)
    inverse = np.linalg.inv(np.eye(network.size) - q)
    user = 1.0 / np.diag(inverse)
    with np.errstate(divide="ignore"):
        link_growth = (
            np.array([1.0 / (inverse[i, j] + np.sqrt(inverse[i, i] * inverse[j, j])) for i, j in network.links]) / load
        )
    return margin, user.astype(np.float64), link_growth.astype(np.float64)
