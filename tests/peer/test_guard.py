"""Guarded links against users who do what they like: nobody gets energy out, and copies meet again.

A search along the gradient of what they get out finds nothing here, and much where one of some parts of the guard
is taken out; what it found is kept below.
"""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.peer.attack import K, Outcome, Plan, Way, attack, greedy, knots, random_plan, tight_plan

from cotouch.errors import NetworkError
from cotouch.peer import NO_HEADER, FreshestLink, LinkGuard, LinkHeader, LinkState, Sample

T = 0.01
SPAN = 0.1

# Found by following the gradient of what is got out, through a guard with a part taken out: (plan, speeds by 0.1 s).
FOUND = {
    "a guarded sample is used": (8, [
        [0.0, 0.0, 0.0, 0.0, 0.37, 0.42, 0.41, 0.45, 0.45, 0.45, 0.43, 0.47, 0.55, 0.74, 0.8, 0.81, 0.77, 0.66, 0.52,
         0.22, -0.11, -0.3, -0.31, -0.39, -0.42, -0.46, -0.37, -0.14, -0.25, -0.35, -0.35],
        [0.0, 0.0, 0.0, 0.0, -0.36, -0.42, -0.41, -0.44, -0.45, -0.46, -0.43, -0.43, -0.36, -0.23, -0.06, 0.13, 0.33,
         0.51, 0.78, 1.0, 1.0, 0.78, 0.61, 0.58, 0.54, 0.51, 0.47, 0.44, 0.42, 0.4, 0.35],
    ]),
    "going guarded is free": (7, [
        [0.0, 0.0, 0.0, 0.0, -0.21, -0.17, -0.13, -0.01, -0.2, -0.07, 0.01, 0.08, 0.05, -0.09, -0.06, -0.06, -0.07,
         -0.14, -0.27, -0.26, -0.37, -0.28, -0.32, -0.09, 0.71, 0.62, 0.46, 0.39, 0.49, 0.58, 0.58],
        [0.0, 0.0, 0.0, 0.0, 0.21, 0.17, 0.14, 0.0, 0.2, 0.1, -0.0, -0.08, -0.02, 0.12, 0.14, 0.14, 0.14, 0.2, 0.32,
         0.26, 0.35, 0.29, 0.32, 0.17, -0.03, -0.26, -0.7, -1.0, -0.52, -0.03, 0.08],
    ]),
    "all damping is credited": (7, [
        [0.0, 0.0, 0.0, 0.0, -0.17, -0.04, 0.11, 0.3, -0.12, -0.1, 0.09, 0.27, 0.17, -0.07, 0.12, 0.19, 0.14, -0.15,
         -0.57, -0.24, -0.55, -0.16, -0.18, 0.42, 1.0, 0.44, -0.13, -0.27, -0.26, -0.41, -0.47],
        [0.0, 0.0, 0.0, 0.0, 0.19, 0.06, -0.1, -0.36, 0.12, 0.12, -0.08, -0.29, -0.2, 0.09, -0.13, -0.21, -0.17, 0.14,
         0.64, 0.26, 0.62, 0.18, 0.22, -0.38, -0.46, -0.71, -0.47, -0.06, 0.32, 0.37, 0.18],
    ]),
    "credit is doubled": (8, [
        [0.0, 0.0, 0.0, 0.0, 0.0, 0.01, 0.02, 0.03, 0.03, 0.03, 0.03, 0.06, 0.12, 0.18, 0.26, 0.36, 0.36, 0.82, -0.03,
         0.14, 0.41, 0.39, -0.42, -0.3, -0.28, -0.22, -0.23, -0.53, -1.0, -0.85, -0.76],
        [0.0, 0.0, 0.0, 0.0, -0.0, -0.01, -0.02, -0.03, -0.03, -0.03, -0.03, -0.03, -0.07, -0.11, -0.15, -0.2, -0.24,
         -0.45, -0.05, -0.15, -0.29, -0.29, 0.19, 0.09, 0.08, 0.04, 0.78, 0.8, 0.53, 0.12, -0.07],
    ]),
}  # fmt: skip


def found(what: str) -> Outcome:
    seed, speed = FOUND[what]
    plan = tight_plan(seed, duration=3.0)
    return attack(plan, knots(plan, np.array(speed), SPAN))


def worst_motions(plan: Plan, seed: int) -> np.ndarray:
    """At rest until all is coupled; then apart, still, and together again, more than once."""
    rng = np.random.default_rng(seed)
    spans = int(plan.order[-1][0] / SPAN) + 1
    out = np.zeros((len(plan.ends), spans))
    at, place = 4, np.zeros(len(plan.ends))
    while at < spans - 2:
        away, wait, back = (int(n) for n in rng.integers(1, 8, 3))
        side = np.where(rng.random(len(plan.ends)) < 0.5, -1.0, 1.0) if rng.random() < 0.3 else [1.0, -1.0]
        speed = np.resize(side, len(plan.ends)) * rng.choice([1.0, 1.0, rng.uniform(0.0, 1.0)])
        out[:, at : at + away] = speed[:, None]
        place += speed * min(away, spans - at)
        at += away + wait
        if at < spans:
            out[:, at : at + back] = -place[:, None] / back
        place[:] = 0.0
        at += back
    return out


def run(seed: int, *, tight: bool = True, **options: float) -> Outcome:
    plan = tight_plan(seed, duration=3.0, **options) if tight else random_plan(seed, duration=2.5, **options)
    return attack(plan, knots(plan, worst_motions(plan, seed), SPAN))


def balanced(outcome: Outcome, seed: float = 0.0) -> None:
    for guard in outcome.guards.values():
        ledger = guard.ledger
        total = seed + ledger.credited + ledger.taken - ledger.given - ledger.paid - ledger.lost
        assert ledger.tank == pytest.approx(total, abs=1e-12 * max(1.0, ledger.credited + ledger.lost))
        assert ledger.tank >= 0.0


def test_no_motion_gets_energy_out():
    """Constant delays at the budget to the last bit, where the age rule has nothing to spare."""
    coupled = guarded = 0
    for seed in range(60):
        outcome = run(seed)
        assert outcome.supplied >= -1e-12 * outcome.scale
        balanced(outcome)
        coupled, guarded = coupled + outcome.coupled, guarded + outcome.guarded
    assert coupled > 150
    assert guarded > 80


@pytest.mark.parametrize("initial_energy", [0.0, 0.02])
def test_nor_over_bad_paths(initial_energy: float):
    """Two to five users, jitter, loss, outages of one way, clocks of their own, hands that push and follow."""
    coupled = 0
    for seed in range(20):
        options = {"initial_energy": initial_energy, "cap": 0.5} if seed % 2 else {"initial_energy": initial_energy}
        plan = random_plan(seed, **options)
        for policy in (greedy(seed), knots(plan, worst_motions(plan, seed), SPAN)):
            outcome = attack(plan, policy)
            assert outcome.supplied >= -initial_energy * len(outcome.guards) - 1e-12 * outcome.scale
            balanced(outcome, initial_energy)
            coupled += outcome.coupled
    assert coupled > 75


def spoiled(monkeypatch: pytest.MonkeyPatch, what: str) -> None:
    """Takes a part out of the guard."""
    if what == "a guarded sample is used":
        why = LinkGuard._why_guard
        monkeypatch.setattr(
            LinkGuard, "_why_guard",
            lambda self, end, fresh, rise: why(
                self, LinkHeader(LinkState.COUPLED, self._partner, end.known_epoch), fresh, rise
            ),
        )  # fmt: skip
    elif what == "going guarded is free":
        fall = LinkGuard._fall

        def free(self: LinkGuard, now: float, reason: str, tank: float) -> None:
            fall(self, now, reason, tank)
            self.tank += 1e9

        monkeypatch.setattr(LinkGuard, "_fall", free)
    elif what == "all damping is credited":
        settle = LinkGuard.settle

        def generous(self: LinkGuard, square: float, T: float) -> None:
            self._surplus = self.total
            settle(self, square, T)

        monkeypatch.setattr(LinkGuard, "settle", generous)
    elif what == "credit is doubled":
        book = LinkGuard.settle
        monkeypatch.setattr(LinkGuard, "settle", lambda self, square, T: book(self, 2.0 * square, T))
    elif what == "age does not matter":
        decide = LinkGuard.decide

        def blind(self: LinkGuard, sample: Sample, desired: float, held: float, now: float, T: float) -> float:
            old, self.budget = self.budget, 1e9
            fraction = decide(self, sample, desired, held, now, T)
            self.budget, self._surplus = old, 0.0
            return fraction

        monkeypatch.setattr(LinkGuard, "decide", blind)


def test_motions_found_by_a_search_get_nothing_out():
    for what in FOUND:
        outcome = found(what)
        assert outcome.coupled >= 2
        assert outcome.supplied >= -1e-12 * outcome.scale


@pytest.mark.parametrize("what", FOUND)
def test_they_break_a_guard_without_the_part(what: str, monkeypatch: pytest.MonkeyPatch):
    spoiled(monkeypatch, what)
    outcome = found(what)
    assert outcome.supplied < -0.1 * outcome.scale


def test_so_do_others_where_age_does_not_matter(monkeypatch: pytest.MonkeyPatch):
    spoiled(monkeypatch, "age does not matter")
    assert min(outcome.supplied / outcome.scale for outcome in map(run, range(60))) < -1e-3


# One end by hand.


def sample(k: int, header: LinkHeader, stamp: float | None = None) -> Sample:
    return Sample(sender=1, index=k, stamp=T * k if stamp is None else stamp, position=np.zeros(1), header=header)


def guard(**options: float) -> LinkGuard:
    start = Sample(sender=1, index=-1, stamp=0.0, position=np.zeros(1), header=NO_HEADER)
    made = LinkGuard(FreshestLink(start), **({"budget": 0.05, "total": 0.1, "initial_energy": 1.0} | options))
    made.attach(K)
    return made


def feed(
    end: LinkGuard, k: int, header: LinkHeader, desired: float = 0.0, held: float = 0.0, **options: float
) -> float:
    fraction = end.decide(sample(k, header, **options), desired, held, T * (k + 1), T)
    end.settle(0.0, T)
    return fraction


def couple(end: LinkGuard, epoch: int = 7) -> int:
    k = 0
    while end.state != LinkState.COUPLED:
        feed(end, k, LinkHeader(LinkState.READY if k > 3 else LinkState.GUARDED, epoch, end.epoch))
        k += 1
        assert k < 30
    return k


def test_an_end_couples_after_the_time_of_both_budgets():
    end = guard()
    assert couple(end) == 12  # ten or, with rounding, eleven steps of catching up before it
    assert [event.state for event in end.events] == [LinkState.COUPLED]
    end = guard()
    for k in range(15):
        feed(end, k, LinkHeader(LinkState.GUARDED, 7, 1))
    assert end.state == LinkState.READY
    assert end.header[:3] == (LinkState.READY, 1, 7)


@pytest.mark.parametrize(
    ("header", "options", "reason"),
    [
        (LinkHeader(LinkState.GUARDED, 7, 1), {}, "the other is guarded"),
        (LinkHeader(LinkState.READY, 8, 1), {}, "the other was guarded"),
        (LinkHeader(LinkState.COUPLED, 6, 1), {}, "the other was guarded"),
        (LinkHeader(LinkState.COUPLED, 7, 1), {"stamp": 0.0}, "too old"),
        (LinkHeader(LinkState.COUPLED, 7, 1), {"desired": 0.1}, "too much power"),
    ],
)
def test_what_guards_a_coupled_end(header: LinkHeader, options: dict[str, float], reason: str):
    end = guard(power=1.0, burst=1.0)
    k = couple(end)
    assert feed(end, k, LinkHeader(LinkState.COUPLED, 7, 1)) == 1.0
    feed(end, k + 1, header, **options)
    assert (end.state, end.epoch, end.events[-1].reason) == (LinkState.GUARDED, 2, reason)


@pytest.mark.parametrize(
    "header",
    [LinkHeader(LinkState.READY, 7, 0), LinkHeader(LinkState.COUPLED, 7, 3), LinkHeader(LinkState.COUPLED, 7, 2)],
)
def test_an_end_that_is_not_heard_in_this_epoch_stays_guarded(header: LinkHeader):
    end = guard(epoch=1)
    for k in range(40):
        feed(end, k, header)
    assert end.state == LinkState.GUARDED


def test_going_guarded_is_paid_from_the_tank():
    end = guard(initial_energy=1.0)
    k = couple(end)
    fraction = feed(end, k, LinkHeader(LinkState.GUARDED, 7, 1), desired=0.01, held=0.01)  # ½ K 0.01 = 0.25 J
    assert (fraction, end.tank) == (1.0, pytest.approx(0.75))
    end = guard(initial_energy=0.0625)
    k = couple(end)
    assert feed(end, k, LinkHeader(LinkState.GUARDED, 7, 1), desired=0.01, held=0.01) == pytest.approx(0.5)
    assert end.tank == 0.0
    end = guard(initial_energy=0.0)
    k = couple(end)
    assert feed(end, k, LinkHeader(LinkState.GUARDED, 7, 1), desired=0.01, held=0.01) == 0.0


def test_the_tank_that_stays_at_coupling_is_the_least_of_the_time_before():
    end = guard(initial_energy=1.0)
    for k in range(12):
        feed(end, k, LinkHeader(LinkState.GUARDED, 7, 1), desired=0.02 if k == 6 else 0.0, held=0.02 if k == 7 else 0.0)
    assert end.tank == 1.0
    feed(end, 12, LinkHeader(LinkState.READY, 7, 1))
    assert (end.state, end.tank) == (LinkState.COUPLED, pytest.approx(0.5))


def test_what_the_other_gave_is_taken_once():
    end = guard(initial_energy=1.0)
    for k, total in enumerate((0.7, 0.7, 0.9, 0.8, 0.9, 1.4)):  # of before it was heard, again, more, overtaken, more
        feed(end, k, LinkHeader(LinkState.GUARDED, 7, 1, given=total))
    assert end.tank == pytest.approx(1.0 + 0.2 + 0.5)
    assert end.ledger.taken == pytest.approx(0.7)


def test_what_the_other_says_it_gave_comes_no_faster_than_its_power_and_as_far_as_there_is_room():
    end = guard(initial_energy=1.0, cap=1.2, power=2.0)
    feed(end, 0, LinkHeader(LinkState.GUARDED, 7, 1, given=1e12))
    for k in range(1, 40):
        feed(end, k, LinkHeader(LinkState.GUARDED, 7, 1, given=2e12))
        ledger = end.ledger
        assert ledger.received == ledger.taken == pytest.approx(min(0.2, 2.0 * T * k))
        assert end.tank == pytest.approx(1.0 + ledger.received)
        assert ledger.lost == 0.0
    # Nothing of it is there twice: what there was no room for is taken when there is.
    end = guard(initial_energy=1.0, cap=1.2, power=2.0)
    for k in range(61):
        header = LinkHeader(LinkState.GUARDED, 7, 1, given=0.3 if k else 0.0)
        feed(end, k, header, desired=0.0 if k < 30 else 0.02, held=0.0 if k <= 30 else 0.02)
    assert end.ledger.received == pytest.approx(0.3)


def test_of_a_leap_in_what_the_other_gave_one_tank_is_believed():
    """Else one number would fill the tank again and again, for as long as the link lives."""
    end = guard(initial_energy=0.1, cap=0.1, power=50.0)
    for k in range(200):
        spends = k % 2 == 0
        header = LinkHeader(LinkState.GUARDED, 7, 1, given=1e12 if k else 0.0)
        feed(end, k, header, desired=1.0 if spends else 0.0, held=0.0)
    assert end.ledger.paid > 0.1  # there was room for more
    assert end.ledger.received == pytest.approx(0.1)
    for k in range(200, 240):  # what is given afterwards is taken
        feed(end, k, LinkHeader(LinkState.GUARDED, 7, 1, given=1e12 + 0.03125), desired=1.0 if k % 2 else 0.0, held=0.0)
    assert end.ledger.received == pytest.approx(0.1 + 0.03125, abs=1e-4)


@pytest.mark.parametrize("stamp", [0.2, 1e6, 1e10])
def test_stamps_of_the_future_leave_no_more_of_the_damping_over_than_there_is(stamp: float):
    end = guard(total=0.1)
    k = couple(end)
    before = end.ledger.credited
    end.decide(sample(k, LinkHeader(LinkState.COUPLED, 7, 1), stamp=stamp), 0.0, 0.0, T * (k + 1), T)
    end.settle(1.0, T)
    assert end.ledger.credited - before <= 0.5 * K * 0.1 * 1.0 * T * (1.0 + 1e-12)


def test_a_newcomer_is_let_come_before_what_the_tank_holds_is_spent():
    end, other = guard(initial_energy=1.0, patience=0.5), guard(initial_energy=1.0)
    header, spent = LinkHeader(LinkState.GUARDED, 7, 1, starved=True), list[float]()
    for k in range(60):
        feed(end, k, header, desired=1.0, held=2.0 * end.ledger.potential / K)
        spent += [end.ledger.potential]
    feed(other, 0, header, desired=1.0)
    assert other.ledger.potential == 1.0
    assert spent[0] == 0.0
    assert spent[5] == pytest.approx(0.01, rel=0.2)
    assert spent[-1] == pytest.approx(1.0)
    assert not np.any(np.diff(spent) < -1e-12)
    # As long as it waits it lacks nothing.
    assert not guard(initial_energy=1e-9, patience=0.5).starved
    late = guard(initial_energy=1e-9, patience=0.5)
    feed(late, 0, header, desired=1.0)
    assert not late.starved


def test_an_end_that_has_caught_up_gives_what_the_other_lacks_and_no_more_than_it_has_for_certain():
    end = guard(initial_energy=1.0)
    for k in range(8):
        feed(end, k, LinkHeader(LinkState.GUARDED, 7, 1))
    assert end.header.given == 0.0  # nobody lacks anything
    end.help(0.5)  # it may belong to a coupled link, if the other end has just coupled
    feed(end, 8, LinkHeader(LinkState.GUARDED, 7, 1, starved=True))
    assert (end.header.given, end.tank) == (pytest.approx(1.0), pytest.approx(0.5))
    for k in range(9, 40):
        feed(end, k, LinkHeader(LinkState.GUARDED, 7, 1, starved=True))
    assert (end.header.given, end.tank) == (pytest.approx(1.5), pytest.approx(0.0))


def test_an_end_that_could_not_pay_says_so():
    end = guard(initial_energy=0.01)
    assert feed(end, 0, LinkHeader(LinkState.GUARDED, 7, 1), desired=0.01) < 1.0
    assert end.header.starved
    feed(end, 1, LinkHeader(LinkState.GUARDED, 7, 1), stamp=-9.0, desired=0.01)  # too old: energy would not help
    assert not end.header.starved


def test_copies_at_rest_apart_meet_by_what_the_hand_of_one_put_in():
    """One is held away from the other all the time; the other, alone, has lost its energy long ago."""
    ways = {pair: Way(0.02) for pair in ((0, 1), (1, 0))}
    plan = Plan([T * np.arange(1, 1200) for _ in range(2)], [(0, 1)], ways, {(0, 1): 0.05, (1, 0): 0.05}, [0.0, 0.0])

    def hold(i: int, k: int, force: float, damping: float) -> float:
        if i == 0:
            return 0.2 if k < 50 else 0.0
        return force / (damping + 5.0)  # a damper of its own takes what the link's does not

    outcome = attack(plan, hold)
    assert {end.state for end in outcome.guards.values()} == {LinkState.COUPLED}
    assert outcome.spread < 1e-3
    assert outcome.supplied >= 0.0
    balanced(outcome)


def test_an_end_that_was_ready_and_falls_back_gets_no_spring_that_it_cannot_pay():
    """Budgets are raised while it waits; the other end has all that was in its tank, and may have coupled."""
    end = guard(initial_energy=0.0625)
    for k in range(15):
        feed(end, k, LinkHeader(LinkState.GUARDED, 7, 1, starved=True))
    assert end.state == LinkState.READY
    end.total = 1.0
    assert feed(end, 15, LinkHeader(LinkState.GUARDED, 7, 1), desired=0.01, held=0.01) == 0.0
    assert (end.state, end.tank, end.ledger.potential) == (LinkState.GUARDED, 0.0, 0.0)


@given(st.floats(1e-6, 1e3), st.floats(0.0, 10.0), st.booleans())
def test_the_force_is_limited(limit: float, distance: float, together: bool):
    end = guard(force=limit, initial_energy=1e9)
    k = couple(end) if together else 0
    fraction = feed(end, k, LinkHeader(LinkState.COUPLED, 7, 1), desired=distance**2)
    assert K * fraction * distance <= limit * (1 + 1e-12)
    assert end.state == (LinkState.COUPLED if together else LinkState.GUARDED)
    assert K * distance >= limit or fraction == 1.0


def test_a_violent_neighbour_gets_no_more_in_than_the_power_it_has():
    """It jumps to and fro by a metre, in time and in the right words."""
    end, power, burst = guard(power=2.0, burst=0.5, initial_energy=100.0), 2.0, 0.5
    rng, held, work = np.random.default_rng(0), 0.0, 0.0
    for k in range(2000):
        y = float(rng.normal())
        fraction = end.decide(sample(k, LinkHeader(LinkState.READY, 7, end.epoch)), y * y, held * held, T * (k + 1), T)
        before = 0.5 * K * held**2
        held = fraction * y
        work += max(0.0, 0.5 * K * held**2 - before)
        end.settle(0.0, T)
        assert work <= burst + power * T * (k + 1) + 1e-9
    assert work > 0.9 * power * T * 2000


@pytest.mark.parametrize("desired", [np.inf, np.nan])
def test_a_sample_at_no_finite_distance_has_no_force(desired: float):
    end = guard()
    assert feed(end, 0, LinkHeader(LinkState.READY, 7, 1), desired=desired) == 0.0
    assert end.tank == 1.0


def test_rounding_is_paid():
    end = guard(rounding=1e-3, initial_energy=0.1)
    charge = K * 1e-6 * 17
    k = couple(end)
    assert end.tank == pytest.approx(0.1 - charge)
    end.settle(4.0, T)
    left = 0.05 - 0.1 / 16.0  # of the budget
    surplus = left - T - 0.5 * T
    assert end.tank == pytest.approx(0.1 - charge + 0.5 * K * surplus * 4.0 * T - K * 1e-3 * 2.0 * T)
    poor = guard(rounding=1e-3, initial_energy=0.5 * charge)
    for k in range(40):
        feed(poor, k, LinkHeader(LinkState.READY, 7, 1))
    assert poor.state == LinkState.READY
    broke = guard(rounding=1e-3, initial_energy=charge * 1.0001)
    k = couple(broke)
    just = T * (k + 1) - left + 0.25 * T  # so old that of the budget half a step is not left
    feed(broke, k, LinkHeader(LinkState.COUPLED, 7, 1), stamp=just)
    assert broke.state == LinkState.COUPLED
    broke.settle(1.0, T)
    assert broke.tank < 0.0
    feed(broke, k + 1, LinkHeader(LinkState.COUPLED, 7, 1), desired=1e-4)
    assert (broke.state, broke.events[-1].reason) == (LinkState.GUARDED, "rounding")


def test_copies_meet_again_after_an_outage():
    """Moved apart while nothing passes; then somebody moves a little, and all is coupled again, at one place."""
    ways = {pair: Way(0.02, outages=[(1.0, 2.0)]) for pair in ((0, 1), (1, 0))}
    ends = [T * np.arange(1, 900) for _ in range(2)]
    plan = Plan(ends, [(0, 1)], ways, {(0, 1): 0.05, (1, 0): 0.05}, [5.0, -3.0], {"initial_energy": 1e-3})

    def follow(i: int, k: int, force: float, damping: float) -> float:
        if 100 <= k < 200:
            return 0.3 if i else -0.3
        return force / (damping + 2.0)

    outcome = attack(plan, follow)
    assert {end.state for end in outcome.guards.values()} == {LinkState.COUPLED}
    assert outcome.spread < 1e-3
    assert outcome.supplied >= -2e-3
    assert outcome.force < K * 0.6


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"balance": 0.0}, "balance"),
        ({"initial_energy": -1.0}, "initial_energy"),
        ({"cap": 0.5}, "cap"),
        ({"force": 0.0}, "force"),
        ({"power": np.nan}, "power"),
        ({"burst": 0.0}, "burst"),
        ({"rounding": -1.0}, "rounding"),
        ({"epoch": 0}, "epoch"),
    ],
)
def test_options_that_cannot_be_are_named(options: dict[str, float], message: str):
    with pytest.raises(NetworkError, match=message):
        guard(**options)
