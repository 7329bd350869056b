import pytest

from cotouch.body import Body
from cotouch.errors import SessionError
from cotouch.observers import Pointer
from cotouch.session import _requests

BODY = Body(mass=[[1.0, 0.0], [0.0, 1.0]], rest=[0.0, 1.0], stiffness_int=[[1.0, -1.0], [-1.0, 1.0]])


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: _requests.slot_of({"slot": 3}, (0, 1)), "slot is 3; it must be one of 0, 1"),
        (lambda: _requests.slot_of({"slot": True}, (0, 1)), "slot is True"),
        (lambda: _requests.slot_of({}, (0, 1)), "slot is None"),
        (lambda: _requests.hand_of({"mode": "fly"}, BODY), "mode is 'fly'; it must be one of script"),
        (lambda: _requests.hand_of({"mode": "hold", "node": 2}, BODY), "node is 2; it must be from 0 to 1"),
        (lambda: _requests.hand_of({"mode": "pull"}, BODY), "to is missing"),
        (lambda: _requests.hand_of({"mode": "pull", "to": [0, 0]}, BODY), "to is [0, 0]; it must be 3 numbers"),
        (lambda: _requests.hand_of({"mode": "pull", "to": [0, 0, float("nan")]}, BODY), "it must be 3 numbers"),
        (lambda: _requests.pair_of({"a": 0, "b": 0}, 2), "a and b are both 0"),
        (lambda: _requests.law_of({"delay": -1}), "delay is -1; it must be from 0 to 5 s"),
        (lambda: _requests.law_of({"loss": 1.5}), "loss is 1.5; it must be from 0 to 1"),
        (lambda: _requests.law_of({"loss": "much"}), "loss is much"),
        (lambda: _requests.law_of({}), "nothing is named"),
        (lambda: _requests.flag_of({"on": 1}), "on is 1; it must be true or false"),
        (lambda: _requests.fraction_of({"fraction": 0}), "share is 0; it must be above 0 and at most 1"),
        (lambda: _requests.fraction_of({"fraction": 1.01}), "share is 1.01"),
        (lambda: _requests.links_of({"choice": "odd"}, {"start": []}, 3), "choice is 'odd'; it must be one of start"),
        (lambda: _requests.links_of({"links": [[0, 1, 2]]}, {}, 3), "links has the entry [0, 1, 2]"),
        (lambda: _requests.links_of({"links": [[0, 3]]}, {}, 3), "b is 3; it must be one of 0, 1, 2"),
        (lambda: _requests.links_of({}, {}, 3), "links has the entry None"),
        (
            lambda: _requests.checked(Pointer(number=1, mode="pull", node=0, target=(0, 0, 0)), BODY),
            'the pointer\'s mode is "pull"',
        ),
        (
            lambda: _requests.checked(Pointer(number=1, mode="grab", node=2, target=(0, 0, 0)), BODY),
            "the pointer's node is 2",
        ),
        (
            lambda: _requests.checked(Pointer(number=1, mode="grab", node=0, target=(0, 0, float("inf"))), BODY),
            "the pointer's target",
        ),
        (
            lambda: _requests.checked(Pointer(number=1, mode="ball", node=0, target=(0, 0, 0), radius=-1.0), BODY),
            "the pointer's radius is -1.0",
        ),
    ],
)
def test_mistakes_are_sentences(call, words: str) -> None:
    with pytest.raises(SessionError) as error:
        call()
    assert words in str(error.value)


def test_what_is_right_goes_through() -> None:
    assert _requests.hand_of({"mode": "pull", "node": 1, "to": [1, 2, 3]}, BODY) == ("pull", 1, (1.0, 2.0, 3.0))
    assert _requests.hand_of({"mode": "free"}, BODY) == ("free", -1, None)
    assert _requests.law_of({"delay": 0.1, "loss": 0}) == {"delay": 0.1, "loss": 0.0}
    assert _requests.links_of({"links": [[2, 0], [0, 2], [1, 2]]}, {}, 3) == [(0, 2), (1, 2)]
    assert _requests.links_of({"choice": "best"}, {"best": [(0, 1)]}, 3) == [(0, 1)]
