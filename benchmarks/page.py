"""The page: frames and bytes a second, its server's share of a core, from a pointer to Python, from start to frame.

The page is a process of its own that reads, acknowledges and points as a browser does. Copies are made beforehand and
shown one after the other, so that what is measured is the server and not who makes them. Then the demonstration as
users start it: what a page costs its process and its members' deadlines; and a browser. Some three and a half minutes.
"""

import contextlib
import json
import math
import os
import shutil
import signal
import struct
import subprocess
import sys
import time
from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any, cast

import numpy as np
import psutil

from benchmarks._report import Row, command
from cotouch.observers import CopyView, Overview, Pointer, Scene
from cotouch.web import PageServer

SECONDS = 8.0
KEPT = 64  # views of each copy
STEPS = 500.0  # a second
GOAL = {"3d": "≤ 10 %", "big": ""}
# A screen without a browser: pictures a second, and how long before one of them a frame is asked for [s].
SCREEN, LEAD = 60.0, 0.004
_HELLO = {"type": "hello", "version": 1, "want": "all", "rate": 60, "slot": 0}


class _Played:
    """A stage that shows what was made beforehand; notes when pointers came."""

    def __init__(self, kind: str) -> None:
        from tests.web.fake_session_api import FakeSessionApi, Kind

        now = [0.0]
        made = FakeSessionApi(cast("Kind", kind), clock=lambda: now[0])
        self.scene: Scene = made.scene
        self._kept: list[Mapping[int, CopyView]] = []
        for _ in range(KEPT):
            now[0] += 0.05
            self._kept.append(made.views())
        self._overview: Overview = made.overview()
        self.late: list[float] = []
        self._received = 0

    def views(self) -> Mapping[int, CopyView]:
        now = time.monotonic()
        views = self._kept[int(now * STEPS) % KEPT]
        return {slot: replace(view, time=now, received=self._received) for slot, view in views.items()}

    def overview(self) -> Overview:
        return self._overview

    def point(self, slot: int, pointer: Pointer) -> None:
        del slot
        # The page puts the time of its event, on the clock of this machine, where the target's places are.
        sent = pointer.target[0] * 1000.0 + pointer.target[1]
        self.late.append(time.monotonic() % 1000.0 - sent if sent else 0.0)
        self._received = pointer.number

    def do(self, what: str, arguments: Mapping[str, Any]) -> str:
        del arguments
        return what

    def recorded(self) -> bytes | None:
        return None


def visit(address: str, token: str, seconds: float, pointing: float, timed: bool = True) -> dict[str, Any]:
    """A page without a browser: what it saw.

    Args:
        address: of the page.
        token: of the server.
        seconds: how long.
        pointing: pointers a second; 0: none.
        timed: whether their places say when they were sent, for a stage that reads it there.
    """
    from websockets.sync.client import connect

    began = time.monotonic()
    frames, size, waits, shows, first, copies = 0, 0, [], [], 0.0, 0
    when: dict[int, float] = {}
    state: dict[str, Any] = {}
    own = address.rstrip("/")
    with connect(
        own.replace("http", "ws") + "/ws", origin=own, compression=None, max_size=None, max_queue=None
    ) as page:
        page.send(json.dumps(_HELLO | {"token": token}))
        number, due, seen = 0, began + 0.5, 0
        rng = np.random.default_rng(0)
        end = began + seconds
        while (now := time.monotonic()) < end:
            if pointing and now >= due:
                # At any time between two pictures, as hands move.
                number, due = number + 1, max(due + rng.uniform(0.5, 1.5) / pointing, now)
                when[number] = now
                part = time.monotonic() % 1000.0
                x = np.float32(int(part) / 1000.0)  # the rest goes into y, so that single precision is enough
                y = np.float32(part - float(x) * 1000.0)
                if not timed:
                    x, y = np.float32(0.02), np.float32(0.02)
                action = 0 if timed else 1  # a ball's place is told as it is, that of a grab as its node's
                page.send(
                    struct.pack(
                        "<BBBBII3fffd3f", 2, 0, action, 0, number, 0, x, y, 0.0, 0.0, 0.0, 1e3 * now, 0.0, 0.0, 0.0
                    )
                )
            try:
                message = page.recv(max(min(due, end) - time.monotonic(), 0.0) if pointing else 1.0)
            except TimeoutError:
                continue
            if isinstance(message, str):
                commanded = json.loads(message)
                state = commanded if commanded["type"] == "state" else state
            else:
                if not first:
                    first = time.monotonic() - began
                came = time.monotonic()
                wait = _picture(came + LEAD) - LEAD - came
                page.send(struct.pack("<B3xIff", 3, struct.unpack_from("<I", message, 4)[0], 1e3 * wait, 1e3 / SCREEN))
                frames, size, copies = frames + 1, size + len(message), struct.unpack_from("<H", message, 2)[0]
                echo, waited = struct.unpack_from("<II", message, 24)
                if echo > seen:
                    shows += [_picture(came) - when[k] for k in range(seen + 1, echo + 1)]
                    seen = echo
                    waits.append(1e-6 * waited)
    return {
        "shows": shows,
        "copies": copies,
        "first": first,
        "frames": frames / seconds,
        "bytes": size / seconds,
        "waits": waits,
    } | {
        "late": [
            sum(member.get(name) or 0 for member in state.get("members", {}).values()) for name in ("missed", "steps")
        ],
        "coupled": bool(state.get("ends")) and all(end["state"] == "coupled" for end in state["ends"].values()),
        "planned": {"best", "worst"} <= state.get("choices", {}).keys(),
    }


def _picture(time: float) -> float:
    """When the next picture is."""
    return math.ceil(time * SCREEN) / SCREEN


def _page(server: PageServer, pointing: float = 0.0, seconds: float = SECONDS) -> dict[str, Any]:
    return _visitor(server.address, server.token, seconds, pointing, timed=True)


def _visitor(address: str, token: str, seconds: float, pointing: float, *, timed: bool) -> dict[str, Any]:
    asked = json.dumps([address, token, seconds, pointing, timed])
    done = subprocess.run(
        [sys.executable, "-m", "benchmarks.page", "--visit"],
        input=asked, capture_output=True, text=True, check=True, timeout=seconds + 60.0,
    )  # fmt: skip
    return json.loads(done.stdout)


def served() -> list[Row]:
    """Against copies that are made beforehand."""
    rows: list[Row] = []
    for kind, what in (("3d", "5 copies of 1,924 points"), ("big", "5 copies of 20,002 points")):
        api = _Played(kind)
        started = time.perf_counter()
        with PageServer(api, port=0) as server:
            ready = time.perf_counter() - started
            before = time.process_time()
            time.sleep(3.0)
            idle, before = (time.process_time() - before) / 3.0, time.process_time()
            found = _page(server)
            used = (time.process_time() - before) / SECONDS
            late = _page(server, 60.0)
        seconds = np.array([x for x in api.late if x > 0.0])
        rows += [
            Row("page", f"{what}: frames a second", f"{found['frames']:.1f}", "≥ 55" if kind == "3d" else "≥ 30",
                f"{found['bytes'] / 1e6:.2f} MB/s; {load()}"),
            Row("page", f"{what}: server's share of a core, one page", f"{100.0 * used:.1f} %", GOAL[kind],
                f"{100.0 * idle:.2f} % while nobody watches; CPU time of its process"),
            Row("page", f"{what}: from pointer to Python, p50 / p99", _times(seconds), "p50 ≤ 3 ms",
                f"{seconds.size} pointers, 60 a second; {load()}"),
            Row("page", f"{what}: from pointer to the picture that shows it, p50 / p99",
                _times(np.array(late["shows"])),
                "≤ 16 ms" if kind == "3d" else "", "of a screen of 60 Hz, without drawing; the copy answers at once"),
            Row("page", f"{what}: server ready, then first frame to a page", f"{1e3 * ready:.0f} ms, "
                f"{1e3 * found['first']:.0f} ms", "≤ 1 s", "the page connects, greets and gets scene and frame"),
        ]  # fmt: skip
    return rows


def demonstration() -> list[Row]:
    """Against the demonstration as users start it: a process for each of five users."""
    with _demo() as (process, address, token):
        spans: dict[str, tuple[float, float]] = {}
        found: dict[str, Any] = {}

        def span(name: str, action: Callable[[], Any]) -> None:
            """What it takes: share of a core of the demonstration, share of its members' steps that came late."""
            late, start, came = _late(address, token), _times_of(process), time.monotonic()
            found[name] = action()
            used = (_times_of(process) - start) / (time.monotonic() - came)
            after = _late(address, token)
            spans[name] = (used, (after[0] - late[0]) / max(after[1] - late[1], 1))

        span("none", lambda: time.sleep(SECONDS))
        span("page", lambda: _visitor(address, token, SECONDS, 60.0, timed=False))
        span("browser", lambda: _looked_at(f"{address}#token={token}", SECONDS))
    visited = found["page"]
    (alone, before), (used, during), (_, drawn) = spans["none"], spans["page"], spans["browser"]
    browser = (
        f"{100.0 * drawn:.2f} % with a browser that draws {found['browser']:.0f} pictures a second by the processor"
    )
    return [
        Row("page", "demonstration, five users, soft body: frames a second", f"{visited['frames']:.1f}", "≥ 55",
            f"{visited['bytes'] / 1e6:.2f} MB/s, 60 pointers a second; {load()}"),
        Row("page", "demonstration: share of a core that one page takes", f"{100.0 * (used - alone):.1f} %", "≤ 10 %",
            f"its process with one page {100.0 * used:.1f} %, with none, as the session's host, {100.0 * alone:.1f} %"),
        Row("page", "demonstration: members' missed steps, with one page and with none",
            f"{100.0 * during:.2f} %, {100.0 * before:.2f} %", "alike",
            f"{browser if found['browser'] else 'no browser'}; {load()}"),
        Row("page", "demonstration: from pointer to the picture whose copy has used it, p50 / p99",
            _times(np.array(visited["shows"])), "≤ 16 ms",
            f"of a screen of 60 Hz, without drawing; {len(visited['shows'])} pointers; mailboxes and a step between"),
    ]  # fmt: skip


def _late(address: str, token: str) -> list[int]:
    """Steps of all members that came late, and all their steps, as they said last."""
    return _visitor(address, token, 1.2, 0.0, timed=False)["late"]


def _looked_at(url: str, seconds: float) -> float:
    """Pictures a second that a browser draws of it; 0 where there is none."""
    with _chromium() as running:
        if running is None:
            return 0.0
        page = running.new_page(viewport={"width": 900, "height": 500})
        page.goto(url)
        page.wait_for_function("() => window.cotouch && window.cotouch.stats.frames > 30", timeout=120_000)
        return _rate(page, seconds)


@contextlib.contextmanager
def _demo() -> Any:
    arguments = [
        sys.executable,
        "-m",
        "cotouch",
        "demo",
        "--body",
        "soft",
        "--duration",
        "240",
        "--page",
        "--headless",
        "--port",
        "0",
    ]
    process = subprocess.Popen(arguments, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    assert process.stderr is not None
    try:
        line = next(line for line in process.stderr if "the page is at" in line)
        address, _, token = line.split()[-1].partition("#token=")
        # Where kernels have to compile, that takes a minute or two; then all are coupled, and the best links are found.
        for _ in range(90):
            seen = _visitor(address, token, 2.0, 0.0, timed=False)
            if seen["copies"] == 5 and seen["coupled"] and seen["planned"]:
                break
        yield process, address, token
    finally:
        process.send_signal(signal.SIGTERM)
        with contextlib.suppress(subprocess.TimeoutExpired):
            process.wait(30)
        process.kill()
        process.wait()


def _times_of(process: "subprocess.Popen[str]") -> float:
    used = psutil.Process(process.pid).cpu_times()
    return used.user + used.system


def _times(seconds: np.ndarray) -> str:
    if not seconds.size:
        return "none came"
    low, high = np.quantile(seconds, [0.5, 0.99])
    return f"{1e3 * low:.1f} / {1e3 * high:.1f} ms"


def load() -> str:
    """What else the machine did."""
    return f"load {os.getloadavg()[0]:.1f} on {os.cpu_count()} cores"


# Without a graphics card a simulated one draws: only the picture is to be drawn by it, not the page around it.
_FLAGS = (
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    "--disable-gpu-rasterization",
    "--disable-accelerated-2d-canvas",
)
# Wide windows, where the processor's drawing is the limit, and one so small that it hardly is.
_CASES = (
    ("3d", "1,924", "≥ 55", 1280, 720),
    ("3d", "1,924", "≥ 55", 900, 500),
    ("3d", "1,924", "≥ 55", 390, 400),
    ("big", "20,002", "≥ 30", 900, 500),
    ("big", "20,002", "≥ 30", 390, 400),
)
# What else a shared machine does in a run makes it slower and never faster.
_RUNS = 5


@contextlib.contextmanager
def _apart(kind: str, static: Path | None) -> Any:
    """Serves copies that are made beforehand in a process of its own, as sessions do; this one moves the browser."""
    arguments = [sys.executable, "-m", "benchmarks.page", "--serve", kind, *([] if static is None else [str(static)])]
    process = subprocess.Popen(arguments, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
    assert process.stdin is not None
    assert process.stdout is not None
    try:
        yield process.stdout.readline().strip()
    finally:
        process.stdin.close()
        process.wait(30)


def serve(kind: str, static: str | None = None) -> None:
    """Says where it serves, and does until its input ends."""
    with PageServer(_Played(kind), port=0, static=None if static is None else Path(static)) as server:
        print(server.url, flush=True)
        sys.stdin.read()


@contextlib.contextmanager
def _chromium() -> Any:
    program = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
    if program is None:
        yield None
        return
    from playwright.sync_api import sync_playwright

    with sync_playwright() as playwright:
        running = playwright.chromium.launch(executable_path=program, args=list(_FLAGS))
        try:
            yield running
        finally:
            running.close()


def _rate(page: Any, seconds: float) -> float:
    """Mesh updates a second."""
    before = page.evaluate("() => [window.cotouch.stats.frames, performance.now()]")
    page.wait_for_timeout(1e3 * seconds)
    after = page.evaluate("() => [window.cotouch.stats.frames, performance.now()]")
    return 1e3 * (after[0] - before[0]) / (after[1] - before[1])


def _drags(page: Any, *, whole: bool) -> np.ndarray:
    """From a pointer's event to a picture whose copy has used it [s].

    Args:
        page: that shows it.
        whole: whether to the picture's last pixel; else until it was handed over to whoever draws.
    """
    page.evaluate("on => { const s = window.cotouch.stats; s.finishing = on; s.dragToMesh.length = 0; }", whole)
    picture = page.locator("canvas").first.bounding_box()
    x, y = picture["x"] + 0.5 * picture["width"], picture["y"] + 0.5 * picture["height"]
    page.mouse.move(x, y)
    page.mouse.down()
    rng = np.random.default_rng(0)  # at any time between two pictures, as hands move
    for k in range(100):
        page.mouse.move(x + k % 60, y + k % 40)
        page.wait_for_timeout(float(rng.uniform(8.0, 40.0)))
    page.mouse.up()
    return np.array(page.evaluate("() => window.cotouch.stats.dragToMesh")) / 1e3


def in_browser(static: Path | None = None) -> list[Row]:
    """In chromium, which draws without a graphics card here: what the page itself says of its frames and drags."""
    rows: list[Row] = []
    with _chromium() as running:
        if running is None:
            return [Row("page", "in a browser", "not measured", "", "no chromium on this machine")]
        for kind, what, goal, wide, high in _CASES:
            with _apart(kind, static) as url:
                page = running.new_page(viewport={"width": wide, "height": high})
                page.goto(url)
                page.wait_for_function("() => window.cotouch && window.cotouch.stats.frames > 30", timeout=120_000)
                page.wait_for_timeout(4_000)  # until it is as coarse as it has to be
                rate = _rate(page, 6.0)
                runs = sorted((_drags(page, whole=False) for _ in range(_RUNS)), key=np.median)
                handed, whole = runs[0], _drags(page, whole=True)
                size, ratio = page.evaluate(
                    "() => { const c = document.querySelector('.ct-canvas'), b = c.getBoundingClientRect();"
                    " return [`${c.width} × ${c.height}`, c.width / b.width]; }"
                )
                page.close()
            named = f"browser, {wide} × {high}, {what} points"
            rows += [
                Row("page", f"{named}: mesh updates a second", f"{rate:.1f}", goal,
                    f"chromium, drawn by the processor in {size} pixels, {ratio:.2g} of the page's; {load()}"),
                Row("page", f"{named}: drag to mesh handed over, p50 / p99", _times(handed),
                    "≤ 16 ms" if kind == "3d" else "",
                    f"{handed.size} drags, the least disturbed of {_RUNS} runs, p50 of all: "
                    f"{', '.join(f'{1e3 * np.median(run):.1f}' for run in runs)}; until all pixels are drawn "
                    f"{_times(whole)}"),
            ]  # fmt: skip
    return rows


def measure() -> list[Row]:
    return [*served(), *demonstration(), *in_browser()]


if __name__ == "__main__":
    if "--visit" in sys.argv:
        print(json.dumps(visit(*json.loads(sys.stdin.read()))))
    elif "--serve" in sys.argv:
        serve(*sys.argv[sys.argv.index("--serve") + 1 :])
    else:
        command(measure, cast("str", __doc__))
