"""A body's material in a recording, and what it met: what forces follow, and the energy that they hold at places."""

from collections.abc import Mapping
from dataclasses import fields
from typing import final

import numpy as np
import numpy.typing as npt
import scipy.sparse as sp

from cotouch.arrays import Array, Bool, Float
from cotouch.body import Body, Material, Skin, SumOfSquares, grip_shares
from cotouch.errors import BodyError
from cotouch.mechanics import (
    SHAPES,
    Between,
    Cutting,
    Model,
    Obstacle,
    Solid,
    begin_world,
    cutting_of,
    deepest_between,
    deepest_point,
    follow_world,
    inner_energy,
    mark_cuts,
    model,
    shape_of,
    show_skin,
    unsettled,
)
from cotouch.mechanics import World as Around
from cotouch.recording._outside import Outside
from cotouch.recording._parts import NAMES, parts_arrays, parts_of_arrays, solid_arrays, solids_of_arrays

_INNER, _OUTER = ("damping_int", "stiffness_int"), ("mass", "damping_ext", "stiffness_ext")
PARTS = ("data", "indices", "indptr")
_PREFIX, _SKIN, _WORLD = "material_", "skin_", "world_"
_SURFACE = ("vertices", "triangles", "nodes", "weights")
# Numbers of an obstacle: of its shape, unused ones 0, and of its law.
_SHAPE, _LAW = 13, ("stiffness", "loss", "friction", "kinetic")


@final
class RecordedMaterial:
    """Works out energies of a body with a material; the machine code for it is made when it is first asked.

    Attributes:
        body: with its material.
        material: of it.
        world: what stands around it, by name: `kind` (S,), `shape` (S, 13) and `law` (S, 4), and those of
            `solid_arrays`; empty: nothing does.
        between: what its parts do to each other, of several bodies.
    """

    def __init__(self, body: Body, world: Mapping[str, Array] | None = None, between: Between | None = None) -> None:
        """Takes a body.

        Args:
            body: with a material; with a skin where it meets something.
            world: see above; None: nothing.
            between: see above.
        """
        assert body.material is not None
        self.body, self.material = body, body.material
        self.world, self.between = dict(world or {}), between
        self._model: Model | None = None

    @classmethod
    def of(cls, model: Model) -> "RecordedMaterial":
        """Takes a body with a material, and what stands around it, from a model.

        Args:
            model: of the session.
        """
        obstacles, world = model.obstacles, {}
        if obstacles:
            shapes = np.zeros((len(obstacles), _SHAPE))
            solids: list[Solid] = []
            for row, obstacle in zip(shapes, obstacles, strict=True):
                if isinstance(obstacle.shape, Solid):
                    solids.append(obstacle.shape)
                    continue
                numbers = np.concatenate([np.ravel(values) for values in obstacle.shape])
                row[: numbers.size] = numbers
            laws = [
                [o.stiffness, o.loss, o.friction, o.friction if o.kinetic is None else o.kinetic] for o in obstacles
            ]
            kind = np.array([(*SHAPES, Solid).index(type(o.shape)) for o in obstacles])
            world = {"kind": kind, "shape": shapes, "law": np.array(laws), **solid_arrays(solids)}
        return cls(model.body, world, model.between)

    def obstacles(self) -> list[Obstacle]:
        """What stands around the body.

        Raises:
            BodyError: numbers of one are out of their range.
        """
        if not self.world:
            return []

        made: list[Obstacle] = []
        solids = solids_of_arrays(self.world)
        for kind, shape, law in zip(*(self.world[name] for name in ("kind", "shape", "law")), strict=True):
            if not 0 <= int(kind) < len(SHAPES) and not (int(kind) == len(SHAPES) and solids):
                raise BodyError(f"the recording has an obstacle of kind {kind}; there are 0 to {len(SHAPES) - 1}")
            numbers = dict(zip(_LAW, map(float, law), strict=True))
            given = shape_of(int(kind), shape) if int(kind) < len(SHAPES) else solids.pop(0)
            made.append(Obstacle(shape=given, **numbers))
        return made

    def arrays(self) -> dict[str, Array]:
        """All of it, by name."""
        if self.body.parts:
            found = parts_arrays(self.body, self.between, lambda one: RecordedMaterial(one)._own(skin=True))
            found = {_PREFIX + name: values for name, values in found.items()}
            found[_PREFIX + "model"] = np.asarray(self.material.model)
            found[_PREFIX + "gravity"] = np.asarray(self.material.gravity)
            if self.body.rigid:
                found[_PREFIX + "places"] = self.body.places
            return found | {_PREFIX + _WORLD + name: values for name, values in self.world.items()}
        return self._own(skin=bool(self.world) or self.body.rigid)

    def _own(self, *, skin: bool) -> dict[str, Array]:
        """Of one body."""
        found: dict[str, Array] = {}
        for name in (*_INNER, *_OUTER):
            found |= {f"{_PREFIX}{name}_{part}": getattr(getattr(self.body, name), part) for part in PARTS}
        found |= {_PREFIX + field.name: np.asarray(getattr(self.material, field.name)) for field in _FIELDS}
        if skin and self.body.skin is not None:
            found |= {_PREFIX + _SKIN + name: getattr(self.body.skin, name) for name in _SURFACE}
        if self.body.rigid:
            found[_PREFIX + "places"] = self.body.places
        if self.world and self.body.skin is not None:
            found |= {_PREFIX + _WORLD + name: values for name, values in self.world.items()}
        return found

    @classmethod
    def of_arrays(cls, arrays: Mapping[str, Array], rest: Float) -> "RecordedMaterial | None":
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
        world, places = _world_of(arrays), arrays.get(_PREFIX + "places", ())
        if str(arrays[_PREFIX + "model"]) != "several":
            return cls(_body_of(arrays, rest, places), world)
        bare = {name.removeprefix(_PREFIX): arrays[name] for name in arrays if name.startswith(_PREFIX)}
        body, between = parts_of_arrays(bare, lambda own, shape: _body_of(own, shape, ()))
        if body.rest.shape != rest.shape or not np.allclose(body.rest, rest, rtol=1e-9, atol=1e-9):
            raise ValueError("its parts do not make up the body")
        x, y, z = np.asarray(arrays[_PREFIX + "gravity"], dtype=np.float64).ravel().tolist()
        body = body.with_gravity((x, y, z))
        return cls(body.with_places(places) if body.rigid else body, world, between)

    def same(self, other: "RecordedMaterial | None") -> bool:
        """Whether another is of the same numbers.

        Args:
            other: of another recording.
        """
        if other is None:
            return False
        one, two = self.arrays(), other.arrays()
        return one.keys() == two.keys() and all(np.array_equal(values, two[name]) for name, values in one.items())

    def energies(
        self, start: Float, after: Float, mean: Float, *, index: Float, when: Float
    ) -> tuple[Float, Float, Float, Float]:
        """What the inner forces hold before and after each step, what their dampers took, and what was cut away.

        Rotations are followed from one step to the next of those that are given.

        Args:
            start: displacements of the nodes, (steps, n, d) [m].
            after: likewise, after the step.
            mean: their mean velocity in it [m/s].
            index: number of each step, (steps,).
            when: after which step each element was cut, (elements,); see `cut_steps`.

        Returns:
            Energy before and after [J], power [W], and what went with the elements that were cut after the step [J],
            each (steps,), all of the whole body.
        """
        made = self._made()
        assert made.force is not None
        memory = made.unturned()
        before, ends, power, gone = (np.zeros(start.shape[0]) for _ in range(4))
        marks = memory[made.cut : made.cut + when.size] if made.cut >= 0 else np.zeros(when.size)
        still = made.to_rows(np.zeros(self.body.rest.shape))
        for step in range(start.shape[0]):
            x, ahead, rate = (made.to_rows(field[step]) for field in (start, after, mean))
            marks[:] = when < index[step]
            before[step], _ = inner_energy(made.force, memory, x, x, still, made.lanes)
            ends[step], power[step] = inner_energy(made.force, memory, x, ahead, rate, made.lanes)
            if np.any(when == index[step]):
                marks[:] = when <= index[step]
                left, _ = inner_energy(made.force, memory, ahead, ahead, still, made.lanes)
                gone[step], ends[step] = ends[step] - left, left
        return before, ends, power, gone

    def outside(
        self,
        start: Float,
        after: Float,
        T: Float,
        told: Outside,
        *,
        fresh: Bool,
        follows: Bool,
        index: Float,
        when: Float,
        user: int,
    ) -> Outside:
        """What planes, boxes and other bodies held before and after each step, and what was lost at them.

        How far friction is stretched follows from the steps before, and so does how deep something was where a cut
        brought it to light, and what is asleep. Where these are not all there, what the peer booked stands in, until
        the copy touches nothing, or there is neither friction nor a cut, and nothing that meets another yields.

        Args:
            start: displacements of the nodes, (steps, n, d) [m].
            after: likewise, after the step.
            T: length of the step, (steps,) [s].
            told: what the peer booked; of before only where no step is missing.
            fresh: whether the step is the copy's first, (steps,).
            follows: whether it begins where the one before ended, (steps,).
            index: number of each step, (steps,).
            when: after which step each element was cut, (elements,).
            user: whose copy it is, from 0: only his tools are in it.
        """
        made = self._made()
        world = None if made.force is None else made.force.world
        if world is None:
            return told
        memory, found, known, held = unsettled(made, user), Outside(*map(np.array, told)), False, np.nan
        slick = not np.any(world.friction)
        if world.bodies is not None:  # points of what yields may be asleep
            slick = slick and not np.any(world.bodies.friction) and all(part.body.rigid for part in self.body.parts)
        cutting = cutting_of(made)
        for step in range(T.size):
            x, ahead = (made.to_rows(field[step]) for field in (start, after))
            if not follows[step]:
                whole = not np.any(when < index[step])
                known = bool((slick and whole) or fresh[step])
                _mark(made, cutting, memory, when < index[step])
                held = begin_world(world, memory, x)
                _mark(made, cutting, memory, when < index[step])
            if not known:  # a step that touches nothing leaves nothing stretched
                known = max(_deepest(world, memory, x), _deepest(world, memory, ahead)) <= 0.0
                _mark(made, cutting, memory, when <= index[step])
                held = begin_world(world, memory, ahead)
                _mark(made, cutting, memory, when <= index[step])
                continue
            found.before[step] = held
            held, found.lost[step] = follow_world(world, memory, x, ahead, float(T[step]))
            new, found.cut[step] = when == index[step], 0.0
            if cutting is not None and np.any(new):
                cutting.wanted[:] = new
                left = mark_cuts(cutting, world, memory, ahead, int(index[step]))
                found.cut[step] = max(held - left, 0.0)
                held -= found.cut[step]
            found.after[step] = held
        return found

    def firmness(self) -> float:
        """Of all that the whole skin can lean on [N/m]."""
        made = self._made()
        world = None if made.force is None else made.force.world
        if world is None:
            return 0.0
        firm = sum(one.stiffness for one in self.obstacles())
        if self.between is not None and (len(self.body.parts) > 1 or self.between.own):
            firm += self.between.stiffness
        return float(firm * world.area[: world.moves].sum())

    def _made(self) -> Model:

        if self._model is None:
            self._model = model(self.body, obstacles=self.obstacles(), between=self.between)
        return self._model

    def held(self, rate: Float) -> Float:
        """Velocities of what ports hold: nodes, of a rigid body any points, and behind these what holds tools.

        Args:
            rate: of the nodes, (steps, n, d) [m/s].
        """
        body = self.body
        grips = grip_shares(body.parts, body.nodes)
        own = rate[:, : body.shared] if body.held_shares is None else np.einsum("hn,sna->sha", body.held_shares, rate)
        return np.concatenate([own, np.einsum("gn,sna->sga", grips, rate)], axis=1) if grips.size else own

    def weight(self, place: Float, mass: Float) -> Float:
        """Potential energy in the field of gravity, zero at rest [J].

        Args:
            place: displacements of the nodes, (steps, n, d) [m].
            mass: of the nodes, (n,) [kg].
        """
        n = self.body.shared  # tools have none
        return -np.einsum("snd,n,d->s", place[:, :n], mass[:n], np.asarray(self.material.gravity[: place.shape[2]]))


_FIELDS = fields(Material)


def _mark(made: Model, cutting: Cutting | None, memory: Float, gone: Bool) -> None:
    """Lets a memory know what was cut, and the skin what of it is there."""
    world = None if made.force is None else made.force.world
    if cutting is not None and world is not None:
        memory[made.cut : made.cut + gone.size] = gone
        memory[made.cut - 1] = np.count_nonzero(gone)
        show_skin(cutting, world, memory)


def _deepest(world: Around, memory: Float, x: Float) -> float:
    """How deep the deepest point is in anything [m]."""
    most = deepest_point(world, memory, x)[0]
    return most if world.bodies is None else max(most, deepest_between(world, world.bodies, memory, x)[0])


def _world_of(arrays: Mapping[str, Array]) -> dict[str, Array]:
    """What stands around a body."""
    if _PREFIX + _WORLD + "kind" not in arrays:
        return {}
    world = {name: np.asarray(arrays[_PREFIX + _WORLD + name]) for name in ("kind", "shape", "law")}
    extents = [values.shape for values in world.values()]
    if extents != [extents[0], (*extents[0], _SHAPE), (*extents[0], len(_LAW))] or len(extents[0]) != 1:
        raise ValueError(f"the surroundings of the body have arrays of shapes {extents}")
    return world | {
        name: np.asarray(arrays[_PREFIX + _WORLD + name]) for name in NAMES if _PREFIX + _WORLD + name in arrays
    }


def _number(said: Array) -> float | Float:
    """One for all elements, or one for each."""
    numbers = np.asarray(said, dtype=np.float64)
    return numbers if numbers.ndim else float(numbers)


def matrix_of(arrays: Mapping[str, Array], name: str, rows: int | None = None) -> sp.csr_array:
    """A square matrix that can be used safely.

    Args:
        arrays: by name; nothing of them is believed.
        name: of the matrix.
        rows: how many it must have; None: as many as it has.

    Raises:
        ValueError, KeyError, TypeError: there is none.
    """
    parts = tuple(arrays[f"{name}_{part}"] for part in PARTS)
    rows = int(parts[2].size) - 1 if rows is None else rows
    made = sp.csr_array(parts, shape=(rows, rows))
    made.check_format(full_check=True)
    return made


def _body_of(arrays: Mapping[str, Array], rest: Float, places: npt.ArrayLike) -> Body:
    """One body, with its material."""
    matrices = {name: matrix_of(arrays, _PREFIX + name) for name in (*_INNER, *_OUTER)}
    said = {field.name: arrays[_PREFIX + field.name] for field in _FIELDS}
    material = Material(
        model=str(said["model"]),  # pyright: ignore[reportArgumentType]  checked by the body
        elements=np.asarray(said["elements"], dtype=np.int64),
        stiffness=np.asarray(said["stiffness"], dtype=np.float64),
        gravity=tuple(np.asarray(said["gravity"], dtype=np.float64).ravel().tolist()),  # pyright: ignore[reportArgumentType]
        cuttable=bool(said["cuttable"]),
        **{name: float(said[name]) for name in ("tear", "strength", "toughness")},
        faces=np.asarray(said["faces"], dtype=np.int64),
        sides=np.asarray(said["sides"], dtype=np.int64),
        ties=np.asarray(said["ties"], dtype=np.float64),
        part=np.asarray(said["part"], dtype=np.float64),
        young=_number(said["young"]),
        poisson=_number(said["poisson"]),
        viscosity=_number(said["viscosity"]),
    )
    skin = None
    if _PREFIX + _SKIN + _SURFACE[0] in arrays:
        skin = Skin(**{name: arrays[_PREFIX + _SKIN + name] for name in _SURFACE})
    return Body(
        rest=rest,
        material=material,
        skin=skin,
        places=places,
        mass=matrices["mass"],
        damping_int=SumOfSquares(matrices["damping_int"]),
        damping_ext=matrices["damping_ext"],
        stiffness_int=SumOfSquares(matrices["stiffness_int"]),
        stiffness_ext=matrices["stiffness_ext"],
    )
