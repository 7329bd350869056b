"""What is compiled before anybody waits, and by whom."""

import numba
from tests.session.inside import warm_copy

from cotouch.hands import CommandedHand
from cotouch.mechanics import contact_step
from cotouch.members import SessionFile, SharedModel, Slot

BLOCK = """
[session]
users = 2
[body]
kind = "lattice"
shape = [3, 3, 2]
spacing = 0.02
ground = "z-"
ground_stiffness = 50.0
"""


def test_what_another_process_compiles_ahead_is_what_a_step_with_tools_calls() -> None:
    session = SessionFile.from_toml(BLOCK)
    replica = SharedModel.build(session)
    hand, peer = warm_copy(replica, lambda model: CommandedHand(Slot.of(session, replica, 0, model)))
    assert hand.tools is not None
    hand.before(1e-3, 1e-3)
    peer.step(1e-3, 1e-3)
    assert contact_step.signatures
    parts = peer.contact_parts()
    assert len(parts) > 5
    for part, arguments in parts:
        wanted = tuple(numba.typeof(argument) for argument in arguments)
        compiled = sum(part.stats.cache_misses.values())
        part.compile(wanted)
        assert sum(part.stats.cache_misses.values()) == compiled, part.py_func.__name__
