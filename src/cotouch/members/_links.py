"""Who is linked to whom among those who are there."""

from collections.abc import Iterable

import numpy as np

from cotouch.arrays import Float
from cotouch.network import Network, Pair


def present_links(network: Network, members: Iterable[int]) -> list[Pair]:
    """The given links among those present; if these fall into parts, the stiffest springs join them.

    Args:
        network: of the session.
        members: indices of the users who are there.
    """
    there = sorted(set(members))
    links = [(a, b) for a, b in network.links if a in there and b in there]
    piece = {user: user for user in there}

    def root(user: int) -> int:
        while piece[user] != user:
            user = piece[user]
        return user

    for a, b in links:
        piece[root(a)] = root(b)
    possible = [(a, b) for a in there for b in there if a < b and network.spring[a, b] > 0.0]
    for a, b in sorted(possible, key=lambda pair: (-float(network.spring[pair]), pair)):
        if root(a) != root(b):
            piece[root(a)] = root(b)
            links.append((a, b))
    return sorted(links)


def delays_of(network: Network, sums: dict[Pair, float]) -> Float:
    """Delays for the planner from measured round trips, half for each direction.

    Only the sum is known without common clocks, and only the sum decides the damping. Pairs that nobody measured keep
    the delays of the session's file.

    Args:
        network: of the session.
        sums: time there and back of pairs, the smaller index first [s].
    """
    delay = np.array(network.delay)
    for (a, b), both in sums.items():
        delay[a, b] = delay[b, a] = 0.5 * max(both, 0.0)
    return delay
