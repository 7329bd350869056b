"""What one step of a peer did."""

from dataclasses import dataclass
from typing import final

import numpy as np
import numpy.typing as npt

from cotouch.peer._guard import GuardBooks
from cotouch.peer._links import Sample

Float = npt.NDArray[np.float64]


@final
@dataclass(frozen=True, kw_only=True, eq=False)
class Report:
    """What one step did.

    Attributes:
        sample: what the neighbours should be told.
        force: mean force of the step at every port, (ports, width) [N].
        supplied: work done at the ports [J].
        body_loss: dissipated by the body's own dampers [J].
        local_loss: by the damping B_i of the synchronisation [J].
        extra_loss: by the extra damping B_e [J].
        link_work: work that each link did on the copy, in the order of `Peer.neighbours` [J].
        kinetic: energy after the step [J].
        elastic: energy after the step [J].
        drive_work: work done on the proxies by what pulls them [J].
        touch_work: work done on the body by contacts and grasps [J].
        touch_loss: dissipated in contacts and grasps [J].
        proxy: kinetic energy of the proxies after the step [J].
        touch_stored: energy in contacts and grasps after the step [J].
        residual: what the books of this step do not explain [J]; round-off, or something is broken.
        age: of each link's sample at the end of the step, by the clocks as they are [s].
        iterations: of the solver.
        rescaled: what kinetic and elastic energy changed by since the step before, as the number of copies did [J].
        guards: books of each link's guard, in the order of `Peer.neighbours`; None for a link without.
    """

    sample: Sample
    force: Float
    supplied: float
    body_loss: float
    local_loss: float
    extra_loss: float
    link_work: Float
    kinetic: float
    elastic: float
    drive_work: float
    touch_work: float
    touch_loss: float
    proxy: float
    touch_stored: float
    residual: float
    age: Float
    iterations: int
    rescaled: float
    guards: tuple[GuardBooks | None, ...]
