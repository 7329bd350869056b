"""The report of a comparison in a real browser."""

from collections.abc import Generator
from pathlib import Path

import pytest
from playwright.sync_api import Browser
from tests.simulation.browser import FLAT, browser

from cotouch.laboratory import Study, compare, write_report


@pytest.fixture(scope="module")
def running() -> Generator[Browser]:
    with browser(FLAT) as one:
        yield one


def test_it_opens_offline_with_losing_cases_first_and_tables_coloured(running: Browser, tmp_path: Path) -> None:
    whole = Study.make(
        laws=[{"name": "rule", "law": "spring"}, "wave"],
        networks=[{"name": "near", "delay": 0.005}, {"name": "far", "delay": 0.1}],
        tasks=["carry"],
        draws=2,
        duration=4.0,
        tuning={"search": 0, "local": 0},
        ours="rule",
        felt=False,
    )
    place = write_report(compare(whole, jobs=1), tmp_path / "report.html")
    wrong: list[str] = []
    with running.new_context(offline=True, viewport={"width": 420, "height": 800}) as context:
        page = context.new_page()
        page.on("console", lambda said: wrong.append(said.text))
        page.on("pageerror", lambda error: wrong.append(str(error)))
        page.on("requestfailed", lambda request: wrong.append(request.url))
        page.goto(place.as_uri())
        titles = page.locator("h2").all_inner_texts()
        lost = page.locator("section", has=page.locator("h2")).first.locator("tbody tr").all_inner_texts()
        colours = page.locator("tbody .level").evaluate_all(
            "all => all.map(one => [one.innerText, getComputedStyle(one).backgroundColor])"
        )
        wide, tall = page.evaluate("[document.documentElement.scrollWidth, document.documentElement.scrollHeight]")
    assert wrong == []
    assert "Where rule loses" in titles[0]
    assert "Cost with 2 users" in titles[1]
    assert lost
    assert all("wave" in row for row in lost)
    # Of different levels, so that a glance tells; none is left blank.
    assert len({colour for _, colour in colours}) >= 3
    assert "rgba(0, 0, 0, 0)" not in {colour for _, colour in colours}
    assert wide <= 420
    assert tall > 1000
