"""Tools, devices and hands in a scenario: what they are, what they do, what the ledger says."""

import json
from typing import Any

import numpy as np
import pytest
import xarray as xr
from tests.simulation.inside import TOOL_UNITS

from cotouch.body import lattice, point
from cotouch.coupling import opening_energy, virtual_coupling_limit
from cotouch.device import PRESETS
from cotouch.errors import BodyError, CotouchError, ScenarioError
from cotouch.scenario import Scenario, SimulatedDeviceTable, ToolHand, ToolTable, resolve_penetration
from cotouch.simulation import animation, felt, figures, frame_rate, prepare, run_batch, simulate, summary

PAIR: dict[str, Any] = {"users": ["Ann", "Ben"], "spring": [[0, 20], [20, 0]], "delay": [[0, 0.01], [0.02, 0]]}
# One body for all runs, so that its kernels are compiled once.
BLOCK: dict[str, Any] = {
    "kind": "lattice",
    "shape": [4, 3, 3],
    "spacing": 0.01,
    "mass": 0.1,
    "stiffness": 200,
    "damping": 0.3,
    "ground": "z-",
    "ground_stiffness": 50,
}
PUSH = {"path": [[0.0, 0.0, 0.0, 0.0], [0.1, 0.015, 0.0, 0.005]], "amplitude": [0.004, 0.0, 0.002], "frequency": 7.0}
LEFT: dict[str, Any] = {"user": 1, "at": [-0.011, 0.01, 0.01], "radius": 0.01, "stiffness": 3000, "hand": PUSH}
HOLD: dict[str, Any] = {"user": 2, "at": [0.03, 0.01, 0.02], "kind": "grasp", "stiffness": 300, "hand": PUSH}
DEVICES: dict[str, dict[str, Any]] = {
    "cartesian": {"viscous": 0.05, "coulomb": 0.05, "periods": [0.001, 0.0004, 0.003]},
    "preset": {"preset": "omega", "stiffness": 1500, "rate": 437},
    "declared": {"viscous": 1.0, "assumed_damping": 0.5, "stiffness": 2000},
    "phantom": {"preset": "phantom"},
    "virtual": {"coupling": "virtual", "viscous": 3.0, "damping": 0.1, "stiffness": 500},
    "host force": {"coupling": "host_force", "viscous": 1.0, "damping": 0.1, "stiffness": 600},
}


def run_of(*tools: dict[str, Any], **tables: Any) -> xr.Dataset:
    made: dict[str, Any] = {"network": PAIR, "body": BLOCK, "steps": {"duration": 0.3}, "tools": list(tools), **tables}
    return simulate(made)


def check(run: xr.Dataset) -> None:
    """What every run must keep, whatever is in it."""
    assert run.attrs["finished"]
    assert run.attrs["energy_residual"] <= 1e-10
    assert run.attrs["passivity_margin"] >= -1e-10 * run.attrs["energy_in_play"]
    for entry in summary(run, Scenario.make(network=PAIR, body=BLOCK).build_body())["tools"]:
        if "coupling" in entry:
            assert entry["coupling"]["passive"], entry
    if "device_residual" in run.attrs:
        assert run.attrs["device_residual"] <= 1e-10


# ---- tables


def test_defaults_are_a_touching_fingertip_and_van_beeks_hand() -> None:
    tool = ToolTable(user=1, at=[0.0, 0.0, 0.0])
    assert (tool.kind, tool.radius, tool.mass, tool.stiffness, tool.friction) == ("touch", 0.01, 0.05, 1000.0, 0.0)
    hand = ToolHand()
    assert (hand.mass, hand.damping, hand.stiffness) == (0.554, 6.45, 135.0)
    assert SimulatedDeviceTable().coupling == "pspm"
    assert SimulatedDeviceTable().sort() == "cartesian"
    assert SimulatedDeviceTable(preset="phantom").sort() == "phantom"
    assert SimulatedDeviceTable(preset="phantom", kind="cartesian").sort() == "cartesian"


WRONG: list[tuple[str, str]] = [
    ("user=3\nat=[0,0,-1]", "tools[2].user is 3; the network has users 1 to 2"),
    ("user=0\nat=[0,0,-1]", "tools[2].user is 0; it must be greater than or equal to 1"),
    ("user=2", "tools[2].at is missing"),
    ("user=2\nat=[0,1]", "tools[2].at is [0, 1]; it must have at least 3 entries"),
    ("user=2\nat=[0,1,'x']", "tools[2].at[3] is 'x'"),
    ("user=2\nat=[0.01,0.01,0.01]", "is 0.02 m deep in the body; move it to [-0.01, 0.01, 0.01] or farther"),
    ("user=2\nat=[-0.005,0.01,0.01]", "0.005 m deep in the body; move it to [-0.01, 0.01, 0.01]"),
    ("user=2\nat=[0.01,0.01,-0.2]\naxis=[0,0,0.4]", "0.0188 m deep in the body; move or turn it"),
    ("AT\naxis=[0,0,1e6]", "tools[2].axis is 1e+06 m long, but radius is 0.01 m; it must be at most 1000 times"),
    ("AT\nkind='pinch'", 'tools[2].kind is "pinch"'),
    ("AT\nradius=0", "tools[2].radius is 0"),
    ("AT\ncolour=1", "tools[2].colour is not an option"),
    ("AT\nkind='grasp'\nfriction=0.5", "tools[2].friction is 0.5, but a grasp holds without"),
    ("AT\nbegin=1\nrelease=0.5", "tools[2].release is 0.5 s but begin is 1.0 s; it must be later"),
    ("AT\nhand=3", "tools[2].hand is 3; it must be a table"),
    ("AT\n[tools.hand]\nmass=1", "tools[2].hand.mass needs a device"),
    ("AT\n[tools.hand]\npath=[1,2]", "tools[2].hand.path is [1.0, 2.0]; it must be 3 numbers or waypoints"),
    ("AT\n[tools.hand]\npath=[[0,1,2]]", "tools[2].hand.path has the waypoint [0.0, 1.0, 2.0]"),
    ("AT\n[tools.hand]\npath=[[0,1,2,'x']]", "tools[2].hand.path[1][4] is 'x'"),
    ("AT\n[tools.hand]\npath=[[1,1,2,3],[1,1,2,3]]", "tools[2].hand: the times of path are [1.0, 1.0]"),
    ("AT\n[tools.hand]\ngrip=9", "tools[2].hand.grip is 9"),
    ("AT\n[tools.hand]\nbegin=1\nrelease=0.5", "tools[2].hand.release is 0.5 s but begin is 1.0 s"),
    ("AT\n[tools.device]\npreset='omgea'", 'tools[2].device.preset is "omgea"; it must be one of omega, delta'),
    ("AT\n[tools.device]\nrate=500\nperiods=[0.1]", "tools[2].device.rate and periods are given"),
    ("AT\n[tools.device]\nperiods=[]", "tools[2].device.periods is []; it must have at least 1 entry"),
    ("AT\n[tools.device]\nkind='phantom'\nmass=1", "tools[2].device.mass is 1.0 kg; a PHANToM has its own"),
    ("AT\n[tools.device]\nkind='phantom'\npreset='omega'", 'tools[2].device.kind is "phantom" but preset is "omega"'),
    (
        "AT\n[tools.device]\npreset='falcon'\nstiffness=3000",
        "the coupling's stiffness is 3000 N/m, but encoders with steps of 6e-05 m empty PSPM's tank at 2 Ns/m above "
        "900 N/m; lower it, or set clip_stiffness",
    ),
    (
        "AT\n[tools.device]\nresolution=0.001\ndamping=4",
        "the coupling's damping is 4 Ns/m over 0.02 s, but encoders with steps of 0.001 m empty PSPM's tank with any "
        "stiffness; lower it, or measure velocity over a longer window",
    ),
    (
        "AT\n[tools.device]\ncoupling='host_force'\nrate=9",
        'tools[2].device.rate is given, but with coupling "host_force"',
    ),
    ("AT\n[tools.device]\ncoupling='host_force'", "tools[2].device: the virtual coupling's damping is 2 Ns/m"),
    ("AT\n[tools.device]\ncoupling='host_force'\ndamping=0", "passive up to 25 N/m; lower it or use PSPM"),
    ("AT\n[tools.device]\ncoupling='virtual'\ndamping=0", "passive up to 5 N/m; lower it or use PSPM"),
    ("AT\n[tools.device]\ncoupling='soft'", 'coupling is "soft"; it must be one of pspm, virtual, host_force'),
    ("AT\n[tools.device]\nwindow=1e9", "tools[2].device: window is 1e+09 s"),
    (
        "AT\n[tools.device]\nkind='phantom'\n[tools.hand]\npath=[0.3,0,0]",
        "tools[2].hand.path leads to [0.3, 0, 0] m from where the tool starts; a PHANToM's tip cannot reach that far",
    ),
    (
        "AT\n[tools.device]\nkind='phantom'\n[tools.hand]\namplitude=[0.3,0,0]",
        "tools[2].hand.path leads to [-0.3, 0, 0]",
    ),
]


@pytest.mark.parametrize(("text", "headers"), WRONG)
def test_what_is_wrong_is_one_sentence_with_its_place(text: str, headers: str) -> None:
    tools = "[[tools]]\nuser=1\nat=[-1,0,0]\n[[tools]]\n" + text.replace("AT", "user=2\nat=[-0.05,0.01,0.01]")
    body = "[body]\nkind='lattice'\nshape=[3,3,3]\n"
    network = '[network]\nusers=["Ann","Ben"]\nspring=[[0,9],[9,0]]\ndelay=[[0,0.1],[0.1,0]]\n'
    with pytest.raises(CotouchError) as caught:
        prepare(Scenario.from_toml(network + body + "[steps]\nduration=0.1\n" + tools))
    assert headers in str(caught.value)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("body", [{}, {"kind": "lattice", "shape": [3, 3]}, {"kind": "chain", "nodes": 3}])
def test_tools_need_a_body_of_three_axes(body: dict[str, Any]) -> None:
    with pytest.raises(BodyError, match=r"3 axes, but this one has [12]; give a point the rest place"):
        prepare(Scenario.make(network=PAIR, body=body, steps={"duration": 0.1}, tools=[LEFT]))


def test_where_a_sphere_is_clear_of_a_box() -> None:
    box = lattice([3, 3, 3], spacing=0.01)
    still = np.zeros((27, 3))
    rng = np.random.default_rng(1)
    for centre in rng.uniform(-0.02, 0.04, size=(200, 3)):
        away = np.maximum(np.maximum(-centre, centre - 0.02), 0.0)
        outside = float(np.linalg.norm(away))
        depth = 0.005 - (outside or -min(*centre, *(0.02 - centre)))
        found = resolve_penetration(box, still, centre, 0.005, 0)
        assert (found is None) == (depth <= 0.0)
        if found is not None:
            assert found[0] == pytest.approx(depth)
            assert resolve_penetration(box, still, found[1] + 1e-9 * (found[1] - 0.01), 0.005, 0) is None
    moved = still + np.array([0.0, 0.0, 0.1])
    assert resolve_penetration(box, moved, np.array([0.01, 0.01, 0.01]), 0.005, 0) is None


def test_a_tool_inside_the_body_may_wait_there_but_not_touch() -> None:
    inside = {**LEFT, "at": [0.015, 0.01, 0.01]}
    with pytest.raises(ScenarioError, match="starts outside"):
        prepare(Scenario.make(network=PAIR, body=BLOCK, tools=[inside]))
    prepare(Scenario.make(network=PAIR, body=BLOCK, steps={"duration": 0.1}, tools=[{**inside, "begin": 0.05}]))


# ---- runs


@pytest.fixture(scope="module")
def plain() -> xr.Dataset:
    """A touch without a device and a grasp without a device, which lets go."""
    return run_of({**LEFT, "friction": 0.5, "damping": 1.0}, {**HOLD, "release": 0.2}, record={"frames": 50})


def test_energy_balances_and_the_ports_are_passive(plain: xr.Dataset) -> None:
    check(plain)
    assert "device_force" not in plain
    touching = plain["touching"].values
    assert touching[0].max() >= 1
    assert np.array_equal(plain["force"].values[0], -plain["touch_force"].values[0])


def test_books_of_tools_add_up(plain: xr.Dataset) -> None:
    """Recomputed from the variables of users, not from the engine's own sum."""
    last = plain.isel(step=-1, tick=-1)
    stored = sum(float(last[name].sum()) for name in ("kinetic", "elastic", "proxy", "touch_stored", "link_energy"))
    lost = sum(float(last[name].sum()) for name in ("body_loss", "local_loss", "extra_loss", "touch_loss"))
    given = float(last["drive_work"].sum()) + float(last["supplied"].sum())
    assert stored == pytest.approx(float(last["stored"]), rel=1e-12)
    assert stored - given + lost == pytest.approx(float(last["delay_work_total"]), abs=1e-12 * stored + 1e-15)
    assert float(last["touch_work"].sum()) > 0.0


def test_letting_go_of_a_grasp_is_at_once(plain: xr.Dataset) -> None:
    step = int(np.searchsorted(plain["time"].values[1], 0.2)) + 1
    assert plain["touching"].values[1, step - 1] > 0
    assert plain["touching"].values[1, step:].max() == 0
    assert np.abs(plain["touch_force"].values[1, step - 1]).max() > 0.1
    assert not plain["touch_force"].values[1, step:].any()
    assert plain["touch_loss"].values[1, step] > plain["touch_loss"].values[1, step - 1]


def test_what_a_hand_without_a_device_feels_is_what_it_pulls_with(plain: xr.Dataset) -> None:
    assert np.array_equal(felt(plain), -plain["drive_force"].values)
    # Newton for the proxy: m (w+ - w) / T = drive + touch.
    w, T = plain["tool_velocity"].values, plain["period"].values[:, 1:, None]
    gained = 0.05 * np.diff(w, axis=1) / T
    np.testing.assert_allclose(gained, (plain["drive_force"] + plain["touch_force"]).values[:, 1:], atol=1e-9)


def test_order_in_the_file_decides_nothing_but_the_order_of_results() -> None:
    second = {**LEFT, "at": [0.041, 0.01, 0.01], "radius": 0.008, "hand": {"path": [-0.01, 0.0, 0.0]}}
    tools = [LEFT, second, {**HOLD, "device": DEVICES["preset"]}]
    one, other = run_of(*tools), run_of(*(tools[k] for k in (2, 0, 1)))
    for name in ("tool_position", "touch_force", "device_force", "coupling_bound"):
        assert np.array_equal(one[name].values, other[name].values[[1, 2, 0]], equal_nan=True)
    assert np.array_equal(one["position"].values, other["position"].values)
    assert np.isnan(one["device_force"].values[:2]).all()
    assert not np.isnan(one["device_force"].values[2]).any()


@pytest.mark.parametrize("name", DEVICES)
@pytest.mark.parametrize("tool", [LEFT, HOLD], ids=["touch", "grasp"])
def test_every_device_is_passive_and_its_books_balance(name: str, tool: dict[str, Any]) -> None:
    run = run_of({**tool, "device": DEVICES[name]})
    check(run)
    assert np.linalg.norm(felt(run), axis=-1).max() > 0.3
    (entry,) = summary(run, Scenario.make(network=PAIR, body=BLOCK).build_body())["tools"]
    assert entry["contact_time_s"] > 0.1
    assert entry["peak_force_n"] >= entry["mean_force_n"] > 0.0
    if name == "host force":
        assert entry["coupling"]["bound_j"] == 0.0
    else:
        assert 0.01 <= entry["coupling"]["bound_j"] < 0.06


@pytest.mark.parametrize("tool", [LEFT, HOLD], ids=["touch", "grasp"])
def test_every_joule_of_a_coupling_is_on_its_account(tool: dict[str, Any]) -> None:
    """Where ticks and steps fall together: what both ends took and what is left on the account come to nothing."""
    run = run_of({**tool, "device": {"rate": 1000, "stiffness": 1500, "coulomb": 0.05, "cap": 1e3}})
    check(run)
    left = (run["coupling_energy"] + run["device_work"] + run["coupling_work"]).values
    left -= 2 * opening_energy(toll=0.0, stiffness=1500.0, cap=1e3)
    flows = np.abs(run["coupling_work"].values).max()
    assert flows > 1e-3
    assert np.abs(left).max() < 1e-12 * flows


def test_host_force_is_passive_up_to_its_limit_and_refused_above() -> None:
    steps = {"duration": 0.3, "random": {"low": 0.0005, "high": 0.002}}
    tool = {
        **LEFT,
        "device": {"coupling": "host_force", "viscous": 1.0, "damping": 0.05, "stiffness": 1e5, "clip_stiffness": True},
    }
    lowered = run_of(tool, steps=steps)
    check(lowered)
    length = lowered["period"].values[0, 1:]
    length = length[np.isfinite(length)]
    limit = virtual_coupling_limit(
        device_damping=1.0,
        damping=0.05,
        period=float(length.max()),
        spread=float((length[1:] / length[:-1]).max()),
    )
    tool["device"] = {**tool["device"], "clip_stiffness": False, "stiffness": 0.999 * limit}
    assert run_of(tool, steps=steps).attrs["coupling_excess"] <= 1e-15
    tool["device"]["stiffness"] = 1.001 * limit
    with pytest.raises(ScenarioError, match=r"tools\[1\]\.device: .*is passive up to"):
        run_of(tool, steps=steps)


def test_host_force_counts_its_encoders() -> None:
    """Refused where dry friction cannot pay for them; else the excess keeps its bound, which the proxy's path sets."""
    device = {"coupling": "host_force", "viscous": 2.0, "damping": 0.05, "stiffness": 600, "resolution": 1e-3}
    with pytest.raises(
        ScenarioError, match=r"tools\[1\]\.device: .* 0\.000866 m of its place, with 0 N of dry friction"
    ):
        run_of({**LEFT, "device": device}, steps={"duration": 0.3, "period": 0.001})
    for kind, resolution in ((LEFT, 1e-3), (HOLD, 1e-3), (HOLD, 1e-5)):
        tool = {**kind, "device": {**device, "resolution": resolution, "coulomb": 0.7}}
        run = run_of(tool, steps={"duration": 0.3, "period": 0.001})
        check(run)
        path = np.linalg.norm(np.diff(run["tool_position"].values[0], axis=0), axis=1).sum()
        unsure = (600 + 2 * 0.05 / 0.001) * 0.5 * 3.0**0.5 * resolution
        assert run["coupling_bound"].values[0] == pytest.approx(unsure * path, rel=1e-9)
    phantom = {**device, "kind": "phantom", "viscous": 0.5, "coulomb": 0.01, "resolution": 1.4e-4, "stiffness": 400}
    with pytest.raises(
        ScenarioError, match=r"with 0\.025974 N of dry friction .* is passive up to 381\.\d+ N/m; lower"
    ):
        run_of({**HOLD, "device": phantom}, steps={"duration": 0.3, "period": 0.001})


def test_at_rest_a_force_stands_still_though_nothing_rubs(monkeypatch: pytest.MonkeyPatch) -> None:
    """Steps of the encoder times the stiffness would make it hum; energy is accounted for either way."""
    hand = {"path": [[0.0, 0.0, 0.0, 0.0], [0.5, 0.03, 0.002, 0.001]]}

    def hum(**device: float) -> float:
        run = run_of({**HOLD, "user": 1, "hand": hand, "device": device}, steps={"duration": 4.0, "period": 0.002})
        check(run)
        force = run["device_force"].values[0, 1750:]
        assert np.linalg.norm(force, axis=1).min() > 1.0
        return float(np.ptp(force, axis=0).max())

    worst = [(500.0, 6e-5), (1800.0, 3e-5), (5000.0, 1e-5)]
    for stiffness, step in worst:
        assert hum(stiffness=stiffness, resolution=step) < 0.02
    monkeypatch.setattr("cotouch.device._assemble.rest_fraction", lambda *_: 1.0)
    assert max(hum(stiffness=stiffness, resolution=step) for stiffness, step in worst) > 0.05


@pytest.mark.parametrize(("preset", "spring"), [("delta", (5000.0, 30.0)), ("falcon", (3000.0, 20.0))])
def test_a_weak_grip_is_still_because_a_tank_begins_with_what_encoders_cost(
    preset: str, spring: tuple[float, float], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Else the account is empty before there is anything in it: the spring slips, and force jumps with every step."""
    hand = {"path": [[0.0, 0.0, 0.0, 0.0], [0.5, 0.02, 0.001, 0.002]], "grip": 0.25}
    stiffness, damping = spring
    made = {"preset": preset, "stiffness": stiffness, "damping": damping, "coulomb": 0.0, "clip_stiffness": True}

    def last(**device: float) -> tuple[float, float, xr.Dataset]:
        tool = {**LEFT, "hand": hand, "device": {**made, **device}}
        run = run_of(tool, steps={"duration": 12.0, "period": 0.002})
        check(run)
        force = run["device_force"].values[0, -500:]
        apart = (run["device_position"] - run["tool_position"]).values[0, -1]
        return float(np.ptp(force, axis=0).max()), float(np.linalg.norm(apart)), run

    hum, apart, run = last()
    fine = PRESETS[preset].resolution
    clipped = min(stiffness, 0.135 / fine - damping / 0.02)
    assert hum < 0.02
    assert apart < np.linalg.norm(run["device_force"].values[0, -1]) / clipped + 12 * fine
    begun = 0.3 * (clipped + damping / 0.02) * fine
    assert run["coupling_energy"].values[0, 0] == pytest.approx(2 * begun)
    assert run["coupling_bound"].values[0] > 2 * begun
    monkeypatch.setattr("cotouch.scenario._tools.opening_energy", lambda **_: 0.0)
    without, slipped, _ = last()
    assert without > 0.1 or slipped > apart + 1e-3


@pytest.mark.parametrize("kind", ["touch", "grasp"])
@pytest.mark.parametrize("seed", [2, 3, 4])
def test_host_force_saturates_with_its_motors_and_stays_passive(kind: str, seed: int) -> None:
    """Pulled about far beyond what the motors can do. A linear spring that they cut off gives energy, without end."""
    rng = np.random.default_rng(seed)
    hand = {"path": [[0.1 * k, *rng.normal(0.0, 0.06, 3).tolist()] for k in range(8)], "grip": 4.0}
    device = {"coupling": "host_force", "stiffness": 800, "damping": 0.5, "viscous": 2.0, "force": 1.0, "mass": 0.1}
    tool = {**(LEFT if kind == "touch" else HOLD), "user": 1, "hand": hand, "device": device}
    steps = {"duration": 0.8, "random": {"low": 0.0008, "high": 0.001}}
    prepared = prepare(Scenario.make(network=PAIR, body=BLOCK, steps=steps, tools=[tool]))
    assert prepared.touching is not None
    couplings = prepared.touching.couplings
    assert couplings.most[0] == 1.0
    outcome = run_batch(prepared)
    assert outcome.tools is not None
    moved = np.abs(outcome.tools.coupling[0]).max()
    assert moved > 1e-3
    assert outcome.tools.coupling[1].max() <= 1e-12 * moved
    pull = np.linalg.norm(outcome.tools.drive[0, :, :3], axis=1).max()
    couplings.most[0] = np.inf
    linear = run_batch(prepared)
    assert linear.tools is not None
    assert linear.tools.coupling[1].max() > 0.01 * moved
    # The proxy is pulled no harder either, but for what its own motion adds.
    assert pull < min(2.0, 0.3 * np.linalg.norm(linear.tools.drive[0, :, :3], axis=1).max())


@pytest.mark.parametrize("steps", [{"rate": [500, 1700]}, {"random": {"low": 0.0003, "high": 0.004}}])
def test_the_servos_pace_and_the_bodys_are_each_its_own(steps: dict[str, Any]) -> None:
    devices = [DEVICES["cartesian"], DEVICES["preset"]]
    tools = [{**tool, "device": device} for tool, device in zip((LEFT, HOLD), devices, strict=True)]
    check(run_of(*tools, steps={"duration": 0.3, **steps}))


@pytest.mark.parametrize("mode", ["constant", "self-paced", "freshest"])
def test_in_every_mode(mode: str) -> None:
    tools = [{**LEFT, "device": DEVICES["preset"], "friction": 0.4}, {**HOLD, "device": DEVICES["phantom"]}]
    channel = {"jitter": {"scale": 0.01}, "loss": 0.05}
    check(run_of(*tools, synchronisation={"mode": mode}, channel=channel, steps={"duration": 0.3, "rate": 500}))


def test_runs_are_the_same_every_time() -> None:
    tools = [{**LEFT, "device": DEVICES["cartesian"]}, {**HOLD, "device": DEVICES["phantom"]}]
    channel = {"jitter": {"scale": 0.01}, "loss": 0.1}
    one, other = (run_of(*tools, channel=channel, seed=3) for _ in range(2))
    assert one.identical(other)
    assert not one.identical(run_of(*tools, channel=channel, seed=4))


def test_a_device_that_nobody_holds_stays_at_rest() -> None:
    run = run_of({**LEFT, "hand": None, "device": {"preset": "omega"}})
    assert not run["tool_position"].diff("step").values.any()
    assert not felt(run).any()
    assert not run["position"].diff("step").values.any()


# ---- results


def test_a_run_becomes_an_animation(plain: xr.Dataset) -> None:
    body = Scenario.make(network=PAIR, body=BLOCK).build_body()
    shown = animation(plain, body)
    assert shown.users == ("Ann", "Ben")
    assert shown.links == ((0, 1),)
    assert np.array_equal(shown.time, np.arange(0.0, 0.3, 0.02))
    assert shown.tools.owner.tolist() == [0, 1]
    assert shown.tools.radius.tolist() == [0.01, 0.01]
    frame = 7  # 0.14 s, which is a step's end
    step = 140
    for tool in range(2):
        np.testing.assert_allclose(
            shown.tools.centre[frame, tool], plain["tool_position"].values[tool, step], atol=1e-12
        )
        np.testing.assert_allclose(shown.tools.force[frame, tool], felt(plain)[tool, step], atol=1e-9)
    assert body.skin is not None
    copies = plain["position"].values[:, step] - body.rest
    for user in range(2):
        skin = body.skin.vertices + body.skin.carried(copies[user])
        np.testing.assert_allclose(shown.vertices[frame, user], skin, atol=3e-4)  # a frame is the step before
    apart = np.linalg.norm(copies - copies.mean(axis=0), axis=-1).max(axis=1)
    assert shown.series[0].name == "Discrepancy"
    np.testing.assert_allclose(shown.series[0].values[frame], apart, rtol=0.1)


def test_an_animation_knows_where_styluses_end() -> None:
    stylus = {**LEFT, "at": [-0.03, 0.01, 0.01], "axis": [0.0, 0.01, 0.05]}
    run = run_of(LEFT, stylus, HOLD, steps={"duration": 0.02}, record={"frames": 50})
    shown = animation(run, Scenario.make(network=PAIR, body=BLOCK).build_body())
    assert shown.tools.tip.tolist() == [[0.0, 0.0, 0.0], [0.0, 0.01, 0.05], [0.0, 0.0, 0.0]]
    assert not shown.tools.axis.any()  # nobody's is a blade


@pytest.mark.parametrize(
    ("body", "edges"),
    [({}, 0), ({"kind": "chain", "nodes": 4}, 3), ({"kind": "lattice", "shape": [3, 2]}, 7)],
)
def test_bodies_without_skin_or_with_fewer_axes_are_shown_by_nodes_and_edges(body: dict[str, Any], edges: int) -> None:
    made = Scenario.make(
        network=PAIR,
        body=body,
        steps={"duration": 0.3},
        hands=[{"user": 2, "path": [0.1, 0.0][: 2 if "shape" in body else 1], "begin": 0.1}],
        record={"frames": 20},
    )
    run = simulate(made)
    shown = animation(run, made.build_body())
    assert shown.triangles.shape[0] == 0
    assert shown.edges.shape == (edges, 2)
    assert shown.ports.owner.tolist() == [1]
    assert not shown.ports.force[1].any()
    assert shown.ports.force[-1].any()
    np.testing.assert_allclose(shown.ports.place[:, 0, 0], shown.vertices[:, 1, 0, 0])
    assert "<html" in shown.page()


def test_figures_of_tools_show_places_forces_and_contacts(plain: xr.Dataset) -> None:
    drawn = figures(plain)
    assert {"tools", "touch", "positions", "forces"} <= set(drawn)
    places = drawn["tools"].get_axes()
    assert [axes.get_ylabel()[0] for axes in places] == ["x", "y", "z"]
    force, hand, contacts = drawn["touch"].get_axes()
    sizes = [np.linalg.norm(values, axis=-1).max(axis=1) for values in (plain["touch_force"].values, felt(plain))]
    for axes, largest in zip((force, hand), sizes, strict=True):
        assert axes.get_ylabel() == "|f| / N"
        tops = [np.max(np.asarray(line.get_ydata())) for line in axes.get_lines()]
        np.testing.assert_allclose(tops, largest)
    counts = [np.max(np.asarray(line.get_ydata())) for line in contacts.get_lines()]
    assert counts == plain["touching"].max("step").values.tolist()


def test_an_animation_needs_frames_of_the_same_body(plain: xr.Dataset) -> None:
    with pytest.raises(ScenarioError, match="no frames; set record"):
        animation(plain.drop_vars("frame_position"), Scenario.make(network=PAIR, body=BLOCK).build_body())
    with pytest.raises(ScenarioError, match="36 nodes and 3 axes, this one 1 and 1"):
        animation(plain, point())


def test_frames_are_60_a_second_or_fewer_where_there_is_much_to_show() -> None:
    short = Scenario.make(network=PAIR, body=BLOCK, steps={"duration": 5.0})
    assert frame_rate(short) == 60.0
    assert frame_rate(short.replace(steps__duration=100.0)) == 12.0
    big = {"kind": "lattice", "shape": [20, 20, 20]}
    assert frame_rate(Scenario.make(network=PAIR, body=big, steps={"duration": 10.0})) == pytest.approx(37.5)


def test_every_variable_of_tools_says_its_unit_and_meaning() -> None:
    run = run_of({**LEFT, "device": DEVICES["preset"]})
    assert set(TOOL_UNITS) <= set(run.data_vars)
    for name, (unit, meaning) in TOOL_UNITS.items():
        assert (run[name].attrs["units"], run[name].attrs["long_name"]) == (unit, meaning)
    assert run["device_force"].dims == ("tool", "step", "axis")


def test_a_scenario_in_a_result_holds_its_tools(plain: xr.Dataset) -> None:
    tools = json.loads(plain.attrs["scenario"])["tools"]
    assert [tool["kind"] for tool in tools] == ["touch", "grasp"]
    assert tools[0]["hand"]["frequency"] == 7.0
