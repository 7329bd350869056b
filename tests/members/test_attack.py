"""A member that lies with all keys of its own gains no more than its link's limits, and breaks nothing.

The long search is `python -m benchmarks.attack`; what it found in earlier versions is kept here.
"""

from collections.abc import Callable

import numpy as np
import pytest
from tests.members import attack
from tests.members.attack import GOALS, Search, play
from tests.members.lie import Lie, near, random_lie

from cotouch.peer import LinkGuard
from cotouch.samples import BudgetAgreement

# Each broke something once.
FOUND = {
    "a place far away, before the others came": Lie(
        first=True, since=0.0, law="noise", size=9.9, pattern=1, state=2, seed=2
    ),
    "a budget that no clock shows": Lie(ask=2e10, grant=2e10, seed=2),
    "ages that no clock shows": Lie(since=0.0, law="drift", rate=0.1, age=3e9, given=1.0, seed=2),
    "energy that nobody had": Lie(law="noise", size=0.2, given=1.5e9, state=1, received=True, seed=2),
    "stamps of the future": Lie(first=True, law="push", lead=-0.05, drift=5.0, received=True, seed=2),
    "silence, where everybody waits": Lie(silence=1.0, seed=1),
}
# The part that holds it, taken out.
WITHOUT: dict[str, Callable[[pytest.MonkeyPatch], None]] = {
    "a budget that no clock shows": lambda patch: patch.setattr(BudgetAgreement, "__init__", _unlimited),
    "energy that nobody had": lambda patch: patch.setattr(LinkGuard, "_receive", _believing),
    "stamps of the future": lambda patch: patch.setattr(LinkGuard, "settle", _generous),
    "silence, where everybody waits": lambda patch: patch.setattr("cotouch.members._replica._MOST_WAIT", np.inf),
}
_made, _settled = BudgetAgreement.__init__, LinkGuard.settle


def _unlimited(end: BudgetAgreement, **options: float) -> None:
    _made(end, **(options | {"limit": 1e12}))  # pyright: ignore[reportArgumentType]


def _believing(end: LinkGuard, given: float, T: float) -> None:
    del T
    if end._given_before is None:
        end._given_before = given
    more = given - end._given_before - end._received
    if more > 0.0:
        end._received += more
        end.help(more)


def _generous(end: LinkGuard, square: float, T: float) -> None:
    sample = end.source.choose(0)
    if end._surplus > 0.0:
        end._surplus = max(end._surplus, sample.stamp - 4.0)
    _settled(end, square, T)


@pytest.mark.parametrize("what", FOUND)
def test_what_was_found_breaks_nothing_any_more(what: str) -> None:
    outcome = play(FOUND[what])
    assert outcome.held, outcome.broken
    assert max(outcome.gain, outcome.work, outcome.received, outcome.damping) <= 1.0


@pytest.mark.parametrize("what", WITHOUT)
def test_it_does_without_the_part_that_holds_it(what: str, monkeypatch: pytest.MonkeyPatch) -> None:
    WITHOUT[what](monkeypatch)
    assert not play(FOUND[what]).held


def test_nobody_cuts_the_links_of_others_by_what_it_says_was_decided() -> None:
    """The host took another's word for a member's start, and everybody made that one's links anew, for ever."""
    outcome = play(Lie(talk=("rosters",), seed=2))
    assert outcome.held, outcome.broken
    assert outcome.apart == 0.0


def test_a_search_finds_nothing() -> None:
    search = Search(np.random.default_rng(5), judge=lambda lie: play(lie, seconds=2.5))
    for lie, outcome in search.run(5):
        assert outcome.held, (lie, outcome.broken)
    # It does look: the worst of each goal is worse than what the truth leads to.
    truth = play(Lie(seed=2), seconds=2.5)
    for name in ("gain", "work", "damping", "speed"):
        assert search.best[name][0][0] > getattr(truth, name)


def test_a_search_goes_on_from_the_worst() -> None:
    """On a landscape that is known: it gets nearer to the top than chance does with as many tries."""

    def judge(lie: Lie) -> attack.Outcome:
        off = sum(
            abs(float(np.log(abs(value) / top))) for value, top in ((lie.size, 0.05), (lie.rate, 3.0), (lie.lead, 0.1))
        )
        return attack.Outcome(**dict.fromkeys(GOALS, -off), broken=())

    tops = {0.5: [], 1.0: []}
    for random, found in tops.items():
        for seed in range(5):
            search = Search(np.random.default_rng(seed), judge=judge, random=random)
            assert len(list(search.run(300))) == search.tried == 300
            found.append(search.best["gain"][0][0])
    assert np.median(tops[0.5]) > 0.7 * np.median(tops[1.0])


def test_lies_are_what_can_be_said() -> None:
    """Else they would be refused where they arrive, and show nothing."""
    rng = np.random.default_rng(2)
    lie = random_lie(rng)
    for _ in range(300):
        lie = near(lie, rng)
        assert abs(lie.size) <= 9.9
        assert not abs(lie.age) > 2e10
        assert not abs(lie.ask) > 2.1e10
        assert not abs(lie.grant) > 2.1e10
        assert 0.0 <= lie.silence <= 1.0
