"""The energy that each block of the paper's Fig. 2 gave and took in a run, from what crosses its ports.

Work at a port is counted on the spot, force times the motion of whatever it acts on: of motors on devices, of couplings
on proxies, of contacts on proxies and on the body. A block is passive if what it has given, all its ports together,
never exceeds what it was given plus a constant; here every run starts from rest, relaxed, so the constant is 0 or a
bound that belongs to the block.
"""

from dataclasses import dataclass
from typing import Any, final

import numpy as np

from cotouch.arrays import Float, Long
from cotouch.device import DEVICE_LEDGER, excess_bound
from cotouch.simulation import TOOL_LEDGER, USER_LEDGER, Outcome, Prepared

_BOOK = {name: row for row, name in enumerate(USER_LEDGER + TOOL_LEDGER)}
_DEVICE = {name: row for row, name in enumerate(DEVICE_LEDGER)}
_ENERGIES = ("kinetic", "hand_energy", "potential")
_LOSSES = ("hand_loss", "viscous_loss", "coulomb_loss")


@final
@dataclass(frozen=True, kw_only=True)
class TwoPort:
    """One tool's coupling.

    Attributes:
        user: whose, from 0.
        law: name of the coupling.
        excess: most that it had given device and proxy together at the end of any step [J]. A virtual coupling is paid
            for by the device's own damping and (for its encoder) friction, whose losses count as given to the coupling.
        bound: d², which the excess must not exceed [J].
        saturated: ticks at which the motors could not do what was asked. A virtual coupling asks for no more than they
            can, but for what its proxy's motion in the step adds.
    """

    user: int
    law: str
    excess: float
    bound: float
    saturated: int

    def numbers(self) -> dict[str, object]:
        """For JSON."""
        return {
            "user": self.user + 1,
            "law": self.law,
            "excess_j": self.excess,
            "bound_j": self.bound,
            "saturated": self.saturated,
        }


@final
@dataclass(frozen=True, kw_only=True, eq=False)
class Blocks:
    """What the ports of the blocks say, step by step in the order of the ledger.

    Attributes:
        time: end of every step of every user, in order, (events,) [s].
        human: work so far of all hands, on devices, or on proxies that have none, (events,) [J].
        device: taken so far by hands and devices: human work and the work of the motors, (events,) [J].
        coupling: taken so far by couplings, (events,) [J].
        contact: taken so far by proxies with their contacts, (events,) [J].
        object: taken so far by all copies, `Σ_i Σ_k v̂_iᵀ f_i T_i`, (events,) [J].
        given: most that the contacts of one user had ever given body and proxies together [J].
        split: largest imbalance of any user's proxies alone. A step solves proxies and body together; the sum of their
            energies is exact, the share of each as good as the solve [J].
        couplings: of the tools with a device.
        device_residual: largest imbalance in the ledger of a device with its hand, of the energy in play there.
        energy_residual: of copies, links, proxies and contacts, of the energy in play.
        aged: energy that the age of samples has put into the links by the end [J].
        in_play: largest energy that was stored, supplied or dissipated in them [J].
        finished: whether the motion stayed within floating point.
    """

    time: Float
    human: Float
    device: Float
    coupling: Float
    contact: Float
    object: Float
    given: float
    split: float
    couplings: tuple[TwoPort, ...]
    device_residual: float
    energy_residual: float
    aged: float
    in_play: float
    finished: bool

    @property
    def bound(self) -> float:
        """What all couplings together may have given away [J]."""
        return sum(port.bound for port in self.couplings)

    @property
    def port_margin(self) -> float:
        """Least of `Σ v̂ᵀ f T` over all users and all times [J]: above 0, the copies are N-port passive from rest."""
        return float(self.object.min(initial=0.0))

    @property
    def human_margin(self) -> float:
        """Least work of all hands over time [J]."""
        return float(self.human.min(initial=0.0))

    @property
    def used(self) -> float:
        """Largest part of its d² that any PSPM coupling used."""
        return max((port.excess / port.bound for port in self.couplings if port.law != "host_force"), default=0.0)

    @property
    def virtual(self) -> float:
        """Most that any virtual coupling gave beyond what its device's own damping paid for [J]."""
        return max((port.excess for port in self.couplings if port.law == "host_force"), default=0.0)

    def numbers(self) -> dict[str, Any]:
        """For JSON."""
        return {
            "finished": self.finished,
            "object_least_work_j": self.port_margin,
            "contact_most_given_j": self.given,
            "proxies_alone_j": self.split,
            "couplings": [port.numbers() for port in self.couplings],
            "human_least_work_j": self.human_margin,
            "human_work_j": float(self.human[-1]),
            "device_residual": self.device_residual,
            "energy_residual": self.energy_residual,
            "energy_from_age_j": self.aged,
            "energy_in_play_j": self.in_play,
        }


def blocks(prepared: Prepared, outcome: Outcome) -> Blocks:
    """Reads the ports of a run that recorded every step and whose tools come in the order of their users.

    Args:
        prepared: what was run.
        outcome: what came of it.
    """
    touching, record, tools = prepared.touching, outcome.record, outcome.tools
    assert touching is not None
    assert tools is not None
    assert record.every == 1
    users = int(record.users.shape[1])
    owner = np.repeat(np.arange(users), np.diff(touching.first))
    joined = touching.couplings.device >= 0
    drive, touched = record.users[_BOOK["drive_work"]], record.users[_BOOK["touch_work"]]
    ports = record.users[_BOOK["supplied"]]
    ledger = tools.device_ledger
    motors, will = ledger[_DEVICE["work"]], ledger[_DEVICE["human"]]
    pulled = tools.coupling[0]

    def of_users(values: Float) -> Float:
        total = np.zeros((users, values.shape[1]))
        np.add.at(total, owner, values)
        return total

    # Proxies move exactly by T ŵ in a step, so force times change of place is the work on them.
    moved = np.diff(tools.place[..., :3], axis=1, prepend=tools.place[:, :1, :3])
    on_proxies = of_users(np.cumsum((tools.force[..., :3] * moved).sum(axis=2), axis=1))
    moving = record.users[_BOOK["proxy"]]
    alone = drive + on_proxies - (moving - moving[:, :1])
    direct = drive - of_users(pulled)
    order = np.asarray(prepared.schedule.order[: outcome.events], dtype=np.int64)
    step = _steps(order, users)
    reached = np.arange(int(record.users.shape[2]))[None, :] <= outcome.taken[:, None]

    def in_order(values: Float) -> Float:
        return np.cumsum(values[order, step] - values[order, step - 1])

    whole = record.ticks[:, : int(outcome.taken[prepared.schedule.reference]) + 1]
    in_play = float(np.abs(whole[:4]).max(initial=0.0))
    energy = sum(ledger[_DEVICE[name]] for name in _ENERGIES)
    flows = [motors, will, energy, sum(ledger[_DEVICE[name]] for name in _LOSSES)]
    with_device = float(max(np.abs(flow).max(initial=0.0) for flow in flows))
    unclosed = float(np.abs(ledger[_DEVICE["residual"]]).max(initial=0.0))
    residual = float(np.abs(whole[4]).max(initial=0.0))
    return Blocks(
        time=prepared.schedule.end[order, step - 1],
        human=in_order(of_users(will) + direct),
        device=in_order(of_users(will + motors)),
        coupling=in_order(-of_users(motors + pulled)),
        contact=in_order(drive - touched),
        object=in_order(touched + ports),
        given=float(np.where(reached, touched + on_proxies, 0.0).max()),
        split=float(np.abs(np.where(reached, alone, 0.0)).max()),
        couplings=tuple(_two_port(prepared, outcome, int(t), int(owner[t])) for t in np.flatnonzero(joined)),
        device_residual=unclosed / with_device if with_device > 0.0 else unclosed,
        energy_residual=residual / in_play if in_play > 0.0 else residual,
        aged=float(whole[3, -1]),
        in_play=in_play,
        finished=outcome.events == prepared.schedule.order.size,
    )


def _steps(order: Long, users: int) -> Long:
    """Of every event, which step of its user it is, from 1."""
    step = np.zeros(order.size, dtype=np.int64)
    for user in range(users):
        own = order == user
        step[own] = np.arange(1, int(own.sum()) + 1)
    return step


def _two_port(prepared: Prepared, outcome: Outcome, tool: int, user: int) -> TwoPort:
    """Excess of a coupling at the ends of its user's steps, and d²."""
    touching, tools = prepared.touching, outcome.tools
    assert touching is not None
    assert tools is not None
    device = int(touching.couplings.device[tool])
    last = int(outcome.taken[user])
    ledger = tools.device_ledger[:, tool, : last + 1]
    given = ledger[_DEVICE["work"]] + tools.coupling[0, tool, : last + 1]
    saturated = int(ledger[_DEVICE["saturated"], -1])
    table = prepared.scenario.proxies[prepared.tool.index(tool)].device
    assert table is not None
    if table.coupling == "host_force":
        given = given - ledger[_DEVICE["viscous_loss"]] - ledger[_DEVICE["coulomb_loss"]]
        unpaid = float(tools.coupling[2, tool, last])
        return TwoPort(user=user, law="host_force", excess=float(given.max()), bound=unpaid, saturated=saturated)
    given = given - ledger[_DEVICE["declared"]]
    force = float(touching.devices.servos.force[device])
    bound = excess_bound(
        touching.devices,
        touching.couplings,
        tool,
        longest=float(ledger[_DEVICE["longest"], -1]),
        fastest=float(ledger[_DEVICE["fastest"], -1]),
        largest=force if np.isfinite(force) else 0.0,
        unpaid=0.0,
    )
    return TwoPort(user=user, law=table.coupling, excess=float(given.max()), bound=bound, saturated=saturated)
