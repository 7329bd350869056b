"""State that seals with nonces, and so must exist once."""

import os

from cotouch.errors import SessionError


class Unique:
    """State that must exist once, because two that go on from it would seal with the same nonces.

    It cannot be copied or pickled, and in a process forked off it is of no use: see `here`.
    """

    def __init__(self) -> None:
        """Belongs to this process from now on."""
        self._process = os.getpid()

    @property
    def here(self) -> bool:
        """Whether this is the process in which it was made."""
        return os.getpid() == self._process

    def __reduce_ex__(self, protocol: object) -> str:
        """Refuses `copy`, `deepcopy` and `pickle`, which all ask here."""
        raise SessionError(f"{type(self).__name__} cannot be copied: nonces would be used twice; agree on new keys")
