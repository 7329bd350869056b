"""Blocks of code in documents: what kind each is, and which commands it holds."""

import re
import shlex
import tomllib
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).parent.parent
PAGES = [
    *(ROOT / name for name in ("README.md", "ARCHITECTURE.md", "CONTRIBUTING.md", "page/README.md")),
    *sorted((ROOT / "docs").glob("*.md")),
    *sorted((ROOT / "src" / "cotouch").rglob("DESIGN.md")),
]
_FENCE = re.compile(r'^```(\w*)(?: title="([^"]*)")?\n(.*?)^```', re.MULTILINE | re.DOTALL)
_INDENTED = re.compile(r"(?<=\n\n)(?:    .*\n(?:\n(?=    ))?)+", re.MULTILINE)
_COMMAND = re.compile(r"(?:[A-Z_]+=\S+ )*(?:cotouch|make|npm|source) ")


class Block(NamedTuple):
    """A block of a page.

    Attributes:
        kind: "python", "toml", "console", "math" or "text".
        title: name of the file that it is, or "".
        text: what it says.
    """

    kind: str
    title: str
    text: str


def blocks_of(page: Path) -> list[Block]:
    """All blocks of a page in their order, fenced or indented."""
    text = page.read_text(encoding="utf-8")
    found = [(match.start(), Block(match[1] or "text", match[2] or "", match[3])) for match in _FENCE.finditer(text)]
    bare = _FENCE.sub(lambda match: re.sub(r"[^\n]", "·", match[0]), text)
    for match in _INDENTED.finditer(bare):
        lines = re.sub(r"^    ", "", match[0], flags=re.MULTILINE)
        found.append((match.start(), Block(_kind(lines), "", lines)))
    return [block for _, block in sorted(found)]


def _kind(text: str) -> str:
    if _COMMAND.match(text) and "──" not in text:
        return "console"
    if re.search(r"^(?:from \S+ )?import ", text, re.MULTILINE):
        return "python"
    try:
        return "toml" if tomllib.loads(text) else "text"
    except tomllib.TOMLDecodeError:
        # One that begins as a table is meant as one, and whoever runs it finds out what is wrong.
        return "toml" if re.match(r"\[{1,2}[\w.-]+\]{1,2}\s*$", text, re.MULTILINE) else "text"


def commands_of(text: str) -> list[list[str]]:
    """Its commands as lists of words, without comments, explanations at the right, and variables before them."""
    found = list[list[str]]()
    for line in text.splitlines():
        if _COMMAND.match(line):
            words = shlex.split(re.split(r"\s{2,}", line)[0], comments=True)
            found.append([word for word in words if not re.match(r"[A-Z_]+=", word)])
    return found
