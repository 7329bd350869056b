"""Theorem 1, its three items, the cases after it and what follows from it, each with a measured number."""

from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal, final

import numpy as np

from cotouch.arrays import Float
from cotouch.network import Network
from cotouch.scenario import Scenario
from cotouch.simulation import at_times, simulate
from cotouch.study._attack import CORNERS, Attack, worst_force
from cotouch.study._data import START, free

if TYPE_CHECKING:
    import xarray as xr


_STIFFNESS = 100.0  # N/m: the object's own spring to the ground where it has one
_REST = 0.02  # m: its rest x_d, off zero so that a lost x_d would show
_EXTRA = 2.0  # Ns/m
# Ns/m: hands that take most of what the copies hold before their own damping does.
_BRAKE = 100.0
_PUSHES = (3.0, 2.0)  # N: of two users together
_NODES = 4
SEED = 7
# Links this many times stiffer, for the consequence that needs "perfect synchronisation".
_STIFFER = (1.0, 10.0, 100.0)


@final
@dataclass(frozen=True, kw_only=True)
class Claim:
    """A statement of the paper with its number.

    Attributes:
        item: where the paper says it.
        text: what it says.
        measured: the number.
        unit: of the number.
        sign: how the number must compare with the limit.
        limit: what it is held against.
    """

    item: str
    text: str
    measured: float
    unit: str
    sign: Literal["≤", "≥"]
    limit: float

    @property
    def holds(self) -> bool:
        """The verdict."""
        return self.measured <= self.limit if self.sign == "≤" else self.measured >= self.limit

    def numbers(self) -> dict[str, object]:
        """For JSON."""
        return {
            "item": self.item,
            "claim": self.text,
            "measured": self.measured,
            "unit": self.unit,
            "must_be": f"{self.sign} {self.limit:g}",
            "holds": self.holds,
        }


@final
@dataclass(frozen=True, kw_only=True, eq=False)
class Theorem:
    """All claims, and the runs behind them.

    Attributes:
        claims: in the paper's order.
        attack: the worst hands against the rule's damping.
        restless: the run with steps of every user's own that change all the time.
        released: with K = 0 and with K = 100 N/m, by name.
        offsets: `‖[P + I⊗K/N](x − 1⊗x_d)‖` of each over time, by name [N].
        held: users who hold different places of a grounded object.
        chains: a chain of nodes, "free" and "grounded".
        single: relative error of "a single user feels K(x−x_d)" with links 1, 10 and 100 times as stiff.
        agreed: where the users of the free object agree [m].
        translation: how far the free chain has moved as a whole [m].
    """

    claims: tuple[Claim, ...]
    attack: Attack
    restless: "xr.Dataset"
    released: "dict[str, xr.Dataset]"
    offsets: dict[str, Float]
    held: "xr.Dataset"
    chains: "dict[str, xr.Dataset]"
    single: tuple[float, ...]
    agreed: float
    translation: float

    stiffer = _STIFFER
    """How many times as stiff the links of `single` are."""
    stiffness = _STIFFNESS
    """K of the grounded object [N/m]."""
    rest = _REST
    """x_d of the object [m]."""

    @property
    def chain_rest(self) -> Float:
        """Rest of the chain's nodes, one after the other [m]."""
        return _chain_rest(self.chains["free"])

    @property
    def residual(self) -> float:
        """Largest energy residual of these runs, of the energy in play."""
        runs = [self.attack.run, self.restless, self.held, *self.released.values(), *self.chains.values()]
        return max(float(run.attrs["energy_residual"]) for run in runs)

    def numbers(self) -> dict[str, object]:
        """For JSON."""
        return {
            "claims": [claim.numbers() for claim in self.claims],
            "all_hold": all(claim.holds for claim in self.claims),
            "single_user_error": dict(zip(map(str, _STIFFER), self.single, strict=True)),
        }


def theorem(network: Network, *, period: float, corners: int = CORNERS) -> Theorem:
    """Measures every claim on one network.

    Args:
        network: connected.
        period: T of the users, where it is constant [s].
        corners: of the polygons that the worst hands push.
    """
    attack = worst_force(network, period=max(period, 5e-3), corners=corners)
    restless = simulate(_restless(network, period))
    released, offsets = _released(network, period)
    held = simulate(_holding(network, period))
    chains = {kind: simulate(_chain(network, period, ground=kind == "grounded")) for kind in ("free", "grounded")}
    single = tuple(_single(network, period, factor) for factor in _STIFFER)
    agreement = _last(released["free"])[:, 0]
    moved = {kind: _last(run) - _chain_rest(run) for kind, run in chains.items()}
    runs = [attack.run, restless, held, *released.values(), *chains.values()]
    balance = _imbalance(held)
    total = sum(_PUSHES)
    claims = (
        Claim(
            item="Item 1",
            text=f"No hands get energy out of users at rest: the least work of {attack.profiles} independent force "
            "profiles and all their mixtures, for each N²s of force",
            measured=attack.least,
            unit="J",
            sign="≥",
            limit=0.0,
        ),
        Claim(
            item="Item 1",
            text="The worst of these mixtures, played: work of the hands by the ledger of the run",
            measured=attack.worked,
            unit="J",
            sign="≥",
            limit=0.0,
        ),
        Claim(
            item="Item 1",
            text="Hands that brake copies whose springs start tensed, every user with steps of its own that change all "
            "the time, get no more out than was in: V(0) + min Σ T v̂ᵀf",
            measured=float(restless.attrs["passivity_margin"]),
            unit="J",
            sign="≥",
            limit=0.0,
        ),
        Claim(
            item="Item 1",
            text="The ledger balances in all these runs: residual relative to the energy in play",
            measured=max(float(run.attrs["energy_residual"]) for run in runs),
            unit="",
            sign="≤",
            limit=1e-10,
        ),
        *(
            Claim(
                item="Item 2",
                text=f"Released with extra damping, {label}: what is left of ‖[P + I⊗K/N](x − 1⊗x_d)‖ at the end",
                measured=float(offsets[name][-1] / offsets[name][0]),
                unit="",
                sign="≤",
                limit=1e-6,
            )
            for name, label in (("free", "K = 0"), ("grounded", f"K = {_STIFFNESS:g} N/m"))
        ),
        Claim(
            item="Item 3",
            text=f"At rest with K = {_STIFFNESS:g} N/m: |Σf − K(x̄ − x_d)| relative to Σ|f|",
            measured=balance,
            unit="",
            sign="≤",
            limit=1e-6,
        ),
        Claim(
            item="Case 1",
            text="K = 0: all users agree; largest |x_i − x̄| at the end",
            measured=float(np.abs(agreement - agreement.mean()).max()),
            unit="m",
            sign="≤",
            limit=1e-6,
        ),
        Claim(
            item="Case 2",
            text=f"Chain of {_NODES} nodes, K_ext = 0: all agree up to a rigid translation; largest deviation",
            measured=float(np.abs(moved["free"] - moved["free"].mean()).max()),
            unit="m",
            sign="≤",
            limit=1e-6,
        ),
        Claim(
            item="Case 3",
            text="Chain with its first node grounded, K_ext ≠ 0: x_i → x_d; largest |x_i − x_d|",
            measured=float(np.abs(moved["grounded"]).max()),
            unit="m",
            sign="≤",
            limit=1e-6,
        ),
        Claim(
            item="After (6)",
            text=f"Together users induce an average deformation: |K(x̄ − x_d) − Σf| when two of them push with "
            f"{total:g} N in all, relative",
            measured=abs(_STIFFNESS * _pushed(network, period, _PUSHES) - total) / total,
            unit="",
            sign="≤",
            limit=1e-6,
        ),
        Claim(
            item="After (6)",
            text="They balance with Σf = 0: |x̄ − x_d| when two users push with 4 N against each other",
            measured=abs(_pushed(network, period, (4.0, -4.0))),
            unit="m",
            sign="≤",
            limit=1e-8,
        ),
        Claim(
            item="After (6)",
            text="A single user feels K(x − x_d) if synchronisation is perfect: relative error with links "
            f"{_STIFFER[-1]:g} times as stiff",
            measured=single[-1],
            unit="",
            sign="≤",
            limit=0.02,
        ),
    )
    return Theorem(
        claims=claims,
        attack=attack,
        restless=restless,
        released=released,
        offsets=offsets,
        held=held,
        chains=chains,
        single=single,
        agreed=float(agreement.mean()),
        translation=float(moved["free"].mean()),
    )


def _restless(network: Network, period: float) -> Scenario:
    """Copies that start apart, hands that only brake, and users who all change their steps all the time."""
    hands = [{"user": i + 1, "stiffness": 0.0, "damping": _BRAKE} for i in range(network.size)]
    base = free(network, duration=20.0, period=period, hands=hands)
    steps = {"duration": 20.0, "random": {"low": period / 2, "high": 2 * period}}
    return base.replace(seed=SEED, steps=steps)


def _released(network: Network, period: float) -> "tuple[dict[str, xr.Dataset], dict[str, Float]]":
    """A free and a grounded object let go, and how far they are from where (5) says that they go."""
    runs: dict[str, xr.Dataset] = {}
    offsets: dict[str, Float] = {}
    for name, stiffness in (("free", 0.0), ("grounded", _STIFFNESS)):
        body = {"kind": "point", "stiffness": stiffness, "rest": _REST}
        runs[name] = simulate(free(network, duration=25.0, period=period, body=body, extra_damping=_EXTRA))
        spring = network.stiffness_matrix().toarray() + stiffness / network.size * np.eye(network.size)
        places: Float = runs[name]["position"].values[:, :, 0, 0]
        offsets[name] = np.asarray(np.linalg.norm(spring @ (places - _REST), axis=0), dtype=np.float64)
    return runs, offsets


def _holding(network: Network, period: float) -> Scenario:
    """Everyone holds a place of their own for good, on a grounded object."""
    hands = [
        {"user": i + 1, "path": place, "stiffness": 60.0, "damping": 2.0}
        for i, place in enumerate(START[: network.size])
    ]
    body = {"kind": "point", "stiffness": _STIFFNESS, "rest": _REST}
    return free(network, duration=25.0, period=period, body=body, hands=hands, start=False)


def _imbalance(run: "xr.Dataset") -> float:
    """`|Σf − K(x̄ − x_d)| / Σ|f|` at the end."""
    forces: Float = run["force"].values[:, -1, 0]
    pulled = _STIFFNESS * (float(_last(run).mean()) - _REST)
    return abs(float(forces.sum()) - pulled) / float(np.abs(forces).sum())


def _chain(network: Network, period: float, *, ground: bool) -> Scenario:
    """A chain whose copies start deformed, each in its own way."""
    rng = np.random.default_rng(SEED)
    body = {"kind": "chain", "nodes": _NODES, "stiffness": 500.0, "damping": 2.0, "mass": 1.0}
    if ground:
        body |= {"ground": [1], "ground_stiffness": 500.0}
    base = free(network, duration=50.0, period=period, body=body, extra_damping=_EXTRA)
    return base.replace(initial={"position": rng.normal(0.03, 0.04, (network.size, _NODES)).tolist()})


def _chain_rest(run: "xr.Dataset") -> Float:
    """Rest of the chain's nodes, one after the other along x [m]."""
    import json

    spacing = float(json.loads(run.attrs["scenario"])["body"]["spacing"])
    return np.arange(_NODES, dtype=np.float64) * spacing


def _pushed(network: Network, period: float, forces: tuple[float, float]) -> float:
    """x̄ − x_d at the end when two users push a grounded object."""
    hands = [{"user": i + 1, "kind": "force", "path": force} for i, force in enumerate(forces)]
    body = {"kind": "point", "stiffness": _STIFFNESS, "rest": _REST}
    run = simulate(free(network, duration=40.0, period=period, body=body, hands=hands, start=False))
    return float(_last(run).mean()) - _REST


def _single(network: Network, period: float, factor: float) -> float:
    """How far the force on user 1, who holds the object alone, is from K(x_1 − x_d), relatively."""
    stiffer = network.replace(spring=network.spring * factor)
    hands = [{"user": 1, "path": 0.05, "stiffness": 2e4, "damping": 200.0}]
    body = {"kind": "point", "stiffness": _STIFFNESS, "rest": _REST}
    run = simulate(free(stiffer, duration=60.0, period=period, body=body, hands=hands, start=False))
    felt, place = float(run["force"].values[0, -1, 0]), float(_last(run)[0, 0])
    return abs(felt - _STIFFNESS * (place - _REST)) / abs(felt)


def _last(run: "xr.Dataset") -> Float:
    """Positions at the end, (users, nodes) [m]."""
    end = np.array([float(run["tick_time"].values[-1])])
    return np.asarray(at_times(run, "position", end)[0, :, :, 0], dtype=np.float64)
