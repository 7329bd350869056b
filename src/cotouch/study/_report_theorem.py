"""The chapters on Theorem 1 and on what happens below its bound."""

from html import escape

from cotouch.pages import Section, figure, formula, num, quantity, table, verdict
from cotouch.study import _charts as charts
from cotouch.study._bound import Bound
from cotouch.study._data import digits, listed
from cotouch.study._theorem import Theorem


def proofs(found: Theorem, links: str) -> Section:
    """Theorem 1: claim, number, verdict.

    Args:
        found: what was checked.
        links: the links of that network, as the report names them.
    """
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
    agree = digits(found.attack.worked, found.attack.least, 15)
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
{agree} digits. <a href="#bound">Below the bound</a> the same search succeeds.</p>
<h3>What “perfect synchronisation” asks for</h3>
<p>That a single user feels <span class="math">K(x − x<sub>d</sub>)</span> holds as far as the other copies follow.
With K = {found.stiffness:g} N/m, which is as stiff as the links themselves, they follow badly: the force is off by
{errors}. The error falls in proportion, as it must. What holds for any links is (6): the force is
<span class="math">K(x̄ − x<sub>d</sub>)</span>, of the <em>average</em> copy.</p>"""
    return Section(anchor="theorem", title="Theorem 1, claim by claim", body=body)


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
        "alone": f"{100 * found.fractions['alone']:.1f} % of the rule, nobody holds",
        "held": f"{100 * found.fractions['held']:.1f} % of the rule, users {listed(found.held)} hold still",
        "below": f"{100 * found.fractions['below']:.1f} % of the rule, nobody holds",
    }
    growth = table(
        ["Run", "Rightmost root", "Rate read from the run", "Outcome"],
        [
            [
                cases[name],
                quantity(found.roots[name], "1/s", 4) if name in found.roots else "–",
                quantity(rate, "1/s", 4),
                "comes to rest" if rate < 0 else "diverges",
            ]
            for name, rate in found.growth.items()
        ],
        text=(0, 3),
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
                escape(method if fraction == 1.0 else f"{fraction:g} × {method}"),
                num(fraction if method == "rule" else fraction * found.exact, 3),
                quantity(a.least, "J"),
                f"{num(100 * a.returned, 2)} % of what is in play" if a.returned > 0 else "none",
            ]
            for (method, fraction), a in found.attacks.items()
        ],
        text=(0, 3),
    )
    body = f"""<p>The rule is sufficient. What happens with less depends on who holds, and three things fail one after
the other as all <span class="math">B<sub>i</sub></span> are scaled down on the best links:</p>
<ol><li>Below <b>{num(found.exact, 3)}</b> of the rule the users are no longer passive: some hands can get energy out.
This is the exact test’s threshold; on networks without cycles of odd length it is 1, and the rule cannot be
bettered.</li>
<li>Near <b>{num(found.fractions["held"], 2)}</b> the copies still come to rest by themselves, but not in the hands of
{len(found.held)} users who do nothing but hold still, with springs of {found.hand:g} N/m.</li>
<li>Below <b>{num(found.critical, 4)}</b> they diverge without any help, swinging at {num(found.frequency, 3)} rad/s:
the rightmost root has crossed the axis.</li></ol>
{thresholds}
{positions}
{growth}
<p>Roots are of the free loop, so there is none for the run that hands hold. The second step is why passivity, not
stability, is the aim: the designer of the network does not know the hands. The passive springs of three users are
enough to turn a loop that is stable by a good margin into one that is not.</p>
<h3>Hands that get energy out of nothing</h3>
<p>The search for the worst hands of the <a href="#theorem">previous chapter</a>, at four dampings. It finds nothing
at the rule and at the exact test’s damping, and finds energy as soon as the damping is 10 % below that: the exact
test is exact.</p>
{least}
{attack}"""
    return Section(anchor="bound", title="Below the bound", body=body)
