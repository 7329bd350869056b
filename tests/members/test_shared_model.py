"""Who built another body, or another world around it, is told apart: newcomers check the arrays of the law."""

from tests.session import heavy, turned

from cotouch.members import SessionFile, SharedModel
from cotouch.members._shared_model import same_body


def built(text: str) -> list[float]:
    return SharedModel.build(SessionFile.from_toml(text, source="a test")).fingerprint


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
