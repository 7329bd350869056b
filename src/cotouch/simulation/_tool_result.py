"""What tools, devices and couplings did in a run, as labelled variables."""

from typing import TypeAlias

import numpy as np
import numpy.typing as npt

from cotouch.arrays import Float
from cotouch.device import DEVICE_LEDGER, excess_bound
from cotouch.interaction import ToolRecord, Touching
from cotouch.simulation._batch import Outcome
from cotouch.simulation._prepare import Prepared

_Data: TypeAlias = dict[str, tuple[tuple[str, ...], Float]]

# Below this nobody has done anything: a share of it would be a share of round-off [J].
LEAST_ENERGY = 1e-15

UNITS = {
    "drive_work": ("J", "work so far of what pulls a user's proxies"),
    "touch_work": ("J", "work so far of a user's contacts and grasps on the body"),
    "touch_loss": ("J", "dissipated so far in a user's contacts and grasps"),
    "proxy": ("J", "kinetic energy of a user's proxies"),
    "touch_stored": ("J", "energy in a user's contacts and grasps"),
    "tool_position": ("m", "position y of a proxy"),
    "tool_velocity": ("m/s", "velocity w of a proxy"),
    "touch_force": ("N", "mean force of contacts or grasp on the proxy over the step"),
    "drive_force": ("N", "mean force of what pulls the proxy over the step"),
    "touching": ("1", "contacts that pushed in the step, or nodes held"),
    "device_position": ("m", "place of the device's tip as last measured, in the body's frame"),
    "device_force": ("N", "force at the tip that the device's motors hold"),
    "device_work": ("J", "work of the device's motors so far, the integral of force times velocity"),
    "human_work": ("J", "work of the hand's will on the device so far"),
    "device_loss": ("J", "dissipated so far in hand and device"),
    "device_energy": ("J", "energy of hand and device"),
    "device_residual": ("J", "energy - initial - work + loss of hand and device: zero but for round-off"),
    "coupling_work": ("J", "work of the coupling on the proxy so far"),
    "coupling_energy": ("J", "energy of the coupling: the tanks of both ends, and what is on its way between them"),
    "coupling_excess": ("J", "most that the coupling has given both sides together so far: passive if bounded"),
    "coupling_bound": (
        "J",
        "what the excess can at most come to, with the speed and the servo periods that there were",
    ),
}
# Those above that every tool has; the rest belong to tools with a device.
_LOSSES = ("hand_loss", "viscous_loss", "coulomb_loss")
_ENERGIES = ("kinetic", "hand_energy", "potential")


def tool_variables(prepared: Prepared, outcome: Outcome) -> _Data:
    """Variables of tools in the order of the scenario; empty without tools. What a tool has not is NaN.

    Args:
        prepared: what was run.
        outcome: what it recorded.
    """
    record, touching = outcome.tools, prepared.touching
    if record is None or touching is None:
        return {}
    order = np.array(prepared.tool)
    found = {
        "tool_position": record.place[..., :3],
        "tool_velocity": record.rate[..., :3],
        "touch_force": record.force[..., :3],
        "drive_force": record.drive[..., :3],
        "touching": record.touching,
    }
    own = {name: (("tool", "step", "axis")[: values.ndim], values[order]) for name, values in found.items()}
    return own | _device_variables(touching, record, order, "tool")


def leading_variables(prepared: Prepared, outcome: Outcome) -> _Data:
    """Variables of the devices that lead rigid tools, in the order of these, each named `rigid_` and as of tools.

    Args:
        prepared: what was run.
        outcome: what it recorded.
    """
    record, leading = outcome.led, prepared.leading
    if record is None or leading is None:
        return {}
    found = _device_variables(leading.touching, record, np.array(prepared.led), "rigid_tool")
    return {f"rigid_{name}": values for name, values in found.items()}


def _device_variables(touching: Touching, record: ToolRecord, order: npt.NDArray[np.int_], dimension: str) -> _Data:
    """What devices and couplings did; empty where there are none."""
    held = touching.couplings.device[order] >= 0
    if not held.any():
        return {}

    def bound(tool: int) -> float:
        fastest, longest = (float(ledger[name][tool].max()) for name in ("fastest", "longest"))
        largest = float(np.linalg.norm(record.device_force[tool], axis=-1).max())
        unpaid = float(record.coupling[2, tool].max())
        return excess_bound(
            touching.devices,
            touching.couplings,
            tool,
            fastest=fastest,
            longest=longest,
            largest=largest,
            unpaid=unpaid,
        )

    ledger = {name: record.device_ledger[index] for index, name in enumerate(DEVICE_LEDGER)}
    limits = [bound(int(tool)) if touching.couplings.device[tool] >= 0 else np.nan for tool in range(order.size)]
    found = {
        "device_position": record.device_place[..., :3],
        "device_force": record.device_force[..., :3],
        "device_work": ledger["work"],
        "human_work": ledger["human"],
        "device_loss": np.sum([ledger[name] for name in _LOSSES], axis=0),
        "device_energy": np.sum([ledger[name] for name in _ENERGIES], axis=0),
        "device_residual": ledger["residual"],
        "coupling_work": record.coupling[0],
        "coupling_energy": ledger["tank"] + record.coupling[3],
        "coupling_excess": record.coupling[1],
        "coupling_bound": np.array(limits),
    }
    return {
        name: (
            (dimension, "step", "axis")[: values.ndim],
            np.where(held.reshape(-1, *(1,) * (values.ndim - 1)), values[order], np.nan),
        )
        for name, values in found.items()
    }


def tool_attributes(data: _Data) -> dict[str, float]:
    """What a run says about couplings and devices in one number each: the greatest of tools and rigid tools."""
    each = [_attributes(data, prefix) for prefix in ("", "rigid_") if f"{prefix}coupling_excess" in data]
    return {name: max(one[name] for one in each) for name in (each[0] if each else ())}


def _attributes(data: _Data, prefix: str) -> dict[str, float]:
    values = {name: data[prefix + name][1] for name in UNITS if prefix + name in data}
    flows = [values[name] for name in ("device_work", "human_work", "device_loss", "device_energy")]
    in_play = max(float(np.nanmax(np.abs(flow))) for flow in flows)
    residual = float(np.nanmax(np.abs(values["device_residual"])))
    return {
        "device_residual": residual / max(in_play, LEAST_ENERGY),
        "coupling_excess": float(np.nanmax(values["coupling_excess"])),
    }
