import pytest
from tests.session.inside import requests

from cotouch.body import Body, lattice
from cotouch.errors import SessionError
from cotouch.observers import ChooseLinks, Cut, MoveHand, Pointer

BODY = Body(mass=[[1.0, 0.0], [0.0, 1.0]], rest=[0.0, 1.0], stiffness_int=[[1.0, -1.0], [-1.0, 1.0]])


CUTTABLE = lattice((2, 2, 2), model="cells").with_cutting()


def pointer(mode="ball", node=0, target=(0.0, 0.0, 0.0), radius=0.0, edge=(0.0, 0.0, 0.0)) -> Pointer:
    return Pointer(number=1, mode=mode, node=node, target=target, radius=radius, edge=edge)


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: requests.slot_among(3, (0, 1)), "slot is 3; it must be one of 0, 1"),
        (
            lambda: requests.check_hand(MoveHand(slot=0, mode="hold", node=2), BODY, cuts=True),
            "node is 2; it must be from 0 to 1",
        ),
        (lambda: requests.ends_of(Cut(a=0, b=3, on=True), 3), "b is 3; it must be one of 0, 1, 2"),
        (
            lambda: requests.links_of(ChooseLinks(choice="best"), {"start": []}, 3),
            "choice is 'best'; it must be one of start",
        ),
        (lambda: requests.links_of(ChooseLinks(choice="best"), {"best": []}, 3), "no such links were found"),
        (lambda: requests.links_of(ChooseLinks(links=((0, 3),)), {}, 3), "a slot of links is 3"),
        (lambda: requests.checked(pointer("pull"), BODY, 0, cuts=True), 'the pointer\'s mode is "pull"'),
        (lambda: requests.checked(pointer("grab", node=2), BODY, 0, cuts=True), "the pointer's node is 2"),
        (
            lambda: requests.checked(pointer(target=(0.0, 0.0, float("inf"))), BODY, 0, cuts=True),
            "the pointer's target",
        ),
        (
            lambda: requests.checked(pointer(target=(0.0, 0.0, float("nan"))), BODY, 0, cuts=True),
            "the pointer's target",
        ),
        (
            lambda: requests.checked(pointer("blade"), BODY, 0, cuts=True),
            "the blade cuts nothing here, because the session file has no [cutting] table; add one",
        ),
        (
            lambda: requests.checked(pointer("blade"), CUTTABLE, 0, cuts=False),
            "this user may not cut; cutting.users in the session file says who may",
        ),
        (lambda: requests.checked(pointer(edge=(0.0, 0.0, float("nan"))), BODY, 0, cuts=True), "the pointer's edge"),
        (lambda: requests.checked(pointer(radius=-1.0), BODY, 0, cuts=True), "the pointer's radius is -1.0"),
    ],
)
def test_mistakes_are_sentences(call, words: str) -> None:
    with pytest.raises(SessionError) as error:
        call()
    assert words in str(error.value)


def test_what_is_right_goes_through() -> None:
    requests.check_hand(MoveHand(slot=0, mode="pull", node=1, to=(1.0, 2.0, 3.0)), BODY, cuts=True)
    assert requests.ends_of(Cut(a=2, b=0, on=True), 3) == (2, 0)
    assert requests.links_of(ChooseLinks(links=((2, 0), (0, 2), (1, 2))), {}, 3) == [(0, 2), (1, 2)]
    assert requests.links_of(ChooseLinks(choice="best"), {"best": [(0, 1)]}, 3) == [(0, 1)]
