"""A device, its servo's core, and a proxy at another rate, with mailboxes that are late or lost; on a virtual clock."""

from dataclasses import dataclass, field
from typing import Any

import numpy as np

from cotouch.device import DeviceSpec
from cotouch.haptics import (
    Cause,
    EndOptions,
    Order,
    ProxyEnd,
    SafetyLimits,
    ServoCore,
    ServoReport,
    SimulatedOnClock,
    norm,
)

Array = np.ndarray


@dataclass
class Body:
    """What the proxy meets: a mass on a spring, a stop, and somebody who shakes it."""

    mass: float = 0.1
    spring: float = 0.0
    stop: float = np.inf  # stands at x = stop, of 2000 N/m
    shake: float = 0.0
    hertz: float = 2.0
    place: Array = field(default_factory=lambda: np.zeros(3))
    speed: Array = field(default_factory=lambda: np.zeros(3))


@dataclass
class Ran:
    """What came of it; `excess` is the largest of X_device + X_proxy - `paid` at any time, by true work [J]."""

    excess: float = -np.inf
    bound: float = 0.0
    device_work: float = 0.0
    proxy_work: float = 0.0
    paid: float = 0.0
    pulls: list[float] = field(default_factory=list)
    reports: list[ServoReport] = field(default_factory=list)
    fractions: list[float] = field(default_factory=list)
    proxies: list[Array] = field(default_factory=list)
    speeds: list[float] = field(default_factory=list)


def circumstances(rng: np.random.Generator) -> dict[str, Any]:
    """What the proxy meets, and how bad clocks and mailboxes are: any of it, for `run`."""
    body = Body(
        mass=float(10.0 ** rng.uniform(-2, 0)),
        spring=float(rng.choice([0.0, 200.0])),
        stop=float(rng.choice([np.inf, 0.002])),
        shake=float(rng.choice([0.0, 1.0, 4.0])),
        hertz=float(rng.uniform(0.5, 20.0)),
    )
    jitter, late, loss = (float(rng.uniform(0.0, most)) for most in (0.5, 0.05, 0.5))
    return {"body": body, "jitter": jitter, "late": late, "loss": loss}


def check_passive(ran: Ran, spec: DeviceSpec) -> None:
    """Nothing was made, nobody had to step in, and the force kept to its limit."""
    assert ran.excess <= ran.bound
    assert max(report.excess for report in ran.reports) <= 0.0  # the observer has nothing to say
    assert not any(report.causes & (Cause.FAULT | Cause.ACTIVE) for report in ran.reports)
    assert max(norm(report.force) for report in ran.reports) <= SafetyLimits.of(spec).force * (1 + 1e-12)


def run(
    device: SimulatedOnClock,
    spec: DeviceSpec,
    *,
    seconds: float,
    peer: float,
    clock: list[float],
    options: EndOptions | None = None,
    limits: SafetyLimits | None = None,
    body: Body | None = None,
    rate: float = 1000.0,
    jitter: float = 0.0,
    late: float = 0.0,
    loss: float = 0.0,
    silent: tuple[float, float] = (np.inf, np.inf),
    seed: int = 0,
    core: Any = None,
) -> Ran:
    """Runs both ends: the servo at `rate`, the peer at `peer` [Hz]; mailboxes are up to `late` s old or not read."""
    rng = np.random.default_rng(seed)
    options = EndOptions() if options is None else options
    servo = core or ServoCore(spec, limits or SafetyLimits.of(spec), options)
    proxy, body, ran = ProxyEnd(options), body or Body(), Ran()
    device.open()
    device.calibrate(allow_motion=False)
    device.enable_force()
    force = np.zeros(3)
    to_peer: list[tuple[float, ServoReport]] = []
    to_servo: list[tuple[float, Order]] = []
    known: ServoReport | None = None
    next_servo, next_peer, last_peer, step = 0.0, 0.0, 0.0, 0
    origin: Array | None = None

    def wobble(period: float) -> float:
        return period * float(1.0 + jitter * rng.uniform(-0.9, 3.0))

    while min(next_servo, next_peer) < seconds:
        if next_servo <= next_peer:
            now = clock[0] = next_servo
            arrived = [order for time, order in to_servo if time <= now]
            if arrived and rng.random() >= loss:
                servo.receive(arrived[-1])
                to_servo = [entry for entry in to_servo if entry[0] > now]
            reading = device.exchange(force)
            report = servo.cycle(reading, now)
            force = np.array(report.force)
            to_peer.append((now + late * rng.random(), report))
            ran.reports.append(report)
            ran.speeds.append(float(np.linalg.norm(reading.velocity)))
            ran.fractions.append(servo.end.fraction)
            next_servo += wobble(1.0 / rate)
        else:
            now = next_peer
            T = now - last_peer
            last_peer = now
            arrived_reports = [report for time, report in to_peer if time <= now]
            if arrived_reports and rng.random() >= loss:
                known = arrived_reports[-1]
                to_peer = [entry for entry in to_peer if entry[0] > now]
            if T > 0.0 and known is not None:
                if origin is None:
                    origin = body.place - np.array(known.place)
                where = tuple(np.array(known.place) + origin)
                pull = proxy.pull(tuple(body.place), where, known.rate, known.message, T)
                done, moved = _step(body, pull, now, T)
                proxy.settle(tuple(done), tuple(moved))
                ran.proxy_work += float(done @ moved)
                ran.pulls.append(proxy.fraction)
                step += 1
                if not silent[0] <= now < silent[1]:
                    there = tuple(body.place - origin)
                    order = Order(time=now, step=step, place=there, message=proxy.message, enable=True)
                    to_servo.append((now + late * rng.random(), order))
            ran.proxies.append(body.place.copy())
            next_peer += wobble(1.0 / peer)
        assert device.device is not None
        ran.device_work = device.device.ledger["work"]
        ran.paid = servo.end.paid  # what its own friction took, which must be no more than it really did
        ran.excess = max(ran.excess, ran.device_work + ran.proxy_work - ran.paid)
    ran.bound = 2.0 * options.initial_energy + servo.observed_bound + 1e-9
    return ran


def _step(body: Body, pull: Any, now: float, T: float) -> tuple[Array, Array]:
    """An implicit step of the proxy; the force of the pull and what the proxy moved by."""
    k, b, m = pull.stiffness, pull.damping, body.mass
    target, push = np.array(pull.target), np.array(pull.push)
    outer = body.shake * np.sin(2 * np.pi * body.hertz * now) * np.array([1.0, 0.6, -0.8])
    grounded = np.full(3, body.spring)
    if body.place[0] > body.stop:
        grounded[0] += 2000.0
    free = -body.spring * body.place
    if body.place[0] > body.stop:
        free[0] -= 2000.0 * (body.place[0] - body.stop)
    mean = (2 * m / T * body.speed + k * (target - body.place) + push + outer + free) / (
        2 * m / T + b + (k + grounded) * T / 2
    )
    done = k * (target - body.place - T / 2 * mean) - b * mean + push
    moved = T * mean
    body.place = body.place + moved
    body.speed = 2 * mean - body.speed
    return done, moved
