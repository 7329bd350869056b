"""When the nodes of a body lose their last element, and are no longer part of it."""

import numpy as np

from cotouch.arrays import Float
from cotouch.body._body import Body


def cut_away(body: Body, when: Float) -> Float:
    """When each node loses its last element.

    Args:
        body: that is cut.
        when: each element is, infinite where it stays; through all bodies that can be cut, (elements,).

    Returns:
        Likewise, (nodes,); infinite where a node keeps an element.
    """
    last, first = np.full(body.nodes, -np.inf), 0
    for own, node in [(part.body, part.first) for part in body.parts] or [(body, 0)]:
        if own.cut_count and own.material is not None:
            if not own.material.faces.size:  # faces open, and every element stays
                np.maximum.at(last, own.material.elements + node, when[first : first + own.cut_count, None])
            first += own.cut_count
    last[last == -np.inf] = np.inf
    return last
