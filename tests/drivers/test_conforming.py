"""Every driver passes the suite of all devices against its stand-in, and breaks none of the vendor's rules."""

from collections.abc import Callable
from contextlib import AbstractContextManager
from pathlib import Path

import pytest
from tests.drivers.moved import Moved
from tests.drivers.standin import Board, Service
from tests.drivers.test_gamepad import Pad
from tests.haptics.conformance import assert_conforms

from cotouch.haptics import make_device


def test_haply(service: Service):
    assert_conforms(lambda: make_device("haply", url=service.url, events=service.events))


@pytest.mark.parametrize(
    ("system", "initialized", "motion"),
    [(33, 0, True), (63, 1, False), (104, 1, False), (108, 0, True), (60, 1, False)],
)
def test_force_dimension(
    running: Callable[..., AbstractContextManager[Board]], built: Path, system: int, initialized: int, motion: bool
):
    with running(system=system, initialized=initialized) as board:
        assert_conforms(lambda: make_device("force_dimension", library=str(built)), allow_motion=motion)
        assert board.get("violations") == 0, board.said


@pytest.mark.parametrize("initialized", [1, 2])
def test_touch(running: Callable[..., AbstractContextManager[Board]], built: Path, initialized: int):
    with running(initialized=initialized) as board:
        assert_conforms(lambda: make_device("touch", library=str(built)))
        assert board.get("violations") == 0, board.said


def test_gamepad():
    with Pad() as pad:
        assert_conforms(pad.device)


def test_recorded(moved: Moved):
    assert_conforms(moved.device)
