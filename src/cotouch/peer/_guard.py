"""One end of a link that stays passive whatever becomes of the other end and of the way between them.

The spring to the newest sample (freshest, or of a constant index) is passive as long as samples are at most as old as
was agreed, at both ends: the age rule. An end that cannot rely on that is *guarded*: it holds a set position ȳ and
moves it towards the newest sample only as far as it has energy for (PSPM, see `cotouch.mechanics.modulate`), which is
passive alone. Three states follow, told to the other end with every sample, together with the *epoch*, the number of
times that this end was guarded, and the other's epoch as heard last::

    COUPLED ──  a sample too old, the other end guarded or in another epoch, too much power    ──▶ GUARDED, epoch + 1
    GUARDED ──  ȳ = y and age within budget for as long as both budgets, and heard by the other  ──▶ READY
    READY   ──  ȳ ≠ y, or age beyond the budget                                                  ──▶ GUARDED, epoch + 1
    READY   ──  the other is READY or COUPLED and has heard this epoch                           ──▶ COUPLED

**What the age rule pays.** With A_ij the budget of end i in i's own measure (offset of the clocks included; only sums
and differences with measured ages count, so it drops out), i damps with ½K(A_ij + A_ji): the first part pays for what
i's own samples are wrong by, the second for what the other's are. While the age is a, `½K(A_ij - a - T/2)‖v̂‖²_W T` of
the first part is left over (the half step is for steps longer than the age). It goes to the tank E.

**Why going guarded is passive.** The energy of the new end's spring, U = ½K‖x - ȳ‖²_W, is paid from the tank. The other
end never uses a sample of a guarded end, so to it this end stands still, at the place where it was guarded: its
spring's energy goes on without a jump, and its errors are covered by the damping from before. Then it is guarded
itself, and pays for its own. From then on both are passive alone, so that all of ½K(A_ij + A_ji) may go to the tank
while ȳ is away from y: that is what brings copies together again.

**Why coupling is passive.** With d = x_i - x_j and e, p what the two moved while their samples travelled, two guarded
ends that have caught up hold U_i = ½K‖d + e‖² and U_j = ½K‖d - p‖², and

    ½K‖d‖² = U_i + U_j - ½K‖d + e - p‖² - K e·p   ≤   U_i + U_j + ½K(a_ij ∫‖v_i‖² + a_ji ∫‖v_j‖²)

over the last ages: an end pays its own age a. That, and what the other's samples will cost, is the damping that an end
that has caught up does not put into its tank. It needs the time of both budgets, and so long an end catches up before
it is READY; its forces are those of a coupled end already. Which instant of that time the other end will take is
unknown, so the tank that stays is the least of that time.

**Who has what the other lacks.** Copies that were apart for long meet again only if both ends can pay. An end that has
caught up gives what its tank holds to an end that says that it lacks energy: what was given in all goes with every
sample, so that losses and repetitions do not matter. It gives no more than the least of the time since it caught up,
see above. Energy on its way belongs to nobody and is lost with the link. A copy's links help each other, too (`Peer`):
what coupled ones do not need goes to those that lack it, with what the body's own damping and B_e took.

**What the other end says is not believed.** Its stamps may be of the future and its gifts may be nobody's. An age
leaves over no more than both budgets, for that is all that this end damps for; and of what the other says it gave, no
more is taken than the tank holds, and no faster than the power limit; of a sum that rises by more than a tank, the rest
is forgotten. So whatever it says, its link puts into this copy
at most what the power limit allows.

**Rounding.** A sample on the wire may be off by ε (in W's norm). A coupled end pays `K ε‖v̂‖_W T` a step from its tank;
what one step takes beyond it is a debt, and guards the link. A guarded end needs no more than its account. At coupling,
the product above grows by K(‖e‖ + ‖p‖)ε + Kε², of which ends that leave another 1/16 of both budgets out of their tanks
pay all but 17 K ε²; that comes out of the tank.
"""

from collections import deque
from math import inf, sqrt
from typing import final

from cotouch.errors import NetworkError
from cotouch.peer._catch_up import CatchUp
from cotouch.peer._guard_ledger import GuardEvent, GuardLedger
from cotouch.peer._links import Link, LinkHeader, LinkState, Sample, SourcedLink

# Share of both budgets that pays for the rounding of samples at coupling; 1/share + 1 times K ε² is left.
_ROUNDING_FRACTION = 1.0 / 16.0
_BURST = 0.1  # [s] of the power that may come at once
_MOST_EVENTS = 256
_LAST_EPOCH = 255


@final
class LinkGuard(SourcedLink):
    """A link with a guard that keeps this end passive, as a source of samples; a `Link` of the peer.

    The peer asks `choose` for the sample, `decide` how far the spring may follow it, and tells `settle` what the step
    did. Between steps its owner may change `budget` and `total`, as the two ends agreed.

    Attributes:
        source: of the samples.
        budget: A_ij, greatest age at the end of a step at which a sample may be used, as this end's clock shows it;
            -inf as long as nothing is agreed [s].
        total: A_ij + A_ji, as far as this end's damping covers it, >= 0 [s].
        state: `GUARDED`, `READY` or `COUPLED`.
        epoch: how often this end was guarded.
        lacking: energy for want of which it could not follow its neighbour, in the last step [J].
        tank: E [J].
        events: the last 256 changes of state; whoever reads them may clear them.
        bypassed: follows every sample, whatever it costs; for who wants to show what a guard is good for.
        tolerant: whether the other end bears errors of this one's samples, because as far as is known both are coupled;
            in between, what follows from a sample must be the truth. As of the last step.
    """

    def __init__(
        self,
        source: Link,
        *,
        budget: float = -inf,
        total: float = 0.0,
        balance: float = 1.0,
        initial_energy: float = 0.0,
        cap: float = inf,
        force: float = inf,
        power: float = inf,
        burst: float | None = None,
        rounding: float = 0.0,
        patience: float = 0.0,
        epoch: int = 1,
    ) -> None:
        """Starts guarded and relaxed.

        Args:
            source: which sample a step would use.
            budget: A_ij [s].
            total: A_ij + A_ji [s].
            balance: d_j/d_i of the age rule; the damping that pays is `½K total balance`.
            initial_energy: what the tank starts with, so that copies at rest apart meet; counts once in the bound on
                what the users can get out, >= 0 [J].
            cap: what the tank keeps at most, >= initial_energy [J].
            force: greatest force of the spring, in the norm of the link's weight, > 0 [N].
            power: what the neighbour may put in by moving its copy, for long, > 0 [W].
            burst: and at once, > 0; None: what the power gives in 0.1 s [J].
            rounding: bound on the error of a sample, in the norm of the link's weight, >= 0 [m].
            patience: over so long its force may grow to what the tank is good for, while a newcomer is on its way,
                >= 0 [s].
            epoch: 1 to 255; another one after a restart than before it.

        Raises:
            NetworkError: an option is out of range.
        """
        for name, value, least, strict in (
            ("balance", balance, 0.0, True),
            ("initial_energy", initial_energy, 0.0, False),
            ("cap", cap, initial_energy, False),
            ("force", force, 0.0, True),
            ("power", power, 0.0, True),
            ("burst", inf if burst is None else burst, 0.0, True),
            ("rounding", rounding, 0.0, False),
            ("patience", patience, 0.0, False),
        ):
            if not (value > least if strict else value >= least):
                raise NetworkError(
                    f"the guard's {name} is {value:g}; it must be {'above' if strict else 'at least'} {least:g}"
                )
        if not 1 <= epoch <= _LAST_EPOCH:
            raise NetworkError(f"the guard's epoch is {epoch}; it must be from 1 to {_LAST_EPOCH}")
        self.source = source
        self.budget = budget
        self.total = total
        self.state = LinkState.GUARDED
        self.epoch = epoch
        self.tank = initial_energy
        self.events = deque[GuardEvent](maxlen=_MOST_EVENTS)
        self.bypassed = self.tolerant = False
        self._keep_back, self._patience, self._waited = initial_energy, patience, 0.0
        self._balance, self._cap, self._rounding = balance, cap, rounding
        self._force, self._power, self._burst = force, power, _BURST * power if burst is None else burst
        self._bucket = self._burst
        self._strength = 0.0
        self._most = inf  # of U, by the force
        self._charge = 0.0  # at coupling
        self._known_epoch = 0
        self._partner = 0  # the other's epoch that this end is coupled with
        self._potential = 0.0
        self._catch_up, self._catching = CatchUp(), False  # the latter in this step
        self.lacking = 0.0
        self._surplus = 0.0  # of the budget, in this step
        self._given_before: float | None = None  # by the other, as heard first
        self._given = self._received = self._shared = self._taken = 0.0
        self._credited = self._paid = self._lost = self._injected = 0.0

    def attach(self, strength: float) -> None:
        """Learns the link's spring [N/m for the identity weight]; the peer calls it."""
        self._strength = strength
        self._most = 0.5 * self._force**2 / strength if strength > 0.0 else inf
        self._charge = strength * self._rounding**2 * (1.0 / _ROUNDING_FRACTION + 1.0)

    @property
    def header(self) -> LinkHeader:
        """What the other end must be told with the sample of the step that was just taken."""
        return LinkHeader(self.state, self.epoch, self._known_epoch, self._given, self.starved)

    @property
    def ledger(self) -> GuardLedger:
        """Energies, as they are now."""
        return GuardLedger(
            self.state,
            self.epoch,
            self._potential,
            self.tank,
            self._credited,
            self._taken,
            self._given + self._shared,
            self._paid,
            self._lost,
            self._injected,
            self._given,
            self._received,
        )

    def decide(self, sample: Sample, desired: float, held: float, now: float, T: float) -> float:
        """How far the spring may follow the sample in the coming step: `ȳ = x + fraction (y - x)`.

        Args:
            sample: the newest, y.
            desired: ‖x - y‖²_W, x at the start of the step [m²]; a sample at no finite distance is ignored.
            held: ‖x - ȳ‖²_W, with ȳ of the step before [m²].
            now: end of the step [s].
            T: its length [s].

        Returns:
            The share, in [0, 1].
        """
        header, half = sample.header, 0.5 * self._strength
        desired, held = half * desired, half * held
        if not desired < inf:
            desired, goal = inf, 0.0
        else:
            goal = min(desired, self._most)
        bucket = self._bucket + self._power * T
        self._bucket = min(bucket, self._burst)
        left = self.budget - (now - sample.stamp) if sample.index >= 0 else -inf
        if self._rounding > 0.0:
            left -= _ROUNDING_FRACTION * self.total
        fresh = left >= 0.0
        surplus = min(left - 0.5 * T, self.total)
        self._surplus = surplus if fresh and surplus > 0.0 else 0.0
        if sample.index >= 0:
            self._known_epoch = header.epoch
            self._receive(header.given, T)
        self.lacking, self.tolerant = 0.0, False
        if self.bypassed and sample.index >= 0 and desired < inf:
            self._catching = False
            self._move(desired, held)
            return 1.0
        if self.state == LinkState.COUPLED:
            reason = self._why_guard(header, fresh, goal - held)
            if not reason:
                self._move(goal, held)
                self.tolerant = header.state == LinkState.COUPLED
                return 1.0 if goal == desired else sqrt(goal / desired)
            self._fall(now, reason, self.tank)
            available = self.tank
        else:
            available = self.tank + held
        if self._waited < self._patience:
            goal = min(goal, (self._waited / self._patience) ** 2 * available)
            self._waited += T
        potential = self._affordable(goal, held, available)
        caught = fresh and potential == desired
        if self.state == LinkState.READY and not (caught and self._catch_up.time >= self.total):
            self._fall(now, "left behind" if fresh else "too old", self._catch_up.least)
            available = self.tank
            potential = self._affordable(goal, held, available)
            caught = fresh and potential == desired
        self.lacking = goal - potential if fresh and potential < goal and available <= potential else 0.0
        if not caught:
            self._catch_up.begin()
        self._paid += self.tank - (available - potential)
        self.tank = available - potential
        self._move(potential, held)
        self._catching = caught
        if caught:
            self._catch_up.note(self.tank, self.total, T, guarded=header.state == LinkState.GUARDED)
            self._rise(header, now)
            if header.starved and header.state == LinkState.GUARDED and self.state != LinkState.COUPLED:
                self._give()
            self._catch_up.time += T
            return 1.0
        return sqrt(potential / desired) if potential > 0.0 else 0.0

    def settle(self, square: float, T: float) -> None:
        """Books what the step left over.

        Args:
            square: ‖v̂‖²_W, v̂ the mean velocity of the step [m²/s²].
            T: its length [s].
        """
        trusted = self.state == LinkState.COUPLED or self._catching
        span = self._surplus if trusted else self.total
        gain = 0.5 * self._strength * self._balance * span * square * T
        self._credited += gain
        if self._rounding > 0.0 and self.state == LinkState.COUPLED:
            price = self._strength * self._rounding * sqrt(square) * T
            self._paid += price
            gain -= price
        self._keep(self.tank + gain)

    @property
    def starved(self) -> bool:
        """Whether this end cannot follow its neighbour for want of energy, as of the last step."""
        return self.lacking > 0.0

    def donate(self) -> float:
        """Takes out of the tank of a coupled end what it can do without, for the copy's other links [J]."""
        if self.state != LinkState.COUPLED or self.tank <= self._keep_back:
            return 0.0
        spare = self.tank - self._keep_back
        self.tank = self._keep_back
        self._shared += spare
        return spare

    def help(self, energy: float) -> None:
        """Gets energy of the copy's other links, or of its own damping.

        Args:
            energy: >= 0 [J].
        """
        self._taken += energy
        self._keep(self.tank + energy)

    def _receive(self, given: float, T: float) -> None:
        """Takes what the other end gave since it was heard first, as fast as it may and as far as there is room."""
        if self._given_before is None:
            self._given_before = given
        due = given - self._given_before - self._received
        if due > self._cap:  # an honest end has no more to give than its own tank held
            self._given_before += due - self._cap
            due = self._cap
        taken = min(due, self._power * T, self._cap - self.tank)
        if taken > 0.0:
            self._received += taken
            self.help(taken)

    def _give(self) -> None:
        """Gives the other end, which lacks it, what this one has for certain."""
        spare = min(self.tank, self._catch_up.least) - 2.0 * self._charge  # what coupling will cost, and more
        if spare > 0.0:
            self.tank -= spare
            self._catch_up.give(spare)
            self._given += spare

    def _why_guard(self, header: LinkHeader, fresh: bool, rise: float) -> str:
        """Why a coupled end cannot stay so; empty if it can."""
        if not fresh:
            return "too old"
        if header.state == LinkState.GUARDED:
            return "the other is guarded"
        if header.epoch != self._partner:
            return "the other was guarded"
        if rise > self._bucket:
            return "too much power"
        return "rounding" if self.tank < 0.0 else ""

    def _affordable(self, goal: float, held: float, available: float) -> float:
        """The potential nearest to the desired position that energy and power allow."""
        return max(0.0, min(goal, available, held + self._bucket))

    def _move(self, potential: float, held: float) -> None:
        """Takes ȳ as moved."""
        rise = potential - held
        self._injected += rise
        if rise > 0.0:
            self._bucket -= rise
        self._potential = potential

    def _keep(self, tank: float) -> None:
        """Fills the tank; what it cannot hold is lost."""
        if tank > self._cap:
            self._lost += tank - self._cap
            tank = self._cap
        self.tank = tank

    def _fall(self, now: float, reason: str, tank: float) -> None:
        """Guards the link, with so much in the tank and nothing in the spring."""
        self._lost += self.tank - tank
        self.tank = tank
        self.state = LinkState.GUARDED
        self.epoch = self.epoch % _LAST_EPOCH + 1
        self._catch_up.begin()
        self.events.append(GuardEvent(now, LinkState.GUARDED, reason))

    def _rise(self, header: LinkHeader, now: float) -> None:
        """An end that has caught up becomes ready, and then couples."""
        if self._catch_up.time < self.total or header.known_epoch != self.epoch:
            return
        if header.state != LinkState.GUARDED and self._catch_up.least >= self._charge:
            self._lost += self.tank - self._catch_up.least
            self._paid += self._charge
            self.tank = self._catch_up.least - self._charge
            self.state, self._partner = LinkState.COUPLED, header.epoch
            self.events.append(GuardEvent(now, LinkState.COUPLED, "both have caught up"))
        elif self.state == LinkState.GUARDED:
            self.state = LinkState.READY
            self.events.append(GuardEvent(now, LinkState.READY, "caught up"))
