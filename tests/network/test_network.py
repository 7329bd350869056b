"""Networks: what they compute, and what they refuse."""

from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.network.support import DELAY, SPRING, five_users, pairs, uniform

from cotouch.errors import NetworkError
from cotouch.network import Network, complete, connected_graphs, path, ring, star

SPD = np.array([[2.0, 0.5], [0.5, 1.0]])


def build(**changes):
    arguments = {"users": ["Ann", "Bo", "Cy"], "spring": 5.0 * (1 - np.eye(3)), "delay": 0.1 * (1 - np.eye(3))}
    return Network(**(arguments | changes))


def with_entry(value, *entries, scale=1.0):
    matrix = scale * (1 - np.eye(3))
    for i, j in entries:
        matrix[i, j] = value
    return matrix


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"users": []}, ["users is empty", "at least one"]),
        ({"users": "Ann"}, ["users", "list of names"]),
        ({"users": ["Ann", "Bo", "Ann"]}, ['"Ann"', "user 1", "user 3", "different"]),
        ({"users": ["Ann", " ", "Cy"]}, ["user 2", "non-empty"]),
        ({"spring": with_entry(7.0, (0, 1))}, ['user 1 ("Ann")', 'user 2 ("Bo")', "1 N/m", "7 N/m", "equal"]),
        ({"spring": with_entry(-2.0, (0, 2), (2, 0))}, ["user 1", "user 3", "-2 N/m", "at least 0"]),
        ({"spring": with_entry(np.nan, (1, 2), (2, 1))}, ["user 2", "user 3", "nan", "finite"]),
        ({"spring": with_entry(np.inf, (1, 2), (2, 1))}, ["inf", "finite"]),
        ({"spring": with_entry(3.0, (1, 1))}, ["user 2", "itself", "diagonal"]),
        ({"spring": np.ones((2, 2))}, ["spring is 2 x 2", "3 x 3"]),
        ({"spring": [[1, 2], [3]]}, ["spring", "numbers"]),
        ({"delay": with_entry(-0.5, (2, 0))}, ["from user 1", "to user 3", "-0.5 s"]),
        ({"delay": with_entry(np.nan, (2, 0))}, ["from user 1", "nan"]),
        ({"delay": with_entry(np.inf, (2, 0))}, ["from user 1", "inf"]),
        ({"delay": with_entry(1.0, (2, 2))}, ["user 3", "itself", "diagonal"]),
        ({"delay": np.ones(3)}, ["delay is 3", "3 x 3"]),
        ({"links": [(0, 1), (1, 0)]}, ["user 1", "user 2", "twice"]),
        ({"links": [(1, 1)]}, ["user 2", "itself"]),
        ({"links": [(0, 3)]}, ["(0, 3)", "index 3", "indices 0 to 2", "files number 1 to 3"]),
        ({"links": [(-1, 1)]}, ["(-1, 1)", "index -1", "indices 0 to 2"]),
        ({"links": [(0, 1, 2)]}, ["not a link", "pair"]),
        ({"links": [(0, 0.5)]}, ["not a link"]),
        ({"links": [(0, 1)], "spring": with_entry(0.0, (0, 1), (1, 0))}, ["user 1", "user 2", "0 N/m"]),
        ({"weight": [[1.0, 2.0], [2.0, 1.0]]}, ["weight", "eigenvalue is -1", "above 0"]),
        ({"weight": [[1.0, 2.0], [0.0, 1.0]]}, ["weight", "[0, 1]", "equal"]),
        ({"weight": [1.0, 2.0]}, ["weight is 2", "square"]),
        ({"weight": [[np.nan]]}, ["weight", "finite"]),
    ],
)
def test_refuses_with_a_sentence_that_helps(changes, words):
    with pytest.raises(NetworkError) as caught:
        build(**changes)
    for word in words:
        assert word in str(caught.value)


@pytest.mark.parametrize(
    ("block", "words"),
    [
        (np.diag([1.0, -1.0]), ["user 1", "user 2", "eigenvalue is -1"]),
        (np.full((2, 2), np.nan), ["user 1", "finite"]),
        (np.array([[1.0, 0.2], [0.1, 1.0]]), ["user 1", "[0, 1]"]),
    ],
)
def test_refuses_wrong_matrix_springs(block, words):
    spring = np.zeros((2, 2, 2, 2))
    spring[0, 1] = spring[1, 0] = block
    with pytest.raises(NetworkError) as caught:
        Network(users=["a", "b"], spring=spring, delay=np.zeros((2, 2)))
    for word in words:
        assert word in str(caught.value)


def test_refuses_matrix_springs_that_differ_by_direction():
    spring = np.zeros((2, 2, 2, 2))
    spring[0, 1], spring[1, 0] = SPD, 2 * SPD
    with pytest.raises(NetworkError, match=r"2 N/m one way and 4 N/m the other"):
        Network(users=["a", "b"], spring=spring, delay=np.zeros((2, 2)))
    with pytest.raises(NetworkError, match="together with"):
        Network(users=["a", "b"], spring=spring, delay=np.zeros((2, 2)), weight=SPD)


def test_matrix_springs_are_stored_as_strengths_and_distinct_weights():
    spring = np.zeros((4, 4, 2, 2))
    for (i, j), block in {(0, 1): 3 * SPD, (1, 2): 7 * SPD, (2, 3): 2 * np.eye(2), (0, 3): np.diag([1.0, 3])}.items():
        spring[i, j] = spring[j, i] = block
    network = Network(users=list("abcd"), spring=spring, delay=np.zeros((4, 4)))
    assert len(network.weights) == 2
    assert network.weight_of[2, 3] == -1
    assert network.weight_of[0, 1] == network.weight_of[2, 1] != network.weight_of[0, 3]
    assert network.links == ((0, 1), (0, 3), (1, 2), (2, 3))
    for i, j in network.links:
        np.testing.assert_allclose(
            network.link_matrix(i, j) * np.eye(2) if (i, j) == (2, 3) else network.link_matrix(i, j), spring[i, j]
        )
    np.testing.assert_allclose(network.stiffness_matrix(2).toarray(), dense_stiffness(network, spring), atol=1e-14)
    again = network.replace(spring=network.spring * 2)
    np.testing.assert_allclose(again.stiffness_matrix(2).toarray(), 2 * dense_stiffness(network, spring), atol=1e-13)
    with pytest.raises(NetworkError, match="2 weights to choose from"):
        network.replace(spring=np.ones((4, 4)) - np.eye(4))


def dense_stiffness(network, spring):
    """P of (5), written down as the paper prints it."""
    size, rows = network.size, spring.shape[2]
    matrix = np.zeros((size, rows, size, rows))
    for i in range(size):
        for j in network.neighbours(i):
            matrix[i, :, i] += spring[i, j]
            matrix[i, :, j] -= spring[i, j]
    return matrix.reshape(size * rows, size * rows)


@pytest.mark.parametrize("rows", [1, 2, 3])
def test_stiffness_matrix_of_scalar_springs(rows):
    network = five_users().with_links(pairs("12 14 23 24 34 45"))
    blocks = np.array(SPRING)[:, :, None, None] * np.eye(rows)
    np.testing.assert_array_equal(network.stiffness_matrix(rows).toarray(), dense_stiffness(network, blocks))


def test_stiffness_matrix_with_a_common_weight():
    network = build(weight=SPD)
    np.testing.assert_allclose(
        network.stiffness_matrix(2).toarray(), np.kron(build().stiffness_matrix().toarray(), SPD)
    )
    assert network.weight_rows == 2
    np.testing.assert_allclose(network.link_matrix(0, 1), 5 * SPD)
    for rows in (0, 3):
        with pytest.raises(NetworkError, match="rows is"):
            network.stiffness_matrix(rows)
    assert build(weight=np.eye(2)).weights == ()


@pytest.mark.parametrize("n", [3, 4, 7])
def test_laplacian_spectra(n):
    k = np.arange(n)
    spectra = {
        complete: np.r_[0.0, np.full(n - 1, float(n))],
        ring: 2 - 2 * np.cos(2 * np.pi * k / n),
        path: 2 - 2 * np.cos(np.pi * k / n),
        star: np.r_[0.0, np.ones(n - 2), float(n)],
    }
    for shape, spectrum in spectra.items():
        network = uniform(shape(n), n, spring=3.0)
        np.testing.assert_allclose(np.linalg.eigvalsh(network.laplacian()), np.sort(spectrum), atol=1e-12)
        stiffness = network.stiffness_matrix().toarray()
        np.testing.assert_allclose(np.linalg.eigvalsh(stiffness), 3 * np.sort(spectrum), atol=1e-12)


def test_neighbours_and_groups():
    network = five_users().with_links(pairs("21 54"))
    assert network.links == ((0, 1), (3, 4))
    assert network.neighbours(3) == (4,)
    assert network.neighbours(2) == ()
    assert network.components() == ((0, 1), (2,), (3, 4))
    assert not network.is_connected()
    assert five_users().is_connected()
    assert len(five_users().links) == 10
    assert network.link_matrix(0, 1) == 60.0
    assert network.link_matrix(0, 2) == 0.0


@given(st.integers(1, 7), st.data())
def test_groups_agree_with_the_null_space(n, data):
    every = complete(n)
    links = data.draw(st.lists(st.sampled_from(every), unique=True)) if every else []
    network = uniform(every, n).with_links(links)
    assert len(network.components()) == int((np.linalg.eigvalsh(network.laplacian()) < 1e-9).sum())


def test_index_delays_round_up_to_at_least_one():
    network = five_users().with_links(pairs("12 23"))
    steps = network.index_delays(0.01)
    assert steps[0, 1] == 10
    assert steps[1, 0] == steps[1, 2] == 5
    assert steps[2, 1] == 4
    assert steps[0, 2] == steps[3, 4] == 0
    assert network.index_delays(0.03)[0, 1] == 4
    assert uniform(path(2), 2, delay=0.0).index_delays(0.1)[0, 1] == 1
    with pytest.raises(NetworkError, match="period is 0 s"):
        network.index_delays(0.0)


def test_arrays_are_read_only_and_input_is_copied():
    spring = 5.0 * (1 - np.eye(3))
    network = build(spring=spring)
    spring[0, 1] = 9.0
    assert network.spring[0, 1] == 5.0
    for array in (network.spring, network.delay, network.weight_of, build(weight=SPD).weights[0]):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 1


def test_replace():
    network = build(links=[(0, 1), (1, 2)], weight=SPD)
    changed = network.replace(users=["x", "y", "z"], spring=2 * network.spring, delay=np.zeros((3, 3)))
    assert changed.users == ("x", "y", "z")
    assert changed.links == network.links
    np.testing.assert_allclose(changed.link_matrix(0, 1), 10 * SPD)
    assert not changed.delay.any()
    assert network.delay[0, 1] == 0.1
    with pytest.raises(NetworkError, match="2 names"):
        network.replace(users=["x", "y"])
    with pytest.raises(NetworkError, match="0 N/m"):
        network.replace(spring=np.zeros((3, 3)))


def toml(tmp_path: Path, text: str) -> Path:
    file = tmp_path / "net.toml"
    file.write_text(text, encoding="utf-8")
    return file


HEAD = 'users = ["1", "2"]\nspring = [[0, 4.0], [4.0, 0]]\n'
GOOD = f"[network]\n{HEAD}delay = [[0, 0.1], [0.2, 0]]\n"


def test_reads_a_file_and_leaves_other_tables_alone(tmp_path):
    network = Network.read(toml(tmp_path, GOOD + "links = [[2, 1]]\nweight = [[2.0]]\n[body]\nmass = 1.0\n"))
    assert network.links == ((0, 1),)
    assert network.delay[1, 0] == 0.2
    assert network.link_matrix(0, 1) == np.array([[8.0]])


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("[network", ["not TOML"]),
        ("[body]\nmass = 1\n", ["no table [network]", "users, spring, delay"]),
        ("network = 3\n", ["no table [network]"]),
        (f"[network]\n{HEAD}", ['lacks the key "delay"']),
        (GOOD + "colour = 3\n", ['no key "colour"', "links"]),
        (GOOD + "links = [[1, 2, 3]]\n", ["[1, 2, 3]", "pair"]),
        (GOOD + "links = [[1.0, 2]]\n", ["pair"]),
        (GOOD + "links = 3\n", ["links is 3", "list of pairs"]),
        (GOOD + "links = [[0, 1]]\n", ["user 0", "1 to 2"]),
        (GOOD + "links = [[1, 2], [2, 1]]\n", ["user 1 and user 2", "twice"]),
        (GOOD.replace("4.0], [4.0", "4.0], [5.0"), ["user 1 and user 2", "4 N/m", "5 N/m"]),
        (GOOD.replace('["1", "2"]', "2"), ["users is 2"]),
        (GOOD.replace('["1", "2"]', "[1, 2]"), ["user 1 is 1", "non-empty string"]),
    ],
)
def test_refuses_a_file_by_name_and_key(tmp_path, text, words):
    file = toml(tmp_path, text)
    with pytest.raises(NetworkError) as caught:
        Network.read(file)
    for word in [str(file), *words]:
        assert word in str(caught.value)


def test_refuses_missing_and_binary_files(tmp_path):
    with pytest.raises(NetworkError, match="cannot be read: No such file"):
        Network.read(tmp_path / "none.toml")
    with pytest.raises(NetworkError, match="cannot be read"):
        Network.read(tmp_path)
    (tmp_path / "b.toml").write_bytes(b"\xff\xfe\x00")
    with pytest.raises(NetworkError, match="UTF-8"):
        Network.read(tmp_path / "b.toml")


def test_connected_graphs_of_the_paper():
    graphs = list(connected_graphs(five_users(), links=6))
    assert len(graphs) == len(set(graphs)) == 205
    assert graphs == sorted(graphs)
    assert all(five_users().with_links(graph).is_connected() for graph in graphs)


@pytest.mark.parametrize("n", [2, 3, 4, 5, 6])
def test_cayley_counts_the_trees(n):
    assert sum(1 for _ in connected_graphs(uniform(complete(n), n), links=n - 1)) == n ** (n - 2)


def test_connected_graphs_refuses_the_impossible():
    with pytest.raises(NetworkError, match=r"links is 3; .* must be 4 to 10"):
        connected_graphs(five_users(), links=3)
    with pytest.raises(NetworkError, match="4 to 10"):
        connected_graphs(five_users(), links=11)
    with pytest.raises(NetworkError, match="separate groups"):
        connected_graphs(uniform([(0, 1)], 3), links=2)
    with pytest.raises(NetworkError, match="at least 3"):
        ring(2)


def test_paper_data_are_transcribed():
    assert np.array_equal(SPRING, np.transpose(SPRING))
    assert np.sum(SPRING) == 1230
    assert np.sum(DELAY) == pytest.approx(8.92)
