"""The suite that every device passes: over the registry, each driver with what stands in for its hardware.

A driver's tests add theirs to `STAND_INS`, or call `assert_conforms` themselves.
"""

from collections.abc import Callable, Generator
from contextlib import AbstractContextManager, contextmanager

from cotouch.haptics import Device, conform, make_device

StandIn = Callable[[], AbstractContextManager[Callable[[], Device]]]


@contextmanager
def _simulated(variant: str) -> Generator[Callable[[], Device]]:
    yield lambda: make_device("simulated", variant=variant)


# By what pytest calls it; the part before a colon is the driver's name in the registry.
STAND_INS: dict[str, StandIn] = {
    f"simulated:{variant}": lambda variant=variant: _simulated(variant) for variant in ("phantom", "cartesian", "touch")
}


def assert_conforms(make: Callable[[], Device], *, allow_motion: bool = False, force: bool = True) -> None:
    """All checks of `cotouch.haptics.conform` pass, and the device came to the end of them."""
    found = conform(make, allow_motion=allow_motion, force=force)
    assert [finding for finding in found if not finding.passed] == []
    assert found[-1].check == "exchange after close is refused"
