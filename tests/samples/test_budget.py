"""Whatever becomes of the messages and of the ends: damping covers the budgets in force, and did so long enough."""

import struct

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.thorough import examples

from cotouch.errors import SessionError
from cotouch.samples import MOST_AGE, BudgetAgreement, LinkAges

TICK = 0.05


class Pair:
    """Two ends on one clock, messages that are carried as fates say, and what was covered when.

    What is in force is what their guards use: a first budget once they have caught up for as long as both.
    """

    def __init__(self, offset: float = 0.0) -> None:
        self.now, self.life = 0.0, [10, 10]
        self.offset = [offset, -offset]
        self.ends = [self._make(k) for k in range(2)]
        self.flying: list[tuple[float, int, bytes]] = []
        self.history: list[tuple[float, float, float]] = []
        self.since = [0.0, 0.0]
        self.fresh: list[float | None] = [None, None]  # since when each has a budget
        self.said = 0

    def _make(self, k: int) -> BudgetAgreement:
        return BudgetAgreement(life=self.life[k], patience=0.3, every=0.1)

    def restart(self, k: int) -> None:
        self.life[k] += 1
        self.ends[k] = self._make(k)
        self.since[k] = self.now

    def request(self, k: int, age: float) -> None:
        self.ends[k].request(self.now, age + self.offset[k], spare=0.02)

    def tick(self, fates: list[list[float]]) -> None:
        """Each message goes as many times as it has latencies."""
        self.now += TICK
        for entry in sorted(e for e in self.flying if e[0] <= self.now):
            self.flying.remove(entry)
            self.ends[entry[1]].receive(self.now, entry[2])
        for k, end in enumerate(self.ends):
            end.advance(self.now)
            said = end.message(self.now)
            if said is not None:
                self.said += 1
                self.flying += [(self.now + latency, 1 - k, said) for latency in fates[k]]
        self.check()

    def check(self) -> None:
        first, second = self.ends
        self.history.append((self.now, first.total, second.total))
        both = first.budget + second.budget
        for k, end in enumerate(self.ends):
            self.fresh[k] = None if np.isinf(end.budget) else self.now if self.fresh[k] is None else self.fresh[k]
        caught = [
            since is not None and self.now - since >= end.total
            for since, end in zip(self.fresh, self.ends, strict=True)
        ]
        if np.isfinite(both) and all(caught):
            from_then = max(self.now - both, *self.since)
            for then, *covered in self.history:
                if then >= from_then - 1e-9:
                    assert min(covered) >= both - 1e-6, (then, self.now, covered, both)


fate = st.lists(st.sampled_from([0.0, 0.05, 0.2, 1.0]), max_size=2)
change = st.one_of(
    st.none(),
    st.none(),
    st.tuples(st.integers(0, 1), st.sampled_from([0.01, 0.05, 0.1, 0.3, 0.8])),
    st.tuples(st.integers(0, 1), st.none()),
)


@settings(max_examples=examples(150))
@given(st.lists(st.tuples(change, fate, fate), max_size=80), st.sampled_from([0.0, 5.0, -1e4]))
def test_damping_covers_what_is_in_force(story, offset: float):
    pair = Pair(offset)
    for event, one, two in story:
        if event is not None:
            who, age = event
            pair.restart(who) if age is None else pair.request(who, age)
        pair.tick([one, two])
    for k in range(2):  # and when the messages pass again, both get what they want
        pair.request(k, 0.9)
    for _ in range(60):
        pair.tick([[0.05], [0.05]])
    assert [end.settled for end in pair.ends] == [True, True]
    assert pair.ends[0].total == pytest.approx(1.8, abs=1e-6) == pair.ends[1].total


def test_a_budget_is_raised_last_and_lowered_first():
    pair, order = Pair(), []
    for k in range(2):
        pair.request(k, 0.1)
    for _ in range(40):
        pair.tick([[0.05], [0.05]])
    was = [(end.budget, end.total) for end in pair.ends]
    assert was == [(0.1, pytest.approx(0.2))] * 2
    pair.request(0, 0.3)
    for _ in range(40):
        pair.tick([[0.05], [0.05]])
        now = [(end.budget, end.total) for end in pair.ends]
        order += [name for name, a, b in (
            ("own damping", was[0][1], now[0][1]), ("other's damping", was[1][1], now[1][1]),
            ("budget", was[0][0], now[0][0]),
        ) if a != b]  # fmt: skip
        was = now
    assert order == ["own damping", "other's damping", "budget"]
    raised = next(then for then, mine, other in pair.history if other > 0.3)
    assert pair.ends[0].budget == 0.3
    for _ in range(10):  # patience
        pair.request(0, 0.1)
        pair.tick([[], []])
    assert pair.ends[0].budget == 0.1
    assert pair.ends[1].total == pytest.approx(0.4)  # it has not heard
    for _ in range(20):
        pair.tick([[0.05], [0.05]])
    assert pair.ends[1].total == pytest.approx(0.2)
    assert raised < pair.now


def test_the_first_budget_does_not_wait_for_what_its_guard_waits_for_again():
    pair = Pair()
    for k in range(2):
        pair.request(k, 0.5)
    for _ in range(6):  # messages there and back, not both budgets besides
        pair.tick([[0.05], [0.05]])
    assert [end.budget for end in pair.ends] == [0.5, 0.5]
    pair.restart(1)
    pair.request(1, 0.5)
    pair.tick([[0.05], [0.05]])
    pair.tick([[0.05], [0.05]])
    assert pair.ends[0].budget == -np.inf  # what the old life granted is gone
    pair.request(0, 0.8)
    for _ in range(6):
        pair.tick([[0.05], [0.05]])
    assert [end.budget for end in pair.ends] == [0.8, 0.5]
    pair.request(0, 1.0)  # but one that is in use is raised only when the damping has stood
    for _ in range(20):
        pair.tick([[0.05], [0.05]])
    assert pair.ends[0].budget == 0.8
    for _ in range(20):
        pair.tick([[0.05], [0.05]])
    assert pair.ends[0].budget == 1.0


def test_an_old_grant_is_not_taken_for_the_answer_to_a_new_wish():
    """Granted, not wanted any more, wanted again: the grant of before is late, and has been taken back since."""
    first, second = (BudgetAgreement(life=1, patience=0.0) for _ in range(2))
    said: list[bytes] = []

    def say(end: BudgetAgreement, now: float) -> bytes:
        message = end.message(now)
        assert message is not None
        return message

    second.request(0.0, 0.1)
    first.request(0.0, 0.5)
    first.receive(0.0, say(second, 0.0))
    second.receive(0.0, say(first, 0.0))
    said.append(say(second, 0.0))  # grants 0.5, and is late
    for now in (0.1, 0.2):
        first.request(now, 0.1)
    second.receive(0.2, say(first, 0.2))
    assert second.total == pytest.approx(0.2)
    first.request(0.3, 0.5)
    first.receive(0.3, said[0])
    for now in np.arange(0.3, 3.0, 0.1):
        first.advance(float(now))
    assert first.budget == -np.inf


asked = st.one_of(st.floats(-2.1e10, 2.1e10), st.sampled_from([np.nan, np.inf, -np.inf, 0.0, 2.1e10, -2.1e10]))


@settings(max_examples=examples(200))
@given(st.lists(st.tuples(asked, asked, st.integers(0, 3), st.floats(-1e9, 1e9)), max_size=30), st.floats(0.1, 5.0))
def test_whatever_is_asked_and_measured_the_limit_holds(story, limit: float):
    end = BudgetAgreement(life=5, limit=limit, patience=0.0)
    for number, (ask, grant, life, request) in enumerate(story):
        now = 0.1 * number
        end.request(now, request)
        end.receive(now, struct.pack("<4sQQIIdd", b"ctb1", 1 + life, 5, number, 1 << 31, ask, grant))
        end.advance(now + 0.05)
        assert 0.0 <= end.total <= limit * (1.0 + 1e-9) + 1e-5  # clocks that show 1e9 s are no finer
        assert not np.isnan(end.budget)
        assert end.budget < np.inf


@pytest.mark.parametrize("offset", [0.0, 5.0, -1e4])
def test_who_asks_for_too_much_gets_what_the_limit_leaves(offset: float):
    """And the other end keeps what it has."""
    pair = Pair(offset)
    for k in range(2):
        pair.request(k, 0.3)
    for _ in range(40):
        pair.tick([[0.05], [0.05]])
    pair.request(1, 1e6)
    for _ in range(100):
        pair.tick([[0.05], [0.05]])
    assert [end.total for end in pair.ends] == pytest.approx([MOST_AGE, MOST_AGE])
    assert pair.ends[0].budget == pytest.approx(0.3 + offset)
    assert pair.ends[1].budget == pytest.approx(MOST_AGE - 0.3 - offset)
    pair.request(0, 1.5)  # nothing of what is granted is taken back
    for _ in range(100):
        pair.tick([[0.05], [0.05]])
    assert [end.total for end in pair.ends] == pytest.approx([MOST_AGE, MOST_AGE])
    assert pair.ends[0].budget == pytest.approx(0.3 + offset)
    for _ in range(60):
        pair.request(1, 0.2)
        pair.request(0, 1.5)
        pair.tick([[0.05], [0.05]])
    assert [end.budget for end in pair.ends] == pytest.approx([1.5 + offset, 0.2 - offset])
    assert [end.beyond for end in pair.ends] == [None, None]  # they ask for what they can get
    insatiable = struct.pack("<4sQQIIdd", b"ctb1", 99, 10, 1, 0x7FFF_FFFF, 1e6 - offset, 1.5 + offset)
    pair.ends[0].receive(pair.now, insatiable)
    assert pair.ends[0].beyond == pytest.approx(1e6 + 1.5)
    assert pair.ends[0].total == pytest.approx(MOST_AGE)


def test_it_does_not_chatter():
    """Wishes that wander within half the margin change nothing, and little is said once all is settled."""
    pair, rng = Pair(), np.random.default_rng(0)
    for k in range(2):
        pair.request(k, 0.1)
    for _ in range(40):
        pair.tick([[0.05], [0.05]])
    before, said = [end.budget for end in pair.ends], pair.said
    for _ in range(400):
        for k in range(2):
            pair.request(k, 0.1 + float(rng.uniform(-0.009, 0.009)))
        pair.tick([[0.05], [0.05]])
    assert [end.budget for end in pair.ends] == before
    assert pair.said - said <= 2 * (400 * TICK / 0.4 + 1)


def test_one_short_calm_does_not_lower_it():
    pair = Pair()
    for k in range(2):
        pair.request(k, 0.3)
    for _ in range(60):
        pair.tick([[0.05], [0.05]])
    for k in range(30):
        pair.request(0, 0.3 if k % 5 == 0 else 0.1)
        pair.tick([[0.05], [0.05]])
    assert pair.ends[0].budget == 0.3
    for age in (0.1, 0.2, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1):  # the most of the calm counts
        pair.request(0, age)
        pair.tick([[0.05], [0.05]])
    assert pair.ends[0].budget == 0.2


def asked_and_granted(message: bytes | None) -> tuple[float, float]:
    assert message is not None
    *_, ask, grant = struct.unpack("<4sQQIIdd", message)
    return ask, grant


def test_ages_become_a_wish():
    ages, end = LinkAges(), BudgetAgreement(life=1, margin=0.5, slack=0.01)
    end.propose(0.0, ages)
    assert np.isnan(asked_and_granted(end.message(0.0))).all()
    for k in range(10):
        ages.used(0.01 * k, 0.01 * k - 100.03)  # clocks apart
        ages.received(0.01 * k, index=k, age=-99.95, worst=-99.95)
    end.propose(0.1, ages)
    assert asked_and_granted(end.message(0.1))[0] == pytest.approx(100.03 + 0.01 + 0.5 * (100.03 - 99.95))


@given(st.binary(max_size=60), st.booleans())
def test_noise_changes_nothing(noise: bytes, sealed: bool):
    end, undisturbed = BudgetAgreement(life=3), BudgetAgreement(life=3)
    for one in (end, undisturbed):
        one.request(0.0, 0.1)
    message = (b"ctb1" + noise) if sealed else noise
    if len(message) != 44:
        assert not end.receive(0.0, message)
        assert (end.budget, end.total) == (undisturbed.budget, undisturbed.total)
        assert end.message(0.0) == undisturbed.message(0.0)  # all that it knows


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"life": 0}, "life"),
        ({"quantile": 0.0}, "quantile"),
        ({"margin": -1.0}, "margin"),
        ({"slack": np.inf}, "slack"),
        ({"patience": np.nan}, "patience"),
        ({"every": 0.0}, "every"),
        ({"limit": np.inf}, "limit"),
        ({"limit": 0.0}, "limit"),
    ],
)
def test_options_that_cannot_be_are_named(options: dict[str, float], message: str):
    with pytest.raises(SessionError, match=message):
        BudgetAgreement(**({"life": 1} | options))


@pytest.mark.parametrize(
    ("life", "number", "received"),
    [(2**64 - 1, 1, 0), (2**63, 1, 0), (1, 2**32 - 1, 0), (1, 2**31, 0), (1, 1, 2**32 - 1)],
)
def test_lives_and_numbers_near_their_end_are_refused(life: int, number: int, received: int):
    end = BudgetAgreement(life=5)
    said = struct.pack("<4sQQIIdd", b"ctb1", life, 5, number, received, 0.1, float("nan"))
    assert not end.receive(0.0, said)
    honest = struct.pack("<4sQQIIdd", b"ctb1", 7, 5, 1, 0, 0.1, float("nan"))
    assert end.receive(0.1, honest)
