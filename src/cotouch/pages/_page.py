"""Pieces of an HTML page: numbers, tables, verdicts, figures; everything in one file, nothing loaded from elsewhere."""

import io
import math
import re
from collections.abc import Sequence
from dataclasses import dataclass
from html import escape
from importlib.resources import files
from string import Template
from typing import TYPE_CHECKING, final

from cotouch import drawing

if TYPE_CHECKING:
    from matplotlib.figure import Figure

# From here up and from here down a number is written with a power of ten.
_LARGE, _SMALL = 1e5, 1e-3

# The figures' colours become the page's, so that they follow a dark page; see page.html.
_PAGE_COLORS = {
    drawing.INK: "ink",
    drawing.MUTED: "muted",
    drawing.GRID: "grid",
    drawing.SHADE: "shade",
    drawing.SURFACE: "surface",
    drawing.ALARM_COLOUR: "alarm",
    **{color: f"user-{number}" for number, color in enumerate(drawing.USERS, start=1)},
}


@final
@dataclass(frozen=True, kw_only=True)
class Section:
    """A chapter of the page.

    Attributes:
        anchor: its name in links.
        title: plain text.
        body: HTML.
    """

    anchor: str
    title: str
    body: str


def page(*, title: str, lead: str, sections: Sequence[Section], footer: str) -> str:
    """The whole page.

    Args:
        title: plain text.
        lead: HTML before the first section.
        sections: in order.
        footer: HTML.
    """
    template = Template(files("cotouch.pages").joinpath("page.html").read_text(encoding="utf-8"))
    entries = "".join(f'<li><a href="#{s.anchor}">{escape(s.title)}</a></li>' for s in sections)
    chapters = "\n".join(
        f'<section id="{s.anchor}"><h2><span class="count">{number}</span> {escape(s.title)}</h2>\n{s.body}\n</section>'
        for number, s in enumerate(sections, start=1)
    )
    colors = {name.replace("-", "_"): color for color, name in _PAGE_COLORS.items()}
    return template.substitute(
        title=escape(title), contents=entries, lead=lead, chapters=chapters, footer=footer, **colors
    )


def num(value: float | None, digits: int = 3) -> str:
    """A number as HTML, with a true minus and powers of ten; None is a dash.

    Args:
        value: the number.
        digits: significant ones.
    """
    if value is None or math.isnan(value):
        return "–"
    if math.isinf(value):
        return "∞" if value > 0 else "−∞"
    if value == 0.0:
        return "0"
    if _SMALL <= abs(value) < _LARGE:
        # Of the rounded value: 0.9996 to three digits is 1.00.
        size = math.floor(math.log10(abs(float(f"{value:.{digits - 1}e}"))))
        decimals = max(digits - 1 - size, 0)
        return f"{value:.{decimals}f}".replace("-", "−")
    mantissa, exponent = f"{value:.{digits - 1}e}".split("e")
    power = f"10<sup>{int(exponent)}</sup>".replace("-", "−")
    return power if float(mantissa) == 1.0 else f"{mantissa.replace('-', '−')} × {power}"


def quantity(value: float | None, unit: str, digits: int = 3) -> str:
    """A number with its unit, kept together on one line.

    Args:
        value: the number.
        unit: of it.
        digits: significant ones.
    """
    return f"{num(value, digits)}&nbsp;{unit}" if unit and value is not None else num(value, digits)


def formula(text: str) -> str:
    """Plain text as HTML, in which "_ext" is a subscript."""
    return re.sub(r"_(\w+)", r"<sub>\1</sub>", escape(text))


def verdict(*, holds: bool, yes: str = "holds", no: str = "fails") -> str:
    """A mark that says it in words too.

    Args:
        holds: whether it does.
        yes: words if so.
        no: words if not.
    """
    kind, mark, word = ("yes", "✓", yes) if holds else ("no", "✗", no)
    return f'<span class="verdict {kind}">{mark} {escape(word)}</span>'


def table(head: Sequence[str], rows: Sequence[Sequence[str]], *, text: Sequence[int] = (0,), kind: str = "") -> str:
    """A table of HTML cells; the columns in `text` are left-aligned, the others are numbers.

    Args:
        head: titles of the columns, HTML.
        rows: of cells, HTML.
        text: columns of words.
        kind: class of the table.
    """
    words = set(text)

    def line(tag: str, cells: Sequence[str]) -> str:
        inner = "".join(
            f'<{tag} class="{"text" if column in words else "number"}">{cell}</{tag}>'
            for column, cell in enumerate(cells)
        )
        return f"<tr>{inner}</tr>"

    body = "\n".join(line("td", row) for row in rows)
    name = f' class="{kind}"' if kind else ""
    return f'<div class="wide"><table{name}><thead>{line("th", head)}</thead>\n<tbody>\n{body}\n</tbody></table></div>'


def figure(drawn: "Figure", key: str, caption: str, description: str) -> str:
    """A figure with its caption (HTML) and a description for who cannot see it (plain text).

    Args:
        drawn: the figure.
        key: names it within the page; ids begin with it.
        caption: HTML.
        description: plain text.
    """
    return (
        f'<figure id="{key}"><div class="wide"><div class="drawing" role="img" aria-label="{escape(description)}">'
        f"{svg(drawn, key)}</div></div>\n<figcaption>{caption}</figcaption></figure>"
    )


def svg(drawn: "Figure", key: str) -> str:
    """A figure as SVG to be put into the page: its colours and letters follow the page's; ids start with `key`.

    Args:
        drawn: the figure.
        key: names it within the page; ids begin with it.
    """
    import matplotlib as mpl

    stream = io.StringIO()
    # Text stays text: it can be searched, and the page's fonts apply. The salt makes ids the same in every run.
    with mpl.rc_context({"svg.fonttype": "none", "svg.hashsalt": key}):
        drawn.savefig(stream, format="svg", metadata={"Date": None, "Creator": None, "Format": None, "Type": None})
    text = stream.getvalue()
    text = text[text.index("<svg") :]
    for pattern, replacement in (
        (r"(?s)<metadata>.*?</metadata>", ""),
        (r'\sxmlns(:\w+)?="[^"]*"', ""),
        (r"(?s)<!--.*?-->", ""),
        (r"(?s)<style[^>]*>.*?</style>", ""),
        (r'(id=")([^"]+)"', rf'\g<1>{key}-\g<2>"'),
        (r"url\(#([^)]+)\)", rf"url(#{key}-\g<1>)"),
        (r'xlink:href="#([^"]+)"', rf'href="#{key}-\g<1>"'),
    ):
        text = re.sub(pattern, replacement, text)
    text = re.sub(r"<svg[^>]*?viewBox=\"([^\"]+)\"[^>]*>", r'<svg viewBox="\g<1>" class="chart">', text, count=1)
    text = re.sub(r"<[^>]*>", lambda match: _lean(match[0]), text)
    text = re.sub(r">([^<>]*_[^<>]*)</text>", lambda match: f">{_lowered(match[1])}</text>", text)
    for color, name in _PAGE_COLORS.items():
        text = text.replace(color, f"var(--{name})")
    return text.strip()


def _lean(tag: str) -> str:
    """A tag without what the page decides (fonts) and without digits that nobody sees."""
    tag = re.sub(r"font(-family)?: (?:(\w+) )?(?:([\d.]+)px )?'[^;\"]*(; )?", _letters, tag)
    tag = re.sub(r' transform="rotate\(-?0 [^)]*\)"', "", tag)
    return re.sub(r"-?\d+\.\d{3,}", lambda match: f"{float(match[0]):.2f}".rstrip("0").rstrip("."), tag)


def _letters(match: re.Match[str]) -> str:
    weight = f"font-weight: {match[2]}; " if match[2] else ""
    return weight + (f"font-size: {match[3]}px; " if match[3] else "")


def _lowered(text: str) -> str:
    """Text of a drawing in which "_d" is a subscript."""
    return re.sub(r"_(\w+)", r'<tspan dy="1.6" font-size="75%">\1</tspan><tspan dy="-1.6">&#8203;</tspan>', text)
