"""What tools that are rigid bodies did in a run: pose, force and torque."""

import numpy as np

from cotouch.arrays import Float, Int
from cotouch.body import SIGNS, axial, frame_of, shares_of, turn_vectors
from cotouch.scenario import RigidTool, rows_of
from cotouch.simulation._layout import Record
from cotouch.simulation._prepare import Prepared

_MASSES = 4  # of each tool
UNITS = {
    "rigid_position": ("m", "position of a rigid tool's handle"),
    "rigid_rotation": (
        "rad",
        "how a rigid tool has turned from its start: along the axis of turning, as long as the angle",
    ),
    "rigid_velocity": ("m/s", "velocity of a rigid tool's handle"),
    "rigid_spin": ("rad/s", "angular velocity of a rigid tool"),
    "rigid_force": ("N", "mean force of the hand on a rigid tool over the step; the hand feels the opposite"),
    "rigid_torque": (
        "N m",
        "mean torque of the hand on a rigid tool over the step, about the handle; the hand feels the opposite",
    ),
    "rigid_contact_force": ("N", "mean force on a rigid tool over the step from all that it touches"),
    "rigid_contact_torque": (
        "N m",
        "mean torque on a rigid tool over the step from all that it touches, about the handle",
    ),
}


def masses_of(prepared: Prepared) -> int:
    """How many masses of tools are recorded, behind the nodes."""
    return _MASSES * len(prepared.rigid_tools)


def with_masses(prepared: Prepared, shape: Float, rows: Int) -> tuple[Float, Int]:
    """What reads recorded nodes, and behind them the masses of rigid tools.

    Args:
        prepared: what is run.
        shape: row vectors of the nodes, (nodes, rows) or (0, rows).
        rows: of the nodes.
    """
    if not prepared.rigid_tools:
        return shape, rows
    masses = np.concatenate([rows_of(tool.part, prepared.model) for tool in prepared.rigid_tools])
    own = np.eye(shape.shape[1])[masses]
    return np.ascontiguousarray(np.concatenate([shape, own])), np.concatenate([rows, masses])


def rigid_tool_variables(prepared: Prepared, record: Record, period: Float) -> dict[str, tuple[tuple[str, ...], Float]]:
    """Variables of rigid tools in the order of the scenario; empty without them.

    What a tool meets is worked out from how its momentum changed beside what the hand did, which needs every step: else
    it is NaN.

    Args:
        prepared: what was run.
        record: of all its users.
        period: length of each step, (users, records) [s].
    """
    tools = prepared.rigid_tools
    if not tools:
        return {}
    first = record.position.shape[2] - masses_of(prepared)
    each = [_told(tool, record, period[tool.user], first + _MASSES * k) for k, tool in enumerate(tools)]
    dims = ("rigid_tool", "step", "axis")
    return {name: (dims, np.stack([one[name] for one in each])) for name in UNITS}


def _told(tool: RigidTool, record: Record, period: Float, first: int) -> dict[str, Float]:
    """One tool."""
    own = slice(first, first + _MASSES)
    rest = tool.part.rest()
    place, rate = record.position[tool.user, :, own, :3] + rest, record.velocity[tool.user, :, own, :3]
    share = shares_of(rest, tool.handle[None])[0]
    handle, speed = np.einsum("k,rka->ra", share, place), np.einsum("k,rka->ra", share, rate)
    map_of = np.linalg.inv(frame_of(rest))
    turn, turning = (0.25 * np.einsum("rka,kb->rab", field, SIGNS) @ map_of for field in (place, rate))
    left, _, right = np.linalg.svd(turn)
    rotation = left @ right
    # Of a rotation that goes on, Ṙ Rᵀ is skew: the spin.
    skew = turning @ np.swapaxes(rotation, -1, -2)
    spin = 0.5 * axial(skew)
    # Forces are means over a step: they act where points are in its middle.
    middle = place if record.every > 1 else np.concatenate([place[:1], 0.5 * (place[1:] + place[:-1])])
    centre = np.einsum("k,rka->ra", share, middle)
    force, torque = np.zeros_like(handle), np.zeros_like(handle)
    for port, held in zip(tool.ports, tool.shares, strict=True):
        about = np.einsum("k,rka->ra", held, middle) - held.sum() * centre
        force += held.sum() * record.force[port, :, :3]  # what holds a way from the handle only turns
        torque += np.cross(about, record.force[port, :, :3])
    met, met_torque = np.full_like(handle, np.nan), np.full_like(handle, np.nan)
    if record.every == 1:
        pushed = np.zeros_like(place)
        pushed[1:] = tool.mass * (rate[1:] - rate[:-1]) / period[1:, None, None]
        met = pushed.sum(axis=1) - force
        met_torque = np.cross(middle - centre[:, None], pushed).sum(axis=1) - torque
    return {
        "rigid_position": handle,
        "rigid_rotation": turn_vectors(turn),
        "rigid_velocity": speed,
        "rigid_spin": spin,
        "rigid_force": force,
        "rigid_torque": torque,
        "rigid_contact_force": met,
        "rigid_contact_torque": met_torque,
    }
