"""The sample plane of one user: samples out to the neighbours, theirs in, over whatever transport."""

from collections import Counter
from collections.abc import Hashable
from dataclasses import dataclass, field, replace
from typing import final

from cotouch.arrays import Float
from cotouch.errors import SessionError
from cotouch.peer import MOST_AHEAD, LawLink, LinkGuard, Sample
from cotouch.samples._ages import LinkAges
from cotouch.samples._assembly import Assembly
from cotouch.samples._chunk import AGED, BRIEF, ECHO, RENEW, Chunk, Coded, Heading, Refusal, Written
from cotouch.samples._codec import SampleCodec
from cotouch.samples._coded import CodedLink
from cotouch.samples._indexed import IndexedAssembly
from cotouch.samples._layout import Layout
from cotouch.samples._rate import SendRate
from cotouch.samples._seal import SealedLink, connection_of
from cotouch.samples._sent import Sent
from cotouch.samples._transport import Arrival, Transport


@final
@dataclass(eq=False)
class SampleLink:
    """All that the sample plane keeps about one neighbour.

    Attributes:
        assembly: its state, as far as it arrived; the peer's link.
        seal: what is between the two and nobody else.
        rate: how often it is sent to.
        ages: of both directions.
        refused: datagrams that came by its number and were of no use, by reason.
        asked: whether the other end asks for new keys.
        guard: what keeps this end passive; its words go with every datagram. None: this end says it is coupled.
        law: what the link does instead of a guarded spring; its words go with every datagram.
        coded: its perceptual codec, where the session has one.
        said: how it said the last step's sample: 0 in full numbers, 255 rounded, else since how many steps it goes on;
            -1: it was not sent.
        sent: what goes to the neighbour a second.
        ahead: what the neighbour's samples seem older than they are, because clocks differ, as the quickest echo of the
            last seconds says with ways there and back that take the same; 0 before [s].
    """

    assembly: Assembly | IndexedAssembly
    seal: SealedLink = field(default_factory=SealedLink)
    rate: SendRate = field(default_factory=SendRate)
    ages: LinkAges = field(default_factory=LinkAges)
    refused: Counter[Refusal] = field(default_factory=Counter[Refusal])
    asked: bool = False
    guard: LinkGuard | None = None
    law: LawLink | None = None
    coded: CodedLink | None = None
    said: int = -1
    sent: Sent = field(default_factory=Sent)
    ahead: float = 0.0
    _newest: tuple[float, float] | None = None  # stamp and arrival

    def note(self, chunk: Chunk | Coded, arrived: float, now: float) -> None:
        """Takes what an authenticated chunk says besides its state.

        Args:
            chunk: which part of the state.
            arrived: when, by the receiver's clock [s].
            now: time by the clock of this member [s].
        """
        _, _, step, stamp, T, flags, newest, count, echo, held, age, worst, _ = chunk.heading
        if self._newest is None or stamp > self._newest[0]:
            self._newest = (stamp, arrived)
        if flags & BRIEF:
            return
        self.asked = bool(flags & RENEW)
        ages = self.ages
        if flags & AGED:
            ages.received(now, index=step, age=age, worst=worst)
        if flags & ECHO:
            path = ages.echoed(now, arrived=arrived, echo=echo, held=held)
            if path is not None and path <= (ages.shortest_path or 0.0):
                self.ahead = arrived - stamp - 0.5 * (T + path)
            self.rate.report(
                now, sent=self.seal.sealed, newest=newest, count=count, path=path, shortest=ages.shortest_path
            )

    def heading(self, epoch: int, sample: Sample, T: float, now: float) -> Heading:
        """What a datagram to this neighbour says besides the state.

        Args:
            epoch: of the links.
            sample: what the step tells.
            T: length of the step [s].
            now: time by the clock of this member [s].
        """
        flags, echo, held, age, worst = 0, 0.0, 0.0, 0.0, 0.0
        newest, count = self.seal.received
        if self._newest is not None and newest >= 0:
            flags |= ECHO
            echo, held = self._newest[0], max(0.0, now - self._newest[1])
        own = self.ages.own
        if own is not None:
            flags |= AGED
            age, worst = own
        if self.seal.wants_keys(now):
            flags |= RENEW
        header = sample.header if self.guard is None else self.guard.header
        return Heading(
            epoch,
            sample.sender,
            sample.index,
            sample.stamp,
            T,
            flags,
            max(newest, 0),
            count,
            echo,
            held,
            age,
            worst,
            header,
        )


@final
class SamplePlane:
    """Sends a user's samples to its neighbours and reassembles theirs.

    In every step: `poll`, the peer's step with `links[j].assembly` as its links, or the guards around them, `stepped`,
    `send`. Times are those of one clock of this user, the one that the transport stamps arrivals with.

    Attributes:
        user: index of this one.
        epoch: of the session; what says another is refused.
        links: of each neighbour.
        refused: datagrams that belong to no link, by reason.
        unsent: whether the last sample for which it was time is farther away than samples can tell.
    """

    def __init__(self, transport: Transport, layout: Layout, *, user: int, epoch: int = 0) -> None:
        """Sets the plane up, without neighbours.

        Args:
            transport: carries the datagrams.
            layout: of the session.
            user: index of this one.
            epoch: of the session.
        """
        if not 0 <= user < 1 << 16 or not 0 <= epoch < 1 << 32:
            raise SessionError(f"user {user} or epoch {epoch} does not fit into 16 and 32 bits")
        self.user = user
        self.epoch = epoch
        self.links: dict[int, SampleLink] = {}
        self.refused: Counter[Refusal] = Counter()
        self.unsent = False
        self._transport = transport
        self._codec = SampleCodec(layout)
        self._by_number: dict[int | None, tuple[int, SampleLink]] = {}
        self._early: list[Arrival] = []

    @property
    def layout(self) -> Layout:
        """Of the session."""
        return self._codec.layout

    def connect(self, neighbour: int, link: SampleLink, *, at: Hashable | None = None) -> None:
        """Adds a neighbour; its keys go to `link.seal`.

        Args:
            neighbour: index of the user.
            link: what is held of it.
            at: where it is, as the transport understands it; None: wherever it will be heard from.
        """
        if neighbour == self.user or link.assembly.sender != neighbour:
            raise SessionError(f"user index {neighbour} cannot be this link's neighbour; take the assembly's sender")
        self.links[neighbour] = link
        self._by_number.clear()
        if at is not None:
            self._transport.follow(neighbour, at)

    def disconnect(self, neighbour: int) -> None:
        """Lets a neighbour go; what still comes of it is refused."""
        if self.links.pop(neighbour, None) is not None:
            self._by_number.clear()
            self._transport.forget(neighbour)

    def poll(self, now: float) -> int:
        """Reads everything that arrived; returns how many chunks were of use.

        What arrived more than a millisecond after now is kept for the next call.

        Args:
            now: [s].
        """
        arrivals = self._transport.poll()
        if self._early:
            arrivals, self._early = self._early + arrivals, []
        if not arrivals:
            return 0
        if arrivals[-1].time > now + MOST_AHEAD:  # they are in order
            self._early = [arrival for arrival in arrivals if arrival.time > now + MOST_AHEAD]
            arrivals = [arrival for arrival in arrivals if arrival.time <= now + MOST_AHEAD]
        useful, current = 0, False
        by_number, transport, read = self._by_number, self._transport, self._codec.read
        for payload, source, time in arrivals:
            number = connection_of(payload)
            if isinstance(number, Refusal):
                self.refused[number] += 1
                continue
            found = by_number.get(number)
            if not current and (found is None or found[1].seal.connection != number):  # new keys since the last look
                by_number = self._by_number = self._numbered()
                found, current = by_number.get(number), True
            if found is None:
                self.refused[Refusal.CONNECTION] += 1
                continue
            neighbour, link = found
            opened = link.seal.open(payload, now)
            if isinstance(opened, Refusal):
                link.refused[opened] += 1
                continue
            if opened.newest:
                transport.follow(neighbour, source)
            chunk = read(opened.payload, epoch=self.epoch, sender=neighbour)
            if isinstance(chunk, Refusal):
                link.refused[chunk] += 1
                continue
            link.note(chunk, time, now)
            chunks = [chunk] if isinstance(chunk, Chunk) else self._decoded(link, chunk)
            for one in chunks:
                reason = link.assembly.take(one)
                if reason is None:
                    useful += 1
                else:
                    link.refused[reason] += 1
        return useful

    def _decoded(self, link: SampleLink, said: Coded) -> list[Chunk]:
        """What a link's decoder makes of a datagram."""
        found = Refusal.ENCODING if link.coded is None else link.coded.hear(self._codec, said)
        if isinstance(found, Refusal):
            link.refused[found] += 1
            return []
        return found

    def _numbered(self) -> dict[int | None, tuple[int, SampleLink]]:
        """Links by the number that datagrams to this end bear."""
        return {link.seal.connection: (neighbour, link) for neighbour, link in self.links.items()}

    def stepped(self, now: float) -> None:
        """Notes the ages of the samples that the step ending now has used; to be called after it, before `poll`."""
        for link in self.links.values():
            if link.assembly.complete:
                link.ages.used(now, link.assembly.oldest)

    def send(self, now: float, sample: Sample, T: float, mean: Float | None = None) -> Written | Refusal | None:
        """Sends a sample to every neighbour whose turn it is.

        Args:
            now: [s].
            sample: what the step told.
            T: length of the step [s].
            mean: v̂ of the step, (rows, width); links with a perceptual codec need it [m/s].

        Returns:
            What was sent, with its rounding error; None if it was nobody's turn; why not, if nobody would take it. A
            perceptual codec's errors are not in it.
        """
        capacity, chunks, due = self._transport.capacity, self.layout.chunks, list[tuple[int, SampleLink]]()
        for neighbour, link in self.links.items():
            link.said = -1
            link.rate.cap(capacity(neighbour) / chunks)
            if link.rate.due(now):
                due.append((neighbour, link))
            elif link.coded is not None and mean is not None:
                link.coded.encoder.skip(sample.stamp, mean, T)
        if not due:
            return None
        written = self._codec.write(sample.position)
        self.unsent = isinstance(written, Refusal)
        if isinstance(written, Refusal):
            self.refused[written] += 1
            return written
        for neighbour, link in due:
            self._tell(now, neighbour, link, written, link.heading(self.epoch, sample, T, now), sample, mean)
        return written

    def _tell(
        self,
        now: float,
        neighbour: int,
        link: SampleLink,
        written: Written,
        heading: Heading,
        sample: Sample,
        mean: Float | None,
    ) -> None:
        """Sends a sample to one neighbour."""
        codec, seal, send, coded = self._codec, link.seal.seal, self._transport.send, link.coded
        message = None if link.law is None else link.law.message
        told = codec.told(message)
        if isinstance(told, Refusal):
            link.refused[told] += 1
            return
        if coded is None:
            datagrams = [codec.datagram(heading, chunk, body, told[chunk]) for chunk, body in enumerate(written.bodies)]
        else:
            assert mean is not None
            exact = link.guard is not None and not link.guard.tolerant
            datagrams = coded.say(codec, heading, replace(sample, message=message), mean, heading.T, exact=exact)
            link.said = coded.encoder.said
        size = 0
        for datagram in datagrams:
            sealed = seal(datagram)
            if sealed is not None:
                send(neighbour, sealed)
                size += len(sealed)
        link.sent.add(now, len(datagrams), size, size if coded is None else coded.full)
