"""What an audit says: every user's energy, every link's, what is not accounted for, and the verdict in words."""

from dataclasses import dataclass
from typing import final

from cotouch.arrays import Float
from cotouch.recording._findings import AuditFinding
from cotouch.recording._law import LawLedger
from cotouch.recording._links import LinkLedger
from cotouch.units import user_number


@final
@dataclass(frozen=True, kw_only=True)
class UserLedger:
    """One user's energy over the whole recording, recomputed [J].

    Attributes:
        user: index.
        name: of the user.
        steps: recorded.
        worked_out: steps whose state is recorded.
        supplied: by hands and by what pulls the proxies.
        body_loss: taken by the body's own dampers.
        local_loss: by the damping of the synchronisation.
        extra_loss: by the extra damping.
        touch_loss: in contacts and grasps.
        cut: with the elements that were cut.
        link_work: of all links on the copy.
        members: came with others' joining and leaving.
        stored: at the end less at the start.
        residual: what nothing explains.
        closure: work on the velocity that closed the steps of a body with a material; in no other column.
        closure_factor: greatest change of the velocity by that, |β - 1|.
        damping: least B_i there was, over the identity [Ns/m].
        asked: what the age rule asks for, for the ages that there were [Ns/m].
    """

    user: int
    name: str
    steps: int
    worked_out: int
    supplied: float
    body_loss: float
    local_loss: float
    extra_loss: float
    touch_loss: float
    cut: float
    link_work: float
    members: float
    stored: float
    residual: float
    closure: float
    closure_factor: float
    damping: float
    asked: float


@final
@dataclass(frozen=True, kw_only=True, eq=False)
class Audit:
    """The result of an audit.

    Attributes:
        users: their ledger.
        links: of those that both ends are recorded of.
        law: of all links, and what hands felt of it.
        findings: energy that is not accounted for, largest first; empty if all is well.
        complete: whether every step of everybody is recorded with its state.
        notes: what could not be judged, or is worth knowing; one sentence each.
        tolerance: what energies may differ by [J].
        in_play: the most that was stored, supplied or lost [J].
        initial: c², stored at the beginning, with what links were given to begin with [J].
        margin: the least of `Σ ∫ f v + c²`, with what others' joining and leaving brought or took [J].
        margin_time: when, since the beginning [s].
        time: instants of the next three, since the beginning [s].
        supplied: by all users so far [J].
        made: by all links through the age of samples so far [J].
        taken: by all damping of the synchronisation so far [J].
    """

    users: tuple[UserLedger, ...]
    links: tuple[LinkLedger, ...]
    law: LawLedger
    findings: tuple[AuditFinding, ...]
    complete: bool
    notes: tuple[str, ...]
    tolerance: float
    in_play: float
    initial: float
    margin: float
    margin_time: float
    time: Float
    supplied: Float
    made: Float
    taken: Float

    @property
    def holds(self) -> bool:
        """Whether all energy is accounted for, and nobody got out more than was there."""
        return not self.findings

    @property
    def verdict(self) -> str:
        """In words."""
        if not self.holds:
            first = self.findings[0]
            more = len(self.findings) - 1
            rest = f" ({more} more {'finding' if more == 1 else 'findings'})" if more else ""
            return f"Violated: {first.words}, first at {first.time:.4g} s{rest}."
        least = f"the energy put in by users, with what was there at the start, was never below {self.margin:.4g} J"
        if self.margin < -self.tolerance:  # by what is recorded, and not everybody is
            least = "what others put in is not recorded"
        partly = "" if self.complete else ", as far as recorded"
        return f"Holds{partly}: every step's energy is explained to {self.tolerance:.2g} J, and {least}."

    def numbers(self) -> dict[str, object]:
        """Everything but the series, for JSON; users numbered from 1."""
        return {
            "holds": self.holds,
            "complete": self.complete,
            "verdict": self.verdict,
            "tolerance_j": self.tolerance,
            "energy_in_play_j": self.in_play,
            "initial_j": self.initial,
            "law": self.law.numbers(),
            "passivity_margin_j": self.margin,
            "passivity_margin_time_s": self.margin_time,
            "users": [{**vars(ledger), "user": user_number(ledger.user)} for ledger in self.users],
            "links": [
                {
                    "link": [user_number(user) for user in ledger.ends],
                    "work_j": list(ledger.work),
                    "spring_j": ledger.spring,
                    "dissipated_j": ledger.dissipated,
                    "made_by_state_j": dict(ledger.by_state),
                    "excess_j": ledger.excess,
                    "age_s": list(ledger.age),
                    "judged": ledger.strict,
                    "without_gap": ledger.whole,
                    "as_booked": ledger.unknown,
                }
                for ledger in self.links
            ],
            "findings": [
                {
                    "place": finding.place,
                    "user": None if finding.user is None else user_number(finding.user),
                    "link": None if finding.link is None else [user_number(user) for user in finding.link],
                    "energy_j": finding.energy,
                    "time_s": finding.time,
                    "step": finding.step,
                    "words": finding.words,
                }
                for finding in self.findings
            ],
            "notes": list(self.notes),
        }
