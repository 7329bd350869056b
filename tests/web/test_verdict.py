"""The verdict in words, from statuses made for it."""

from dataclasses import replace
from typing import Any

import pytest
from tests.web.fake_stage import FakeStage

from cotouch.session import LinkStatus, Overview, Status
from cotouch.web import judged

NAMES = FakeStage("1d").overview()


def link(seat: int, **entries: Any) -> LinkStatus:
    return LinkStatus(**({"seat": seat, "state": "coupled", "ages": 0.08, "budget": 0.1} | entries))


def status(seat: int, *links: LinkStatus, **entries: Any) -> Status:
    usual = {"seat": seat, "steps": 9, "supplied": 1.0, "certificate": 0.0, "residual": 1e-16, "links": list(links)}
    return Status(**(usual | entries))


def seen(*statuses: Status, **entries: Any) -> Overview:
    return replace(NAMES, **({"statuses": {s.seat: s for s in statuses}, "damping": 1.0, "ended": False} | entries))


CALM = (status(1, link(3, ages=0.088)), status(3, link(1, ages=0.04), link(2, ages=0.05)), status(2, link(3)))


@pytest.mark.parametrize(
    ("overview", "level", "text"),
    [
        (seen(*CALM), "good", "passive: 12 % to spare on link 2–4"),
        (seen(status(0)), "good", "no links yet"),
        (seen(), "warn", "nobody moves"),
        (seen(status(0, steps=0)), "warn", "nobody moves"),
        (seen(*CALM, ended=True), "warn", "over"),
        (seen(status(0, link(1, ages=0.098))), "warn", "passive: 2 % to spare on link 1–2"),
        (seen(status(0, link(1, ages=0.09999))), "warn", "passive: 1 % to spare"),
        (seen(status(0, link(1, ages=0.11))), "warn", "later than its damping covers"),
        (seen(*CALM, status(0, link(4, state="guarded", ages=0.3))), "warn", "link 1–5 is held back"),
        (seen(*CALM, status(0, link(4, state="keys", ages=None))), "warn", "2–4; link 1–5 is being joined"),
        (seen(status(0, link(4, state="waiting", ages=None))), "warn", "link 1–5 is being joined"),
        (seen(*CALM, damping=0.4), "bad", "not passive: the damping is lowered to 40 %"),
        (seen(*CALM, damping=0.9999), "bad", "lowered to 99 %"),
        (seen(*CALM, damping=0.003), "bad", "lowered to 0.3 %"),
        (seen(*CALM, status(4, certificate=-0.25)), "bad", "not passive: Eve has 25 % less damping"),
        (seen(*CALM, status(4, certificate=-1e-12)), "good", "passive"),
        (seen(*CALM, status(4, alarms=1)), "bad", "books of Eve are off"),
        (seen(*CALM, status(4, residual=1e-3), damping=0.4), "bad", "off by 1e-03 of the energy in play"),
        (seen(status(0, supplied=-2.0, initial=0.5)), "bad", "not passive: 1.5 J came out"),
        (seen(status(0, supplied=-2.0), status(1, supplied=2.0)), "good", "passive"),
    ],
)
def test_verdict(overview: Overview, level: str, text: str):
    verdict = judged(overview)
    assert (verdict.level, text in verdict.text) == (level, True), verdict.text


def test_of_those_who_left_nothing_counts():
    gone = NAMES.roster.model_copy(update={"members": NAMES.roster.members[:4]})
    assert judged(seen(*CALM, status(4, alarms=1), roster=gone)).level == "good"
