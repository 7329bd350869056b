"""Ends of links on which a law is tried before its machine code runs."""

from collections.abc import Iterator, Sequence

import numpy as np

from cotouch.laws._end import End

# Rows and numbers of a row: a point along one axis and three, a chain, and what is padded.
_SIZES = ((1, 1), (1, 4), (3, 2), (5, 4))
_STEPS = 6


def ends(
    parameters: Sequence[float], sends: int, keeps: int, shares: int, numbers: int, own: int, common: int
) -> Iterator[tuple[End]]:
    """Ends in their first steps, in bodies of several sizes.

    Args:
        parameters: of the law.
        sends: fields of its messages.
        keeps: fields that an end keeps.
        shares: fields that the ends of a copy share.
        numbers: of its messages.
        own: numbers that an end keeps.
        common: numbers that the ends of a copy share.
    """
    rng = np.random.default_rng(0)
    for rows, width in _SIZES:
        size = rows * width
        kept = {"memory": np.zeros((keeps, size)), "scalars": np.zeros(own)}
        shared = {"shared": np.zeros((shares, size)), "shared_scalars": np.zeros(common)}
        results = {"target": np.zeros(size), "push": np.zeros(size), "gains": np.zeros(2)}
        message = {"sent": np.zeros((sends, size)), "sent_scalars": np.zeros(numbers)}
        for step in range(_STEPS):
            for side in (0, 1):
                read = ("position", "velocity", "mean", "sample", "hand", "touch")
                yield (
                    End(
                        T=1e-3,
                        age=0.05,
                        sample_index=step - 2,
                        new=step > 1,
                        step=step,
                        side=side,
                        first=side == 0,
                        last=side == 1,
                        copies=2,
                        width=width,
                        spring=50.0,
                        parameters=np.array(parameters, dtype=np.float64),
                        weight=np.ones(size),
                        received=rng.normal(size=(sends, size)),
                        received_scalars=rng.normal(size=numbers),
                        **{name: rng.normal(size=size) for name in read},
                        **kept,
                        **shared,
                        **results,
                        **message,
                    ),
                )
