"""In which order tests run when several processes share them, so that all of these are done at about the same time.

`--dist loadfile` hands out whole modules, whose fixtures are made once, to whoever has nothing left. So what takes long
comes first, what waits and what computes in turns, and what is quick fills the gaps at the end.
"""

from collections.abc import Sequence
from itertools import zip_longest
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
    "coupling",
    "device",
    "drawing",
    "interaction",
    "kernels",
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
    "control/test_control.py",
    "test_leftovers.py",
    "web/test_silence.py",
    "web/test_picture.py",
    "web/test_shell_reach.py",
    "web/test_pages.py",
    "simulation/test_animation.py",
    "web/test_picture_kinds.py",
    "web/test_shell.py",
    "web/test_shell_instruments.py",
    "cli/test_full_disk.py",
)
# What computes for long or compiles much, the longest first.
COMPUTING = (
    "mechanics/test_force.py",
    "simulation/test_bodies.py",
    "simulation/test_tools_side_by_side.py",
    "simulation/test_long_steps.py",
    "hands/test_commanded_hand.py",
    "session/test_cut_bodies.py",
    "session/test_heavy.py",
    "planning/test_workers.py",
    "cli/test_plan_command.py",
    "session/test_rigid_tools.py",
    "test_processors.py",
    "session/test_bodies.py",
    "study/test_study.py",
    "simulation/test_rigid_tools_on_soft.py",
    "test_compiled.py",
    "mechanics/test_contact_material.py",
    "laboratory/test_impedance.py",
    "mechanics/test_contact_step.py",
    "network/test_consensus.py",
    "cli/test_outputs.py",
    "session/test_cuts.py",
    "simulation/test_cutting.py",
    "laboratory/test_compare_report.py",
    "planning/test_feel.py",
    "haptics/test_one_law.py",
    "test_document_blocks.py",
    "body/test_meshes.py",
    "members/test_member.py",
    "study/test_solid.py",
    "members/test_live_law.py",
    "mechanics/test_contact_law.py",
    "simulation/test_tools.py",
    "cli/test_cli.py",
    "cli/test_interrupted.py",
    "members/test_succession.py",
    "laws/test_worlds.py",
    "mechanics/test_meeting.py",
    "simulation/test_rigid.py",
    "session/test_recovery.py",
    "simulation/test_rigid_tools.py",
    "session/test_parity.py",
    "architecture/test_imports.py",
    "planning/test_plan.py",
    "test_interrupt.py",
    "device/test_cartesian.py",
    "planning/test_flood.py",
    "recording/test_dataset.py",
    "simulation/test_mesh_body.py",
    "simulation/test_figures.py",
    "laboratory/test_replicas.py",
    "architecture/test_docstrings.py",
    "recording/test_audit.py",
    "mechanics/test_cut_skin.py",
    "session/test_real_cut.py",
    "cli/test_laboratory_commands.py",
    "session/test_recording.py",
    "device/test_modulation.py",
    "web/test_screen.py",
    "coupling/test_law.py",
    "mechanics/test_cutting.py",
    "planning/test_springs.py",
    "cli/test_recording_commands.py",
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
    """All of them, module by module, the longest first."""
    found: dict[str, list[T]] = {}
    for item in items:
        found.setdefault(module_of(item.nodeid), []).append(item)
    both = [name for pair in zip_longest(WAITING, COMPUTING) for name in pair if name is not None]
    return [item for module in [*both, *found] for item in found.pop(module, [])]
