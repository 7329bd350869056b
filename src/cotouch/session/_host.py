"""The host: hands out the session's file, and decides who takes part as long as it is there."""

from typing import final

from cotouch.live import ControlPlane, Message
from cotouch.session._coordinator import Coordinator, Planner
from cotouch.session._file import SessionFile
from cotouch.session._links import Pair
from cotouch.session._messages import Roster, read, write
from cotouch.session._watch import HANDED_ON, Watch

# How often who only watches is told what members say of themselves [s].
_HAND_ON = 0.5


@final
class Host:
    """Keeps a session open without taking a seat in it.

    Attributes:
        watch: what is seen of the session.
    """

    def __init__(
        self,
        session: SessionFile,
        control: ControlPlane,
        *,
        planner: Planner | None = None,
        fingerprint: list[float] | None = None,
        resumed: bool = False,
    ) -> None:
        """Opens the session.

        Args:
            session: what was asked for.
            control: the control plane; this member's key is the one that the invitation names.
            planner: chooses the links, for links = "plan".
            fingerprint: of the body.
            resumed: whether members may be there already, who went on while the host was gone.
        """
        self._control = control
        self._resumed = resumed
        self._handed_on = -float("inf")
        self._coordinator = Coordinator(session, planner=planner, fingerprint=fingerprint)
        self.watch = Watch(control, host=control.identity.public)
        control.offer(session.content)
        for data in session.files.values():
            control.offer(data)

    def service(self, now: float) -> None:
        """Hears, decides, says.

        Args:
            now: [s].
        """
        own = self._control.identity.public
        present = self._control.present() | {own}
        for message in self._control.poll():
            if message.topic == "roster":  # while the host is there, nobody else decides
                self._resume(message, now)
                continue
            self._coordinator.hear(message, now)
            self.watch.hear(message, present, now)
        for topic, body, to in self._coordinator.tick(now, present):
            self._control.send(topic, body, to=to)
        self.watch.follow(self._coordinator.roster, now)
        if now - self._handed_on >= _HAND_ON:
            self._handed_on = now
            self._hand_on(present - {own}, now)

    def _hand_on(self, others: frozenset[bytes], now: float) -> None:
        """Tells who only watches what members say of themselves: members behind NATs see nobody but the host.

        That a member sees a watcher cannot be known here, so it is told to all, and taken of those unseen.
        """
        watchers = others - {bytes.fromhex(entry.key) for entry in self.roster.members}
        if not watchers:
            return
        said = [seen.status for seen in self.watch.members.values() if not seen.stale(now)]
        for body in [write(status) for status in said if status is not None]:
            for watcher in watchers:
                self._control.send(HANDED_ON, body, to=watcher)

    def _resume(self, message: Message, now: float) -> None:
        """Goes on from what the members decided while the host was gone."""
        roster = read(Roster, message.body) if self._resumed else None
        if roster is not None and roster.of(message.sender) is not None and not self._coordinator.roster.epoch:
            self._coordinator.adopt(roster, now)

    @property
    def roster(self) -> Roster:
        """Who takes part, and who is linked to whom."""
        return self._coordinator.roster

    def choose(self, links: list[Pair]) -> None:
        """Takes these links from now on; see `Coordinator.choose`."""
        self._coordinator.choose(links)

    def end(self) -> None:
        """Ends the session for everybody."""
        self.watch.ended = True
        self._control.send("end", b"")
