"""A real browser without a window, for what is written as a page."""

import io
import os
import shutil
import tempfile
from collections.abc import Generator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
from PIL import Image
from playwright.sync_api import Browser, Page, sync_playwright

# The first has no windows and takes half of what the others take.
NAMES = ("chromium-headless-shell", "chromium", "chromium-browser", "google-chrome")
# WebGL in software, as the machine that tests has no graphics card; all else is drawn as if nobody had one, which is
# many times as fast.
DRAWN = [
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    "--disable-gpu-rasterization",
    "--disable-accelerated-2d-canvas",
]
FLAT = ["--disable-gpu"]
# Eight pictures a second are enough where none is counted. Sixty, without a graphics card, took a core and a half for
# as long as a page was open.
UNHURRIED = """{
  const draw = window.requestAnimationFrame.bind(window), drop = window.cancelAnimationFrame.bind(window);
  const waiting = new Map(), drawing = new Map();
  let last = 0;
  window.requestAnimationFrame = (then) => {
    const id = ++last;
    waiting.set(id, setTimeout(() => {
      waiting.delete(id);
      drawing.set(id, draw((now) => { drawing.delete(id); then(now); }));
    }, 120));
    return id;
  };
  window.cancelAnimationFrame = (id) => {
    clearTimeout(waiting.get(id));
    if (drawing.has(id)) drop(drawing.get(id));
    waiting.delete(id);
    drawing.delete(id);
  };
}"""
# The first picture of a slow machine takes its time; nothing waits longer than it must.
PATIENCE = 60_000


@contextmanager
def _modest(program: str) -> Generator[str]:
    """The same browser, which cannot put itself above others: as nobody but root's could where people use it."""
    without = shutil.which("setpriv")
    if os.geteuid() != 0 or without is None:
        yield program
        return
    with tempfile.TemporaryDirectory() as place:
        script = Path(place) / "browser"
        script.write_text(f'#!/bin/sh\nexec {without} --bounding-set=-sys_nice --inh-caps=-sys_nice {program} "$@"\n')
        script.chmod(0o700)
        yield str(script)


@contextmanager
def browser(args: Sequence[str] = DRAWN) -> Generator[Browser]:
    """Debian's chromium; skips the test where there is none.

    Args:
        args: how it draws. A page without WebGL is drawn many times faster with `FLAT`.
    """
    program = next(filter(None, map(shutil.which, NAMES)), None)
    if program is None:
        pytest.skip("no chromium on this machine; `make browser` installs it where apt and root are available")
    with _modest(program) as modest, sync_playwright() as playwright:
        running = playwright.chromium.launch(executable_path=modest, args=list(args))
        try:
            yield running
        finally:
            running.close()


class Opened:
    """A page with everything it asked for and complained about."""

    def __init__(self, running: Browser, path: Path, **settings: Any) -> None:
        self.complaints: list[str] = []
        self.requests: list[str] = []
        script = settings.pop("script", None)
        context = running.new_context(**{"viewport": {"width": 1280, "height": 720}, **settings})
        context.set_default_timeout(PATIENCE)
        context.add_init_script(UNHURRIED)
        self.page: Page = context.new_page()
        self.page.on("console", lambda message: self.complaints.append(f"{message.type}: {message.text}"))
        self.page.on("pageerror", lambda error: self.complaints.append(str(error)))
        self.page.on("request", lambda request: self.requests.append(request.url))
        if script:
            self.page.add_init_script(script)
        self.page.goto(path.as_uri())

    def ready(self) -> "Opened":
        self.page.wait_for_selector("#notice", state="hidden")
        self.page.wait_for_selector("#chart[aria-valuemax]")  # the first picture was drawn
        return self

    def state(self, name: str) -> Any:
        return self.page.evaluate("name => window.cotouch.state[name]", name)

    def until(self, name: str, value: object) -> None:
        """Waits until the page's state says so."""
        self.page.wait_for_function("([name, value]) => window.cotouch.state[name] === value", arg=[name, value])

    def picture(self, selector: str = "#stage") -> npt.NDArray[np.float64]:
        """What is seen there after the next frame is drawn, (height, width, 3), 0 to 255."""
        self.page.evaluate("() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))")
        data = self.page.locator(selector).screenshot()
        return np.asarray(Image.open(io.BytesIO(data)).convert("RGB"), dtype=np.float64)
