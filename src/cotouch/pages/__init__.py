"""HTML reports in one file, nothing loaded from elsewhere."""

from cotouch.pages._page import Section, figure, formula, num, page, quantity, svg, table, verdict

__all__ = ["Section", "figure", "formula", "num", "page", "quantity", "svg", "table", "verdict"]
