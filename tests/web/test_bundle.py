"""The bundle in the package is what the sources make."""

import gzip
import hashlib
import re
import shutil
import subprocess
from importlib.resources import files
from pathlib import Path

import pytest

PAGE = Path(__file__).parents[2] / "page"
STATIC = files("cotouch.web") / "static"
VIEWER = files("cotouch.simulation") / "_viewer"
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
    for name, place in (("app.js", STATIC), ("app.css", STATIC), ("animation.js", VIEWER)):
        found = re.search(r"sources ([0-9a-f]{64});", (place / name).read_text(encoding="utf-8")[:300])
        assert found is not None
        assert found[1] == wanted, f"{name} is of other sources: run `npm ci && npm run build` in page/ and commit it"
    assert (STATIC / "index.html").read_bytes() == (PAGE / "index.html").read_bytes()


def test_the_bundle_is_small_and_says_what_it_contains() -> None:
    sizes = {name: len(gzip.compress((STATIC / name).read_bytes(), 9)) for name in SERVED}
    assert sum(sizes.values()) <= 250_000, sizes
    licences = (STATIC / "licences.txt").read_text(encoding="utf-8")
    for library in ("three", "uplot"):
        assert re.search(rf"^== {library} [\d.]+ \(MIT\) ==$", licences, re.MULTILINE)


def test_an_animation_holds_the_licence_of_what_it_contains() -> None:
    head = (VIEWER / "animation.js").read_text(encoding="utf-8")[:2000]
    assert "three.js authors" in head
    assert "The above copyright notice and this permission notice shall be included" in head


def test_nothing_in_the_bundle_is_loaded_from_elsewhere() -> None:
    page, style = ((STATIC / name).read_text(encoding="utf-8") for name in ("index.html", "app.css"))
    assert not re.findall(r"(?:src|href)=\"(?:https?:)?//", page)
    assert not re.findall(r"url\((?!['\"]?data:)|@import", style)


def make_with(tools: dict[str, str], folder: Path) -> subprocess.CompletedProcess[str]:
    """Runs `make page-types` on a copy of the page, with these programs and no others but a shell's own."""
    (folder / "bin").mkdir()
    for name, text in tools.items():
        (folder / "bin" / name).write_text(f"#!/bin/sh\n{text}\n", encoding="utf-8")
        (folder / "bin" / name).chmod(0o755)
    shutil.copy(PAGE.parent / "Makefile", folder / "Makefile")
    (folder / "page").mkdir()
    (folder / "page" / "package-lock.json").write_text("{}", encoding="utf-8")
    make = shutil.which("make")
    assert make is not None
    return subprocess.run(
        [make, "-s", "page-types"],
        cwd=folder,
        env={"PATH": str(folder / "bin")},
        capture_output=True,
        text=True,
        check=False,
        timeout=60,
    )


# What npm does: "ci" brings packages or not, "run check" finds the types right or not.
_NPM = 'case "$*" in ci*) exit {ci};; *check) echo types looked at; exit {check};; esac; exit 9'


@pytest.mark.skipif(shutil.which("make") is None or not PAGE.is_dir(), reason="for the repository, with make")
@pytest.mark.parametrize(
    ("node", "ci", "check", "good", "said"),
    [
        pytest.param(None, 0, 0, True, "no Node 20 here", id="no node"),
        pytest.param(1, 0, 1, True, "no Node 20 here", id="an old node"),
        pytest.param(0, 1, 1, True, "cannot be had here", id="no registry"),
        pytest.param(0, 0, 0, True, "types looked at", id="right"),
        pytest.param(0, 0, 1, False, "types looked at", id="wrong"),
    ],
)
def test_check_looks_at_the_types_of_the_page_where_it_can(
    tmp_path: Path, node: int | None, ci: int, check: int, good: bool, said: str
) -> None:
    tools = {} if node is None else {"node": f"exit {node}", "npm": _NPM.format(ci=ci, check=check)}
    done = make_with(tools, tmp_path)
    assert (done.returncode == 0) == good, done.stderr
    assert said in done.stdout
    makefile = (PAGE.parent / "Makefile").read_text(encoding="utf-8")
    assert re.search(r"^check:.* page-types\b", makefile, re.MULTILINE)
