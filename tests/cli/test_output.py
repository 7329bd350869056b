"""Tables on terminals that are narrow."""

import re
from types import SimpleNamespace
from typing import Any

import pytest
from rich.console import Console

from cotouch.cli._audit import _links, _users
from cotouch.cli._demo import _print
from cotouch.cli._output import print_columns
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
    assert text.endswith("Nothing was guaranteed while the damping was lowered; links added 633 J in all.")
    _print(outcome())
    assert "Passive: nobody got out" in printed(capsys)
