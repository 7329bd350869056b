"""In which order tests run when several processes share them, so that all of these are done at about the same time.

`--dist worksteal` gives each of two workers half of the list; whoever is done takes half of what the other has left,
from its end. So one begins with what waits for other processes, the other with what computes longest, and what is quick
is left for the end. Modules stay whole: their fixtures are made once.
"""

from collections.abc import Sequence
from pathlib import Path
from typing import Protocol, TypeVar

# What must come within milliseconds or needs both processors: `make test` runs it with nothing beside it.
ALONE = (
    "control/test_control_zenoh.py",
    "drivers/test_coming_back.py",
    "drivers/test_conforming.py",
    "drivers/test_critical.py",
    "drivers/test_failing.py",
    "drivers/test_inverse3.py",
    "drivers/test_processes.py",
    "drivers/test_session.py",
    "drivers/test_touch.py",
    "hands/test_device_hand.py",
    "haptics/test_conformance.py",
    "haptics/test_processes.py",
    "haptics/test_servo.py",
    "live/test_transports.py",
    "pacing/test_pacing.py",
    "session/test_felt_live.py",
    "session/test_short_faults.py",
    "web/test_real_demo.py",
)
# Real sessions and networks that mostly wait, with patience for many seconds: one after the other, beside the rest.
PATIENT = (
    "cli/test_documented_commands.py",
    "cli/test_session_commands.py",
    "control/test_control_processes.py",
    "control/test_gate.py",
    "control/test_gatekeeper.py",
    "live/test_moving.py",
    "live/test_nats.py",
    "live/test_networks.py",
    "session/test_demo_session_api.py",
    "session/test_nats.py",
    "session/test_networks.py",
    "web/test_real_join.py",
)
TIMED = (*ALONE, *PATIENT)
# What only computes: it needs nothing on time, so it runs beside what needs much.
_ROOMS = (
    "body",
    "device",
    "laboratory",
    "laws",
    "mechanics",
    "members",
    "network",
    "peer",
    "planning",
    "scenario",
    "simulation",
    "study",
)
_FILES = ("test_compiled.py", "test_document_blocks.py", "test_processors.py")
# Browsers, and workers that must answer.
_PROMPT = ("planning/test_workers.py", "simulation/test_animation.py")
# Browsers, and runs of tests that are interrupted, the longest first.
WAITING = (
    "web/test_picture.py",
    "test_leftovers.py",
    "web/test_shell_reach.py",
    "web/test_shell_instruments.py",
    "web/test_shell.py",
    "web/test_silence.py",
    "cli/test_full_disk.py",
    "web/test_picture_kinds.py",
    "simulation/test_animation.py",
)
# What computes for long or compiles much, the longest first.
COMPUTING = (
    "mechanics/test_force.py",
    "simulation/test_bodies.py",
    "test_compiled.py",
    "simulation/test_rigid.py",
    "members/test_member.py",
    "study/test_study.py",
    "simulation/test_cutting.py",
    "body/test_meshes.py",
    "mechanics/test_grasp.py",
    "members/test_live_law.py",
    "test_document_blocks.py",
    "members/test_succession.py",
    "mechanics/test_cutting.py",
    "mechanics/test_meeting.py",
    "device/test_modulation.py",
    "simulation/test_figures.py",
    "planning/test_plan.py",
    "cli/test_outputs.py",
    "hands/test_commanded_hand.py",
    "test_processors.py",
    "cli/test_plan_command.py",
    "cli/test_cli.py",
    "session/test_planner.py",
    "laboratory/test_replicas.py",
    "planning/test_springs.py",
    "members/test_attack.py",
    "study/test_solid.py",
    "simulation/test_world.py",
    "simulation/test_rigid_tools.py",
    "laws/test_known_answers.py",
    "laboratory/test_compare.py",
    "simulation/test_tools.py",
    "cli/test_laboratory_commands.py",
    "simulation/test_materials.py",
    "session/test_recovery.py",
    "mechanics/test_rigid.py",
    "mechanics/test_cut_skin.py",
    "simulation/test_mesh_body.py",
)


class Item(Protocol):
    """What is asked of a test: the name that begins with its file's path."""

    @property
    def nodeid(self) -> str: ...


T = TypeVar("T", bound=Item)


def numerical(tests: Path) -> list[str]:
    """Files of tests that only compute, as they are named here.

    Args:
        tests: where they are.
    """
    found = [path for room in _ROOMS for path in sorted((tests / room).rglob("test_*.py"))]
    names = [str(path.relative_to(tests)) for path in found]
    return [*(name for name in names if name not in (*TIMED, *_PROMPT)), *_FILES]


def module_of(nodeid: str) -> str:
    """The file of a test, as it is named above."""
    return nodeid.partition("::")[0].removeprefix("tests/")


def ordered(items: Sequence[T]) -> list[T]:
    """All of them, for two workers: the first half for one, the second for the other."""
    found: dict[str, list[T]] = {}
    for item in items:
        found.setdefault(module_of(item.nodeid), []).append(item)
    waiting = [item for module in WAITING for item in found.pop(module, [])]
    computing = [item for module in COMPUTING for item in found.pop(module, [])]
    first, second = list[T](), list[T]()
    for module in found.values():
        (first if len(waiting) + len(first) < len(items) / 2 else second).extend(module)
    return [*waiting, *first, *computing, *second]
