"""Recording: what it costs the loop, how large the file gets, how long reading and auditing take.

One user at 1 kHz with two links. The loop is timed step by step, so that the thread's work that gets in its way counts.
"""

import tempfile
from pathlib import Path
from time import perf_counter, perf_counter_ns, sleep

import numpy as np

from benchmarks._report import Row, command
from cotouch.body import Body, lattice, point
from cotouch.mechanics import Ports, model
from cotouch.peer import FreshestLink, Peer, Sample, StepReport
from cotouch.recording import RecordedBody, Recorder, RecordHeader, audit, read_recording

PERIOD = 0.001
STEPS = 20_000


def peer_of(body: Body) -> Peer:
    """A copy with two neighbours that stand still, held by a hand that moves."""
    ready = model(body, copies=3)
    rows, width = ready.port_rows(0), ready.width
    still = np.zeros((ready.operator_rows, width))
    hand = {name: np.zeros((rows.size, width)) for name in ("start", "end", "push", "force")}
    return Peer(
        index=0,
        model=ready,
        links={j: FreshestLink(Sample(sender=j, index=-1, stamp=0.0, position=still)) for j in (1, 2)},
        strength=[60.0, 60.0],
        weight=[0, 0],
        local_damping=np.array([4.0]),
        extra_damping=np.array([0.0]),
        ports=Ports(
            row=rows,
            shape=ready.port_shapes(rows),
            stiffness=np.full(rows.size, 100.0),
            damping=np.zeros(rows.size),
            **hand,
        ),
        position=np.zeros((body.nodes, body.dimension)),
        velocity=np.zeros((body.nodes, body.dimension)),
    )


def case(name: str, body: Body) -> list[Row]:
    peer = peer_of(body)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "one.mcap"
        header = RecordHeader(user=0, monotonic=0.0, unix=1e9, body=RecordedBody.of(peer.model))
        recorder = Recorder(path, header)
        recorder.setup(0.0, copies=3, neighbours=[1, 2], strength=[60.0, 60.0], local_damping=[4.0], ports=[0])
        head = path.stat().st_size
        spent = np.empty(STEPS)
        for k in range(STEPS):
            now = PERIOD * (k + 1)
            peer.ports.start[:, 0], peer.ports.end[:, 0] = 0.1 * np.sin(7.0 * (now - PERIOD)), 0.1 * np.sin(7.0 * now)
            report: StepReport = peer.step(now, PERIOD)
            before = perf_counter_ns()
            recorder.step(report, end=now, T=PERIOD, state=peer.state, used=(-1, -1))
            spent[k] = perf_counter_ns() - before
            if k % 200 == 199:
                sleep(0.05)  # a loop at 1 kHz leaves the thread time
        done = recorder.close()
        size = (path.stat().st_size - head) * 60.0 / (STEPS * PERIOD)
        middle, high, most = np.quantile(spent, [0.5, 0.99, 0.999]) / 1e3
        every = max(1, -(-header.body.rows * header.body.axes // 256))
        start = perf_counter()
        recording = read_recording(path)
        read = perf_counter() - start
        audit([recording])
        audited = perf_counter() - start - read
    states = "every state" if every == 1 else f"one state in {every}"
    seconds = STEPS * PERIOD
    return [
        Row(
            "recording",
            f"{name}, a step of the loop, p50 / p99 / p99.9",
            f"{middle:.1f} / {high:.1f} / {most:.1f} µs",
            note=f"{states}; {done.dropped_steps} of {STEPS:,} steps dropped",
        ),
        Row("recording", "— file at 1 kHz", f"{size / 1e6:.1f} MB/min", note=f"after a head of {head / 1e3:.0f} kB"),
        Row("recording", f"— reading and auditing {seconds:g} s of it", f"{read:.2f} + {audited:.2f} s"),
    ]


def measure() -> list[Row]:
    return case("point", point(mass=1.0)) + case("1,000 nodes", lattice((10, 10, 10)))


if __name__ == "__main__":
    command(measure, __doc__)
