"""A texture as a page draws it: the heights that contact has, no more of them than can be seen."""

import base64
from typing import Any

import numpy as np
import pytest

from cotouch.scenario import DrawnTexture, TextureTable

MAP = [[0.0, 4e-4, 1e-4], [2e-4, 0.0, 5e-4]]
TABLES: list[dict[str, Any]] = [
    {"pattern": "ridges", "wavelength": 0.004, "height": 2e-4},
    {"pattern": "bumps", "wavelength": 0.004, "height": 2e-4, "angle": 0.7},
    {"heights": MAP, "size": [0.03, 0.02], "angle": -1.1},
]


def drawn(table: dict[str, Any]) -> DrawnTexture:
    """One tile of it."""
    found = TextureTable.model_validate(table).drawn()
    assert found is not None
    return found


@pytest.mark.parametrize("table", TABLES, ids=lambda table: table.get("pattern", "heights"))
def test_a_tile_has_the_heights_that_contact_has(table: dict[str, Any]) -> None:
    found = drawn(table)
    rows, columns = found.heights.shape
    v, u = np.divmod(np.arange(rows * columns), columns)
    u, v = (u + 0.5) / columns * found.size[0] + 3 * found.size[0], (v + 0.5) / rows * found.size[1] - found.size[1]
    c, s = np.cos(found.angle), np.sin(found.angle)
    place = np.stack([c * u - s * v, s * u + c * v, np.zeros(u.size)], axis=-1)
    felt = TextureTable.model_validate({**table, "projection": "z"}).profile()(place, np.zeros_like(place))
    assert found.heights.ravel() == pytest.approx(felt, abs=1e-9 * found.top)
    assert 0.9 * found.top < found.heights.max() <= found.top


def test_a_page_is_told_a_bounded_tile_of_bounded_numbers() -> None:
    rng = np.random.default_rng(1)
    rough = rng.uniform(0.0, 1e-3, (700, 3))
    found = drawn({"heights": rough.tolist(), "size": [0.01, 2.0], "projection": "x"})
    assert found.heights.shape == (256, 128)
    assert found.heights.mean() == pytest.approx(rough.mean(), rel=0.02)
    told = found.table()
    levels = np.frombuffer(base64.b64decode(told.pop("heights")), dtype="<u2")
    assert levels.reshape(256, 128) / 65535 * found.top == pytest.approx(found.heights, abs=found.top / 65535)
    top = pytest.approx(rough.max())
    assert told == {"rows": 256, "columns": 128, "size": [0.01, 2.0], "top": top, "angle": 0.0, "projection": "x"}


def test_what_is_flat_is_not_drawn() -> None:
    assert TextureTable.model_validate({"heights": [[0.0, 0.0]], "size": [0.01, 0.01]}).drawn() is None
