"""The chapter on a solid in three dimensions: numbers and figures into words."""

from html import escape

import numpy as np

from cotouch.pages import Section, figure, formula, num, quantity, table, verdict
from cotouch.study import _solid_charts as charts
from cotouch.study._scene import DEVICES, DOES, RELEASE, STEPS
from cotouch.study._solid import BELOW, SolidFindings
from cotouch.study._tick import worst_tick

# Of the hand that takes all that one tick can give away [N/m, m/s].
_WALL, _QUICK = 2000.0, 0.5


def solid(found: SolidFindings, links: str) -> Section:
    """All four blocks of Fig. 2, and their energy.

    Args:
        found: what the run showed.
        links: the links of that network, as the report names them.
    """
    constant, freshest = found.runs["constant"], found.runs["freshest"]
    forces = np.linalg.norm(freshest.rest.force, axis=1)
    users = table(
        ["User", "Device", "Tool", "Coupling", "|f| at rest", "Gave at most", "d²"],
        [
            [
                str(port.user + 1),
                escape(DEVICES[port.user]),
                escape(DOES[port.user]),
                "PSPM" if port.law == "pspm" else "host force",
                quantity(float(forces[port.user]), "N"),
                quantity(1e3 * port.excess, "mJ", 2),
                quantity(1e3 * port.bound, "mJ", 2),
            ]
            for port in freshest.blocks.couplings
        ],
        text=(0, 1, 2, 3),
    )
    margins = table(
        ["Block", "What was measured over the whole run", "Constant", "Freshest", "Must be", "Verdict"],
        [
            [
                row[0].item,
                formula(row[0].text),
                *(quantity(claim.measured, claim.unit, 2) for claim in row),
                f"{row[0].sign} {quantity(row[0].limit, row[0].unit, 1)}",
                verdict(holds=all(claim.holds for claim in row)),
            ]
            for row in found.claims
        ],
        text=(0, 1, 5),
    )
    pictures = figure(
        charts.copies(found),
        "fig-solid",
        f"<b>Everyone holds, half a second before letting go</b>, freshest samples. Five copies of "
        f"{found.places.shape[0]:,} nodes, each with its user’s tool and force, and their average. Dashed: at rest.",
        "Six drawings of a block: users 1 and 3 pull at its upper edges, 2 and 4 press on its sides, 5 on its top; the "
        "average is deformed much less.",
    )
    energies = figure(
        charts.energies(found),
        "fig-blocks",
        "<b>Where the work of the hands goes</b>, all users together; shaded: they hold. A block that ends below 0 has "
        f"made energy. Right: the shared object under the rule and with {100 * BELOW:g} % of its damping.",
        "Left and middle, work of the hands and what each of four blocks has taken, over time; right, with little "
        "damping the shared object gives back all that it had taken, and more.",
    )
    below = found.below
    split = max(run.blocks.split for run in found.runs.values())
    crossed = float(below.time[int(np.argmax((below.object < 0.0) & (below.time > 1.0)))])
    gone = float(below.object[-1])
    used = max(run.blocks.used for run in found.runs.values())
    tick = worst_tick(stiffness=_WALL, period=1e-3, speed=_QUICK)
    body = f"""<p>So far the object had one axis, and hands pulled at it directly. Here is everything that the paper’s
Fig. 2 puts between a hand and the object, five times, around one elastic block in three dimensions:
{found.places.shape[0]:,} nodes, 1 kg, springs between neighbours, its lower face held softly. Each user has a
simulated <b>hand and device</b>, a <b>coupling</b>, a <b>proxy</b> that touches or grasps the skin, and a <b>copy</b>
of the object. Links and delays are those of {links}; a link’s spring is shared out over the nodes. All users change
their steps at every step, between {1e3 * STEPS[0]:g} and {1e3 * STEPS[1]:g} ms, whatever their servos’ rates. The scene
is chosen here; the paper has none like it.</p>
{users}
{pictures}
<p>Soft links share where the block is and how it is turned, but not every dent: the copies differ by up to
{quantity(1e3 * freshest.rest.apart, "mm", 2)} where somebody holds. Eq. (6) is about their average and holds node by
node: <span class="math">K(x̄ − x<sub>d</sub>)</span> is each tool’s force where that tool is, and nothing anywhere
else. {RELEASE:g} s after the start all let go, and the copies come together again.</p>
<h3>Each block, and the whole</h3>
<p>The paper’s argument is that passive blocks in a row are passive together. It assumes this of the contact and of the
coupling; here it is measured. Work is counted where it crosses from one block to the next, force times motion at every
step, from rest. A step solves a body and its proxies together; the sum of their energies is exact to round-off, the
share of each to {quantity(split, "J", 1)} in these runs, the solver’s accuracy.</p>
{energies}
{margins}
<p>The motors’ sampled force may take a little more out of a PSPM coupling than is in it, at most what one tick does at
full speed; that, and what its tank begins with for the steps of its encoders, is <span class="math">d²</span>.
Couplings here use at most {num(100 * used, 2)} % of theirs. That a tick can take so much shows with exact encoders,
whose tanks begin empty: a hand that goes along with the held force for one tick takes
{num(100 * tick.taken / tick.bound, 3)} % of the d² of its speed
({quantity(1e3 * tick.taken, "mJ", 3)} at {_WALL:g} N/m, 1 kHz and {_QUICK:g} m/s), and the spring is off at the next.
The virtual coupling has no such store: its device must pay with its
own damping, so user 4’s has 3&nbsp;Ns/m, which most products have not.</p>
<h3>With too little damping</h3>
<p>The same with {100 * BELOW:g} % of the rule’s damping (the rule asks for up to
{quantity(constant.damping, "Ns/m")} with constant delays, {quantity(freshest.damping, "Ns/m")} with freshest samples).
The hands do nothing but hold; how firmly decides whether it shows, which no designer knows beforehand.
After {quantity(crossed, "s", 2)} the shared object has returned all that it was
given; at the end it has given {quantity(-gone, "J", 2)} out of nothing. Contacts, couplings and devices stay passive
throughout: contacts gave at most {quantity(below.given, "J", 2)}, couplings {num(100 * below.used, 2)} % of their d².
The ledger balances to {num(below.energy_residual, 2)} there, too, and say where the energy comes from: the age of the
samples put {quantity(below.aged, "J", 2)} into the links.</p>"""
    return Section(anchor="solid", title="All four blocks, in three dimensions", body=body)
