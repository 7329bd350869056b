"""HTML reports in one file that loads nothing from elsewhere."""

from cotouch.pages._page import Section, figure, formula, num, page, quantity, svg, table, verdict

__all__ = ["Section", "figure", "formula", "num", "page", "quantity", "svg", "table", "verdict"]
