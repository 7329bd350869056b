import base64
import gzip
import json
import re
import resource
from collections.abc import Generator
from importlib.resources import files
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
from playwright.sync_api import Browser, Page
from tests.body.shapes import sphere
from tests.simulation.browser import Opened, browser

from cotouch import body_from_surface
from cotouch.body import Skin
from cotouch.errors import BodyError, InputError, NetworkError, OutputError
from cotouch.mechanics import Box, Plane
from cotouch.simulation import Animation, PortTracks, ToolTracks, UserSeries

FRAMES = 40
TIME = np.arange(FRAMES) / 60
TIPS = [[0.0, 0.5, 0.0], [0.0, 0.0, 0.0]]
TRIANGLE: dict[str, Any] = {
    "title": "A triangle",
    "users": ["Ann", "Ben"],
    "time": TIME,
    "vertices": np.ones((FRAMES, 2, 1, 1)) * [[0, 0, 0], [0.1, 0, 0], [0, 0.1, 0]],
    "triangles": [[0, 1, 2]],
}
KINDS = {"f4": "<f4", "f8": "<f8", "u4": "<u4"}
Unpacked = tuple[dict[str, Any], dict[str, npt.NDArray[Any]]]


def unpacked(page: str) -> Unpacked:
    """Header and arrays of a page, read by the book and not by the page's own code; vertices as (F, U, V, 3) [m]."""
    header = json.loads(re.findall(r'<script type="application/json" id="header">(.*?)</script>', page, re.DOTALL)[0])
    text = re.findall(r'<script type="text/plain" id="data">(.*?)</script>', page, re.DOTALL)[0]
    data = gzip.decompress(base64.b64decode(text))
    arrays: dict[str, npt.NDArray[Any]] = {}
    for name, entry in header["arrays"].items():
        shape, offset = tuple(entry["shape"]), entry["offset"]
        size = int(np.prod(shape))
        assert offset % 8 == 0
        if entry["kind"] != "q2":
            arrays[name] = np.frombuffer(data, KINDS[entry["kind"]], size, offset).reshape(shape)
            continue
        low, high = np.frombuffer(data, np.uint8, 2 * size, offset).reshape(2, *shape).astype(np.int64)
        coded = low + 256 * high
        rests = np.where(coded % 2, -(coded + 1) // 2, coded // 2)
        levels = np.zeros(shape, dtype=np.int64)
        for frame in range(shape[1]):
            line = 0 if frame == 0 else levels[:, 0] if frame == 1 else 2 * levels[:, frame - 1] - levels[:, frame - 2]
            levels[:, frame] = (line + rests[:, frame]) % 2**16
        arrays[name] = (levels * np.array(header["step"]) + header["low"]).transpose(1, 0, 2, 3)
    return header, arrays


def made(**changes: Any) -> Animation:
    return Animation(**{**TRIANGLE, **changes})


# ---- packing


@pytest.mark.parametrize("frames", [1, 2, 3, 17])
@pytest.mark.parametrize("kind", ["smooth", "wild"])
def test_vertices_come_back_to_half_a_step(frames: int, kind: str) -> None:
    """Wild motion goes from end to end of the box, where the prediction wraps around."""
    rng = np.random.default_rng(frames)
    places = rng.normal(size=(frames, 3, 11, 3)) * [0.1, 3.0, 1e-4]
    if kind == "smooth":
        places = places[:1] + 0.01 * np.sin(np.arange(frames))[:, None, None, None]
    shown = made(users=["a", "b", "c"], time=np.arange(frames), vertices=places, triangles=None)
    header, arrays = unpacked(shown.page())
    extent = np.ptp(shown.vertices.reshape(-1, 3), axis=0)
    bound = 0.5 * extent / 65535 + 1e-6 * np.abs(shown.vertices).max(axis=(0, 1, 2))  # single precision of the input
    assert header["step"] == pytest.approx(extent / 65535, rel=1e-5)
    assert (np.abs(arrays["vertices"] - shown.vertices) <= bound).all()


def test_what_does_not_move_is_exact() -> None:
    _, arrays = unpacked(made(vertices=np.full((FRAMES, 2, 3, 3), 0.7)).page())
    assert np.array_equal(arrays["vertices"], np.full((FRAMES, 2, 3, 3), np.float32(0.7), dtype=np.float64))


def test_everything_else_comes_back() -> None:
    rng = np.random.default_rng(1)
    tracks = rng.normal(size=(4, FRAMES, 2, 3))
    values = rng.normal(size=(FRAMES, 2))
    values[3, 1] = np.nan
    shown = made(
        rest=np.ones((3, 3)),
        tools=ToolTracks(owner=[1, 0], centre=tracks[0], radius=[0.1, 0.2], force=tracks[1], tip=TIPS),
        ports=PortTracks(owner=[0, 0], place=tracks[2], force=tracks[3]),
        links=[(0, 1)],
        series=[UserSeries(name="Age", unit="s", values=values)],
    )
    header, arrays = unpacked(shown.page())
    assert (header["users"], header["links"]) == (["Ann", "Ben"], [[0, 1]])
    assert header["tools"] == {"owner": [1, 0], "radius": [0.1, 0.2], "axis": [[0.0] * 3] * 2, "tip": TIPS}
    assert header["ports"] == {"owner": [0, 0]}
    assert header["series"] == [{"name": "Force", "unit": "N"}, {"name": "Age", "unit": "s"}]
    assert np.array_equal(arrays["time"], TIME)
    assert arrays["triangles"].tolist() == [[0, 1, 2]]
    assert arrays["edges"].size == 0
    for name, given in zip(("tool_centre", "tool_force", "grip_place", "grip_force"), tracks, strict=True):
        assert np.array_equal(arrays[name], given.astype(np.float32))
    assert np.array_equal(arrays["series_0"], shown.felt().astype(np.float32))
    assert np.array_equal(arrays["series_1"], values.astype(np.float32), equal_nan=True)


def test_what_stands_around_is_told_as_the_page_has_it() -> None:
    shapes = [Plane(point=(0.0, 0.0, -0.1), normal=(0.0, 0.0, 1.0)), Box(size=(0.1, 0.2, 0.3), centre=(0.5, 0.0, 0.0))]
    header, _ = unpacked(made(shapes=shapes).page())
    assert header["obstacles"] == [
        {"kind": "plane", "point": [0.0, 0.0, -0.1], "normal": [0.0, 0.0, 1.0]},
        {"kind": "box", "size": [0.1, 0.2, 0.3], "centre": [0.5, 0.0, 0.0], "turn": [0.0, 0.0, 0.0]},
    ]
    with pytest.raises(BodyError, match="size"):
        made(shapes=[Box(size=(0.0, 0.2, 0.3), centre=(0.0, 0.0, 0.0))])


def test_peaks_by_hand() -> None:
    places = np.zeros((2, 2, 1, 3))
    places[1, 0, 0], places[1, 1, 0] = [0.3, 0.4, 0.0], [0.0, 0.0, 0.0]
    header, _ = unpacked(made(time=[0, 1], vertices=places, triangles=None, rest=[[0, 0, 0]]).page())
    assert header["peaks"] == pytest.approx({"displacement": 0.5, "difference": 0.25})


def test_smooth_motion_is_small() -> None:
    """Four to one at least; without the prediction it is not three to one."""
    rng = np.random.default_rng(0)
    rest, phase = rng.normal(size=(500, 3)), rng.random((500, 3))
    time = np.arange(240) / 60
    places = rest + 0.1 * np.sin(2 * np.pi * (time[:, None, None, None] + phase))
    shown = made(time=time, users=["a"], vertices=places, triangles=None)
    _, arrays = unpacked(shown.page())
    page = len(shown.page()) - len(made(time=[0.0], vertices=np.zeros((1, 2, 1, 3)), triangles=None).page())
    assert page < arrays["vertices"].size * 4 / 4


def test_the_same_animation_gives_the_same_page() -> None:
    """Also at another time of day, which gzip would write down."""
    page = made().page()
    assert page == made().page()
    text = re.findall(r'id="data">(.*?)</script>', page)[0]
    assert base64.b64decode(text)[4:8] == bytes(4)


def test_what_users_write_is_text() -> None:
    nasty = '</script><b>"$header&'
    page = made(title=nasty, users=[nasty, "Ben"]).page()
    assert page.count("</script>") == 3
    assert "<b>" not in without_script(page)
    assert unpacked(page)[0]["users"][0] == nasty


def without_script(page: str) -> str:
    """What the page says beside its program, which holds a library; a browser sees what that asks for."""
    return re.sub(r'<script type="module">.*?</script>', "", page, flags=re.DOTALL)


def test_the_page_asks_for_nothing() -> None:
    page = without_script(made().page())
    assert not re.search(r"https?:|//\w+\.\w+|@import|url\(|<link|<img|\bsrc=|\bimport\b\s*[({'\"]", page)
    assert "default-src 'none'" in page


def test_assets_are_in_the_package() -> None:
    viewer = files("cotouch.simulation").joinpath("_viewer")
    names = {entry.name for entry in viewer.iterdir()}
    assert {"index.html", "style.css", "animation.js"} <= names


# ---- what goes in


def test_a_skin_carries_the_displacement() -> None:
    body = body_from_surface(sphere(1), unit="m", resolution=2)
    skin = body.skin
    assert skin is not None
    moved = np.random.default_rng(0).normal(size=(FRAMES, 2, body.nodes, 3))
    shown = made(vertices=None, triangles=None, skin=skin, displacement=moved)
    assert np.array_equal(shown.triangles, skin.triangles)
    assert np.allclose(shown.rest, skin.vertices)
    assert np.allclose(shown.vertices[7, 1], skin.vertices + skin.carried(moved[7, 1]), atol=1e-6)


def test_a_user_feels_the_tools_less_what_the_hands_give() -> None:
    """3 N from a tool and 4 N across from another; the hand pulls with 1 N along, so is pulled back by as much."""
    track = np.zeros((FRAMES, 1, 3))
    along, across = np.array([1.0, 0.0, 0.0]), np.array([0.0, 1.0, 0.0])
    shown = made(
        tools=ToolTracks(
            owner=[1, 1],
            centre=np.zeros((FRAMES, 2, 3)),
            radius=0.01,
            force=np.concatenate([track + 3 * along, track + 4 * across], axis=1),
        ),
        ports=PortTracks(owner=[1], place=track, force=track + along),
    )
    assert shown.felt() == pytest.approx(np.array([[0.0, 20.0**0.5]] * FRAMES))


@pytest.mark.parametrize("axes", [1, 2])
def test_missing_axes_are_zero(axes: int) -> None:
    places = np.random.default_rng(0).normal(size=(FRAMES, 2, 4, axes))
    track = np.ones((FRAMES, 1, axes))
    shown = made(
        vertices=places,
        triangles=None,
        edges=[[0, 1]],
        rest=places[0, 0],
        tools=ToolTracks(owner=[0], centre=track, radius=0.1, force=track),
    )
    assert shown.vertices.shape == (FRAMES, 2, 4, 3)
    assert np.array_equal(shown.vertices[..., :axes], places.astype(np.float32))
    assert not shown.vertices[..., axes:].any()
    assert shown.rest.shape == (4, 3)
    assert shown.tools.force[0, 0].tolist() == [1.0] * axes + [0.0] * (3 - axes)


def test_nothing_given_can_be_changed_afterwards() -> None:
    places = np.zeros((FRAMES, 2, 3, 3), dtype=np.float32)
    shown = made(vertices=places)
    places[:] = 1.0
    assert not shown.vertices.any()
    with pytest.raises(ValueError, match="read-only"):
        shown.vertices[0] = 1.0


NO_NUMBER = np.where(np.arange(3)[:, None] == 1, np.nan, 0.0) * np.ones((FRAMES, 2, 1, 3))
SKIN = Skin(vertices=[[0, 0, 0]], triangles=[], nodes=[[2]], weights=[[1.0]])
TRACK = np.zeros((FRAMES, 1, 3))


def made_of(changes: dict[str, Any]) -> Animation:
    """With changes inside tools, grips and series too."""
    tool = {"owner": [0], "centre": TRACK, "radius": [0.1], "force": TRACK}
    grip = {"owner": [0], "place": TRACK, "force": TRACK}
    series = {"name": "Age", "unit": "s", "values": np.zeros((FRAMES, 2))}
    changes = dict(changes)
    if "tools" in changes:
        changes["tools"] = ToolTracks(**{**tool, **changes["tools"]})
    if "ports" in changes:
        changes["ports"] = PortTracks(**{**grip, **changes["ports"]})
    if "series" in changes:
        changes["series"] = [UserSeries(**{**series, **changes["series"]})]
    return made(**changes)


@pytest.mark.parametrize(
    ("changes", "error", "headers"),
    [
        ({"users": []}, NetworkError, "needs users"),
        ({"time": [0.0]}, BodyError, "vertices are 40 x 2 x 3 x 3; they must be 1 frames x 2 users"),
        ({"time": np.zeros(FRAMES)}, InputError, "frame 2 is at 0 s and the one before at 0 s"),
        ({"time": []}, InputError, "frame times are 0"),
        ({"time": ["soon"] * FRAMES}, InputError, "frame times are not an array of numbers"),
        ({"vertices": None}, BodyError, "exactly once"),
        ({"vertices": None, "skin": SKIN}, BodyError, "exactly once"),
        ({"skin": SKIN, "displacement": np.zeros((FRAMES, 2, 3, 3))}, BodyError, "exactly once"),
        (
            {"vertices": None, "skin": SKIN, "displacement": np.zeros((FRAMES, 2, 3, 3))},
            BodyError,
            "triangles, edges and rest come from the skin",
        ),
        (
            {"vertices": None, "triangles": None, "skin": SKIN, "displacement": np.zeros((FRAMES, 2, 2, 3))},
            BodyError,
            "node index 2",
        ),
        ({"vertices": np.zeros((FRAMES, 2, 3, 4))}, BodyError, "vertices are 40 x 2 x 3 x 4"),
        ({"vertices": np.zeros((FRAMES, 2, 0, 3))}, BodyError, "vertices are 40 x 2 x 0 x 3"),
        ({"vertices": NO_NUMBER}, BodyError, r"vertices are nan at index \[0, 0, 1, 0\]"),
        ({"triangles": [[0, 1, 3]]}, BodyError, "a triangle names vertex 3; this animation has vertices 0 to 2"),
        ({"triangles": [[0, -1, 2]]}, BodyError, "a triangle names vertex -1"),
        ({"triangles": [[0, 1]]}, BodyError, "triangles are 1 x 2; they must be rows of 3"),
        ({"triangles": [[0, 1, 1.5]]}, BodyError, "triangles must be whole numbers"),
        ({"edges": [[0, 1]]}, BodyError, "both triangles and edges"),
        ({"triangles": None, "edges": [[0, 7]]}, BodyError, "an edge names vertex 7"),
        ({"rest": np.zeros((2, 3))}, BodyError, "vertices at rest are 2 x 3; there are 3 vertices"),
        ({"links": [(0, 2)]}, NetworkError, "a link joins user indices 0 and 2"),
        ({"links": [(1, 1)]}, NetworkError, "a link joins user indices 1 and 1"),
        ({"tools": {"owner": [2]}}, InputError, "a tool belongs to user index 2; this animation has 0 to 1"),
        (
            {"tools": {"owner": [0, 1], "radius": 0.1}},
            InputError,
            "tool centres are 40 x 1 x 3; they must be frames x 2 x axes",
        ),
        ({"tools": {"owner": [0.5]}}, InputError, "tool owners must be whole numbers"),
        ({"tools": {"radius": [0.0]}}, InputError, "the radius of tool 1 is 0 m; it must be positive"),
        ({"tools": {"radius": [1.0, 1.0]}}, InputError, "tool radii are 2; there are 1 tools"),
        ({"tools": {"force": TRACK + np.inf}}, InputError, "tool forces are inf at index"),
        ({"tools": {"centre": TRACK[:3]}}, InputError, "tools have 3 frames; this animation has 40"),
        ({"ports": {"owner": [-1]}}, InputError, "a grip belongs to user index -1"),
        ({"ports": {"force": TRACK[:3]}}, InputError, "grips have 3 frames"),
        ({"series": {"name": " "}}, InputError, "a series has no name"),
        ({"series": {"values": [1.0]}}, InputError, "values of Age are 1; they must be frames x users"),
        ({"series": {"values": np.zeros((FRAMES, 3))}}, InputError, "they must be 40 frames x 2 users"),
    ],
)
def test_what_is_wrong_is_said(changes: dict[str, Any], error: type[InputError], headers: str) -> None:
    with pytest.raises(error, match=headers) as raised:
        made_of(changes)
    assert type(raised.value) is error
    assert "\n" not in str(raised.value)
    assert not str(raised.value).endswith(".")


# ---- the file


def test_it_is_written(tmp_path: Path) -> None:
    path = tmp_path / "run.html"
    assert made().write(path) == path
    assert path.read_bytes() == made().page().encode("utf-8")
    assert [entry.name for entry in tmp_path.iterdir()] == ["run.html"]


def test_a_full_disk_leaves_the_old_file(tmp_path: Path) -> None:
    path = tmp_path / "run.html"
    path.write_text("old")
    limits = resource.getrlimit(resource.RLIMIT_FSIZE)
    page = made()
    resource.setrlimit(resource.RLIMIT_FSIZE, (1000, limits[1]))
    try:
        with pytest.raises(OutputError, match=r"the animation cannot be written to .*run.html: File too large"):
            page.write(path)
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, limits)
    assert path.read_text() == "old"
    assert [entry.name for entry in tmp_path.iterdir()] == ["run.html"]


def test_no_such_folder(tmp_path: Path) -> None:
    with pytest.raises(OutputError, match="does not exist; create it first"):
        made().write(tmp_path / "none" / "run.html")
    with pytest.raises(OutputError, match=r'ends in "\.gif"; its name must end in \.html or \.htm'):
        made().write(tmp_path / "run.gif")


# ---- in a browser


def ball(tip: tuple[float, float, float] = (0.0, 0.0, 0.0)) -> Animation:
    """Ann's copy of a ball stays where it is, Ben's swells; both push with 1 to 3 N, Ann upwards, Ben to the right."""
    points, faces = sphere(3)
    points = 0.05 * points
    swelling = 0.02 * np.sin(np.pi * np.arange(FRAMES) / (FRAMES - 1))
    places = np.stack(
        [np.broadcast_to(points, (FRAMES, *points.shape)), points * (1 + swelling[:, None, None] / 0.05)], 1
    )
    force = np.linspace(1.0, 3.0, FRAMES)[:, None, None] * np.array([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0]])
    centre = np.broadcast_to([[0.0, 0.0, 0.09], [0.09, 0.0, 0.0]], (FRAMES, 2, 3))
    return Animation(
        title="A ball for two",
        users=["Ann", "Ben"],
        time=TIME,
        vertices=places,
        triangles=faces,
        rest=points,
        tools=ToolTracks(owner=[0, 1], centre=centre, radius=0.01, force=force, tip=[tip, [0.0, 0.0, 0.0]]),
        links=[(0, 1)],
        series=[UserSeries(name="Discrepancy", unit="m", values=np.stack([swelling, swelling], 1) / 2)],
    )


PEAK = FRAMES // 2  # the frame in which Ben's ball is large
LIVELY = {"reduced_motion": "no-preference"}
STILL = {"reduced_motion": "reduce"}


@pytest.fixture(scope="module")
def running() -> Generator[Browser]:
    with browser() as found:
        yield found


@pytest.fixture(scope="module")
def path(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return ball().write(tmp_path_factory.mktemp("page") / "ball.html")


@pytest.fixture
def still(running: Browser, path: Path) -> Generator[Opened]:
    opened = Opened(running, path, **STILL).ready()
    opened.page.evaluate(f"window.cotouch.seek({PEAK})")
    yield opened
    assert opened.complaints == []
    opened.page.context.close()


def middle(page: Page, picture: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
    """Mean colour of a small square in the middle of the balls."""
    x, y = (int(at) for at in page.evaluate("window.cotouch.seen([0, 0, 0])"))
    return picture[y - 6 : y + 6, x - 6 : x + 6].mean(axis=(0, 1))


def blue(colour: npt.NDArray[np.float64]) -> bool:
    return bool(colour[2] > colour[0] + 20.0 and colour[2] > colour[1] + 20.0)


def yellow(colour: npt.NDArray[np.float64]) -> bool:
    return bool(min(colour[0], colour[1]) > colour[2] + 80.0)


def darkness(picture: npt.NDArray[np.float64]) -> float:
    return float(255 - picture.mean(axis=2).min())


def test_it_plays_by_itself_and_asks_for_nothing(running: Browser, path: Path) -> None:
    opened = Opened(running, path, **LIVELY).ready()
    before = opened.picture()
    first = opened.state("frame")
    opened.page.wait_for_function("first => window.cotouch.state.frame !== first", arg=first)
    opened.page.evaluate(f"window.cotouch.seek({PEAK})")
    assert np.abs(opened.picture() - before).max() > 40
    assert opened.requests == [path.as_uri()]
    assert opened.complaints == []
    opened.page.context.close()


def test_it_stands_still_for_those_who_want_that(running: Browser, path: Path) -> None:
    opened = Opened(running, path, **STILL).ready()
    opened.picture()
    opened.picture()
    assert (opened.state("playing"), opened.state("frame")) == (False, 0)
    opened.page.context.close()


def test_copies_are_where_they_were_written(still: Opened, path: Path) -> None:
    _, arrays = unpacked(path.read_text())
    still.picture()
    for user in (0, 1):
        drawn = np.reshape(still.page.evaluate("user => window.cotouch.copy(user)", user), (-1, 3))
        assert np.abs(drawn - arrays["vertices"][PEAK, user]).max() < 1e-7
    still.page.evaluate("window.cotouch.seek(2.25)")
    still.picture()
    between = 0.75 * arrays["vertices"][2, 1] + 0.25 * arrays["vertices"][3, 1]
    drawn = np.reshape(still.page.evaluate("window.cotouch.copy(1)"), (-1, 3))
    assert np.abs(drawn - between).max() < 1e-7


def test_keys_scrub_and_play(still: Opened) -> None:
    keyboard = still.page.keyboard
    for key, frame in (
        ("ArrowRight", PEAK + 1),
        ("ArrowLeft", PEAK),
        ("Shift+ArrowLeft", PEAK - 10),
        ("End", FRAMES - 1),
    ):
        keyboard.press(key)
        still.until("frame", frame)
    keyboard.press("ArrowRight")
    still.until("frame", FRAMES - 1)
    keyboard.press("Home")
    still.until("frame", 0)
    assert still.page.locator("#chart").get_attribute("aria-valuemax") == str(FRAMES - 1)
    keyboard.press("ArrowDown")
    still.until("speed", 0.5)
    keyboard.press("Space")
    still.until("playing", True)
    still.page.wait_for_function("() => window.cotouch.state.frame > 0")
    keyboard.press("Space")
    still.until("playing", False)


def test_the_playhead_can_be_dragged(still: Opened) -> None:
    box = still.page.locator("#chart").bounding_box()
    assert box is not None
    still.page.mouse.move(box["x"] + box["width"] / 2, box["y"] + 30)
    still.page.mouse.down()
    still.page.mouse.move(box["x"] + box["width"] - 2, box["y"] + 30, steps=3)
    still.page.mouse.up()
    still.until("frame", FRAMES - 1)
    still.page.mouse.move(box["x"] + 50, box["y"] + 30)  # let go
    assert still.state("frame") == FRAMES - 1


def test_one_copy_alone(still: Opened) -> None:
    """Ann's ball is at rest, so blue; Ben's is displaced most of all, so yellow."""
    still.page.keyboard.press("a")
    still.until("view", "alone")
    picture = still.picture()
    ann = middle(still.page, picture)
    x, y = (int(at) for at in still.page.evaluate("window.cotouch.seen([0, 0, 0])"))
    across = picture[y, x - 50 : x + 10].mean(axis=1)
    assert np.abs(np.diff(across)).max() < 4  # smooth: no triangle is to be seen
    still.page.keyboard.press("2")
    still.until("user", 1)
    ben = middle(still.page, still.picture())
    assert blue(ann)
    assert yellow(ben)
    names = still.page.locator("#labels .name").all_inner_texts()
    assert names == ["Ben"]


def test_a_stylus_is_drawn_to_its_tip(running: Browser, tmp_path: Path) -> None:
    """In Ann's colour, which is blue."""
    seen: list[float] = []
    for name, tip in (("ball", (0.0, 0.0, 0.0)), ("stylus", (0.0, 0.09, 0.0))):
        opened = Opened(running, ball(tip).write(tmp_path / f"{name}.html"), **STILL).ready()
        opened.page.keyboard.press("a")
        opened.until("view", "alone")
        picture = opened.picture()
        x, y = (int(at) for at in opened.page.evaluate("window.cotouch.seen([0, 0.09, 0.09])"))
        red, _, blue_there = picture[y - 2 : y + 3, x - 2 : x + 3].mean(axis=(0, 1))
        seen.append(float(blue_there - red))
        assert opened.complaints == []
        opened.page.context.close()
    assert seen[0] < 20.0 < 60.0 < seen[1]


def test_side_by_side_shows_each_copy(still: Opened) -> None:
    still.page.get_by_role("button", name="Side by side").click()
    still.until("view", "side")
    picture = still.picture("#picture")
    force = np.linspace(1.0, 3.0, FRAMES)[PEAK]
    assert still.page.locator("#labels .tile").all_inner_texts() == [f"{name}{force:.2f} N" for name in ("Ann", "Ben")]
    ann, ben = np.array_split(picture, 2, axis=1)
    assert blue(middle(still.page, ann))
    assert yellow(middle(still.page, ben))
    still.page.keyboard.press("Space")  # plays, and does not press the button again
    still.until("playing", True)


def test_ghosts_show_where_copies_differ(still: Opened) -> None:
    def orange(picture: npt.NDArray[np.float64]) -> int:
        """Pixels of Ben's colour in the upper left, where his ball stands out of Ann's and neither tool is."""
        part = picture[: picture.shape[0] // 2, : picture.shape[1] // 2]
        return int(((part[..., 0] - part[..., 2]) > 45).sum())

    assert still.state("view") == "ghosts"
    apart = orange(still.picture("#picture"))
    still.page.keyboard.press("Home")
    still.until("frame", 0)
    together = orange(still.picture("#picture"))
    assert together < 30
    assert apart > 1000


def test_legend_and_table_say_what_is_seen(still: Opened) -> None:
    still.picture()
    page = still.page
    assert page.locator("#field").inner_text() == "Displacement / mm"
    assert page.locator("#ticks").inner_text().split() == ["0", "10", "20"]
    assert re.fullmatch(r"\d+ m?N", page.locator("#arrow").inner_text().strip())
    assert page.locator("#pitch").inner_text() == "grid 40 mm"
    force = np.linspace(1.0, 3.0, FRAMES)[PEAK]
    cells = page.locator("#users tbody tr").first.locator("td").all_inner_texts()
    assert (cells[0].strip(), cells[1]) == ("Ann", f"{force:.2f}")
    assert page.locator("#users thead").inner_text().split() == ["Force", "N", "Discrepancy", "mm"]
    assert page.locator("#network svg").get_attribute("aria-label") == "Ann and Ben"
    page.keyboard.press("c")
    still.until("field", "difference")
    still.picture()
    assert page.locator("#ticks").inner_text().split() == ["0", "5", "10"]


def test_arrows_point_where_forces_do(still: Opened) -> None:
    """Ann's arrow, in her blue, is above her tool, and longer at the end than at the start."""

    def arrow(frame: int) -> npt.NDArray[np.int64]:
        still.page.evaluate(f"window.cotouch.seek({frame})")
        picture = still.picture("#picture")
        rows, columns = np.nonzero((picture[..., 2] - picture[..., 0] > 70) & (picture[..., 2] > 90))
        return rows[np.abs(columns - np.median(columns)) < 40]

    start, end = arrow(0), arrow(FRAMES - 1)
    assert start.max() == pytest.approx(end.max(), abs=4)  # the tool stays
    assert end.min() < start.min() - 40


def test_the_arrow_on_a_rigid_tool_ends_where_it_comes_in(running: Browser, tmp_path: Path) -> None:
    """A hand within a ball presses it down: what began at the handle was hidden in the ball."""
    points, faces = sphere(2)
    points = 0.05 * points
    path = Animation(
        title="A ball pressed down",
        users=["Ann"],
        time=TIME,
        vertices=np.broadcast_to(points, (FRAMES, 1, *points.shape)),
        triangles=faces,
        rest=points,
        parts=[
            {
                "name": "ball",
                "vertices": points.shape[0],
                "colour": "#dddddd",
                "tool": {"slot": 0, "number": 0, "handle": [0.0, 0.0, 0.0]},
            }
        ],
        ports=PortTracks(owner=[0], place=np.zeros((FRAMES, 1, 3)), force=np.full((FRAMES, 1, 3), [0.0, 0.0, -2.0])),
    ).write(tmp_path / "pressed.html")
    opened = Opened(running, path, **STILL).ready()
    picture = opened.picture("#picture")
    rows, _ = np.nonzero((picture[..., 2] - picture[..., 0] > 70) & (picture[..., 2] > 90))
    top = opened.page.evaluate("window.cotouch.seen([0, 0, 0.05])")[1]
    assert rows.size > 50
    assert rows.min() < top - 20
    assert opened.complaints == []
    opened.page.context.close()


def test_turning_zooming_and_the_first_view_again(still: Opened) -> None:
    first = turned = still.picture("#picture")
    box = still.page.locator("#picture").bounding_box()
    assert box is not None
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    for dx, dy, keys in ((120, 0, []), (0, 40, []), (60, 0, ["Shift"])):
        before, name = turned, still.page.locator("#labels .name", has_text="Ann").bounding_box()
        still.page.mouse.move(x, y)
        for key in keys:
            still.page.keyboard.down(key)
        still.page.mouse.down()
        still.page.mouse.move(x + dx, y + dy, steps=3)
        still.page.mouse.up()
        for key in keys:
            still.page.keyboard.up(key)
        turned = still.picture("#picture")
        assert np.abs(turned - before).mean() > 0.5
    moved = still.page.locator("#labels .name", has_text="Ann").bounding_box()
    assert name is not None
    assert moved is not None
    # The last was a move: everything goes along, a little less or more as it is far or near.
    assert moved["x"] - name["x"] == pytest.approx(60, abs=8)
    assert moved["y"] == pytest.approx(name["y"], abs=1)
    still.page.mouse.wheel(0, 600)
    assert np.abs(still.picture("#picture") - turned).mean() > 0.5
    still.page.keyboard.press("r")
    assert np.abs(still.picture("#picture") - first).max() == 0


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_light_and_dark(running: Browser, path: Path, scheme: str) -> None:
    opened = Opened(running, path, color_scheme=scheme, **STILL).ready()
    corner = opened.picture()[:20, :20].mean()
    opened.page.get_by_role("button", name="Light or dark").click()
    other = opened.picture()[:20, :20].mean()
    assert (corner > 200, other > 200) == ((True, False) if scheme == "light" else (False, True))
    assert opened.complaints == []
    opened.page.context.close()


def test_keys_are_explained(still: Opened) -> None:
    still.page.keyboard.press("?")
    assert "play or pause" in still.page.locator("#help").inner_text()
    still.page.keyboard.press("Escape")
    assert still.page.locator("#help").is_hidden()


def test_it_fits_a_phone(running: Browser, path: Path) -> None:
    small = {"width": 390, "height": 844}
    opened = Opened(running, path, viewport=small, has_touch=True, is_mobile=True, **STILL).ready()
    assert opened.page.evaluate("document.documentElement.scrollWidth") == 390
    assert darkness(opened.picture("#picture")) > 60
    assert opened.complaints == []
    opened.page.context.close()


@pytest.mark.parametrize("edges", [[[0, 1], [1, 2], [2, 3]], []])
def test_nodes_without_a_surface(running: Browser, tmp_path: Path, edges: list[list[int]]) -> None:
    places = np.linspace(0, 0.3, 4)[:, None] + 0.02 * np.sin(8 * TIME)[:, None, None, None] * np.ones((1, 3, 1, 1))
    shown = Animation(title="A chain", users=["a", "b", "c"], time=TIME, vertices=places, edges=edges)
    opened = Opened(running, shown.write(tmp_path / "chain.html"), **STILL).ready()
    opened.page.evaluate("window.cotouch.seek(12)")
    picture = opened.picture("#picture")
    columns = int((picture.mean(axis=2) < 120).any(axis=0).sum())
    assert columns > (400 if edges else 40)  # nodes alone cover less than nodes and the lines between them
    assert edges or columns < 400
    opened.page.keyboard.press("s")
    opened.until("view", "side")
    opened.picture()
    assert opened.complaints == []
    opened.page.context.close()


def test_the_table_shows_no_force_where_there_is_none(running: Browser, tmp_path: Path) -> None:
    shown = made(series=[UserSeries(name="Age", unit="s", values=np.full((FRAMES, 2), 0.05))])
    opened = Opened(running, shown.write(tmp_path / "age.html"), **STILL).ready()
    opened.picture()
    assert opened.page.locator("#users thead").inner_text().split() == ["Age", "ms"]
    assert opened.page.locator("#users tbody td:nth-child(2)").all_inner_texts() == ["50.0", "50.0"]
    assert opened.page.locator("#arrow").is_hidden()
    assert opened.complaints == []
    opened.page.context.close()


@pytest.mark.parametrize(
    ("script", "headers"),
    [
        ("HTMLCanvasElement.prototype.getContext = () => null", "needs WebGL 2"),
        ("delete window.DecompressionStream", "too old"),
    ],
)
def test_a_browser_that_cannot_says_so(running: Browser, path: Path, script: str, headers: str) -> None:
    opened = Opened(running, path, script=script)
    opened.page.wait_for_selector("#notice.failed")
    assert headers in opened.page.locator("#notice").inner_text()
    assert opened.complaints == []
    opened.page.context.close()
