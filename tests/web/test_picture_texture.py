"""The texture of a session on the skin that the page draws: where contact has it, lit from where the light is."""

import io
from collections.abc import Generator
from dataclasses import replace

import numpy as np
import pytest
from PIL import Image
from playwright.sync_api import Browser, Page
from tests.simulation.browser import browser
from tests.web.pictures import shown, until

from cotouch.scenario import TextureTable

LENGTH, HEIGHT, ANGLE = 0.02, 0.001, 1.3
RIDGES = TextureTable(pattern="ridges", wavelength=LENGTH, height=HEIGHT, angle=ANGLE, projection="y").drawn()
KEY = np.array([-0.45, 0.8, 0.55])  # of the page's light, in the eye's axes
# Pixels of the page's own copy, and the places of the skin there.
SEEN = """() => {
  const { space, orbit } = window.cotouch.stage.probe();
  const frame = document.querySelector(".ct-canvas").getBoundingClientRect();
  const found = [];
  for (let x = 4; x < frame.width; x += 6)
    for (let y = 4; y < frame.height; y += 6) {
      const hit = space.pick(x, y, 0);
      if (hit) found.push([x + frame.left, y + frame.top, ...hit.surface.toArray()]);
    }
  return [found, orbit.camera.matrixWorldInverse.toArray()];
}"""


@pytest.fixture(scope="module")
def running() -> Generator[Browser]:
    with browser() as one:
        yield one


def bright(page: Page) -> np.ndarray:
    """How bright each pixel of the page is, (height, width)."""
    return np.asarray(Image.open(io.BytesIO(page.screenshot())).convert("L"), dtype=np.float64)


def test_ridges_are_where_contact_has_them_and_lit_by_the_light(running: Browser) -> None:
    pictures: list[np.ndarray] = []
    for texture in (None, RIDGES):
        with shown(running, texture=texture) as here:
            page = here.open()
            page.evaluate("() => window.cotouch.store.set({ colour: 'plain', ghosts: false })")
            until(page, "stats.frames > 3")
            found, flat = page.evaluate(SEEN)
            pictures.append(bright(page))
    seen = np.array(found)
    seen = seen[seen[:, 3] < 0.02]  # the side that is seen, away from the rim
    x, y = seen[:, 0].astype(int), seen[:, 1].astype(int)
    along = np.array([np.cos(ANGLE), 0.0, np.sin(ANGLE)])
    phase = 2.0 * np.pi * (seen[:, 2:] @ along) / LENGTH
    model = np.stack([np.cos(phase), np.sin(phase), np.ones(phase.size)], axis=1)
    brighter = (pictures[1] - pictures[0])[y, x]
    (slope, height, _), left, _, _ = np.linalg.lstsq(model, brighter, rcond=None)
    up = (np.array(flat).reshape(4, 4).T[:3, :3] @ along) @ KEY
    assert seen.shape[0] > 300
    assert up > 0.5
    assert slope < -4.0  # what rises the way that the light comes from looks away from it
    assert height > 4.0  # hollows are darker
    assert left[0] < 0.4 * ((brighter - brighter.mean()) ** 2).sum()


def test_what_could_not_be_drawn_is_left_out(running: Browser) -> None:
    assert RIDGES is not None
    with shown(running, texture=replace(RIDGES, size=(1e-12, 1.0))) as here:
        page = here.open()
        until(page, "store.scene.texture === null && stats.frames > 2")
