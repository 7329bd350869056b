"""What people notice, and the figures of a comparison in multiples of it."""

from typing import TYPE_CHECKING, TypedDict

import numpy as np

from cotouch.arrays import Float
from cotouch.device import NOTICED
from cotouch.laboratory._study import Study, spread

if TYPE_CHECKING:
    import xarray as xr


def chosen(data: "xr.Dataset") -> str:
    """The tuning that counts: tuned, if it was."""
    return "tuned" if "tuned" in data["tuning"].values else "published"


def mean_cost(data: "xr.Dataset", *, hand: int = 0) -> dict[tuple[str, str, int], tuple[float, float]]:
    """Mean cost over tasks with half of its 95 % interval over draws, by law, network and number of users.

    Args:
        data: of `compare`.
        hand: which kind of hand.
    """
    cost = data["cost"].sel(tuning=chosen(data)).isel(hand=hand)
    result: dict[tuple[str, str, int], tuple[float, float]] = {}
    for l, law in enumerate(data["law"].values.tolist()):
        for n, network in enumerate(data["network"].values.tolist()):
            for u, users in enumerate(data["users"].values.tolist()):
                draws: Float = cost.values[l, n, u].mean(axis=0)
                known = draws[~np.isnan(draws)]
                result[law, network, users] = spread(known) if known.size else (float("nan"), float("nan"))
    return result


def multiples(data: "xr.Dataset", study: Study, law: str, network: str, users: int) -> dict[str, float]:
    """What is wrong with a law somewhere, in multiples of what people notice.

    Drag is compared with the damping of the hand itself, mass with that of the object, and stiffness with that of the
    other hands.

    Args:
        data: of `compare`.
        study: that it came from.
        law: name in the study.
        network: likewise.
        users: how many.
    """
    here = data.sel(law=law, network=network, users=users, tuning=chosen(data))
    mass = float(study.build_body().mass.diagonal().max())
    hand = study.hands[0]
    others = (users - 1) * hand.stiffness
    return {
        "place": float(here["place"].isel(hand=0).mean()) / NOTICED["place"],
        "force": float(here["force"].isel(hand=0).mean()) / NOTICED["force"],
        "drag": abs(float(here["felt_drag"])) / (NOTICED["drag"] * max(hand.damping, 1.0)),
        "mass": abs(float(here["felt_mass"]) / mass - 1.0) / NOTICED["mass"],
        "stiffness": abs(float(here["felt_stiffness"]) / others - 1.0) / NOTICED["stiffness"],
    }


def is_dangerous(data: "xr.Dataset", law: str, network: str, users: int, *, hand: int = 0) -> bool:
    """Whether pushes don't die away, or the motion leaves floating point.

    Args:
        data: of `compare`.
        law: name in the study.
        network: likewise.
        users: how many.
        hand: which kind of hand.
    """
    here = data.sel(law=law, network=network, users=users, tuning=chosen(data)).isel(hand=hand)
    return bool(here["dangerous"] == 1.0) or bool(np.isinf(here["cost"].values).any())


def broken(data: "xr.Dataset") -> dict[str, float]:
    """Laws that promise to make no energy beyond their initial one and did, and the most that one made beyond it [J].

    Args:
        data: of `compare`.
    """
    made = data["made"].sel(tuning=chosen(data))
    most = made.max(dim=[dim for dim in made.dims if dim != "law"])
    found = {law: float(most.sel(law=law)) for law in data["law"].values.tolist()}
    return {
        law: energy for law, energy in found.items() if energy > 0.0 and float(data["promises"].sel(law=law)) == 1.0
    }


def able(data: "xr.Dataset") -> list[str]:
    """Laws that promise to make no energy beyond their initial one, and did not.

    Args:
        data: of `compare`.
    """
    liars = broken(data)
    return [
        law for law in data["law"].values.tolist() if float(data["promises"].sel(law=law)) == 1.0 and law not in liars
    ]


def ours(data: "xr.Dataset", study: Study) -> str:
    """The law whose losing cases come first: the study's, or the one that promises most for least.

    Args:
        data: of the comparison, as `compare` gives it.
        study: what was compared.
    """
    if study.ours is not None:
        return study.ours
    costs = mean_cost(data)
    laws = data["law"].values.tolist()

    def total(law: str) -> float:
        values = [cost for (name, _, _), (cost, _) in costs.items() if name == law]
        return float(np.mean(values)) if np.isfinite(values).all() else float("inf")

    return min(able(data) or laws, key=total)


class Loss(TypedDict):
    """Where a rival costs less: its name, what ours and the rival cost, and the difference [J]."""

    network: str
    users: int
    hand: str
    task: str
    rival: str
    cost: float
    best: float
    gap: float


def losing(data: "xr.Dataset", study: Study) -> list[Loss]:
    """Where another law costs less than ours, for certain at 95 %, worst first; not one that broke its promise.

    Args:
        data: of `compare`.
        study: that it came from.
    """
    own, tuning, liars = ours(data, study), chosen(data), broken(data)
    cost = data["cost"].sel(tuning=tuning)
    laws = [law for law in data["law"].values.tolist() if law == own or law not in liars]
    found: list[Loss] = []
    for n, network in enumerate(data["network"].values.tolist()):
        for u, users in enumerate(data["users"].values.tolist()):
            for h, hand in enumerate(data["hand"].values.tolist()):
                for t, task in enumerate(data["task"].values.tolist()):
                    draws = {law: cost.sel(law=law).values[n, u, h, t] for law in laws}
                    known = {law: row[~np.isnan(row)] for law, row in draws.items()}
                    mine = known[own]
                    rivals = {
                        law: row
                        for law, row in known.items()
                        if law != own and row.size and not is_dangerous(data, law, network, users, hand=h)
                    }
                    if not mine.size or not rivals:
                        continue
                    rival = min(rivals, key=lambda law: float(rivals[law].mean()))
                    # The same draws for all, so it is their differences that tell.
                    gap, half = spread(mine - rivals[rival]) if np.isfinite(mine).all() else (float("inf"), 0.0)
                    if gap > half:
                        found.append(
                            {
                                "network": network,
                                "users": users,
                                "hand": hand,
                                "task": task,
                                "rival": rival,
                                "cost": float(mine.mean()),
                                "best": float(rivals[rival].mean()),
                                "gap": gap,
                            }
                        )
    return sorted(found, key=lambda entry: -entry["gap"])
