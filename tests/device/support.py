"""Ticks along a prescribed motion, and the two ports of a device with its proxy."""

from dataclasses import dataclass, field

import numba
import numpy as np

from cotouch.device import DEVICE_LEDGER, Devices, DeviceState, advance
from cotouch.device._servo import tick
from cotouch.mechanics import credit, modulate

Array = np.ndarray
BOOK = {name: index for index, name in enumerate(DEVICE_LEDGER)}


@numba.njit(error_model="numpy")
def drive(devices, state, times, places, pulled, wishes, totals, motion, efforts, sent, credited):
    """Servo ticks of device 0 at given times and places, whatever its own dynamics.

    The place at each tick is the last one plus `places[k]` plus `pulled[k]` along the force that is held, which is the
    worst that a hand can do. Motion (true places), efforts, energy sent and credited after each tick are results.
    """
    place = np.zeros(4)
    for k in range(times.size):
        size = np.sqrt(np.sum(state.effort[0] ** 2))
        for axis in range(3):
            place[axis] += places[k, axis]
            if size > 0.0:
                place[axis] += pulled[k] * state.effort[0, axis] / size
        state.coordinate[0] = place
        state.time[0] = times[k]
        state.desired[0, :3] = wishes[k]
        state.received[0] = totals[k]
        tick(devices, state, 0)
        motion[k] = place
        efforts[k] = state.effort[0]
        sent[k] = state.sent[0]
        credited[k] = state.seen[0]


@dataclass
class Driven:
    """A prescribed motion's result; `extracted[k]` is the port's true work until tick k."""

    motion: Array
    efforts: Array
    sent: Array
    credited: Array
    extracted: Array = field(init=False)

    def __post_init__(self) -> None:
        work = np.einsum("ka,ka->k", self.efforts[:-1], np.diff(self.motion, axis=0))
        self.extracted = np.concatenate([[0.0], np.cumsum(work)])


def driven(
    devices: Devices, state: DeviceState, times: Array, places: Array, pulled: Array, wishes: Array, totals: Array
) -> Driven:
    """Runs `drive` from the start of the devices."""
    count = times.size
    out = np.zeros((count, 4)), np.zeros((count, 4)), np.zeros(count), np.zeros(count)
    drive(devices, state, times, places, pulled, wishes, totals, *out)
    return Driven(*out)


@dataclass
class Proxy:
    """A free mass that a spring holds to the set position; NPMI with the spring implicit."""

    mass: float
    stiffness: float
    damping: float
    cap: float
    place: Array
    speed: Array
    set_position: Array
    tank: float = 0.0
    sent: float = 0.0
    seen: float = 0.0
    work: float = 0.0

    def step(self, T: float, push: Array, desired: Array, total: float) -> None:
        """One body step, then the modulation of the spring."""
        k, b, m = self.stiffness, self.damping, self.mass
        mean = (2 * m / T * self.speed + k * (self.set_position - self.place) + push) / (2 * m / T + b + k * T / 2)
        force = k * (self.set_position - self.place - T / 2 * mean) - b * mean
        self.work += T * float(force @ mean)
        self.place = self.place + T * mean
        self.speed = 2 * mean - self.speed
        stretch, gap = self.set_position - self.place, desired - self.place
        gift = credit(total, self.seen)
        self.seen += gift
        available = 0.5 * k * float(stretch @ stretch) + self.tank + b * T * float(mean @ mean) + gift
        fraction, self.tank, out = modulate(0.5 * k * float(gap @ gap), available, self.cap)
        self.set_position = self.place + fraction * gap
        self.sent += out


def in_play(ledger: Array) -> float:
    """The energy that went through a device's ledger [J]."""
    names = ("work", "human", "hand_loss", "viscous_loss", "coulomb_loss", "initial", "kinetic", "potential")
    return float(sum(abs(ledger[BOOK[name]]) for name in names))


def run(devices: Devices, state: DeviceState, until: float, every: float = 1e-3) -> Array:
    """Advances device 0; its true tip after each span, (spans, 3)."""
    places = []
    for k in range(1, round(until / every) + 1):
        assert advance(devices, state, 0, k * every)
        places.append(state.tip[0, :3].copy())
    return np.array(places)
