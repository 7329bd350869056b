"""The verdict in words, from statuses made for it."""

from dataclasses import replace
from typing import Any

import pytest
from tests.web.fake_session_api import FakeSessionApi

from cotouch.members import LinkStatus, Status
from cotouch.observers import Overview
from cotouch.web import judged

NAMES = FakeSessionApi("1d").overview()


def link(slot: int, **entries: Any) -> LinkStatus:
    return LinkStatus(**({"slot": slot, "state": "coupled", "age_sum": 0.08, "budget": 0.1} | entries))


def status(slot: int, *links: LinkStatus, **entries: Any) -> Status:
    usual = {"slot": slot, "steps": 9, "supplied": 1.0, "damping_margin": 0.0, "residual": 1e-16, "links": list(links)}
    return Status(**(usual | entries))


def seen(*statuses: Status, **entries: Any) -> Overview:
    return replace(NAMES, **({"statuses": {s.slot: s for s in statuses}, "damping": 1.0, "ended": False} | entries))


CALM = (status(1, link(3, age_sum=0.088)), status(3, link(1, age_sum=0.04), link(2, age_sum=0.05)), status(2, link(3)))


@pytest.mark.parametrize(
    ("overview", "level", "text"),
    [
        (seen(*CALM), "good", "safe: 12 % to spare on link 2–4"),
        (seen(status(0)), "good", "no links yet"),
        (seen(status(0, link(1, budget=None, law="paid"))), "good", "safe: law paid needs no damping"),
        (seen(), "warn", "no copy is moving"),
        (seen(status(0, steps=0)), "warn", "no copy is moving"),
        (seen(*CALM, ended=True), "warn", "over"),
        (seen(status(0, link(1, age_sum=0.098))), "warn", "safe: 2 % to spare on link 1–2"),
        (seen(status(0, link(1, age_sum=0.09999))), "warn", "safe: 1 % to spare"),
        (seen(status(0, link(1, age_sum=0.11))), "warn", "safe: link 1–2 is late and may pause"),
        (seen(*CALM, status(0, link(4, state="guarded", age_sum=0.3))), "warn", "safe: link 1–5 paused, network slow"),
        (
            seen(status(0, link(4, state="guarded")), status(4, link(0, state="guarded"))),
            "warn",
            "safe: link 1–5 paused",
        ),
        (seen(status(0, link(4, state="guarded"), link(1, state="guarded"))), "warn", "safe: 2 links paused"),
        (seen(*CALM, status(0, link(4, state="keys", age_sum=None))), "warn", "2–4; link 1–5 is connecting"),
        (seen(status(0, link(4, state="waiting", age_sum=None))), "warn", "safe: link 1–5 is connecting"),
        (
            seen(status(0, link(1, law="paid"), link(4, law="paid", state="waiting", age=0.9))),
            "warn",
            "safe: link 1–5 receives nothing, network slow",
        ),
        (
            seen(status(0, link(1, state="guarded"), unsent=True), status(1, link(0, state="waiting", age=0.9))),
            "warn",
            "safe: Ann's copy is farther away than samples can tell, so its neighbours hear nothing",
        ),
        (seen(*CALM, damping=0.4), "bad", "not safe: damping lowered to 40 %"),
        (seen(*CALM, damping=0.9999), "bad", "lowered to 99 %"),
        (seen(*CALM, damping=0.003), "bad", "lowered to 0.3 %"),
        (seen(*CALM, status(4, damping_margin=-0.25)), "bad", "not safe: Eve has 25 % less damping"),
        (seen(*CALM, status(4, damping_margin=-1e-12)), "good", "safe"),
        (seen(*CALM, status(4, alarms=1)), "bad", "ledger of Eve is off"),
        (seen(*CALM, status(4, steps=900, closure_alarms=9, closure_factor=0.03)), "good", "safe: 12 %"),
        (
            seen(*CALM, status(4, steps=900, closure_alarms=10, closure_factor=0.03)),
            "warn",
            "safe: forces and energy of Eve's copy disagree by up to 3 %",
        ),
        (seen(*CALM, status(4, residual=1e-3), damping=0.4), "bad", "off by 1e-03 of the energy in play"),
        (seen(status(0, supplied=-2.0, initial=0.5)), "bad", "not safe: 1.5 J came out"),
        (seen(status(0, supplied=-2.0), status(1, supplied=2.0)), "good", "safe"),
        (seen(status(0, supplied=-2.0), left=True), "good", "safe: no links yet"),
    ],
)
def test_verdict(overview: Overview, level: str, text: str):
    verdict = judged(overview)
    assert (verdict.level, text in verdict.text) == (level, True), verdict.text


def test_of_those_who_left_nothing_counts():
    gone = NAMES.roster.model_copy(update={"members": NAMES.roster.members[:4]})
    assert judged(seen(*CALM, status(4, alarms=1), roster=gone)).level == "good"
