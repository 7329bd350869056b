"""Tests look at what objects show. How many looks into their private state are left, by file, can only fall."""

import ast
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

from tests.architecture.modules import ROOT

TESTS = ROOT / "tests"
# Documented for everybody, though they begin with an underscore.
PUBLIC = {"_asdict", "_current_frames", "_exit", "_fields", "_make", "_replace", "_repr_html_"}
LEFT = {
    "conftest.py": 1,
    "drivers/test_coming_back.py": 1,
    "drivers/test_inverse3.py": 2,
    "drivers/test_processes.py": 1,
    "drivers/test_touch.py": 1,
    "hands/test_device_hand.py": 2,
    "hands/test_twisted.py": 1,
    "haptics/test_servo.py": 1,
    "haptics/test_virtual.py": 3,
    "laboratory/test_cells.py": 1,
    "live/test_transports.py": 1,
    "members/attack.py": 1,
    "members/liar.py": 2,
    "members/test_attack.py": 8,
    "members/test_coordinator.py": 1,
    "members/test_live_law.py": 4,
    "members/test_succession.py": 1,
    "peer/test_guard.py": 2,
    "peer/test_peer.py": 2,
    "planning/test_local.py": 6,
    "samples/test_agreement_states.py": 7,
    "samples/test_coded.py": 1,
    "session/test_cuts.py": 1,
    "session/test_demo_session_api.py": 1,
    "simulation/stepped.py": 2,
    "simulation/test_figures.py": 1,
    "study/test_touch_record.py": 1,
    "test_compiled.py": 8,
}


def private(source: str) -> Iterator[str]:
    """Private attributes of other objects than one's own."""
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Attribute) and node.attr.startswith("_") and not node.attr.startswith("__"):
            own = isinstance(node.value, ast.Name) and node.value.id in {"self", "cls"}
            if not own and node.attr not in PUBLIC:
                yield node.attr


def counted(folder: Path) -> Counter[str]:
    files = sorted(folder.rglob("*.py"))
    found = {path.relative_to(folder).as_posix(): len(list(private(path.read_text("utf-8")))) for path in files}
    return Counter({name: count for name, count in found.items() if count and not name.startswith("mechanics/")})


def test_what_is_private_is_told_from_what_is_not():
    source = "self._a = one._b._c(cls._d, one.__e__, two._replace(x=_f))"
    assert sorted(private(source)) == ["_b", "_c"]


def test_private_state_that_tests_look_at_only_gets_less():
    found = counted(TESTS)
    more = found - Counter(LEFT)
    assert not more, f"test what is shown instead, or show it: {dict(more)} too many"
    assert found == LEFT, "fewer are left: lower their numbers here"
