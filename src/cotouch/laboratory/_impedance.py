"""What a hand feels of the object through its user's copy: drag, mass, stiffness, over frequency.

Predicted for laws that are linear, from the bodies' matrices and the mean ages of samples; measured for every law, by
pushing with one tone after the other. Both are `Z = f/v` at the node that the hand holds.
"""

from typing import TYPE_CHECKING, Literal, get_args

import numpy as np
import numpy.typing as npt

from cotouch.arrays import Complex, Float
from cotouch.errors import ScenarioError, UnsupportedError
from cotouch.interrupt import interruptible
from cotouch.laboratory._cells import many
from cotouch.laws import Tone
from cotouch.scenario import Scenario
from cotouch.simulation import Prepared, facts_of, given_law, hand_forces, prepare, run_prepared

if TYPE_CHECKING:
    import xarray as xr

Others = Literal["free", "holding"]

# The band of what hands do and feel [Hz], and up to where drag, mass and stiffness are read.
_BAND, _TONES, _SLOW = (0.2, 20.0), 13, 2.0
# How far a tone moves the object, about [m]; how long it settles and is listened to, in periods, and at least [s].
_SWAY, _SETTLE, _LISTEN, _LEAST = 0.01, 4.0, 4.0, 4.0


@interruptible
def impedance(
    scenario: Scenario,
    user: int,
    *,
    node: int | None = None,
    axis: int = 0,
    others: Others = "free",
    frequencies: npt.ArrayLike | None = None,
    measured: bool = True,
    jobs: int = -1,
) -> "xr.Dataset":
    """What a user's hand feels at the node that it holds, predicted and measured.

    Args:
        scenario: the session; hands' paths and tools are left out.
        user: whose hand, from 1.
        node: that it holds, from 1; by default that of the user's first hand, else 1.
        axis: along which it moves.
        others: "free", or "holding": hands with springs of the other users hold their nodes still.
        frequencies: of the tones [Hz]; by default 13 from 0.2 to 20.
        measured: whether to simulate too.
        jobs: how many tones are simulated at once; -1: one per core.

    Returns:
        Over `frequency` [Hz] the complex impedance in parts, `predicted_real`, `predicted_imag` (NaN where the law is
        not linear), `measured_real`, `measured_imag` [Ns/m]. In `attrs`, for each of the two: `drag`, the real part at
        the lowest tone [Ns/m]; `mass` [kg] and `stiffness` [N/m] of the `m s + k/s` that comes nearest up to 2 Hz.

    Raises:
        ScenarioError: there is no such user, node, axis or others; or no frequency is above 0.
        UnsupportedError: links have weights, which cannot be predicted yet; or nothing is to be measured of a law that
            is not linear, so that nothing can be predicted.
    """
    import xarray as xr

    scenario = scenario.placed()
    tones = np.geomspace(*_BAND, _TONES) if frequencies is None else np.atleast_1d(np.asarray(frequencies, dtype=float))
    body, users = scenario.build_body(), scenario.network.size
    if others not in get_args(Others):
        raise ScenarioError(f'others is "{others}"; it must be "free" or "holding"')
    if not 1 <= user <= users:
        raise ScenarioError(f"user is {user}; the network has users 1 to {users}")
    held = [hand.node for hand in scenario.hands if hand.user == user]
    place = node if node is not None else held[0] if held else 1
    if not 1 <= place <= body.nodes:
        raise ScenarioError(f"node is {place}; the body has nodes 1 to {body.nodes}")
    if not 0 <= axis < body.dimension:
        raise ScenarioError(f"axis is {axis}; the body has axes 0 to {body.dimension - 1}")
    if tones.ndim != 1 or not tones.size or not (np.isfinite(tones) & (tones > 0.0)).all():
        raise ScenarioError(f"frequencies are {str(frequencies)[:60]}; they must be finite numbers above 0")
    quiet = [
        hand.model_copy(update={"path": 0.0, "amplitude": 0.0, "begin": 0.0, "release": None})
        for hand in scenario.hands
        if others == "holding" and hand.user != user and hand.kind == "spring"
    ]
    law, _ = given_law(scenario)
    if not measured and law.linear is None and scenario.network.links:
        raise UnsupportedError(f'law "{law.name}" is not linear, so what hands feel of it can only be measured')
    still = scenario.replace(hands=quiet, tools=[], initial={}, record={})
    prepared = prepare(still)
    found: dict[str, Complex] = {"predicted": _predicted(prepared, user - 1, place - 1, axis, tones)}
    if measured:
        found["measured"] = np.array(many(lambda tone: _measured(still, user, place, axis, tone), tones.tolist(), jobs))
    data: dict[str, object] = {}
    attrs: dict[str, object] = {"law": law.name, "user": user, "node": place, "others": others}
    for name, values in found.items():
        for part, numbers in (("real", values.real), ("imag", values.imag)):
            data[f"{name}_{part}"] = ("frequency", numbers, {"units": "N s/m", "long_name": f"impedance, {name}"})
        for quantity, value in zip(("drag", "mass", "stiffness"), _felt(tones, values), strict=True):
            attrs[f"{name}_{quantity}"] = value
    return xr.Dataset(data, coords={"frequency": ("frequency", tones, {"units": "Hz"})}, attrs=attrs)


def _felt(tones: Float, values: Complex) -> tuple[float, float, float]:
    """Drag at the lowest tone, and the mass and stiffness of the `m s + k/s` nearest to what slow tones say."""
    omega = 2.0 * np.pi * tones
    use = (tones <= max(_SLOW, float(tones.min()))) & np.isfinite(values)
    if not use.any():
        return float("nan"), float("nan"), float("nan")
    omega, values = omega[use], values[use]
    scale, drag = 1.0 / np.abs(values), float(values.real[omega.argmin()])
    if omega.size < 2:
        return drag, float(values.imag[0] / omega[0]), 0.0
    columns = np.stack([omega, -1.0 / omega], axis=1) * scale[:, None]
    (mass, stiffness), *_ = np.linalg.lstsq(columns, scale * values.imag, rcond=None)
    return drag, float(mass), float(stiffness)


def _predicted(prepared: Prepared, user: int, node: int, axis: int, tones: Float) -> Complex:
    """From the matrices; exact for constant ages and short steps."""
    import scipy.sparse as sp
    import scipy.sparse.linalg as solver

    scenario, body, timing = prepared.scenario, prepared.body, prepared.schedule
    law, given = given_law(scenario)
    if law.linear is None and scenario.network.links:
        return np.full(tones.size, np.nan + 0j)
    if body.rigid and any(hand.node > body.nodes for hand in scenario.hands):
        raise UnsupportedError("the felt impedance is predicted at nodes only, of a rigid body its four masses")
    if scenario.network.weights or body.truncation is not None:
        raise UnsupportedError("the felt impedance is predicted for links that all pull with the identity as weight")
    facts = facts_of(scenario, prepared.model, timing, prepared.topology.weight)
    parameters = [law.values(fact, given) for fact in facts]
    slots, count, rows = timing.slots, scenario.network.size, body.mass.shape[0]
    wide = rows // body.nodes
    # A sample is of mid-step, and its force acts at mid-step in the mean.
    delay = np.zeros((count, count))
    for s, (i, j) in enumerate(slots.pairs):
        heard = np.flatnonzero(timing.used[s, : timing.count[i]] >= 0)
        delay[i, j] = float((timing.age[s, heard] - 0.5 * timing.length[i, heard]).mean()) if heard.size else 0.0
    hands = [np.zeros((2, rows)) for _ in range(count)]
    for hand in scenario.hands:
        own = slice((hand.node - 1) * wide, hand.node * wide)
        hands[hand.user - 1][:, own] += np.array([[hand.stiffness], [hand.damping]])
    at = user * rows + node * wide + (axis if wide > 1 else 0)
    result = np.empty(tones.size, dtype=np.complex128)
    local = prepared.local_damping[:, 0] + prepared.extra_damping[:, 0]
    for index, s in enumerate(2j * np.pi * tones):
        own = local.astype(np.complex128)
        between = np.zeros((count, count), dtype=np.complex128)
        for slot, (i, j) in enumerate(slots.pairs):
            tone = Tone(
                s=complex(s),
                spring=facts[slot].spring,
                parameters=parameters[slot],
                there=complex(np.exp(-s * delay[i, j])),
                back=complex(np.exp(-s * delay[j, i])),
            )
            at_own, at_other = law.response(tone)
            own[i] += at_own
            between[i, j] -= at_other
        copy = (s * body.mass + body.damping + body.stiffness / s) / count
        held = [sp.diags_array(own[i] + hands[i][0] / s + hands[i][1]) for i in range(count)]
        whole = sp.block_diag([copy + extra for extra in held]) + sp.kron(sp.csr_array(between), sp.eye_array(rows))
        push = np.zeros(count * rows, dtype=np.complex128)
        push[at] = 1.0
        answer = solver.spsolve(sp.csc_array(whole), push)
        result[index] = 1.0 / np.atleast_1d(answer)[at]
    return result


def _measured(still: Scenario, user: int, node: int, axis: int, tone: float) -> complex:
    """By a sine of force at the node, and the velocity that answers."""
    body, omega = still.build_body(), 2.0 * np.pi * tone
    settle, listen = max(_SETTLE / tone, _LEAST), max(round(_LEAST * tone), _LISTEN) / tone
    drag = 4.0 * float(still.network.spring[user - 1].sum()) * float(still.network.delay.max(initial=0.0))
    force = [0.0] * body.dimension
    force[axis] = _SWAY * omega * (float(body.mass.diagonal().max()) * omega + drag + 0.1)
    hand = {"user": user, "node": node, "kind": "force", "path": [0.0] * body.dimension}
    hand |= {"amplitude": force, "frequency": tone}
    steps = still.steps.model_dump(exclude_none=True) | {"duration": settle + listen}
    loud = still.replace(hands=[*still.hands, hand], steps=steps, record={"nodes": [node]})
    prepared = prepare(loud)
    outcome = run_prepared(prepared)
    i, n = user - 1, int(outcome.taken[user - 1])
    end, length = prepared.schedule.end[i, :n], prepared.schedule.length[i, :n]
    place = outcome.record.position[i, : n + 1].reshape(n + 1, -1)[:, axis]
    pushed = hand_forces(prepared, outcome.record.force, body.dimension)[-1, 1 : n + 1, axis]
    window = end > settle
    time = (end - 0.5 * length)[window]
    waves = np.stack([np.cos(omega * time), np.sin(omega * time), np.ones(time.size), time], axis=1)
    rate = np.diff(place)[window] / length[window]
    both, *_ = np.linalg.lstsq(waves, np.stack([pushed[window], rate], axis=1), rcond=None)
    f, v = both[0] - 1j * both[1]
    return complex(f / v) if v else complex("nan")
