"""Stands in for Haply's Inverse Service 3.x: written from its published schema, with a cursor that a hand moves.

One frame in full on connection, then exactly one lean frame for every message, and events on a second port. The last
force stays until another comes, also when its client is gone: what the real service does then is not published, so the
worst is assumed. Usage: inverse_service.py folder [--silent-start] [--without-status] [--more] [--long]; prints its two
ports, and ends with its parent, or after two minutes if it is not to last long.
"""

import json
import math
import os
import selectors
import socket
import struct
import sys
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

from board import Board, Fault
from websockets.frames import Frame, Opcode
from websockets.http11 import Request
from websockets.protocol import State
from websockets.server import ServerProtocol

IDENTITY = "049D"
MASS, DAMPING, STIFFNESS = 0.7, 6.45, 135.0  # device and hand
MIDDLE = (0.0, -0.12, 0.15)
AXES = "xyz"


def xyz(values):
    return dict(zip(AXES, values, strict=True))


class Cursor:
    """A mass in a hand that goes round; keeps the force that it was told last."""

    def __init__(self, board, log):
        self.board, self.log = board, log
        self.begun = self.then = time.monotonic()
        self.x, self.v, self.force = list(MIDDLE), [0.0] * 3, [0.0] * 3

    def advance(self):
        now = time.monotonic()
        left, self.then = min(now - self.then, 0.05), now
        while left > 0.0:
            T, left = min(left, 1e-3), left - 1e-3
            for a in range(3):
                hand = MIDDLE[a] + 0.03 * math.sin(6.283 * (now - self.begun) + a)
                self.v[a] += T / MASS * (STIFFNESS * (hand - self.x[a]) - DAMPING * self.v[a] + self.force[a])
                self.x[a] += T * self.v[a]

    def push(self, force):
        if force != self.force:
            self.force = force
            self.board.set("motor", *force)
            self.log.write(struct.pack("<4d", time.monotonic(), *force))


class Client:
    def __init__(self, connection, events):
        self.connection, self.events = connection, events
        self.protocol = ServerProtocol()
        self.greeted = False

    def feed(self, data):
        if data:
            self.protocol.receive_data(data)
        else:
            self.protocol.receive_eof()
        return self.protocol.events_received()

    def flush(self):
        for data in self.protocol.data_to_send():
            try:
                if data:
                    self.connection.sendall(data)
                else:
                    self.connection.shutdown(socket.SHUT_WR)
            except OSError:
                return

    def tell(self, message):
        if self.protocol.state is State.OPEN:
            self.protocol.send_text(json.dumps(message).encode())
            self.flush()


class Service:
    def __init__(self, folder, flags):
        self.board, self.flags = Board(folder), flags
        self.cursor = Cursor(self.board, (folder / "motors").open("ab", buffering=0))
        self.selector = selectors.DefaultSelector()
        self.ports = []
        for events in (False, True):
            listener = socket.create_server(("127.0.0.1", 0))
            self.selector.register(listener, selectors.EVENT_READ, events)
            self.ports.append(listener.getsockname()[1])
        self.clients = []
        self.due = []  # (when, client, message)
        self.frozen = None
        self.announced = 0

    def met(self, fault):
        if self.board.get("fault") != fault:
            return False
        if self.board.get("struck") == 0.0:
            self.board.set("struck", time.monotonic())
        return True

    def state(self):
        cursor = self.cursor
        cursor.advance()
        place, rate = list(cursor.x), list(cursor.v)
        if self.met(Fault.FROZEN):
            self.frozen = self.frozen or (place, rate)
            place, rate = self.frozen
        if self.met(Fault.NOT_A_NUMBER):
            place = [math.nan, *place[1:]]
        state = {
            "cursor_position": xyz(place),
            "cursor_velocity": xyz(rate),
            "angular_position": {"a0": 0.0, "a1": 0.0, "a2": 0.0},
            "angular_velocity": {"a0": 0.0, "a1": 0.0, "a2": 0.0},
            "body_orientation": {"w": 1.0, "x": 0.0, "y": 0.0, "z": 0.0},
            "current_cursor_force": xyz(cursor.force),
            "current_cursor_position": xyz(place),
            "current_angular_torques": {"a0": 0.0, "a1": 0.0, "a2": 0.0},
            "control_domain": "cartesian",
            "control_mode": "force" if any(cursor.force) else "idle",
            "mode": "idle",
        }
        if self.met(Fault.MISSING):
            del state["cursor_position"]
        return state

    def frame(self, full):
        device = {"device_id": IDENTITY}
        if full:
            device["config"] = {
                "type": "inverse3", "port": "COM12",
                "device_info": {"major_version": 7, "minor_version": 4, "id": IDENTITY, "device_type": 4, "uuid": "0"},
                "gravity_compensation": {"enabled": True, "scaling_factor": 1.0}, "handedness": "right",
                "torque_scaling": {"enabled": True}, "preset": "defaults", "basis": {"permutation": "XYZ"},
                "filters": {"force_gate": {"gain": 0.3}, "damping": {"scalar": 0.0}},
            }  # fmt: skip
        device["state"] = self.state()
        if full:
            device["state"]["transform"] = {"position": xyz((0, 0, 0)), "scale": xyz((1, 1, 1))}
        if full or "--without-status" not in self.flags:
            device["status"] = {
                "calibrated": self.board.get("initialized") == 1,
                "in_use": False,
                "power_supply": True,
                "ready": not self.met(Fault.NOT_READY),
                "started": True,
            }
        devices = [] if self.met(Fault.UNPLUGGED) else [device]
        if "--more" in self.flags:
            devices.append({**device, "device_id": "04A1"})
        buttons = self.board.get("buttons")
        grip = {"orientation": {"w": 0.6, "x": 0.0, "y": 0.8, "z": 0.0}}
        wireless = {"buttons": {name: bool(buttons >> n & 1) for n, name in enumerate("abc")}, "battery_level": 0.9}
        return {
            **({"session_id": 7} if full else {}),
            "inverse3": devices,
            "verse_grip": [],
            "wireless_verse_grip": [
                {
                    "device_id": "61548",
                    "state": {**grip, **wireless},
                    "status": {"connected": True, "awake": True, "ready": True},
                }
            ],
        }

    def violated(self, what):
        self.board.set("violations", self.board.get("violations") + 1)
        self.board.set("said", what.encode()[:63])

    def message(self, client, data):
        try:
            told = json.loads(data, parse_constant=lambda name: self.violated(f"{name} is no JSON"))
        except ValueError:
            self.violated("no JSON")
            return
        if ("session" in told) == client.greeted:
            self.violated("session in the first message, and only there")
        client.greeted = True
        for device in told.get("inverse3", []):
            if device["device_id"] != IDENTITY:
                self.violated(f"no device {device['device_id']}")
                continue
            values = device["commands"]["set_cursor_force"]["values"]
            gain = 0.3 if self.met(Fault.GATE) else 1.0
            self.cursor.advance()
            self.cursor.push([gain * values[axis] for axis in AXES])
            self.board.set("sets", self.board.get("sets") + 1)
        if self.met(Fault.SILENT):
            return
        if self.met(Fault.SLOW):
            self.due.append((time.monotonic() + self.board.get("value"), client))
        else:
            client.tell(self.frame(False))

    def announce(self):
        fault = self.board.get("fault")
        if fault == self.announced:
            return
        self.announced = fault
        name, data = {
            Fault.SAFETY: ("device-safety-triggered", {"device_id": IDENTITY, "safety_type": "stall_detected"}),
            Fault.UNPLUGGED: ("device-disconnected", {"device_id": IDENTITY}),
            Fault.OTHERS_SAFETY: ("device-safety-triggered", {"device_id": "FFFF", "safety_type": "stall_detected"}),
        }.get(fault, ("", {}))
        if name:
            self.met(fault)
            for client in self.clients:
                if client.events:
                    client.tell({"name": name, "category": "device", "level": "error", "data": data, "message": "m"})

    def ready(self, client):
        try:
            data = client.connection.recv(65536)
        except OSError:
            data = b""
        for event in client.feed(data):
            if isinstance(event, Request):
                client.protocol.send_response(client.protocol.accept(event))
                client.flush()
                if not client.events and "--silent-start" not in self.flags:
                    client.tell(self.frame(True))
            elif isinstance(event, Frame) and event.opcode is Opcode.TEXT and not client.events:
                self.message(client, event.data)
        client.flush()
        if not data or client.protocol.state is State.CLOSED:
            self.drop(client)

    def drop(self, client):
        if client in self.clients:
            self.clients.remove(client)
            self.selector.unregister(client.connection)
            client.connection.close()

    def run(self):
        print(*self.ports, flush=True)
        parent, end = os.getppid(), time.monotonic() + (3600.0 if "--long" in self.flags else 120.0)
        while time.monotonic() < end and os.getppid() == parent:
            for key, _ in self.selector.select(0.001):
                if isinstance(key.data, Client):
                    self.ready(key.data)
                else:
                    connection, _ = key.fileobj.accept()
                    connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
                    client = Client(connection, key.data)
                    self.clients.append(client)
                    self.selector.register(connection, selectors.EVENT_READ, client)
            self.announce()
            self.cursor.advance()
            if self.board.get("fault") == Fault.CLOSED and self.board.get("struck") == 0.0:
                self.met(Fault.CLOSED)
                for client in [client for client in self.clients if not client.events]:
                    self.drop(client)
            while self.due and self.due[0][0] <= time.monotonic():
                self.due.pop(0)[1].tell(self.frame(False))


if __name__ == "__main__":
    Service(Path(sys.argv[1]), sys.argv[2:]).run()
