"""Tables on terminals that are narrow."""

import re
from types import SimpleNamespace
from typing import Any

import pytest
from tests.cli.commands import FIVE_USERS, here

from cotouch.session import DemoOutcome

NUMBERS = [-5.974e-05, -1.234e-11, 12.34, -0.001234, 633.1]
LEDGER = (
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


@pytest.fixture(autouse=True)
def narrow(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("COLUMNS", "80")


def audited(
    monkeypatch: pytest.MonkeyPatch,
    *users: tuple[str, dict[str, float]],
    links: tuple[object, ...] = (),
    notes: tuple[str, ...] = (),
    on_the_way: float | None = None,
) -> str:
    """What `cotouch audit` prints of such an audit."""
    found = SimpleNamespace(
        users=[SimpleNamespace(user=n, name=name, residual=-1.2e-17, **own) for n, (name, own) in enumerate(users)],
        links=links,
        law=SimpleNamespace(name="spring", on_the_way=on_the_way, drag=None),
        notes=notes,
        findings=(),
        verdict="Passive.",
        holds=True,
    )
    monkeypatch.setattr("cotouch.cli._audit.read_recording", lambda _: None)
    monkeypatch.setattr("cotouch.cli._audit.audit", lambda _: found)
    done = here("audit", "a.mcap")
    assert (done.returncode, done.stderr) == (0, "")
    return done.stdout


def test_no_number_is_cut_however_many_columns_there_are(monkeypatch: pytest.MonkeyPatch) -> None:
    own = dict(zip(LEDGER, NUMBERS, strict=False)) | dict.fromkeys(LEDGER[len(NUMBERS) :], 7.0)
    text = audited(monkeypatch, *((f"user {n}", own) for n in range(9)))
    assert max(map(len, text.splitlines())) <= 80
    assert "…" not in text
    for name, value in zip(LEDGER, NUMBERS, strict=False):
        shown = f"{-value if name.endswith('loss') else value:.4g}"
        assert len(re.findall(rf"(?<!\S){re.escape(shown)}(?!\S)", text)) == 9
    assert text.count("Energy of each user [J]") == 1
    assert [text.count(f"user {n}") for n in range(9)] == [1] * 9


def test_an_audit_can_be_read_at_eighty_columns(monkeypatch: pytest.MonkeyPatch) -> None:
    names = ("Ann", "Benedikta", "Cleo [x]", "Dan", "Eve")
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
    users = [(name, dict.fromkeys(LEDGER, -5.974e-05)) for name in names]
    text = audited(monkeypatch, *users, links=tuple(links))
    assert max(map(len, text.splitlines())) <= 80
    assert "…" not in text
    assert text.count("5.974e-05") == 9 * 5 + 2 * 4
    assert text.count("-1.234e-11") == 4 * 4
    assert "Cleo [x]" in text


def outcome(**entries: Any) -> DemoOutcome:
    energies = dict.fromkeys(("seconds", "supplied", "lost", "energy", "initial", "residual", "apart", "missed"), 0.5)
    return DemoOutcome(members={}, guarded=0, complaints=[], **(energies | {"linked": 633.0} | entries))


def test_after_lowered_damping_nothing_is_called_passive(monkeypatch: pytest.MonkeyPatch) -> None:
    played = [outcome(lowered=True), outcome()]
    monkeypatch.setattr("cotouch.cli._demo.play", lambda *_, **__: played.pop(0))
    lowered, passive = (" ".join(here("demo", "--headless", "--no-page").stdout.split()) for _ in range(2))
    assert "Passive" not in lowered
    assert lowered.endswith("While the damping was lowered, nothing was guaranteed; links added 633 J in total.")
    assert "Passive: nobody took out energy" in passive


def test_a_plan_sets_the_worst_apart_and_nothing_else(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("COLUMNS", "120")
    done = here("plan", FIVE_USERS, "--links", "6", "--top", "3")
    text = [line.split()[:1] for line in done.stdout.splitlines()]
    rows = text[text.index(["1"]) :]
    assert rows[:5] == [["1"], ["2"], ["3"], [], ["worst"]]


def test_a_note_ends_its_lines_between_words_at_a_terminal_and_stays_one_line_in_a_file(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    text = "Its moments of inertia are up to 25 % above the solid's; a higher resolution is nearer."
    for name, value in (("COLUMNS", "40"), ("LINES", "25"), ("TERM", "dumb")):
        monkeypatch.setenv(name, value)
    for terminal, lines in (("1", 3), ("0", 1)):
        monkeypatch.setenv("TTY_COMPATIBLE", terminal)
        written = audited(monkeypatch, ("Ann", dict.fromkeys(LEDGER, 0.0)), notes=(text,)).splitlines()
        start = next(n for n, line in enumerate(written) if "•" in line)
        found = written[start : written.index("Passive.")]
        assert len(found) == lines
        assert found[0].startswith("  • Its moments")
        assert all(line.startswith("    ") for line in found[1:])
        assert " ".join(" ".join(found).split()) == f"• {text}"


def test_nothing_is_less_than_zero_by_its_sign_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    own = dict.fromkeys(LEDGER, 0.0) | {"supplied": -0.0, "link_work": -1e-20}
    text = audited(monkeypatch, ("Ann", own), on_the_way=-0.0)
    assert re.search("put in by hands and tools +0 ", text)
    assert re.search("added by links +-1e-20 ", text)
    assert " 0 J still on its way" in text
