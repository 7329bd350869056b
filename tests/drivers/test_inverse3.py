"""The Inverse3 through the Inverse Service: axes, lean frames, handles, altered forces."""

import time

import numpy as np
import pytest
from tests.drivers.driving import push, ready
from tests.drivers.inside import Inverse3, halt, present, read_event, read_state
from tests.drivers.standin import Fault, Service, inverse_service
from tests.stalls import Stalls

from cotouch.errors import DeviceError
from cotouch.haptics import Flag


@pytest.fixture
def device(service: Service):
    made = Inverse3(url=service.url, events=service.events)
    yield made
    made.close()


def test_a_force_of_ours_arrives_along_the_axes_of_the_device(service: Service, device: Inverse3):
    ready(device)
    reading = push(device, 20, np.array([1.0, 2.0, 3.0]))
    # Ours: x forward, y left, z up; theirs: x right, y forward, z up.
    assert service.board.get("motor") == (-2.0, 1.0, 3.0)
    np.testing.assert_allclose(reading.force, [1.0, 2.0, 3.0])
    assert not reading.flags & Flag.LIMITED


def test_places_are_from_the_middle_of_the_workspace_in_our_axes():
    frame = {
        "inverse3": [
            {
                "device_id": "A",
                "state": {
                    "cursor_position": {"x": 0.01, "y": -0.10, "z": 0.2},
                    "cursor_velocity": {"x": 1, "y": 2, "z": 3},
                },
            }
        ]
    }
    device = Inverse3(events=None)
    device._take(read_state(frame, "A"))
    reading = device._read(0.0)
    np.testing.assert_allclose(reading.position, [-0.03, -0.02, 0.07])
    np.testing.assert_allclose(reading.velocity, [2, -1, 3])
    assert np.isnan(reading.force).all()  # the frame does not say
    assert reading.orientation is None


@pytest.mark.parametrize("axis", range(3))
def test_a_pushed_cursor_gets_faster_where_it_is_pushed(service: Service, device: Inverse3, axis: int):
    ready(device)
    push(device, 1, np.zeros(3))
    for sign in (1.0, -1.0):
        force = np.zeros(3)
        force[axis] = 5.0 * sign
        for _ in range(100):  # while the machine stands still nobody renews the force, and the hand pushes back
            push(device, 20, -force)
            before = after = device.exchange(force)
            longest = 0.0
            while after.time < before.time + 0.05:
                last, after = after, push(device, 1, force)
                longest = max(longest, after.time - last.time)
            if longest < 0.01:
                break
        # 5 N on 0.7 kg; hand and damper make 2 m/s² at most.
        gained = sign * (after.velocity - before.velocity)[axis] / (after.time - before.time)
        assert gained > 3.0


def test_the_force_that_the_service_applies_is_the_one_recorded(service: Service, device: Inverse3):
    ready(device)
    push(device, 10)
    service.board.inject(Fault.GATE)
    reading = push(device, 20, np.array([2.0, 0.0, 0.0]))
    np.testing.assert_allclose(reading.force, [0.6, 0.0, 0.0], atol=1e-6)
    assert reading.flags & Flag.LIMITED


def test_buttons_and_orientation_of_the_handle(service: Service, device: Inverse3):
    device.open()
    service.board.set("buttons", 0b101)
    reading = push(device, 3)
    assert reading.buttons == 0b101
    # About their y, which is our x, by 2 acos(0.6).
    np.testing.assert_allclose(reading.orientation, [0.8, 0.0, 0.0, 0.6])


def test_others_devices_safety_is_not_ours(service: Service, device: Inverse3):
    ready(device)
    service.board.inject(Fault.OTHERS_SAFETY)
    service.board.wait_for("struck", bool)
    assert push(device, 30).flags & Flag.FORCE_ON


def test_a_late_answer_is_said_and_survived(service: Service, device: Inverse3):
    ready(device)
    service.board.inject(Fault.SLOW, 0.012)
    flags = Flag(0)
    for _ in range(10):
        flags |= device.exchange(np.zeros(3)).flags
    assert flags & Flag.LATE
    assert flags & Flag.STALE
    service.board.inject(Fault.NONE)
    time.sleep(0.03)
    for _ in range(500):  # the service may have to wait for its turn
        if not push(device, 1).flags & Flag.STALE:
            return
    pytest.fail("every sample is old")


@pytest.mark.parametrize("flag", ["--silent-start", "--without-status"])
def test_services_that_say_less(tmp_path, flag: str):
    with inverse_service(tmp_path, flag) as service:
        device = Inverse3(url=service.url, events=service.events)
        try:
            ready(device)
            assert push(device, 5).flags & Flag.CALIBRATED
            assert service.board.get("violations") == 0, service.board.said
        finally:
            device.close()


def test_which_of_two(tmp_path):
    with inverse_service(tmp_path, "--more") as service:
        assert present(service.url) == ["049D", "04A1"]
        with pytest.raises(DeviceError, match="2 Inverse3 are connected; name one by its identity: 049D, 04A1"):
            Inverse3(url=service.url, events=service.events).open()
        with pytest.raises(DeviceError, match='no Inverse3 has the identity "9"'):
            Inverse3("9", url=service.url, events=service.events).open()
        device = Inverse3("049D", url=service.url, events=service.events)
        device.open()
        assert device.identity == "049D"
        device.close()


def test_not_calibrated(service: Service, device: Inverse3):
    service.board.set("initialized", 0)
    device.open()
    assert not device.exchange(np.zeros(3)).flags & Flag.CALIBRATED
    with pytest.raises(DeviceError, match="is not calibrated; place its arm as Haply Hub shows"):
        device.calibrate(allow_motion=True)


def test_halting_from_elsewhere_takes_the_force_away(service: Service, device: Inverse3, stalls: Stalls):
    ready(device)
    push(device, 10)
    began = time.monotonic()
    halt(None, url=service.url)
    stalls.within(began, time.monotonic() - began, 0.5)
    stalls.within(began, service.board.gone_after(began))


def test_halting_where_nobody_is_does_nothing():
    halt(None, url="ws://127.0.0.1:9")
    halt(None, url="nonsense")


@pytest.mark.parametrize(
    ("url", "words"),
    [
        ("ws://127.0.0.1:9", "did not answer at ws://127.0.0.1:9 .*install it with Haply Hub"),
        ("http://x", "must be like ws://localhost:10001"),
        ("wss://127.0.0.1:9", "must begin with ws://"),
    ],
)
def test_where_there_is_no_service(url: str, words: str):
    with pytest.raises(DeviceError, match=words):
        Inverse3(url=url).open()


def test_events_that_cannot_be_heard_are_an_error(service: Service):
    with pytest.raises(DeviceError, match=r"the Inverse Service \(events\) did not answer"):
        Inverse3(url=service.url, events="ws://127.0.0.1:9").open()


def test_limit():
    with pytest.raises(DeviceError, match=r"must be from 0.005 to 0.08 s"):
        Inverse3(limit=0.2)


def test_events():
    disconnected = b'{"name":"device-disconnected","data":{"device_id":"A"}}'
    assert read_event(disconnected, "A") == "the Inverse3 A was disconnected"
    assert read_event(disconnected, "B") is None
    assert "ebrake_triggered" in (
        read_event(b'{"name":"device-safety-triggered","data":{"safety_type":"ebrake_triggered"},"message":""}', "A")
        or ""
    )
    assert read_event(b'{"name":"device-connected","data":null}', "A") is None
    with pytest.raises(DeviceError, match="is not a JSON object"):
        read_event(b"[1]", "A")
