"""In which order tests run when several processes share them, so that all of these are done at about the same time.

`--dist worksteal` gives each of two workers half of the list; whoever is done takes half of what the other has left,
from its end. So one begins with what waits in real time and leaves its processor to the processes that it waits for,
the other with what computes longest, and what is quick is left for the end. Modules stay whole: their fixtures are made
once.
"""

from collections.abc import Sequence
from typing import Protocol, TypeVar

# Real sessions, networks, devices and browsers, the longest first.
WAITING = (
    "session/test_networks.py",
    "cli/test_session_commands.py",
    "web/test_real_demo.py",
    "live/test_networks.py",
    "live/test_nats.py",
    "live/test_control_processes.py",
    "session/test_nats.py",
    "session/test_device_hand.py",
    "drivers/test_session.py",
    "drivers/test_processes.py",
    "haptics/test_processes.py",
    "web/test_picture.py",
    "web/test_shell_reach.py",
    "web/test_shell_instruments.py",
    "web/test_shell.py",
    "web/test_picture_kinds.py",
    "simulation/test_animation.py",
)
# What computes for long or compiles much, the longest first.
COMPUTING = (
    "study/test_study.py",
    "planning/test_plan.py",
    "study/test_solid.py",
    "study/test_touch_record.py",
    "live/test_control_fuzz.py",
    "session/test_parity.py",
    "session/test_member.py",
    "planning/test_springs.py",
    "cli/test_plan_command.py",
    "cli/test_cli.py",
    "cli/test_recording_commands.py",
    "device/test_servo.py",
    "device/test_modulation.py",
    "body/test_meshes.py",
    "mechanics/test_contact.py",
    "mechanics/test_collide.py",
    "session/test_recording.py",
    "session/test_demo_stage.py",
    "live/test_fuzz.py",
)


class Item(Protocol):
    """What is asked of a test: the name that begins with its file's path."""

    @property
    def nodeid(self) -> str: ...


T = TypeVar("T", bound=Item)


def ordered(items: Sequence[T]) -> list[T]:
    """All of them, for two workers: the first half for one, the second for the other."""
    found: dict[str, list[T]] = {}
    for item in items:
        found.setdefault(item.nodeid.partition("::")[0].removeprefix("tests/"), []).append(item)
    waiting = [item for module in WAITING for item in found.pop(module, [])]
    computing = [item for module in COMPUTING for item in found.pop(module, [])]
    first, second = list[T](), list[T]()
    for module in found.values():
        (first if len(waiting) + len(first) < len(items) / 2 else second).extend(module)
    return [*waiting, *first, *computing, *second]
