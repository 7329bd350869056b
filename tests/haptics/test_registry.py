"""Drivers by name, what is asked of them in words, and the frames of devices."""

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from cotouch.errors import DeviceError
from cotouch.haptics import (
    FORCE_DIMENSION_FRAME,
    FRAMES,
    HAPLY_FRAME,
    OPENHAPTICS_FRAME,
    OPENXR_FRAME,
    SIMULATED,
    Device,
    DeviceChoice,
    DeviceFrame,
    device_names,
    driver,
    make_device,
    open_device,
)

NOT_A_DRIVER = 7


def fails(**options: object) -> Device:
    raise ValueError("no number")


def refuses(**options: object) -> Device:
    raise DeviceError("the option is 7; it must be less")


def incomplete(**options: object) -> Any:
    return SimpleNamespace(spec=SIMULATED.spec, open=print, close=print)


INCOMPLETE = replace(SIMULATED, make=incomplete)
FAILS = replace(SIMULATED, make=fails)
REFUSES = replace(SIMULATED, make=refuses)


def test_the_package_registers_its_own_as_others_do():
    assert "simulated" in device_names()
    assert driver("simulated") is SIMULATED


def test_a_driver_that_is_being_written_is_named_by_its_module():
    assert driver("cotouch.haptics/SIMULATED") is SIMULATED


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("omega9", 'device is "omega9"; it must be one of'),
        ("no.such/THING", 'the driver "no.such/THING" cannot be loaded: No module'),
        (f"{__name__}/NOT_A_DRIVER", "is a int; it must be a cotouch.haptics.Driver"),
    ],
)
def test_a_driver_that_is_none_is_a_sentence(name: str, said: str):
    with pytest.raises(DeviceError, match=said):
        driver(name)


@pytest.mark.parametrize(
    ("text", "name", "options"),
    [
        ("simulated", "simulated", {}),
        ("simulated:touch", "simulated", {"variant": "touch"}),
        ("simulated:touch,hand=false,sweep=0.5", "simulated", {"variant": "touch", "hand": False, "sweep": 0.5}),
        ("haply:url=ws://localhost:10001", "haply", {"url": "ws://localhost:10001"}),
        ("a/B:number=3", "a/B", {"number": 3}),
    ],
)
def test_devices_are_asked_for_in_words(text: str, name: str, options: dict[str, object]):
    assert DeviceChoice.read(text) == DeviceChoice(name, options)


@pytest.mark.parametrize("text", ["", ":phantom", "simulated:a,b", "simulated:a=1,a=2", "simulated:2x=1"])
def test_words_that_ask_for_nothing_are_refused(text: str):
    with pytest.raises(DeviceError, match="it must"):
        DeviceChoice.read(text)


@pytest.mark.parametrize(
    ("options", "said"),
    [
        ({"variant": "falcon"}, 'has no variant "falcon"; its variants: phantom, cartesian, touch'),
        ({"mass": 1.0}, 'has no option "mass"; its options: hand, sweep, viscous, turn'),
        ({"sweep": 4}, "sweep is 4; it must be from 0 to 3"),
        ({"turn": 4}, "turn is 4 rad; it must be from 0 to 3 rad"),
        ({"viscous": -1}, "viscous is -1 Ns/m; it must be from 0 to 20 Ns/m"),
        ({"variant": "phantom", "viscous": 1}, "viscous is 1 Ns/m, but a PHANToM has joints instead; leave it out"),
    ],
)
def test_options_that_are_wrong_are_refused(options: dict[str, str | float], said: str):
    with pytest.raises(DeviceError, match=said):
        make_device("simulated", **options)


def test_an_opened_device_answers_and_is_off():
    device = open_device("simulated", variant="cartesian", hand=False)
    reading = device.exchange(np.array([1.0, 0.0, 0.0]))
    assert not reading.force.any()
    device.close()
    with pytest.raises(DeviceError):
        device.exchange(np.zeros(3))


@pytest.mark.parametrize("frame", FRAMES.values(), ids=FRAMES)
def test_frames_are_right_handed_and_go_back(frame: DeviceFrame):
    assert np.linalg.det(frame.matrix) == pytest.approx(1.0)
    theirs = np.array([0.3, -0.5, 0.7])
    np.testing.assert_allclose(frame.place(theirs), frame.unit * frame.matrix @ theirs)
    np.testing.assert_allclose(frame.direction(theirs), frame.matrix @ theirs)
    np.testing.assert_allclose(frame.back(frame.direction(theirs)), theirs)
    # Work is the same in both: a force of ours on a move of theirs.
    force, move = np.array([1.0, 2.0, -3.0]), np.array([0.1, 0.2, 0.4])
    assert force @ frame.direction(move) == pytest.approx(frame.back(force) @ move)


def test_frames_are_those_of_the_vendors():
    """Where each device's own axes point, in ours: forward, left, up."""
    forward, left, up = np.eye(3)
    np.testing.assert_array_equal(HAPLY_FRAME.direction([1, 0, 0]), -left)
    np.testing.assert_array_equal(HAPLY_FRAME.direction([0, 1, 0]), forward)
    np.testing.assert_array_equal(OPENHAPTICS_FRAME.place([0, 0, 1000]), -forward)
    np.testing.assert_array_equal(OPENHAPTICS_FRAME.place([1000, 0, 0]), -left)
    np.testing.assert_array_equal(OPENHAPTICS_FRAME.direction([0, 1, 0]), up)
    np.testing.assert_array_equal(FORCE_DIMENSION_FRAME.direction([1, 0, 0]), -forward)
    np.testing.assert_array_equal(FORCE_DIMENSION_FRAME.direction([0, 1, 0]), -left)
    np.testing.assert_array_equal(OPENXR_FRAME.direction([0, 1, 0]), up)
    np.testing.assert_array_equal(OPENXR_FRAME.direction([0, 0, -1]), forward)


def test_orientations_turn_about_the_same_axis():
    half = np.sqrt(0.5)
    np.testing.assert_allclose(OPENHAPTICS_FRAME.orientation([0, half, 0, half]), [0, 0, half, half])  # about up


@pytest.mark.parametrize(("rows", "unit"), [((1, 2, -3), 1.0), ((1, 1, 2), 1.0), ((2, 1, 3), 1.0), ((1, 2, 3), 0.0)])
def test_frames_that_are_none_are_refused(rows: tuple[int, int, int], unit: float):
    with pytest.raises(DeviceError, match="must be"):
        DeviceFrame(rows, unit)


def test_a_driver_that_cannot_make_its_device_is_a_sentence():
    with pytest.raises(DeviceError, match=r"cannot be made: no number \(ValueError\); its driver must refuse options"):
        make_device(f"{__name__}/FAILS")
    with pytest.raises(DeviceError, match=r"^the option is 7; it must be less$"):
        make_device(f"{__name__}/REFUSES")


def test_a_driver_has_the_name_of_its_entry_point(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr("cotouch.haptics._registry.installed", lambda *a, **k: SIMULATED)
    with pytest.raises(DeviceError, match='the driver "pantograph" calls itself "simulated"; its entry point must'):
        driver("pantograph")


def test_a_device_that_lacks_a_member_is_a_sentence_before_it_is_opened(capsys: pytest.CaptureFixture[str]):
    """The servo ended with a traceback where it wanted to stop it."""
    with pytest.raises(DeviceError, match=r"has no calibrate, enable_force, exchange, stop; it must have every member"):
        open_device(f"{__name__}/INCOMPLETE")
    assert capsys.readouterr().out == ""
