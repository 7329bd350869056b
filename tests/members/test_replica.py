"""What a session makes of its body."""

import pytest

from cotouch.members import SessionFile, SharedModel

TEXT = """
[network]
users = ["Ann", "Ben"]
spring = [[0, 50], [50, 0]]
delay = [[0, 0.01], [0.01, 0]]
[body]
kind = "lattice"
shape = [3, 3, 3]
"""


@pytest.mark.parametrize(("line", "name"), [('model = "cells"', "cells"), ('frame = "floating"', "floating")])
def test_a_body_with_a_material_is_taken(line: str, name: str) -> None:
    material = SharedModel.build(SessionFile.from_toml(TEXT + line + "\n", source="a test")).body.material
    assert material is not None
    assert material.model == name


def test_a_linear_body_is_taken() -> None:
    assert SharedModel.build(SessionFile.from_toml(TEXT, source="a test")).body.material is None
