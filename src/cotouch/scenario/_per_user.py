"""One number for all users, or one for each."""

import numpy as np

from cotouch.arrays import Float
from cotouch.errors import ScenarioError


def per_user(value: float | list[float], users: int, name: str) -> Float:
    """One number for all users, or a list with one for each.

    Args:
        value: one number, or one for each.
        users: how many there are.
        name: of the option, for messages.

    Raises:
        ScenarioError: the list has another length.
    """
    if isinstance(value, list):
        if len(value) != users:
            raise ScenarioError(f"{name} has {len(value)} entries; the network has {users} users")
        return np.asarray(value, dtype=np.float64)
    return np.full(users, float(value))
