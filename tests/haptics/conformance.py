"""The suite that every device passes: over the registry, each driver with what stands in for its hardware.

`tests/drivers/test_conforming.py` runs all of them, because the stub libraries are built there.
"""

import time
from collections.abc import Callable, Generator
from contextlib import AbstractContextManager, contextmanager
from functools import partial

import pytest
from tests.stalls import Stalled, Stalls

from cotouch.haptics import Device, conform, make_device

# Gives, from a test's fixtures, something that makes the device for as long as it stands in.
StandIn = Callable[[pytest.FixtureRequest], AbstractContextManager[Callable[[], Device]]]


@contextmanager
def _simulated(
    variant: str, _request: pytest.FixtureRequest, *, wrist: bool = False
) -> Generator[Callable[[], Device]]:
    yield lambda: make_device("simulated", variant=variant, wrist=wrist)


@contextmanager
def _haply(request: pytest.FixtureRequest) -> Generator[Callable[[], Device]]:
    service = request.getfixturevalue("service")
    yield lambda: make_device("haply", url=service.url, events=service.events)


@contextmanager
def _stubbed(
    name: str, system: int, initialized: int, request: pytest.FixtureRequest, *, wrist: bool = False
) -> Generator[Callable[[], Device]]:
    library = str(request.getfixturevalue("built"))
    with request.getfixturevalue("running")(system=system, initialized=initialized, wrist=wrist) as mailbox:
        yield lambda: make_device(name, library=library)
        assert mailbox.get("violations") == 0, mailbox.said


@contextmanager
def _gamepad(_request: pytest.FixtureRequest) -> Generator[Callable[[], Device]]:
    from tests.drivers.test_gamepad import Pad

    with Pad() as pad:
        yield pad.device


@contextmanager
def _recorded(request: pytest.FixtureRequest) -> Generator[Callable[[], Device]]:
    yield request.getfixturevalue("moved").device


# By what pytest calls it; the part before a colon is the driver's name in the registry.
STAND_INS: dict[str, StandIn] = {
    **{f"simulated:{variant}": partial(_simulated, variant) for variant in ("phantom", "cartesian", "touch")},
    "simulated:with a wrist": partial(_simulated, "cartesian", wrist=True),
    "haply": _haply,
    "force_dimension:omega": partial(_stubbed, "force_dimension", 33, 0),
    "force_dimension:delta": partial(_stubbed, "force_dimension", 63, 1),
    "force_dimension:sigma": partial(_stubbed, "force_dimension", 104, 1),
    "force_dimension:sigma with a wrist": partial(_stubbed, "force_dimension", 104, 1, wrist=True),
    "force_dimension:lambda": partial(_stubbed, "force_dimension", 108, 0),
    "force_dimension:falcon": partial(_stubbed, "force_dimension", 60, 1),
    "touch": partial(_stubbed, "touch", 33, 1),
    "touch:to be calibrated": partial(_stubbed, "touch", 33, 2),
    "touch:with a wrist": partial(_stubbed, "touch", 33, 1, wrist=True),
    "gamepad": _gamepad,
    "recorded": _recorded,
}
# Those that move by themselves to find their place.
MOVING = frozenset({"force_dimension:omega", "force_dimension:lambda"})


def assert_conforms(make: Callable[[], Device], stalls: Stalls, *, allow_motion: bool = False) -> None:
    """All checks of `cotouch.haptics.conform` pass, and the device came to the end of them.

    Args:
        make: gives the device, not open.
        stalls: a machine that stands still for as long as an exchange may take has a device take its force away.
        allow_motion: whether it may move by itself to calibrate.

    Raises:
        Stalled: not all pass, but the machine stood still meanwhile.
        AssertionError: not all pass.
    """
    began = time.monotonic()
    found = conform(make, allow_motion=allow_motion)
    failed = [finding for finding in found if not finding.passed]
    if failed:
        raise (Stalled if stalls.stood(began, 0.01) else AssertionError)(str(failed))
    assert found[-1].check == "exchange after close is refused"
