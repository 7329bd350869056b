"""Networks and plans that several tests share."""

import numpy as np
from tests.network.support import five_users, pairs

from cotouch.network import Network

__all__ = ["five_users", "pairs", "small_network"]

GRID = 0.05


def small_network(rng: np.random.Generator) -> tuple[Network, int]:
    """4 to 6 users, most pairs with a spring, delays in whole steps of `GRID`; and a number of links that fits."""
    size = int(rng.integers(4, 7))
    while True:
        spring = np.triu(rng.uniform(10, 100, (size, size)) * (rng.random((size, size)) < 0.8), 1)
        delay = GRID * rng.integers(1, 12, (size, size)) * (1 - np.eye(size))
        network = Network(users=[f"u{i}" for i in range(size)], spring=spring + spring.T, delay=delay)
        if network.is_connected():
            most = len(network.links)
            return network, int(rng.integers(size - 1, min(size + 1, most) + 1))
