"""Photographs the first minute on the page, to be looked at: `python -m tests.web.take_pictures FOLDER`.

What is shown is the page's own test session, so that nobody waits for members; widths are those of a desk, a tablet and
a telephone, each light and dark.
"""

import io
import sys
from pathlib import Path

from PIL import Image
from playwright.sync_api import Page
from tests.simulation.browser import browser
from tests.web.fake_session_api import FakeSessionApi
from tests.web.pictures import PATIENCE, READY

from cotouch.web import PageServer

SIZES = {"1440": (1440, 900), "1024": (1024, 768), "390": (390, 844)}
LIVE = "!document.documentElement.hasAttribute('data-lost')"
SCHEMES = ("light", "dark")
# As finely drawn as where a graphics card draws, however long it takes here.
FINE = """() => {
  const { space } = window.cotouch.stage.probe();
  if (!space) return;
  Object.assign(space.quality, { level: 1, took: () => false });
  space.resize();
}"""


def main(folder: Path) -> None:
    """Three pictures of each: on arrival, with the tour's first step, and a while after the tour was refused.

    Args:
        folder: an existing one.
    """
    with browser() as running, PageServer(FakeSessionApi("3d"), port=0) as server:
        for name, (width, height) in SIZES.items():
            for scheme in SCHEMES:
                phone = width < 600
                context = running.new_context(
                    viewport={"width": width, "height": height},
                    color_scheme=scheme,
                    has_touch=phone,
                    is_mobile=phone,
                    reduced_motion="reduce",
                )
                context.set_default_timeout(PATIENCE)
                page = context.new_page()
                page.goto(server.url)
                page.wait_for_function(READY)
                page.wait_for_selector("#tour-offer")
                page.evaluate(FINE)
                for moment, action in (("arrival", None), ("tour", "Start"), ("after", None)):
                    if action is not None:
                        page.click(f"#tour-offer >> text={action}")
                    elif moment == "after":
                        page.keyboard.press("Escape")
                    page.wait_for_timeout(1500)
                    # A machine with much else to do may lose the connection for a moment.
                    page.wait_for_function(LIVE)
                    taken(page, folder / f"first-{moment}-{name}-{scheme}.webp")
                context.close()


def taken(page: Page, path: Path) -> None:
    """Keeps what is seen.

    Args:
        page: as it is.
        path: of the picture.
    """
    Image.open(io.BytesIO(page.screenshot())).convert("RGB").save(path, quality=80, method=6)


if __name__ == "__main__":
    main(Path(sys.argv[1]))
