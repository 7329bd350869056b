"""Laws of tetrahedra of others: what makes a stress and an energy a material that bodies can be of."""

import re
from collections.abc import Callable

import numpy as np

from cotouch.arrays import Float
from cotouch.body import add_solid_law
from cotouch.errors import BodyError
from cotouch.kernels import FourNumbers, as_written, raises
from cotouch.kernels.matrix3 import Matrix
from cotouch.mechanics._materials._force import LAWS
from cotouch.mechanics._materials._tetrahedra import SOLIDS, SolidLaw, evaluate, resist, tables_of


def register_solid(
    name: str, *, stress: Callable[..., Matrix], energy: Callable[..., float], poisson_above: float = -1.0
) -> SolidLaw:
    """Makes a law of tetrahedra known by its name, instead of one of the same name.

    With H the gradient of displacement, F = I + H. Four tetrahedra are worked out at once, so all numbers may be four
    numbers; λ and μ come times the volume, and so do results.

    Args:
        name: as `model`.
        stress: compiled (`inner`); `stress(law, lam, mu, h, h1, memory, e)` is the mean first Piola stress between two
            H, `P : (H1 - H) = ψ(H1) - ψ(H)` exactly or to third order, such as that halfway; 0 at rest [J].
        energy: compiled; `energy(law, lam, mu, h1, memory, e, sweeps)` is ψ, 0 at rest [J].
        poisson_above: what Poisson's ratio must be above.

    Raises:
        BodyError: stress and energy are not those of one elastic material with these λ and μ.
    """
    broken = _uncompiled(stress, energy) or _findings(as_written(stress), as_written(energy))
    if broken:
        raise BodyError(f'material "{name}" breaks the interface: {broken[0]}')
    made = SOLIDS[name] = SolidLaw(tables_of("Solid_" + re.sub(r"\W", "_", name), f"Of {name}"), stress, energy)
    LAWS[made.kind] = resist, evaluate
    add_solid_law(name, poisson_above=poisson_above)
    return made


def _uncompiled(stress: Callable[..., Matrix], energy: Callable[..., float]) -> list[str]:
    """What both must be before they are run, in a sentence each."""
    found: list[str] = []
    for what, function in (("stress", stress), ("energy", energy)):
        where = raises(function)
        if where is not None:
            found.append(f"its {what} raises an error or asserts ({where}), which nobody catches where it runs")
        if not hasattr(function, "py_func"):
            found.append(f"its {what} is not compiled; write `@inner` above it")
    return found


# λ and μ with which laws are tried; odd, so that one is not taken for the other.
_LAMBDA, _MU = 3.0, 1.7


def _findings(stress: Callable[..., Matrix], energy: Callable[..., float]) -> list[str]:
    """What a law breaks of the interface, in a sentence each; it is run as it is written, not compiled."""

    def stored(h: Float) -> float:
        return float(energy(None, _LAMBDA, _MU, tuple(h.ravel()), None, None, 1))

    def pull(h: Float, h1: Float) -> Float:
        found = stress(None, _LAMBDA, _MU, tuple(h.ravel()), tuple(h1.ravel()), None, None)
        return np.array(found, dtype=np.float64).reshape(3, 3)

    rng = np.random.default_rng(0)
    h, way, rest = 0.1 * rng.normal(size=(3, 3)), rng.normal(size=(3, 3)), np.zeros((3, 3))
    turn = np.linalg.qr(rng.normal(size=(3, 3)))[0]
    turn *= np.linalg.det(turn)  # no mirror
    four = FourNumbers(1.0)
    try:
        stress(None, four, four, (four,) * 9, (four,) * 9, None, None)
        energy(None, four, four, (four,) * 9, None, None, 1)
        found: list[str] = []
        if abs(stored(rest)) > 1e-12 or np.abs(pull(rest, rest)).max() > 1e-12:
            found.append("energy or stress is not 0 at rest")
        missed = [float((pull(h, h + s * way) * s * way).sum()) - stored(h + s * way) + stored(h) for s in (0.02, 0.01)]
        if abs(missed[1]) > max(abs(missed[0]) / 6.0, 1e-12):
            found.append("the stress does not do the work of the energy: P : (H1 - H) is not ψ(H1) - ψ(H)")
        if abs(stored(turn @ (np.eye(3) + h) - np.eye(3)) - stored(h)) > 1e-9 * stored(h):
            found.append("the energy changes as the body turns")
        strain = 0.5e-4 * (way + way.T)
        linear = _MU * (strain**2).sum() + 0.5 * _LAMBDA * np.trace(strain) ** 2
        if abs(stored(strain) + stored(-strain) - 2.0 * linear) > 1e-3 * linear:
            found.append("near rest the energy is not μ ‖ε‖² + ½ λ (tr ε)², which young and poisson stand for")
    except NotImplementedError:  # what only machine code can do
        return []
    except Exception as error:  # noqa: BLE001 - what somebody wrote may be wrong in any way
        return [f"it cannot be evaluated: {error}"]
    return found
