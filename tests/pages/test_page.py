import math
import re

import pytest
from matplotlib.figure import Figure

from cotouch import drawing
from cotouch.pages import Section, formula, num, page, quantity, svg, table, verdict


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (0.0, "0"),
        (2.594, "2.59"),
        (-1.4285524, "−1.43"),
        (0.9996, "1.00"),
        (12345.0, "12345"),
        (2.2188e-7, "2.22 × 10<sup>−7</sup>"),
        (-3.2e12, "−3.20 × 10<sup>12</sup>"),
        (1e-6, "10<sup>−6</sup>"),
        (math.inf, "∞"),
        (math.nan, "–"),
        (None, "–"),
    ],
)
def test_numbers(value: float | None, text: str) -> None:
    assert num(value) == text


def test_number_and_unit_stay_together() -> None:
    assert quantity(2.5, "N", 2) == "2.5&nbsp;N"
    assert quantity(2.5, "", 2) == "2.5"
    assert quantity(None, "N") == "–"


def test_table_cells_are_words_or_numbers() -> None:
    made = table(["what", "how much"], [["a", "1"], ["b", "2"]], kind="dense")
    assert made.count("<tr>") == 3
    assert made.count('class="text"') == made.count('class="number"') == 3
    assert 'class="dense"' in made


def test_verdict_says_it_in_words_too() -> None:
    assert verdict(holds=True) == '<span class="verdict yes">✓ holds</span>'
    assert verdict(holds=False) == '<span class="verdict no">✗ fails</span>'


def test_formula_is_escaped_and_lowered() -> None:
    assert formula("|x_i − x_d| < K_ext") == "|x<sub>i</sub> − x<sub>d</sub>| &lt; K<sub>ext</sub>"


def drawn() -> Figure:
    with drawing.style():
        figure = drawing.sheet(2.0)
        axes = figure.subplots()
        axes.plot([0.0, 1.0], [0.123456, 2.0], color=drawing.USERS[0])
        axes.set(title="0.123456 of x_d", ylabel="Force / N")
        return figure


def test_drawing_is_the_same_in_every_run() -> None:
    assert svg(drawn(), "a") == svg(drawn(), "a")


def test_two_drawings_share_no_ids() -> None:
    assert 'id="a-' in svg(drawn(), "a")
    assert 'id="a-' not in svg(drawn(), "b")


def test_drawing_takes_colours_and_letters_from_the_page() -> None:
    text = svg(drawn(), "a")
    assert "var(--user-1)" in text
    assert "var(--ink)" in text
    assert "font-family" not in text
    assert "font-weight: 700; font-size: 8.5px" in text
    assert "xmlns" not in text


def test_only_coordinates_are_rounded() -> None:
    text = svg(drawn(), "a")
    assert "0.123456 of x" in text
    assert ">d</tspan>" in text
    for shape in re.findall(r'\bd="([^"]+)"', text):
        assert not re.search(r"\.\d{3}", shape)


def test_page_escapes_titles() -> None:
    text = page(title="a < b", lead="<p>x</p>", sections=[Section(anchor="s", title="c & d", body="")], footer="")
    assert "<title>a &lt; b</title>" in text
    assert "c &amp; d" in text
    assert "$" not in text
