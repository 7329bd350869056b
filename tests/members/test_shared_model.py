"""Who built another body, or another world around it, is not let in: newcomers check the arrays of the law."""

from tests.session import heavy, turned

from cotouch.laws import law_named
from cotouch.members import Admission, Join, Roster, SessionFile, SharedModel


def built(text: str) -> list[float]:
    return SharedModel.build(SessionFile.from_toml(text, source="a test")).fingerprint


def same_body(own: list[float], other: list[float]) -> bool:
    """Whether a host that built one lets in who built the other."""
    session = SessionFile.from_toml("[session]\nusers = 2\n")
    request = Join(name="Ann", fingerprint=other, version="1", law=law_named(session.law).signature)
    why = Admission(session, fingerprint=own).unfit(request, "a" * 64, Roster())
    assert why is None or "a different body" in why
    return why is None


def test_another_body() -> None:
    text = turned.session('model = "cells"')
    same = built(text)
    assert same_body(same, built(text))
    for other in ('frame = "floating"', "", 'model = "spring-network"\nneighbours = 18'):
        assert not same_body(same, built(turned.session(other)))
    for line, instead in (("stiffness = 60.0", "stiffness = 60.1"), ("damping = 0.02", "damping = 0.0201")):
        assert not same_body(same, built(text.replace(line, instead)))


def test_another_world() -> None:
    text = heavy.session()
    same = built(text)
    assert same_body(same, built(text))
    changes = (
        ("stiffness = 1e6", "stiffness = 1.01e6"),
        ("-9.81", "-9.8"),
        (heavy.TABLE, heavy.SLICK),
        (heavy.TABLE, ""),
    )
    for one, other in changes:
        assert not same_body(same, built(text.replace(one, other)))
