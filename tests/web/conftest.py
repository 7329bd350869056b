"""What tests of the page's surroundings begin with."""

from collections.abc import Generator

import pytest
from playwright.sync_api import Browser
from tests.simulation.browser import FLAT, browser
from tests.web.shell_pages import World, world


@pytest.fixture(scope="module")
def running() -> Generator[Browser]:
    """A browser that draws without a simulated graphics card: no picture in space, but all around it."""
    with browser(FLAT) as one:
        yield one


@pytest.fixture
def here(running: Browser) -> Generator[World]:
    """A session of made-up motion in one dimension."""
    with world(running) as made:
        yield made
