"""What a page sees of a hand, in the mailbox of its member's process."""

from collections.abc import Sequence

from cotouch.arrays import Array
from cotouch.observers import HAND_MODES, HandMode


def write_hand(
    fields: dict[str, Array],
    k: int,
    mode: HandMode,
    node: int,
    target: Sequence[float],
    place: Sequence[float],
    force: Sequence[float],
    radius: float = 0.0,
    *,
    edge: Sequence[float] = (),
) -> None:
    """Writes one hand into a mailbox; axes that the body lacks are 0.

    Args:
        fields: see `view_fields`.
        k: which hand, from 0.
        mode: see `HandMode`.
        node: that it holds, from 0; -1: none.
        target: where the hand is; empty: at the place [m].
        place: of what it holds or pushes with [m].
        force: of the hand on the object; empty: none [N].
        radius: of the ball that pushes; 0: it holds [m].
        edge: of a blade, from its place to the other end, or of a stylus to its round tip; empty: it has none [m].
    """
    fields["mode"][k] = HAND_MODES.index(mode)
    fields["node"][k] = node
    fields["radius"][k] = radius
    for name, value in (("target", target or place), ("place", place), ("force", force), ("edge", edge)):
        fields[name][k] = (*value, *(0.0,) * (3 - len(value)))
