"""A body's material in a recording: what its inner forces follow, and the energy that they hold at recorded places."""

from collections.abc import Mapping
from dataclasses import fields
from typing import TYPE_CHECKING, Any, final

import numpy as np
import scipy.sparse as sp

from cotouch.arrays import Float
from cotouch.body import Body, Material, SumOfSquares

if TYPE_CHECKING:  # reading a recording needs no kernels
    from cotouch.mechanics import Model

_INNER, _OUTER = ("damping_int", "stiffness_int"), ("mass", "damping_ext", "stiffness_ext")
_PARTS = ("data", "indices", "indptr")
_PREFIX = "material_"


@final
class RecordedMaterial:
    """Works out energies of a body with a material; the machine code for it is made when it is first asked.

    Attributes:
        body: with its material.
        material: of it.
    """

    def __init__(self, body: Body) -> None:
        """Takes a body.

        Args:
            body: with a material.
        """
        assert body.material is not None
        self.body, self.material = body, body.material
        self._model: Model | None = None

    def arrays(self) -> dict[str, Any]:
        """All of it, by name."""
        found: dict[str, Any] = {}
        for name in (*_INNER, *_OUTER):
            found |= {f"{_PREFIX}{name}_{part}": getattr(getattr(self.body, name), part) for part in _PARTS}
        return found | {_PREFIX + field.name: np.asarray(getattr(self.material, field.name)) for field in _FIELDS}

    @classmethod
    def of_arrays(cls, arrays: Mapping[str, Any], rest: Float) -> "RecordedMaterial | None":
        """The inverse of `arrays`; None where there is none. A body checks what it is made of.

        Args:
            arrays: by name; nothing of them is believed.
            rest: shape at rest, (n, d) [m].

        Raises:
            BodyError: they are of no body.
            ValueError, KeyError, TypeError, IndexError: nor arrays of that.
        """
        if _PREFIX + "model" not in arrays:
            return None
        matrices: dict[str, sp.csr_array] = {}
        for name in (*_INNER, *_OUTER):
            parts = tuple(arrays[f"{_PREFIX}{name}_{part}"] for part in _PARTS)
            size = int(parts[2].size) - 1
            matrices[name] = sp.csr_array(parts, shape=(size, size))
            matrices[name].check_format(full_check=True)
        said = {field.name: arrays[_PREFIX + field.name] for field in _FIELDS}
        material = Material(
            model=str(said["model"]),  # pyright: ignore[reportArgumentType]  checked by the body
            elements=np.asarray(said["elements"], dtype=np.int64),
            stiffness=np.asarray(said["stiffness"], dtype=np.float64),
            gravity=tuple(np.asarray(said["gravity"], dtype=np.float64).ravel().tolist()),  # pyright: ignore[reportArgumentType]
            **{name: float(said[name]) for name in ("young", "poisson", "viscosity")},
        )
        inner = {name: SumOfSquares(matrices[name]) for name in _INNER}
        outer = {name: matrices[name] for name in _OUTER}
        return cls(Body(rest=rest, material=material, **inner, **outer))

    def same(self, other: "RecordedMaterial | None") -> bool:
        """Whether another is of the same numbers.

        Args:
            other: of another recording.
        """
        if other is None:
            return False
        one, two = self.arrays(), other.arrays()
        return all(np.array_equal(values, two[name]) for name, values in one.items())

    def energies(self, start: Float, after: Float, mean: Float) -> tuple[Float, Float, Float]:
        """What the inner forces hold before and after each step, and what their dampers took.

        Rotations are followed from one step to the next of those that are given.

        Args:
            start: displacements of the nodes, (steps, n, d) [m].
            after: likewise, after the step.
            mean: their mean velocity in it [m/s].

        Returns:
            Energy before and after [J], and power [W], each (steps,), all of the whole body.
        """
        from cotouch.mechanics import inner_energy, model

        if self._model is None:
            self._model = model(self.body)
        made = self._model
        assert made.force is not None
        memory = made.unturned()
        before, ends, power = (np.zeros(start.shape[0]) for _ in range(3))
        still = made.to_rows(np.zeros(self.body.rest.shape))
        for step in range(start.shape[0]):
            x, ahead, rate = (made.to_rows(field[step]) for field in (start, after, mean))
            before[step], _ = inner_energy(made.force, memory, x, x, still, made.lanes)
            ends[step], power[step] = inner_energy(made.force, memory, x, ahead, rate, made.lanes)
        return before, ends, power

    def weight(self, place: Float, mass: Float) -> Float:
        """Potential energy in the field of gravity, zero at rest [J].

        Args:
            place: displacements of the nodes, (steps, n, d) [m].
            mass: of the nodes, (n,) [kg].
        """
        return -np.einsum("snd,n,d->s", place, mass, np.asarray(self.material.gravity[: place.shape[2]]))


_FIELDS = fields(Material)
