"""How rows become the tables of RESULTS.md: values for several networks, or deadbands, get a column each."""

import re
import textwrap
from collections.abc import Iterable, Sequence
from typing import NamedTuple


class Row(NamedTuple):
    """One line: what was measured, the value, the goal where there is one, and what it stands beside."""

    section: str
    what: str
    value: str
    goal: str = ""
    note: str = ""


class Section(NamedTuple):
    """How a section is measured again, and what its rows mean."""

    command: str
    meaning: str


_LAWS = (
    "The first table has the cost of every tuned law by network: position error / 10 mm + force error / ideal force, "
    "with its 95 % interval, and in brackets the cost with hands of 1800 instead of 300 N/m; means over "
    "all tasks. Then `paid` beside its rivals, the tasks that it loses, and the energy that laws made"
)
# In the order of the file.
SECTIONS = {
    "engine": Section("python -m benchmarks.engine", "One run of the paper's scenario, with all that a user waits for"),
    "step": Section("python -m benchmarks.step", "Time of one step of one user's copy, by body"),
    "scaling": Section("python -m benchmarks.scaling", "Time and memory of a step as bodies and sessions grow"),
    "touch": Section("python -m benchmarks.touch", "Median time of a step of 1 ms, and what tools add to it"),
    "materials": Section(
        "python -m benchmarks.materials", "Time of one step of 1 ms of a free body that bends and turns"
    ),
    "bodies": Section("python -m benchmarks.bodies", "CPU time of one step of several rigid bodies in contact"),
    "acceptance": Section(
        "python -m benchmarks.acceptance",
        "Balance of bodies beyond small displacements as fractions of the energy in play",
    ),
    "planner": Section("python -m benchmarks --long", "How long the planner searches, and what it finds"),
    "laws": Section("python -m benchmarks.laws --passive --out DIR", _LAWS),
    "codec": Section(
        "python -m benchmarks.codec",
        "Two users, laws with their defaults, five tasks at 500 Hz: cost, and packets a second to a neighbour, by "
        "deadband; below it how good signals are without a codec and with the usual deadband",
    ),
    "laws: ten in ten minutes": Section("python -m benchmarks.laws --part ten --out DIR", _LAWS),
    "laws: stars": Section("python -m benchmarks.laws --part star --out DIR", _LAWS),
    "laws: paths": Section("python -m benchmarks.laws --part path --out DIR", _LAWS),
    "laws: elastic body": Section("python -m benchmarks.laws --part elastic --out DIR", _LAWS),
    "promises": Section(
        "python -m benchmarks.promises", "Random or searched runs in which a law made more energy than it declares"
    ),
    "law interface": Section(
        "python -m benchmarks.interface", "What a link's end costs more as a law than as a built-in spring"
    ),
    "live": Section("python -m benchmarks.live", "What samples cost between two processes on loopback"),
    "laws live": Section("python -m benchmarks.drag", "Drag that a hand feels in a session of two processes"),
    "members": Section("python -m benchmarks.members", "Members as processes on one machine: latency, load, deadlines"),
    "drivers": Section("python -m benchmarks.drivers", "Drivers against stand-ins of the vendors' services"),
    "servo": Section("python -m benchmarks.servo", "What a servo costs, and how soon force is gone, whoever dies"),
    "servo memory": Section("python -m benchmarks.servo --growth 600", "What servo and guardian grow by"),
    "page": Section("python -m benchmarks.page", "Frames, load and latency of the page"),
    "recording": Section("python -m benchmarks.recording", "What recording costs the loop, and reading afterwards"),
    "record": Section("python -m benchmarks.record --count 10000", "Balance and passivity of random scenarios"),
    "touch record": Section("python -m benchmarks.touch_record --count 1000", "The same, with tools"),
    "device record": Section("python -m benchmarks.device_record --count 600", "The same, with devices"),
    "soak": Section("python -m benchmarks.soak", "A session in which members are killed, stopped and cut off"),
    "attack": Section("python -m benchmarks.attack --count 2100", "The worst that a lying member did to honest ones"),
    "fuzz": Section(
        "python -m benchmarks.fuzz --count 10000000", "Mutated messages that were believed or crashed a reader"
    ),
}


def introduction(section: str) -> list[str]:
    """What the rows of a section mean, and the command that measures them again, as lines of Markdown."""
    told = SECTIONS.get(section)
    if told is None:
        return []
    return [*textwrap.wrap(f"{told.meaning}.", 120, break_on_hyphens=False), "", f"To repeat: `{told.command}`", ""]


def laid_out(section: str, rows: Sequence[Row]) -> list[str]:
    """The tables of a section, as lines of Markdown.

    Args:
        section: its name.
        rows: of it.
    """
    if section == "codec":
        return _codec(rows)
    if section == "scaling":
        return _plain(each for row in rows for each in _by_size(row))
    if any(row.what == "networks" for row in rows):
        return _networks(rows)
    return _plain(rows)


def _table(headings: Sequence[str], lines: Iterable[Sequence[str]]) -> list[str]:
    rows = [headings, ["---"] * len(headings), *lines]
    return ["", *("| " + " | ".join(cell.replace("|", "/") for cell in row) + " |" for row in rows)]


def _plain(rows: Iterable[Row]) -> list[str]:
    return _table(["measured", "value", "goal", "note"], [row[1:] for row in rows])


def _by_size(row: Row) -> list[Row]:
    """A row for each size of a list such as `1: 0.1, 1,000: 64.1`; else the row as it is."""
    sizes = [part.split(": ") for part in row.value.split(", ")]
    if any(len(size) != 2 for size in sizes):
        return [row]
    return [
        row._replace(what=f"{row.what}: {size}", value=value, note="" if k else row.note)
        for k, (size, value) in enumerate(sizes)
    ]


def _networks(rows: Sequence[Row]) -> list[str]:
    """What was compared on several networks: costs, our law beside its rivals, what it loses, and the rest."""
    head = next(row for row in rows if row.what == "networks")
    networks = head.value.split(" / ")
    costs, beside, lost, energies, rest = [], [], [], [], []
    for row in rows:
        users, _, what = row.what.partition(": ")
        if row is head:
            continue
        if what.startswith("energy made"):
            energies.append([users, row.value, row.goal])
        elif "loses" in what:
            lost += [[users, *each] for each in _lost(row.value, networks)]
        elif row.note.startswith("best passive rival: "):
            rivals, half = row.note.removeprefix("best passive rival: ").split("; half of the rule's: ")
            beside.append([f"{users}: {what}", *row.value.split(" / ")])
            beside.append(["— best passive rival", *rivals.split(" / ")])
            beside.append(["— half of the rule's", *half.split(" / ")])
        elif len(cells := row.value.split(" / ")) == len(networks):
            costs.append([f"{users}: {what}", *cells])
        else:
            rest.append(row)
    said = head.note.split("; ")[0]
    return [
        "",
        f"{said[0].upper()}{said[1:]}.",
        *_table(["cost", *networks], costs),
        *_table(["mean cost of all tasks", *networks], beside),
        *(_table(["lost by ours", "task", "network", "cost", "best passive rival"], lost) if lost else []),
        *_table(["law", "energy made beyond its initial energy, at most", "goal"], energies),
        *(_plain(rest) if rest else []),
    ]


def _lost(text: str, networks: Sequence[str]) -> list[list[str]]:
    """Task, network, own cost and rival's of a list of what was lost."""
    if text == "none":
        return []
    name = "|".join(re.escape(network) for network in sorted(networks, key=len, reverse=True))
    single = re.findall(rf"(\w+) on ({name}) ([\d.]+) \(([\d.]+)\)", text)
    whole = re.findall(rf"({name}): ([\d.]+) \(best rival (\w+ [\d.]+), half of the rule's ([\d.]+)\)", text)
    return [list(each) for each in single] + [
        ["mean of all", network, own, f"{rival}; half of the rule's {half}"] for network, own, rival, half in whole
    ]


def _codec(rows: Sequence[Row]) -> list[str]:
    costs, signals = [], []
    for row in (row for row in rows if row.note):
        found = dict(cell.split(": ") for cell in row.value.split("; "))
        costs.append((row.what, found))
        for part in row.note.split("; "):
            deadband, _, text = part.partition(": ")
            signals.append([row.what, deadband, *re.split(r", PSNR | and HPW-PSNR | dB, ETVO | and | mm, made ", text)])
    deadbands = list(dict.fromkeys(name for _, found in costs for name in found))
    return [
        *_table(
            ["law, network; cost at packets/s", *deadbands],
            [[what, *(found.get(name, "") for name in deadbands)] for what, found in costs],
        ),
        *_table(["law, network", "deadband", "data", "PSNR", "HPW-PSNR dB", "ETVO", "ETVO mm", "energy made"], signals),
    ]
