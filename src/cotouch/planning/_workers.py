"""Who works: the cores of this machine, or those of a Dask cluster."""

from collections.abc import Generator
from contextlib import ExitStack, contextmanager
from typing import Any, NamedTuple

from cotouch.errors import UnsupportedError


class Workers(NamedTuple):
    """Those who work.

    Attributes:
        parallel: a `joblib.Parallel`.
        jobs: how many things are done at once.
    """

    parallel: Any
    jobs: int


@contextmanager
def workers(jobs: int, dask: str | None) -> Generator[Workers]:
    """Threads of this process, because the kernels hold no lock, or the workers of a Dask cluster.

    Args:
        jobs: number of threads; -1 for one per core.
        dask: address of a Dask scheduler, such as `tcp://host:8786`.

    Raises:
        UnsupportedError: there is no Dask here, or no scheduler answers.
    """
    import joblib

    with ExitStack() as stack:
        if dask is None:
            count = joblib.cpu_count() if jobs == -1 else jobs
            stack.enter_context(joblib.parallel_config(backend="threading", n_jobs=count))
        else:
            client = stack.enter_context(_client(dask))
            count = max(sum(client.nthreads().values()), 1)
            stack.enter_context(joblib.parallel_config(backend="dask", n_jobs=-1))
        yield Workers(stack.enter_context(joblib.Parallel()), count)


def _client(dask: str) -> Any:
    try:
        from distributed import Client
    except ImportError:
        raise UnsupportedError('dask is asked for but not installed; install "cotouch[dask]"') from None
    try:
        return Client(dask, timeout=10)
    except (OSError, ValueError) as error:
        raise UnsupportedError(f'no Dask scheduler answers at "{dask}"; start one or correct the address') from error
