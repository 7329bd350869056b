"""What a page is told once: the object, and what stands around it."""

import json
from typing import Any

from cotouch.body import Placed, lattice, rigid_box, together
from cotouch.mechanics import Box, Plane, Solid
from cotouch.observers import Scene
from cotouch.web._scene import scene_message


def test_it_has_what_stands_around_the_object() -> None:
    shapes = (Plane((0.0, 0.0, -0.1)), Box((0.1, 0.2, 0.3), (1.0, 0.0, 0.0), (0.0, 0.0, 0.5)))
    scene = Scene(title="a block", users=("Ann",), body=lattice((2, 2, 2)), own=(0,), may=frozenset(), shapes=shapes)
    told = json.loads(json.dumps(scene_message(scene, version="1", started="now", acts=True)))["obstacles"]
    assert told == [
        {"kind": "plane", "point": [0.0, 0.0, -0.1], "normal": [0.0, 0.0, 1.0]},
        {"kind": "box", "size": [0.1, 0.2, 0.3], "centre": [1.0, 0.0, 0.0], "turn": [0.0, 0.0, 0.5]},
    ]


def test_it_tells_several_bodies_apart_and_has_meshes_that_stand_still() -> None:
    die = rigid_box([0.1, 0.1, 0.1], resolution=1)
    assert die.skin is not None
    pair = together([Placed(body=die, name="low"), Placed(body=die, name="high", at=(0.0, 0.0, 0.2))])
    solid = Solid(die.skin.vertices, die.skin.triangles)
    given = {"users": ("Ann",), "own": (0,), "may": frozenset[Any]()}
    scene = Scene(title="two", body=pair, shapes=(solid,), colours=(None, "#ff0000"), **given)
    told = json.loads(json.dumps(scene_message(scene, version="1", started="now", acts=True)))
    assert told["parts"] == [
        {"name": "low", "vertices": 8, "colour": None},
        {"name": "high", "vertices": 8, "colour": "#ff0000"},
    ]
    assert [len(told["obstacles"][0][name]) for name in ("vertices", "triangles")] == [24, 36]
    assert told["texture"] is None
    alone = Scene(title="one", body=die, **given)
    assert scene_message(alone, version="1", started="now", acts=True)["parts"] == []
