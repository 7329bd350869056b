"""Random scenarios with tools for the record: contacts that switch at random, on random bodies, steps and networks.

Every scenario is drawn from (seed, number) alone, so that a single one can be run again with `--only NUMBER`. Findings
go to a file as they come, so that a long run can be taken up again with `--resume FILE`.
"""

import argparse
import json
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from benchmarks._report import Row, add_write, finish
from cotouch.body import Body, lattice
from cotouch.device import PRESETS
from cotouch.scenario import Scenario
from cotouch.simulation import prepare, run_batch
from cotouch.study._blocks import blocks

SEED = 2011
TOLERANCE = 1e-10  # of the energy in play
COUNT, SHORT = 1000, 60
_KINDS = ("nodal", "elastic", "truncated")
_CHUNK = 20

Table = dict[str, Any]
Float = npt.NDArray[np.float64]


@dataclass(frozen=True, kw_only=True)
class Finding:
    """What one scenario came to. Energies are relative to the energy in play of their run.

    Attributes:
        number: of the scenario.
        kind: of the body.
        steps: of all users.
        switches: how often a tool began or ceased to touch or hold.
        devices: tools with a device.
        residual: largest imbalance in the ledger of copies, links, proxies and contacts.
        device_residual: in those of devices and hands.
        given: most that contacts gave body and proxies together.
        used: largest share of its d² that a PSPM coupling gave away.
        virtual: most that a virtual coupling gave beyond what its device's damping and friction paid.
        saturated: virtual couplings whose motors could not always do what was asked.
        beyond: how many of those gave more than was paid.
        margin: least of Σ v̂ᵀ f T; negative: energy came out of the copies.
        finished: whether the motion stayed in floating point.
    """

    number: int
    kind: str
    steps: int
    switches: int
    devices: int
    residual: float
    device_residual: float
    given: float
    used: float
    virtual: float
    saturated: int
    beyond: int
    margin: float
    finished: bool


def _log(rng: np.random.Generator, low: float, high: float) -> float:
    return float(np.exp(rng.uniform(np.log(low), np.log(high))))


def body_of(rng: np.random.Generator) -> tuple[Body, str]:
    """A random body of at most 64 nodes with a skin, in one of three kinds."""
    kind = str(rng.choice(_KINDS))
    extents = [int(extent) for extent in rng.integers(2, 5, 3)]
    stiffness, ground = _log(rng, 20.0, 2e4), _log(rng, 1.0, 1e3)
    # A body that is to be truncated has modes of its own only if its damping follows its stiffness.
    ratio = _log(rng, 1e-5, 1e-3) * (rng.random() < 0.7)
    made = lattice(
        extents,
        mass=_log(rng, 0.05, 5.0),
        stiffness=stiffness,
        damping=ratio * stiffness,
        spacing=_log(rng, 0.005, 0.03),
        ground=str(rng.choice(["none", "z-", "all"])),
        ground_stiffness=ground,
        ground_damping=ratio * ground if kind == "truncated" else _log(rng, 1e-3, 1.0) * (rng.random() < 0.5),
        neighbours=int(rng.choice([6, 18, 26])),  # pyright: ignore[reportArgumentType]
    )
    if kind == "elastic" or (kind == "truncated" and rng.random() < 0.5):
        made = _coupled(rng, made, ratio)
    if kind == "truncated":
        corners = rng.choice(made.nodes, int(rng.integers(1, 4)), replace=False)
        made = made.truncated(modes=int(rng.integers(4, 9)), contacts=[int(node) for node in corners])
    return made, kind


def _coupled(rng: np.random.Generator, plain: Body, ratio: float) -> Body:
    """The same with springs that couple the axes: along and across random directions between neighbours."""
    full = plain.as_full()
    rows = 3 * plain.nodes
    extra = np.zeros((rows, rows))
    distance = np.linalg.norm(plain.rest[:, None] - plain.rest[None], axis=2)
    nearest = np.min(distance[distance > 0.0])
    scale = float(np.abs(plain.stiffness_int.diagonal()).max()) or 1.0
    for a, b in zip(*np.nonzero((distance > 0.0) & (distance < 1.5 * nearest)), strict=True):
        if a < b:
            along = rng.normal(size=3)
            block = scale * rng.random() * np.outer(along, along) / (along @ along)
            sa, sb = slice(3 * a, 3 * a + 3), slice(3 * b, 3 * b + 3)
            extra[sa, sa] += block
            extra[sb, sb] += block
            extra[sa, sb] -= block
            extra[sb, sa] -= block
    return Body(
        mass=full.mass.toarray(),
        damping_int=full.damping_int.toarray() + ratio * extra,
        damping_ext=full.damping_ext.toarray(),
        stiffness_int=full.stiffness_int.toarray() + extra,
        stiffness_ext=full.stiffness_ext.toarray(),
        rest=full.rest,
        skin=full.skin,
    )


def _network(rng: np.random.Generator, nodes: int) -> Table:
    users = int(rng.integers(1, 5))
    spring, delay = np.zeros((users, users)), np.zeros((users, users))
    longest = _log(rng, 1e-3, 0.1)
    for b in range(users):
        for a in range(b):
            spring[a, b] = spring[b, a] = _log(rng, 1.0, 1000.0) / nodes
            delay[a, b], delay[b, a] = rng.uniform(0.0, longest, 2)
    links = {(int(rng.integers(i)) + 1, i + 1) for i in range(1, users)}
    links |= {(a + 1, b + 1) for b in range(users) for a in range(b) if rng.random() < 0.3}
    return {
        "users": [str(i + 1) for i in range(users)],
        "spring": spring.tolist(),
        "delay": delay.tolist(),
        "links": [list(link) for link in sorted(links)],
    }


def _channel(rng: np.random.Generator) -> Table:
    table: Table = {}
    if rng.random() < 0.6:
        table["jitter"] = {
            "kind": str(rng.choice(["uniform", "exponential", "normal"])),
            "scale": _log(rng, 1e-4, 2e-2),
        }
    if rng.random() < 0.5:
        table["loss"] = float(rng.uniform(0.0, 0.4))
    return table


def _hand(rng: np.random.Generator, inwards: Float, size: float, duration: float, *, device: bool) -> Table:
    """New places at random times, in and out of the body and along it."""
    count = int(rng.integers(3, 16))
    times = np.unique(rng.uniform(0.0, duration, count))
    depth = rng.uniform(-0.5, 1.2, times.size) * size
    places = depth[:, None] * inwards + rng.normal(0.0, 0.3 * size, (times.size, 3))
    hand: Table = {"path": [[float(t), *map(float, place)] for t, place in zip(times, places, strict=True)]}
    if rng.random() < 0.3:
        hand |= {
            "amplitude": rng.normal(0.0, 0.2 * size, 3).tolist(),
            "frequency": _log(rng, 0.5, 100.0),
        }
    if device:
        hand["grip"] = float(rng.choice([0.25, 1.0, 4.0]))
    else:
        hand |= {"stiffness": _log(rng, 20.0, 5e3), "damping": _log(rng, 0.01, 20.0) * (rng.random() < 0.8)}
    if rng.random() < 0.3:
        hand["release"] = float(rng.uniform(0.4, 1.0) * duration)
    return hand


def _device(rng: np.random.Generator) -> Table:
    table: Table = {"damping": float(rng.uniform(0.0, 5.0)), "stiffness": _log(rng, 50.0, 5e3), "clip_stiffness": True}
    kind = rng.integers(3)
    if kind == 0:
        table |= {"kind": "phantom", "preset": "phantom"}
    else:
        table["preset"] = str(rng.choice(sorted(PRESETS)))
    if kind == 2:
        own = _log(rng, 0.5, 10.0)
        table |= {
            "coupling": "host_force",
            "viscous": own,
            # Steps beside each other differ by up to thirty times in length; what is left must pay for the spring.
            "damping": own * float(rng.uniform(0.0, 0.01)),
        }
    elif rng.random() < 0.5:
        table["periods"] = np.exp(rng.uniform(np.log(2e-4), np.log(4e-3), 5)).tolist()
    else:
        table["rate"] = _log(rng, 250.0, 4000.0)
    return table


def _tool(rng: np.random.Generator, user: int, body: Body, duration: float, *, device: bool) -> Table:
    assert body.skin is not None
    low, high = body.rest.min(axis=0), body.rest.max(axis=0)
    middle, size = 0.5 * (low + high), float(np.min(high - low))
    radius = float(rng.uniform(0.1, 0.4) * size)
    spot = body.skin.vertices[int(rng.integers(body.skin.vertices.shape[0]))]
    outwards = spot - middle + rng.normal(0.0, 0.1 * size, 3)
    outwards /= np.linalg.norm(outwards)
    grasp = bool(rng.random() < 0.35)
    table: Table = {
        "user": user,
        "at": _outside(body, spot, outwards, radius * float(rng.uniform(1.01, 2.0))).tolist(),
        "kind": "grasp" if grasp else "touch",
        "radius": radius,
        "mass": _log(rng, 0.005, 0.5),
        "stiffness": _log(rng, 1e3, 1e6),
    }
    if grasp:
        table["damping"] = _log(rng, 0.01, 50.0) * (rng.random() < 0.5)
    else:
        table["damping"] = _log(rng, 0.01, 100.0) * (rng.random() < 0.5)
        table["friction"] = float(rng.uniform(0.05, 1.5)) * (rng.random() < 0.5)
    if rng.random() < 0.5:
        table["begin"] = float(rng.uniform(0.0, 0.5) * duration)
    if rng.random() < 0.5:
        table["release"] = float(rng.uniform(0.55, 1.0) * duration)
    table["hand"] = _hand(rng, -outwards, size, duration, device=device)
    if device:
        table["device"] = _device(rng)
    return table


def _outside(body: Body, spot: Float, outwards: Float, away: float) -> Float:
    """A place out from a spot on the skin, so far that nothing of the skin at rest is nearer than `away`."""
    assert body.skin is not None
    corners = body.skin.vertices[body.skin.triangles]
    place = spot + away * outwards
    while True:
        gap = float(np.linalg.norm(place - _nearest(corners, place), axis=1).min())
        if gap >= away * (1.0 - 1e-9):
            return place
        place = place + (away - gap + 1e-6) * outwards


def scenario(number: int) -> tuple[Scenario, str]:
    """The scenario of a number, and the kind of its body."""
    rng = np.random.default_rng((SEED, number))
    body, kind = body_of(rng)
    network = _network(rng, body.nodes)
    low, high = np.sort(np.exp(rng.uniform(np.log(2e-4), np.log(6e-3), 2)))
    duration = float(high * 2 + 0.5 * (low + high) * _log(rng, 100, 600))
    devices = rng.random() < 0.5
    users = len(network["users"])
    tools = [
        _tool(rng, user + 1, body, duration, device=devices and rng.random() < 0.7)
        for user in range(users)
        for _ in range(int(rng.integers(1, 4)))
    ]
    return Scenario.make(
        title=f"touch record {number}",
        seed=number,
        network=network,
        body=body,
        steps={"duration": duration, "random": {"low": float(low), "high": float(high)}},
        synchronisation={"mode": str(rng.choice(["freshest", "constant"])), "damping": "rule"},
        channel=_channel(rng),
        tools=tools,
        solver={
            "basis": "auto" if kind == "truncated" else str(rng.choice(["nodal", "auto"])),
            "tolerance": _log(rng, 1e-12, 1e-4),
            **({"iterations": int(rng.integers(2, 60))} if rng.random() < 0.3 else {}),
        },
        record={"nodes": list(range(1, body.nodes + 1))},
    ), kind


def examine(number: int) -> Finding | str:
    """Runs one scenario; a sentence where it could not be run."""
    try:
        made, kind = scenario(number)
        prepared = prepare(made)
    except ValueError as error:
        return f"{number}: {type(error).__name__}: {error}"
    with np.errstate(over="ignore", invalid="ignore"):
        outcome = run_batch(prepared)
        found = blocks(prepared, outcome)
    tools = outcome.tools
    assert tools is not None
    play = found.in_play or 1.0
    springs = [port for port in found.couplings if port.law == "host_force"]
    outside = [port for port in springs if port.saturated]
    return Finding(
        number=number,
        kind=kind,
        steps=outcome.events,
        switches=int(np.count_nonzero(np.diff((tools.touching > 0).astype(np.int8), axis=1))),
        devices=len(found.couplings),
        residual=found.energy_residual,
        device_residual=found.device_residual,
        given=found.given / play,
        used=found.used,
        virtual=max((port.excess for port in springs), default=0.0) / play,
        saturated=len(outside),
        beyond=sum(port.excess > TOLERANCE * play for port in outside),
        margin=found.port_margin / play,
        finished=found.finished,
    )


def _nearest(corners: Float, point: Float) -> Float:
    """Nearest point of every triangle to a point [Ericson 2004, 5.1.5, by trying faces, edges and corners]."""
    a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
    best = a.copy()
    least = np.linalg.norm(point - a, axis=1)

    def take(candidate: Float, valid: npt.NDArray[np.bool_]) -> None:
        away = np.linalg.norm(point - candidate, axis=1)
        better = valid & (away < least)
        best[better], least[better] = candidate[better], away[better]

    for p, q in ((a, b), (b, c), (c, a)):
        edge = q - p
        fraction = np.einsum("ij,ij->i", point - p, edge) / np.maximum(np.einsum("ij,ij->i", edge, edge), 1e-300)
        take(p + np.clip(fraction, 0.0, 1.0)[:, None] * edge, np.ones(fraction.size, dtype=bool))
    u, v, w = b - a, c - a, point - a
    uu, uv, vv = (np.einsum("ij,ij->i", x, y) for x, y in ((u, u), (u, v), (v, v)))
    wu, wv = np.einsum("ij,ij->i", w, u), np.einsum("ij,ij->i", w, v)
    scale = np.maximum(uu * vv - uv * uv, 1e-300)
    s, t = (vv * wu - uv * wv) / scale, (uu * wv - uv * wu) / scale
    take(a + s[:, None] * u + t[:, None] * v, (s >= 0) & (t >= 0) & (s + t <= 1))
    return best


def run(count: int, jobs: int, kept: Path | None = None) -> tuple[list[Finding], list[str]]:
    """Findings of the scenarios 1 to `count`, and why some could not be run; `kept` holds what was found so far."""
    import joblib

    findings: dict[int, Finding] = {}
    refused: list[str] = []
    if kept is not None and kept.exists():
        for line in kept.read_text(encoding="utf-8").splitlines():
            found = json.loads(line)
            if isinstance(found, str):
                refused.append(found)
            else:
                findings[found["number"]] = Finding(**found)
    skip = {*findings, *(int(text.split(":")[0]) for text in refused)}
    left = [number for number in range(1, count + 1) if number not in skip]
    with joblib.Parallel(n_jobs=jobs) as parallel:
        for start in range(0, len(left), _CHUNK * max(jobs, 1)):
            chunk = left[start : start + _CHUNK * max(jobs, 1)]
            results: Sequence[Finding | str] = list(parallel(joblib.delayed(examine)(number) for number in chunk))
            lines: list[str] = []
            for found in results:
                if isinstance(found, str):
                    refused.append(found)
                    lines.append(json.dumps(found))
                else:
                    findings[found.number] = found
                    lines.append(json.dumps(asdict(found)))
            if kept is not None:
                with kept.open("a", encoding="utf-8") as file:
                    file.write("\n".join(lines) + "\n")
    return [findings[number] for number in sorted(findings) if number <= count], refused


def measure(count: int = SHORT, jobs: int = 1, kept: Path | None = None) -> list[Row]:
    """Rows of the table."""
    findings, refused = run(count, jobs, kept)

    def numbers(bad: list[Finding]) -> str:
        return str([found.number for found in bad[:9]]) if bad else "none"

    worst = max(findings, key=lambda found: found.residual)
    device = max(findings, key=lambda found: found.device_residual)
    unbalanced = [f for f in findings if not max(f.residual, f.device_residual) <= TOLERANCE]
    gave = [f for f in findings if not f.given <= TOLERANCE]
    coupled = [f for f in findings if f.devices]
    broke = [f for f in coupled if not (f.used <= 1.0 and f.virtual <= TOLERANCE)]
    active = [f for f in findings if not f.margin >= -TOLERANCE]
    left = [f for f in findings if not f.finished]
    kinds = ", ".join(f"{sum(f.kind == kind for f in findings):,} {kind}" for kind in _KINDS)
    steps, switches = sum(f.steps for f in findings), sum(f.switches for f in findings)
    couplings = sum(f.devices for f in findings)
    used = max((f.used for f in coupled), default=0.0)
    outside, beyond = sum(f.saturated for f in findings), sum(f.beyond for f in findings)
    return [
        Row(
            "touch record",
            "random scenarios with tools",
            f"{len(findings):,}",
            "",
            f"bodies: {kinds}; {steps:,} steps; contact or grasp began or ended {switches:,} times; {len(refused)} "
            f"refused, {len(left)} left floating point",
        ),
        Row(
            "touch record",
            "worst energy residual, of the energy in play",
            f"{worst.residual:.1e}",
            f"≤ {TOLERANCE:g}",
            f"above: {numbers(unbalanced)}; worst is number {worst.number}; devices and hands "
            f"{device.device_residual:.1e}",
        ),
        Row(
            "touch record",
            "runs whose contacts gave more than they were given",
            f"{len(gave)}",
            "0",
            f"numbers: {numbers(gave)}; most {max(f.given for f in findings):.1e} of the energy in play",
        ),
        Row(
            "touch record",
            "runs with a coupling beyond its bound",
            f"{len(broke)} of {len(coupled):,}",
            "0",
            f"numbers: {numbers(broke)}; {couplings:,} couplings; PSPM at most {used:.2g} of d²; motors of {outside} "
            f"virtual couplings saturated, {beyond} of which gave energy",
        ),
        Row(
            "touch record",
            "runs in which the copies gave energy",
            f"{len(active)}",
            "0",
            f"numbers: {numbers(active)}; least Σ v̂ᵀ f T {min(f.margin for f in findings):.1e} of the energy in play",
        ),
    ]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=SHORT, help=f"how many scenarios ({COUNT:,} for the record)")
    parser.add_argument("--jobs", type=int, default=1, help="processes")
    parser.add_argument("--resume", type=Path, help="keep findings in this file and go on from there")
    parser.add_argument("--only", type=int, help="run this scenario alone and print it")
    add_write(parser)
    options = parser.parse_args()
    if options.only is not None:
        print(scenario(options.only)[0].as_json())
        print(examine(options.only))
        return
    finish(measure(options.count, options.jobs, options.resume), write=options.write)


if __name__ == "__main__":
    main()
