"""What members say together of their law."""

import pytest
from pydantic import ValidationError

from cotouch.members import LinkStatus, Status, law_felt


def said(slot: int, **entries: object) -> Status:
    usual = {"slot": slot, "steps": 9, "law": "paid", "drag": 0.0, "braked": 0.02, "moved": 0.04}
    return Status.model_validate(usual | entries)


def end(slot: int, given: float, taken: float) -> LinkStatus:
    return LinkStatus(slot=slot, state="coupled", given=given, taken=taken)


def test_drag_is_what_all_copies_lost_for_the_way_that_one_of_them_went() -> None:
    found = law_felt([said(0, drag=1.0), said(1, drag=2.0, braked=-0.01), said(2, drag=3.0, moved=0.07)])
    assert found is not None
    assert found.measured == pytest.approx(0.03 / 0.05)
    assert found.predicted == 6.0


def test_only_what_both_ends_say_is_on_the_way() -> None:
    ends = said(0, links=[end(1, 3.0, 1.0), end(2, 9.0, 0.0)]), said(1, links=[end(0, 1.0, 2.5)])
    found = law_felt(ends)
    assert found is not None
    assert found.on_the_way == pytest.approx(0.5)
    springs = law_felt([one.model_copy(update={"law": "spring"}) for one in ends])
    assert springs is not None
    assert springs.on_the_way is None


def test_what_nobody_knows_is_not_said() -> None:
    assert law_felt([]) is None
    assert law_felt([said(0, steps=0)]) is None
    found = law_felt([said(0, moved=1e-5), said(1, moved=1e-5, drag=None)])
    assert found is not None
    assert (found.measured, found.predicted) == (None, None)


@pytest.mark.parametrize("name", ["\x1b[2J", "\u202edias", "a\u2028b", "\u200b"])
def test_a_law_whose_name_steers_terminals_is_not_read(name: str) -> None:
    with pytest.raises(ValidationError, match="law"):
        said(0, law=name)


def test_ages_that_only_one_end_counts_predict_no_drag() -> None:
    """Each end counts the difference of the clocks, the other way round: alone it came to millions of Ns/m."""
    one = said(0, law="spring", drag=5.0 + 60.0 * 2.6e5, links=[end(1, 0.0, 0.0)])
    other = said(1, law="spring", drag=7.0 - 60.0 * 2.6e5, links=[end(0, 0.0, 0.0)])
    both = law_felt([one, other])
    assert both is not None
    assert both.predicted == pytest.approx(12.0)
    guarded = other.model_copy(update={"drag": 7.0, "links": [LinkStatus(slot=0, state="guarded")]})
    for known in ([one, guarded], [one]):
        found = law_felt(known)
        assert found is not None
        assert found.predicted is None
