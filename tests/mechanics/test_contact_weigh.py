"""How a step with tools is judged: which way closes it, and which length is tried next."""

import numpy as np
import pytest
from tests.mechanics.inside import EASY, LEAST, MOST, WEIGHED, is_closed, is_rounded, next_scale


def test_a_scale_is_sought_where_the_last_two_lead() -> None:
    """At first where the slope that was thought of leads, then where a line through the last two does."""

    def left(scale: float) -> float:
        return 0.1 - 0.5 * (scale - 1.0)

    slope, scale = next_scale.py_func(1.0, left(1.0), 0.0, 0.0, -1.0, 0.02, 0)
    assert (slope, scale) == pytest.approx((-1.0, 1.08))
    slope, scale = next_scale.py_func(scale, left(scale), 1.0, left(1.0), slope, 0.02, 1)
    assert slope == pytest.approx(-0.5)
    assert left(scale) == pytest.approx(0.02)


@pytest.mark.parametrize(("over", "slope", "scale"), [(10.0, -1.0, MOST), (-10.0, -1.0, LEAST), (-10.0, 1.0, 1.0)])
def test_a_scale_stays_near_one(over: float, slope: float, scale: float) -> None:
    """And the same where less would be left over of a shorter way, which no scale makes up for."""
    assert next_scale.py_func(1.0, over, 0.0, 0.0, slope, 0.0, 0) == (slope, scale)


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_rounding_is_that_of_the_copys_share(sign: float) -> None:
    """Of the energies that were weighed or of places, whichever is more; what is weighed is the whole body."""
    for noise, rough in ((3.0, 1.0), (1.0, 3.0)):
        weighed = np.zeros(10)
        weighed[WEIGHED["noise"]], weighed[WEIGHED["rough"]] = noise, rough
        assert is_rounded.py_func(weighed, sign * 1.4, 0.5)
        assert not is_rounded.py_func(weighed, sign * 1.6, 0.5)


NEAR, FAR = 1.0 + 0.9 * EASY, 1.0 + 1.1 * EASY


@pytest.mark.parametrize(
    ("said", "closes"),
    [
        ({"square": NEAR}, True),
        ({"square": 2.0 - NEAR}, True),
        ({"square": FAR}, True),
        ({"square": 1.01 * MOST}, False),
        ({"square": 0.99 * LEAST}, False),
        # Where a length or a search may do better, the body makes up for little.
        ({"square": NEAR, "easy": True}, True),
        ({"square": FAR, "easy": True}, False),
        ({"square": 2.0 - FAR, "easy": True}, False),
        # What is left over of a way that cannot be longer is lost, not made velocity of.
        ({"square": NEAR, "over": 1.0}, False),
        ({"square": NEAR, "over": 1.0, "seeks": True}, True),
        # Only by its momentum could this one make up for anything.
        ({"square": NEAR, "central": True}, True),
        ({"square": NEAR, "central": True, "about": 0.0}, False),
        ({"square": NEAR, "about": 0.0}, True),
        # Rounding is no reason for another way, unless energy would be below 0.
        ({"square": 9.0, "over": 1e-9}, True),
        ({"square": 9.0, "over": -1e-9}, True),
        ({"square": 9.0, "rounded": True}, True),
        ({"square": 0.0, "rounded": True}, True),
        ({"square": -1.0, "rounded": True}, False),
    ],
)
def test_which_way_is_taken(said: dict[str, float], closes: bool) -> None:
    weighed = np.zeros(10)
    weighed[WEIGHED["have"]], weighed[WEIGHED["about"]] = 1.0, said.get("about", 0.5)
    flags = (bool(said.get(name, False)) for name in ("easy", "rounded", "seeks", "central"))
    assert is_closed.py_func(weighed, said.get("over", -1.0), 1e-8, said["square"], *flags) == closes
