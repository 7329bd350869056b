"""A member's recording: what its copy does, in the words of `cotouch.recording`."""

from pathlib import Path
from typing import Any, final

import numpy as np

from cotouch import __version__
from cotouch.errors import RecordingError
from cotouch.peer import COUPLED, Report
from cotouch.recording import EXCHANGE, GUARDS, LinkPhase, RecordedBody, Recorder, RecordHeader, both_clocks
from cotouch.session._copy import Copy
from cotouch.session._file import SessionFile
from cotouch.session._replica import Replica

_BOOKS = [(name, "lost" if name == "spilled" else name) for name in (*GUARDS, *EXCHANGE)]


@final
class Tape:
    """Opens the file when the copy begins to move, and is told of everything from then on; a `copy.Recorder`."""

    def __init__(self, path: Path, session: SessionFile, replica: Replica, *, name: str, key: bytes) -> None:
        """Prepares to record.

        Args:
            path: of the file; must not exist.
            session: that is recorded.
            replica: the body as built here.
            name: of the member.
            key: its public key.

        Raises:
            RecordingError: the file cannot be made.
        """
        if path.exists():
            raise RecordingError(f"{path} exists already; name a file that is not there yet")
        self._path, self._session, self._replica = path, session, replica
        self._name, self._key = name, key
        self._recorder: Recorder | None = None
        self._ports: list[int] | None = None

    def setup(self, copy: Copy, now: float) -> None:
        """Links, damping or the number of copies changed."""
        peer = copy.peer
        assert peer is not None
        if self._recorder is None:
            monotonic, unix = both_clocks()
            weights = self._replica.scenario.network.weights
            header = RecordHeader(
                user=copy.seat,
                body=RecordedBody.of(peer.model, weights=weights),
                monotonic=monotonic,
                unix=unix,
                name=self._name,
                key=self._key.hex(),
                session=self._session.digest.hex(),
                configuration={"session": self._session.content.decode()},
                version=f"cotouch {__version__}",
                columns={
                    "stiffness_share": ("1", "share of K that the copy carries"),
                    "rescaled": ("J", "what the copy's energy changed by before the step, as members came and went"),
                    **GUARDS,
                    **EXCHANGE,
                },
            )
            self._recorder = Recorder(self._path, header)
        held = [copy.neighbours[seat] for seat in peer.neighbours]
        self._recorder.setup(
            now,
            copies=copy.copies,
            neighbours=peer.neighbours,
            strength=[link.strength for link in held],
            weight=[link.weight for link in held],
            local_damping=copy.damping,
            extra_damping=copy.extra_damping,
            ports=copy.ports,
            tool_mass=() if peer.tools is None else peer.tools.mass[peer.tools.first : peer.tools.last],
            link_damping=[0.5 * link.strength * link.guard.total for link in held],
            budgets=[link.guard.budget if np.isfinite(link.guard.budget) else None for link in held],
            names=[link.entry.name for link in held],
            keys=[link.entry.key for link in held],
            seeds=[self._session.options.seed for _ in held],
        )

    def step(self, copy: Copy, report: Report, now: float, T: float) -> None:
        """A step was taken."""
        peer, recorder = copy.peer, self._recorder
        assert peer is not None
        assert recorder is not None
        held = [copy.neighbours[seat] for seat in peer.neighbours]
        books = [guard for guard in report.guards if guard is not None]
        used = [link.used for link in held]
        recorder.step(
            report,
            end=now,
            T=T,
            state=peer.state,
            tools=peer.tools,
            used=used,
            phase=[LinkPhase.COUPLED if book.state == COUPLED else LinkPhase.GUARDED for book in books],
            extra={
                "stiffness_share": peer.stiffness_share,
                "rescaled": report.rescaled,
                **{name: np.array([getattr(book, field) for book in books]) for name, field in _BOOKS},
            },
        )

    @property
    def begun(self) -> bool:
        """Whether there is a recording yet; what happens before it is not noted."""
        return self._recorder is not None

    def event(self, kind: str, time: float, **fields: Any) -> None:
        """Something happened."""
        if self._recorder is not None:
            self._recorder.event(kind, time, **fields)

    def close(self) -> int:
        """Ends the recording; returns how many steps are in it."""
        return 0 if self._recorder is None else self._recorder.close().steps
