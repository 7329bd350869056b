"""The chapter on the paper's slips."""

from cotouch.pages import Section, figure, num, quantity, table
from cotouch.study import _charts as charts
from cotouch.study._data import names
from cotouch.study._errata import Errata
from cotouch.study._topologies import COARSE_UNIT, TIME_UNIT, Topologies


def corrections(found: Errata, topologies: Topologies) -> Section:
    """Errata with their numbers.

    Args:
        found: the errata.
        topologies: the choice of links.
    """
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
