"""Who may come in, and to which slot."""

from collections.abc import Callable, Container, Mapping
from ipaddress import ip_address
from typing import final

from cotouch.members._file import SessionFile
from cotouch.members._law_check import signature_of
from cotouch.members._messages import MOST_NAMES, Entry, Join, Roster
from cotouch.members._shared_model import same_body
from cotouch.traversal import Addresses, Place

# A member's process begins anew at most this often [s].
_AGAIN = 2.0
# Names that one address may take in a session.
_NAMES_EACH = 16
_UNKNOWN = "an unknown address"


def addresses_of(addresses: Addresses, own: Container[str]) -> Callable[[bytes, Join], str | None]:
    """Where a requester is, by its proofs; "" for this machine itself, which does not count.

    Args:
        addresses: knows what it told.
        own: addresses of this machine, loopback aside.
    """

    def where(key: bytes, join: Join) -> str | None:
        if join.place is None:
            return None
        place = Place(bytes.fromhex(join.place.nonce), join.place.host, bytes.fromhex(join.place.cookie))
        shown = addresses.shown(key, place)
        here = shown is not None and (place.host in own or ip_address(place.host).is_loopback)
        return "" if here else shown

    return where


@final
class Admission:
    """Answers requests to take part.

    A name belongs for the whole session to the key that took it first, and a key has one name. An address has half of
    the slots, if addresses are known; all whose address nobody knows share one such half.

    Attributes:
        fingerprint: of the body, as built here; None: not built yet, and nobody is answered.
        mine: slots that nobody but these keys gets, by key.
    """

    def __init__(
        self,
        session: SessionFile,
        *,
        fingerprint: list[float] | None,
        each: int | None = None,
        where: Callable[[bytes, Join], str | None] = lambda key, join: None,  # noqa: ARG005
    ) -> None:
        """Begins.

        Args:
            session: what was asked for.
            fingerprint: of the body, as built here.
            each: slots that one address may take; None: any.
            where: the address of a key that requests to take part, as far as it is shown; None: not known; "": not
                counted.
        """
        self.fingerprint = fingerprint
        self.mine: Mapping[str, int] = {}
        self._law = signature_of(session.scenario)
        self._session, self._each, self._where = session, each, where
        self._at: dict[str, str] = {}
        self._began: dict[str, float] = {}
        self._former: dict[str, int] = {}

    def slot(self, join: Join, key: str, roster: Roster, now: float) -> int | str | None:
        """The slot that a newcomer gets, why it gets none, or None: no answer yet.

        Args:
            join: its.
            key: its public key.
            roster: as it is.
            now: [s].
        """
        if self.fingerprint is None:
            return None
        why = self.unfit(join, key, roster)
        if why is not None:
            return why
        own = next((entry for entry in roster.members if entry.key == key), None)
        if own is not None:
            return own.slot if now - self._began.get(key, -_AGAIN) >= _AGAIN else None
        return self._free(join, key, roster)

    def came(self, join: Join, key: str, roster: Roster, now: float) -> None:
        """Remembers one who was let in.

        Args:
            join: its.
            key: its public key.
            roster: that it is in now.
            now: [s].
        """
        self._remember(roster, {key: self._address(key, join)})
        self._began[key] = now

    def welcome(self, entry: Entry, roster: Roster) -> bool:
        """Whether one whom somebody else let in may stay: it shows no address, so it counts where it was, or nowhere.

        Args:
            entry: its; remembered if it may.
            roster: those besides it.
        """
        at = self._at.get(entry.key, _UNKNOWN)
        if self._crowded(at, entry.key, roster) is not None:
            return False
        self._remember(roster, {entry.key: at})
        return True

    def _remember(self, roster: Roster, at: Mapping[str, str]) -> None:
        known = {*roster.owners().values(), *at}
        self._began = {other: time for other, time in self._began.items() if other in known}
        slots = {entry.key: entry.slot for entry in roster.members}
        self._former = {other: slot for other, slot in self._former.items() if other in known} | slots
        self._at = {other: where for other, where in self._at.items() if other in known} | dict(at)

    def unfit(self, join: Join, key: str, roster: Roster) -> str | None:
        """Why somebody does not come in, however many slots are free; None: nothing is against it.

        Args:
            join: its.
            key: its public key.
            roster: as it is.
        """
        if self.fingerprint is None or not same_body(join.fingerprint, self.fingerprint):
            return (
                "this machine built a different body from the same file; use the same version of cotouch as the others"
            )
        if join.law != self._law:
            own, name = self._law.split()[0], (join.law.split() or ["none"])[0]
            return (
                f'links of this session use law "{own}", and this machine has a different one ("{name}"); use the same '
                "version of cotouch as the others"
            )
        if key in roster.banned:
            return "the host expelled you from this session"
        owners = roster.owners()
        if owners.get(join.name, key) != key:
            return (
                f'the name "{join.name}" is taken by somebody else in this session; choose another with --name, or ask '
                "the host to release it"
            )
        before = next((name for name, owner in owners.items() if owner == key), join.name)
        if before != join.name:
            return f'you are known as "{before}" in this session; join with --name "{before}"'
        if join.name not in owners and len(owners) >= MOST_NAMES:
            return f"this session already has {MOST_NAMES} names, the maximum; ask the host to release some"
        return None

    def _free(self, join: Join, key: str, roster: Roster) -> int | str:
        users = self._session.scenario.network.users
        taken = {entry.slot for entry in roster.members}
        free = [slot for slot in range(len(users)) if slot not in taken]
        if not free:
            return f"all {len(users)} slots of this session are taken"
        crowded = self._crowded(self._address(key, join), key, roster)
        if crowded is not None:
            return crowded
        if key in self.mine:
            slot = self.mine[key]
            return slot if slot in free else "your slot was given to somebody else while you were away"
        if self._session.named and join.name in users and users.index(join.name) in free:
            return users.index(join.name)
        if self._former.get(key) in free:
            return self._former[key]
        others = set(self.mine.values())  # who has a slot from the host may come back to it
        return next((slot for slot in free if slot not in others), free[0])

    def _crowded(self, address: str, key: str, roster: Roster) -> str | None:
        if self._each is None or not address:
            return None
        here = sum(self._at.get(entry.key) == address for entry in roster.members)
        if here >= self._each:
            return (
                f"{address} already has {here} of the {self._each} slots that one address may take; the host can allow "
                "more with session.per_address"
            )
        owners = set(roster.owners().values())
        if key not in owners and sum(self._at.get(owner) == address for owner in owners) >= _NAMES_EACH:
            return f"{_NAMES_EACH} names are already taken from {address}; ask the host to release some"
        return None

    def _address(self, key: str, join: Join) -> str:
        address = self._where(bytes.fromhex(key), join)
        return _UNKNOWN if address is None else address
