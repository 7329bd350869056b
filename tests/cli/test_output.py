"""Tables on terminals that are narrow."""

import io
import re
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from rich.console import Console

from cotouch.cli import _plan_tables
from cotouch.cli._audit import _links, _users
from cotouch.cli._demo import _print
from cotouch.cli._output import number, print_columns, print_note
from cotouch.session import DemoOutcome

NUMBERS = [-5.974e-05, -1.234e-11, 12.34, -0.001234, 633.1]


def printed(capsys: pytest.CaptureFixture[str]) -> str:
    return capsys.readouterr().out


def test_no_number_is_cut_however_many_columns_there_are(capsys: pytest.CaptureFixture[str]) -> None:
    console = Console(width=80)
    columns = [(f"user {n}", [f"{value:.4g}" for value in NUMBERS]) for n in range(9)]
    print_columns(console, "Energy [J]", [f"what it is of, {n}" for n in range(5)], columns)
    text = printed(capsys)
    assert max(map(len, text.splitlines())) <= 80
    assert "…" not in text
    for value in NUMBERS:
        assert len(re.findall(rf"(?<!\S){re.escape(f'{value:.4g}')}(?!\S)", text)) == 9
    assert text.count("Energy [J]") == 1
    assert [text.count(f"user {n}") for n in range(9)] == [1] * 9


def test_an_audit_can_be_read_at_eighty_columns(capsys: pytest.CaptureFixture[str]) -> None:
    console = Console(width=80)
    fields = (
        "supplied",
        "link_work",
        "body_loss",
        "local_loss",
        "extra_loss",
        "touch_loss",
        "members",
        "stored",
        "closure",
    )
    users = [
        SimpleNamespace(user=n, name=name, residual=-1.2e-17, **dict.fromkeys(fields, -5.974e-05))
        for n, name in enumerate(("Ann", "Benedikta", "Cleo [x]", "Dan", "Eve"))
    ]
    states = dict.fromkeys(("coupled", "guarded", "waiting"), -1.234e-11)
    links = [
        SimpleNamespace(
            ends=(0, n),
            work=NUMBERS[:2],
            spring=-5.974e-05,
            by_state=states,
            dissipated=1e-3,
            excess=-1e-9,
            strict=True,
        )
        for n in range(1, 5)
    ]
    result: Any = SimpleNamespace(users=users, links=links)
    _users(console, result)
    _links(console, result)
    text = printed(capsys)
    assert max(map(len, text.splitlines())) <= 80
    assert "…" not in text
    assert text.count("5.974e-05") == 9 * 5 + 2 * 4
    assert text.count("-1.234e-11") == 4 * 4
    assert "Cleo [x]" in text


def outcome(**entries: Any) -> DemoOutcome:
    energies = dict.fromkeys(("seconds", "supplied", "lost", "energy", "initial", "residual", "apart", "missed"), 0.5)
    return DemoOutcome(members={}, guarded=0, complaints=[], **(energies | {"linked": 633.0} | entries))


def test_after_lowered_damping_nothing_is_called_passive(capsys: pytest.CaptureFixture[str]) -> None:
    _print(outcome(lowered=True))
    text = " ".join(printed(capsys).split())
    assert "Passive" not in text
    assert text.endswith("While the damping was lowered, nothing was guaranteed; links added 633 J in total.")
    _print(outcome())
    assert "Passive: nobody took out energy" in printed(capsys)


def test_a_plan_sets_the_worst_apart_and_nothing_else(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(_plan_tables, "_verdict", lambda found: "Proved.")
    choice = SimpleNamespace(
        links=((0, 1),), value=-1.0, period=1, time_constant_s=1.0, worst_path_s=0.1, damping=np.array([4.0, 4.0])
    )
    found: Any = SimpleNamespace(
        objective="decay", users=("Ann", "Ben"), top=[choice] * 3, best=choice, worst=choice, worst_status="proved",
        notes=(),
    )  # fmt: skip
    _plan_tables.print_plan(found)
    text = [line.split()[:1] for line in printed(capsys).splitlines()]
    rows = text[text.index(["1"]) :]
    assert rows[:5] == [["1"], ["2"], ["3"], [], ["worst"]]


def test_a_note_ends_its_lines_between_words_at_a_terminal_and_stays_one_line_in_a_file() -> None:
    text = "Its moments of inertia are up to 25 % above the solid's; a higher resolution is nearer."
    for terminal, lines in ((True, 3), (False, 1)):
        written = io.StringIO()
        print_note(Console(file=written, width=40, force_terminal=terminal, color_system=None), "yellow", text)
        found = written.getvalue().splitlines()
        assert len(found) == lines
        assert found[0].startswith("  • Its moments")
        assert all(line.startswith("    ") for line in found[1:])
        assert " ".join(" ".join(found).split()) == f"• {text}"


def test_nothing_is_less_than_zero_by_its_sign_alone() -> None:
    assert (number(-0.0), number(0.0, "J"), number(-1e-20)) == ("0", "0 J", "-1e-20")
