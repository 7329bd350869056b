"""What a search waits for before its time begins: only what it compiles, and only what it is going to run."""
# pyright: reportPrivateUsage=false

from collections.abc import Callable

import pytest
from tests.planning.inside import ready

from cotouch.planning import compiles


@pytest.mark.parametrize(
    ("missing", "method", "objective", "waits"),
    [
        (
            ready.descend,
            "local",
            "decay",
            False,
        ),  # or every local search would, for a kernel that none of them compiles
        (ready.descend, "bound", "damping", True),
        (ready.flood, "local", "decay", True),
        (ready.flood, "bound", "damping", False),
        (ready.sweep, "enumerate", "decay", True),
        (ready.sweep, "local", "decay", False),
    ],
)
def test_only_what_it_runs_counts(
    missing: Callable[..., object], method: str, objective: str, waits: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("cotouch.planning._ready.cold", lambda kernel: kernel is missing)
    assert compiles(method, objective) is waits  # type: ignore[arg-type]
