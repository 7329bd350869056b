"""The engine of the laboratory: the same for many, on all cores or a Dask cluster, resumed where it was interrupted."""

import hashlib
import json
import marshal
from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import partial
from pathlib import Path
from typing import TypeAlias, TypeVar, cast, final

from cotouch.errors import OutputError, ScenarioError
from cotouch.files import folder, look, read_text, table_of, write
from cotouch.interrupt import check, flag, heeding
from cotouch.planning import workers
from cotouch.stamps import stamp_of

A = TypeVar("A")
R = TypeVar("R")

# How much is done, of how much, and what.
Progress: TypeAlias = Callable[[int, int, str], None]

# A cluster is given so many cells at once for each of its threads; what they bring is kept before it gets more.
_AHEAD = 4


@final
class Store:
    """Results of cells in a folder, a file each, so that an interrupted study goes on where it was.

    A file is named by all that its result follows from, so another study, or a changed one, finds nothing of it.
    """

    def __init__(self, place: Path, version: str) -> None:
        """Takes up a folder.

        Args:
            place: of the files; made if need be.
            version: of what computes; another one computes anew.

        Raises:
            OutputError: it cannot be made.
        """
        self._place = folder(place)
        self._version = version

    def name(self, what: str, cell: object) -> str:
        """Of the file of a cell, for all that its result follows from.

        Args:
            what: sort of the result, as it stands before the digest in the name.
            cell: all that the result follows from; anything that JSON can hold.
        """
        text = json.dumps([self._version, what, cell], sort_keys=True, allow_nan=True)
        return f"{what}-{hashlib.sha256(text.encode()).hexdigest()[:24]}.json"

    def find(self, name: str) -> dict[str, object] | None:
        """A result that is there; None where there is none, or none that can be read."""
        path = self._place / name
        if not path.is_file():
            return None
        try:
            return table_of(json.loads(read_text(path, "cell", OutputError)))
        except (OutputError, ValueError):
            return None

    def keep(self, name: str, result: object) -> None:
        """Writes a result, whole or not at all.

        Args:
            name: of the file, from `name`.
            result: as `found` gives it back; anything that JSON can hold.
        """
        write(self._place / name, json.dumps(result).encode(), "cell")


def source_of(made: Callable[..., object]) -> str:
    """Of all that a function is made of, so that with another version of it cells are computed anew.

    That is its file and what this package's files that it imports are made of; of one without a file, such as one that
    was typed in, what Python has made of it; nothing of one that is not written in Python. Modules of somebody else's
    that it imports do not count.

    Args:
        made: the function, compiled or not, or a part of one.
    """
    plain = made.func if isinstance(made, partial) else made
    plain = getattr(plain, "py_func", plain)
    code = getattr(plain, "__code__", None) or getattr(type(plain).__call__, "__code__", None)
    if code is None:  # not written in Python
        return ""
    path = Path(code.co_filename)
    try:
        # The file as it is now: what it imports was read when it was first asked.
        text = path.read_bytes() + stamp_of(path)[0].encode()
    except OSError:
        # The second format does not depend on who else holds the code's parts.
        text = marshal.dumps(code.replace(co_filename=""), 2)
    return hashlib.sha256(text).hexdigest()[:16]


def contents_of(files: Iterable[Path]) -> list[str]:
    """Digests of what files hold, for what follows from them; "" of one that cannot be read.

    Args:
        files: that a cell reads, by names that may stay the same while what is in them changes.
    """
    return [_digest(file) for file in files]


def _digest(file: Path) -> str:
    try:
        look(file, "file", OutputError)
        with file.open("rb") as opened:
            return hashlib.file_digest(opened, "sha256").hexdigest()[:16]
    except (OSError, OutputError):
        return ""


def many(function: Callable[[A], R], items: Sequence[A], jobs: int = -1) -> list[R]:
    """What a function makes of each item, in their order.

    Args:
        function: of an item.
        items: any number.
        jobs: how many at once; -1: one per core.
    """
    found = dict(_done(function, items, jobs, None))
    return [found[at] for at in range(len(items))]


def cells(
    what: str,
    function: Callable[[A], R],
    items: Sequence[A],
    *,
    jobs: int = -1,
    dask: str | None = None,
    store: Store | None = None,
    progress: Progress | None = None,
) -> list[R]:
    """The same with plain results, which are kept one by one as they come and not computed again.

    Args:
        what: names the cells, in files and in progress.
        function: of a cell; whatever it makes is JSON.
        items: the cells, JSON too: all that their results follow from.
        jobs: how many at once; -1: one per core.
        dask: address of a Dask scheduler whose workers do it instead.
        store: of results; None: none are kept.
        progress: told after each.
    """
    names = ["" if store is None else store.name(what, item) for item in items]
    kept: dict[int, R] = {
        at: cast("R", found)
        for at, name in enumerate(names)
        if store is not None and (found := store.find(name)) is not None
    }
    left = [at for at in range(len(items)) if at not in kept]
    done = len(kept)
    if progress is not None:
        progress(done, len(items), what)
    for which, result in _done(function, [items[at] for at in left], jobs, dask):
        at = left[which]
        kept[at] = result
        if store is not None:
            store.keep(names[at], result)
        done += 1
        if progress is not None:
            progress(done, len(items), what)
    return [kept[at] for at in range(len(items))]


def _done(function: Callable[[A], R], items: Sequence[A], jobs: int, dask: str | None) -> Iterator[tuple[int, R]]:
    """Results as they come, with their numbers."""
    if jobs != -1 and jobs < 1:
        raise ScenarioError(f"jobs is {jobs}; it must be at least 1, or -1 for one per core")
    import joblib

    if dask is not None:
        with workers(jobs, dask) as hands:
            size = _AHEAD * max(hands.jobs, 1)
            for start in range(0, len(items), size):
                calls = [joblib.delayed(function)(item) for item in items[start : start + size]]
                yield from enumerate(hands.parallel(calls), start)
        return
    stop = flag()

    def each(at: int, item: A) -> tuple[int, R]:
        with heeding(stop):  # threads, because kernels hold no lock
            check()
            return at, function(item)

    parallel = joblib.Parallel(n_jobs=jobs, backend="threading", return_as="generator_unordered")
    yield from parallel(joblib.delayed(each)(at, item) for at, item in enumerate(items))
