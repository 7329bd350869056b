"""The chapters of the report: numbers and figures into words."""

from collections.abc import Sequence
from html import escape

import numpy as np
import numpy.typing as npt

from cotouch.network import Network
from cotouch.study import _charts as charts
from cotouch.study._bound import Bound
from cotouch.study._certificates import Certificates
from cotouch.study._data import names
from cotouch.study._errata import Errata
from cotouch.study._experiment import PERIOD, RELEASE, Experiment, Trial
from cotouch.study._modes import JITTER, LOSS, Modes
from cotouch.study._page import Section, figure, formula, num, quantity, table, verdict
from cotouch.study._theorem import Theorem
from cotouch.study._topologies import COARSE_UNIT, LINKS, TIME_UNIT, Topologies

Float = npt.NDArray[np.float64]

PAPER = (
    "D. Lee and K. Huang, “Peer-to-Peer Control Architecture for Multiuser Haptic Collaboration over Undirected "
    "Delayed "
    "Packet-Switching Network”, 2010"
)

_WARNING = (
    '<p class="note no">Not everything came out as it should: look for ✗ in the tables and for thresholds out of '
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
    """What stands above the first chapter."""
    held = sum(claim.holds for claim in theorem.claims)
    freshest, buffered = modes.ways["freshest"].damping.max(), modes.ways["buffered"].damping.max()
    best, worst = trials.best.settling["agreement"], trials.worst.settling["agreement"]

    def keep(text: str) -> str:
        return text.replace(" ", "&nbsp;")

    cards = (
        (f"{len(found.graphs)} of {found.choices}", "choices of six links connect everyone; each was looked at"),
        (f"{num(best, 2)} or {num(worst, 3)} s", "until the five agree after letting go: best links, worst links"),
        (f"{held} of {len(theorem.claims)}", "claims of Theorem 1 and after it hold as measured"),
        (
            f"{num(buffered / freshest, 2)} × less",
            "damping with the freshest sample than with a buffer, on one bad channel",
        ),
        (
            f"{num(100 * below.exact, 2)} % and {num(100 * below.critical, 2)} %",
            "of the rule’s damping: below, hands can get energy out; below, copies diverge by themselves",
        ),
        (num(residual, 2), "is the most that the energy books of any run here miss, of the energy in play"),
    )
    boxes = "".join(f"<div><b>{keep(value)}</b><span>{text}</span></div>" for value, text in cards)
    return f"""<p class="kicker">The paper, repeated and tested</p>
<h1>Five users hold one object over a slow network</h1>
<p class="lede">Each user simulates a copy of the same object. Springs over a delayed network pull the copies
together, and damping at each copy pays for the delay. Lee and Huang showed in 2010 how much damping is enough for
<em>any</em> passive hands and devices, and which links to choose when only some can be had. This report repeats their
experiment, puts a measured number beside each claim, goes below the bound to see what breaks, and says where the
printed text is wrong.</p>
<p>Every number is computed by the run that wrote this page; only what is marked <em>expected</em> was known
before.</p>
{"" if confirmed else _WARNING}
<div class="cards">{boxes}</div>"""


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


def choice(found: Topologies) -> Section:
    """The data, the choice of links, and the reference values."""
    best, worst = found.best, found.worst
    reference = table(
        ["Objective", "Expected links", "Found links", "Expected", "Found", "Agree to 10<sup>−5</sup>"],
        [
            [
                escape(r.text),
                escape(r.expected[0]),
                escape(r.found[0]),
                _six(r.expected[1]),
                _six(r.found[1]),
                verdict(holds=r.agrees, yes="yes", no="no"),
            ]
            for r in found.references
        ],
        text=(0, 1, 2, 5),
    )
    decay = found.rankings["decay"]
    ratio = decay.values[decay.best] / decay.values[decay.worst]
    drawn = figure(
        charts.chosen(found),
        "fig-links",
        "<b>Best and worst choice of six links by the closed loop.</b> Bold: spring in N/m, also the width of "
        "the link. Small, at an "
        "end: delay in ms of what arrives there. Blue links answer within 0.2 s, orange ones take 1.6 s or more "
        "there and back.",
        f"Two drawings of five users on a circle. Best links {_in_words(best)}; worst links {_in_words(worst)}.",
    )
    small = figure(
        charts.others(found),
        "fig-others",
        "<b>The first-order objective’s choices under both readings of the paper</b> (delays in units of "
        f"{TIME_UNIT:g} s). Its equation and its printed matrix differ by one step, which decides what is “best” "
        "and “worst”.",
        "Four small drawings: best and worst links by the first-order model, for the equation and for the matrix.",
    )
    body = f"""<p>The data are two matrices: springs that may join two users, and the delay from one to the other. With
{len(found.network.links)} possible links, {LINKS} of which are allowed, there are {found.choices} choices;
{len(found.graphs)} connect everyone.</p>
<div class="pair"><div><h3>Spring in N/m</h3>{_matrix(found.network.spring)}</div>
<div><h3>Delay in s, to the row from the column</h3>{_matrix(found.network.delay)}</div></div>
<p>The paper ranks them by how fast a first-order model mixes: each user replaces its state by the spring-weighted
mean of what it hears, and the second largest eigenvalue |λ₂| of that recursion, lifted over the delays, says how much
remains after each time unit. The copies themselves are of second order, so their own slowest mode is the better
judge: the rightmost root other than zero of</p>
<p class="display"><span class="math">det[(s² m/N + s B<sub>i</sub> + Σ<sub>j</sub> K<sub>ij</sub>) I − K<sub>ij</sub>
e<sup>−s d<sub>ij</sub></sup>] = 0</span>, &emsp; <span class="math">m</span> = 1 kg, object without damper or spring,
damping by the rule.</p>
<p>Between the best and the worst choice the closed loop’s slowest mode differs by a factor of
{num(float(ratio), 2)}.</p>
{drawn}
<h3>Against known values</h3>
{reference}
{small}
<div class="note"><p>The page of the paper that shows its Fig. 4, the drawings of its best and worst network, is not
part of the text that this work is made from. Which of the choices above it shows cannot be confirmed; the equation’s
best is also the closed loop’s best, whatever the figure has.</p></div>"""
    return Section(anchor="links", title="Which links to choose", body=body)


def _six(value: float) -> str:
    return f"{value:.6f}".replace("-", "−")


def _in_words(network: Network) -> str:
    """Links in words, for descriptions."""
    return ", ".join(f"{a + 1} to {b + 1}" for a, b in network.links)


def _matrix(values: Float) -> str:
    rows = [
        [str(i + 1), *(f"{value:g}" if i != j else '<span class="nil">–</span>' for j, value in enumerate(row))]
        for i, row in enumerate(values)
    ]
    return table(["user", *(str(j + 1) for j in range(len(values)))], rows, kind="matrix")


def trials(found: Experiment) -> Section:
    """Positions and forces while held and after the release."""
    columns = (found.best, found.worst, found.misjudged)

    def settled(name: str) -> list[str]:
        return [quantity(t.settling[name], "s") if t.settling[name] is not None else "not settled" for t in columns]

    results = table(
        ["", "Best", "Worst", "The matrix’s worst"],
        [
            ["Links", *(trial.links for trial in columns)],
            ["Position settled while held", *settled("position")],
            ["Force settled while held", *settled("force")],
            ["|Σf| at the end of the hold", *(quantity(trial.force_sum, "N", 2) for trial in columns)],
            ["Agreed after the release", *settled("agreement")],
            ["Largest B<sub>i</sub> of the rule", *(quantity(max(trial.damping), "Ns/m") for trial in columns)],
            ["Slowest mode: root of the closed loop", *(quantity(trial.predicted.real, "1/s", 6) for trial in columns)],
            [
                "Slowest mode: read from a simulated decay",
                *(quantity(trial.measured.real, "1/s", 6) for trial in columns),
            ],
        ],
    )
    drawn = figure(
        charts.held_and_released(found),
        "fig-held",
        "<b>The paper’s Figs. 5 and 6, repeated.</b> Shaded: all five hold. Dashed: settled to 2 % of the "
        "largest excursion.",
        "Positions, forces and sum of forces of five users over forty seconds, with the best and with the worst "
        "links. The "
        "best settle within three seconds, the worst take about seven.",
    )
    misjudged = found.misjudged
    body = f"""<p>As in the paper the object has mass only (<var>B</var> = <var>K</var> = 0). Five hands, springs of 60
N/m with 2 Ns/m, pull towards five different places, hold, and let go at {RELEASE:g} s. Places, hands and the step of
{1e3 * PERIOD:g} ms are not printed in the paper and are chosen here; network, object and damping rule are the
paper’s.</p>
{drawn}
<p>While held, everyone feels the others: the forces settle at different values whose sum vanishes. After the release
the copies agree on a common place. Both happen sooner with the better links.</p>
{results}
<p>The last two rows check the choice of links against the simulator, which knows nothing of roots: from a free decay
of the copies, linear prediction reads off the slowest mode. It is the closed loop’s rightmost root to
{_digits(found.best)} digits with the best links.</p>
<p>The choice that the printed matrix calls worst, {misjudged.links}, is nothing of the kind: it agrees after
{quantity(misjudged.settling["agreement"], "s")}. Its first-order model almost echoes (see the
<a href="#errata">errata</a>); the real copies, with mass and damping, do not.</p>"""
    return Section(anchor="experiment", title="The experiment: hold and let go", body=body)


def _digits(trial: Trial) -> int:
    """Decimal digits to which a simulated rate is the predicted one."""
    gap = abs(trial.measured.real - trial.predicted.real) / abs(trial.predicted.real)
    return int(np.clip(np.floor(-np.log10(max(gap, 1e-12))), 0, 12))


def proofs(found: Theorem, links: str) -> Section:
    """Theorem 1: claim, number, verdict."""
    rows = [
        [
            claim.item,
            formula(claim.text),
            quantity(claim.measured, claim.unit),
            f"{claim.sign} {quantity(claim.limit, claim.unit, 1)}",
            verdict(holds=claim.holds),
        ]
        for claim in found.claims
    ]
    drawn = figure(
        charts.claims(found),
        "fig-claims",
        "<b>The runs behind the table.</b> Dashed in the lower row: where all copies end up, "
        f"{quantity(1e3 * found.agreed, 'mm')} for the "
        f"free object and {quantity(1e3 * found.translation, 'mm')} for the free chain, which nothing but the "
        "start decides, and "
        "x<sub>d</sub> for the grounded chain.",
        "Six small graphs: work of the worst hands, decay of equation 5, balance of forces, and positions in the "
        "three cases.",
    )
    errors = ", ".join(
        f"{num(100 * error, 2)} % with links {factor:g} times as stiff"
        if factor > 1
        else f"{num(100 * error, 2)} % as they are"
        for factor, error in zip(found.stiffer, found.single, strict=True)
    )
    body = f"""<p>Each claim of the theorem, the three cases after it and its consequences, measured on the links
{links}. “Item” is where the paper says it.</p>
{table(["Item", "Claim", "Measured", "Must be", "Verdict"], rows, text=(0, 1, 4))}
{drawn}
<h3>How item 1 is tested</h3>
<p>That some hands got no energy out says little: other hands might. So the hands are made as bad as they can be. From
rest the copies answer linearly, so the work of all hands is a quadratic form in the forces. For every user, a force
profile of {found.attack.profiles // len(found.attack.run["user"])} corners one second apart makes a family of
{found.attack.profiles} dimensions; the smallest eigenvalue of its work is the best that <em>any</em> profile in the
family can do. It is {quantity(found.attack.least, "J")}, above zero, and playing the profile gives the same work to
{_agreement(found)} digits. <a href="#bound">Below the bound</a> the same search succeeds.</p>
<h3>What “perfect synchronisation” asks for</h3>
<p>That a single user feels <span class="math">K(x − x<sub>d</sub>)</span> holds as far as the other copies follow.
With K = {found.stiffness:g} N/m, which is as stiff as the links themselves, they follow badly: the force is off by
{errors}. The error falls in proportion, as it must. What holds for any links is (6): the force is
<span class="math">K(x̄ − x<sub>d</sub>)</span>, of the <em>average</em> copy.</p>"""
    return Section(anchor="theorem", title="Theorem 1, claim by claim", body=body)


def _agreement(found: Theorem) -> int:
    gap = abs(found.attack.worked - found.attack.least) / abs(found.attack.least)
    return int(np.clip(np.floor(-np.log10(max(gap, 1e-15))), 0, 15))


def edge(found: Bound) -> Section:
    """Below the damping bound."""
    thresholds = figure(
        charts.thresholds(found),
        "fig-bound",
        "<b>Left: rightmost root of the free closed loop as all damping is scaled.</b> <b>Right: energy of four "
        "runs</b> of the best links.",
        "Left, rate of the slowest mode against damping for best and worst links; right, energy over time in "
        "four runs.",
    )
    positions = figure(
        charts.below(found),
        "fig-below",
        "<b>The same four runs.</b> The scale of each graph is its own.",
        "Positions of five users: settled at the rule, settled at a fifth of it alone, diverging when held, "
        "diverging below.",
    )
    attack = figure(
        charts.attacks(found),
        "fig-attack",
        "<b>The worst hands.</b> Work that ends below zero is energy got out of nothing. “exact” is the damping "
        "of the exact test.",
        "Left, the five force profiles that get most energy out; right, the work of the worst hands at four dampings.",
    )
    cases = {
        "rule": "the rule, nobody holds",
        "alone": f"{100 * found.shares['alone']:.1f} % of the rule, nobody holds",
        "held": f"{100 * found.shares['held']:.1f} % of the rule, users {_list(found.held)} hold still",
        "below": f"{100 * found.shares['below']:.1f} % of the rule, nobody holds",
    }
    growth = table(
        ["Run", "Rate of the amplitude", "Outcome"],
        [
            [cases[name], quantity(rate, "1/s"), "comes to rest" if rate < 0 else "diverges"]
            for name, rate in found.growth.items()
        ],
        text=(0, 2),
    )
    least = table(
        [
            "Damping",
            "Share of the rule",
            "Least work of any hands for each N²s",
            "Energy that the worst hands get back",
        ],
        [
            [
                escape(method if share == 1.0 else f"{share:g} × {method}"),
                num(share if method == "rule" else share * found.exact, 3),
                quantity(a.least, "J"),
                f"{num(100 * a.returned, 2)} % of what is in play" if a.returned > 0 else "none",
            ]
            for (method, share), a in found.attacks.items()
        ],
        text=(0, 3),
    )
    body = f"""<p>The rule is sufficient. What happens with less depends on who holds, and three things fail one after
the other as all <span class="math">B<sub>i</sub></span> are scaled down on the best links:</p>
<ol><li>Below <b>{num(found.exact, 3)}</b> of the rule the users are no longer passive: some hands can get energy out.
This is the exact test’s threshold; on networks without cycles of odd length it is 1, and the rule cannot be
bettered.</li>
<li>Near <b>{num(found.shares["held"], 2)}</b> the copies still come to rest by themselves, but not in the hands of
{len(found.held)} users who do nothing but hold still, with springs of {found.hand:g} N/m.</li>
<li>Below <b>{num(found.critical, 4)}</b> they diverge without any help, swinging at {num(found.frequency, 3)} rad/s:
the rightmost root has crossed the axis.</li></ol>
{thresholds}
{positions}
{growth}
<p>Below the critical scale the rightmost root predicts {quantity(found.predicted, "1/s")}; the run grows by
{quantity(found.growth["below"], "1/s")}. The second step is why passivity, not stability, is the aim: the designer of
the network does not know the hands. The passive springs of three users are enough to turn a loop that is stable by a
good margin into one that is not.</p>
<h3>Hands that get energy out of nothing</h3>
<p>The search for the worst hands of the <a href="#theorem">previous chapter</a>, at four dampings. It finds nothing
at the rule and at the exact test’s damping, and finds energy as soon as the damping is 10 % below that: the exact
test is exact.</p>
{least}
{attack}"""
    return Section(anchor="bound", title="Below the bound", body=body)


def _list(numbers: Sequence[int]) -> str:
    words = [str(number) for number in numbers]
    return f"{', '.join(words[:-1])} and {words[-1]}" if len(words) > 1 else words[0]


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
        f"{quantity(found.delay, 's')}. "
        "Right: all directions; the steps are the links’ own delays. The buffered modes make every sample as old "
        "as the oldest.",
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
more out than in) and their books balance. They differ in what it costs. A buffer pays for the rarest event, a message
lost several times in a row, at every step: old samples ask for damping, and damping makes the object slow. The newest
sample is never much older than the link’s own delay.</p>
<div class="note"><p><b>What each mode was told.</b> “buffered” covers every sample of this run, which no buffer can
know beforehand: an oracle in its favour as to losses, and against it as to damping. “buffered 99 %” is told the 99 %
point; {num(100 * short.late, 2)} % of its samples come too late and it uses an older one, which the theorem does not
cover. “self-paced” covers 99 % and waits for the rest; waits spread through the network, so it takes
{num(paced.pace, 3)} steps a second, and its damping must cover its longest step. “freshest” is given the largest age
of this run, an oracle too; a live peer declares an age and must act when a sample gets older.</p></div>"""
    return Section(anchor="modes", title="A channel with jitter and loss", body=body)


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


def corrections(found: Errata, topologies: Topologies) -> Section:
    """Errata with their numbers."""
    equation, matrix = (topologies.rankings[name] for name in ("equation", "matrix"))
    echo = figure(
        charts.consensus(found),
        "fig-echo",
        f"<b>The first-order model, as printed.</b> On the right all cycles last a multiple of {found.echo[1]} "
        "time units, so what was different stays different.",
        "States of five users over thirty seconds: on the best graph they agree; on a periodic graph they keep "
        "oscillating.",
    )
    ranks = figure(
        charts.ranks(topologies, found),
        "fig-ranks",
        f"<b>All {len(topologies.graphs)} choices of links.</b> If the first-order model were adequate, the dots "
        "would lie on a falling curve.",
        "Two scatter plots of the closed loop's decay against the first-order time constant; the dots hardly "
        "follow a line.",
    )
    work = table(
        ["T", "Σ T v̂ᵀf", "Σ v̂ᵀf, as printed"],
        [
            [quantity(1e3 * T, "ms"), quantity(true, "J", 4), num(printed, 4)]
            for T, (true, printed) in found.work.items()
        ],
    )
    counts = table(
        ["Never mixing", f"time unit {TIME_UNIT:g} s", f"time unit {COARSE_UNIT:g} s"],
        [[name, *map(str, found.periodic[name])] for name in ("equation", "matrix")],
    )
    total = len(topologies.graphs)
    body = f"""<p>Small slips in a good paper; each changes a number that a reader may rely on.</p>
<h3>Equation and matrix differ by one step</h3>
<p>In the printed <var>J</var> the block <span class="math">A<sub>k</sub></span> that belongs to delay <var>k</var>
multiplies <span class="math">p(k − N<sub>ij</sub>)</span>; the printed equation has <span class="math">p(k + 1 −
N<sub>ij</sub>)</span>. For the best links |λ₂| is {num(found.one_graph["equation"], 6)} by the equation and
{num(found.one_graph["matrix"], 6)} by the matrix, and the two name different winners:
{names(topologies.graphs[equation.best])} and {names(topologies.graphs[matrix.best])}.</p>
<h3>“All other eigenvalues are strictly within the unit circle”</h3>
<p>Not on every connected graph. The recursion is a Markov chain; where the total delays of all its cycles share a
divisor it is periodic and never mixes, |λ₂| = 1 exactly. It depends on the time unit which graphs do:</p>
{counts}
<p>So the unit decides the “worst” graph. An example is {found.echo[0]}: after half a minute its states still swing by
{num(100 * found.spreads["echo"], 2)} % of what they did in the first second, and do so forever; on the best graph
{num(100 * found.spreads["best"], 2)} % are left.</p>
{echo}
<h3>“This assumption appears to be a reasonable one”</h3>
<p>The first-order model is said to capture the second-order copies adequately. Over all {total} choices the rank
correlation (Spearman) of its objective with the closed loop’s slowest mode is {num(found.spearman["equation"], 2)}
for the equation and {num(found.spearman["matrix"], 2)} for the matrix. The equation’s best is right: place
{found.places["equation"][0]} of {total}. The matrix’s “worst” is the {found.places["matrix"][1]}th best, and its best
has place {found.places["matrix"][0]}.</p>
{ranks}
<h3>A missing T<sub>i</sub></h3>
<p>The two-port inequality of the device coupling is printed as <span class="math">∫ τᵀv dt + Σ τ<sub>i</sub>ᵀ
v̂<sub>i</sub> ≤ d²</span>. The second term lacks the step <span class="math">T<sub>i</sub></span>, without which it
is no energy, and its <span class="math">v̂<sub>i</sub></span> should be the proxy’s
<span class="math">ŵ<sub>i</sub></span>. The same pull of one hand for two seconds, in steps of three lengths:</p>
{work}
<p>With <var>T</var> the sum is the work and does not depend on the step; without it, it doubles whenever the step is
halved.</p>"""
    return Section(anchor="errata", title="Errata", body=body)
