"""Docstrings as the site reads them: `[i][j]` is an entry of a matrix, not a link."""

import re
from typing import Any

import griffe


class Entries(griffe.Extension):
    """Escapes brackets that Markdown would take for a reference."""

    def on_object(self, *, obj: griffe.Object, **kwargs: Any) -> None:
        """Called for every object of the package."""
        if obj.docstring:
            obj.docstring.value = re.sub(r"\[(\w)\]\[(\w)\]", r"\\[\1\\]\\[\2\\]", obj.docstring.value)
