"""The figures of the report."""

from typing import TYPE_CHECKING

import numpy as np

from cotouch import drawing
from cotouch.arrays import Float
from cotouch.network import Network
from cotouch.simulation import shade_hold
from cotouch.study._bound import Bound
from cotouch.study._certificates import Certificates
from cotouch.study._data import listed
from cotouch.study._errata import Errata
from cotouch.study._experiment import DURATION, RELEASE, Experiment
from cotouch.study._modes import Modes
from cotouch.study._theorem import Theorem
from cotouch.study._topologies import TIME_UNIT, Topologies

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

# The beginning of the runs below the bound, in which the eye still sees how they start to diverge [s].
_EARLY = 8.0

_FAST, _SLOW = drawing.USERS[0], drawing.USERS[1]
_GOOD, _BAD = drawing.USERS[2], drawing.USERS[1]


def chosen(found: Topologies) -> "Figure":
    """Best and worst choice of links by the closed loop, with strengths and delays."""
    figure = drawing.sheet(3.3)
    panels = figure.subplots(1, 2)
    decay = found.rankings["decay"]
    cases = ((found.best, "Best", decay.best), (found.worst, "Worst", decay.worst))
    for panel, (network, word, graph) in zip(panels, cases, strict=True):
        _network(panel, network, labelled=True)
        panel.set_title(f"{word}: slowest mode {_signed(decay.values[graph])} 1/s")
    return figure


def others(found: Topologies) -> "Figure":
    """What the paper's first-order objective takes for best and worst, under both readings."""
    figure = drawing.sheet(1.95)
    panels = figure.subplots(1, 4)
    k = 0
    for convention in ("equation", "matrix"):
        ranking = found.rankings[convention]
        for word, graph in (("best", ranking.best), ("worst", ranking.worst)):
            _network(panels[k], found.network.with_links(found.graphs[graph]), labelled=False)
            tie = word == "worst" and ranking.never > 0
            value = f"1 (one of {ranking.never})" if tie else f"{ranking.values[graph]:.6f}"
            panels[k].set_title(f"{convention.capitalize()}, {word}\n|λ₂| = {value}", fontsize=7.5)
            k += 1
    return figure


def _network(axes: "Axes", network: Network, *, labelled: bool) -> None:
    """In two colours: round trips below and above the middle of all, in orders of magnitude."""
    round_trip = network.delay + network.delay.T
    everywhere = round_trip[network.spring > 0]
    divide = float(np.sqrt(everywhere.min() * everywhere.max()))
    drawing.network(
        axes,
        network.users,
        network.links,
        network.spring,
        network.delay,
        width=drawing.WIDTH / (2 if labelled else 4),
        strongest=float(network.spring.max()),
        color=lambda seconds: _FAST if seconds < divide else _SLOW,
        labelled=labelled,
    )


def ranks(found: Topologies, errata: Errata) -> "Figure":
    """The first-order objective against the closed loop, every graph a dot.

    Args:
        found: objectives of all graphs.
        errata: what is compared.
    """
    figure = drawing.sheet(2.7)
    panels = figure.subplots(1, 2, sharex=True, sharey=True)
    decay = -found.rankings["decay"].values
    for panel, convention in zip(panels, ("equation", "matrix"), strict=True):
        ranking = found.rankings[convention]
        pace = np.where(ranking.values < 1.0, -TIME_UNIT / np.log(np.minimum(ranking.values, 1.0 - 1e-12)), np.inf)
        never = ~(ranking.values < 1.0)
        slowest = float(pace[~never].max())
        shown = np.where(never, 1.6 * slowest, pace)
        panel.set_xscale("log")
        panel.plot(shown[~never], decay[~never], "o", color=drawing.MUTED, markersize=2.6, alpha=0.75)
        if never.any():
            style = {"color": drawing.ALARM_COLOUR, "markersize": 4.0, "label": f"never mix: {int(never.sum())}"}
            panel.plot(shown[never], decay[never], "x", **style)
        for graph, color, word in ((ranking.best, _GOOD, "its best"), (ranking.worst, _BAD, "its worst")):
            if not never[graph]:
                panel.plot(shown[graph], decay[graph], "o", color=color, markersize=5.5, label=word)
        panel.set_title(f"{convention.capitalize()}: rank correlation {errata.spearman[convention]:.2f}")
        panel.set_xlabel("Time constant of the first-order model / s")
        panel.set_xticks([1, 2, 5, 10, 20, 50, 100, 200], labels=["1", "2", "5", "10", "20", "50", "100", "200"])
        panel.set_xticks([], minor=True)
        panel.set_ylim(0.0, 1.3 * float(decay.max()))
        panel.legend(loc="upper left", ncols=3, fontsize=7.0, columnspacing=1.0, handletextpad=0.2)
    panels[0].set_ylabel("Decay of the closed loop / (1/s)")
    return figure


def held_and_released(found: Experiment) -> "Figure":
    """Positions, forces and their sum, best beside worst."""
    figure = drawing.sheet(5.2)
    panels = figure.subplots(3, 2, sharex=True, sharey="row", height_ratios=[1.5, 1.5, 1.0])
    for column, (trial, word) in enumerate(((found.best, "Best"), (found.worst, "Worst"))):
        run, (top, middle, bottom) = trial.run, panels[:, column]
        for panel in (top, middle, bottom):
            shade_hold(panel, run, label=panel is top)
        _positions(top, run, unit=1e-3)
        _each(middle, run["time"].values[:, 1:], run["force"].values[:, 1:, 0])
        total = run["force"].values[:, 1:, 0].sum(axis=0)
        bottom.plot(*drawing.decimate(run["time"].values[0][1:], total), color=drawing.INK)
        for panel, name in ((top, "position"), (middle, "force")):
            settled = trial.settling[name]
            if settled is not None:
                panel.axvline(settled, color=drawing.MUTED, linewidth=0.7, linestyle=(0, (2.0, 2.0)))
                panel.annotate(
                    f"settled {settled:.1f} s",
                    (settled, 0.0),
                    xycoords=("data", "axes fraction"),
                    xytext=(4, 4),
                    textcoords="offset points",
                    color=drawing.MUTED,
                    fontsize=7.0,
                )
        top.set_title(f"{word}: {trial.links}")
        bottom.set(xlabel="Time / s", xlim=(0.0, DURATION))
    panels[0, 0].set_ylabel("Position / mm")
    panels[1, 0].set_ylabel("Force / N")
    panels[2, 0].set_ylabel("Sum of forces / N")
    drawing.figure_legend(figure, [str(name) for name in found.best.run["user"].values])
    return figure


def claims(found: Theorem) -> "Figure":
    """The runs behind Theorem 1, small."""
    figure = drawing.sheet(4.4)
    panels = figure.subplots(2, 3)
    worst, left, balance = panels[0]
    factor, unit = drawing.prefix(drawing.peak(found.attack.run["supplied_total"].values), "J")
    work = found.attack.run["supplied_total"].values / factor
    worst.plot(*drawing.decimate(found.attack.run["tick_time"].values, work), color=drawing.INK)
    worst.axhline(0.0, color=drawing.MUTED, linewidth=0.6)
    worst.set(title="Item 1: the worst hands", ylabel=f"Work of the hands / {unit}")

    for name, label, color in (("free", "K = 0", _FAST), ("grounded", f"K = {found.stiffness:g} N/m", _SLOW)):
        time, offset = found.released[name]["time"].values[0], found.offsets[name]
        left.plot(*drawing.decimate(time, offset), color=color, label=label)
    left.set(yscale="log", title="Item 2: released", ylabel="‖[P + I⊗K/N](x − x_d)‖ / N")
    left.legend(loc="lower left")

    run = found.held
    time = run["time"].values[0]
    force = run["force"].values[:, :, 0].sum(axis=0)
    elastic = found.stiffness * (run["position"].values[:, :, 0, 0].mean(axis=0) - found.rest)
    balance.plot(*drawing.decimate(time[1:], force[1:]), color=_FAST, label="Σf")
    balance.plot(*drawing.decimate(time[1:], elastic[1:]), color=_SLOW, linestyle=(0, (4.0, 2.0)), label="K(x̄ − x_d)")
    balance.set(title="Item 3: held", ylabel="Force / N", xlim=(0.0, 10.0))
    balance.legend(loc="lower right")

    agree, drift, home = panels[1]
    _positions(agree, found.released["free"], unit=1e-3)
    agree.set(title="Case 1: K = 0", ylabel="Position / mm", xlim=(0.0, 6.0))
    agree.axhline(1e3 * found.agreed, color=drawing.MUTED, linewidth=0.7, linestyle=(0, (2.0, 2.0)))
    cases = ((drift, "free", "Case 2: chain, K_ext = 0", 6.0), (home, "grounded", "Case 3: chain, K_ext ≠ 0", 20.0))
    for panel, name, title, span in cases:
        run = found.chains[name]
        rest = found.chain_rest
        for user in range(run.sizes["user"]):
            for node in range(run.sizes["node"]):
                displaced = run["position"].values[user, :, node, 0] - rest[node]
                line = drawing.decimate(run["time"].values[user], 1e3 * displaced)
                panel.plot(*line, **{**drawing.user_line(user), "linewidth": 0.8})
        panel.set(title=title, ylabel="Displacement / mm", xlim=(0.0, span))
    drift.axhline(1e3 * found.translation, color=drawing.MUTED, linewidth=0.7, linestyle=(0, (2.0, 2.0)))
    home.axhline(0.0, color=drawing.MUTED, linewidth=0.7, linestyle=(0, (2.0, 2.0)))
    for panel in panels.flat:
        panel.set_xlabel("Time / s")
    return figure


def thresholds(found: Bound) -> "Figure":
    """The rightmost root over the damping, and the energies of four runs."""
    figure = drawing.sheet(2.9)
    roots, energies = figure.subplots(1, 2)
    for name, color in (("best", _GOOD), ("worst", _BAD)):
        roots.plot(found.scales, found.rates[name], color=color)
        # Where the two curves are apart from each other and from everything else.
        place = int(np.searchsorted(found.scales, 0.1 if name == "best" else 0.45))
        roots.annotate(
            f"{name} links",
            (found.scales[place], found.rates[name][place]),
            xytext=(6, 6),
            textcoords="offset points",
            color=color,
            fontsize=7.5,
        )
    roots.axhline(0.0, color=drawing.MUTED, linewidth=0.8)
    roots.set(
        xscale="log",
        xlabel="Damping, share of the rule",
        ylabel="Rightmost root / (1/s)",
        title="Where the closed loop stands",
    )
    ticks = [0.1, found.critical, 0.3, found.exact]
    roots.set_xticks(ticks, labels=["0.1", f"{found.critical:.2f}", "0.3", f"{found.exact:.2f}"])
    roots.set_xticks([], minor=True)
    low = float(roots.get_ylim()[0])
    for fraction, text in ((found.critical, "unstable\nbelow"), (found.exact, "not passive\nbelow")):
        roots.axvline(fraction, color=drawing.MUTED, linewidth=0.7, linestyle=(0, (2.0, 2.0)))
        roots.annotate(
            text,
            (fraction, low),
            xytext=(-3, 4),
            textcoords="offset points",
            ha="right",
            fontsize=7.0,
            color=drawing.MUTED,
        )
    lines = (
        ("rule", drawing.INK, "the rule"),
        ("alone", _FAST, f"{_percent(found.fractions['alone'])}, nobody holds"),
        ("held", _SLOW, f"{_percent(found.fractions['held'])}, {len(found.held)} hands hold"),
        ("below", drawing.ALARM_COLOUR, f"{_percent(found.fractions['below'])}, nobody holds"),
    )
    for name, color, label in lines:
        run = found.runs[name]
        stored = run["stored"].values
        floor = 1e-16 * float(stored[0])
        energies.plot(*drawing.decimate(run["tick_time"].values, np.maximum(stored, floor)), color=color, label=label)
    energies.set(
        yscale="log",
        xlabel="Time / s",
        ylabel="Stored energy / J",
        title="Energy of copies and links",
        ylim=(1e-13, None),
    )
    energies.legend(loc="upper left", fontsize=7.0)
    return figure


def below(found: Bound) -> "Figure":
    """Positions at the rule, between the thresholds alone and held, and below."""
    figure = drawing.sheet(3.7)
    panels = figure.subplots(2, 2, sharex=True)
    names = (
        ("rule", "The rule"),
        ("alone", f"{_percent(found.fractions['alone'])} of the rule, nobody holds"),
        ("held", f"{_percent(found.fractions['held'])}, users {listed(found.held)} hold still"),
        ("below", f"{_percent(found.fractions['below'])} of the rule, nobody holds"),
    )
    for panel, (name, title) in zip(panels.flat, names, strict=True):
        seen = found.runs[name].isel(step=slice(0, int((found.runs[name]["time"].values[0] <= _EARLY).sum())))
        factor, unit = drawing.prefix(drawing.peak(seen["position"].values), "m")
        _positions(panel, seen, unit=factor)
        panel.set(title=title, ylabel=f"Position / {unit}", xlim=(0.0, _EARLY))
    for panel in panels[1]:
        panel.set_xlabel("Time / s")
    return figure


def attacks(found: Bound) -> "Figure":
    """The worst profile of force below the bound, and what the worst hands get out at four dampings."""
    figure = drawing.sheet(2.7)
    pushes, work = figure.subplots(1, 2)
    worst = found.attacks["rule", 0.5].run
    size = drawing.peak(worst["force"].values)
    _each(pushes, worst["time"].values[:, 1:], worst["force"].values[:, 1:, 0] / size)
    pushes.set(title="Worst forces at half the rule", xlabel="Time / s", ylabel="Force, share of the largest")
    drawing.figure_legend(figure, [str(name) for name in worst["user"].values])
    colors = (drawing.INK, _GOOD, drawing.USERS[4], drawing.ALARM_COLOUR)
    for ((method, fraction), attack), color in zip(found.attacks.items(), colors, strict=True):
        run = attack.run
        got = 100.0 * run["supplied_total"].values / float(run.attrs["energy_in_play"])
        label = f"{method} damping" if fraction == 1.0 else f"{fraction:g} × {method}"
        work.plot(*drawing.decimate(run["tick_time"].values, got), color=color, label=label)
    work.axhline(0.0, color=drawing.MUTED, linewidth=0.8)
    work.set(title="Work of the worst hands", xlabel="Time / s", ylabel="Share of the energy in play / %")
    work.legend(loc="upper right", fontsize=7.0)
    return figure


def ages(found: Modes) -> "Figure":
    """Ages of one direction over time, and how often samples of any direction are older than that."""
    figure = drawing.sheet(2.7)
    over, fraction = figure.subplots(1, 2, width_ratios=[1.25, 1.0])
    for (name, way), color in zip(found.ways.items(), _WAYS, strict=True):
        run = way.run
        index = [str(direction) for direction in run["direction"].values].index(found.direction)
        receiver = int(found.direction.split("<-")[0]) - 1
        time = run["time"].values[receiver]
        seen = time <= 2.0 * RELEASE
        over.plot(
            *drawing.decimate(time[seen], run["age"].values[index][seen], 900), color=color, linewidth=0.9, label=name
        )
        old = np.sort(way.ages)
        rank = 1.0 - np.arange(old.size) / old.size
        pick = np.unique(np.round(old.size * (1.0 - np.geomspace(1.0, 1.0 / old.size, 500))).astype(np.int64))
        pick = pick[pick < old.size]
        fraction.plot(old[pick], rank[pick], color=color, drawstyle="steps-pre")
    over.set(
        yscale="log",
        xlabel="Time / s",
        ylabel="Age / s",
        title=f"One direction: {found.direction.replace('<-', ' ← ')}",
        xlim=(0, DURATION),
        ylim=(0.02, None),
    )
    fraction.set(
        xscale="log",
        yscale="log",
        xlabel="Age / s",
        ylabel="Share of samples that are older",
        title="All directions",
        ylim=(1e-4, 1.2),
    )
    figure.legend(loc="outside upper right", ncols=len(found.ways))
    return figure


def ways(found: Modes) -> "Figure":
    """Positions in every mode."""
    shown = {name: way for name, way in found.ways.items() if way.quantile is None}
    figure = drawing.sheet(2.5)
    panels = figure.subplots(1, len(shown), sharex=True, sharey=True)
    for panel, (name, way) in zip(panels, shown.items(), strict=True):
        shade_hold(panel, way.run)
        _positions(panel, way.run, unit=1e-3)
        panel.set(title=name.capitalize(), xlabel="Time / s", xlim=(0.0, DURATION))
    panels[0].set_ylabel("Position / mm")
    drawing.figure_legend(figure, [str(name) for name in found.ways["freshest"].run["user"].values])
    return figure


_WAYS = (drawing.USERS[1], drawing.USERS[4], drawing.USERS[3], drawing.USERS[0])


def dampings(found: Certificates) -> "Figure":
    """B_i of every user by each method."""
    figure = drawing.sheet(2.0)
    panel = figure.subplots()
    marks = ("o", "s", "D")
    for k, (proof, color) in enumerate(zip(found.proofs, (_SLOW, _FAST, _GOOD), strict=True)):
        users = np.arange(proof.damping.size)
        text = f"{proof.name}: largest {proof.damping.max():.1f}"
        panel.plot(proof.damping, users + 0.18 * (k - 1), marks[k], color=color, markersize=5.0, label=text)
    names = [f"user {i + 1}" for i in range(found.proofs[0].damping.size)]
    panel.set_yticks(range(len(names)), labels=names)
    panel.invert_yaxis()
    panel.set_xlim(0.0, 1.05 * max(float(proof.damping.max()) for proof in found.proofs))
    panel.grid(visible=False, axis="y")
    panel.set_xlabel("Damping B_i / (Ns/m)")
    panel.legend(loc="lower right", bbox_to_anchor=(1.0, 1.02), ncols=3)
    return figure


def consensus(found: Errata) -> "Figure":
    """The first-order model on a graph that mixes and on one that never does."""
    figure = drawing.sheet(2.2)
    panels = figure.subplots(1, 2, sharex=True, sharey=True)
    titles = {"best": "Best graph: everyone agrees", "echo": f"{found.echo[0]}: echoes of period {found.echo[1]}"}
    for panel, (name, states) in zip(panels, found.consensus.items(), strict=True):
        time = (np.arange(int(states.shape[0])) * TIME_UNIT).astype(np.float64)
        for user in range(states.shape[1]):
            line = {**drawing.user_line(user), "linewidth": 0.7}
            panel.plot(*drawing.decimate(time, states[:, user], 1000), **line)
        panel.set(title=titles[name], xlabel="Time / s", xlim=(0.0, float(time[-1])))
    panels[0].set_ylabel("State p_i")
    return figure


def _positions(axes: "Axes", run: "xr.Dataset", *, unit: float) -> None:
    _each(axes, run["time"].values, run["position"].values[:, :, 0, 0] / unit, 700)


def _each(axes: "Axes", times: Float, values: Float, *points: int) -> None:
    """A line for each user, of a row of times and one of values."""
    for user, (time, line) in enumerate(zip(times, values, strict=True)):
        axes.plot(*drawing.decimate(time, line, *points), **drawing.user_line(user))


def _signed(value: float) -> str:
    return f"{value:.4f}".replace("-", "−")


def _percent(fraction: float) -> str:
    return f"{100.0 * fraction:.0f} %"
