"""Compiling before anybody waits: what a copy's steps need, once on this machine for each kind of body."""

from collections.abc import Callable

import numpy as np

from cotouch.compiled import cold
from cotouch.mechanics import Model, closed_step, contact_step, step, touch_step
from cotouch.peer import FreshestLink, Link, LinkGuard, Peer, Sample
from cotouch.session._file import SessionFile
from cotouch.session._hand import Hand
from cotouch.session._shared_model import SharedModel

_T = 1e-3


def compiles(session: SessionFile, *, touched: bool = False) -> bool:
    """Whether `warm_up` is going to compile, once on this machine, which takes a minute or two.

    Args:
        session: that is taken part in.
        touched: whether its object may be touched besides what the file says.
    """
    scenario = session.scenario
    material = scenario.build_body().material
    if scenario.tools or touched:
        return cold(touch_step if scenario.contact.made(material) is None else contact_step)
    return cold(step if material is None else closed_step)


def warm_up(replica: SharedModel, make: Callable[[Model], Hand]) -> None:
    """Takes two steps of a copy that nobody sees.

    Args:
        replica: of the session.
        make: makes the hand, given the model.
    """
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
    for k in (1, 2):
        hand.before(k * _T, _T)
        peer.step(k * _T, _T)
        hand.after()
        peer.rescale(1 + k)
