"""How springs are moved.

Sequential linear programming. The rate of the slowest mode is the largest real part of many roots, so it has kinks, and
the best springs mostly lie on one: all roots in the front are lowered together by a linear program inside a trust
region. Where two roots meet on the real axis the rate has an infinite slope on one side, but their mean and the square
of half their distance go on smoothly; a second program moves with these, and keeps the two from parting again.
"""

import itertools
import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import final

import numpy as np

from cotouch.arrays import Complex, Float
from cotouch.errors import NetworkError, UnsupportedError
from cotouch.network import (
    Decay,
    Loop,
    Network,
    characteristic,
    closed_loop,
    generator_eigenvalues,
    polish,
    rate_of,
    rightmost_root,
)
from cotouch.planning._deadline import aside
from cotouch.planning._modes import own_drag

# The trust region, in logarithms of the springs: at first, at most, and where the search ends.
_REGION, _WIDEST, _NARROWEST = 0.3, 1.0, 1e-5
# A fall smaller than this share of the rate is none.
_GAIN = 1e-9
# Degree of the collocation that finds the roots in the front, and how many of them a program lowers.
_ORDER = 14
_FRONT = 12
# Singular values below this share of the largest term belong to a root.
_NULL = 1e-9
# Roots beyond this, times the longest delay, are not in any front, and exp would overflow on their way.
_FAR = 100.0
# What the count of roots ends in where several coincide: such springs are passed over.
_UNSETTLED = (UnsupportedError, ZeroDivisionError)
# Other starts: so many spread over the bounds for every link (and at most), and how many of the best are followed.
_SPREAD, _MOST_SPREAD, _FOLLOWED = 15, 120, 3


@final
class Search:
    """What stays the same while the springs change."""

    def __init__(self, network: Network, limit: Float, modes: Float, drag_limit: float | None = None) -> None:
        self.network = network
        self.modes = modes
        pairs = np.array(network.links, dtype=np.int64).reshape(-1, 2)
        self.first, self.second = pairs[:, 0], pairs[:, 1]
        self.to_first = network.delay[self.first, self.second]
        self.to_second = network.delay[self.second, self.first]
        self.age = (self.to_first + self.to_second) / 2
        # Rows: what each N/m of each spring takes of a user's limit, and of that on the drag of all.
        self.takes = np.zeros((network.size, len(pairs)))
        links = np.arange(len(pairs))
        self.takes[self.first, links] += self.age
        self.takes[self.second, links] += self.age
        self.takes /= limit[:, None]
        if drag_limit is not None:
            own = own_drag(modes)
            if not drag_limit > own:
                raise NetworkError(
                    f"drag_limit is {drag_limit:g} Ns/m; it must be above the object's own damping, {own:g} Ns/m"
                )
            self.takes = np.vstack([self.takes, 4.0 * self.age / (drag_limit - own)])
        self.low, self.high = 0.0, math.inf
        self.rounds = 0
        self.found: list[tuple[Decay, Float, Float]] = []

    def springs_of(self, network: Network) -> Float:
        """The springs of the links chosen [N/m]."""
        return network.spring[self.first, self.second]

    def network_of(self, springs: Float) -> Network:
        """The network with these springs [N/m]."""
        matrix = self.network.spring.copy()
        matrix[self.first, self.second] = matrix[self.second, self.first] = springs
        return self.network.replace(spring=matrix)

    def room(self, springs: Float) -> float:
        """The factor that brings the springs just to the limit; inf where no damping is needed."""
        most = float((self.takes @ springs).max(initial=0.0))
        return 1.0 / most * (1.0 - 1e-15) if most > 0 else math.inf

    def at(self, springs: Float) -> Decay:
        """The decay with springs within the limits; the best of all that were asked for is kept."""
        decay, mode = self.slowest(springs)
        if not self.found or decay.rate < self.found[0][0].rate:
            self.found[:] = [(decay, springs, mode)]
        return decay

    @property
    def best(self) -> tuple[Decay, Float, Float]:
        """The best decay so far, its springs, and the mode that is slowest then."""
        return self.found[0]

    def slowest(self, springs: Float) -> tuple[Decay, Float]:
        """The decay of the object's slowest mode, and which that is."""
        network = self.network_of(springs)
        found = [
            (rightmost_root(network, mass=m, damping=b, stiffness=k), row)
            for row, (m, b, k) in enumerate(self.modes.tolist())
        ]
        decay, row = max(found, key=lambda one: one[0].rate)
        return decay, self.modes[row]

    def spread(self) -> list[tuple[Decay, Float]]:
        """The best of many springs between the bounds, scaled into the limit where they break it."""
        size = self.takes.shape[1]
        # Kronecker sequence of the powers of the root g of g^(E+1) = g + 1, the most even known in any dimension.
        ratio = 1.5
        for _ in range(50):
            ratio = (1.0 + ratio) ** (1.0 / (size + 1))
        powers = ratio ** -np.arange(1.0, size + 1)
        found: list[tuple[Decay, Float]] = []
        for point in range(min(_SPREAD * size, _MOST_SPREAD)):
            springs = self.low * (self.high / self.low) ** ((0.5 + (point + 1) * powers) % 1.0)
            springs = np.maximum(springs * min(1.0, self.room(springs)), self.low)
            if self.room(springs) < 1.0:
                continue
            try:
                found.append((self.at(springs), springs))
            except _UNSETTLED:
                continue
        return sorted(found, key=lambda one: one[0].rate)[:_FOLLOWED]

    def improve(self, best: tuple[Decay, Float], rounds: int) -> None:
        """Linear programs in a row, as long as they help.

        Args:
            best: decay and springs to begin with.
            rounds: most linear programs in a row.
        """
        region, count = _REGION, 0
        model: list[_Program] = []
        while count < rounds and region > _NARROWEST:
            decay, springs = best
            if not model:
                model = self.programs(decay, springs)
            count += 1
            self.rounds += 1
            here, promised = best, 0.0
            for program in model:
                step = self.solve(program, springs, region)
                if step is None:
                    continue
                change, value = step
                new = self.inside(springs * (1.0 + change))
                try:
                    there = self.at(new)
                except _UNSETTLED:
                    continue
                if there.rate < here[0].rate:
                    here, promised = (there, new), decay.rate - value
            gain = decay.rate - here[0].rate
            if gain <= _GAIN * abs(decay.rate):
                region *= 0.4
                continue
            best, model = here, []
            if gain > 0.5 * promised:
                region = min(2.0 * region, _WIDEST)
            elif gain < 0.1 * promised:
                region *= 0.5

    def inside(self, springs: Float) -> Float:
        """Round-off of the linear program taken back."""
        springs = np.clip(springs, self.low, self.high)
        return springs * min(1.0, self.room(springs))

    def programs(self, decay: Decay, springs: Float) -> list["_Program"]:
        """What to lower together: each root of the front by itself; and with those that meet as pairs.

        Args:
            decay: with these springs.
            springs: of the links, in their order, (E,) [N/m].
        """
        roots, slopes = self.front(decay, springs)
        plain = _Program(roots.real, slopes.real, np.zeros(0), np.zeros((0, len(springs))))
        return [plain, *self.pairings(roots, slopes)]

    def pairings(self, roots: Complex, slopes: Complex) -> Iterator["_Program"]:
        """Programs in which two roots, that are or come onto the real axis together, stay together.

        Args:
            roots: of the front, the rightmost first, (roots,) [1/s].
            slopes: of each in relative changes of the springs, (roots, E) [1/s].
        """
        real = np.flatnonzero(roots.imag == 0)
        pairs = [(int(a), int(b)) for a, b in itertools.pairwise(real)][:2]
        pairs += [(int(a), int(a)) for a in np.flatnonzero(roots.imag != 0)[:2]]
        for a, b in pairs:
            other = roots[b] if a != b else roots[a].conjugate()
            bend = slopes[b] if a != b else slopes[a].conjugate()
            half, turn = (roots[a] - other) / 2, (slopes[a] - bend) / 2
            rest = np.array([r for r in range(len(roots)) if r not in (a, b)], dtype=np.int64)
            yield _Program(
                np.append(roots.real[rest], ((roots[a] + other) / 2).real),
                np.vstack([slopes.real[rest], ((slopes[a] + bend) / 2).real]),
                np.array([(half * half).real]),
                (2 * half * turn).real[None, :],
            )

    def front(self, decay: Decay, springs: Float) -> tuple[Complex, Complex]:
        """The rightmost roots with Im >= 0, the rightmost first, and (roots, E) their slopes in relative changes.

        Args:
            decay: with these springs.
            springs: of the links, in their order, (E,) [N/m].
        """
        found: list[tuple[complex, Loop]] = []
        slow = self.slowest(springs)[1]
        for mode in self.modes:
            found += self.roots(decay, springs, mode, [decay.root] if np.array_equal(mode, slow) else [])
        found = sorted(found, key=lambda one: -one[0].real)[:_FRONT]
        pairs = [(root, slope) for root, loop in found for slope in self.slopes(loop, root)]
        return np.array([root for root, _ in pairs]), np.array([slope for _, slope in pairs]) * springs

    def roots(self, decay: Decay, springs: Float, mode: Float, known: list[complex]) -> list[tuple[complex, Loop]]:
        """The rightmost roots of one mode, with the loop that they belong to; `known` are among them.

        Args:
            decay: with these springs.
            springs: of the links, in their order, (E,) [N/m].
            mode: mass [kg], damping [Ns/m], stiffness [N/m] of the body mode, (3,).
            known: roots of it [1/s].
        """
        mass, drag, rigid = mode.tolist()
        loop, _ = closed_loop(self.network_of(springs), mass, drag, rigid, None)
        scale = rate_of(loop)
        near = 1e-7 * (abs(decay.root) + 1e-3 * scale)
        resting = rigid == 0
        coupling = np.zeros((len(loop.mass),) * 2)
        coupling[loop.first, loop.second] = coupling[loop.second, loop.first] = loop.spring
        delay = self.network.delay
        starts = aside(lambda: generator_eigenvalues(loop.mass, loop.drag, loop.rigid, coupling, delay, order=_ORDER))
        none = np.zeros(1, np.complex128), np.ones(1, np.int64), 0
        roots, longest = list(known), float(delay.max())
        for start in starts[starts.imag >= 0][: 2 * _FRONT]:
            root, arrived = polish(loop, complex(start), scale, *none)
            if not arrived or (resting and abs(root) < near) or root.real > decay.rate + near:
                continue
            if root.real * longest < -_FAR:
                continue
            if all(abs(root - other) > near for other in roots):
                roots.append(complex(root))
        return [(root, loop) for root in roots]

    def slopes(self, loop: Loop, root: complex) -> list[Complex]:
        """ds/dK_e: one for a simple root; for several that coincide, along each of their shapes and between them.

        Args:
            loop: that the root is of.
            root: s, with Im >= 0 [1/s].
        """
        left, sizes, right = np.linalg.svd(characteristic(loop, root))
        terms = np.max(abs(root) ** 2 * loop.mass + abs(root) * loop.drag + loop.rigid)
        several = max(1, int(np.count_nonzero(sizes < _NULL * terms)))
        # x in columns, y* in rows.
        x, y = right[-several:].conj().T, left[:, -several:].conj().T
        i, j = loop.first, loop.second
        slope = np.diag(2 * loop.mass * root + loop.drag).astype(np.complex128)
        forth, back = np.exp(-root * self.to_first), np.exp(-root * self.to_second)
        slope[i, j], slope[j, i] = loop.spring * self.to_first * forth, loop.spring * self.to_second * back
        own = 1.0 + root * self.age
        # (several, several, E): y* dG/dK x for every spring.
        moved = own * (y[:, None, i] * x.T[None, :, i] + y[:, None, j] * x.T[None, :, j])
        moved -= forth * y[:, None, i] * x.T[None, :, j] + back * y[:, None, j] * x.T[None, :, i]
        speed = y @ slope @ x
        try:
            result = -np.einsum("ab,bce->ace", np.linalg.inv(speed), moved)
        except np.linalg.LinAlgError:
            return [np.zeros(len(i), np.complex128)]
        shapes = [np.eye(several)[a] for a in range(several)]
        for a in range(several):
            for b in range(a):
                shapes += [(shapes[a] + shapes[b]) / np.sqrt(2), (shapes[a] - shapes[b]) / np.sqrt(2)]
        return [np.einsum("a,ace,c->e", shape, result, shape) for shape in shapes]

    def solve(self, program: "_Program", springs: Float, region: float) -> tuple[Float, float] | None:
        """Relative changes of the springs and the largest rate that the program promises; None where it has none.

        Args:
            program: what is to be lowered together.
            springs: of the links, in their order, (E,) [N/m].
            region: farthest that a spring may go, in logarithms, > 0.
        """
        from scipy.optimize import linprog  # takes a tenth of a second, and no member needs it

        size = len(springs)
        below = np.maximum(np.expm1(-region), np.minimum(self.low / springs - 1.0, 0.0))
        above = np.minimum(np.expm1(region), np.maximum(self.high / springs - 1.0, 0.0))
        taken = self.takes * springs
        used = taken.sum(axis=1)
        unit = max(float(np.abs(program.rates).max()), 1e-300)
        square = np.maximum(np.abs(program.apart), np.abs(program.parting).max(axis=1, initial=0.0))[:, None] + 1e-300
        lowered = np.hstack([program.slopes / unit, -np.ones((len(program.rates), 1))])
        limited = np.hstack([taken, np.zeros((len(taken), 1))])
        joined = np.hstack([program.parting / square, np.zeros((len(program.apart), 1))])
        done = linprog(
            np.append(np.zeros(size), 1.0),
            A_ub=np.vstack([lowered, limited, joined]),
            b_ub=np.concatenate([-program.rates / unit, np.maximum(1.0 - used, 0.0), -program.apart / square[:, 0]]),
            bounds=[*zip(below, above, strict=True), (None, None)],
            method="highs",
        )
        if done.status != 0:
            return None
        return np.asarray(done.x[:-1], dtype=np.float64), float(done.x[-1]) * unit


@final
@dataclass(frozen=True, eq=False)
class _Program:
    """What a linear program lowers, and what it keeps at most 0.

    Attributes:
        rates: (R,) 1/s.
        slopes: (R, E), in relative changes of the springs.
        apart: (P,) 1/s², squares of half the distance of two roots; negative for a conjugate pair.
        parting: (P, E), their slopes.
    """

    rates: Float
    slopes: Float
    apart: Float
    parting: Float
