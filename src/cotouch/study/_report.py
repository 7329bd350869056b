"""The frame of the report: what stands above the chapters, and the equations that all of them use."""

import os
import platform
from collections.abc import Mapping, Sequence
from html import escape
from importlib.metadata import version
from pathlib import Path

from cotouch.pages import Section, num, table
from cotouch.study._bound import Bound
from cotouch.study._experiment import Experiment
from cotouch.study._modes import Modes
from cotouch.study._theorem import Theorem
from cotouch.study._topologies import Topologies

PAPER = (
    "D. Lee and K. Huang, “Peer-to-Peer Control Architecture for Multiuser Haptic Collaboration over Undirected "
    "Delayed "
    "Packet-Switching Network”, 2010"
)

_WARNING = (
    '<p class="note no">Not all results are as expected: look for ✗ in the tables and for thresholds out of '
    "order. The text below describes what was expected.</p>"
)


def lead(
    found: Topologies,
    trials: Experiment,
    theorem: Theorem,
    below: Bound,
    modes: Modes,
    *,
    residual: float,
    confirmed: bool,
) -> str:
    """What stands above the first chapter.

    Args:
        found: the choice of links.
        trials: positions and forces.
        theorem: what was checked of Theorem 1.
        below: runs below the bound.
        modes: the three ways of synchronising.
        residual: largest of all runs.
        confirmed: whether every claim was.
    """
    held = sum(claim.holds for claim in theorem.claims)
    best, worst = trials.best.settling["agreement"], trials.worst.settling["agreement"]

    def keep(text: str) -> str:
        return text.replace(" ", "&nbsp;")

    cards = (
        (f"{len(found.graphs)} of {found.choices}", "choices of six links connect everyone; each was looked at"),
        (f"{num(best, 2)} or {num(worst, 3)} s", "until the five agree after letting go: best links, worst links"),
        (f"{held} of {len(theorem.claims)}", "claims of Theorem 1 and after it hold as measured"),
        (
            f"{num(modes.savings['buffered'].middle, 2)} × or {num(modes.savings['buffered 99 %'].middle, 2)} × less",
            "damping with the freshest sample than with a buffer for every sample, or for 99 % of them (which no "
            f"theorem covers); means over {len(modes.seeds)} seeds of one bad channel",
        ),
        (
            f"{num(100 * below.exact, 2)} % and {num(100 * below.critical, 2)} %",
            "of the rule’s damping: below, hands can get energy out; below, copies diverge by themselves",
        ),
        (num(residual, 2), "is the most that the energy ledger of any run here miss, of the energy in play"),
    )
    boxes = "".join(f"<div><b>{keep(value)}</b><span>{text}</span></div>" for value, text in cards)
    return f"""<p class="kicker">The paper’s experiment and claims, tested</p>
<h1>Five users hold one object over a slow network</h1>
<p class="lede">Each user simulates a copy of the same object. Springs over a delayed network pull the copies
together, and damping at each copy pays for the delay. Lee and Huang showed in 2010 how much damping is enough for
<em>any</em> passive hands and devices, and which links to choose when only some can be had. This report runs their
experiment with hands of its own (theirs are not printed), puts a measured number beside each claim, goes below the
bound to see what breaks, runs hands, devices, couplings and contacts around a solid in three dimensions, and says where
the printed text is wrong.</p>
<p>Every number is computed by the run that wrote this page; only what is marked <em>expected</em> was known
before.</p>
{"" if confirmed else _WARNING}
<div class="cards">{boxes}</div>"""


def provenance(modes: Modes, *, seeds: Mapping[str, int], steps: Sequence[float], seconds: float) -> Section:
    """With what all of this was computed, so that somebody else can compute it again.

    Args:
        modes: whose channel has seeds.
        seeds: of other chapters, by what they are of.
        steps: lengths of the steps of the runs on one axis [s].
        seconds: that it took so far.
    """
    libraries = ", ".join(f"{name} {version(name)}" for name in ("numpy", "scipy", "numba", "xarray", "matplotlib"))
    rows = [
        ["Program", f"cotouch {version('cotouch')}"],
        ["Python and libraries", f"{platform.python_implementation()} {platform.python_version()}; {libraries}"],
        ["System", f"{platform.system()} {platform.release()}, {platform.machine()}"],
        ["Processor", f"{_processor()}, {os.cpu_count()} logical cores"],
        ["Computed in", f"{num(seconds, 2)} s, with what had to be compiled"],
        ["Steps", ", ".join(f"{1e3 * step:g} ms" for step in sorted(set(steps)))],
        [
            "Seeds",
            f"channel of the modes {modes.seed}, of the comparison of their damping {modes.seeds[0]} to "
            f"{modes.seeds[-1]}; " + ", ".join(f"{name} {seed}" for name, seed in seeds.items()),
        ],
    ]
    body = f"""<p>The same versions give the same numbers to the last bit on processors of one kind; others agree to the
digits that are printed.</p>
{table(["", ""], [[name, escape(text)] for name, text in rows], text=(0, 1))}"""
    return Section(anchor="provenance", title="How this was computed", body=body)


def _processor() -> str:
    """Its name, as far as the system tells it."""
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
    except OSError:
        lines = []
    named = (line.split(":", 1)[1].strip() for line in lines if line.startswith("model name"))
    return next(named, platform.processor() or "unknown")


def model() -> Section:
    """The equations, as far as the rest needs them."""
    return Section(
        anchor="model",
        title="The copies and their springs",
        body="""<p>User <var>i</var> of <var>N</var> simulates an object with mass <var>M</var>, damping <var>B</var>
and stiffness <var>K</var>, all divided by <var>N</var>, so that the copies together weigh as much as one object:</p>
<p class="display"><span class="math">(1/N)·[M a<sub>i</sub> + B v̂<sub>i</sub> + K(x̂<sub>i</sub> − x<sub>d</sub>)] =
u<sub>i</sub> + f<sub>i</sub></span>, &emsp; <span class="math">u<sub>i</sub> = −B<sub>i</sub> v̂<sub>i</sub> −
Σ<sub>j</sub> K<sub>ij</sub>(x̂<sub>i</sub>(k) − x̂<sub>j</sub>(k − N<sub>ij</sub>))</span></p>
<p>A hat is the mean of a step’s two ends: <span class="math">v̂ = (x⁺ − x)/T</span>, <span class="math">x̂ = (x⁺ +
x)/2</span>. With these, one linear solve makes a step whose energy balance is exact for any step length <var>T</var>.
The hands’ forces are <span class="math">f<sub>i</sub></span>; the copy of user <var>j</var> is seen
<span class="math">N<sub>ij</sub></span> steps late. Theorem 1 of the paper: if every user keeps</p>
<p class="display"><span class="math">B<sub>i</sub> ≥ Σ<sub>j</sub> ½ (N<sub>ij</sub> + N<sub>ji</sub>)
max<sub>k</sub> T<sub>j</sub>(k) K<sub>ij</sub></span> &emsp; (“the rule”)</p>
<p>then all users together are passive: whatever their hands do, no more energy can be taken out than was
put in.</p>""",
    )
