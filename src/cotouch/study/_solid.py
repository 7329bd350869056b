"""Theorem 1 on a solid in three dimensions, with all four blocks of the paper's Fig. 2 for each of five users."""

from dataclasses import dataclass
from typing import final

import numpy as np

from cotouch.arrays import Float, Long
from cotouch.network import Network
from cotouch.scenario import Mode
from cotouch.simulation import Outcome, Prepared, prepare, run_batch
from cotouch.study._blocks import Blocks, blocks
from cotouch.study._data import five_users
from cotouch.study._scene import DURATION, FRAMES, RELEASE, SHAPE, SMALL, SPACING, scene
from cotouch.study._theorem import Claim

MODES: tuple[Mode, ...] = ("constant", "freshest")
# Share of the rule's damping in the run that shows what it is for: by the freshest sample, whose ages vary most.
BELOW = 0.08
# J: round-off beside the tenths of a joule that the hands put in.
_ROUNDING = 1e-12
# s: over which a force at rest is averaged; proxies may ring at the step's own frequency without moving.
_MEAN = 1.0
_REST = RELEASE - 1.0 / FRAMES


@final
@dataclass(frozen=True, kw_only=True, eq=False)
class AtRest:
    """A collaboration at rest, everyone holding.

    Attributes:
        copies: displacement of all nodes in every copy, (users, n, 3) [m].
        force: of every user's tool on its copy, mean over the last second, (users, 3) [N].
        place: of every tool, (users, 3) [m].
        balance: how far K(x̄ − x_d), summed where a tool holds, is from that tool's force, all tools; and what it is
            elsewhere, where it should vanish; relative to the sum of forces.
        apart: largest distance of a node in a copy from the average copy [m].
    """

    copies: Float
    force: Float
    place: Float
    balance: float
    apart: float


@final
@dataclass(frozen=True, kw_only=True, eq=False)
class Collaboration:
    """One run.

    Attributes:
        mode: how samples are chosen.
        blocks: what crossed the ports.
        rest: while everyone holds.
        left: largest distance of a node from the average copy at the end, relative to that at rest.
        damping: largest B_i, all nodes together [Ns/m].
        rates: mean steps per second of a user.
    """

    mode: Mode
    blocks: Blocks
    rest: AtRest
    left: float
    damping: float
    rates: float


@final
@dataclass(frozen=True, kw_only=True, eq=False)
class SolidFindings:
    """What was found.

    Attributes:
        runs: by mode, under the rule's damping.
        below: the ports of the run with `BELOW` of it.
        claims: by what they say, each with one claim for each mode, in the order of `runs`.
        places: of all nodes at rest without forces, (n, 3) [m].
        triangles: of the skin, indices of nodes, (F, 3).
        radii: of the tools, (users,) [m].
    """

    runs: dict[Mode, Collaboration]
    below: Blocks
    claims: tuple[tuple[Claim, ...], ...]
    places: Float
    triangles: Long
    radii: Float

    @property
    def holds(self) -> bool:
        """Whether all claims do, and too little damping shows."""
        return all(claim.holds for row in self.claims for claim in row) and self.below.port_margin < 0.0

    @property
    def residual(self) -> float:
        """Largest energy residual of these runs, devices included, of the energy in play."""
        every = [*(run.blocks for run in self.runs.values()), self.below]
        return max(max(found.energy_residual, found.device_residual) for found in every)

    def numbers(self) -> dict[str, object]:
        """For JSON."""
        return {
            "nodes": int(self.places.shape[0]),
            "claims": [
                {"mode": mode, **claim.numbers()}
                for row in self.claims
                for mode, claim in zip(self.runs, row, strict=True)
            ],
            "all_hold": self.holds,
            "runs": {
                mode: {
                    **run.blocks.numbers(),
                    "force_at_rest_n": np.linalg.norm(run.rest.force, axis=1).tolist(),
                    "apart_at_rest_m": run.rest.apart,
                    "largest_damping_ns_m": run.damping,
                    "steps_per_s": run.rates,
                }
                for mode, run in self.runs.items()
            },
            "below": {"share_of_the_rule": BELOW, **self.below.numbers()},
        }


def solid(network: Network, *, quick: bool = False) -> SolidFindings:
    """Five users at one block.

    Args:
        network: of the five users.
        quick: a smaller block.
    """
    shape = SMALL if quick else SHAPE
    runs: dict[Mode, Collaboration] = {}
    prepared = None
    for mode in MODES:
        prepared = prepare(scene(network, mode, shape=shape))
        runs[mode] = collaboration(prepared, run_batch(prepared))
    assert prepared is not None
    body = prepared.body
    assert body.skin is not None
    few = prepare(scene(network, MODES[1], shape=shape, scale=BELOW))
    return SolidFindings(
        runs=runs,
        below=blocks(few, run_batch(few)),
        claims=claims(list(runs.values())),
        places=body.rest,
        # A lattice's skin has a node at every vertex.
        triangles=body.skin.nodes[:, 0].astype(np.int64)[body.skin.triangles],
        radii=np.array([tool.radius for tool in prepared.scenario.proxies]),
    )


def warm_up() -> None:
    """Compiles what a body with tools needs, into the cache on disk."""
    network = Network.read(five_users())
    run_batch(prepare(scene(network, "constant", shape=SMALL).replace(steps__duration=0.05)))


def collaboration(prepared: Prepared, outcome: Outcome) -> Collaboration:
    """What one run shows.

    Args:
        prepared: what was run.
        outcome: what came of it.
    """
    timing, model = prepared.schedule, prepared.model
    rest = _rest(prepared, outcome)
    last = np.array([model.to_nodes(copy) for copy in outcome.position])
    return Collaboration(
        mode=timing.mode,
        blocks=blocks(prepared, outcome),
        rest=rest,
        left=_apart(last) / rest.apart,
        damping=float(prepared.local_damping[:, 0].max()) * prepared.body.nodes,
        rates=float(timing.count.mean()) / DURATION,
    )


def _apart(copies: Float) -> float:
    return float(np.linalg.norm(copies - copies.mean(axis=0), axis=2).max())


def _rest(prepared: Prepared, outcome: Outcome) -> AtRest:
    """The collaboration half a second before the hands let go, and the paper's eq. (6) node by node."""
    body, timing, tools = prepared.body, prepared.schedule, outcome.tools
    assert tools is not None
    frame = int(np.argmin(np.abs(outcome.frame_time - _REST)))
    copies = np.array([prepared.model.to_nodes(copy) for copy in outcome.frames[frame]])
    users = copies.shape[0]
    force, place = np.zeros((users, 3)), np.zeros((users, 3))
    for user in range(users):
        end, length = timing.end[user, : timing.count[user]], timing.length[user, : timing.count[user]]
        seen = np.flatnonzero((end > _REST - _MEAN) & (end <= _REST))
        force[user] = -np.average(tools.force[user, seen + 1, :3], axis=0, weights=length[seen])
        place[user] = tools.place[user, seen[-1] + 1, :3]
    pulled = body.apply(body.stiffness, copies.mean(axis=0))
    reach = np.array([tool.radius for tool in prepared.scenario.proxies]) + 1.5 * SPACING
    away = np.linalg.norm(body.rest + copies - place[:, None], axis=2)  # of every node in each user's copy
    away = np.where(away <= reach[:, None], away, np.inf)
    nearest = np.where(np.isfinite(away.min(axis=0)), away.argmin(axis=0), int(users))
    off = float(np.linalg.norm(pulled[nearest == users], axis=1).sum())
    for user in range(users):
        off += float(np.linalg.norm(pulled[nearest == user].sum(axis=0) - force[user]))
    size = float(np.linalg.norm(force, axis=1).sum())
    return AtRest(
        copies=copies, force=force, place=place, balance=off / size if size > 0.0 else np.inf, apart=_apart(copies)
    )


def claims(runs: list[Collaboration]) -> tuple[tuple[Claim, ...], ...]:
    """What must hold of every run, one row for each statement."""
    return tuple(zip(*(_claims(run) for run in runs), strict=True))


def _claims(run: Collaboration) -> list[Claim]:
    found = run.blocks
    whole = found.human + _steady(found)
    return [
        Claim(
            item="Shared object",
            text="Copies with synchronisation, N ports together: least Σ v̂ᵀf T over all times",
            measured=found.port_margin,
            unit="J",
            sign="≥",
            limit=-_ROUNDING,
        ),
        Claim(
            item="Proxy, contact",
            text="Most that a contact or grasp ever gave body and proxy together",
            measured=found.given,
            unit="J",
            sign="≤",
            limit=_ROUNDING,
        ),
        Claim(
            item="Coupling",
            text="PSPM: largest ∫τᵀq̇ dt + Σ τᵀŵ T, as a share of its d²",
            measured=found.used,
            unit="",
            sign="≤",
            limit=1.0,
        ),
        Claim(
            item="Coupling",
            text="Virtual coupling: the same beyond what its device’s own damping took",
            measured=found.virtual,
            unit="J",
            sign="≤",
            limit=_ROUNDING,
        ),
        Claim(
            item="Hand, device",
            text="Ledgers of devices and hands: residual of the energy in play there",
            measured=found.device_residual,
            unit="",
            sign="≤",
            limit=1e-10,
        ),
        Claim(
            item="The whole",
            text="Least work of all hands over all times, beside the couplings’ Σ d²",
            measured=found.human_margin + found.bound,
            unit="J",
            sign="≥",
            limit=0.0,
        ),
        Claim(
            item="The whole",
            text="Ledgers of copies, links, proxies and contacts: residual of the energy in play",
            measured=found.energy_residual,
            unit="",
            sign="≤",
            limit=1e-10,
        ),
        Claim(
            item="The whole",
            text="What the four blocks took, together, is the work of the hands: largest difference",
            measured=float(np.abs(whole).max()),
            unit="J",
            sign="≤",
            limit=_ROUNDING,
        ),
        Claim(
            item="At rest, (6)",
            text="K(x̄ − x_d) where a tool holds is that tool’s force, and 0 elsewhere: difference, relative to Σ|f|",
            measured=run.rest.balance,
            unit="",
            sign="≤",
            limit=0.02,
        ),
        Claim(
            item="Released, (5)",
            text="Copies agree: largest distance of a node from the average copy at the end, beside that while held",
            measured=run.left,
            unit="",
            sign="≤",
            limit=0.02,
        ),
    ]


def _steady(found: Blocks) -> Float:
    """Minus what all blocks have taken."""
    return -(found.device + found.coupling + found.contact + found.object)
