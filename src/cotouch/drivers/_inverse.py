"""Haply Inverse3 through the Inverse Service: one message out, one frame back, as often as we like."""

import contextlib
import math
import threading
import time
from collections.abc import Mapping
from dataclasses import replace
from typing import final

import numpy as np

from cotouch.arrays import Float
from cotouch.device import PRESETS, DeviceSpec
from cotouch.drivers._inverse_aside import SERVICE, WHAT, halt, holders
from cotouch.drivers._inverse_frame import Grip, InverseState, choose, grip_of, read_event, read_frame, read_state
from cotouch.drivers._inverse_session import asking, command, deviations, greeting, plea
from cotouch.drivers._watch import SampleWatch, failed
from cotouch.drivers._websocket import WebSocket
from cotouch.errors import DeviceError, TransportError
from cotouch.haptics import HAPLY_FRAME, DeviceReading, Flag

EVENTS = "ws://localhost:10020"
# Where Haply's own examples in wide use stop; ten newtons are only nominal [N].
_FORCE = 5.0
# Who answers later is late: the last place is said again. A cycle at 1 kHz and its answer take a fifth of that [s].
_LATE = 0.005
# Who does not answer for this long has failed; with what follows, well within 100 ms [s].
LIMIT = 0.06
MIDDLE = (-0.01, -0.07, 0.13)
"""Middle of the box that the handle reaches, in the service's axes from the device's base; as measured on one [m]."""
_CONNECT = 2.0
# The service sends its first frame unasked; one that waits to be asked is asked after this [s].
_FIRST = 0.5
_FAREWELL = 0.05
# What the service applies may differ from what it was told by this without being limited [N, share].
_TOLERANCE = (0.05, 0.05)
_HINT = "install it with Haply Hub (develop.haply.co), start it, or give its address with the option url"
# How the workspace is set, and whose handle is whose, is asked every so many cycles: Haply Hub may change it meanwhile.
_ASK_EVERY = 50
# Pleas for a workspace as it must be, of which each may take the service a few frames.
_PLEAS, _FRAMES = 6, 5
# For somebody else who has just left a device, and between two looks whether they have [s].
_LEAVING, _AGAIN = 0.3, 0.03


@final
class Inverse3:
    """A Haply Inverse3. `cotouch.haptics.Device` says what its methods do.

    `current_cursor_force` is recorded as the force that is really applied, as the service may alter what it is told;
    where it does, the reading is flagged LIMITED. Orientation and buttons are those of the handle that belongs to the
    device; where it cannot be told which does, there are none.
    """

    def __init__(
        self,
        identity: str | None = None,
        *,
        url: str = SERVICE,
        events: str | None = EVENTS,
        limit: float = LIMIT,
        grip: str | None = None,
    ) -> None:
        """Connects to nothing yet.

        Args:
            identity: `device_id` of the device; None: the only one.
            url: of the service.
            events: of its events, by which it says that a safety function was triggered; None: do without.
            limit: within which it must answer, 0.005 to 0.08 [s].
            grip: `device_id` of the handle; None: the one that belongs to the device, if that can be told.

        Raises:
            DeviceError: the limit is out of range.
        """
        if not _LATE <= limit <= 0.08:
            raise DeviceError(f"the time limit of an answer is {limit:g} s; it must be from {_LATE:g} to 0.08 s")
        self._wanted, self._url, self._events_url, self._limit = identity, url, events, limit
        self._wanted_grip = grip
        self._middle = HAPLY_FRAME.place(MIDDLE)
        self._spec = replace(PRESETS["inverse3"], force=_FORCE)
        self._socket: WebSocket | None = None
        self._events: WebSocket | None = None
        self._identity = ""
        self._grip: Grip | None = None
        self._session: object = None  # number of ours
        self._commanded = 0  # forces in this session
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
        self._identity, self._owed, self._commanded, self._watch = "", 0, 0, SampleWatch()
        self._grip = self._session = self._last = self._reading = None
        try:
            self._socket = WebSocket(self._url, what=WHAT, timeout=_CONNECT, hint=_HINT)
            if self._events_url is not None:
                self._events = WebSocket(self._events_url, what=f"{WHAT} (events)", timeout=_CONNECT, hint=_HINT)
            frame = read_frame(self._first(self._socket))
            identity = choose(frame, self._wanted)
            self._session = frame.get("session_id")
            self._take(self._free(self._socket, read_state(frame, identity), identity))
            self._identity = identity
            self._set_workspace(self._socket)
            self._listen()
            self._check_status(opening=True)
        except TransportError as lost:
            self.close()
            raise DeviceError(f"{WHAT} at {self._url} cannot be used: {lost}") from None
        except BaseException:
            self.close()
            raise

    def calibrate(self, *, allow_motion: bool) -> None:  # noqa: ARG002
        """See `Device.calibrate`. The service calibrates; this only looks, as the device does not move by itself."""
        if not self._calibrated:
            self.exchange(np.zeros(3))
        if not self._calibrated:
            raise failed(
                self,
                f"the Inverse3 {self._identity} is not calibrated; place its arm as Haply Hub shows, and open it again",
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
            raise failed(self, "the Inverse3 was given a force that is not finite")
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
            frame = read_frame(data)
            state = read_state(frame, self._identity, self._grip)
            if state.config:
                self._grip = grip_of(frame, self._identity, self._wanted_grip)
            self._take(state)
            self._look(state)
            self._listen()
        except TransportError as lost:
            raise failed(self, f"the connection to the Inverse Service is gone: {lost}") from None
        except DeviceError as error:
            raise failed(self, str(error)) from None
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
            link.send(greeting(None))
            first = link.receive(_CONNECT)
        if first is None:
            raise DeviceError(f"{WHAT} at {self._url} sends no frame within {_CONNECT:g} s; is its version 3.1?")
        return first

    def _free(self, link: WebSocket, state: InverseState, identity: str) -> InverseState:
        """A state in which nobody uses the device; it takes the service a moment to see that somebody has left.

        Raises:
            DeviceError: somebody does.
        """
        end = time.monotonic() + _LEAVING
        while state.status.get("in_use"):
            if time.monotonic() > end:
                raise DeviceError(f"the Inverse3 {identity} is in use by {holders(self._url)}; end that first")
            time.sleep(_AGAIN)
            message, self._greeted = asking() if self._greeted else greeting(None), True
            link.send(message)
            data = link.receive(_CONNECT)
            if data is not None and (newer := read_state(read_frame(data), identity)).status:
                state = newer
        return state

    def _set_workspace(self, link: WebSocket) -> None:
        """Asks for axes, preset, mount and transform, reads them back, and asks again for what is otherwise."""
        name = self._identity
        message, self._greeted = plea(name, "preset") if self._greeted else greeting(name), True
        asked: list[str] = []
        wrong: dict[str, str] = {}
        for _ in range(_PLEAS):
            frame = self._full(link, message)
            state = read_state(frame, name)
            self._take(state)
            self._grip = grip_of(frame, name, self._wanted_grip)
            wrong = deviations(state.config, state.raw)
            # What was asked for longest ago first: a mount undoes a preset, and a preset a mount.
            what = min(wrong, key=lambda each: (asked.count(each), list(wrong).index(each)), default=None)
            if what is None:
                return
            asked.append(what)
            message = plea(name, what)
        raise DeviceError(_set_otherwise(name, wrong, "and does not let it be set back"))

    def _full(self, link: WebSocket, message: bytes) -> Mapping[str, object]:
        """A frame in full, as the answer to a message or soon after."""
        for _ in range(_FRAMES):
            link.send(message)
            data = link.receive(_CONNECT)
            if data is None:
                break
            frame = read_frame(data)
            if read_state(frame, self._identity).config:
                return frame
            message = command(self._identity, np.zeros(3), full=True)
        raise DeviceError(
            f"{WHAT} at {self._url} does not say how the workspace of the Inverse3 {self._identity} is set, so its "
            "metres may not be ours; is its version 3.1 or newer?"
        )

    def _look(self, state: InverseState) -> None:
        wrong = deviations(state.config, state.raw)
        if wrong:
            raise DeviceError(_set_otherwise(self._identity, wrong, "since a moment ago"))

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
            commanded = force.copy() if self._on else np.zeros(3)
            self._asked = time.monotonic()
            link.send(self._message(HAPLY_FRAME.back(commanded)))
            self._owed += 1
            self._sent = [self._sent[1], commanded]

    def _message(self, force: Float) -> bytes:
        first, self._greeted = not self._greeted, True
        self._commanded += 1
        return command(self._identity, force, first=first, full=self._commanded % _ASK_EVERY == 0)

    def _take(self, state: InverseState) -> None:
        if not state.status and self._last is not None:
            state = state._replace(status=self._last.status)
        self._last = state
        self._calibrated = bool(state.status.get("calibrated", True))

    @property
    def _status(self) -> Mapping[str, object]:
        assert self._last is not None
        return self._last.status

    def _check_status(self, *, opening: bool) -> None:
        status = self._status
        for name, meaning in (("power_supply", "has no power"), ("ready", "is not ready")):
            if status.get(name) is False:
                raise failed(
                    self,
                    f"the Inverse3 {self._identity} {meaning}; " + ("check Haply Hub" if opening else "force is off"),
                )

    def _listen(self) -> None:
        while self._events is not None and (event := self._events.receive(0.0)) is not None:
            why = read_event(event, self._identity, self._session)
            if why is not None:
                raise DeviceError(why)

    def _waiting(self) -> DeviceReading:
        """Nothing came: late, or too late."""
        if time.monotonic() - self._asked >= self._limit:
            raise failed(
                self, f"the Inverse Service did not answer within {1e3 * self._limit:.0f} ms; is this machine too busy?"
            )
        self._listen()
        last = self._reading
        if last is None:
            last = self._read(self._asked)
        return replace(last, flags=last.flags | Flag.LATE | Flag.STALE)

    def _read(self, at: float) -> DeviceReading:
        state = self._last
        assert state is not None
        position, velocity = HAPLY_FRAME.place(state.position) - self._middle, HAPLY_FRAME.place(state.velocity)
        why = self._watch.fault(at, position, velocity)
        if why is not None:
            raise failed(self, f"the Inverse3 {self._identity} {why}")
        applied = HAPLY_FRAME.direction(state.force)
        flags = Flag(0)
        flags |= Flag.CALIBRATED if self._calibrated else flags
        flags |= Flag.FORCE_ON if self._on else flags
        if math.isfinite(state.force[0]) and not any(_near(applied, commanded) for commanded in self._sent):
            flags |= Flag.LIMITED
        self._reading = DeviceReading(
            time=at,
            position=position,
            velocity=velocity,
            force=applied,
            buttons=state.buttons,
            flags=flags,
            orientation=None if state.orientation is None else HAPLY_FRAME.orientation(state.orientation),
        )
        return self._reading


def _near(applied: Float, commanded: Float) -> bool:
    absolute, relative = _TOLERANCE
    return float(np.linalg.norm(applied - commanded)) <= absolute + relative * float(np.linalg.norm(commanded))


def _set_otherwise(identity: str, wrong: Mapping[str, str], since: str) -> str:
    return (
        f"the workspace of the Inverse3 {identity} is set to {', '.join(wrong.values())} {since}; its metres are not "
        'ours then, so open the device\'s settings in Haply Hub and choose the preset "defaults"'
    )
