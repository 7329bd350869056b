"""Where an Inverse3's metres are ours, whose it is, and which handle belongs to it."""

import json
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from tests.drivers.driving import push, ready
from tests.drivers.inside import Grip, Inverse3, deviations, grip_of, holders, read_event, read_state
from tests.drivers.standin import Fault, Service, inverse_service

from cotouch.errors import DeviceError
from cotouch.haptics import Flag

TWICE = {"scale": {"x": 2, "y": 2, "z": 2}}
RAISED = {"position": {"x": 0, "y": 0, "z": 0.1}}


@pytest.fixture
def device(service: Service):
    made = Inverse3(url=service.url, events=service.events)
    yield made
    made.close()


def hub(kept: dict) -> str:
    return f"--hub={json.dumps(kept)}"


@pytest.mark.parametrize(
    "kept",
    [
        {"mount": TWICE},
        {"mount": RAISED, "transform": TWICE},
        {"preset": "arm_front_centered"},
        {"preset": "led_front", "mount": TWICE, "transform": RAISED},
    ],
)
def test_what_haply_hub_kept_of_the_workspace_is_set_back(tmp_path: Path, kept: dict):
    with inverse_service(tmp_path, hub(kept)) as service:
        device = Inverse3(url=service.url, events=service.events)
        try:
            ready(device)
            reading = push(device, 3, np.zeros(3))
            # The handle goes round within 3 cm and some of the middle, which is 15 cm from where a device is mounted:
            # twice as far or 10 cm up it would be somewhere else.
            assert np.abs(reading.position).max() < 0.05
            assert service.board.get("violations") == 0, service.board.said
        finally:
            device.close()


@pytest.mark.parametrize(
    ("kept", "words"),
    [
        ({"mount": TWICE}, r"set to mount with scale \(2, 2, 2\) and does not let it be set back.*preset \"defaults\""),
        ({"preset": "led_front"}, 'set to preset "led_front"'),
    ],
)
def test_a_workspace_that_cannot_be_set_back_is_refused(tmp_path: Path, kept: dict, words: str):
    with inverse_service(tmp_path, hub(kept), "--stubborn") as service:
        with pytest.raises(DeviceError, match=words):
            Inverse3(url=service.url, events=service.events).open()
        assert not any(service.board.get("motor"))


def test_a_service_that_does_not_say_how_the_workspace_is_set_is_refused(tmp_path: Path):
    with (
        inverse_service(tmp_path, "--sparing") as service,
        pytest.raises(DeviceError, match="does not say how the workspace of the Inverse3 049D is set"),
    ):
        Inverse3(url=service.url, events=service.events).open()


@pytest.mark.parametrize(
    ("fault", "words"), [(Fault.RESCALED, r"mount with scale \(2, 2, 2\)"), (Fault.MOVED, r"transform with scale \(3")]
)
def test_a_workspace_that_is_changed_meanwhile_takes_the_force_away(
    service: Service, device: Inverse3, fault: Fault, words: str
):
    ready(device, 20)
    service.board.inject(fault)
    with pytest.raises(DeviceError, match=words):
        push(device, 60)  # it is asked every 50 cycles
    service.board.wait_for("motor", lambda force: not any(force))


@pytest.mark.parametrize(
    ("config", "state", "what"),
    [
        ({"mount": {"scale": {"x": 1, "y": 1.5}}}, {}, ["mount"]),
        ({"mount": {"transform": {"rotation": {"w": 0, "z": 1}}}}, {}, ["mount"]),
        ({"mount": 3}, {}, ["mount"]),
        ({"mount": {"scale": {"x": "a"}}}, {}, ["mount"]),
        ({"mount": {}, "preset": "custom"}, {"transform": {}}, []),
        ({"preset": "custom"}, {}, ["preset"]),
        ({"preset": {"preset": "defaults"}, "basis": "XYZ"}, {}, []),
        ({"basis": {"permutation": "XZY"}}, {"transform": {"position": {"z": 0.1}}}, ["basis", "transform"]),
        ({}, {"transform": {"scale": {"x": float("nan")}}}, ["transform"]),
    ],
)
def test_deviations(config: dict, state: dict, what: list[str]):
    assert list(deviations(config, state)) == what


def test_a_device_that_another_program_has_is_refused_and_the_program_named(tmp_path: Path):
    with inverse_service(tmp_path, "--held") as service:
        with pytest.raises(DeviceError, match=r'049D is in use by "com\.example:painter"; end that first'):
            Inverse3(url=service.url, events=service.events).open()
        assert service.board.get("sets") == 0  # it was not even told zero
    assert holders("ws://127.0.0.1:9") == "another program, which has not told the service its name"


def test_a_device_that_another_program_is_just_leaving_is_waited_for(tmp_path: Path):
    with inverse_service(tmp_path, "--left") as service:
        device = Inverse3(url=service.url, events=service.events)
        device.open()
        device.close()


def test_a_device_that_another_session_takes_is_given_up(service: Service, device: Inverse3):
    ready(device)
    service.board.inject(Fault.BUSY)
    with pytest.raises(DeviceError, match=r"in use by another session com\.example:painter"):
        push(device, 500)
    service.board.wait_for("motor", lambda force: not any(force))


def test_news_do_not_end_a_device(service: Service, device: Inverse3):
    ready(device)
    service.board.inject(Fault.NEWS)
    service.board.wait_for("struck", bool)
    assert push(device, 50).flags & Flag.FORCE_ON


@pytest.mark.parametrize(
    ("event", "fault"),
    [
        ({"name": "device-safety-triggered", "level": "notice", "data": {"safety_type": "ebrake_released"}}, False),
        ({"name": "device-safety-triggered", "data": {"safety_type": "ebrake_released"}}, False),
        ({"name": "device-safety-triggered", "level": "info", "data": {"safety_type": "fod_stage_changed"}}, False),
        ({"name": "device-safety-triggered", "level": "warning", "data": {"safety_type": "fod_stage_changed"}}, True),
        ({"name": "device-safety-triggered", "level": "error", "data": {"safety_type": "ebrake_triggered"}}, True),
        ({"name": "device-safety-triggered", "level": "warning", "data": {"safety_type": "stability_ceiling"}}, True),
        ({"name": "device-disconnected", "level": "warning", "data": {"device_family": "verse_grip"}}, False),
        ({"name": "device-disconnected", "level": "warning", "data": {"device_family": "inverse"}}, True),
        ({"name": "device-busy", "level": "warning", "data": {"session_id": 8}}, True),
        ({"name": "device-busy", "level": "warning", "data": {"session_id": 7}}, False),  # our own
        ({"name": "device-calibration-failed", "level": "warning", "data": {}}, False),
        ({"name": ["odd"], "level": {}, "data": 3}, False),
    ],
)
def test_which_events_are_faults(event: dict, fault: bool):
    assert (read_event(json.dumps(event).encode(), "A", 7) is not None) == fault


RIGHT, LEFT = {"config": {"handedness": "right"}}, {"config": {"handedness": "left"}}
W, C = "wireless_verse_grip", "verse_grip"


def framed(devices: list, grips: list) -> dict:
    frame: dict = {"inverse3": [{"device_id": name, **said} for name, said in devices], C: [], W: []}
    for kind, name, said in grips:
        frame[kind].append({"device_id": name, "state": {"button": True, "buttons": {"a": True}}, **said})
    return frame


@pytest.mark.parametrize(
    ("devices", "grips", "expected"),
    [
        ([("A", {})], [(C, "1", {})], "1"),
        ([("A", {})], [], None),
        ([("A", {})], [(C, "1", {}), (W, "2", {})], None),  # two, and nothing says whose
        ([("A", {}), ("B", {})], [(C, "1", {})], None),  # it may be B's
        ([("A", {}), ("B", {})], [(C, "1", {"config": {"inverse3": {"device_id": "A"}}})], "1"),
        ([("A", {}), ("B", {})], [(C, "1", {"config": {"paired": "B"}}), (C, "2", {})], None),
        ([("A", {}), ("B", {})], [(C, "1", {"status": {"paired": "B"}}), (W, "2", {"config": {"with": "A"}})], "2"),
        ([("A", RIGHT), ("B", LEFT)], [(W, "1", LEFT), (W, "2", RIGHT)], "2"),
        ([("A", RIGHT), ("B", LEFT)], [(W, "1", LEFT)], None),
        ([("A", RIGHT), ("B", RIGHT)], [(W, "1", RIGHT)], None),
        ([("A", RIGHT), ("B", LEFT)], [(W, "1", RIGHT), (W, "2", RIGHT)], None),
        ([("A", RIGHT)], [(W, "1", LEFT)], None),
        ([("A", RIGHT), ("B", LEFT)], [(W, "1", {**RIGHT, "bound_to": ["B"]})], None),  # what it names goes first
    ],
)
def test_a_handle_belongs_to_one_device_or_to_none(devices: list, grips: list, expected: str | None):
    found = grip_of(framed(devices, grips), "A", None)
    assert (None if found is None else found.identity) == expected


def test_a_handle_that_was_named_is_taken():
    frame = framed([("A", {}), ("B", {})], [(C, "1", {}), (W, "2", {})])
    assert grip_of(frame, "A", "2") == Grip(W, "2")
    assert grip_of(frame, "A", "9") is None


def buttons(frame: dict, grip: Grip | None) -> int:
    place = {"cursor_position": dict.fromkeys("xyz", 0.0), "cursor_velocity": dict.fromkeys("xyz", 0.0)}
    for entry in frame["inverse3"]:
        entry["state"] = place
    return read_state(frame, "A", grip).buttons


def test_a_handle_that_was_alone_counts_only_while_it_is():
    grip = grip_of(framed([("A", {})], [(C, "1", {})]), "A", None)
    assert buttons(framed([("A", {})], [(C, "1", {})]), grip) == 1
    assert buttons(framed([("A", {})], [(C, "1", {}), (C, "2", {})]), grip) == 0
    assert buttons(framed([("A", {}), ("B", {})], [(C, "1", {})]), grip) == 0
    assert buttons(framed([("A", {})], []), grip) == 0


@pytest.mark.parametrize("asleep", ["connected", "awake", "ready"])
def test_a_handle_that_sleeps_presses_nothing(asleep: str):
    assert buttons(framed([("A", {})], [(W, "1", {"status": {asleep: False}})]), Grip(W, "1")) == 0


@pytest.mark.parametrize(
    ("chosen", "pressed"),
    [(lambda url, events: Inverse3("049D", url=url, events=events), 0b010),
     (lambda url, events: Inverse3("049D", url=url, events=events, grip="G1"), 0b101)],
)  # fmt: skip
def test_with_two_devices_the_other_hand_presses_nothing_here(
    tmp_path: Path, chosen: Callable[[str, str], Inverse3], pressed: int
):
    grips = json.dumps([[W, "G1", {"config": {"handedness": "left"}}], [W, "G2", {"config": {"handedness": "right"}}]])
    with inverse_service(tmp_path, "--more", f"--grips={grips}") as service:
        device = chosen(service.url, service.events)
        try:
            device.open()
            service.board.set("buttons", 0b010_101)  # a and c of the left hand's, b of the right hand's
            assert push(device, 3).buttons == pressed
        finally:
            device.close()
