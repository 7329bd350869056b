"""The engine of the laboratory: order, resuming, a cluster, and what interrupts it."""

from functools import partial
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from tests.laboratory.inside import Store, cells, many, source_of

from cotouch import stamps
from cotouch.laws import law_named


def double(cell: dict[str, Any]) -> dict[str, Any]:
    return {"twice": 2 * cell["number"]}


CELLS = [{"number": number} for number in range(7)]


@pytest.mark.parametrize("jobs", [1, 3])
def test_results_come_in_the_order_of_the_cells(jobs: int) -> None:
    assert many(lambda number: number**2, list(range(20)), jobs) == [number**2 for number in range(20)]
    assert [found["twice"] for found in cells("double", double, CELLS, jobs=jobs)] == [0, 2, 4, 6, 8, 10, 12]


class Stop(Exception):
    """Somebody pulls the plug."""


def test_what_was_done_before_an_interruption_is_not_done_again(tmp_path: Path) -> None:
    done: list[int] = []

    def counted(cell: dict[str, Any]) -> dict[str, Any]:
        done.append(cell["number"])
        return double(cell)

    def plug(count: int, _total: int, _what: str) -> None:
        if count == 3:
            raise Stop

    with pytest.raises(Stop):
        cells("double", counted, CELLS, jobs=1, store=Store(tmp_path, "1"), progress=plug)
    before = set(done)
    assert len(list(tmp_path.iterdir())) == 3
    done.clear()
    told: list[tuple[int, int]] = []
    found = cells(
        "double", counted, CELLS, jobs=1, store=Store(tmp_path, "1"), progress=lambda n, all_, _: told.append((n, all_))
    )
    assert [each["twice"] for each in found] == [0, 2, 4, 6, 8, 10, 12]
    assert told[0] == (3, 7)
    assert told[-1] == (7, 7)
    assert len(done) == 4
    assert before | set(done) == set(range(7))


def test_another_version_or_cell_or_a_spoilt_file_is_computed(tmp_path: Path) -> None:
    store = Store(tmp_path, "1")
    cells("double", double, CELLS[:1], store=store)
    (file,) = tmp_path.iterdir()
    assert store.find(file.name) == {"twice": 0}
    assert Store(tmp_path, "2").find(Store(tmp_path, "2").name("double", CELLS[0])) is None
    assert store.find(store.name("double", CELLS[1])) is None
    file.write_text("{half", encoding="utf-8")
    assert cells("double", double, CELLS[:1], store=store) == [{"twice": 0}]
    assert store.find(file.name) == {"twice": 0}


def test_a_law_is_another_when_a_file_that_it_imports_is(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """`paid` is made of several files; one that is typed in has none."""
    before = law_named("paid").before
    first = source_of(before)
    assert source_of(before) == first
    assert source_of(law_named("spring").before) != first
    asked: list[str] = []

    def another(path: Path) -> tuple[str, int]:
        asked.append(path.name)
        return ("another", 1)

    monkeypatch.setattr("cotouch.laboratory._cells.stamp_of", another)
    assert source_of(before) != first
    assert asked == ["_paid.py"]
    monkeypatch.undo()
    assert "_paid_hand.py" in {path.name for path in stamps._sources(Path(before.__code__.co_filename))}

    typed: list[Any] = []
    for number in (1, 2, 1):
        names: dict[str, Any] = {}
        exec(f"def before(end):\n    return {number}", names)
        typed.append(source_of(names["before"]))
    assert typed[0] == typed[2] != typed[1]

    file = tmp_path / "law.py"
    for text in ("def before(end):\n    return 1\n", "def before(end):\n    return 3\n"):
        file.write_text(text)
        names = {}
        exec(compile(text, file, "exec"), names)
        typed.append(source_of(partial(names["before"], 1)))
    assert len(set(typed)) == 4

    class Called:
        def __call__(self) -> int:
            return 1

    assert source_of(Called()) == source_of(Called.__call__) != ""
    assert source_of(len) == ""


def test_a_cluster_gets_cells_in_portions_and_what_it_brings_is_kept(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from contextlib import contextmanager

    portions: list[int] = []

    def parallel(calls: Any) -> list[Any]:
        every = list(calls)
        portions.append(len(every))
        if len(portions) == 2:
            raise Stop
        return [function(*given, **named) for function, given, named in every]

    @contextmanager
    def cluster(jobs: int, dask: str | None) -> Any:
        assert dask == "tcp://here:1"
        yield SimpleNamespace(parallel=parallel, jobs=jobs)

    monkeypatch.setattr("cotouch.laboratory._cells.workers", cluster)
    with pytest.raises(Stop):
        cells("double", double, CELLS, jobs=1, dask="tcp://here:1", store=Store(tmp_path, "1"))
    assert portions == [4, 3]
    assert len(list(tmp_path.iterdir())) == 4
