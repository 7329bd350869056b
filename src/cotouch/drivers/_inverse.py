"""Haply Inverse3 through the Inverse Service: one message out, one frame back, as often as we like."""

import contextlib
import math
import threading
import time
from dataclasses import replace
from typing import final

import numpy as np
import numpy.typing as npt

from cotouch.device import PRESETS, DeviceSpec
from cotouch.drivers._inverse_frame import InverseState, choose, identities, read_event, read_frame, read_state
from cotouch.drivers._watch import SampleWatch
from cotouch.drivers._websocket import WebSocket
from cotouch.errors import DeviceError, TransportError
from cotouch.haptics import HAPLY, DeviceReading, Flag

Float = npt.NDArray[np.float64]

SERVICE = "ws://localhost:10001"
EVENTS = "ws://localhost:10020"
# Where Haply's own examples in wide use stop; ten newtons are only nominal [N].
_FORCE = 5.0
# Who answers later is late: the last place is said again. A cycle at 1 kHz and its answer take a fifth of that [s].
_LATE = 0.005
# Who does not answer for this long has failed; with what follows, well within 100 ms [s].
LIMIT = 0.06
MIDDLE = (0.0, -0.12, 0.15)
"""Where the handle is in the middle of its workspace, in the service's axes; nominal [m]."""
_CONNECT = 2.0
# The service sends its first frame unasked; one that waits to be asked is asked after this [s].
_FIRST = 0.5
_FAREWELL = 0.05
# What the service applies may differ from what it was told by this without being limited [N, share].
_TOLERANCE = (0.05, 0.05)
_HINT = "install it with Haply Hub (develop.haply.co), start it, or say with the option url where it is"
_WHAT = "the Inverse Service"
# Of the first message only; axes as the device has them, whatever was set up in Haply Hub. One brace is left open.
_SESSION = b'"session":{"configure":{"profile":{"name":"org.cotouch:hand"},"basis":{"permutation":"XYZ"}}'


@final
class Inverse3:
    """A Haply Inverse3. `cotouch.haptics.Device` says what its methods do.

    `current_cursor_force` is recorded as the force that is really applied, as the service may alter what it is told;
    where it does, the reading is flagged LIMITED. A handle's orientation and buttons are in the reading.
    """

    def __init__(
        self,
        identity: str | None = None,
        *,
        url: str = SERVICE,
        events: str | None = EVENTS,
        limit: float = LIMIT,
        middle: tuple[float, float, float] = MIDDLE,
    ) -> None:
        """Connects to nothing yet.

        Args:
            identity: `device_id` of the device; None: the only one.
            url: of the service.
            events: of its events, by which it says that a safety function was triggered; None: do without.
            limit: within which it must answer, 0.005 to 0.08 [s].
            middle: of the workspace, in the service's axes [m].

        Raises:
            DeviceError: the limit is out of range.
        """
        if not _LATE <= limit <= 0.08:
            raise DeviceError(f"the time limit of an answer is {limit:g} s; it must be from {_LATE:g} to 0.08 s")
        self._wanted, self._url, self._events_url, self._limit = identity, url, events, limit
        self._middle = HAPLY.place(middle)
        self._spec = replace(PRESETS["inverse3"], force=_FORCE)
        self._socket: WebSocket | None = None
        self._events: WebSocket | None = None
        self._identity = ""
        self._lock = threading.Lock()  # what is sent after stop() is zero
        self._on = False
        self._greeted = False
        self._lost = False  # the connection is gone, and zero was sent over another one
        self._owed = 0  # answers that are still to come
        self._asked = 0.0
        self._sent: list[Float] = [np.zeros(3), np.zeros(3)]
        self._last: InverseState | None = None
        self._reading: DeviceReading | None = None
        self._watch = SampleWatch()
        self._calibrated = False

    @property
    def spec(self) -> DeviceSpec:
        """Limits, nominal: the service tells none."""
        return self._spec

    @property
    def identity(self) -> str:
        """`device_id` of the opened device; empty before."""
        return self._identity

    def open(self) -> None:
        """See `Device.open`."""
        self.close()
        self._on = self._greeted = self._lost = False
        self._identity, self._owed, self._watch = "", 0, SampleWatch()
        try:
            self._socket = WebSocket(self._url, what=_WHAT, timeout=_CONNECT, hint=_HINT)
            if self._events_url is not None:
                self._events = WebSocket(self._events_url, what=f"{_WHAT} (events)", timeout=_CONNECT, hint=_HINT)
            frame = read_frame(self._first(self._socket))
            self._identity = choose(frame, self._wanted)
            self._take(read_state(frame, self._identity))
            self._check_status(opening=True)
        except TransportError as lost:
            self.close()
            raise DeviceError(f"{_WHAT} at {self._url} cannot be used: {lost}") from None
        except BaseException:
            self.close()
            raise

    def calibrate(self, *, allow_motion: bool) -> None:
        """See `Device.calibrate`. The service calibrates; this only looks, as the device does not move by itself."""
        del allow_motion
        if not self._calibrated:
            self.exchange(np.zeros(3))
        if not self._calibrated:
            raise self._fault(
                f"the Inverse3 {self._identity} is not calibrated; put its arm as Haply Hub shows it, and open it anew"
            )

    def enable_force(self, on: bool = True) -> None:
        """See `Device.enable_force`."""
        self._opened()
        if on:
            self._on = True
        else:
            self.stop()

    def exchange(self, force: Float) -> DeviceReading:
        """See `Device.exchange`."""
        link = self._opened()
        if not np.isfinite(force).all():
            raise self._fault("the Inverse3 was told a force that is not finite")
        try:
            if self._owed == 0:
                self._send(link, force)
            data = link.receive(max(0.0, min(_LATE, self._asked + self._limit - time.monotonic())))
            if data is None:
                return self._waiting()
            while (newer := link.receive(0.0)) is not None:
                data = newer
            self._owed = 0
            now = time.monotonic()
            self._take(read_state(read_frame(data), self._identity))
            self._listen()
        except TransportError as lost:
            raise self._fault(f"the connection to the Inverse Service is gone: {lost}") from None
        except DeviceError as error:
            raise self._fault(str(error)) from None
        self._check_status(opening=False)
        return self._read(0.5 * (self._asked + now))

    def stop(self) -> None:
        """See `Device.stop`. Where the connection is gone, zero is sent over another one."""
        self._on = False
        link = self._socket
        if link is None or self._lost or not self._identity:
            return
        if not self._lock.acquire(timeout=0.02):
            self._leave(link)
            return
        try:
            link.send(self._message(np.zeros(3)))
            self._owed += 1
            self._sent = [np.zeros(3), np.zeros(3)]
        except Exception:  # noqa: BLE001  whatever it is, this connection is of no use any more
            self._leave(link)
        finally:
            self._lock.release()

    def close(self) -> None:
        """See `Device.close`."""
        self.stop()
        link, events = self._socket, self._events
        self._socket = self._events = None
        end = time.monotonic() + _FAREWELL
        with contextlib.suppress(Exception):
            while link is not None and self._owed > 0 and (left := end - time.monotonic()) > 0.0:
                if link.receive(left) is not None:
                    self._owed -= 1
        for each in (link, events):
            if each is not None:
                each.close()

    def _first(self, link: WebSocket) -> bytes:
        first = link.receive(_FIRST)
        if first is None:
            self._greeted = True
            link.send(b"{" + _SESSION + b',"force_render_full_state":{}}}')
            first = link.receive(_CONNECT)
        if first is None:
            raise DeviceError(f"{_WHAT} at {self._url} sends no frame within {_CONNECT:g} s; is its version 3.1?")
        return first

    def _leave(self, link: WebSocket) -> None:
        self._lost = True
        link.abort()
        halt(self._identity, url=self._url)

    def _opened(self) -> WebSocket:
        if self._socket is None:
            raise DeviceError("the Inverse3 is not open; open it first")
        return self._socket

    def _send(self, link: WebSocket, force: Float) -> None:
        with self._lock:
            told = force.copy() if self._on else np.zeros(3)
            self._asked = time.monotonic()
            link.send(self._message(HAPLY.back(told)))
            self._owed += 1
            self._sent = [self._sent[1], told]

    def _message(self, force: Float) -> bytes:
        session, self._greeted = b"" if self._greeted else _SESSION + b"},", True
        return b"{" + session + _command(self._identity, force) + b"}"

    def _take(self, state: InverseState) -> None:
        if not state.status and self._last is not None:
            state = state._replace(status=self._last.status)
        self._last = state
        self._calibrated = bool(state.status.get("calibrated", True))

    def _check_status(self, *, opening: bool) -> None:
        assert self._last is not None
        status = self._last.status
        for name, meaning in (("power_supply", "has no power"), ("ready", "is not ready")):
            if status.get(name) is False:
                raise self._fault(
                    f"the Inverse3 {self._identity} {meaning}; "
                    + ("look into Haply Hub" if opening else "force is off")
                )

    def _listen(self) -> None:
        while self._events is not None and (event := self._events.receive(0.0)) is not None:
            why = read_event(event, self._identity)
            if why is not None:
                raise DeviceError(why)

    def _waiting(self) -> DeviceReading:
        """Nothing came: late, or too late."""
        if time.monotonic() - self._asked >= self._limit:
            raise self._fault(
                f"the Inverse Service did not answer within {1e3 * self._limit:.0f} ms; is this machine too busy?"
            )
        self._listen()
        last = self._reading
        if last is None:
            last = self._read(self._asked)
        return replace(last, flags=last.flags | Flag.LATE | Flag.STALE)

    def _read(self, at: float) -> DeviceReading:
        state = self._last
        assert state is not None
        position, velocity = HAPLY.place(state.position) - self._middle, HAPLY.place(state.velocity)
        why = self._watch.fault(at, position, velocity)
        if why is not None:
            raise self._fault(f"the Inverse3 {self._identity} {why}")
        applied = HAPLY.direction(state.force)
        flags = Flag(0)
        flags |= Flag.CALIBRATED if self._calibrated else flags
        flags |= Flag.FORCE_ON if self._on else flags
        if math.isfinite(state.force[0]) and not any(_near(applied, told) for told in self._sent):
            flags |= Flag.LIMITED
        self._reading = DeviceReading(
            time=at,
            position=position,
            velocity=velocity,
            force=applied,
            buttons=state.buttons,
            flags=flags,
            orientation=None if state.orientation is None else HAPLY.orientation(state.orientation),
        )
        return self._reading

    def _fault(self, why: str) -> DeviceError:
        """Takes the force away, and says why."""
        self.stop()
        return DeviceError(why)


def _near(applied: Float, told: Float) -> bool:
    absolute, relative = _TOLERANCE
    return float(np.linalg.norm(applied - told)) <= absolute + relative * float(np.linalg.norm(told))


def halt(identity: str | None, *, url: str = SERVICE) -> None:
    """Tells the service zero force from elsewhere; blocks for 50 ms at most and never raises.

    Args:
        identity: `device_id` of the device; None: every Inverse3 that the service knows.
        url: of the service.
    """
    end = time.monotonic() + 0.045
    with contextlib.suppress(Exception):
        link = WebSocket(url, what=_WHAT, timeout=0.03)
        try:
            first = link.receive(max(0.0, end - time.monotonic() - 0.01))
            there = identities(read_frame(first)) if first is not None else []
            for each in [identity] if identity is not None else there:
                link.send(_zero(each))
            link.receive(max(0.0, end - time.monotonic()))
        finally:
            link.close()


def present(url: str = SERVICE) -> list[str]:
    """Identities of the Inverse3 that a service on this machine knows; none if there is no service."""
    with contextlib.suppress(Exception):
        link = WebSocket(url, what=_WHAT, timeout=0.2)
        try:
            first = link.receive(_FIRST)
            return identities(read_frame(first)) if first is not None else []
        finally:
            link.close()
    return []


def _zero(identity: str) -> bytes:
    return b"{" + _SESSION + b"}," + _command(identity, np.zeros(3)) + b"}"


def _command(identity: str, force: Float) -> bytes:
    x, y, z = force.tolist()
    return (
        f'"inverse3":[{{"device_id":"{identity}","commands":{{"set_cursor_force":'
        f'{{"values":{{"x":{x:.6g},"y":{y:.6g},"z":{z:.6g}}}}}}}}}]'
    ).encode()
