"""Who works: the cores of this machine, or those of a Dask cluster."""

import time
from collections.abc import Callable, Generator, Iterable, Mapping
from contextlib import AbstractContextManager, ExitStack, contextmanager
from typing import Protocol, TypeAlias, TypeVar, cast, final

from cotouch.errors import UnsupportedError
from cotouch.interrupt import check

R = TypeVar("R")
R_co = TypeVar("R_co", covariant=True)
# What `joblib.delayed` makes of a function's arguments.
Call: TypeAlias = tuple[Callable[..., R], tuple[object, ...], dict[str, object]]

# A scheduler is given so long to answer, and to have workers; and so long is waited for new ones once all are lost [s].
_ANSWER, _PATIENCE = 10.0, 5.0
_LOOK = 0.2


class Parallel(Protocol):
    """Does calls made by `joblib.delayed` and gives their results in order."""

    def __call__(self, calls: Iterable[Call[R]], /) -> list[R]:
        """Results of the calls."""
        ...


class _Future(Protocol[R_co]):
    """What is used of a call that a worker of a cluster does."""

    @property
    def status(self) -> str: ...

    def done(self) -> bool: ...

    def result(self) -> R_co: ...

    def cancel(self) -> object: ...


class _Client(Protocol):
    """What is used of a `distributed.Client`."""

    @property
    def status(self) -> str: ...

    def submit(self, function: Callable[..., R], /, *given: object, pure: bool, **named: object) -> _Future[R]: ...

    def scheduler_info(self) -> Mapping[str, Mapping[str, Mapping[str, int]]]: ...


@final
class Workers:
    """Those who work.

    Attributes:
        parallel: does calls made by `joblib.delayed` and gives their results in order.
        jobs: how many things are done at once.
    """

    def __init__(self, parallel: Parallel, jobs: int) -> None:
        """Takes up who works."""
        self.parallel = parallel
        self.jobs = jobs

    @property
    def notes(self) -> tuple[str, ...]:
        """Sentences on what did not go as asked."""
        return getattr(self.parallel, "notes", ())


@final
class Cluster:
    """Calls shared among the workers of a Dask cluster; what they leave undone is done here.

    A worker that is lost costs nothing but time, for the scheduler hands its calls to the others and each gives the
    same wherever it is made. Once all are lost, calls are made here.
    """

    def __init__(
        self,
        client: _Client,
        here: Parallel,
        *,
        patience: float = _PATIENCE,
        clock: Callable[[], float] = time.monotonic,
        sleep: Callable[[float], None] = time.sleep,
    ) -> None:
        """Takes up a cluster.

        Args:
            client: a `distributed.Client`.
            here: does the calls without it.
            patience: seconds without any worker after which it is given up.
            clock: seconds that only grow.
            sleep: waits for so many seconds.
        """
        self._client = client
        self._here = here
        self._patience = patience
        self._clock = clock
        self._sleep = sleep
        self._given_up = False
        self.notes: tuple[str, ...] = ()

    def wait_for_workers(self) -> int:
        """Threads of the workers that are there, or come within the patience; 0 gives the cluster up."""
        begun = self._clock()
        while not (count := self._threads()) and self._clock() - begun < self._patience:
            check()
            self._sleep(_LOOK)
        if not count:
            self._give_up("The Dask scheduler has no workers")
        return count

    def __call__(self, calls: Iterable[Call[R]], /) -> list[R]:
        """Results of the calls, in order."""
        every = list(calls)
        if self._given_up:
            return self._here(every)
        futures = [self._client.submit(function, *given, pure=False, **named) for function, given, named in every]
        seen = self._clock()
        while not all(future.done() for future in futures):
            check()
            if self._threads():
                seen = self._clock()
            elif self._clock() - seen >= self._patience:
                self._give_up("All Dask workers were lost")
                break
            self._sleep(min(_LOOK, 0.01 if self._clock() - seen < 0.1 else _LOOK))
        left = [at for at, future in enumerate(futures) if future.status != "finished"]
        done = {at: future.result() for at, future in enumerate(futures) if future.status == "finished"}
        for at in left:
            futures[at].cancel()
        done |= dict(zip(left, self._here([every[at] for at in left]), strict=True)) if left else {}
        return [done[at] for at in range(len(every))]

    def _threads(self) -> int:
        if self._client.status != "running":
            return 0
        return sum(worker.get("nthreads", 0) for worker in self._client.scheduler_info()["workers"].values())

    def _give_up(self, why: str) -> None:
        self._given_up = True
        self.notes += (f"{why}; the search was finished on this machine.",)


@contextmanager
def workers(jobs: int, dask: str | None) -> Generator[Workers]:
    """Threads of this process, because the kernels hold no lock, or the workers of a Dask cluster.

    Args:
        jobs: number of threads; -1 for one per core.
        dask: address of a Dask scheduler, such as `tcp://host:8786`. One without workers leaves the work to this
            machine.

    Raises:
        UnsupportedError: there is no Dask here, or no scheduler answers.
    """
    import joblib

    with ExitStack() as stack:
        count = joblib.cpu_count() if jobs == -1 else jobs
        client = None if dask is None else stack.enter_context(_client(dask))
        stack.enter_context(joblib.parallel_config(backend="threading", n_jobs=count))
        here = stack.enter_context(joblib.Parallel())
        if client is None:
            yield Workers(here, count)
            return
        cluster = Cluster(client, here)
        yield Workers(cluster, cluster.wait_for_workers() or count)


def _client(dask: str) -> AbstractContextManager[_Client]:
    try:
        from distributed import Client
    except ImportError:
        raise UnsupportedError('dask is asked for but not installed; install "cotouch[dask]"') from None
    try:
        return cast("AbstractContextManager[_Client]", Client(dask, timeout=_ANSWER))
    except (OSError, ValueError) as error:
        raise UnsupportedError(f'no Dask scheduler answers at "{dask}"; start one or correct the address') from error
