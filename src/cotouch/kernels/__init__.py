"""How a function becomes a kernel, and what kernels compute with: vectors, 3 x 3 matrices, angles."""

from cotouch.kernels import matrix3
from cotouch.kernels._angle import angles
from cotouch.kernels._bounds import as_written, beyond, written_here
from cotouch.kernels._four_numbers import FourNumbers
from cotouch.kernels._kernel import block, inner, kernel, outlined, part
from cotouch.kernels._raises import raises
from cotouch.kernels._reason import reason
from cotouch.kernels._vector import (
    FOUR,
    WIDTHS,
    at,
    four,
    lane,
    load,
    lower,
    put,
    root,
    size,
    splat,
    store,
    total,
    transposed,
    upper,
    where,
)

__all__ = [
    "FOUR",
    "WIDTHS",
    "FourNumbers",
    "angles",
    "as_written",
    "at",
    "beyond",
    "block",
    "four",
    "inner",
    "kernel",
    "lane",
    "load",
    "lower",
    "matrix3",
    "outlined",
    "part",
    "put",
    "raises",
    "reason",
    "root",
    "size",
    "splat",
    "store",
    "total",
    "transposed",
    "upper",
    "where",
    "written_here",
]
