"""Gamepads: events as the kernel writes them, sticks to places, force to rumble."""

import errno
import os
import socket
import struct
from pathlib import Path

import numpy as np
import pytest
from tests.drivers.inside import Gamepad

from cotouch.errors import DeviceError

EVENT = struct.Struct("@llHHi")


class Pad:
    """Stands in for an event file: one end of a pair of sockets, and an ioctl that knows two requests."""

    def __init__(self) -> None:
        self.time = 0.0
        self.effects: list[int] = []
        self.played: list[int] = []

    def __enter__(self) -> "Pad":
        self._ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        self._ours.setblocking(False)
        theirs.setblocking(False)
        self._theirs = theirs
        return self

    def __exit__(self, *_: object) -> None:
        self._ours.close()
        self._theirs.close()

    def opened(self, path: str, flags: int) -> int:
        assert flags & os.O_NONBLOCK
        return os.dup(self._theirs.fileno())

    def ioctl(self, descriptor: int, request: int, data: bytearray) -> int:
        if request == 0x40304580:  # EVIOCSFF
            kind, number, *_, length, _delay, strong, weak = struct.unpack("@HhHHHHH2xHH28x", data)
            assert kind == 0x50
            assert 0 < length <= 200
            assert strong == weak
            self.effects.append(strong)
            struct.pack_into("@h", data, 2, 5 if number == -1 else number)
        elif 0x80184540 <= request < 0x80184580:  # EVIOCGABS
            struct.pack_into("@6i", data, 0, 128, 0, 255, 0, 0, 0)
        else:
            raise OSError(errno.EINVAL, "no such request")
        return 0

    def event(self, kind: int, code: int, value: int) -> None:
        self._ours.send(EVENT.pack(0, 0, kind, code, value))

    def plays(self) -> list[int]:
        """Values of the effects that were started or stopped since the last look."""
        out = []
        while True:
            try:
                _, _, kind, code, value = EVENT.unpack(self._ours.recv(64))
            except BlockingIOError:
                return out
            assert (kind, code) == (0x15, 5)
            out.append(value)

    def unplug(self) -> None:
        self._ours.close()

    def device(self) -> Gamepad:
        return Gamepad("/dev/input/event7", opener=self.opened, ioctl=self.ioctl)

    def timed(self) -> Gamepad:
        return Gamepad("x", clock=lambda: self.time, opener=self.opened, ioctl=self.ioctl)


@pytest.fixture
def pad():
    with Pad() as pad:
        yield pad


def cycles(pad: Pad, device: Gamepad, count: int, force=(0.0, 0.0, 0.0)):
    for _ in range(count):
        pad.time += 0.01
        reading = device.exchange(np.array(force))
    return reading


def test_sticks_lead_a_point_no_faster_than_the_limit(pad: Pad):
    device = pad.timed()
    device.open()
    assert cycles(pad, device, 3).position.tolist() == [0.0, 0.0, 0.0]  # 128 of 255 is within the dead zone
    pad.event(3, 1, 0)  # ABS_Y all the way forward
    reading = cycles(pad, device, 10)
    np.testing.assert_allclose(reading.position, [0.02, 0.0, 0.0])  # 0.2 m/s
    np.testing.assert_allclose(reading.velocity, [0.2, 0.0, 0.0])
    assert cycles(pad, device, 100).position.tolist() == pytest.approx([0.1, 0.0, 0.0])
    pad.event(3, 0, 255)  # right
    pad.event(3, 4, 255)  # right stick towards the user: down
    reading = cycles(pad, device, 200)
    np.testing.assert_allclose(reading.position, 0.1 * np.array([1, -1, -1]) / np.sqrt(3))
    assert reading.velocity.tolist() == [0.0, 0.0, 0.0]
    device.close()


def test_positions_are_the_sum_of_velocities(pad: Pad):
    device = pad.timed()
    device.open()
    place = np.zeros(3)
    rng = np.random.default_rng(1)
    for _ in range(200):
        pad.event(3, int(rng.choice([0, 1, 4])), int(rng.integers(256)))
        reading = cycles(pad, device, 1)
        place += 0.01 * reading.velocity
        np.testing.assert_allclose(reading.position, place, atol=1e-12)
        assert np.linalg.norm(reading.velocity) <= 0.2 + 1e-12
    device.close()


def test_buttons(pad: Pad):
    device = pad.timed()
    device.open()
    pad.event(1, 0x130, 1)
    pad.event(1, 0x133, 1)
    assert cycles(pad, device, 1).buttons == 0b1001
    pad.event(1, 0x130, 0)
    assert cycles(pad, device, 1).buttons == 0b1000
    device.close()


def test_rumble_follows_the_size_of_the_force_and_ends_when_stopped(pad: Pad):
    device = pad.timed()
    device.open()
    cycles(pad, device, 20, (2.0, 0.0, 0.0))
    assert pad.plays() == []  # not enabled
    device.enable_force()
    cycles(pad, device, 20, (0.0, 2.0, 0.0))
    assert 3 <= len(pad.effects) <= 5  # one in 50 ms
    assert set(pad.effects) == {round(65535 * 0.5)}
    assert pad.plays() == [1] * len(pad.effects)
    cycles(pad, device, 10, (0.0, 0.0, 99.0))
    assert pad.effects[-1] == 65535
    pad.plays()
    device.stop()
    assert pad.effects[-1] == 0
    assert pad.plays() == [0]
    device.close()


def test_a_pad_that_goes_away(pad: Pad):
    device = pad.timed()
    device.open()
    pad.unplug()
    with pytest.raises(DeviceError, match="the gamepad x is gone"):
        cycles(pad, device, 1)
    device.stop()
    device.close()


@pytest.mark.parametrize(
    ("number", "words"),
    [
        (errno.EACCES, "may not be read; add yourself to the group input"),
        (errno.ENOENT, "there is no gamepad at /dev/input/event7; connect it"),
        (errno.EIO, "cannot be opened"),
    ],
)
def test_a_pad_that_cannot_be_opened(number: int, words: str):
    def opener(path: str, flags: int) -> int:
        raise OSError(number, os.strerror(number))

    with pytest.raises(DeviceError, match=words):
        Gamepad("/dev/input/event7", opener=opener).open()


def test_a_pad_that_may_only_be_read_does_not_rumble(pad: Pad):
    def opener(path: str, flags: int) -> int:
        if flags & os.O_RDWR:
            raise PermissionError(errno.EACCES, "no")
        return pad.opened(path, flags)

    device = Gamepad("x", opener=opener, ioctl=pad.ioctl, clock=lambda: pad.time)
    device.open()
    device.enable_force()
    cycles(pad, device, 20, (2.0, 0.0, 0.0))
    assert pad.effects == []
    device.close()


def test_no_pad_here(monkeypatch: pytest.MonkeyPatch, tmp_path: Path):
    monkeypatch.setattr("cotouch.drivers._evdev.FOLDER", tmp_path)
    with pytest.raises(DeviceError, match=f"no gamepad is in {tmp_path}; connect one, and make sure that you may read"):
        Gamepad().open()


def test_speed():
    with pytest.raises(DeviceError, match=r"must be from 0.01 to 2"):
        Gamepad(speed=5.0)
