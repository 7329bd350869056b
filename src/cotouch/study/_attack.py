"""The worst that hands can do: of a whole family of force profiles, the one that gets most energy out.

From rest the copies' answer is linear in the forces, so the work `W = sum T v̂ f` of all hands is a quadratic form in
the coefficients of any family of profiles. Its smallest eigenvalue relative to `sum T f²` decides whether any member of
the family gets energy out; its eigenvector is the profile that gets most. The family here: every user pushes with any
polygon over time. As steps and delays are constant, one answer for each user and shifts of it give the whole form.
"""

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, final

import numpy as np
from scipy import linalg

from cotouch.arrays import Float
from cotouch.body import canonical
from cotouch.network import Network
from cotouch.simulation import simulate
from cotouch.study._data import free

if TYPE_CHECKING:
    import xarray as xr


# Corners of a polygon and their distance: slow enough to find the worst at low frequency, where the rule is tightest.
CORNERS = 40
SPACING = 1.0
_TAIL = 10.0


@final
@dataclass(frozen=True, kw_only=True, eq=False)
class Attack:
    """The worst force profile of the family.

    Attributes:
        profiles: dimension of the family.
        least: smallest work of all profiles with `sum T f² = 1 N²s` [J]; below 0 energy was got out.
        run: the run in which users push just so.
    """

    profiles: int
    least: float
    run: "xr.Dataset"

    @property
    def worked(self) -> float:
        """The same work as the run's own ledger has it [J]."""
        return float(self.run["supplied_total"].values[-1])

    @property
    def returned(self) -> float:
        """What hands got out, as a share of the most energy in play; below 0: put in."""
        return -self.worked / float(self.run.attrs["energy_in_play"])


def worst_force(network: Network, *, period: float, corners: int = CORNERS, **synchronisation: Any) -> Attack:
    """Finds and plays the worst profile.

    Args:
        network: linked users.
        period: T of all users [s].
        corners: of every user's polygon.
        synchronisation: options of the scenario's table, such as `damping` and `damping_scale`.
    """
    duration = (corners + 1) * SPACING + _TAIL
    users, shift = network.size, round(SPACING / period)
    hat = 1.0 - np.abs((np.arange(2 * shift) + 0.5) / shift - 1.0)
    # lagged[i, j, 1 + d]: work of user j's hat d corners after the hat of user i that moves it; -1 overlaps by half.
    lagged = np.zeros((users, users, corners + 1))
    for i in range(users):
        hand = _hand(i, [0.0, 1.0, 0.0])
        run = simulate(free(network, duration=duration, period=period, hands=[hand], start=False, **synchronisation))
        steps_taken: Float = np.diff(run["position"].values[:, :, 0, 0], axis=1)  # T v̂
        lagged[i, :, 0] = (steps_taken[:, :shift] * hat[shift:]).sum(axis=1)
        for d in range(corners):
            lagged[i, :, 1 + d] = (steps_taken[:, d * shift : (d + 2) * shift] * hat).sum(axis=1)
    work = np.zeros((users, corners, users, corners))
    for m in range(corners):
        first = max(m - 1, 0)
        work[:, m, :, first:] = lagged[:, :, first - m + 1 : corners - m + 1]
    form = work.reshape(users * corners, -1)
    # The square of a hat, and of a hat with the next one.
    alone, beside = period * float(hat @ hat), period * float(hat[shift:] @ hat[:shift])
    beside_by = np.eye(corners, k=1) + np.eye(corners, k=-1)
    size = np.kron(np.eye(users), alone * np.eye(corners) + beside * beside_by)
    least, profile = linalg.eigh((form + form.T) / 2.0, size, subset_by_index=(0, 0))
    shape = canonical(least, profile, size.astype(np.float64), 0.0)[:, 0].reshape(users, corners)
    hands = [_hand(i, [0.0, *shape[i].tolist(), 0.0]) for i in range(users)]
    return Attack(
        profiles=users * corners,
        least=float(least[0]),
        run=simulate(free(network, duration=duration, period=period, hands=hands, start=False, **synchronisation)),
    )


def _hand(user: int, heights: list[float]) -> dict[str, object]:
    path = [[k * SPACING, height] for k, height in enumerate(heights)]
    return {"user": user + 1, "kind": "force", "path": path}
