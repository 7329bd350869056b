"""Networks that several tests share."""

import functools

import numpy as np
from tests.network.inside import Mixing

from cotouch.network import Network, complete, connected_graphs, mixing

# Lee & Huang 2010, section IV.
SPRING = [
    [0, 60, 50, 40, 100],
    [60, 0, 25, 75, 100],
    [50, 25, 0, 50, 40],
    [40, 75, 50, 0, 75],
    [100, 100, 40, 75, 0],
]
DELAY = [
    [0, 0.1, 0.8, 0.8, 1.0],
    [0.05, 0, 0.05, 0.05, 0.8],
    [0.8, 0.04, 0, 0.05, 0.8],
    [0.8, 0.04, 0.05, 0, 0.05],
    [1.0, 0.8, 0.8, 0.04, 0],
]


def five_users() -> Network:
    """The network of the paper with every pair linked."""
    return Network(users=["1", "2", "3", "4", "5"], spring=SPRING, delay=DELAY)


GRAPHS = tuple(connected_graphs(five_users(), links=6))


@functools.cache
def mixings(convention, unit: float = 0.01, rounding="exact") -> tuple[Mixing, ...]:
    """Mixing of all of the paper's graphs."""
    return tuple(
        mixing(five_users().with_links(links), time_unit=unit, convention=convention, rounding=rounding)
        for links in GRAPHS
    )


def pairs(text: str) -> tuple[tuple[int, int], ...]:
    """Links from "12 23 34", users counted from 1."""
    return tuple((int(link[0]) - 1, int(link[1]) - 1) for link in text.split())


def uniform(links, size: int, *, spring: float = 1.0, delay: float = 1.0) -> Network:
    """Equal springs on the links, equal delays everywhere."""
    matrix = np.zeros((size, size))
    for i, j in links:
        matrix[i, j] = matrix[j, i] = spring
    return Network(users=[f"u{i}" for i in range(size)], spring=matrix, delay=delay * (1 - np.eye(size)))


def random_network(rng: np.random.Generator, *, size: int | None = None, delays=(0.0, 1.0)) -> Network:
    """A connected network with random springs, delays and links."""
    size = size or int(rng.integers(2, 7))
    strength = np.triu(rng.uniform(0.2, 3.0, (size, size)), 1)
    delay = rng.uniform(*delays, (size, size)) * (1 - np.eye(size))
    network = Network(users=[f"u{i}" for i in range(size)], spring=strength + strength.T, delay=delay)
    while True:
        chosen = network.with_links([link for link in complete(size) if rng.random() < 0.6])
        if chosen.is_connected():
            return chosen
