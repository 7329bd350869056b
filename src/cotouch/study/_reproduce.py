"""From the example's file to the report."""

import time
from dataclasses import dataclass
from pathlib import Path
from typing import final

from cotouch.files import check_writable, folder, write
from cotouch.interrupt import interruptible
from cotouch.network import Network
from cotouch.pages import Section, page
from cotouch.processes import aside
from cotouch.study import _errata, _scene, _theorem
from cotouch.study import _report as report
from cotouch.study import _report_channel as of_channel
from cotouch.study import _report_errata as of_errata
from cotouch.study import _report_links as of_links
from cotouch.study import _report_solid as of_solid
from cotouch.study import _report_theorem as of_theorem
from cotouch.study._bound import Bound, bound
from cotouch.study._certificates import Certificates, certificates
from cotouch.study._data import Progress, five_users
from cotouch.study._errata import Errata, errata
from cotouch.study._experiment import PERIOD, Experiment, experiment
from cotouch.study._modes import Modes, modes
from cotouch.study._solid import SolidFindings, solid, warm_up
from cotouch.study._theorem import Theorem, theorem
from cotouch.study._topologies import Topologies, topologies

REPORT = "report.html"

# The energy ledger of every run must balance to this share of the energy in play.
_RESIDUAL = 1e-10
# Steps of the runs [s] and corners of the worst hands' polygons: in full, and where a quick look is enough.
_FULL = {"period": PERIOD, "theorem": 2e-3, "corners": 40}
_QUICK = {"period": 5e-3, "theorem": 5e-3, "corners": 24}


@final
@dataclass(frozen=True, kw_only=True, eq=False)
class Reproduction:
    """Everything that a reproduction found.

    Attributes:
        report: path of the HTML page.
        topologies: all choices of links, ranked.
        experiment: held and released, best and worst.
        theorem: claim by claim.
        bound: below the damping bound.
        modes: freshest against constant delay.
        certificates: damping by each method.
        solid: all four blocks of Fig. 2 around a solid in three dimensions.
        errata: what the text gets wrong.
        energy_residual: the most that the ledger of any run miss, of the energy in play.
        confirmed: whether reference values, claims, the order of the thresholds and all ledgers came out as they
            should.
        seconds: how long it took.
    """

    report: Path
    topologies: Topologies
    experiment: Experiment
    theorem: Theorem
    bound: Bound
    modes: Modes
    certificates: Certificates
    solid: SolidFindings
    errata: Errata
    energy_residual: float
    confirmed: bool
    seconds: float

    @property
    def numbers(self) -> dict[str, object]:
        """All numbers, ready for JSON."""
        return {
            "confirmed": self.confirmed,
            "energy_residual": self.energy_residual,
            "topologies": self.topologies.numbers(),
            "experiment": self.experiment.numbers(),
            "theorem": self.theorem.numbers(),
            "bound": self.bound.numbers(),
            "modes": self.modes.numbers(),
            "certificates": self.certificates.numbers(),
            "solid": self.solid.numbers(),
            "errata": self.errata.numbers(),
            "seconds": self.seconds,
            "report": str(self.report),
        }


def reproduce(out: Path, *, progress: Progress | None = None, quick: bool = False) -> Reproduction:
    """Repeats the paper and writes `report.html`.

    Args:
        out: folder of the report, made if need be.
        progress: told before each part how many of how many are done, and what comes next.
        quick: longer steps and fewer hands, for tests; the claims are the same.

    Raises:
        OutputError: the folder or the report cannot be written.
    """
    begun = time.perf_counter()
    size = _QUICK if quick else _FULL
    period, corners = float(size["period"]), int(size["corners"])
    check_writable(folder(out) / REPORT)
    total = 9

    def tell(done: int, text: str) -> None:
        if progress is not None:
            progress(done, total, text)

    # Another process compiles what only the chapter in three dimensions needs, into the cache that it will read. The
    # first time that takes a minute, which passes while the chapters before it are worked out; later hardly anything.
    with aside(warm_up.__module__, warm_up.__name__) as compiling:
        tell(0, "looking at every choice of links")
        links = interruptible(topologies)(Network.read(five_users()))
        best = links.best
        tell(1, "five users hold and let go")
        trials = interruptible(experiment)(best, links.worst, links.misjudged, period=period)
        tell(2, "Theorem 1, claim by claim")
        claims = interruptible(theorem)(best, period=float(size["theorem"]), corners=corners)
        tell(3, "below the damping bound")
        below = interruptible(bound)(best, links.worst, period=period, corners=corners)
        tell(4, "freshest against constant delay")
        channel = interruptible(modes)(best, period=period)
        tell(5, "certificates")
        proofs = interruptible(certificates)(best, period=period, corners=corners)
        tell(6, "all four blocks, in three dimensions")
        compiling.wait()
        whole = interruptible(solid)(best, quick=quick)
    tell(7, "errata")
    slips = interruptible(errata)(links)
    tell(8, "drawing and writing the report")
    runs = [
        *(trial.run for trial in (trials.best, trials.worst, trials.misjudged)),
        *below.runs.values(),
        *(attack.run for attack in below.attacks.values()),
        *(way.run for way in channel.ways.values()),
    ]
    residual = max(claims.residual, whole.residual, *(float(run.attrs["energy_residual"]) for run in runs))
    confirmed = (
        all(reference.agrees for reference in links.references)
        and all(claim.holds for claim in claims.claims)
        and below.as_expected
        and whole.holds
        and residual <= _RESIDUAL
    )
    text = _write_up(
        links,
        trials,
        claims,
        below,
        channel,
        proofs,
        whole,
        slips,
        residual=residual,
        confirmed=confirmed,
        made=report.provenance(
            channel,
            seeds={
                "steps of the theorem’s runs": _theorem.SEED,
                "steps of the solid": _scene.SEED,
                "states of the first-order model": _errata.SEED,
            },
            steps=(period, float(size["theorem"]), max(period, 5e-3)),
            seconds=time.perf_counter() - begun,
        ),
    )
    path = out / REPORT
    write(path, text.encode("utf-8"), "report")
    tell(total, "done")
    return Reproduction(
        report=path,
        topologies=links,
        experiment=trials,
        theorem=claims,
        bound=below,
        modes=channel,
        certificates=proofs,
        solid=whole,
        errata=slips,
        energy_residual=residual,
        confirmed=confirmed,
        seconds=time.perf_counter() - begun,
    )


def _write_up(
    links: Topologies,
    trials: Experiment,
    claims: Theorem,
    below: Bound,
    channel: Modes,
    proofs: Certificates,
    whole: SolidFindings,
    slips: Errata,
    *,
    residual: float,
    confirmed: bool,
    made: Section,
) -> str:
    from cotouch import drawing
    from cotouch.version import __version__

    with drawing.style():
        return page(
            title="Five users hold one object over a slow network",
            lead=report.lead(links, trials, claims, below, channel, residual=residual, confirmed=confirmed),
            sections=[
                report.model(),
                of_links.choice(links),
                of_links.trials(trials),
                of_theorem.proofs(claims, trials.best.links),
                of_theorem.edge(below),
                of_channel.channel(channel),
                of_channel.guarantees(proofs),
                of_solid.solid(whole, trials.best.links),
                of_errata.corrections(slips, links),
                made,
            ],
            footer=f"{report.PAPER}. Computed and written by cotouch {__version__}.",
        )
