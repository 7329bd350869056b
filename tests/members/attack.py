"""What the worst lies do to two honest members: a search over all that a third one may say."""

import traceback
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np
from tests.members.liar import Liar
from tests.members.lie import DEADLY, TALK, Lie, near, random_lie
from tests.session.world import Person, World

from cotouch.peer import LinkState

# Small limits, so that what gets past them stands out.
FORCE, POWER, TANK, SEED, ALLOWANCE, AGE, SPRING = 5.0, 0.5, 0.01, 1e-3, 0.05, 1.0, 60.0
BURST = 0.1 * POWER  # what a guard lets through at once [J]
SESSION = f"""
[session]
users = 4
spring = {SPRING}
force_limit = {FORCE}
power_limit = {POWER}
tank = {TANK}
initial_energy = {SEED}
allowance = {ALLOWANCE}
age_limit = {AGE}
window = 1.0
[body]
kind = "chain"
nodes = 4
spacing = 0.1
dimension = 1
mass = 0.5
damping = 0.1
stiffness = 40.0
ground = [1]
ground_stiffness = 20.0
[steps]
rate = 50
"""
# For whoever sits there and moves.
SESSION += "".join(
    f"""
[[hands]]
user = {user}
at = [0.3]
path = [[0, 0], [1, 0.03], [2, 0.0], [3, 0.03], [4, 0.0], [5, 0.03], [6, 0.0]]
stiffness = 30.0
damping = 1.0
"""
    for user in (1, 2, 3)
)
SECONDS, LOOK = 3.5, 0.05
_ROUND_OFF = 1e-9
# What a search makes as large as it can; all are shares of what they may be, but speed [m/s].
GOALS = ("gain", "work", "credit", "received", "damping", "apart", "speed")


class Outcome(NamedTuple):
    """What came of a lie.

    Attributes:
        gain: energy that honest copies and hands have beyond what they put in, of what they may.
        work: the most that the liar's link did on an honest copy, of what it may.
        credit: what tanks were credited, of what the damping took.
        received: what tanks took of the liar, of what they may.
        damping: of an honest copy, of the most it may.
        apart: share of the time in which the two honest ones were not coupled with each other.
        speed: of any node of an honest copy [m/s].
        broken: what may not happen, in sentences.
    """

    gain: float
    work: float
    credit: float
    received: float
    damping: float
    apart: float
    speed: float
    broken: tuple[str, ...]

    @property
    def held(self) -> bool:
        """Whether nothing happened that may not."""
        return not self.broken


def play(lie: Lie, *, text: str = SESSION, seconds: float = SECONDS) -> Outcome:
    """Ann moves, Ben follows, and somebody lies to both."""
    modes = {0: "constant", 1: "self-paced"}
    if lie.seed % 6 in modes:
        text += f'[synchronisation]\nlaw = "spring"\nmode = "{modes[lie.seed % 6]}"\n'
    world = World(text, seed=3, tick=5e-3)
    broken: list[str] = []
    seen = dict.fromkeys(GOALS, 0.0)
    names = ("Zoe", "Ann", "Ben") if lie.first else ("Ann", "Ben", "Zoe")
    honest: list[Person] = []
    liar: Liar | None = None
    since: dict[str, float] = {}
    moved: dict[str, tuple[int, float]] = {}
    looks = apart = 0
    try:
        for name in names:
            person = world.join(name, moves=name == "Ann")
            if name == "Zoe":
                liar = Liar(person, lie)
            else:
                honest.append(person)
            world.run(0.1)
        assert liar is not None
        if set(DEADLY) & set(lie.talk):  # until everybody knows that the host is gone, and a little longer
            seconds += lie.since + 4.5
        while world.now < seconds:
            world.run(LOOK)
            if world.now > lie.since + 0.5 and world.now > 1.5:
                looks += 1
                apart += not _coupled(honest)
            for person in honest:
                _look(world, person, liar, since, moved, seen, broken)
            _gained(world, honest, since, seen, broken)
            liar.check()
            if broken:
                break
    except Exception:  # noqa: BLE001
        broken.append("somebody crashed: " + traceback.format_exc().strip()[-600:])
    seen["apart"] = apart / looks if looks else 0.0
    return Outcome(**{name: seen[name] for name in GOALS}, broken=tuple(dict.fromkeys(broken)))


def _coupled(honest: list[Person]) -> bool:
    one, two = honest
    slot = two.member.slot
    held = None if one.member.replica is None or slot is None else one.copy.neighbours.get(slot)
    return held is not None and held.guard.state == LinkState.COUPLED


def _look(
    world: World,
    person: Person,
    liar: Liar,
    since: dict[str, float],
    moved: dict[str, tuple[int, float]],
    seen: dict[str, float],
    broken: list[str],
) -> None:
    """At one honest member."""
    key, member = person.identity.public.hex(), person.member
    if member.ended:
        broken.append(f"{person.name} was told that the session is over")
    died = liar.host_died
    if died is not None and world.now > died + 4.0 and world.host_identity.public in person.control.present():
        broken.append(f"{person.name} takes the dead host for present")
    entry = member.roster.of(person.identity.public)
    if member.replica is None or member.replica.peer is None:
        if world.now > 3.0:
            broken.append(f"{person.name} has no place after 3 s")
        return
    since.setdefault(person.name, world.now - LOOK)
    steps = member.replica.peer.steps
    if moved.get(person.name, (-1, 0.0))[0] != steps:
        moved[person.name] = steps, world.now - LOOK  # not earlier: it was looked at then
    if world.now - max(moved[person.name][1], since[person.name]) > 1.0:
        broken.append(f"{person.name} has stood still for 1 s")
    mine = (person.name, member.replica.slot, key)
    others = [(one.name, one.slot, one.key) for one in member.roster.members]
    if any(0 < sum(map(str.__eq__, map(str, one), map(str, mine))) < len(mine) for one in others):
        broken.append(f"the place of {person.name} was taken")
    if entry is None and _outvoted(person, liar):
        broken.append(f"{person.name} was left out against those whom the host let in")
    copy, peer, totals = member.replica, member.replica.peer, member.replica.totals
    if totals.alarms or not np.isfinite(peer.state.velocity).all():
        broken.append(f"the ledger of {person.name} is off by {totals.residual:.1e}")
    seen["speed"] = max(seen["speed"], float(np.abs(peer.state.velocity).max()))
    most = 0.5 * SPRING * AGE * max(1, len(copy.neighbours))
    seen["damping"] = max(seen["damping"], float(copy.damping.max()) / most)
    if copy.damping.max() > most * (1.0 + 1e-12):
        broken.append(f"the damping of {person.name} is {copy.damping.max():.3g} Ns/m, above {most:.3g}")
    lasted = world.now - since[person.name]
    credited = sum(held.guard.ledger.credited for held in copy.neighbours.values())
    if totals.lost > 1e-6:
        seen["credit"] = max(seen["credit"], credited / totals.lost)
    if credited > totals.lost + _ROUND_OFF:
        broken.append(
            f"tanks of {person.name} were credited {credited:.3g} J, and the damping took {totals.lost:.3g} J"
        )
    for held in copy.neighbours.values():
        if held.guard.tank > max(TANK, SEED) + _ROUND_OFF:
            broken.append(f"a tank of {person.name} holds {held.guard.tank:.3g} J")
        if held.guard.ledger.potential > 0.5 * FORCE**2 / SPRING * (1.0 + 1e-9):
            broken.append(f"a link pulls {person.name} with {(2 * SPRING * held.guard.ledger.potential) ** 0.5:.3g} N")
    slot = next((at for at, held in copy.neighbours.items() if held.entry.name == liar.person.name), None)
    if slot is None:
        return
    ledger, allowed = copy.neighbours[slot].guard.ledger, BURST + POWER * lasted
    seen["received"] = max(seen["received"], ledger.received / allowed)
    if ledger.received > allowed:
        broken.append(f"{person.name} took {ledger.received:.3g} J of the liar in {lasted:.2f} s")
    work = totals.link_work.get(slot, 0.0)
    seen["work"] = max(seen["work"], work / allowed)
    if work > allowed:
        broken.append(
            f"the liar's link did {work:.3g} J on {person.name}'s copy in {lasted:.2f} s; {allowed:.3g} J it may"
        )


def _outvoted(person: Person, liar: Liar) -> bool:
    """Whether the host let this one in, and more honest ones than liars: then nobody may leave it out."""
    chain = person.member._belief.chain
    let_in = {entry.key for entry in chain[0].roster.members} if chain else set[str]()
    liars = {liar.person.identity.public.hex()} & let_in
    return person.identity.public.hex() in let_in and len(let_in - liars) > len(liars)


def _gained(
    world: World, honest: list[Person], since: dict[str, float], seen: dict[str, float], broken: list[str]
) -> None:
    """All honest ones together: what is stored, less what their hands put in."""
    there = [person for person in honest if person.name in since]
    total = allowed = 0.0
    for person in there:
        totals = person.copy.totals
        total += totals.energy - totals.initial - totals.supplied - totals.rescaled
        allowed += SEED + TANK + BURST + POWER * (world.now - since[person.name])  # of the liar's link
        allowed += person.copy.initial_energies
    if there:
        seen["gain"] = max(seen["gain"], total / allowed)
        if total > allowed:
            broken.append(f"honest copies and hands gained {total:.3g} J; {allowed:.3g} J they may")


@dataclass
class Search:
    """Random lies first, then what is near the worst of them, for each goal by turns.

    Attributes:
        tried: so many.
        best: of each goal, worst first: value, lie.
        broken: lies that broke something, and what.
    """

    rng: np.random.Generator
    names: tuple[str, ...] = TALK
    random: float = 0.5
    keep: int = 6
    judge: Callable[[Lie], Outcome] = play
    tried: int = 0
    best: dict[str, list[tuple[float, Lie]]] = field(default_factory=lambda: {name: [] for name in GOALS})
    broken: list[tuple[Lie, Outcome]] = field(default_factory=list)

    def run(self, count: int) -> Iterator[tuple[Lie, Outcome]]:
        """Tries so many more."""
        for nth in range(count):
            goal = GOALS[nth % len(GOALS)]
            pool = self.best[goal]
            fresh = not pool or self.rng.random() < self.random
            lie = random_lie(self.rng, self.names)
            if not fresh:
                lie = near(pool[int(self.rng.integers(0, len(pool)))][1], self.rng, self.names)
            outcome = self.judge(lie)
            self.tried += 1
            if not outcome.held:
                self.broken.append((lie, outcome))
            for name in GOALS:
                ranked = [*self.best[name], (getattr(outcome, name), lie)]
                self.best[name] = sorted(ranked, key=lambda entry: -entry[0])[: self.keep]
            yield lie, outcome
