"""`cotouch devices` as users run it."""

import json
import os
import sys

import pytest

from cotouch.cli import main


def told(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, *words: str) -> tuple[int, str, str]:
    monkeypatch.setattr(sys, "argv", ["cotouch", "devices", *words])
    code = 0
    try:
        main()
    except SystemExit as end:
        code = int(end.code or 0)
    out = capsys.readouterr()
    return code, out.out, out.err


def test_list(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch):
    code, out, _ = told(capsys, monkeypatch, "list", "--json")
    assert code == 0
    said = json.loads(out)
    found = {row["name"]: row for row in said["devices"]}
    assert {"coupling", "stiffness", "friction"} <= set(said["coupling"])
    assert found["simulated"]["variants"] == ["phantom", "cartesian", "touch"]
    assert all(row["watchdog"] for row in found.values())
    code, out, _ = told(capsys, monkeypatch, "list")
    assert code == 0
    assert "simulated" in out
    options = [option for row in found.values() for option in row["options"]]
    assert [option for option in options if f"{option}=" not in out] == []  # on 80 columns


def test_check_calibrate_and_monitor(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch):
    code, out, _ = told(capsys, monkeypatch, "check", "simulated:cartesian", "--json")
    checked = json.loads(out)
    assert (code, checked["passed"]) == (0, True)
    assert len(checked["checks"]) > 25
    code, out, _ = told(capsys, monkeypatch, "calibrate", "simulated:touch,hand=false")
    assert (code, out.startswith("simulated:touch,hand=false is calibrated; its tip is at (0.0, 0.0, 0.0) mm")) == (
        0,
        True,
    )
    code, out, _ = told(capsys, monkeypatch, "monitor", "simulated:cartesian", "--duration", "0.2", "--json")
    seen = json.loads(out)
    assert (code, seen["flags"]) == (0, ["calibrated", "held"])
    assert seen["cycles"] > 5
    assert seen["orientation"] is None
    _, out, _ = told(capsys, monkeypatch, "monitor", "simulated:cartesian,wrist=true", "--duration", "0.1", "--json")
    assert json.loads(out)["orientation"] == pytest.approx([0.0, 0.0, 0.0, 1.0])


def test_check_says_that_priority_was_refused(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch):
    """It is no failure of the device, and whoever holds it will feel it."""

    def refuse(*_: object) -> None:
        raise PermissionError(1, "Operation not permitted")

    monkeypatch.setattr(os, "sched_setscheduler", refuse)
    code, out, _ = told(capsys, monkeypatch, "check", "simulated:cartesian")
    assert code == 0
    assert "WARN  real-time priority was refused ([Errno 1] Operation not permitted): on a busy machine" in out
    code, out, _ = told(capsys, monkeypatch, "check", "simulated:cartesian", "--json")
    assert json.loads(out)["real_time_refused"] == "[Errno 1] Operation not permitted"


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["check", "omega9"], 'cotouch: device is "omega9"; it must be one of'),
        (["check", "simulated:falcon"], 'cotouch: the device "simulated" has no variant "falcon"'),
        (["monitor", "simulated:sweep=9"], "cotouch: sweep is 9; it must be from 0 to 3"),
        (["calibrate", "simulated:a,b"], 'cotouch: device is "simulated:a,b"; it must be name'),
    ],
)
def test_what_is_wrong_is_a_sentence(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, words: list[str], said: str
):
    code, out, err = told(capsys, monkeypatch, *words)
    assert (code, out) == (2, "")
    assert err.startswith(said)
    assert err.count("\n") == 1
