"""The rotation nearest to a matrix, wherever one looks for it from.

All that resists in an element whose rotation is `max tr RᵀS` follows from that maximum, so it is a function of the
place alone only if the maximum is found. Sweeps of Newton's method find it from nearby; where an element is inside out,
or a long step turns it far, they may end at a saddle, or nowhere. What they end at is the maximum if the second
derivative says so, as on all rotations there is no other one [Wahba 1965]; else it is found by quaternions [Horn 1987].
"""

from typing import TypeAlias

from cotouch.kernels import inner, lower, part, root, size, total, upper, where
from cotouch.kernels.matrix3 import Matrix, cofactor, inertia, product, solved, transposed_product

# The upper triangle of a symmetric matrix of four by four, row by row.
_Four: TypeAlias = tuple[float, float, float, float, float, float, float, float, float, float]
# Sweeps that a step takes at most: mostly one or two, more where a long step turns an element far, for only rotations
# that are those of the place make an energy that anybody can work out anew.
SWEEPS = 12
# Squares of the angles after which the next sweep is left out: of the first in a step, of later ones, and from nowhere.
_LITTLE, _LATER, _NOTHING = 2.5e-5, 1e-10, 1e-24
# The second derivative has a sign if its determinant is beyond this share of the cube of its size.
_SURE = 1e-9
# Squarings that leave of all quaternions the best one; what they do not tell apart differs by less than rounding. Fewer
# do if the others are below this share.
_SQUARINGS, _ALONE = 60, 1e-14


@inner
def _turned(r: Matrix, s: Matrix) -> tuple[Matrix, float, float]:
    """One Newton sweep towards the rotation R that maximises `tr RᵀS`.

    `R cay(w)` with `w = (tr M · I - sym M)⁻¹ axial M`, `M = RᵀS`; it stays a rotation however far it is from the best.

    Returns:
        The rotation, the square of the angle that it turned by, and a number above 0 where there is a maximum nearby.
    """
    m = transposed_product(r, s)
    falls = inertia(m)
    w = solved(falls, (m[7] - m[5], m[2] - m[6], m[3] - m[1]))
    square = w[0] * w[0] + w[1] * w[1] + w[2] * w[2]
    # cay(w) = I + c ([w] + ½ [w]²), [w]² = w wᵀ - |w|² I.
    c = 1.0 / (1.0 + 0.25 * square)
    h = 0.5 * c
    q = (
        1.0 + h * (w[0] * w[0] - square),
        h * w[0] * w[1] - c * w[2],
        h * w[0] * w[2] + c * w[1],
        h * w[1] * w[0] + c * w[2],
        1.0 + h * (w[1] * w[1] - square),
        h * w[1] * w[2] - c * w[0],
        h * w[2] * w[0] - c * w[1],
        h * w[2] * w[1] + c * w[0],
        1.0 + h * (w[2] * w[2] - square),
    )
    return product(r, q), square, _positive(falls)


@inner
def _positive(a: Matrix) -> float:
    """Above 0 where a symmetric matrix is positive definite beyond doubt."""
    c = cofactor(a)
    bulk = size(a[0]) + size(a[4]) + size(a[8])
    determinant = a[0] * c[0] + a[1] * c[1] + a[2] * c[2]
    return lower(lower(determinant - _SURE * bulk * bulk * bulk, c[0]), lower(a[0], c[8]))


@inner
def nearest(r: Matrix, s: Matrix, sweeps: int) -> Matrix:
    """The rotation that maximises `tr RᵀS`, looked for from another.

    What a sweep leaves is of the order of the square of what it turned by, times the strain. In a step the second is
    left out where the first hardly turned, and more than two are for what is flung about; a search from nowhere, with
    more sweeps than `SWEEPS`, goes on until nothing is left.

    Args:
        r: from where.
        s: the matrix.
        sweeps: at most.
    """
    best, sure, square, enough = r, s[0], s[0], _LITTLE
    for sweep in range(sweeps):
        best, square, sure = _turned(best, s)
        enough = (_LITTLE if sweep == 0 else _LATER) if sweeps <= SWEEPS else _NOTHING
        if total(square) <= enough:
            break
    # Where this is not above 0, the sweeps ended nowhere, or at what may be no maximum.
    if total(square) > enough:
        sure = where(_LATER - square, sure, -1.0)
    if total(where(sure, 0.0, 1.0)) > 0.0:
        best = _from_nowhere(best, s, sure)
    return best


@part
def _from_nowhere(r: Matrix, s: Matrix, sure: float) -> Matrix:
    """The rotation that maximises `tr RᵀS` where `sure` is not above 0; there is r where it is.

    `tr RᵀS = qᵀ N q` for the quaternion q of R, so the best q belongs to the largest eigenvalue of N. Shifted so that
    no eigenvalue is below 0, N is squared until nothing but this one is left.
    """
    trace = s[0] + s[4] + s[8]
    ax, ay, az = s[7] - s[5], s[2] - s[6], s[3] - s[1]
    p = (
        trace, ax, ay, az,
        2.0 * s[0] - trace, s[1] + s[3], s[2] + s[6],
        2.0 * s[4] - trace, s[5] + s[7],
        2.0 * s[8] - trace,
    )  # fmt: skip
    shift = root(_squares(p))
    p = (p[0] + shift, p[1], p[2], p[3], p[4] + shift, p[5], p[6], p[7] + shift, p[8], p[9] + shift)
    for _ in range(_SQUARINGS):
        p = _normal(p)
        alone = 1.0 - _squares(p)
        if total(upper(alone, 0.0 * alone)) <= _ALONE:
            break
        p = _squared(p)
    p = _normal(p)
    # What is left is q qᵀ; its largest column says most of q.
    w, x, y, z, most = p[0], p[1], p[2], p[3], p[0]
    w, x, y, z, most = _larger(p[4] - most, (p[1], p[4], p[5], p[6]), p[4], (w, x, y, z), most)
    w, x, y, z, most = _larger(p[7] - most, (p[2], p[5], p[7], p[8]), p[7], (w, x, y, z), most)
    w, x, y, z, most = _larger(p[9] - most, (p[3], p[6], p[8], p[9]), p[9], (w, x, y, z), most)
    square = w * w + x * x + y * y + z * z
    k = where(square, 2.0 / square, 0.0)
    found = (
        1.0 - k * (y * y + z * z), k * (x * y - w * z), k * (x * z + w * y),
        k * (x * y + w * z), 1.0 - k * (x * x + z * z), k * (y * z - w * x),
        k * (x * z - w * y), k * (y * z + w * x), 1.0 - k * (x * x + y * y),
    )  # fmt: skip
    return (
        where(sure, r[0], found[0]), where(sure, r[1], found[1]), where(sure, r[2], found[2]),
        where(sure, r[3], found[3]), where(sure, r[4], found[4]), where(sure, r[5], found[5]),
        where(sure, r[6], found[6]), where(sure, r[7], found[7]), where(sure, r[8], found[8]),
    )  # fmt: skip


_Quaternion: TypeAlias = tuple[float, float, float, float]


@inner
def _larger(
    more: float, one: _Quaternion, size_of_one: float, two: _Quaternion, size_of_two: float
) -> tuple[float, float, float, float, float]:
    """The first column and its size where `more` is above 0, else the second and its."""
    return (
        where(more, one[0], two[0]),
        where(more, one[1], two[1]),
        where(more, one[2], two[2]),
        where(more, one[3], two[3]),
        where(more, size_of_one, size_of_two),
    )


@inner
def _squares(p: _Four) -> float:
    """Sum of the squares of all entries."""
    beside = p[1] * p[1] + p[2] * p[2] + p[3] * p[3] + p[5] * p[5] + p[6] * p[6] + p[8] * p[8]
    return p[0] * p[0] + p[4] * p[4] + p[7] * p[7] + p[9] * p[9] + 2.0 * beside


@inner
def _normal(p: _Four) -> _Four:
    """The matrix divided by its trace."""
    trace = p[0] + p[4] + p[7] + p[9]
    k = where(trace, 1.0 / trace, 0.0)
    return k * p[0], k * p[1], k * p[2], k * p[3], k * p[4], k * p[5], k * p[6], k * p[7], k * p[8], k * p[9]


@inner
def _squared(p: _Four) -> _Four:
    a, b, c, d, e, f, g, h, i, j = p
    return (
        a * a + b * b + c * c + d * d,
        a * b + b * e + c * f + d * g,
        a * c + b * f + c * h + d * i,
        a * d + b * g + c * i + d * j,
        b * b + e * e + f * f + g * g,
        b * c + e * f + f * h + g * i,
        b * d + e * g + f * i + g * j,
        c * c + f * f + h * h + i * i,
        c * d + f * g + h * i + i * j,
        d * d + g * g + i * i + j * j,
    )
