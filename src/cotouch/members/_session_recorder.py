"""A member's recording: what its copy does, in the words of `cotouch.recording`.

Whatever the disk does, the copy goes on: an error ends the recording, and is to be said by whoever asks `failure`.
"""

from pathlib import Path
from typing import final

import numpy as np

from cotouch.arrays import Array
from cotouch.errors import RecordingError
from cotouch.members._file import SessionFile
from cotouch.members._neighbour import Neighbour
from cotouch.members._replica import Replica
from cotouch.members._shared_model import SharedModel
from cotouch.network import link_damping
from cotouch.peer import GuardLedger, StepReport
from cotouch.recording import (
    ADVANCED,
    EXCHANGE,
    GUARDS,
    HOW_SAID,
    SAID,
    NewFile,
    RecordedBody,
    Recorder,
    RecordHeader,
    both_clocks,
)
from cotouch.version import __version__

_LEDGER = [(name, "lost" if name == "discarded" else name) for name in (*GUARDS, *EXCHANGE)]


@final
class SessionRecorder:
    """Records a member from its copy's first motion on; a `copy.Recorder`.

    Attributes:
        steps: that it was told of.
        recorded: steps in the file; after `close`.
        trouble: what is wrong with it, in words that follow "the recording"; after `close`. None: it is whole.
    """

    def __init__(
        self, file: Path | NewFile, session: SessionFile, replica: SharedModel, *, name: str, waits: bool = False
    ) -> None:
        """Makes the file; nothing is in it before the copy moves.

        Args:
            file: path of a file that does not exist, or one that was made before.
            session: that is recorded.
            replica: the body as built here.
            name: of the member.
            waits: whether steps wait for a slow disk instead of going unrecorded; for members on a virtual clock.

        Raises:
            RecordingError: the file exists, or cannot be made.
        """
        self.steps = self.recorded = 0
        self.trouble: str | None = None
        self._file = file if isinstance(file, NewFile) else NewFile(file)
        self._session, self._replica, self._law = session, replica, replica.law
        self._codec = session.scenario.channel.codec
        self._name, self._waits = name, waits
        self._recorder: Recorder | None = None
        self._refused: str | None = None
        self._closed = False

    def setup(self, copy: Replica, now: float) -> None:
        """Links, damping or the number of copies changed.

        Args:
            copy: the replica.
            now: time [s].
        """
        peer = copy.peer
        assert peer is not None
        if self._refused is not None:
            return
        if self._recorder is None:
            monotonic, unix = both_clocks()
            weights = self._replica.scenario.network.weights
            header = RecordHeader(
                user=copy.slot,
                body=RecordedBody.of(peer.model, weights=weights),
                monotonic=monotonic,
                unix=unix,
                name=self._name,
                key="" if copy.entry is None else copy.entry.life,
                session=self._session.digest.hex(),
                configuration={"session": self._session.content.decode()},
                version=f"cotouch {__version__}",
                columns={
                    "stiffness_scale": ("1", "share of K that the copy carries"),
                    "rescaled": ("J", "change of the copy's energy before the step, as members joined and left"),
                    ADVANCED: ("J", "what the links' tanks received of the newcomer's allowance after the step"),
                    **({} if self._law is not None else GUARDS),
                    **EXCHANGE,
                    **({} if self._codec is None else {SAID: HOW_SAID}),
                },
            )
            try:
                self._recorder = Recorder(self._file, header, waits=self._waits)
            except RecordingError as error:
                self._refused = getattr(error.__cause__, "strerror", None) or str(error)
                self.trouble = f"was not started: {self._refused}"
                return
            if peer.cuts is not None and peer.cuts.by.any():  # of a recording that begins later
                gone = np.flatnonzero(peer.cuts.by)
                self._recorder.event("cut", now, step=-1, elements=gone.tolist(), by=peer.cuts.by[gone].tolist())
        held = [copy.neighbours[slot] for slot in peer.neighbours]
        self._recorder.setup(
            now,
            copies=copy.copies,
            neighbours=peer.neighbours,
            strength=[link.strength if link.law is None else 0.0 for link in held],
            weight=[link.weight for link in held],
            local_damping=copy.damping,
            extra_damping=copy.extra_damping,
            ports=copy.ports,
            tool_mass=() if peer.tools is None else peer.tools.mass,
            link_damping=None if self._law is not None else [link_damping(link.strength, link.damped) for link in held],
            budgets=[
                link.guard.budget if link.guard is not None and np.isfinite(link.guard.budget) else None
                for link in held
            ],
            names=[link.entry.name for link in held],
            keys=[link.entry.life for link in held],
            law="spring" if self._law is None else self._law.law.name,
            initial_energies=[
                self._session.options.initial_energy if link.law is None else link.law.initial_energy for link in held
            ],
            allowance=self._session.options.allowance,
            codec=None if self._codec is None else self._codec.model_dump(),
        )

    def step(self, copy: Replica, report: StepReport, now: float, T: float) -> None:
        """A step was taken.

        Args:
            copy: the replica.
            report: of the step.
            now: time [s].
            T: length of the step [s].
        """
        peer, recorder = copy.peer, self._recorder
        assert peer is not None
        self.steps += 1
        if recorder is None:
            assert self._refused is not None
            return
        if report.cut_elements and peer.cuts is not None:
            by = [int(peer.cuts.by[element]) for element in report.cut_elements]
            recorder.event("cut", now, step=report.sample.index, elements=list(report.cut_elements), by=by)
        held = [copy.neighbours[slot] for slot in peer.neighbours]
        ledger = [guard for guard in report.guards if guard is not None]
        used = [link.used for link in held]
        recorder.step(
            report,
            end=now,
            T=T,
            state=peer.state,
            tools=peer.tools,
            used=used,
            link_state=[book.state for book in ledger] if self._law is None else None,
            extra={
                "stiffness_scale": peer.stiffness_scale,
                "rescaled": report.rescaled,
                ADVANCED: report.advanced,
                **self._books(held, ledger),
                **({} if self._codec is None else {SAID: np.array([link.link.said for link in held])}),
            },
        )

    def _books(self, held: list[Neighbour], ledger: list[GuardLedger]) -> dict[str, Array]:
        """What the ends' guards say of their energy; of a law, what went over its links."""
        if self._law is None:
            return {name: np.array([getattr(book, field) for book in ledger]) for name, field in _LEDGER}
        ends = [link.law for link in held if link.law is not None]
        return {"sent": np.array([end.sent for end in ends]), "received": np.array([end.received for end in ends])}

    @property
    def begun(self) -> bool:
        """Whether there is a recording yet; what happens before it is not noted."""
        return self._recorder is not None

    def event(self, kind: str, time: float, **fields: object) -> None:
        """Something happened.

        Args:
            kind: of message or event.
            time: when [s].
            fields: what else is to be known of it.
        """
        if self._recorder is not None:
            self._recorder.event(kind, time, **fields)

    @property
    def failure(self) -> str | None:
        """Why nothing is recorded any more, in a few words that name no file; None as long as it is."""
        return self._refused if self._recorder is None else self._recorder.failure

    def close(self) -> None:
        """Ends the recording; a file that holds nothing is removed. May be called again."""
        if self._closed:
            return
        self._closed = True
        if self._recorder is None:
            self._file.discard()
            return
        done = self._recorder.close()
        self.recorded, self.trouble = done.steps, done.trouble
        if not self.steps:
            self._file.discard()
