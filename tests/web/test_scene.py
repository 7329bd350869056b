"""What a page is told once: the object, and what stands around it."""

from collections.abc import Mapping
from typing import Any

from tests.web.fake_session_api import FakeSessionApi
from tests.web.visitor import visit

from cotouch.body import Placed, lattice, rigid_box, together
from cotouch.mechanics import Box, Plane, Solid
from cotouch.observers import CopyView, Scene
from cotouch.web import PageServer


class Shown(FakeSessionApi):
    """A stage of this scene on which nobody has begun yet."""

    def __init__(self, scene: Scene) -> None:
        super().__init__("1d")
        self._scene = scene

    def views(self) -> Mapping[int, CopyView]:
        return {}


def told(scene: Scene) -> dict[str, Any]:
    with PageServer(Shown(scene), port=0) as server, visit(server) as page:
        return page.text("scene")


def test_it_has_what_stands_around_the_object() -> None:
    shapes = (Plane((0.0, 0.0, -0.1)), Box((0.1, 0.2, 0.3), (1.0, 0.0, 0.0), (0.0, 0.0, 0.5)))
    scene = Scene(title="a block", users=("Ann",), body=lattice((2, 2, 2)), own=(0,), may=frozenset(), shapes=shapes)
    assert told(scene)["obstacles"] == [
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
    message = told(scene)
    assert message["parts"] == [
        {"name": "low", "vertices": 8, "colour": None},
        {"name": "high", "vertices": 8, "colour": "#ff0000"},
    ]
    assert [len(message["obstacles"][0][name]) for name in ("vertices", "triangles")] == [24, 36]
    assert message["texture"] is None
    alone = Scene(title="one", body=die, **given)
    assert told(alone)["parts"] == []
