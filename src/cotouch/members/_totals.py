"""What a copy's ledger adds up to."""

from collections.abc import Sequence
from typing import final

from cotouch.mechanics import CLOSURE_ALARM
from cotouch.peer import StepReport

# A residual above this share of the energy in play means that something is broken, not round-off.
TOTALS_ALARM = 1e-9
# Round-off of less than this is not worth an alarm, whatever the share of a copy at rest [J].
_LEAST = 1e-9
# What the law takes of the motion is forgotten over so long [s].
_FORGET = 10.0


@final
class Totals:
    """Sums over all steps, and what was worst.

    Attributes:
        steps: so many.
        initial: energy at the start [J].
        supplied: work of the hands at ports and proxies [J].
        lost: in all dampers and contacts [J].
        linked: work of all links on the copy [J].
        link_work: of each link by its neighbour [J].
        advanced: what the links' tanks got of the newcomer's allowance [J].
        rescaled: what the copy's energy changed by as members came and went [J].
        energy: after the last step [J].
        depth: how far it was below 0 at most, as a body falls below where it began [J].
        in_play: the most that was stored, in motion, supplied, lost or exchanged [J].
        residual: greatest of any step, of the energy in play then.
        total_residual: sum of all steps' residuals [J].
        alarms: steps whose residual is too large to be round-off.
        braked: what the law took of the motion in the last seconds, by B_i and links, less what these gave [J].
        moved: ∫‖v̂‖² over them, in the identity weight [m²/s].
        link_age: of the samples of each neighbour, by the clocks as they are, in the mean of them [s].
        cut: with the elements that were cut, part of `lost` [J].
        closure: work on the velocities that closed steps of a body with a material; in no other sum [J].
        closure_factor: greatest |β - 1| of any step.
        closure_alarms: steps in which that was too large for their forces and energy to agree, or that were shortened.
        least: least of `supplied + initial + depth` so far; negative: the hands got out what nobody put in [J].
    """

    def __init__(self) -> None:
        self.steps = 0
        self.initial = self.supplied = self.lost = self.linked = self.rescaled = self.energy = self.advanced = 0.0
        self.in_play = _LEAST
        self.depth = 0.0
        self.residual = self.total_residual = 0.0
        self.link_work: dict[int, float] = {}
        self.alarms = self.closure_alarms = 0
        self.closure = self.closure_factor = self.cut = 0.0
        self.least = 0.0
        self.braked = self.moved = 0.0
        self.link_age: dict[int, float] = {}
        self._exchanged = 0.0

    def add(self, report: StepReport, neighbours: Sequence[int], T: float) -> None:
        """Adds a step.

        Args:
            report: of the step.
            neighbours: as `Peer.neighbours`.
            T: length of the step [s].
        """
        supplied = report.supplied + report.drive_work
        lost = report.body_loss + report.local_loss + report.extra_loss + report.touch_loss + report.cut
        energy = report.kinetic + report.elastic + report.proxy + report.touch_stored
        if not self.steps:
            self.initial = energy - (supplied - lost + float(report.link_work.sum()) + report.rescaled)
        link_work, link_age, linked, exchanged = self.link_work, self.link_age, 0.0, 0.0
        keep = 1.0 - T / _FORGET  # steps are far shorter
        self.steps += 1
        self.supplied += supplied
        self.lost += lost
        for slot, work, age in zip(neighbours, report.link_work.tolist(), report.age.tolist(), strict=True):
            link_work[slot] = link_work.get(slot, 0.0) + work
            link_age[slot] = age + keep * (link_age.get(slot, age) - age)
            linked += work
            exchanged += abs(work)
        self.linked += linked
        self._exchanged += exchanged
        self.braked = keep * self.braked + report.local_loss - linked
        self.moved = keep * self.moved + T * report.speed
        self.rescaled += report.rescaled
        self.advanced += report.advanced
        self.energy = energy
        self.depth = max(self.depth, -energy)
        # What falls freely has as much motion as its weight gave, and no energy in all.
        held = max(report.kinetic + report.proxy, abs(report.elastic), abs(energy))
        self.in_play = max(self.in_play, held, abs(self.supplied), self.lost, self._exchanged)
        self.total_residual += report.residual
        fraction = abs(report.residual) / self.in_play
        self.residual = max(self.residual, fraction)
        self.alarms += fraction > TOTALS_ALARM
        self.closure += report.closure
        self.cut += report.cut
        self.closure_factor = max(self.closure_factor, report.closure_factor)
        tells = (
            abs(report.closure) > TOTALS_ALARM * self.in_play
        )  # a copy that comes to rest has hardly any motion left
        self.closure_alarms += (report.closure_factor > CLOSURE_ALARM and tells) or report.shortened > 0.0
        self.least = min(self.least, self.supplied + self.initial + self.depth)
