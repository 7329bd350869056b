"""Ticks along a prescribed motion, and the two ports of a device with its proxy."""

from dataclasses import dataclass, field

import numba
import numpy as np
from tests.device.inside import tick

from cotouch.coupling import END, PSPM_COUPLING, EnergyMessage, book_end, end_row, hear, message_of
from cotouch.device import DEVICE_LEDGER, Devices, DeviceState, advance

Array = np.ndarray
CHARGED = DEVICE_LEDGER.index("charged")
BOOK = {name: index for index, name in enumerate(DEVICE_LEDGER)}


@numba.njit(error_model="numpy")
def drive(devices, state, times, places, pulled, wishes, totals, motion, efforts, sent, credited):
    """Servo ticks of device 0 at given times and places, whatever its own dynamics.

    The place at each tick is the last one plus `places[k]` plus `pulled[k]` along the force that is held, which is the
    worst that a hand can do. Results are true places, efforts, energy given away or dropped, and energy received.
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
        state.ends[0, END.heard_given] = totals[k]
        tick(devices, state, 0)
        motion[k] = place
        efforts[k] = state.effort[0]
        sent[k] = state.ends[0, END.given] + state.ends[0, END.lost] - state.ledger[0, CHARGED]
        credited[k] = state.ends[0, END.received]


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


class Proxy:
    """A free mass at the proxy's end of PSPM, spring and damper implicit."""

    def __init__(self, mass: float, stiffness: float, damping: float, cap: float, place: Array) -> None:
        self.mass, self.place, self.speed, self.work = mass, place, np.zeros(3), 0.0
        self.rows = end_row(stiffness=stiffness, damping=damping, cap=cap)[None, :]
        self._law = PSPM_COUPLING.half(proxy=True)

    @property
    def message(self) -> EnergyMessage:
        return message_of(self.rows[0])

    def step(self, T: float, push: Array, desired: Array, message: EnergyMessage) -> None:
        """One body step towards a place of the device that is known, and the message with it."""
        row = self.rows[0]
        hear(row, message)
        row[END.T], row[END.known], row[END.gap : END.rate] = T, 1.0, desired - self.place
        self._law(row)
        k, b, m, stretch = row[END.spring], row[END.brake], self.mass, row[END.stretch : END.push]
        mean = (2 * m / T * self.speed + k * stretch + push) / (2 * m / T + b + k * T / 2)
        force = k * (stretch - T / 2 * mean) - b * mean
        done = T * float(force @ mean)
        self.work += done
        book_end(self.rows, 0, done, 0.0, 0.0)
        self.place = self.place + T * mean
        self.speed = 2 * mean - self.speed


def in_play(ledger: Array) -> float:
    """The energy that went through a device's ledger [J]."""
    names = ("work", "human", "hand_loss", "viscous_loss", "coulomb_loss", "initial", "kinetic", "potential")
    return float(sum(abs(ledger[BOOK[name]]) for name in names))


def check_ledger(devices: Devices, state: DeviceState, rng: np.random.Generator, *, within: float) -> None:
    """Over 0.6 s in spans of any length, the ledger of device 0 closes and what is lost only grows."""
    time = 0.0
    while time < 0.6:
        time += rng.uniform(1e-4, 0.02)
        before = state.ledger[0].copy()
        assert advance(devices, state, 0, time)
        assert abs(state.ledger[0, BOOK["residual"]]) <= within * in_play(state.ledger[0])
        for loss in ("hand_loss", "viscous_loss", "coulomb_loss"):
            assert state.ledger[0, BOOK[loss]] >= before[BOOK[loss]]


def run(devices: Devices, state: DeviceState, until: float, every: float = 1e-3) -> Array:
    """Advances device 0; its true tip after each span, (spans, 3)."""
    places = []
    for k in range(1, round(until / every) + 1):
        assert advance(devices, state, 0, k * every)
        places.append(state.tip[0, :3].copy())
    return np.array(places)
