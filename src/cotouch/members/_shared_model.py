"""A session's body on this machine: the same for everybody, ready for the kernels, and shown to be the same."""

import hashlib
import math
from dataclasses import dataclass
from functools import cached_property
from typing import Literal, cast, final

import numpy as np
import numpy.typing as npt

from cotouch.arrays import Float
from cotouch.body import Body
from cotouch.errors import SessionError
from cotouch.laws import SPRING
from cotouch.mechanics import WEIGHTS, BodyForce, Model, Shape, model
from cotouch.members._file import SessionFile
from cotouch.members._live_law import LiveLaw
from cotouch.peer import ContentForm
from cotouch.samples import Layout
from cotouch.scenario import DrawnTexture, Scenario, colours_of

_PROBES = 6
_LAW_PROBES = 4
_SHAPES = 1e4
# Machines round differently; other bodies, or modes of another sign, differ by far more.
_SAME = 1e-6


@final
@dataclass(frozen=True, eq=False)
class SharedModel:
    """What every member builds for a session before it takes part.

    Attributes:
        scenario: with its hands at nodes.
        body: the shared object.
        layout: of samples on the wire.
        law: of all links; None: guarded springs.
        fingerprint: a few numbers that tell whether another machine built the same.
    """

    scenario: Scenario
    body: Body
    layout: Layout
    law: LiveLaw | None
    fingerprint: list[float]

    @classmethod
    def build(cls, session: SessionFile) -> "SharedModel":
        """Builds the body.

        Raises:
            InputError: body, weights or hands of the session are wrong.
        """
        with session.scenario.naming():
            return cls._built(session, session.scenario.placed())

    @classmethod
    def _built(cls, session: SessionFile, scenario: Scenario) -> "SharedModel":
        body = scenario.build_body()
        ready = _model(scenario, body, 1)
        fingerprint = _fingerprint(ready)  # before anything is worked out in its scratch
        axes = 1 if ready.full else body.dimension
        users = scenario.network.size
        scenario.world.refuse_overlap(ready, np.stack([_begins(scenario, body, slot) for slot in range(users)]))
        encoding, reach = session.options.encoding, session.options.max_displacement
        if encoding != "float64" and (scenario.network.weights or body.truncation is not None):
            raise SessionError(
                f'session.encoding is "{encoding}"; with link weights or a truncated body it must be "float64"'
            )
        limit = reach if ready.modes is None else _SHAPES  # coordinates of shapes are not displacements
        law = LiveLaw.of(session, ready.operator, ready.operator_rows * ready.width)
        if law is not None and bool(np.any(ready.operator.mix[WEIGHTS:])):
            raise SessionError(
                f'synchronisation.law is "{law.law.name}", which takes no truncated body; leave that out'
            )
        asked = scenario.channel.codec
        if asked is not None and bool(np.any(ready.operator.mix[WEIGHTS:])):
            raise SessionError(
                "channel.codec is given, but a link's weight or a truncated body couples nodes or axes; what its "
                "errors cost is known for diagonal weights only, so leave the codec out"
            )
        layout = Layout(
            rows=ready.operator_rows,
            width=ready.width,
            axes=axes,
            encoding=encoding,
            limit=limit,
            fields=0 if law is None else len(law.law.sends),
            coarse=() if law is None else law.law.coarse,
            scalars=0 if law is None else len(law.law.sends_scalars),
            form=None if asked is None else ContentForm(asked.codec, SPRING if law is None else law.law),
        )
        return cls(scenario, body, layout, law, fingerprint)

    @property
    def uncut(self) -> bool:
        """Whether the body cannot be cut."""
        return self.body.cut_count == 0

    @property
    def rounding(self) -> float:
        """Bound on the error of a sample by its coding, in the norm of all rows [m]."""
        layout = self.layout
        if layout.encoding == "float64":
            return 0.0
        return layout.rounding(layout.limit) * math.sqrt(layout.rows * layout.axes)

    @property
    def shapes(self) -> tuple[Shape, ...]:
        """Of what stands still around the object."""
        return tuple(obstacle.shape for obstacle in self.scenario.world.obstacles())

    @property
    def colours(self) -> tuple[str | None, ...]:
        """Of each of several bodies, as "#rrggbb"; None: one of its own."""
        return colours_of(self.scenario.bodies)

    @cached_property
    def texture(self) -> DrawnTexture | None:
        """On the skin of what is shared; None: it is smooth."""
        given = self.scenario.contact.texture
        return None if given is None else given.drawn()

    def model(self, copies: int) -> Model:
        """The body's model as one of so many copies."""
        return _model(self.scenario, self.body, copies)

    def begins(self, slot: int) -> Float:
        """Displacement at which a user's copy begins, (n, d) [m].

        Args:
            slot: of the user.
        """
        return _begins(self.scenario, self.body, slot)


def same_body(one: list[float], other: list[float]) -> bool:
    """Whether two fingerprints are of the same body.

    Args:
        one: of one body.
        other: of the other.
    """
    a, b = np.array(one), np.array(other)
    return a.shape == b.shape and bool(np.allclose(a, b, rtol=_SAME, atol=_SAME * float(np.abs(a).max(initial=0.0))))


def _basis(scenario: Scenario, body: Body) -> Literal["auto", "nodal", "modal"]:
    """Modes of different machines may differ in sign, so rows are nodes unless the file says otherwise."""
    request = scenario.solver.basis
    return "nodal" if request == "auto" and body.truncation is None else request


def _model(scenario: Scenario, body: Body, copies: int) -> Model:
    return model(
        body,
        copies=copies,
        weights=scenario.network.weights,
        basis=_basis(scenario, body),
        obstacles=scenario.world.obstacles(),
        between=scenario.between.made(),
    )


def _begins(scenario: Scenario, body: Body, slot: int) -> Float:
    shape, given = (body.nodes, body.dimension), scenario.initial.position
    begins = np.zeros(shape)
    if given is not None:
        begins[: body.shared] = np.asarray(given[slot])
    return begins


def _fingerprint(ready: Model) -> list[float]:
    rng = np.random.default_rng(2010)
    body, numbers = ready.body, [float(ready.operator_rows), float(ready.operator.mass.sum())]
    for _ in range(_PROBES):
        rows = ready.to_rows(rng.standard_normal((body.nodes, body.dimension)))
        numbers.append(float((rows * rng.standard_normal(rows.shape)).sum()))
    if ready.force is not None:
        numbers += _force_numbers(ready.force, rng, numbers[0])
    return numbers


def _flat(values: object) -> list[npt.ArrayLike]:
    """All arrays and numbers of a tuple of tuples."""
    if isinstance(values, tuple):
        return [found for value in cast("tuple[object, ...]", values) for found in _flat(value)]
    return [] if values is None else [cast("npt.ArrayLike", values)]


def _force_numbers(force: BodyForce, rng: np.random.Generator, rows: float) -> list[float]:
    """Of a material's law, its weight and what it meets: name and extents, the size of their arrays, their directions.

    Each is on the scale of the number of rows, so that none is lost beside the others in `same_body`.
    """
    arrays = [*_flat(force.table), force.gravity, *_flat(force.world)]
    said = f"{type(force.table).__name__} {[np.shape(values) for values in arrays]}".encode()
    sizes, ways = 0.0, np.zeros(_LAW_PROBES)
    for values in arrays:
        array = np.asarray(values, dtype=np.float64).ravel()
        size = float(np.linalg.norm(array))
        weight, probes = rng.uniform(1.0, 2.0), rng.standard_normal((_LAW_PROBES, array.size))
        if size > 0.0:
            sizes += weight * math.log(size)
            ways += probes @ (array / size)
    return [rows * value for value in (hashlib.sha256(said).digest()[0] / 255.0, sizes, *ways.tolist())]
