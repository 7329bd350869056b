"""Felt drag live: two real processes on an emulated path, a scripted hand that moves the object evenly.

`python -m benchmarks.drag` hosts a session for each law with `cotouch host --law`, lets two `cotouch join` take part,
and reads from the recording of the one whose hand moves what that hand had to push with. It is compared with what the
linear prediction says for the same network and the damping in force; of a law that is dragless by design, with the
body's own damping alone.
"""

import json
import os
import signal
import subprocess
import sys
import tempfile
import time
from contextlib import ExitStack, suppress
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from benchmarks._report import Row, command
from cotouch.errors import CotouchError
from cotouch.laboratory import impedance
from cotouch.laws import law_named
from cotouch.members import SessionFile
from cotouch.recording import Recording, read_recording

SPEED = 0.05  # of the hand [m/s]
OWN = 1.0  # damping of the body [Ns/m]
SPRING, DELAY, JITTER, LOSS = 50.0, 0.015, 0.02, 0.05  # 25 ± 10 ms
CODEC = "codec = {deadband = 0.1, quantum = 1e-5, hold = 4}"
SETTLING = 1.5  # after the hand is at its speed [s]
SECONDS = 10.0
PATIENCE = 240.0  # where kernels compile [s]
TWO = f"""
title = "Drag"
[network]
users = ["Ann", "Ben"]
spring = [[0, {SPRING}], [{SPRING}, 0]]
delay = [[0, {DELAY}], [{DELAY}, 0]]
[channel]
jitter = {{kind = "uniform", scale = {JITTER}}}
loss = {LOSS}
[body]
mass = 1.0
damping = {OWN}
[steps]
rate = 200
[session]
emulate = true
wait_for_peers = {PATIENCE}
[[hands]]
user = 1
path = [[0, 0], [100, {100 * SPEED}]]
stiffness = 300.0
damping = 6.5
"""
_COMMAND = [sys.executable, "-m", "cotouch"]
_LOOK = 0.5  # how often recordings are looked at [s]


class Felt(NamedTuple):
    """What a law is like to a hand.

    Attributes:
        law: its name.
        saved: share of bytes that a perceptual codec left out; 0 without one.
        felt: force over velocity of the hand, on the average [Ns/m].
        predicted: likewise [Ns/m].
        said: what members said at their end of the law's part, measured and predicted; None: nothing [Ns/m].
        apart: most that the copies were apart from each other while it counted [m].
        late: Ann's late steps for each that she took.
    """

    law: str
    saved: float
    felt: float
    predicted: float
    said: tuple[float | None, float | None]
    apart: float
    late: float

    @property
    def off(self) -> float:
        """By how much the hand feels more than predicted, as a share of that."""
        return self.felt / self.predicted - 1.0


def measure_drag(law: str, seconds: float, folder: Path, *, codec: bool = False) -> Felt:
    """One session of two processes.

    Args:
        law: of its links.
        seconds: that count.
        folder: an empty one.
        codec: whether samples go through a perceptual codec.

    Raises:
        RuntimeError: a process ended early, or nobody moved for minutes.
    """
    from cotouch.members import Status, law_felt

    text = TWO.replace("[body]", f"{CODEC}\n[body]") if codec else TWO
    (folder / "two.toml").write_text(text, encoding="utf-8")
    recordings = [folder / "ann.mcap", folder / "ben.mcap"]
    with ExitStack() as stack:

        def start(*arguments: str) -> "subprocess.Popen[str]":
            process = subprocess.Popen([*_COMMAND, *arguments], stdout=subprocess.PIPE, text=True)
            stack.enter_context(process)
            stack.callback(process.kill)
            return process

        host = start("host", str(folder / "two.toml"), "--law", law, "--json")
        assert host.stdout is not None
        # What is printed is one object on several lines.
        said = ""
        while not said.endswith("}\n"):
            line = host.stdout.readline()
            if not line:
                raise RuntimeError("the host ended")
            said += line
        invitation = json.loads(said)["invitation"]
        members = [
            start("join", invitation, "--name", name, "--record", str(path), "--json")
            for name, path in zip(("Ann", "Ben"), recordings, strict=True)
        ]
        end = time.monotonic() + PATIENCE + seconds
        far = SPEED * (SETTLING + seconds)
        while (found := _read(recordings)) is None or _travelled(found[0]) < far:
            if time.monotonic() > end or any(process.poll() is not None for process in members):
                raise RuntimeError(f"the object was not carried {far:.2f} m with law {law}")
            time.sleep(_LOOK)
        for process in members:
            os.kill(process.pid, signal.SIGINT)
        last: list[dict[str, Any]] = [json.loads(process.communicate()[0])["status"] for process in members]
    ann, ben = (read_recording(path) for path in recordings)
    summary = law_felt([Status.model_validate(status) for status in last])
    assert summary is not None
    return _judge(law, ann, ben, seconds, (summary.measured, summary.predicted), last)


def _read(paths: list[Path]) -> tuple[Recording, Recording] | None:
    with suppress(CotouchError, OSError):  # not begun
        return read_recording(paths[0]), read_recording(paths[1])
    return None


def _travelled(recording: Recording) -> float:
    return float(recording.states["position"][-1, 0, 0]) if len(recording.states["position"]) else 0.0


def _judge(
    law: str,
    ann: Recording,
    ben: Recording,
    seconds: float,
    said: tuple[float | None, float | None],
    last: list[dict[str, Any]],
) -> Felt:
    place = np.interp(np.arange(ann.steps), ann.states["state_row"], ann.states["position"][:, 0, 0])
    begun = float(ann.time[np.flatnonzero(place > SPEED * SETTLING)[0]])
    window = _window(ann, begun, seconds)
    T, force = ann.columns["period"][window], ann.columns["force"][window, 0, 0]
    way = place[window][-1] - place[window][0]
    others = np.interp(ann.time[window], ben.time[ben.states["state_row"]], ben.states["position"][:, 0, 0])
    damping = [_damping(one, _window(one, begun, seconds)) for one in (ann, ben)]
    return Felt(
        law=law,
        # Who ended second has no link any more.
        saved=next((float(link["saved"]) for status in last for link in status["links"]), 0.0),
        felt=float((T * force)[1:].sum() / way),
        predicted=_predicted(law, damping),
        said=said,
        apart=float(np.abs(place[window] - others).max()),
        late=last[0]["missed"] / last[0]["steps"],
    )


def _window(recording: Recording, begun: float, seconds: float) -> npt.NDArray[np.bool_]:
    """Steps that count."""
    return (recording.time >= begun) & (recording.time < begun + seconds)


def _damping(recording: Recording, window: npt.NDArray[np.bool_]) -> float:
    """B_i in force, on the average of the steps that count [Ns/m]."""
    damping = np.zeros(recording.steps)
    for setup, span in recording.setup_rows():
        damping[span] = setup.local_damping[0]
    return float(np.average(damping[window], weights=recording.columns["period"][window]))


def _predicted(law: str, damping: list[float]) -> float:
    """What the linear prediction says for the emulated network, and the damping that was in force."""
    if law_named(law).dragless:
        return OWN + sum(damping)
    scenario = SessionFile.from_toml(TWO).scenario.replace(
        synchronisation={"law": "spring", "damping": damping}, hands=[]
    )
    return float(impedance(scenario, 1, frequencies=[0.05], measured=False).attrs["predicted_drag"])


def rows(found: list[Felt]) -> list[Row]:
    """Rows of the table.

    Args:
        found: of law spring, and of others.
    """
    spring = found[0]
    result: list[Row] = []
    for one in found:
        said = " and ".join(
            f"{value:.2f} {how}"
            for value, how in zip(one.said, ("measured", "predicted"), strict=True)
            if value is not None
        )
        note = (
            f"predicted {one.predicted:.2f} Ns/m; {OWN:g} of both is the body's own; off by {100 * one.off:+.1f} %; "
            f"members say of the law alone: {said or 'nothing'}; copies {1e3 * one.apart:.1f} mm apart at most; "
            f"{100 * one.late:.1f} missed steps for 100 taken"
        )
        how = f"{one.law}, codec" if one.saved else one.law
        if one.saved:
            note += f"; the codec saved {100 * one.saved:.0f} % of the bytes"
        result.append(
            Row("laws live", f"drag that a hand feels, law {how}", f"{one.felt:.2f} Ns/m", "within 15 %", note)
        )
    for one in found:
        if one.law == "spring":
            continue
        share = (one.felt - OWN) / (spring.felt - OWN)
        how = f"{one.law}, codec," if one.saved else one.law
        what = f"drag of law {how} relative to the rule's, without the body's"
        result.append(Row("laws live", what, f"{share:.3f}", "≤ 0.25", "two processes, 25 ± 10 ms, 5 % lost, 50 N/m"))
    return result


def measure(seconds: float = SECONDS) -> list[Row]:
    """Springs, `paid` and `wave`; the first two also through a perceptual codec.

    Args:
        seconds: that count, of each.
    """
    found: list[Felt] = []
    for law, codec in (("spring", False), ("paid", False), ("wave", False), ("spring", True), ("paid", True)):
        with tempfile.TemporaryDirectory() as folder:
            found.append(measure_drag(law, seconds, Path(folder), codec=codec))
    return rows(found)


if __name__ == "__main__":
    command(measure, __doc__)
