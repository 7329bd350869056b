"""What a page is told once: the object, and what stands around it."""

import json

from cotouch.body import lattice
from cotouch.mechanics import Box, Plane
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
