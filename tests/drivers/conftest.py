"""Stub libraries, built once, and what runs behind them."""

import time
from collections.abc import Callable, Generator
from contextlib import AbstractContextManager
from dataclasses import replace
from functools import partial
from pathlib import Path

import numpy as np
import pytest
from tests.drivers.driving import stalled
from tests.drivers.moved import Moved
from tests.drivers.standin import COMPILER, Board, Service, build, firmware, inverse_service
from tests.recording.driven import Driven
from tests.stalls import Stalls

from cotouch.recording import read_recording

# No device here fails sooner because nobody answers [s].
WAITS = 0.03


@pytest.fixture(scope="session")
def built(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Folder with the stub libraries and the firmware."""
    if COMPILER is None:
        pytest.skip("no C compiler here, which the stub libraries need")
    return build(tmp_path_factory.mktemp("stubs"))


@pytest.fixture
def running(built: Path, tmp_path: Path) -> Callable[..., AbstractContextManager[Board]]:
    """Starts a device behind the stub libraries."""
    return partial(firmware, built, tmp_path)


@pytest.fixture
def board(running: Callable[..., AbstractContextManager[Board]], stalls: Stalls) -> Generator[Board]:
    """A running omega.3 that is calibrated."""
    del stalls  # as below
    with running() as board:
        yield board
        assert board.get("violations") == 0, board.said


@pytest.fixture
def service(tmp_path: Path, stalls: Stalls) -> Generator[Service]:
    """A running Inverse Service."""
    del stalls  # as below
    with inverse_service(tmp_path) as service:
        yield service
        assert service.board.get("violations") == 0, service.board.said


@pytest.fixture
def moved(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Moved:
    """A recording of two tools, the first of which was never anywhere."""
    path = Driven(tmp_path, seconds=0.5).run()[0]
    bare = read_recording(path)
    time = bare.columns["time"] - bare.columns["time"][0]
    place = 0.1 + 0.02 * np.stack([np.sin(9 * time), np.cos(7 * time), time], axis=1)
    places = np.stack([np.full_like(place, np.nan), place], axis=1)
    with_tools = replace(bare, columns={**bare.columns, "tool_position": places})
    monkeypatch.setattr("cotouch.drivers._recorded.read_recording", lambda _path: with_tools)
    return Moved(path, time, place)


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(item: pytest.Item, call: pytest.CallInfo[None]) -> Generator[None, pytest.TestReport]:
    """Notes that a device failed a test as it waited in vain while the machine stood still: it is taken again."""
    report = yield
    watch = getattr(item, "funcargs", {}).get("stalls")
    if watch is not None and call.excinfo is not None and stalled(call.excinfo.value):
        report.stalled = watch.stood(time.monotonic() - 0.5, 0.5 * WAITS)  # type: ignore[attr-defined]
    return report
