"""What named parts of a mesh of tetrahedra are made of, element by element."""

from collections.abc import Mapping
from typing import Final, TypeAlias

import numpy as np

from cotouch.arrays import Float, Long
from cotouch.errors import BodyError

# By the name of a set: young [Pa], poisson and rayleigh_stiffness [s] of what lies in it.
Parts: TypeAlias = Mapping[str, Mapping[str, float]]

_KEYS: Final = ("young", "poisson", "rayleigh_stiffness")
_RANGES: Final = {
    "young": (0.0, np.inf, "a finite number above 0 Pa"),
    "poisson": (-1.0, 0.5, "above -1 and below 0.5"),
    "rayleigh_stiffness": (-1e-300, np.inf, "a finite number of at least 0 s"),
}


def of_parts(
    parts: Parts, elements: Long, sets: Mapping[str, Long], whole: Mapping[str, float], name: str, model: str
) -> dict[str, float | Float]:
    """Young's modulus, Poisson's ratio and damping of each tetrahedron; one number each without parts.

    Args:
        parts: by name; what a part does not say is as of the whole. A tetrahedron belongs to a part if all of its
            corners do; to the last that is named, if to several.
        elements: corners, (E, 4).
        sets: nodes of every named set.
        whole: of what lies in no part.
        name: of the mesh, in words.
        model: name of the material.

    Raises:
        BodyError: a set is not there or holds no tetrahedron, or a value is none or out of its range.
    """
    if not parts:
        return dict(whole)
    values: dict[str, Float] = {key: np.full(elements.shape[0], whole[key]) for key in _KEYS}
    for part, said in parts.items():
        if part not in sets:
            there = ", ".join(f'"{one}"' for one in sorted(sets)) or "none"
            raise BodyError(f'parts names "{part}"; the sets of {name} are {there}')
        inside = np.isin(elements, sets[part]).all(axis=1)
        if not inside.any():
            raise BodyError(f'parts names "{part}", but that set of {name} holds no whole tetrahedron; name a volume')
        for key, value in said.items():
            if key not in _KEYS:
                raise BodyError(f'parts."{part}" has "{key}"; it may have {", ".join(_KEYS)}')
            low, high, range_ = _RANGES[key]
            if key == "poisson" and model == "neo-hookean" and not 0.0 < value < 0.5:
                raise BodyError(
                    f'parts."{part}".poisson is {value}; with model "neo-hookean" it must be above 0 and below 0.5'
                )
            if not low < value < high:
                raise BodyError(f'parts."{part}".{key} is {value}; it must be {range_}')
            values[key][inside] = value
    return dict(values)
