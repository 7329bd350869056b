"""How fast the closed loop of all users comes to rest together: its rightmost root. **Beyond** the paper."""

import math
from dataclasses import dataclass
from typing import final

import numpy as np
import numpy.typing as npt

from cotouch.errors import NetworkError, UnsupportedError
from cotouch.network._checks import one_user
from cotouch.network._collocation import generator_eigenvalues
from cotouch.network._network import Network
from cotouch.network._types import ComplexArray, FloatArray, IntArray

# Degree of the first collocation over the longest delay. Enough for the rightmost root of most networks; the count of
# roots notices when it is not, and the degree is doubled.
_FIRST_ORDER = 10
_DOUBLINGS = 6
# So many of the rightmost collocation eigenvalues are polished; among them is the rightmost root or the count fails.
_STARTS = 8
_NEWTON_STEPS = 60
# Largest turn of the determinant's phase between samples of the contour; half a turn would be lost.
_TURN = 1.0
_REFINEMENTS = 60
_MOST_SAMPLES = 20_000
# Where between two roots the line goes: near the middle, but at no special place.
_BETWEEN = 0.4637
# Samples of the small circle on which coinciding roots are counted.
_CIRCLE = 32
# Starts that Newton throws this many longest delays to the left don't lead to the rightmost root.
_FAR_LEFT = 100.0
# Roots closer together than this, relative to themselves, are one root found twice.
_SAME = 1e-8


@final
@dataclass(frozen=True, eq=False)
class Decay:
    """The rightmost root of the closed loop, the resting translation aside.

    Attributes:
        root: 1/s; its real part is the slowest rate of decay, negative when the loop comes to rest; of a conjugate pair
            the one with Im >= 0.
        residual: smallest singular value of the characteristic matrix at the root over its largest diagonal term:
            round-off.
        mode: (N,) complex, unit norm: how the users move in this mode.
        sync_damping: (N,) Ns/m, the damping `B_i` that was used.
    """

    root: complex
    residual: float
    mode: ComplexArray
    sync_damping: FloatArray

    @property
    def rate(self) -> float:
        """Real part of the root, 1/s."""
        return self.root.real

    @property
    def time_constant_s(self) -> float:
        """Seconds in which the slowest mode falls by e; inf when it does not fall."""
        return -1.0 / self.root.real if self.root.real < 0 else math.inf


@final
@dataclass(frozen=True, eq=False)
class _Loop:
    """`[(s^2 m + s c + kappa) I - K_ij e^(-s d_ij)] x = 0`."""

    inertia: FloatArray
    drag: FloatArray
    stiffness: FloatArray
    coupling: FloatArray
    delay: FloatArray
    grounded: bool

    def matrix(self, s: ComplexArray) -> ComplexArray:
        """Characteristic matrices (len(s), N, N)."""
        at = s[:, None]
        own = at**2 * self.inertia + at * self.drag + self.stiffness
        return own[:, :, None] * np.eye(len(self.inertia)) - self.coupling * np.exp(-s[:, None, None] * self.delay)

    def slope(self, s: ComplexArray) -> ComplexArray:
        """Their derivatives in s."""
        at = s[:, None]
        own = 2 * at * self.inertia + self.drag
        lagged = self.coupling * self.delay * np.exp(-s[:, None, None] * self.delay)
        return own[:, :, None] * np.eye(len(self.inertia)) + lagged


def rightmost_root(
    network: Network,
    *,
    mass: float = 1.0,
    damping: float = 0.0,
    stiffness: float = 0.0,
    sync_damping: npt.ArrayLike | None = None,
) -> Decay:
    """Rightmost root but the translation at 0 of the closed loop of N scaled copies and their delayed links.

    The roots s make `det[(s^2 m/N + s (b/N + B_i) + k/N + sum_j K_ij) I - K_ij e^(-s d_ij)]` zero. With k = 0 all users
    may rest anywhere together: that one root at 0 is left out, no other. Chebyshev collocation gives starting values,
    Newton the digits; then the argument principle counts the roots right of a line left of the result, and collocation
    is refined until none is missing.

    Args:
        network: connected; springs without weights.
        mass: kg of the whole object (or of one body mode), above 0.
        damping: Ns/m of the object or mode, at least 0.
        stiffness: N/m of the object or mode, at least 0.
        sync_damping: (N,) `B_i` in Ns/m, at least 0; None takes the rule with the delays as ages, `B_i = sum_j (d_ij +
            d_ji)/2 K_ij`.

    Raises:
        NetworkError: not connected, or a parameter out of its range.
        UnsupportedError: springs with weights, or roots too crowded to count.
    """
    loop, sync = _closed_loop(network, mass, damping, stiffness, sync_damping)
    if not loop.grounded and not loop.drag.any() and not loop.delay.any():
        # Nothing dissipates and nothing is late: the translation drifts, a double root at 0, and the rest rings on.
        mode = np.full(network.size, network.size**-0.5, dtype=np.complex128)
        return Decay(root=0j, residual=0.0, mode=mode, sync_damping=sync)
    order = _FIRST_ORDER
    for _ in range(_DOUBLINGS):
        starts = generator_eigenvalues(loop.inertia, loop.drag, loop.stiffness, loop.coupling, loop.delay, order=order)
        roots = _polished(loop, starts)
        if roots.size and _complete(loop, roots):
            root = complex(roots[0])
            _, sizes, right = np.linalg.svd(loop.matrix(np.array([root]))[0])
            terms = np.max(abs(root) ** 2 * loop.inertia + abs(root) * loop.drag + loop.stiffness)
            return Decay(root=root, residual=float(sizes[-1] / terms), mode=right[-1].conj(), sync_damping=sync)
        order *= 2
    raise UnsupportedError("the roots of the closed loop are too crowded to tell the rightmost one for certain")


def _closed_loop(
    network: Network, mass: float, damping: float, stiffness: float, sync_damping: npt.ArrayLike | None
) -> tuple[_Loop, FloatArray]:
    if not (math.isfinite(mass) and mass > 0):
        raise NetworkError(f"mass is {mass:g} kg; it must be finite and above 0")
    for name, value, unit in (("damping", damping, "Ns/m"), ("stiffness", stiffness, "N/m")):
        if not (math.isfinite(value) and value >= 0):
            raise NetworkError(f"{name} is {value:g} {unit}; it must be finite and at least 0")
    if not network.is_connected():
        raise NetworkError(
            f"the links leave {len(network.components())} separate groups of users, which never come together; "
            "link them"
        )
    if any(network.weight_of[i, j] >= 0 for i, j in network.links):
        raise UnsupportedError(
            "springs have weights; the decay of one body mode needs scalar springs: use the mode's own"
        )
    spring = network.linked_spring()
    if sync_damping is None:
        sync = (spring * (network.delay + network.delay.T) / 2).sum(axis=1)
    else:
        sync = np.array(sync_damping, dtype=np.float64)
        if sync.shape != (network.size,):
            raise NetworkError(f"sync_damping has shape {sync.shape}; it must be ({network.size},), one for each user")
        for i in map(int, np.flatnonzero(~(np.isfinite(sync) & (sync >= 0)))):
            raise NetworkError(
                f"sync_damping of {one_user(network.users, i)} is {sync[i]:g} Ns/m; it must be finite and at least 0"
            )
    size = network.size
    loop = _Loop(
        inertia=np.full(size, mass / size),
        drag=damping / size + sync,
        stiffness=stiffness / size + spring.sum(axis=1),
        coupling=spring,
        delay=np.where(spring > 0, network.delay, 0.0),
        grounded=stiffness > 0,
    )
    return loop, sync


def _scale(loop: _Loop) -> float:
    """A rate of the loop, to tell a root from 0 by: the stiffest spring on its damper and mass, else damper on mass."""
    resistance = loop.drag + np.sqrt(loop.stiffness * loop.inertia)
    return float(np.max(loop.stiffness / resistance if loop.stiffness.any() else loop.drag / loop.inertia))


def _polished(loop: _Loop, starts: ComplexArray) -> ComplexArray:
    """Different roots with Im >= 0, but the translation, by Newton from the rightmost starts, largest real part first.

    Newton runs on the smallest singular value, so a root that symmetric users share is reached as fast as a simple one.
    """
    s = starts[starts.imag >= 0][:_STARTS]
    scale = _scale(loop)
    found: list[complex] = []
    last = np.full(len(s), np.inf)
    longest = float(loop.delay.max())
    for _ in range(_NEWTON_STEPS):
        if not s.size:
            break
        left, sizes, right = np.linalg.svd(loop.matrix(s))
        slope = np.einsum("si,sij,sj->s", left[:, :, -1].conj(), loop.slope(s), right[:, -1].conj())
        with np.errstate(divide="ignore", invalid="ignore"):
            step = sizes[:, -1] / slope
        # From far away a step may aim anywhere; none is longer than the distance to the origin, about.
        step = step / np.maximum(1.0, np.abs(step) / (np.abs(s) + scale))
        s = s - step
        size = np.abs(step) / (np.abs(s) + scale)
        # A critically damped root is known to half the digits only; there the steps stop shrinking instead.
        converged = (size <= 1e-13) | ((size < 1e-7) & (size >= last))
        for root in s[converged]:
            upper = complex(root.real, abs(root.imag) if abs(root.imag) > 1e-12 * abs(root) else 0.0)
            if all(abs(upper - other) > _SAME * (abs(upper) + scale) for other in found) and (
                loop.grounded or abs(upper) > 1e-11 * scale
            ):
                found.append(upper)
        rest = ~converged & np.isfinite(s) & (s.real * longest > -_FAR_LEFT)
        s, last = s[rest], size[rest]
    return np.array(sorted(found, key=lambda root: -root.real), dtype=np.complex128)


def _complete(loop: _Loop, roots: ComplexArray) -> bool:
    """Whether `roots` holds every root right of a line that lies left of the first one."""
    # The first gap wide enough to draw the line through; below the last root it is a guess that the count judges.
    width = 0.01 * (abs(roots[0]) + 0.1 * _scale(loop))
    gaps = -np.diff(roots.real, append=roots[-1].real - 5 * width)
    last = int(np.argmax(gaps > width))
    line = float(roots[last].real - gaps[last] * _BETWEEN)
    try:
        counted = _count_right_of(loop, line)
    except np.linalg.LinAlgError:
        return False  # The contour meets a root to the last bit.
    if not loop.grounded and line < 0 and counted is not None:
        counted -= 1
    inside = roots[: last + 1]
    copies = np.where(inside.imag > 0, 2, 1)
    return counted == int(copies.sum()) or counted == int((copies * _multiplicities(loop, inside, roots)).sum())


def _multiplicities(loop: _Loop, roots: ComplexArray, others: ComplexArray) -> IntArray:
    """How many roots coincide at each of `roots`, by the logarithmic derivative around it."""
    apart = np.abs(roots[:, None] - np.concatenate([others, others.conj(), [0.0]])[None, :])
    apart[apart == 0.0] = np.inf
    radius = np.minimum(apart.min(axis=1) / 3, 1e-3 * (np.abs(roots) + _scale(loop)))
    around = np.exp(2j * np.pi * np.arange(_CIRCLE) / _CIRCLE)
    s = (roots[:, None] + radius[:, None] * around).ravel()
    ratio = np.einsum("sij,sji->s", np.linalg.inv(loop.matrix(s)), loop.slope(s)).reshape(len(roots), _CIRCLE)
    return np.rint((ratio * radius[:, None] * around).mean(axis=1).real).astype(np.int64)


def _count_right_of(loop: _Loop, line: float) -> int | None:
    """Number of roots with real part above `line`, by the argument principle; None if unclear.

    What turns is the determinant over the product of its diagonal, whose own roots are those of quadratics. Where the
    diagonal dominates this ratio cannot wind. That is so beyond `reach` anywhere right of the line, so a rectangle
    holds all roots, and on the line itself beyond `free`; nearer, samples are close enough together for the longest
    delay. All is real on the real axis: the upper half of the rectangle suffices.
    """
    pull = (loop.coupling * np.exp(-line * loop.delay)).sum(axis=1)
    all_pull = pull + loop.stiffness
    reach = 1.01 * float(np.max((loop.drag + np.sqrt(loop.drag**2 + 4 * loop.inertia * all_pull)) / (2 * loop.inertia)))
    reach = max(reach, 1.5 * abs(line), 1e-300)
    # |own|^2 = (rest - m w^2)^2 + (drag w)^2 on the line, a quadratic in w^2 beside pull^2.
    rest = line**2 * loop.inertia + line * loop.drag + loop.stiffness
    drag = loop.drag + 2 * line * loop.inertia
    half = (drag**2 - 2 * rest * loop.inertia) / (2 * loop.inertia**2)
    radicand = half**2 - (rest**2 - pull**2) / loop.inertia**2
    squares = np.where(radicand > 0, np.sqrt(np.maximum(radicand, 0.0)) - half, 0.0)
    free = min(1.01 * float(np.sqrt(np.maximum(squares, 0.0).max())), reach)
    samples = 20 + math.ceil(4 * free * float(loop.delay.max()))
    if samples > _MOST_SAMPLES:
        return None
    near = np.linspace(0.0, free, samples)
    far = np.geomspace(max(free, 1e-9 * reach), reach, 40)
    sides = (
        reach + 1j * np.linspace(0.0, reach, 12),
        np.linspace(reach, line, 12) + 1j * reach,
        line + 1j * far[::-1],
        line + 1j * near[::-1],
    )
    contour: ComplexArray = np.concatenate(sides).astype(np.complex128)
    phase, speed = _ratio(loop, contour)
    own_roots = np.array([np.roots(row) for row in zip(loop.inertia, loop.drag, loop.stiffness, strict=True)])
    for _ in range(_REFINEMENTS):
        turn = np.angle(phase[1:] / phase[:-1])
        expected = np.abs(np.diff(contour)) * np.maximum(speed[1:], speed[:-1])
        wide = np.flatnonzero(~((np.abs(turn) < _TURN) & (expected < _TURN)))
        if not wide.size:
            return round(float(turn.sum() / np.pi)) + int((own_roots.real > line).sum())
        if len(contour) > 4 * _MOST_SAMPLES:
            return None
        between: ComplexArray = (contour[wide] + contour[wide + 1]) / 2
        more_phase, more_speed = _ratio(loop, between)
        contour = np.insert(contour, wide + 1, between)
        phase = np.insert(phase, wide + 1, more_phase)
        speed = np.insert(speed, wide + 1, more_speed)
    return None


def _ratio(loop: _Loop, s: ComplexArray) -> tuple[ComplexArray, FloatArray]:
    """Phase of the determinant over the product of its diagonal, and how fast its logarithm changes along s.

    The speed shows roots between two samples whose turns add up to whole ones and hide.
    """
    matrix, slope = loop.matrix(s), loop.slope(s)
    own = np.einsum("sii->si", matrix)
    own_slope = 2 * s[:, None] * loop.inertia + loop.drag
    phase = np.linalg.slogdet(matrix)[0] / np.prod(own / np.abs(own), axis=1)
    rate = np.einsum("sij,sji->s", np.linalg.inv(matrix), slope) - (own_slope / own).sum(axis=1)
    return phase.astype(np.complex128), np.abs(rate).astype(np.float64)
