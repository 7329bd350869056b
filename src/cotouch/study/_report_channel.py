"""The chapters on bad channels and on what is certified."""

from html import escape

import numpy as np

from cotouch.pages import Section, figure, num, quantity, table
from cotouch.study import _charts as charts
from cotouch.study._certificates import Certificates
from cotouch.study._modes import JITTER, LOSS, Modes


def channel(found: Modes) -> Section:
    """Freshest against constant delay."""
    rows: list[list[str]] = []
    for name, way in found.ways.items():
        ages, s = way.ages, way.settling
        rows.append(
            [
                name,
                num(float(way.damping.max())),
                num(float(np.median(ages))),
                num(float(np.quantile(ages, 0.99))),
                num(float(ages.max())),
                *(num(s[key]) if s[key] is not None else "not settled" for key in ("position", "force", "agreement")),
                num(way.pace, 4),
                num(float(way.run.attrs["energy_residual"]), 2),
                num(float(way.run.attrs["passivity_margin"]), 2),
            ]
        )
    drawn = figure(
        charts.ages(found),
        "fig-ages",
        "<b>Age of the samples that the steps use.</b> Left: one direction, whose delay without jitter is "
        f"{quantity(found.delay, 's')}. Right: all directions; the steps are the links’ own delays. The buffered modes "
        "make every sample as old as the oldest.",
        "Left, age of samples over time in four modes; right, the share of samples older than a given age.",
    )
    positions = figure(
        charts.ways(found),
        "fig-modes",
        "<b>Positions of the five users</b> on the same channel.",
        "Positions over time with a buffer, self-paced, and with the freshest sample, which settles first.",
    )
    results = table(
        [
            "Mode",
            "Largest B<sub>i</sub><br>(Ns/m)",
            "Age<br>median (s)",
            "99 %<br>(s)",
            "largest<br>(s)",
            "Position<br>settled (s)",
            "Force<br>settled (s)",
            "Agreed after<br>release (s)",
            "Steps per s<br>and user",
            "Energy<br>residual",
            "Margin<br>(J)",
        ],
        rows,
        kind="dense",
    )
    passive = sum(float(way.run.attrs["passivity_margin"]) >= 0.0 for way in found.ways.values())
    short = found.ways["buffered 99 %"]
    paced = found.ways["self-paced"]
    body = f"""<p>The theorem wants a constant indexing delay. A real channel has jitter and loses messages; here it
adds up to {1e3 * JITTER:g} ms to each delay and loses {100 * LOSS:g} % of the messages. One scenario file, with one
word changed, <code>synchronisation.mode</code>:</p>
<ul><li><b>buffered</b> (<code>"constant"</code>): a lost message is sent again, and a buffer as long as the worst
wait makes the delay constant.</li>
<li><b>self-paced</b> (<code>"self-paced"</code>): a step is taken once the sample that it needs is there, and lasts
as long as that took.</li>
<li><b>freshest</b> (<code>"freshest"</code>): use the newest sample that has arrived. Nothing is sent again, and no
index is shared. Passive if the damping covers the largest age: <span class="math">B<sub>i</sub> ≥ ½ Σ<sub>j</sub>
(ā<sub>ij</sub> + ā<sub>ji</sub>) K<sub>ij</sub></span>, which goes beyond the paper.</li></ul>
{results}
{drawn}
{positions}
<p>{passive} of {len(found.ways)} stay passive here (a margin of 0 is the best there is from rest: the hands never had
more out than in) and their ledger balances. They differ in what it costs. A buffer pays for the rarest event, a message
lost several times in a row, at every step: old samples ask for damping, and damping makes the object slow. The newest
sample is never much older than the link’s own delay.</p>
<p>How much depends on what a buffer must cover. Over {len(found.seeds)} seeds of this channel the largest
<span class="math">B<sub>i</sub></span> with a buffer for every sample is {_times(found, "buffered")} as large as with
the freshest sample, and with a buffer for 99 % of them, which leaves the rest without a guarantee,
{_times(found, "buffered 99 %")} (mean and its 95 % interval; least and largest of all seeds in brackets).</p>
<div class="note"><p><b>What each mode was told.</b> “buffered” covers every sample of this run, which no buffer can
know beforehand: an oracle in its favour as to losses, and against it as to damping. “buffered 99 %” is told the 99 %
point; {num(100 * short.late, 2)} % of its samples come too late and it uses an older one, which the theorem does not
cover. “self-paced” covers 99 % and waits for the rest; waits spread through the network, so it takes
{num(paced.pace, 3)} steps a second, and its damping must cover its longest step. “freshest” is given the largest age
of this run, an oracle too; a live peer declares an age and must act when a sample gets older.</p></div>"""
    return Section(anchor="modes", title="A channel with jitter and loss", body=body)


def _times(found: Modes, name: str) -> str:
    saving = found.savings[name]
    low, high = float(saving.each.min()), float(saving.each.max())
    return f"{num(saving.middle, 3)} ± {num(saving.half, 2)} times [{num(low, 3)} to {num(high, 3)}]"


def guarantees(found: Certificates) -> Section:
    """Certificates and what they cover."""
    rows = [
        [
            f"<b>{escape(p.name)}</b>",
            num(float(p.damping.max())),
            num(float(p.damping.sum())),
            num(p.rate, 4),
            quantity(p.least, "J"),
            escape(p.certificate.covers),
        ]
        for p in found.proofs
    ]
    age = found.by_age
    head = [
        "Method",
        "Largest B<sub>i</sub><br>(Ns/m)",
        "Sum<br>(Ns/m)",
        "Slowest mode<br>(1/s)",
        "Least work<br>for each N²s",
        "Covers",
    ]
    rows.append(
        [
            "<b>age rule</b>",
            num(float(age.damping.max())),
            num(float(age.damping.sum())),
            "",
            "",
            escape(age.covers),
        ]
    )
    drawn = figure(
        charts.dampings(found),
        "fig-damping",
        "<b>Damping of each user on the best links</b>, in Ns/m, by method.",
        "Damping of five users by the rule, the minimax weights and the exact test.",
    )
    results = table(head, rows, text=(0, 5))
    body = f"""<p>Three ways to arrive at a damping, for constant indexing delays and steps of {1e3 * found.period:g}
ms, each with the loop that it gives and the least work that the worst hands are left with. What a certificate covers
is as much part of it as its numbers.</p>
{results}
{drawn}
<p>The <b>rule</b> asks each user to pay for its own links. <b>Minimax</b> lets users carry damping for each other
(only the product of a link’s two shares matters), until all carry the same; the largest falls, the sum rises. The
<b>exact</b> test scales the rule down until the port’s Hermitian part just stays positive at all frequencies; it
needs one constant step for everyone. The <b>age rule</b> has the delays as ages and is the one for the freshest
sample.</p>"""
    return Section(anchor="certificates", title="What is certified, and for what", body=body)
