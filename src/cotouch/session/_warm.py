"""Compiling before anybody waits: what a copy's steps need, once on this machine for each kind of body."""

import pickle
import subprocess
import sys
from collections.abc import Callable, Generator
from contextlib import contextmanager, suppress
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

from cotouch.compiled import cold, compile_for
from cotouch.hands import CommandedHand
from cotouch.mechanics import Model, closed_step, contact_step, step
from cotouch.members import Hand, SessionFile, SharedModel, Slot
from cotouch.peer import FreshestLink, Link, LinkGuard, Peer, Sample
from cotouch.processes import aside

_T = 1e-3
_HELD = 1e-30  # [J]


def compiles(session: SessionFile, *, touched: bool = False) -> bool:
    """Whether `warm_up` is going to compile, once on this machine, which takes a minute or two.

    Args:
        session: that is taken part in.
        touched: whether its object may be touched besides what the file says.
    """
    scenario = session.scenario
    if (scenario.proxies or touched) and cold(contact_step):
        return True
    if (scenario.proxies or touched) and not scenario.rigid_tools:
        return False
    return cold(step if scenario.build_body().material is None else closed_step)


def warm_up(replica: SharedModel, make: Callable[[Model], Hand]) -> None:
    """Takes two steps of a copy that nobody sees.

    Args:
        replica: of the session.
        make: makes the hand, given the model.
    """
    hand, peer = _copy(replica, make)
    for k in (1, 2):
        hand.before(k * _T, _T)
        if k == 2 and hand.tools is not None:  # what a tool still holds is let go by a step with contact
            hand.tools.stored[:1] += _HELD
        peer.step(k * _T, _T)
        hand.after()
        peer.rescale(1 + k)


@contextmanager
def shared_with_another_process(session: SessionFile) -> Generator[None]:
    """Has another process compile a part of what `warm_up` needs with a pointer in hand; nothing waits for it.

    Args:
        session: that is taken part in.
    """
    with aside(__name__, parts.__name__, stdin=subprocess.PIPE) as process:
        assert process.stdin is not None
        with suppress(OSError), process.stdin as file:
            pickle.dump((session.content, session.files), file)
        yield


def parts() -> None:
    """Compiles what `contact_parts` lists, for the session on standard input: that other process."""
    content, files = pickle.load(sys.stdin.buffer)  # noqa: S301  from who started this process
    with TemporaryDirectory(prefix="cotouch-") as folder:
        session = SessionFile.from_content(content, files, folder=Path(folder))
        replica = SharedModel.build(session)
    _, peer = _copy(replica, lambda model: CommandedHand(Slot.of(session, replica, 0, model)))
    for part, arguments in peer.contact_parts():
        compile_for(part, arguments)


def _copy(replica: SharedModel, make: Callable[[Model], Hand]) -> tuple[Hand, Peer]:
    """A copy with two links, as a member has it."""
    model = replica.model(2)
    hand = make(model)
    rows, width = model.operator_rows, model.width
    body, weights = replica.body, 1 + len(replica.scenario.network.weights)
    still = np.zeros((body.nodes, body.dimension))
    guards: dict[int, Link] = {
        j: LinkGuard(
            FreshestLink(Sample(sender=j, index=0, stamp=0.0, position=np.full((rows, width), place))),
            budget=1.0,
            total=1.0,
            initial_energy=1.0,
        )
        for j, place in ((1, 1e-6), (2, 1e3))  # one that is followed at once, one that is not
    }
    if replica.law is not None:
        still_rows, law, memory = np.zeros((rows, width)), replica.law, replica.law.memory()
        heard = [Sample(sender=j, index=0, stamp=0.0, position=still_rows) for j in (1, 2)]
        guards = {j: law.link(FreshestLink(said), memory, slot=0, other=0, copies=3) for j, said in enumerate(heard, 1)}
    peer = Peer(
        index=0,
        model=model,
        links=guards,
        strength=[1.0, 1.0],
        weight=[weights - 1] * 2,
        local_damping=np.zeros(weights),
        extra_damping=np.zeros(weights),
        ports=hand.ports,
        position=still,
        velocity=still,
        surface=hand.surface,
        tools=hand.tools,
        contact=hand.contact,
    )
    return hand, peer
