"""Linux input events, read as the kernel writes them (linux/input.h), and rumble."""

import contextlib
import errno
import os
import struct
import sys
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple, final

from cotouch.errors import DeviceError

FOLDER = Path("/dev/input")
EV_KEY, EV_ABS, _EV_FF = 0x01, 0x03, 0x15
_BTN_GAMEPAD = 0x130
_EVENT = struct.Struct("@llHHi")
# struct input_absinfo: value, minimum, maximum, fuzz, flat, resolution.
_ABSINFO = struct.Struct("@6i")
# struct ff_effect with a rumble: type, id, direction, trigger (2), replay (length, delay), strong, weak; 48 bytes.
_RUMBLE = struct.Struct("@HhHHHHH2xHH28x")
_FF_RUMBLE = 0x50
_EVIOCGABS, _EVIOCSFF = 0x80184540, 0x40304580
# A rumble ends by itself after this, so that it ends when a program does [ms].
_LENGTH = 100
# Some kernels only; what happens where the numbers above are not those of this machine is an error of ioctl.
Ioctl = Callable[[int, int, bytearray], int]
Opener = Callable[[str, int], int]


class InputEvent(NamedTuple):
    """One change.

    Attributes:
        kind: EV_KEY or EV_ABS, or one that is of no interest.
        code: which button or axis.
        value: 0 or 1 of a button; of an axis within its range.
    """

    kind: int
    code: int
    value: int


def gamepads() -> list[str]:
    """Event files of what has the buttons of a gamepad and may be read."""
    found: list[str] = []
    for path in sorted(FOLDER.glob("event*")) if FOLDER.is_dir() else []:
        with contextlib.suppress(OSError):
            descriptor = os.open(path, os.O_RDONLY | os.O_NONBLOCK)
            try:
                bits = bytearray(96)
                kernel_ioctl(descriptor, 0x80000000 | len(bits) << 16 | 0x4520 + EV_KEY, bits)
                if bits[_BTN_GAMEPAD // 8] >> _BTN_GAMEPAD % 8 & 1:
                    found.append(str(path))
            finally:
                os.close(descriptor)
    return found


def kernel_ioctl(descriptor: int, request: int, data: bytearray) -> int:
    """Asks the kernel; returns what it says.

    Args:
        descriptor: of the open device.
        request: number of the request.
        data: sent, and overwritten with the answer.
    """
    from fcntl import ioctl

    return ioctl(descriptor, request, data, True)


@final
class EventFile:
    """An open input device.

    Attributes:
        rumbles: whether it can rumble.
    """

    def __init__(self, path: str | None, *, opener: Opener = os.open, ioctl: Ioctl = kernel_ioctl) -> None:
        """Opens it.

        Args:
            path: of the event file; None: the first gamepad.
            opener: what opens files.
            ioctl: what controls them.

        Raises:
            DeviceError: there is none, or it may not be opened; says what to do.
        """
        if sys.platform != "linux":
            raise DeviceError(
                f"gamepads are supported only on Linux, and this is {sys.platform}; use one in the page instead"
            )
        if path is None:
            pads = gamepads()
            if not pads:
                raise DeviceError(
                    f"no gamepad is in {FOLDER}; connect one, and make sure that you may read its event file (group "
                    f"input)"
                )
            path = pads[0]
        self.path = path
        self._ioctl = ioctl
        self._fd = -1
        for mode in (os.O_RDWR, os.O_RDONLY):
            try:
                self._fd = opener(path, mode | os.O_NONBLOCK)
                break
            except OSError as error:
                if mode == os.O_RDONLY or error.errno not in {errno.EACCES, errno.EPERM, errno.EROFS}:
                    raise DeviceError(_why(path, error)) from None
        self.rumbles = mode == os.O_RDWR
        self._effect = -1
        self._rest = b""

    def axis(self, code: int) -> tuple[int, int, int]:
        """Value now, least and most of an axis; (0, -32768, 32767) where the device does not say."""
        data = bytearray(_ABSINFO.size)
        try:
            self._ioctl(self._fd, _EVIOCGABS + code, data)
        except OSError:
            return 0, -32768, 32767
        value, least, most, *_ = _ABSINFO.unpack(data)
        return (value, least, most) if most > least else (0, -32768, 32767)

    def events(self) -> list[InputEvent]:
        """What happened since the last look; waits for nothing.

        Raises:
            DeviceError: it is gone.
        """
        out: list[InputEvent] = []
        while True:
            try:
                data = os.read(self._fd, 64 * _EVENT.size)
            except (BlockingIOError, InterruptedError):
                return out
            except OSError as error:
                raise DeviceError(f"the gamepad {self.path} is gone: {error.strerror or error}") from None
            if not data:
                raise DeviceError(f"the gamepad {self.path} is gone")
            data = self._rest + data
            whole = len(data) - len(data) % _EVENT.size
            self._rest = data[whole:]
            out += [InputEvent(kind, code, value) for _, _, kind, code, value in _EVENT.iter_unpack(data[:whole])]

    def rumble(self, strength: float) -> None:
        """Rumbles for 100 ms, or stops at 0; where it cannot, nothing happens.

        Args:
            strength: 0 to 1.
        """
        if not self.rumbles:
            return
        size = round(65535 * min(1.0, max(0.0, strength)))
        effect = bytearray(_RUMBLE.pack(_FF_RUMBLE, self._effect, 0, 0, 0, _LENGTH, 0, size, size))
        try:
            self._ioctl(self._fd, _EVIOCSFF, effect)
            self._effect = _RUMBLE.unpack(effect)[1]
            os.write(self._fd, _EVENT.pack(0, 0, _EV_FF, self._effect, 1 if size else 0))
        except OSError:
            self.rumbles = False

    def close(self) -> None:
        """Closes it, which ends its rumble; may be called again."""
        if self._fd >= 0:
            with contextlib.suppress(OSError):
                os.close(self._fd)
            self._fd = -1


def _why(path: str, error: OSError) -> str:
    if error.errno in {errno.EACCES, errno.EPERM}:
        return f"the gamepad {path} may not be read; add yourself to the group input, or write a udev rule for it"
    if error.errno in {errno.ENOENT, errno.ENXIO, errno.ENODEV}:
        return f"there is no gamepad at {path}; connect it, or name another of {FOLDER}/event*"
    return f"the gamepad {path} cannot be opened: {error.strerror or error}"
