"""Work that ends when its time is up or when it is interrupted."""

import threading
import time
from itertools import count

import numpy as np
import pytest
from tests.planning.inside import aside, in_real_time
from tests.planning.support import five_users

from cotouch.interrupt import Flag, check, flag, heeding
from cotouch.network import Network
from cotouch.planning import CountsInterrupted, TuningInterrupted, plan_counts, tune_springs, until, worked


def raised(some: Flag) -> None:
    for _ in range(500):
        if some[0]:
            return
        threading.Event().wait(0.01)
    raise AssertionError("never raised")


def test_late_or_asked_raises_the_flag_inside_and_no_other() -> None:
    outer: Flag = np.zeros(1, dtype=np.int64)
    with heeding(outer):
        with until(lambda: True):
            raised(flag())
        assert not outer[0]
        with until(lambda: False):
            assert not flag()[0]
            outer[0] = 1
            raised(flag())
        assert flag() is outer
    assert outer[0] > 1, "who interrupted it waits for what it has to tell"


def test_what_hears_no_flag_is_left_alone() -> None:
    stop: Flag = np.zeros(1, dtype=np.int64)
    begun, go = threading.Event(), threading.Event()
    threading.Thread(target=lambda: begun.wait() and stop.fill(1)).start()
    with pytest.raises(KeyboardInterrupt):
        aside(lambda: (begun.set(), go.wait()), stop)
    go.set()
    with pytest.raises(KeyboardInterrupt):
        aside(lambda: pytest.fail("nothing is begun once it is raised"), stop)
    assert aside(lambda: 3) == 3
    with pytest.raises(ZeroDivisionError):
        aside(lambda: 1 / 0)


def test_a_tuning_out_of_time_has_the_best_so_far(monkeypatch: pytest.MonkeyPatch) -> None:
    def improve(*_: object) -> None:
        raised(flag())
        check()

    monkeypatch.setattr("cotouch.planning._spring_search.Search.improve", improve)
    times = count()
    late = tune_springs(five_users(), damping_limit=42.0, spread=False, seconds=1.0, clock=lambda: float(next(times)))
    assert late.after == late.before < 0
    assert np.max(late.sync_damping) <= 42.0 * (1 + 1e-9)


def test_an_interrupted_tuning_has_the_best_so_far(monkeypatch: pytest.MonkeyPatch) -> None:
    own: Flag = np.zeros(1, dtype=np.int64)

    def improve(search: object, *_: object) -> None:
        own[0] = 1
        raise KeyboardInterrupt

    monkeypatch.setattr("cotouch.planning._spring_search.Search.improve", improve)
    caught: list[TuningInterrupted] = []

    def work() -> None:
        with heeding(own):
            try:
                tune_springs(five_users(), damping_limit=42.0, spread=False)
            except TuningInterrupted as interrupted:
                caught.append(interrupted)

    thread = threading.Thread(target=work)
    thread.start()
    thread.join()
    (interrupted,) = caught
    assert interrupted.tuned.after == interrupted.tuned.before < 0


def test_several_numbers_of_links_tell_those_there_are() -> None:
    def interrupt(done: int, total: int, best: float) -> None:
        if total == 252:  # with five links
            raise KeyboardInterrupt

    with pytest.raises(CountsInterrupted) as caught:
        plan_counts(five_users(), links=[4, 5, 6], objective="decay", progress=interrupt, jobs=1)
    counts = caught.value.counts
    assert [len(one.best.links) for one in counts.plans] == [4, 5]
    assert caught.value.plan is counts.best
    assert counts.plans[1].graphs < 252


def test_a_limit_on_drag_counts_for_springs_too() -> None:
    network: Network = five_users()
    free = tune_springs(network, damping_limit=42.0, damping=3.0, rounds=4, spread=False)

    def drag(tuned: object) -> float:
        return 4.0 * float(sum(tuned.sync_damping)) / 2.0 + 3.0  # type: ignore[attr-defined]

    limit = 0.6 * drag(free)
    kept = tune_springs(network, damping_limit=42.0, drag_limit=limit, damping=3.0, rounds=4, spread=False)
    assert drag(kept) <= limit * (1 + 1e-9)
    assert drag(kept) > 0.5 * limit


def test_a_budget_lasts_longer_where_others_have_the_processors() -> None:
    begun, wall = worked(), time.monotonic()
    time.sleep(0.4)
    passed = time.monotonic() - wall
    assert passed / 4 <= worked() - begun < passed / 2
    begun, work = worked(), time.process_time()
    while time.process_time() - work < 0.2:
        pass
    assert worked() - begun >= 0.2


def test_a_thread_watches_clocks_that_go_on_by_themselves_only() -> None:
    assert in_real_time(worked)
    assert in_real_time(time.monotonic)
    assert not in_real_time(count(0.0, 1e-6).__next__)
