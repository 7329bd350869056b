import numpy as np
import pytest
from matplotlib.figure import Figure
from scipy.stats import spearmanr

from cotouch.drawing import drawn
from cotouch.errors import NetworkError
from cotouch.network import Network, complete, path
from cotouch.planning import knee, networks, ranks


def community(users: int, seed: int = 1) -> Network:
    rng = np.random.default_rng(seed)
    spring = np.triu(rng.integers(20, 100, (users, users)), 1).astype(np.float64)
    delay = 0.01 * rng.integers(2, 41, (users, users))
    np.fill_diagonal(delay, 0.0)
    return Network(users=[f"u{i}" for i in range(users)], spring=spring + spring.T, delay=delay)


def texts(figure: Figure, panel: int = 0) -> list[str]:
    return [text.get_text() for text in figure.axes[panel].texts]


def test_every_link_says_its_strength_and_both_delays():
    network = community(5)
    figure = networks([("all", network), ("path", network.with_links(path(5)))])
    for panel, links in enumerate((complete(5), path(5))):
        expected = [*network.users]
        for a, b in links:
            expected += [f"{network.spring[a, b]:.0f}", f"{1e3 * network.delay[a, b]:.0f}"]
            expected += [f"{1e3 * network.delay[b, a]:.0f}"]
        assert sorted(texts(figure, panel)) == sorted(expected)


def test_what_arrives_is_written_nearer_to_its_end():
    network = Network(users=["1", "2"], spring=[[0, 50], [50, 0]], delay=[[0, 0.1], [0.3, 0]])
    panel = networks([("pair", network)]).axes[0]
    place = {text.get_text(): np.array(text.xy) for text in panel.texts}
    assert np.linalg.norm(place["100"] - place["1"]) < np.linalg.norm(place["100"] - place["2"])
    assert np.linalg.norm(place["300"] - place["2"]) < np.linalg.norm(place["300"] - place["1"])


def test_a_stronger_link_is_wider():
    network = Network(users=list("abc"), spring=[[0, 20, 0], [20, 0, 90], [0, 90, 0]], delay=np.zeros((3, 3)))
    lines = [line for line in networks([("", network)]).axes[0].get_lines() if len(line.get_xydata()) == 2]
    assert lines[0].get_linewidth() < lines[1].get_linewidth()


def test_beyond_ten_users_a_link_has_one_label_and_is_thin():
    network = community(30)
    ring = network.with_links([(i, i + 1) for i in range(29)])
    figure = networks([("ring", ring)])
    said = texts(figure)
    assert len(said) <= 30 + 29
    trips = {f"{1e3 * (network.delay[a, b] + network.delay[b, a]):.3g}" for a, b in ring.links}
    assert set(said) - set(ring.users) <= trips
    lines = [line for line in figure.axes[0].get_lines() if len(line.get_xydata()) == 2]
    assert max(line.get_linewidth() for line in lines) < 1.5


def test_a_name_that_the_font_cannot_write_gives_way_to_the_number(recwarn):
    three = Network(users=["Zürich", "東京", "Rīga"], spring=9.0 * (1 - np.eye(3)), delay=0.1 * (1 - np.eye(3)))
    figure = networks([("", three)])
    assert {"Zürich", "user 2", "Rīga"} <= set(texts(figure))
    drawn(figure, dpi=50)
    assert not [warning for warning in recwarn if "Glyph" in str(warning.message)]


def test_beyond_forty_links_colour_says_it_alone():
    network = community(30)
    around = [(i, i + step) for step in (1, 2) for i in range(30 - step)]
    figure = networks([("two rings", network.with_links(around))])
    assert set(texts(figure)) <= set(network.users)
    assert "Small" not in figure.get_supxlabel()
    assert figure.axes[1].get_xlabel().startswith("Round trip")


def test_the_knee_shows_every_point_whole_and_its_label_covers_none():
    rates, costs = ("Decay / (1/s)", [1.0, 5.0, 4.0, 4.9]), ("Largest damping / (Ns/m)", [30.0, 90.0, 80.0, 85.0])
    figure = knee([4, 5, 6, 7], rates, costs, chosen=6)
    for panel, values in zip(figure.axes, ([1.0, 5.0, 4.0, 4.9], [30.0, 90.0, 80.0, 85.0]), strict=True):
        low, high = panel.get_ylim()
        assert low == 0.0
        assert high >= 1.1 * max(values)
        (label,) = panel.texts
        assert label.get_position()[1] > 0.0, "above its point"
    rising = knee([4, 5], ("Decay / (1/s)", [-0.5, 1.0]), ("Drag / (Ns/m)", [3.0, 4.0]))
    assert rising.axes[0].get_ylim()[0] < -0.5, "a choice that rises is seen"


def test_the_knee_shows_the_objective_and_what_is_proved():
    """A share near 1 has room of its own; what has a unit begins at 0."""
    shares, costs = [0.991, 0.97, 0.972], [30.0, 90.0, 80.0]
    figure = knee(
        [4, 5, 6],
        ("Second largest |eigenvalue|", shares),
        ("Largest damping / (Ns/m)", costs),
        chosen=5,
        bend=5,
        proved=[True, False, True],
    )
    first, second = figure.axes[:2]
    assert [panel.get_ylabel() for panel in (first, second)] == [
        "Second largest |eigenvalue|",
        "Largest damping / (Ns/m)",
    ]
    assert first.get_ylim()[0] > 0.9
    assert second.get_ylim()[0] == 0.0
    open_marks = [line for line in first.get_lines() if line.get_markerfacecolor() == "#ffffff"]
    assert [line.get_xdata().tolist() for line in open_marks] == [[5.0]]
    assert figure.get_supxlabel() == "The line is at the knee, 5 links. Open marks: best found, not proved."


def test_springs_that_are_all_alike_are_said_once():
    network = community(5).replace(spring=50.0 * (1 - np.eye(5)))
    figure = networks([("all", network)])
    assert "50" not in texts(figure)
    assert "All springs 50 N/m" in figure.get_supxlabel()


def test_ranks_say_spearmans_rho():
    rng = np.random.default_rng(3)
    first, second = rng.normal(size=(2, 40))
    first[:5] = np.inf
    title = ranks(("One", first), ("Two / s", second)).axes[0].get_title(loc="left")
    assert f"{spearmanr(first, second).statistic:.2f}" in title


def test_knee_marks_the_chosen_number():
    rates, costs = ("Decay / (1/s)", [2.0, 1.0, 2.1]), ("Largest damping / (Ns/m)", [20.0, 10.0, 40.0])
    figure = knee([5, 4, 6], rates, costs, chosen=5)
    assert [figure.axes[k].texts[0].get_text() for k in (0, 1)] == ["2 1/s", "20 Ns/m"]
    np.testing.assert_array_equal(figure.axes[0].get_lines()[0].get_ydata(), [1.0, 2.0, 2.1])


def test_what_cannot_be_drawn_is_said():
    with pytest.raises(NetworkError, match="cases is empty"):
        networks([])
    with pytest.raises(NetworkError, match="One has 2 values and Two has 3"):
        ranks(("One", [1, 2]), ("Two", [1, 2, 3]))
    one, two = ("Decay / (1/s)", [1.0]), ("Drag / (Ns/m)", [1.0, 2.0])
    with pytest.raises(NetworkError, match="2, 1, 2 and 2 entries"):
        knee([1, 2], one, two)
    for name in ("chosen", "bend"):
        with pytest.raises(NetworkError, match=f"{name} is 9"):
            knee([1, 2], two, two, **{name: 9})
