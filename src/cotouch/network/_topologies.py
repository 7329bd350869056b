"""Choices of links: every connected one with a given number of links, and the usual shapes."""

from collections.abc import Iterator
from itertools import combinations

from cotouch.errors import NetworkError
from cotouch.network._network import Network
from cotouch.network._types import Pair


def connected_graphs(network: Network, *, links: int) -> Iterator[tuple[Pair, ...]]:
    """Every connected choice of `links` links among the pairs that have a spring.

    The links that `network` has now do not matter. The order is lexicographic, so it never changes.

    Args:
        network: gives the users and the pairs that can be linked.
        links: how many links each choice has.

    Yields:
        Pairs of user indices, sorted; hand them to `Network.with_links`.

    Raises:
        NetworkError: no connected choice exists with this number of links.
    """
    possible = network.with_links(None)
    most, least = len(possible.links), network.size - 1
    if not possible.is_connected():
        raise NetworkError(
            "spring leaves the users in separate groups, whichever links are chosen; give more pairs a spring above 0"
        )
    if not least <= links <= most:
        raise NetworkError(
            f"links is {links}; to connect {network.size} users with {most} possible links it must be {least} to {most}"
        )
    return (choice for choice in combinations(possible.links, links) if _connects(choice, network.size))


def _connects(choice: tuple[Pair, ...], size: int) -> bool:
    group = list(range(size))
    groups = size
    for i, j in choice:
        a, b = group[i], group[j]
        if a != b:
            group = [a if g == b else g for g in group]
            groups -= 1
    return groups == 1


def complete(size: int) -> tuple[Pair, ...]:
    """Links of the complete graph of `size` users."""
    return tuple(combinations(range(size), 2))


def path(size: int) -> tuple[Pair, ...]:
    """Links of the path 1-2-...-N."""
    return tuple((i, i + 1) for i in range(size - 1))


def ring(size: int) -> tuple[Pair, ...]:
    """Links of the ring of `size` users.

    Raises:
        NetworkError: fewer than 3 users make no ring.
    """
    if size < 3:
        raise NetworkError(f"size is {size}; a ring has at least 3 users")
    return tuple(sorted([*path(size), (0, size - 1)]))


def star(size: int) -> tuple[Pair, ...]:
    """Links of the star with the first user in the middle."""
    return tuple((0, i) for i in range(1, size))
