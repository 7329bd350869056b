"""What `paid` makes of tools and devices that touch the neighbour's copy."""

from cotouch.laws._end import End
from cotouch.laws._helper import helper
from cotouch.laws._paid_fields import EVENLY, M_B, M_K, M_V, M_WAY, STRETCH, V
from cotouch.laws._paid_heard import Then, place_then

# So long is seen how a hand's force changes [s].
SMOOTH = 0.03


@helper
def stretch(end: End, then: Then, since: float, fresh: bool) -> None:
    """What touches goes on as it did, and pulls this copy to where its own is, over what it acts on.

    Its force is late: what swings would be pushed on by it. So it is taken to change as its spring says of what this
    copy did since, less what is done evenly: that is the aim's, and a spring against it would be a drag.

    Args:
        end: of the link.
        then: where this copy was when the neighbour's sample was.
        since: how long ago that is [s].
        fresh: whether it is another hand than before.
    """
    T, x, own, got, told = end.T, end.position, end.shared, end.received, end.received_scalars
    kept, memory, width, size = end.scalars, end.memory, end.width, end.position.shape[0]
    for axis in range(width):
        stretch = moved = faster = 0.0
        for i in range(axis, size, width):
            shape = got[M_WAY, i]
            if shape != 0.0:
                x_then, v_then = place_then(end, then, i)
                stretch += shape * (told[M_K] * (end.sample[i] - x_then) + told[M_B] * (got[M_V, i] - v_then))
                moved += shape * (x[i] + 0.5 * T * own[V, i] - x_then)
                faster += shape * (own[V, i] - v_then)
        if since > 0.0:
            part = 1.0 if fresh else min(T / SMOOTH, 1.0)
            kept[EVENLY + axis] += part * (moved / since - kept[EVENLY + axis])
            stretch -= told[M_K] * (moved - since * kept[EVENLY + axis]) + told[M_B] * faster
        for i in range(axis, size, width):
            if got[M_WAY, i] != 0.0 or memory[STRETCH, i] != 0.0:
                memory[STRETCH, i] = got[M_WAY, i] * stretch
