"""Random scenarios with devices for the record: two people, each with a device, at one body, through a network.

Every scenario is drawn from (seed, number) alone, so that a single one can be run again with `--only NUMBER`.
Everything runs on one virtual clock: two simulated devices with hands, the cores of their servos, mailboxes that are
    late,
lost or silent, and two copies with the hands that hold devices, joined by a delayed spring. The works of all ports are
counted from true forces and motion, in the device's metres at the device and in the body's at the body, so that neither
the accounts of the couplings nor their scales check themselves.
"""

import argparse
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import joblib
import numpy as np
import numpy.typing as npt

from benchmarks._report import Row, add_write, finish
from cotouch.coupling import EnergyMessage, unseen_place
from cotouch.device import (
    PRESETS,
    CartesianPlant,
    Coupling,
    DeviceModel,
    DeviceSpec,
    PhantomPlant,
    ServoModel,
    SimulatedHand,
)
from cotouch.hands import DeviceHand
from cotouch.haptics import (
    Cause,
    CouplingChoice,
    DeviceChoice,
    EndOptions,
    Order,
    SafetyLimits,
    ServoCore,
    ServoReport,
    ServoSettings,
    SimulatedOnClock,
    Vector,
    norm,
    virtual_limit,
)
from cotouch.haptics._ends import WINDOW
from cotouch.members import SessionFile, SharedModel, Slot
from cotouch.peer import FreshestLink, Peer, Sample

SEED = 2012
COUNT, SHORT = 600, 24
# Of the energy in play; and what rounding may leave of a bound [J].
TOLERANCE, _SLACK = 1e-10, 1e-9
_SLOTS = 2
_BODIES = ("point", "chain", "block")

Float = npt.NDArray[np.float64]


@dataclass(frozen=True, kw_only=True)
class Finding:
    """What one scenario came to.

    Attributes:
        number: of the scenario.
        body: "point", "chain" or "block".
        laws: of the couplings.
        ticks: of both servos.
        used: for each coupling, the most that both its ports gave, as a share of its d².
        watched: most that the passivity observers saw beyond what may be; <= 0 [J].
        causes: anything that ends force for good or until it is re-armed.
        force: largest force at the motors, as a share of the limit.
        paid: most friction that was counted beyond what there was [J].
        residual: largest imbalance in the copies' books, of the energy in play.
        margin: least of what all proxies together had put into the copies, of the energy in play.
        shortened: share of ticks in which a coupling wanted for energy.
    """

    number: int
    body: str
    laws: tuple[str, ...]
    ticks: int
    used: tuple[float, ...]
    watched: float
    causes: int
    force: float
    paid: float
    residual: float
    margin: float
    shortened: float


def _log(rng: np.random.Generator, low: float, high: float) -> float:
    return float(np.exp(rng.uniform(np.log(low), np.log(high))))


class _Clock:
    now = 0.0

    def __call__(self) -> float:
        return self.now


class _Wire:
    """The two mailboxes between a servo and its peer, as both ends see them; for a `DeviceHand` a `ServoLink`."""

    def __init__(self, rng: np.random.Generator, clock: _Clock, settings: ServoSettings, spec: DeviceSpec) -> None:
        self.spec, self.said, self.options = spec, settings.coupling, EndOptions()
        self._rng, self._clock, self._settings = rng, clock, settings
        self._late, self._loss = float(rng.uniform(0.0, 0.05)) ** 1.0, float(rng.uniform(0.0, 0.5))
        self._silent = float(rng.uniform(0.2, 2.0)), float(rng.uniform(0.01, 0.3))
        self._reports: list[tuple[float, ServoReport]] = []
        self._orders: list[tuple[float, Order]] = []
        self._known: ServoReport | None = None
        self._step = 0

    def couple(self, below: CouplingChoice) -> EndOptions:
        """As a `ServoLink` does."""
        chosen = replace(self._settings, coupling=self.said.over(below))
        said = chosen.coupling
        if said.law is None:  # passive also where it would hum or slip, which is refused to people
            assert said.stiffness is not None
            assert said.damping is not None
            self.options = EndOptions(stiffness=said.stiffness, damping=said.damping)
        else:
            self.options = chosen.end_options(self.spec)
        return self.options

    def say(self, report: ServoReport) -> None:
        """Of the servo."""
        self._reports.append((self._clock() + self._late * self._rng.random(), report))

    def read(self) -> ServoReport | None:
        """Of the peer."""
        self._known = self._newest(self._reports) or self._known
        return self._known

    def order(self, place: Vector | None, word: EnergyMessage) -> None:
        """Of the peer; for a while nothing of it comes."""
        now = self._clock()
        self._step += 1
        begun, lasts = self._silent
        if not begun <= now < begun + lasts:
            order = Order(time=now, step=self._step, place=place, message=word, enable=True)
            self._orders.append((now + self._late * self._rng.random(), order))

    def receive(self) -> Order | None:
        """Of the servo."""
        return self._newest(self._orders)

    def _newest(self, mailbox: list[tuple[float, Any]]) -> Any:
        arrived = [entry for entry in mailbox if entry[0] <= self._clock()]
        if not arrived or self._rng.random() < self._loss:
            return None
        mailbox[:] = [entry for entry in mailbox if entry[0] > self._clock()]
        return arrived[-1][1]


def device_of(rng: np.random.Generator) -> tuple[DeviceModel, DeviceSpec, CouplingChoice]:
    """A random device with a hand, its limits, and a coupling that fits it."""
    kind = str(rng.choice(["phantom", *sorted(PRESETS)]))
    spec = PRESETS[kind]
    spec = replace(spec, resolution=spec.resolution * _log(rng, 0.1, 10.0))
    virtual = bool(rng.random() < 0.4)
    own = float(rng.uniform(0.5, 6.0))
    viscous = own if virtual else float(rng.choice([0.0, 0.0125, own]))
    if kind == "phantom" and not virtual:
        plant = PhantomPlant()
        resolution = spec.resolution / plant.lengths()[0]
    else:
        plant = CartesianPlant(
            mass=spec.mass * _log(rng, 0.5, 2.0), viscous=viscous, coulomb=spec.friction * float(rng.uniform(0.0, 3.0))
        )
        resolution = spec.resolution
    far = 0.3 * min(spec.workspace, 0.1) * float(rng.uniform(0.2, 2.0))
    hand = SimulatedHand(
        amplitude=(rng.normal(0.0, 0.6, 3) * far).tolist(),
        frequency=_log(rng, 0.2, 6.0),
        phase=float(rng.uniform(0.0, 6.3)),
        grip=float(rng.choice([0.25, 1.0, 4.0])),
        correction=float(rng.choice([0.0, 1.0])),
        release=None if rng.random() < 0.8 else float(rng.uniform(0.5, 1.5)),
    )
    model = DeviceModel(
        plant=plant,
        servo=ServoModel(resolution=resolution, force=spec.force),
        coupling=Coupling(law="host_force"),
        hand=hand,
    )
    scale = "fit" if rng.random() < 0.15 else _log(rng, 0.2, 10.0) if rng.random() < 0.6 else 1.0
    if not virtual:
        coupling = CouplingChoice(
            stiffness=_log(rng, 50.0, spec.stiffness), damping=float(rng.uniform(0.0, spec.damping)), scale=scale
        )
        return model, spec, coupling
    usual = EndOptions(
        law="virtual",
        friction=own * float(rng.uniform(0.5, 1.0)),
        damping=0.3 * own * float(rng.uniform(0.0, 1.0)),
        ages=float(rng.uniform(0.0, 0.03)),
        weight=_log(rng, 0.1, 10.0),
    )
    stiffness = min(spec.stiffness, virtual_limit(usual, period=1e-3, resolution=0.0)) * float(rng.uniform(0.2, 1.0))
    # What the encoders falsify dry friction must pay for: just enough of it, or twice as much.
    coulomb = 1.01 * (stiffness + 2.0 * usual.damping / WINDOW) * unseen_place(spec.resolution)
    model = replace(model, plant=replace(plant, coulomb=coulomb * float(rng.uniform(1.0, 2.0))))
    coupling = CouplingChoice(
        law="virtual",
        friction=usual.friction,
        coulomb=coulomb,
        damping=usual.damping,
        ages=usual.ages,
        weight=usual.weight,
        stiffness=stiffness,
        scale=scale,
    )
    return model, spec, coupling


def body_of(rng: np.random.Generator) -> tuple[str, str]:
    """A random body, and the session's file of two people at it."""
    kind = str(rng.choice(_BODIES))
    mass, stiffness, damping = _log(rng, 0.05, 2.0), _log(rng, 5.0, 500.0), _log(rng, 0.01, 3.0)
    common = f"mass = {mass}\nstiffness = {stiffness}\ndamping = {damping}\n"
    if kind == "point":
        body = common
    elif kind == "chain":
        body = (
            f'kind = "chain"\nnodes = 3\nspacing = 0.1\ndimension = 3\nground = [1]\nground_stiffness = 50.0\n{common}'
        )
    else:
        body = (
            'kind = "lattice"\nshape = [3, 3, 3]\nspacing = 0.03\nground = "z-"\n'
            f"ground_stiffness = {stiffness}\n{common}"
        )
    text = '[network]\nusers = ["A", "B"]\nspring = [[0, 1], [1, 0]]\ndelay = [[0, 0.01], [0.01, 0]]\n[body]\n' + body
    if kind == "block" and rng.random() < 0.5:
        how = f"radius = 0.02\nmass = {_log(rng, 0.01, 0.3)}\nstiffness = {_log(rng, 300.0, 2e4)}\n"
        how += f"friction = {rng.uniform(0.0, 1.0)}\n" if rng.random() < 0.5 else 'kind = "grasp"\n'
        for user in (1, 2):
            text += f"[[tools]]\nuser = {user}\nat = [0.03, {0.02 * user}, 0.085]\n{how}"
    return kind, text


class _Slot:
    """A person, a device, its servo, and a copy."""

    def __init__(
        self, rng: np.random.Generator, clock: _Clock, replica: SharedModel, slot: int, slowest: float
    ) -> None:
        model, self.spec, coupling = device_of(rng)
        self.limits = SafetyLimits.of(self.spec)
        self.device = SimulatedOnClock(model, self.spec, clock=clock)
        settings = ServoSettings(device=DeviceChoice("none"), folder=None, coupling=coupling)  # type: ignore[arg-type]
        self.wire = _Wire(rng, clock, settings, self.spec)
        kernels = replica.model(_SLOTS)
        at = Slot(
            scenario=replica.scenario,
            body=replica.body,
            model=kernels,
            index=slot,
            period=slowest,
            longest=10.0 * slowest,
        )
        self.hand = DeviceHand(at, link=self.wire)  # type: ignore[arg-type]
        self.core = ServoCore(self.spec, self.limits, self.wire.options)
        self.body, self.kernels = replica.body, kernels
        self.force = np.zeros(3)
        self.proxy_work = self.supplied = self.residual = self.play = self.strongest = 0.0
        self.watched, self.excess = -np.inf, -np.inf
        self.causes = Cause(0)
        self.ticks = self.short = 0
        self.rate, self.jitter = float(rng.uniform(100.0, 1000.0)), float(rng.uniform(0.0, 0.5))
        self.stalls = float(rng.choice([0.0, 0.0, 0.002]))
        self.next_tick, self.next_step, self.last_step = 0.0, 0.0, 0.0
        self.device.open()
        self.device.calibrate(allow_motion=False)
        self.device.enable_force()

    def links(self, other: int, strength: float, damping: float) -> None:
        """Joins the copy to the other's."""
        body, kernels, hand = self.body, self.kernels, self.hand
        still = np.zeros((body.nodes, body.dimension))
        start = Sample(sender=other, index=-1, stamp=0.0, position=kernels.to_rows(still))
        self.peer = Peer(
            index=1 - other,
            model=kernels,
            links={other: FreshestLink(start)},
            strength=[strength],
            weight=[0],
            local_damping=np.full(1, damping),
            extra_damping=np.zeros(1),
            ports=hand.ports,
            position=still,
            velocity=still,
            surface=hand.surface,
            tools=hand.tools,
        )
        hand.attach(self.peer.state.position)

    def tick(self, rng: np.random.Generator, now: float) -> None:
        """A cycle of the servo."""
        order = self.wire.receive()
        if order is not None:
            self.core.receive(order)
        report = self.core.cycle(self.device.exchange(self.force), now)
        self.force = np.array(report.force)
        self.wire.say(report)
        self.ticks += 1
        self.short += self.core.end.message.starved
        self.watched = max(self.watched, report.excess)
        self.causes |= report.causes & (Cause.FAULT | Cause.ACTIVE)
        self.strongest = max(self.strongest, norm(report.force) / self.limits.force)
        stall = float(rng.uniform(5e-3, 0.06)) if rng.random() < self.stalls else 0.0
        self.next_tick = now + 1e-3 * (1.0 + self.jitter * float(rng.uniform(-0.9, 3.0))) + stall
        self._count()

    def step(self, rng: np.random.Generator, now: float) -> Sample | None:
        """A step of the copy; what the other should be told."""
        T = now - self.last_step
        self.next_step = now + (1.0 + self.jitter * float(rng.uniform(-0.9, 3.0))) / self.rate
        if T <= 0.0:
            return None
        self.last_step = now
        self.hand.before(now, T)
        proxies = [hold.grasped for hold in self.hand._holds]
        before = [np.array(proxy.place()) for proxy in proxies]
        report = self.peer.step(now, T)
        for proxy, place in zip(proxies, before, strict=True):
            self.proxy_work += float(np.array(proxy.force()) @ (np.array(proxy.place()) - place))
        self.hand.after()
        self.supplied += report.supplied + report.drive_work
        self.residual = max(self.residual, abs(report.residual))
        self.play = max(self.play, report.kinetic + report.elastic + report.proxy, abs(self.supplied))
        self._count()
        return report.sample

    def _count(self) -> None:
        """What both ports of the coupling gave so far, by true forces and motion."""
        assert self.device.device is not None
        end = self.core.end
        self.excess = max(self.excess, self.device.device.ledger["work"] + self.proxy_work - end.paid)

    @property
    def overpaid(self) -> float:
        """Friction that was counted beyond what there was [J]."""
        end = self.core.end
        assert self.device.device is not None
        return end.paid - self.device.device.ledger["viscous_loss"]

    @property
    def used(self) -> float:
        """Share of d² that the coupling gave."""
        return self.excess / (2.0 * self.wire.options.initial_energy + self.core.observed_bound + _SLACK)


def examine(number: int) -> Finding:
    """Runs one scenario."""
    rng = np.random.default_rng((SEED, number))
    kind, text = body_of(rng)
    replica = SharedModel.build(SessionFile.from_toml(text, source=f"scenario {number}"))
    clock = _Clock()
    slots = [_Slot(rng, clock, replica, slot, 0.01) for slot in range(_SLOTS)]
    delay, spring = _log(rng, 1e-3, 0.08), _log(rng, 5.0, 300.0) / replica.body.nodes
    # A sample is at most this old where it is used: half a step, the way, a step of the sender, one of the receiver.
    longest = [(1.0 + 3.0 * slot.jitter) / slot.rate for slot in slots]
    both = sum(2.0 * delay + 2.5 * longest[k] + longest[1 - k] for k in range(_SLOTS))
    for k, slot in enumerate(slots):
        slot.links(1 - k, spring, 0.5 * spring * both)
    duration = float(rng.uniform(0.8, 1.6))
    mail: list[tuple[float, int, Sample]] = []
    margin = 0.0
    while True:
        now = min(min(slot.next_tick, slot.next_step) for slot in slots)
        if now >= duration:
            break
        clock.now = now
        for arrival in [entry for entry in mail if entry[0] <= now]:
            mail.remove(arrival)
            slots[arrival[1]].peer.receive(arrival[2])
        for k, slot in enumerate(slots):
            if slot.next_tick <= now:
                slot.tick(rng, now)
            if slot.next_step <= now:
                sample = slot.step(rng, now)
                if sample is not None:
                    mail.append((now + delay * float(rng.uniform(0.5, 2.0)), 1 - k, sample))
                margin = min(margin, sum(one.supplied for one in slots))
    play = max(sum(slot.play for slot in slots), 1e-12)
    return Finding(
        number=number,
        body=kind,
        laws=tuple(slot.wire.options.law for slot in slots),
        ticks=sum(slot.ticks for slot in slots),
        used=tuple(slot.used for slot in slots),
        watched=max(slot.watched for slot in slots),
        causes=int(slots[0].causes | slots[1].causes),
        force=max(slot.strongest for slot in slots),
        paid=max(slot.overpaid for slot in slots),
        residual=max(slot.residual for slot in slots) / play,
        margin=margin / play,
        shortened=sum(slot.short for slot in slots) / max(1, sum(slot.ticks for slot in slots)),
    )


def broken(found: Finding) -> bool:
    """Whether a coupling gave more than it may, by its ports or by its observer."""
    return not (max(found.used) <= 1.0 and found.watched <= 0.0 and found.causes == 0 and found.paid <= _SLACK)


def unbalanced(found: Finding) -> bool:
    """Whether the copies' ledgers do not balance, or the copies gave energy."""
    return not (found.residual <= TOLERANCE and found.margin >= -TOLERANCE)


def measure(count: int = SHORT, jobs: int = 1) -> list[Row]:
    """Rows of the table."""
    numbers = range(1, count + 1)
    findings: Sequence[Finding] = list(joblib.Parallel(n_jobs=jobs)(joblib.delayed(examine)(n) for n in numbers))

    def numbered(bad: list[Finding]) -> str:
        return str([found.number for found in bad[:9]]) if bad else "none"

    active = [found for found in findings if broken(found)]
    wrong = [found for found in findings if unbalanced(found)]
    strong = [found for found in findings if found.force > 1.0 + 1e-12]
    couplings = [(law, used) for found in findings for law, used in zip(found.laws, found.used, strict=True)]
    most = {law: max((used for own, used in couplings if own == law), default=0.0) for law in ("pspm", "virtual")}
    kinds = ", ".join(f"{sum(found.body == kind for found in findings)} at a {kind}" for kind in _BODIES)
    laws = ", ".join(f"{sum(own == law for own, _ in couplings)} {law}" for law in most)
    starved = float(np.mean([found.shortened for found in findings]))
    name = "device record"
    return [
        Row(
            name,
            "random scenarios of two people with devices",
            f"{len(findings):,}",
            "",
            f"{kinds}; couplings: {laws}; {sum(found.ticks for found in findings):,} servo ticks; peers at 100 to "
            f"1000 Hz; {100 * starved:.0f} % of ticks wanted for energy",
        ),
        Row(
            name,
            "scenarios with a coupling beyond its bound",
            f"{len(active)}",
            "0",
            f"numbers: {numbered(active)}; most of d²: PSPM {most['pspm']:.2g}, virtual {most['virtual']:.2g}; "
            f"observers saw at most {max(found.watched for found in findings):.1e} J",
        ),
        Row(
            name,
            "scenarios whose copies gave energy, or whose ledgers do not balance",
            f"{len(wrong)}",
            "0",
            f"numbers: {numbered(wrong)}; residual at most {max(found.residual for found in findings):.1e}, least Σ "
            f"v̂ᵀ f T {min(found.margin for found in findings):.1e}, of the energy in play",
        ),
        Row(name, "scenarios with a force beyond the limit", f"{len(strong)}", "0", f"numbers: {numbered(strong)}"),
    ]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=SHORT, help=f"how many scenarios ({COUNT} for the record)")
    parser.add_argument("--jobs", type=int, default=1, help="processes")
    parser.add_argument("--only", type=int, help="run this scenario alone and print it")
    add_write(parser)
    options = parser.parse_args()
    if options.only is not None:
        print(body_of(np.random.default_rng((SEED, options.only)))[1])
        print(examine(options.only))
        return
    finish(measure(options.count, options.jobs), write=options.write)


if __name__ == "__main__":
    main()
