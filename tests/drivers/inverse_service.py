"""Stands in for Haply's Inverse Service 3.x: written from its published schema, with a cursor that a hand moves.

One frame in full on connection, then exactly one lean frame for every message, and events on a second port. The last
force stays until another comes, also when its client is gone: what the real service does then is not published, so the
worst is assumed. Every session has axes, preset, mount and transform of its own, and positions are told through them.
Usage: inverse_service.py folder [flags]; prints its two ports, and ends with its parent, or after two minutes if it is
not to last long. Flags:

    --silent-start, --without-status, --more (devices), --long
    --hub={"mount":{"scale":{...}}}  what Haply Hub kept of a profile, and applies again when a session says its name
    --stubborn                       does not take a mount or a preset
    --sparing                        never says how a workspace is set
    --held                           another session holds the device; --left: it leaves after a moment
    --grips=[["wireless_verse_grip","61548",{}],...]  handles, and what is said of each beside its state; the bits of
                                     `buttons` from 3 n on are those of handle n
"""

import json
import math
import os
import selectors
import socket
import struct
import sys
import time
from http import HTTPStatus
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

from board import Board, Fault
from websockets.frames import Frame, Opcode
from websockets.http11 import Request
from websockets.protocol import State
from websockets.server import ServerProtocol

IDENTITY = "049D"
MASS, DAMPING, STIFFNESS = 0.7, 6.45, 135.0  # device and hand
MIDDLE = (-0.01, -0.07, 0.13)
AXES = "xyz"
HOLDER = "com.example:painter"
GRIPS = [["wireless_verse_grip", "61548", {}]]
IDENTITY_TRANSFORM = {
    "position": {"x": 0, "y": 0, "z": 0},
    "rotation": {"w": 1, "x": 0, "y": 0, "z": 0},
    "scale": {"x": 1, "y": 1, "z": 1},
}


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
            self.log.write(struct.pack("<7d", time.monotonic(), *force, 0.0, 0.0, 0.0))


class Client:
    def __init__(self, connection, events):
        self.connection, self.events = connection, events
        self.protocol = ServerProtocol()
        self.greeted = self.full = self.commanded = False
        self.number = 0
        self.preset, self.axes = "defaults", "XYZ"
        self.mount, self.transform = dict(IDENTITY_TRANSFORM), dict(IDENTITY_TRANSFORM)

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
        self.sessions = 6
        self.leaves = math.inf  # a moment after somebody came
        given = {flag.partition("=")[0]: flag.partition("=")[2] for flag in flags}
        self.hub = json.loads(given.get("--hub", "{}"))
        self.grips = json.loads(given["--grips"]) if "--grips" in given else GRIPS

    def met(self, fault):
        if self.board.get("fault") != fault:
            return False
        if self.board.get("struck") == 0.0:
            self.board.set("struck", time.monotonic())
        return True

    def state(self, client):
        cursor = self.cursor
        cursor.advance()
        place, rate = list(cursor.x), list(cursor.v)
        if self.met(Fault.FROZEN):
            self.frozen = self.frozen or (place, rate)
            place, rate = self.frozen
        if self.met(Fault.RESCALED):
            client.mount = client.mount | {"scale": {"x": 2, "y": 2, "z": 2}}
        if self.met(Fault.MOVED):
            client.transform = client.transform | {"scale": {"x": 3, "y": 3, "z": 3}}
        for seen in (client.mount, client.transform):
            scale = [seen["scale"][axis] for axis in AXES]
            place = [s * x + seen["position"][axis] for s, x, axis in zip(scale, place, AXES, strict=True)]
            rate = [s * v for s, v in zip(scale, rate, strict=True)]
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
            # What is as it is by itself is left out.
            "transform": {name: seen for name, seen in client.transform.items() if seen != IDENTITY_TRANSFORM[name]},
        }
        if self.met(Fault.MISSING):
            del state["cursor_position"]
        return state

    def in_use(self):
        held = "--held" in self.flags or ("--left" in self.flags and time.monotonic() < self.leaves)
        return held or any(client.commanded for client in self.clients)

    def frame(self, client, full):
        full = full or client.full
        client.full = False
        device = {"device_id": IDENTITY}
        if full:
            device["config"] = {
                "type": "inverse3", "port": "COM12",
                "device_info": {"major_version": 7, "minor_version": 4, "id": IDENTITY, "device_type": 4, "uuid": "0"},
                "gravity_compensation": {"enabled": True, "scaling_factor": 1.0}, "handedness": "right",
                "torque_scaling": {"enabled": True}, "preset": client.preset, "basis": {"permutation": client.axes},
                "mount": client.mount, "filters": {"force_gate": {"gain": 0.3}, "damping": {"scalar": 0.0}},
            }  # fmt: skip
            if "--sparing" in self.flags:
                del device["config"]
        device["state"] = self.state(client)
        if full or "--without-status" not in self.flags:
            device["status"] = {
                "calibrated": self.board.get("initialized") == 1,
                "in_use": self.in_use(),
                "power_supply": True,
                "ready": not self.met(Fault.NOT_READY),
                "started": True,
            }
        devices = [] if self.met(Fault.UNPLUGGED) else [device]
        if "--more" in self.flags:
            other = {**device, "device_id": "04A1"}
            if "config" in device:
                other["config"] = device["config"] | {"handedness": "left"}
            devices.append(other)
        return {
            **({"session_id": client.number} if full else {}),
            "inverse3": devices,
            "verse_grip": self.handles("verse_grip", full),
            "wireless_verse_grip": self.handles("wireless_verse_grip", full),
        }

    def handles(self, kind, full):
        found = []
        for number, (its, identity, said) in enumerate(self.grips):
            pressed = self.board.get("buttons") >> 3 * number & 7
            wireless = {"buttons": {name: bool(pressed >> n & 1) for n, name in enumerate("abc")}, "battery_level": 0.9}
            state = {"orientation": {"w": 0.6, "x": 0.0, "y": 0.8, "z": 0.0}}
            state |= wireless if kind == "wireless_verse_grip" else {"button": bool(pressed & 1), "hall": 0}
            status = {"connected": True, "awake": True, "ready": True} | said.get("status", {})
            commanded = {key: value for key, value in said.items() if full and key != "status"}
            if its == kind:
                found.append({"device_id": identity, "state": state, "status": status, **commanded})
        return found

    def violated(self, what):
        self.board.set("violations", self.board.get("violations") + 1)
        self.board.set("said", what.encode()[:63])

    def message(self, client, data):
        try:
            commanded = json.loads(data, parse_constant=lambda name: self.violated(f"{name} is no JSON"))
        except ValueError:
            self.violated("no JSON")
            return
        session = commanded.get("session", {})
        if ("configure" in session) == client.greeted:
            self.violated("session.configure in the first message, and only there")
        client.greeted = True
        client.full = "force_render_full_state" in session
        if session.get("configure", {}).get("profile"):
            client.mount = client.mount | self.hub.get("mount", {})
            client.transform = client.transform | self.hub.get("transform", {})
            client.preset = self.hub.get("preset", client.preset)
        for device in commanded.get("inverse3", []):
            if device["device_id"] != IDENTITY:
                self.violated(f"no device {device['device_id']}")
                continue
            self.configure(client, device.get("configure", {}))
            commands = device.get("commands", {})
            client.transform = commands.get("set_transform", {}).get("transform", client.transform)
            if "set_cursor_force" not in commands:
                continue
            values = commands["set_cursor_force"]["values"]
            gain = 0.3 if self.met(Fault.GATE) else 1.0
            self.cursor.advance()
            self.cursor.push([gain * values[axis] for axis in AXES])
            client.commanded = True
            self.board.set("sets", self.board.get("sets") + 1)
        if self.met(Fault.SILENT):
            return
        if self.met(Fault.SLOW):
            self.due.append((time.monotonic() + self.board.get("value"), client))
        else:
            client.tell(self.frame(client, False))

    def configure(self, client, wanted):
        if {"preset", "mount"} <= wanted.keys():
            self.violated("preset and mount in one message")
        if "--stubborn" in self.flags:
            return
        client.axes = wanted.get("basis", {}).get("permutation", client.axes)
        if "mount" in wanted:
            client.mount, client.preset = wanted["mount"]["transform"], "custom"
        if "preset" in wanted and "mount" not in self.hub:  # a mount of the Hub's comes after it, and stays
            client.mount, client.preset = dict(IDENTITY_TRANSFORM), wanted["preset"]["preset"]

    def announce(self):
        fault = self.board.get("fault")
        if fault == self.announced:
            return
        self.announced = fault
        safety = {"device_family": "inverse", "device_id": IDENTITY}
        grip = {"device_family": "verse_grip", "device_id": "61548"}
        commanded = {
            Fault.SAFETY: [("device-safety-triggered", "warning", safety | {"safety_type": "stall_detected"})],
            Fault.UNPLUGGED: [("device-disconnected", "warning", safety)],
            Fault.OTHERS_SAFETY: [
                ("device-safety-triggered", "error", safety | {"device_id": "FFFF", "safety_type": "stall_detected"})
            ],
            Fault.BUSY: [("device-busy", "warning", safety | {"session_id": 99, "profile": {"name": HOLDER}})],
            Fault.NEWS: [
                ("device-safety-triggered", "notice", safety | {"safety_type": "ebrake_released"}),
                ("device-safety-triggered", "info", safety | {"safety_type": "fod_stage_changed"}),
                ("device-connected", "info", safety),
                ("device-battery-low", "warning", grip),
                ("device-disconnected", "warning", grip),
                ("control-rate", "warning", {"session_id": 7}),
            ],
        }.get(fault, [])
        for name, level, data in commanded:
            self.met(fault)
            for client in self.clients:
                if client.events:
                    client.tell({"name": name, "category": "device", "level": level, "data": data, "message": "m"})

    def ready(self, client):
        try:
            data = client.connection.recv(65536)
        except OSError:
            data = b""
        for event in client.feed(data):
            if isinstance(event, Request) and event.path == "/sessions":
                names = [HOLDER] if "--held" in self.flags else []
                text = json.dumps({"ok": True, "data": [{"id": 3, "profile": {"name": name}} for name in names]})
                client.protocol.send_response(client.protocol.reject(HTTPStatus.OK, text))
                client.flush()
            elif isinstance(event, Request):
                client.protocol.send_response(client.protocol.accept(event))
                client.flush()
                if not client.events:
                    self.sessions += 1
                    self.leaves = min(self.leaves, time.monotonic() + 0.1)
                    client.number = self.sessions
                if not client.events and "--silent-start" not in self.flags:
                    client.tell(self.frame(client, True))
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
                client = self.due.pop(0)[1]
                client.tell(self.frame(client, False))


if __name__ == "__main__":
    Service(Path(sys.argv[1]), sys.argv[2:]).run()
