"""A comparison of link laws as one HTML page."""

import json
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from cotouch.device import NOTICED
from cotouch.drawing import style
from cotouch.files import write
from cotouch.laboratory._compare_figures import fronts, maps
from cotouch.laboratory._noticed import able, broken, chosen, is_dangerous, losing, mean_cost, multiples, ours
from cotouch.laboratory._study import Study
from cotouch.pages import Section, figure, num, page, table, verdict

if TYPE_CHECKING:
    import xarray as xr

# Cells are darker from these multiples of what people notice on.
_STEPS = (1.0, 3.0, 10.0, 30.0)
_MOST_LOSSES = 25
# Measures of what arrives and what it takes, and their scale in the report.
_QUALITY = {"psnr": 1.0, "hpw_psnr": 1.0, "late": 1e3, "off": 1e3, "packets": 1.0, "bandwidth": 1e-3}
_FELT = {"drag": "Ns/m", "mass": "kg", "stiffness": "N/m"}
_LINKED = {
    "complete": "every user is linked with every other",
    "path": "users are linked in a row",
    "ring": "users are linked in a ring",
    "star": "all users are linked with the first",
}


def write_report(data: "xr.Dataset", path: Path) -> Path:
    """Writes the report of a comparison.

    Args:
        data: of `compare`.
        path: of the page.

    Raises:
        OutputError: it cannot be written.
    """
    study = Study.make(**json.loads(data.attrs["study"]))
    with style():
        sections = [_losses(data, study), *_costs(data, study), _details(data, study)]
        if "map_cost" in data:
            sections.append(_maps(data))
        sections += [*_fronts(data, study), _price(data, study), _method(data, study)]
    footer = f"cotouch {escape(data.attrs['version'])}. All numbers are in results.nc beside this page."
    html = page(title=study.title, lead=_lead(data, study), sections=sections, footer=footer)
    write(path, html.encode("utf-8"), "report")
    return path


def _lead(data: "xr.Dataset", study: Study) -> str:
    costs = mean_cost(data)
    own = ours(data, study)
    places = [
        (network, users) for network in data["network"].values.tolist() for users in data["users"].values.tolist()
    ]
    passive, liars = able(data), list(broken(data))
    won = (
        sum(min(passive, key=lambda law: _sure(costs[law, network, users][0])) == own for network, users in places)
        if own in passive
        else 0
    )
    risky = [
        law
        for law in data["law"].values.tolist()
        if any(is_dangerous(data, law, *place, hand=h) for place in places for h in range(data.sizes["hand"]))
    ]
    runs = int(np.isfinite(data["cost"].values).sum())
    cards = (
        (escape(own), "law whose losing cases come first"),
        (f"{won} of {len(places)}", "networks and numbers of users for which it costs least of all passive laws"),
        (f"{runs:,}".replace(",", "&nbsp;"), "runs that count"),
        (str(len(risky) or "none"), f"laws that are dangerous in some case{_list(risky)}"),
        (str(len(liars) or "none"), f"laws that promise passivity and made energy{_list(liars)}"),
        (f"{data.sizes['draw']}", "draws of each task and channel; intervals are 95 % over them"),
    )
    boxes = "".join(f"<div><b>{value}</b><span>{text}</span></div>" for value, text in cards)
    return f"""<p class="kicker">Link laws, side by side</p>
<h1>{escape(study.title)}</h1>
<p class="lede">Users in different places hold one object; a law on each link keeps their copies together. Here every
law is tuned by the same search, meets the same networks, tasks and hands, and is measured against one copy that all
hands hold without any delay.</p>
<p>The cost is <span class="math">position error / 10 mm + force error / ideal force</span>, the mean over
{data.sizes["task"]} tasks. The darker a cell, the more people notice; {_legend()}.</p>
<div class="cards">{boxes}</div>"""


def _list(names: list[str]) -> str:
    return f": {escape(', '.join(names))}" if names else ""


def _sure(value: float) -> float:
    return value if np.isfinite(value) else float("inf")


def _legend() -> str:
    parts = [
        f'<span class="level l{k}">{name}</span>'
        for k, name in enumerate(("&lt; 1×", "1–3×", "3–10×", "10–30×", "&gt; 30×"))
    ]
    return f'{" ".join(parts)} what is noticed, <span class="level danger">dangerous</span>'


def _level(multiple: float) -> str:
    return f"l{sum(multiple >= step for step in _STEPS)}"


def _marked(value: float, multiple: float) -> str:
    """A number, and how many times what is noticed."""
    if np.isnan(value):
        return '<span class="nil">–</span>'
    return f'<span class="level {_level(multiple)}">{num(value)}</span> <small>{num(multiple, 2)}×</small>'


def _losses(data: "xr.Dataset", study: Study) -> Section:
    own, found = ours(data, study), losing(data, study)
    if not found:
        body = (
            f"<p>On no network, task or hand of this study does another law cost less than <b>{escape(own)}</b>, "
            "draw by draw, at 95 %.</p>"
        )
    else:
        rows = [
            [
                escape(entry["network"]),
                str(entry["users"]),
                escape(entry["task"]),
                escape(entry["hand"]),
                num(entry["cost"]),
                escape(entry["rival"]),
                num(entry["best"]),
                f"{num(entry['cost'] / max(entry['best'], 1e-12), 2)} ×",
            ]
            for entry in found[:_MOST_LOSSES]
        ]
        more = f" The worst {_MOST_LOSSES} of {len(found)}:" if len(found) > _MOST_LOSSES else ""
        body = (
            f"<p>Cases in which a law that is not dangerous there costs less than <b>{escape(own)}</b>, draw by draw, "
            f"at 95 %.{more}</p>"
            + table(
                ["network", "users", "task", "hand", f"cost of {escape(own)}", "better", "its cost", "ratio"],
                rows,
                text=(0, 2, 3, 5),
            )
        )
    return Section(anchor="losing", title=f"Where {own} loses", body=body)


def _costs(data: "xr.Dataset", study: Study) -> list[Section]:
    costs, stiff = mean_cost(data), mean_cost(data, hand=data.sizes["hand"] - 1)
    networks, laws = data["network"].values.tolist(), data["law"].values.tolist()
    held = {n.name for n in study.networks if n.tuned_on not in {None, n.name}}
    head = ["law", *(escape(n) + ("<br><small>held out</small>" if n in held else "") for n in networks)]
    sections: list[Section] = []
    for users in data["users"].values.tolist():
        rows: list[list[str]] = []
        for law in laws:
            cells = [
                f"{escape(law)}{'' if float(data['promises'].sel(law=law)) else '<br><small>promises nothing</small>'}"
            ]
            for network in networks:
                value, half = costs[law, network, users]
                if np.isnan(value):
                    cells.append('<span class="nil">none found</span>')
                    continue
                if is_dangerous(data, law, network, users):
                    cells.append(f'<span class="level danger">dangerous</span><br><small>{num(value, 2)}</small>')
                    continue
                worst = max(
                    v for name, v in multiples(data, study, law, network, users).items() if name in {"place", "force"}
                )
                hard = stiff[law, network, users][0]
                risky = is_dangerous(data, law, network, users, hand=data.sizes["hand"] - 1)
                more = '<span class="no">dangerous</span>' if risky else num(hard, 2)
                loose = float(data["loose"].sel(law=law, network=network, users=users, tuning=chosen(data))) == 1.0
                let_go = '<br><small class="no">grows let go</small>' if loose else ""
                cells.append(
                    f'<span class="level {_level(worst)}">{num(value)} ± {num(half, 1)}</span>'
                    f"<br><small>{num(worst, 2)} × · stiff {more}</small>{let_go}"
                )
            rows.append(cells)
        sections.append(
            Section(
                anchor=f"cost-{users}",
                title=f"Cost with {users} users",
                body=f"<p>Cost with its 95 % interval; below it the larger of the errors of position and force, in "
                f"multiples of what is noticed, and cost with hands {study.stiffer:g} times stiffer.</p>"
                + table(head, rows, kind="dense"),
            )
        )
    return sections


def _details(data: "xr.Dataset", study: Study) -> Section:
    users = int(data["users"].values[0])
    here = data.sel(tuning=chosen(data), users=users)
    parts: list[str] = []
    for network in data["network"].values.tolist():
        rows: list[list[str]] = []
        for law in data["law"].values.tolist():
            one = here.sel(law=law, network=network)
            if np.isnan(one["cost"].isel(hand=0).values).all():
                continue
            many = multiples(data, study, law, network, users)
            shown = {
                "place": 1e3 * float(one["place"].isel(hand=0).mean()),
                "force": 100.0 * float(one["force"].isel(hand=0).mean()),
            }
            shown |= {name: float(one[f"felt_{name}"]) for name in _FELT} if study.felt else {}
            rows.append(
                [
                    escape(law),
                    *(_marked(value, many[name]) for name, value in shown.items()),
                    num(1e3 * float(one["apart"].isel(hand=0).mean())),
                    num(float(one["rough"].isel(hand=0).mean()), 2),
                    num(float(one["made"].isel(hand=0).max()), 2),
                    num(float(one["extracted"].isel(hand=0).max()), 2),
                    *(num(scale * _mean(one[name]), 3) for name, scale in _QUALITY.items()),
                ]
            )
        head = [
            "law",
            *("place<br>mm", "force<br>%"),
            *(f"{name}<br>{unit}" for name, unit in _FELT.items() if study.felt),
            *("apart<br>mm", "rough<br>N", "made<br>J", "extracted<br>J", "PSNR<br>dB", "HPW-PSNR<br>dB", "late<br>ms"),
            *("off<br>mm", "packets<br>1/s", "kB/s"),
        ]
        parts.append(f"<h3>{escape(network)}</h3>{table(head, rows, kind='dense')}")
    felt = (
        " Drag and mass are what a hand feels that moves the object freely, stiffness what one feels that presses "
        "while the others hold; a dash means that copies that nobody holds drive each other apart."
    )
    intro = (
        f"<p>For {users} users, the mean over tasks and draws, with the multiple of what is noticed."
        f"{felt if study.felt else ''} <em>Made</em> is energy beyond what the law declares, <em>extracted</em> what "
        "hands got out beyond what there was. PSNR and HPW-PSNR compare hands' forces with the ideal ones, "
        "<em>late</em> and <em>off</em> are the effective time- and value-offset (ETVO) of the object. Packets are "
        "samples sent in full to one neighbour; bytes are without headers.</p>"
    )
    return Section(anchor="noticed", title="What is noticed", body=intro + "".join(parts))


def _mean(values: "xr.DataArray") -> float:
    """Over tasks and draws, of those that are finite."""
    known = values.isel(hand=0).values
    known = known[np.isfinite(known)]
    return float(known.mean()) if known.size else float("nan")


def _maps(data: "xr.Dataset") -> Section:
    lines: list[list[str]] = []
    moving: list[list[str]] = []
    stiffness = data["stiffness"].values.tolist()
    for law in data["law"].values.tolist():
        risky = data["map_dangerous"].sel(law=law).values == 1.0
        cells = [escape(law)]
        for row in risky:
            first = np.flatnonzero(row)
            safe = 1e3 * data["delay"].values[: int(first[0]) if first.size else None]
            cells.append("–" if not safe.size else f"{'≥ ' if not first.size else ''}{safe[-1]:g}")
        lines.append(cells)
        restless = data["map_restless"].sel(law=law).max("delay").values.tolist()
        moving.append([escape(law), *(num(1e3 * value) for value in restless)])
    head = ["law", *(f"{value:g} N/m" for value in stiffness)]
    caption = (
        "<b>Cost over delay and stiffness of two users' hands.</b> Crossed cells are dangerous: a push grows, or goes "
        "on for ever. The line shows where that begins."
    )
    drawn = figure(maps(data), "danger", caption, "Maps of cost over delay and stiffness, one for each law.")
    body = (
        f"{drawn}<p>The largest one-way delay up to which no case was found dangerous, in ms:</p>{table(head, lines)}"
        "<p>If both hold still, at different places: the speed of copies in the last fifth of a run, the most at "
        f"any delay, in mm/s:</p>{table(head, moving)}"
    )
    return Section(anchor="danger-maps", title="Where laws become dangerous", body=body)


def _fronts(data: "xr.Dataset", study: Study) -> list[Section]:
    users, body = int(data["users"].values[0]), ""
    if study.felt:
        body += figure(
            fronts(data, users, "drag"),
            "front-drag",
            f"<b>Error against drag, {users} users.</b> Lower left is better; the broken line joins laws that no other "
            "law beats in both respects. Hollow marks are dangerous there.",
            "Position error over drag, one panel for each network.",
        )
    if float(data["made"].sel(users=users, tuning=chosen(data)).max()) > 0.0:
        body += figure(
            fronts(data, users, "made"),
            "front-made",
            "<b>Error against energy made beyond the initial energy.</b> Passive laws are at 0.",
            "Position error over energy made, one panel for each network.",
        )
    return [Section(anchor="fronts", title="Trade-offs", body=body)] if body else []


def _price(data: "xr.Dataset", study: Study) -> Section:
    rate = 1.0 / study.period
    rows = [
        [
            escape(law),
            escape(str(data["sends"].sel(law=law).item())),
            f"{float(data['bytes'].sel(law=law)):g}",
            num(1e-3 * rate * float(data["bytes"].sel(law=law)), 3),
            num(1e6 * max(float(data["time"].sel(law=law)), 0.0), 2),
            verdict(holds=bool(data["promises"].sel(law=law)), yes="promises", no="doesn't"),
            escape(str(data["source"].sel(law=law).item())),
        ]
        for law in data["law"].values.tolist()
    ]
    head = [
        "law",
        "sends",
        "bytes a<br>message",
        "kB/s at<br>full rate",
        "µs a link<br>and step",
        "passivity",
        "source",
    ]
    body = (
        "<p>Bytes are those of fields and numbers before any codec. Time is what the law takes beyond a spring, at "
        "one end of a link in one step, on the machine that made this page.</p>"
        + table(head, rows, text=(0, 1, 5, 6), kind="dense")
    )
    return Section(anchor="price", title="What laws cost", body=body)


def _method(data: "xr.Dataset", study: Study) -> Section:
    tuning = study.tuning
    how = (
        "No law is tuned; parameters are the published defaults."
        if not study.tunes
        else (
            f"Every law is tuned alike: the springs and every parameter except initial energies, as multiples of its "
            f"default from 1/{tuning.range:g} to {tuning.range:g}; {tuning.search} settings that fill the space "
            f"evenly, then {tuning.local} near the best; {tuning.draws} draw{'s' * (tuning.draws > 1)} of each task "
            f"with {tuning.users} users; these draws do not count otherwise. A setting counts only if pushes die away, "
            f"also with hands {study.stiffer:g} times stiffer."
        )
    )
    rows: list[list[str]] = []
    for law in data["law"].values.tolist():
        for network in data["network"].values.tolist():
            setting = json.loads(str(data["setting"].sel(law=law, network=network, tuning=chosen(data)).item()))
            text = (
                "none found" if setting is None else ", ".join(f"{k}&nbsp;×&nbsp;{v:.3g}" for k, v in setting.items())
            )
            rows.append([escape(law), escape(network), text or "defaults"])
    seen = ", ".join(
        f"{name} {num(value * (1e3 if name == 'place' else 100.0))}&nbsp;{'mm' if name == 'place' else '%'}"
        for name, value in NOTICED.items()
    )
    problems, nodes = json.loads(data.attrs["problems"]), study.build_body().nodes
    left = "".join(f"<li>{escape(problem)}</li>" for problem in problems)
    return Section(
        anchor="method",
        title="How it was done",
        body=f"<p>{how}</p><p>The body is a {escape(str(study.body.get('kind', 'point')))} of {nodes} "
        f"node{'s' * (nodes > 1)}; {_LINKED[study.graph]}.</p>"
        f"<p>What people notice, by the lowest thresholds found: {seen} [Rank, Shi &amp; Hirche "
        "2010; Jay, Glencross &amp; Hubbold 2007]; drag as a fraction of the hand's own damping. A push is dangerous "
        "if after six seconds it has not lost a tenth of its speed since the second quarter, with all hands holding or "
        "one.</p>"
        + (f"<p>What could not run:</p><ul>{left}</ul>" if left else "")
        + f"<h3>Settings</h3>{table(['law', 'network', 'multiples of the defaults'], rows, text=(0, 1, 2))}",
    )
