"""A network as the table of a file, and back."""

import numpy as np
import pytest

from cotouch.network import Network

SPRING = [[0, 50, 20], [50, 0, 0], [20, 0, 0]]
DELAY = [[0, 0.1, 0.2], [0.3, 0, 0.4], [0.5, 0.6, 0]]
USERS = ["Ann", "Ben", "Cleo"]
SQUARE = [[2.0, 0.5], [0.5, 1.0]]


@pytest.mark.parametrize(
    "network",
    [
        Network(users=USERS, spring=SPRING, delay=DELAY, links=[(0, 2)]),
        Network(users=USERS, spring=SPRING, delay=DELAY, weight=SQUARE),
        Network(
            users=USERS[:2],
            spring=np.array([[np.zeros((2, 2)), SQUARE], [SQUARE, np.zeros((2, 2))]]),
            delay=[[0, 0.1], [0.2, 0]],
        ),
        Network(
            users=USERS,
            spring=np.array(
                [
                    [s * (np.eye(2) if i + j == 2 else np.array(SQUARE)) for j, s in enumerate(row)]
                    for i, row in enumerate(SPRING)
                ]
            ),
            delay=DELAY,
        ),
    ],
    ids=["scalars", "one weight", "one matrix", "a matrix for each"],
)
def test_a_network_is_its_table(network: Network) -> None:
    again = Network.from_table(network.as_table())
    assert again.users == network.users
    assert again.links == network.links
    assert np.array_equal(again.delay, network.delay)
    for i, j in network.links:
        assert again.link_matrix(i, j) == pytest.approx(network.link_matrix(i, j), rel=1e-14)


def test_users_are_numbered_from_1_in_tables() -> None:
    assert Network(users=USERS, spring=SPRING, delay=DELAY, links=[(0, 2)]).as_table()["links"] == [[1, 3]]
