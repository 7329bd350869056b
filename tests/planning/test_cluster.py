"""Work shared with a cluster whose workers come, go and are lost, at moments that the test chooses."""

from collections.abc import Callable
from dataclasses import dataclass, field

import pytest
from joblib import delayed
from tests.planning.inside import Cluster


@dataclass
class Future:
    """Work that somebody does, or nobody."""

    work: Callable[[], object]
    status: str = "pending"
    value: object = None

    def done(self) -> bool:
        return self.status != "pending"

    def result(self) -> object:
        return self.value

    def cancel(self) -> None:
        self.status = "cancelled"


@dataclass
class Client:
    """A client of a scheduler, with the workers that the test says."""

    workers: int
    status: str = "running"
    futures: list[Future] = field(default_factory=list)

    def submit(self, function, *given, pure, **named):
        assert not pure
        self.futures.append(Future(lambda: function(*given, **named)))
        return self.futures[-1]

    def scheduler_info(self):
        return {"workers": {str(worker): {"nthreads": 2} for worker in range(self.workers)}}

    def finish(self, *which: int) -> None:
        for at in which:
            self.futures[at].value, self.futures[at].status = self.futures[at].work(), "finished"


class Time:
    """A clock that only sleeping moves, and what happens at which second."""

    def __init__(self) -> None:
        self.now = 0.0
        self.events: list[tuple[float, Callable[[], None]]] = []

    def sleep(self, seconds: float) -> None:
        self.now += seconds
        for at, event in [entry for entry in self.events if entry[0] <= self.now]:
            self.events.remove((at, event))
            event()


def cluster(client: Client, time: Time):
    here: list[int] = []

    def at_home(calls):
        every = list(calls)
        here.append(len(every))
        return [function(*given, **named) for function, given, named in every]

    return Cluster(client, at_home, patience=5.0, clock=lambda: time.now, sleep=time.sleep), here


def calls(count: int):
    return [delayed(pow)(n, 2) for n in range(count)]


def test_results_come_in_order_whoever_is_first():
    client, time = Client(workers=2), Time()
    shared, here = cluster(client, time)
    time.events = [(1.0, lambda: client.finish(2, 0)), (2.0, lambda: client.finish(1))]
    assert shared(calls(3)) == [0, 1, 4]
    assert (here, shared.notes) == ([], ())


def test_a_worker_lost_in_mid_run_changes_nothing():
    client, time = Client(workers=2), Time()
    shared, here = cluster(client, time)
    time.events = [
        (0.5, lambda: client.finish(0)),
        (1.0, lambda: setattr(client, "workers", 1)),
        (30.0, lambda: client.finish(1, 2)),  # by the one that is left
    ]
    assert shared(calls(3)) == [0, 1, 4]
    assert (here, shared.notes) == ([], ())


@pytest.mark.parametrize("how", ["workers", "scheduler"])
def test_all_lost_in_mid_run_is_finished_here_within_ten_seconds(how):
    client, time = Client(workers=2), Time()
    shared, here = cluster(client, time)
    lose = {"workers": ("workers", 0), "scheduler": ("status", "closed")}[how]
    time.events = [(0.5, lambda: client.finish(1)), (1.0, lambda: setattr(client, *lose))]
    assert shared(calls(4)) == [0, 1, 4, 9]
    assert here == [3]
    assert 5.0 < time.now < 10.0
    assert shared.notes == ("All Dask workers were lost; the search was finished on this machine.",)
    assert shared(calls(2)) == [0, 1]
    assert here == [3, 2]


def test_workers_that_come_back_in_time_go_on():
    client, time = Client(workers=1), Time()
    shared, here = cluster(client, time)
    time.events = [
        (1.0, lambda: setattr(client, "workers", 0)),
        (4.0, lambda: setattr(client, "workers", 1)),
        (8.0, lambda: setattr(client, "workers", 0)),
        (12.0, lambda: setattr(client, "workers", 1)),
        (13.0, lambda: client.finish(0, 1)),
    ]
    assert shared(calls(2)) == [0, 1]
    assert (here, shared.notes) == ([], ())


def test_a_scheduler_without_workers_leaves_all_to_this_machine():
    client, time = Client(workers=0), Time()
    shared, here = cluster(client, time)
    assert shared.wait_for_workers() == 0
    assert time.now < 10.0
    assert shared(calls(2)) == [0, 1]
    assert (here, client.futures) == ([2], [])
    assert shared.notes == ("The Dask scheduler has no workers; the search was finished on this machine.",)


def test_workers_that_come_late_are_waited_for():
    client, time = Client(workers=0), Time()
    shared, _ = cluster(client, time)
    time.events = [(3.0, lambda: setattr(client, "workers", 3))]
    assert shared.wait_for_workers() == 6
    assert shared.notes == ()
