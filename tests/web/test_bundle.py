"""The bundle in the package is what the sources make."""

import gzip
import hashlib
import re
from importlib.resources import files
from pathlib import Path

import pytest

PAGE = Path(__file__).parents[2] / "page"
STATIC = files("cotouch.web") / "static"
SERVED = ("index.html", "app.js", "app.css", "favicon.svg", "licences.txt")


def sources() -> list[str]:
    """As page/build.mjs lists them."""
    inside = [path.relative_to(PAGE).as_posix() for path in (PAGE / "src").rglob("*") if path.is_file()]
    return sorted([*inside, "build.mjs", "index.html", "package-lock.json", "tsconfig.json"])


@pytest.mark.skipif(not PAGE.is_dir(), reason="the page's sources are in the repository only")
def test_the_bundle_is_of_these_sources() -> None:
    digest = hashlib.sha256()
    for path in sources():
        digest.update(f"{path}\0".encode() + (PAGE / path).read_bytes() + b"\0")
    wanted = digest.hexdigest()
    for name in ("app.js", "app.css"):
        found = re.search(r"sources ([0-9a-f]{64});", (STATIC / name).read_text(encoding="utf-8")[:300])
        assert found is not None
        assert found[1] == wanted, f"{name} is of other sources: run `npm ci && npm run build` in page/ and commit it"
    assert (STATIC / "index.html").read_bytes() == (PAGE / "index.html").read_bytes()


def test_the_bundle_is_small_and_says_what_it_contains() -> None:
    sizes = {name: len(gzip.compress((STATIC / name).read_bytes(), 9)) for name in SERVED}
    assert sum(sizes.values()) <= 250_000, sizes
    licences = (STATIC / "licences.txt").read_text(encoding="utf-8")
    for library in ("three", "uplot"):
        assert re.search(rf"^== {library} [\d.]+ \(MIT\) ==$", licences, re.MULTILINE)


def test_nothing_in_the_bundle_is_loaded_from_elsewhere() -> None:
    page, style = ((STATIC / name).read_text(encoding="utf-8") for name in ("index.html", "app.css"))
    assert not re.findall(r"(?:src|href)=\"(?:https?:)?//", page)
    assert not re.findall(r"url\((?!['\"]?data:)|@import", style)
