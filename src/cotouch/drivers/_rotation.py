"""What rotation matrices of vendors' libraries say."""

import math
from collections.abc import Sequence


def quaternion_of(rows: Sequence[float]) -> tuple[float, float, float, float]:
    """A rotation as a unit quaternion xyzw; not a number where the matrix is none.

    Args:
        rows: of the matrix, 9 numbers.
    """
    m00, m01, m02, m10, m11, m12, m20, m21, m22 = rows
    w, x, y, z = 1.0 + m00 + m11 + m22, 1.0 + m00 - m11 - m22, 1.0 - m00 + m11 - m22, 1.0 - m00 - m11 + m22
    largest = max(w, x, y, z)
    if not math.isfinite(sum(rows)) or not largest > 0.0:
        return math.nan, math.nan, math.nan, math.nan
    if largest == w:
        out = (m21 - m12, m02 - m20, m10 - m01, w)
    elif largest == x:
        out = (x, m01 + m10, m02 + m20, m21 - m12)
    elif largest == y:
        out = (m01 + m10, y, m12 + m21, m02 - m20)
    else:
        out = (m02 + m20, m12 + m21, z, m10 - m01)
    size = math.hypot(*out)
    return out[0] / size, out[1] / size, out[2] / size, out[3] / size
