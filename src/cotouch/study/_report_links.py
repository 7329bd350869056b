"""The chapters on which links to choose, and on the experiment with them."""

from html import escape

from cotouch.arrays import Float
from cotouch.network import Network
from cotouch.pages import Section, figure, num, quantity, table, verdict
from cotouch.study import _charts as charts
from cotouch.study._data import digits
from cotouch.study._experiment import PERIOD, RELEASE, Experiment
from cotouch.study._topologies import LINKS, TIME_UNIT, Topologies


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
        "<b>What the paper’s Figs. 5 and 6 show, with hands chosen here:</b> the paper does not print its own, so "
        "curves cannot be compared, only what they have in common. Shaded: all five hold. Dashed: settled to 2 % of "
        "the largest excursion.",
        "Positions, forces and sum of forces of five users over forty seconds, with the best and with the worst "
        "links. The "
        "best links settle sooner.",
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
{digits(found.best.measured.real, found.best.predicted.real, 12)} digits with the best links.</p>
<p>The choice that the printed matrix calls worst, {misjudged.links}, is nothing of the kind: it agrees after
{quantity(misjudged.settling["agreement"], "s")}. Its first-order model almost echoes (see the
<a href="#errata">errata</a>); the real copies, with mass and damping, do not.</p>"""
    return Section(anchor="experiment", title="The experiment: hold and let go", body=body)
