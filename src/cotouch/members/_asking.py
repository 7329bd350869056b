"""How a member asks for a slot, and what it makes of being refused."""

from collections.abc import Callable
from typing import final

from cotouch.errors import SessionError
from cotouch.members._messages import AddressProof, Join, Refused, write_message
from cotouch.traversal import Place

_ASK_EVERY = 0.5
# A member that cannot show where it is asks without that after so long [s].
_SHOW = 3.0
# Slots may still be held by what crashed a moment ago: so long one is asked for again [s].
_PATIENCE = 12.0


@final
class Asking:
    """What one member says to whoever decides, as long as it has no slot.

    Attributes:
        request: what is said, but for where it is.
        refusal: why it was not let in, as said last; None: nobody said anything.
    """

    def __init__(self, request: Join, place: Callable[[], Place | None] | None) -> None:
        """Begins.

        Args:
            request: what is said.
            place: what shows the host where this member is, once it was told; None: nobody asks.
        """
        self.request = request
        self.refusal: str | None = None
        self._place = place
        self._asked = -float("inf")
        self._first_asked: float | None = None
        self._final = False

    def refuse(self, said: Refused) -> None:
        """Takes that it was not let in."""
        self.refusal, self._final = said.reason, said.final

    def begin(self) -> None:
        """Asks anew, as if it had not asked before."""
        self._first_asked, self.refusal = None, None

    def due(self, now: float, *, inside: bool) -> bytes | None:
        """What is to be said now; None: nothing.

        Args:
            now: [s].
            inside: whether it has a slot, of which whoever decides does not know.

        Raises:
            SessionError: it was refused for good, or for long enough.
        """
        if self._first_asked is None:
            self._first_asked = now
        waited = now - self._first_asked > _PATIENCE
        if not inside and self.refusal is not None and (self._final or waited):
            raise SessionError(f"the host does not admit {self.request.name}: {self.refusal}")
        if now - self._asked < _ASK_EVERY:
            return None
        place = None if self._place is None else self._place()
        if self._place is not None and place is None and now - self._first_asked < _SHOW:
            return None
        self._asked = now
        if place is None:
            return write_message(self.request)
        shown = AddressProof(nonce=place.nonce.hex(), host=place.host, cookie=place.cookie.hex())
        return write_message(self.request.model_copy(update={"place": shown}))
