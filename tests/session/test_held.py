"""What is said of a device reaches the terminal, the status and the report."""

from types import SimpleNamespace
from typing import Any, cast

from tests.session.inside import HeldDevice

from cotouch.haptics import ServoLink
from cotouch.members import MOST_NOTICE, Status


def device(sentences: list[list[str]]) -> ServoLink:
    """As far as it is asked here."""
    link = SimpleNamespace(
        spec=SimpleNamespace(name="Omega"), warning_log=lambda: sentences.pop(0) if sentences else []
    )
    return cast("ServoLink", link)


def test_every_sentence_is_told_by_a_status_and_the_last_one_stays():
    warned: list[str] = []
    held = HeldDevice("omega", [device([["one", "two"], ["three"]])], warned.append)
    assert held.notice() == ""
    held.service(None, 0.0)
    assert held.notice() == "one"
    held.service(None, 1.0)
    assert [held.notice() for _ in range(4)] == ["two", "three", "three", "three"]
    assert warned == ["one", "two", "three"]


def test_no_sentence_is_too_long_or_too_odd_for_a_status():
    held = HeldDevice("omega", [device([["a\nb\x1b[2J" + "x" * 1000] * 100])], lambda _text: None)
    held.service(None, 0.0)
    given: dict[str, Any] = {"slot": 0, "device": held.notice()}
    assert len(Status.model_validate(given).device) == MOST_NOTICE


def test_of_two_devices_each_is_named():
    warned: list[str] = []
    held = HeldDevice("a + b", [device([["one"]]), device([["two"]])], warned.append)
    held.service(None, 0.0)
    assert warned == ["Omega: one", "Omega: two"]
