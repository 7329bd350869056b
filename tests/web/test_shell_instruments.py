"""Plots, energy, damping and recordings in the page."""

import csv
import io
import re
import zipfile

import pytest
from playwright.sync_api import Browser, Page
from tests.web.fake_session_api import Kind
from tests.web.shell_pages import World, words, world
from tests.web.shell_scripts import COLOURS, FEED


def test_plots_draw_and_hold_no_growing_memory(here: World) -> None:
    page = here.open()
    page.wait_for_function(f"() => ({COLOURS})().length === 3 && ({COLOURS})().every((n) => n > 6)")
    words(page, "#plots .chart:nth-child(2) .reading", r"^\d")
    session = page.context.new_cdp_session(page)

    def heap() -> float:
        session.send("HeapProfiler.collectGarbage")
        return session.send("Runtime.getHeapUsage")["usedSize"]

    assert page.evaluate(FEED, 20) <= 1300
    before = heap()
    page.evaluate(FEED, 40)
    # Whoever kept only a frame's objects would hold ten times as much.
    assert heap() - before < 2_000_000
    assert page.locator("#plots canvas").count() == 3


def test_frozen_plots_stand_still_and_are_saved(here: World) -> None:
    page = here.open()
    page.wait_for_function("() => window.cotouch.store.history.count > 20")
    page.keyboard.press("f")
    assert page.get_attribute("#freeze", "aria-pressed") == "true"
    with page.expect_download() as saved:
        page.click("#plots >> text=CSV")
    lines = saved.value.path().read_text().splitlines()
    heads = lines[0].split(",")
    assert heads[:2] == ["time_s", "displacement_x_m 1 Ann"]
    assert len(heads) == 1 + 3 * 5
    assert all(len(line.split(",")) == len(heads) for line in lines)
    shown = page.evaluate("() => document.querySelector('#plots .reading').textContent")
    page.wait_for_function("count => window.cotouch.store.frame.number > count + 10", arg=len(lines))
    assert page.evaluate("() => document.querySelector('#plots .reading').textContent") == shown
    with page.expect_download() as saved:
        page.click("#plots >> text=CSV")
    assert saved.value.path().read_text().splitlines() == lines
    with page.expect_download() as saved:
        page.click("#plots >> text=PNG")
    assert saved.value.path().read_bytes().startswith(b"\x89PNG")
    page.keyboard.press("f")
    words(page, "#freeze", "Freeze")


def saved_numbers(page: Page) -> dict[str, list[str]]:
    """What the plots are of, by heading."""
    with page.expect_download() as saved:
        page.click("#plots >> text=CSV")
    rows = list(csv.reader(saved.value.path().read_text().splitlines()))
    return {head: [row[i] for row in rows[1:]] for i, head in enumerate(rows[0])}


def test_what_is_plotted_and_saved_is_the_same_on_every_page(running: Browser) -> None:
    """Also where one of them saw more: once, the axis was that along which a page had seen most."""
    with world(running, "bare") as here:
        pages = [here.open(), here.open()]
        pages[1].evaluate(
            """() => {
                const { store } = window.cotouch, last = store.frame;
                const copies = last.copies.map((copy) => ({ ...copy, displacement: copy.displacement.map((_, i) =>
                    i % 3 === 2 ? 30000 : 0) }));
                store.drawn({ ...last, copies, time: last.time + 1e-5, received: performance.now() });
            }"""
        )
        for page in pages:
            words(page, "#plots figcaption strong", "^Displacement$")
            page.wait_for_function("() => window.cotouch.store.history.count > 30")
        for _ in range(20):  # each page has frames of its own; some are both's
            tables = [saved_numbers(page) for page in pages]
            if set(tables[0]["time_s"]) & set(tables[1]["time_s"]):
                break
        heads = [f"displacement_{axis}_m 1 Ann" for axis in "xyz"]
        assert set(heads) < tables[0].keys() == tables[1].keys()
        common = set(tables[0]["time_s"]) & set(tables[1]["time_s"])
        assert common
        for head in heads:
            one, other = (dict(zip(table["time_s"], table[head], strict=True)) for table in tables)
            differ = [time for time in common if one[time] != other[time]]
            assert len(differ) <= 1  # what one of them alone was shown
        here.complaints.clear()  # FLAT has no WebGL, which the picture in space says


def test_missed_steps_are_a_share_of_those_that_were_due(here: World, monkeypatch: pytest.MonkeyPatch) -> None:
    status = here.api.status
    monkeypatch.setattr(
        here.api, "status", lambda slot, roster: status(slot, roster).model_copy(update={"steps": 100, "missed": 300})
    )
    page = here.open()
    words(page, '.user[data-slot="0"] .metric', "^missed75\u202f%$")


def joules(words_: str) -> float:
    """A number with its prefix."""
    match = re.fullmatch(r"(−?[\d.]+)\u202f([kmµnp]?)J", words_.strip())
    assert match, words_
    scale = {"": 1.0, "k": 1e3, "m": 1e-3, "µ": 1e-6, "n": 1e-9, "p": 1e-12}[match[2]]
    return float(match[1].replace("−", "-")) * scale


def test_every_joule_is_somewhere(here: World) -> None:
    page = here.open()
    page.wait_for_function(
        "() => Object.values(window.cotouch.store.state.members).reduce((a, b) => a + (b.supplied ?? 0), 0) > 0.01"
    )
    rows = page.evaluate(
        """() => [...document.querySelectorAll('#energy tbody tr, #energy tfoot tr')].map(
            (row) => [...row.querySelectorAll('td')].map((cell) => Number(cell.textContent.replace('−', '-'))))"""
    )
    assert len(rows) == 6
    assert page.evaluate("() => document.querySelector('#energy thead th').textContent") == "mJ"
    # What each column is, and whether it comes or goes.
    heads = page.evaluate(
        "() => [...document.querySelectorAll('#energy thead th')].slice(1).map((one) => one.textContent)"
    )
    wanted = ["hands", "+ links", "+ start", "+ shares", "− damped", "− in copy", "= rest"]
    assert [" ".join(head.split()) for head in heads] == wanted
    for row in rows:
        hands, links, start, shared, damped, stored, left = row
        assert hands + links + start + shared - damped - stored == pytest.approx(0.0, abs=1.5)
        assert shared in {-2.0, -10.0}
        assert left == 0.0
    sums = page.evaluate("() => [...document.querySelectorAll('#energy .sum')].map((one) => one.textContent)")
    assert joules(sums[0]) == pytest.approx(joules(sums[1]), rel=1e-6)
    assert joules(sums[0]) > 0.01
    # The bars are filled.
    filled = page.evaluate(
        """() => [...document.querySelectorAll('.stack')].map((bar) =>
            bar.lastElementChild.getBoundingClientRect().right / bar.getBoundingClientRect().right)"""
    )
    assert all(0.99 < fraction < 1.01 for fraction in filled)
    page.click("#energy >> text=Count from now")
    page.wait_for_function("() => document.querySelector('#energy table').hasAttribute('data-initial')")
    # All of it is seen, also with the column that there is now.
    wide = page.evaluate(
        """() => {
            const one = document.querySelector('#energy .scroll');
            return [one.scrollWidth, one.clientWidth];
        }"""
    )
    assert wide[0] <= wide[1]


def test_damping_is_lowered_behind_a_warning_and_restored_with_one_click(here: World) -> None:
    other = here.open(here.server.address)
    page = here.open()
    page.click("#tab-margin")
    words(page, "#margin .law", "felt drag11.00\u202fN·s/m measured, predicted 10.0013 times what people notice")
    page.click("#lower")
    dialog = page.get_by_role("dialog", name="Lower the damping")
    assert "nothing keeps energy from growing" in (dialog.text_content() or "")
    # What is safe has the focus.
    assert page.evaluate("() => document.activeElement.textContent") == "Keep it as it is"
    page.keyboard.press("Enter")
    assert here.did("damping") == []
    page.click("#lower")
    dialog.get_by_role("button", name="Lower it").click()
    words(page, "#banner-damping", "lowered to 5\u202f%")
    words(page, "#verdict", "not guaranteed: Not safe")
    words(other, "#banner-damping", "lowered to 5\u202f%")
    page.click("#banner-damping >> text=Restore now")
    page.wait_for_selector("#banner-damping", state="hidden")
    assert here.did("damping") == [{"fraction": 0.05}, {"fraction": 1}]
    # Where the button was is no other that does something, and everybody is told that it is over.
    words(other, "#banner-restored", "Full damping is restored")
    page.click("#banner-restored >> text=Dismiss")
    page.wait_for_selector("#banner-restored", state="hidden")
    assert here.did("damping") == [{"fraction": 0.05}, {"fraction": 1}]


@pytest.mark.parametrize(("kind", "usual", "least"), [("1d", "5 %", "0.1 %"), ("3d", "1 %", "0.1 %")])
def test_the_share_of_the_damping_begins_where_the_body_shakes(
    running: Browser, kind: Kind, usual: str, least: str
) -> None:
    with world(running, kind) as here:
        page = here.open()
        page.click("#tab-margin")
        page.click("#lower")
        slider = page.get_by_role("slider", name="Damping, as a share")
        assert slider.get_attribute("aria-valuetext") == f"{usual} of what is needed"
        slider.press("End")
        assert slider.get_attribute("aria-valuetext") == "95 % of what is needed"
        slider.press("Home")
        assert slider.get_attribute("aria-valuetext") == f"{least} of what is needed"
        page.get_by_role("button", name="Lower it").click()
        words(page, "#banner-damping", "lowered to 0.1\u202f%")
        assert here.did("damping") == [{"fraction": 0.001}]
        # FLAT has no WebGL, which the picture in space says.
        here.complaints.clear()


def test_a_recording_is_made_and_downloaded(here: World) -> None:
    page = here.open()
    assert page.is_hidden("#download")
    page.click("#record")
    words(page, "#record", r"^0:0\d$")
    page.keyboard.press("r")
    page.wait_for_selector("#download")
    with page.expect_download() as saved:
        page.click("#download")
    with zipfile.ZipFile(io.BytesIO(saved.value.path().read_bytes())) as archive:
        assert len(archive.namelist()) == 5
