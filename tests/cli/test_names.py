"""Names, files and terminals that are not what one expects: one line each, and nothing that a terminal obeys."""

import io
import json
import sys
from contextlib import redirect_stdout
from pathlib import Path
from unittest.mock import patch

import pytest
from tests.cli.commands import here

from cotouch.cli import main
from cotouch.errors import BodyError, printable

ODD = """
title = "[/bold] [red]"
[network]
users = ["[/]", "[bold]Ben"]
spring = [[0, 50], [50, 0]]
delay = [[0, 0.05], [0.02, 0]]
[steps]
duration = 0.5
"""


@pytest.fixture
def odd(tmp_path: Path) -> Path:
    (tmp_path / "[").mkdir()
    path = tmp_path / "[" / "]odd.toml"  # together they read as markup
    path.write_text(ODD)
    return path


@pytest.mark.parametrize(
    "command",
    [
        ("simulate",),
        ("certify",),
        ("plan", "--links", "1"),
        ("sweep", "--vary", "synchronisation.law=spring"),
    ],
)
def test_names_are_no_markup(command: tuple[str, ...], odd: Path) -> None:
    done = here(command[0], odd, *command[1:])
    assert done.returncode == 0, done.stderr
    if command[0] in {"simulate", "certify"}:
        assert "[/]" in done.stdout
        assert "[bold]Ben" in done.stdout
    if command[0] == "simulate":
        assert "[/bold] [red]" in done.stdout


def test_what_is_written_may_be_named_anything(odd: Path, tmp_path: Path) -> None:
    out = odd.parent / "]\x1b[2J.nc"
    done = here("simulate", odd, "--out", out)
    assert done.returncode == 0, done.stderr
    assert out.exists()
    assert r"[/]\x1b[2J.nc" in done.stdout
    assert "\x1b" not in done.stdout


def test_a_line_feed_in_a_name_leaves_the_message_on_one_line(tmp_path: Path) -> None:
    for command in ("simulate", "body", "audit"):
        done = here(command, tmp_path / "one\ntwo\x1b]0;title\x07.stl")
        assert done.returncode == 2
        assert done.stderr.count("\n") == 1, done.stderr
        assert r"one\ntwo\x1b]0;title\x07.stl" in done.stderr


def test_what_a_terminal_obeys_is_written_out() -> None:
    assert printable("Ann Łukasz 🙂 ä") == "Ann Łukasz 🙂 ä"
    assert printable("\x1b[2J\u202e\udcff\u2028") == r"\x1b[2J\u202e\udcff\u2028"
    assert str(BodyError("a\nb")) == r"a\nb"


@pytest.mark.parametrize("encoding", ["cp1252", "ascii"])
def test_a_terminal_that_has_not_all_letters(odd: Path, encoding: str) -> None:
    out = io.TextIOWrapper(io.BytesIO(), encoding=encoding)
    command = ["cotouch", "simulate", str(odd)]
    with patch.object(sys, "argv", command), redirect_stdout(out), pytest.raises(SystemExit) as ended:
        main()
    assert not ended.value.code
    out.flush()
    text = out.buffer.getvalue().decode(encoding)  # type: ignore[attr-defined]
    assert "residual" in text
    assert "?f" in text, "in place of Σ"


def test_a_motion_that_diverges_ends_with_1(tmp_path: Path) -> None:
    path = tmp_path / "diverges.toml"
    path.write_text(
        ODD.replace("50", "5e5") + '[synchronisation]\nlaw = "spring"\ndamping = 0.0\n[[hands]]\nuser = 1\npath = 0.1\n'
    )
    path.write_text(path.read_text().replace("duration = 0.5", "duration = 20.0"))
    out = tmp_path / "run.nc"
    done = here("simulate", path, "--json", "--out", out)
    assert done.returncode == 1
    assert json.loads(done.stdout)["finished"] is False
    assert out.exists(), "what there is of it is written"


def test_too_little_memory_is_a_sentence(odd: Path) -> None:
    with patch("cotouch.cli._simulate.run", side_effect=MemoryError):
        done = here("simulate", odd)
    assert done.returncode == 2
    assert "not enough memory" in done.stderr
    assert done.stderr.count("\n") == 1
