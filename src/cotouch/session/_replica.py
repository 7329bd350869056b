"""A session's body on this machine: the same for everybody, ready for the kernels, and shown to be the same."""

import math
from dataclasses import dataclass
from typing import Any, final

import numpy as np
import numpy.typing as npt

from cotouch.body import Body
from cotouch.errors import SessionError
from cotouch.live import Layout
from cotouch.mechanics import Model, model
from cotouch.scenario import Scenario
from cotouch.session._file import SessionFile

Float = npt.NDArray[np.float64]

_PROBES = 6
_SHAPES = 1e4
# Machines round differently; other bodies, or modes of another sign, differ by far more.
_SAME = 1e-6


@final
@dataclass(frozen=True, eq=False)
class Replica:
    """What every member builds of a session before it takes part.

    Attributes:
        scenario: with its hands at nodes.
        body: the shared object.
        layout: of samples on the wire.
        fingerprint: a few numbers that tell whether another machine built the same.
    """

    scenario: Scenario
    body: Body
    layout: Layout
    fingerprint: list[float]

    @classmethod
    def build(cls, session: SessionFile) -> "Replica":
        """Builds the body.

        Raises:
            InputError: body, weights or hands of the session are wrong.
        """
        scenario = session.scenario.placed()
        body = scenario.build_body()
        ready = model(body, copies=1, weights=scenario.network.weights, basis=_basis(scenario, body))
        axes = 1 if ready.full else body.dimension
        coding, reach = session.options.coding, session.options.reach
        if coding != "float64" and (scenario.network.weights or body.truncation is not None):
            raise SessionError(
                f'session.coding is "{coding}"; with link weights of their own or a truncated body it must be "float64"'
            )
        limit = reach if ready.modes is None else _SHAPES  # coordinates of shapes are not displacements
        layout = Layout(rows=ready.operator_rows, width=ready.width, axes=axes, coding=coding, limit=limit)
        return cls(scenario, body, layout, _fingerprint(ready))

    @property
    def rounding(self) -> float:
        """Bound on the error of a sample by its coding, in the norm of all rows [m]."""
        layout = self.layout
        if layout.coding == "float64":
            return 0.0
        return layout.rounding(layout.limit) * math.sqrt(layout.rows * layout.axes)

    def model(self, copies: int) -> Model:
        """The body's model as one of so many copies."""
        weights = self.scenario.network.weights
        return model(self.body, copies=copies, weights=weights, basis=_basis(self.scenario, self.body))


def same_body(one: list[float], other: list[float]) -> bool:
    """Whether two fingerprints are of the same body."""
    a, b = np.array(one), np.array(other)
    return a.shape == b.shape and bool(np.allclose(a, b, rtol=_SAME, atol=_SAME * float(np.abs(a).max(initial=0.0))))


def _basis(scenario: Scenario, body: Body) -> Any:
    """Modes of different machines may differ in sign, so rows are nodes unless the file says otherwise."""
    wish = scenario.solver.basis
    return "nodal" if wish == "auto" and body.truncation is None else wish


def _fingerprint(ready: Model) -> list[float]:
    rng = np.random.default_rng(2010)
    body, numbers = ready.body, [float(ready.operator_rows), float(ready.operator.mass.sum())]
    for _ in range(_PROBES):
        rows = ready.to_rows(rng.standard_normal((body.nodes, body.dimension)))
        numbers.append(float((rows * rng.standard_normal(rows.shape)).sum()))
    return numbers
