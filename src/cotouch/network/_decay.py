"""How fast the closed loop of all users comes to rest together: its rightmost root. **Beyond** the paper."""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import final

import numpy as np
import numpy.typing as npt

from cotouch.arrays import Complex, Float
from cotouch.errors import NetworkError, UnsupportedError
from cotouch.interrupt import check
from cotouch.network._checks import one_user
from cotouch.network._collocation import generator_eigenvalues
from cotouch.network._damping import link_damping
from cotouch.network._loop import Loop, characteristic, loop_of
from cotouch.network._network import Network
from cotouch.network._rightmost import rightmost

# Degree of the first collocation over the longest delay, for what the walk along a line does not settle by itself.
_FIRST_ORDER = 10
_DOUBLINGS = 5
# So many of the rightmost collocation eigenvalues are polished.
_STARTS = 8
# Larger matrices of a collocation are not tried: their eigenvalues take minutes.
_MOST_ROWS = 4000


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
    mode: Complex
    sync_damping: Float

    @property
    def rate(self) -> float:
        """Real part of the root, 1/s."""
        return self.root.real

    @property
    def time_constant_s(self) -> float:
        """Seconds in which the slowest mode falls by e; inf when it does not fall."""
        return -1.0 / self.root.real if self.root.real < 0 else math.inf


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
    may rest anywhere together: that one root at 0 is left out, no other. Newton gives the digits; the argument
    principle counts the roots right of a line just left of the result, in steps along it that cannot lose a turn of the
    determinant; the same walk says where to look for roots that the count misses. Where that does not settle it,
    Chebyshev collocation, refined until none is missing, gives the starting values.

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
    loop, sync = closed_loop(network, mass, damping, stiffness, sync_damping)
    grounded = stiffness > 0
    late = bool(loop.to_first.any() or loop.to_second.any())
    if not grounded and not loop.drag.any() and not late:
        # Nothing dissipates and nothing is late: the translation drifts, a double root at 0, and the rest rings on.
        mode = np.full(network.size, network.size**-0.5, dtype=np.complex128)
        return Decay(root=0j, residual=0.0, mode=mode, sync_damping=sync)
    root, certain = 0j, False
    for guesses in _guesses(loop):
        root, certain, _ = rightmost(loop, not grounded, guesses)
        check()
        if certain:
            break
    if not certain:
        raise UnsupportedError(
            "the roots of the closed loop are too close together to identify the rightmost one reliably"
        )
    root = complex(root)
    _, sizes, right = np.linalg.svd(characteristic(loop, root))
    terms = np.max(abs(root) ** 2 * loop.mass + abs(root) * loop.drag + loop.rigid)
    return Decay(root=root, residual=float(sizes[-1] / terms), mode=right[-1].conj(), sync_damping=sync)


def _guesses(loop: Loop) -> Iterator[Complex]:
    """Where the rightmost root may be: first no idea, then ever finer collocation."""
    yield np.zeros(0, dtype=np.complex128)
    coupling, delay = np.zeros((2, len(loop.mass), len(loop.mass)))
    coupling[loop.first, loop.second] = coupling[loop.second, loop.first] = loop.spring
    delay[loop.first, loop.second], delay[loop.second, loop.first] = loop.to_first, loop.to_second
    for doubling in range(_DOUBLINGS):
        order = _FIRST_ORDER * 2**doubling
        if doubling and len(loop.mass) * order > _MOST_ROWS:
            return
        starts = generator_eigenvalues(loop.mass, loop.drag, loop.rigid, coupling, delay, order=order)
        yield starts[starts.imag >= 0][:_STARTS]


def closed_loop(
    network: Network,
    mass: float = 1.0,
    damping: float = 0.0,
    stiffness: float = 0.0,
    sync_damping: npt.ArrayLike | None = None,
) -> tuple[Loop, Float]:
    """The loop whose roots `rightmost_root` looks for, and the (N,) `B_i` in it; arguments and errors are the same.

    Args:
        network: of the users.
        mass: of each copy, > 0 [kg].
        damping: of each copy to the ground, >= 0 [Ns/m].
        stiffness: likewise, >= 0 [N/m].
        sync_damping: `B_i`, (N,) [Ns/m]; None: by the rule.
    """
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
            "springs have weights; the decay of one body mode needs scalar springs; use those of the mode"
        )
    spring = network.linked_spring()
    if sync_damping is None:
        sync = link_damping(spring, network.delay + network.delay.T).sum(axis=1)
    else:
        sync = np.array(sync_damping, dtype=np.float64)
        if sync.shape != (network.size,):
            raise NetworkError(f"sync_damping has shape {sync.shape}; it must be ({network.size},), one for each user")
        for i in map(int, np.flatnonzero(~(np.isfinite(sync) & (sync >= 0)))):
            raise NetworkError(
                f"sync_damping of {one_user(network.users, i)} is {sync[i]:g} Ns/m; it must be finite and at least 0"
            )
    copy_scale = np.full(network.size, 1.0 / network.size)
    return loop_of(
        network, mass=mass * copy_scale, drag=damping * copy_scale + sync, ground=stiffness * copy_scale
    ), sync
