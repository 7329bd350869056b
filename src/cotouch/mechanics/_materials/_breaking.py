"""The greatest principal stress of a tetrahedron, by which it breaks."""
# pyright: reportArgumentType=false, reportReturnType=false

import math

from cotouch.arrays import Float
from cotouch.kernels import block

# Laws of tetrahedra, by number.
SOLIDS = ("corotated", "st-venant-kirchhoff", "neo-hookean")


@block
def principal_stress(law: int, lam: float, mu: float, spot: Float, gradient: Float, first: int) -> float:
    """The greatest principal nominal stress, force over the area at rest: that of P Rᵀ, P the first Piola stress [Pa].

    The energies are isotropic, so it is the slope of their density by each principal stretch.

    Args:
        law: index among `SOLIDS`.
        lam: λ [Pa].
        mu: μ [Pa].
        spot: places of the corners, (4 or more, 4) [m].
        gradient: ∇N of the last three corners, (3 E, 4) [1/m].
        first: row of the element in it.
    """
    xx = yy = zz = xy = xz = yz = 0.0
    # C = FᵀF, entry by entry; F = Σ_n (x_n - x_0) ∇N_nᵀ.
    for a in range(3):
        fx = fy = fz = 0.0
        for n in range(3):
            edge = spot[n + 1, a] - spot[0, a]
            fx += edge * gradient[first + n, 0]
            fy += edge * gradient[first + n, 1]
            fz += edge * gradient[first + n, 2]
        xx, yy, zz = xx + fx * fx, yy + fy * fy, zz + fz * fz
        xy, xz, yz = xy + fx * fy, xz + fx * fz, yz + fy * fz
    # Eigenvalues of a symmetric matrix in closed form [Smith 1961].
    mean = (xx + yy + zz) / 3.0
    xx, yy, zz = xx - mean, yy - mean, zz - mean
    spread = math.sqrt(max((xx * xx + yy * yy + zz * zz + 2.0 * (xy * xy + xz * xz + yz * yz)) / 6.0, 0.0))
    great = middle = small = mean
    if spread > 1e-14 * mean:
        half = xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz)
        angle = math.acos(min(max(half / (2.0 * spread**3), -1.0), 1.0)) / 3.0
        great = mean + 2.0 * spread * math.cos(angle)
        small = mean + 2.0 * spread * math.cos(angle + 2.0 * math.pi / 3.0)
        middle = 3.0 * mean - great - small
    one, two, three = math.sqrt(great), math.sqrt(max(middle, 0.0)), math.sqrt(max(small, 0.0))
    if law == 0:
        return 2.0 * mu * (one - 1.0) + lam * (one + two + three - 3.0)
    if law == 1:
        return one * (mu * (great - 1.0) + 0.5 * lam * (great + middle + small - 3.0))
    return mu * one + ((lam + mu) * (one * two * three - 1.0) - mu) * two * three
