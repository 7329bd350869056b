"""What stands at the head of a recording: who, which version, which clocks, what was asked for."""

import json
from collections.abc import Mapping
from dataclasses import dataclass, field
from importlib.metadata import version
from typing import Any, final

from cotouch.errors import RecordingError
from cotouch.recording._body import RecordedBody

SCHEMA = 1
_STRINGS = ("name", "key", "session", "version", "body_hash")


@final
@dataclass(frozen=True, kw_only=True, eq=False)
class RecordHeader:
    """What is known before the first step.

    Attributes:
        user: index of the user.
        body: the shared object (`RecordedBody.of(model)`).
        monotonic: an instant on the user's own clock, the one of `Report.sample.stamp` [s].
        unix: the same instant in Unix time [s]; with `monotonic` it lays recordings of several machines side by side.
        name: of the user, as others see it.
        key: what identifies the user, such as its public key in hexadecimal digits.
        session: what names the session, the same for all its users.
        configuration: the resolved configuration; anything that JSON can say.
        body_hash: of the file that the body came from, if it came from one.
        version: of the software; empty: this one.
        columns: unit and meaning of extra columns, by name.
    """

    user: int
    body: RecordedBody
    monotonic: float
    unix: float
    name: str = ""
    key: str = ""
    session: str = ""
    configuration: Mapping[str, object] = field(default_factory=dict[str, object])
    body_hash: str = ""
    version: str = ""
    columns: Mapping[str, tuple[str, str]] = field(default_factory=dict[str, tuple[str, str]])

    @property
    def offset(self) -> float:
        """Unix time less the user's monotonic time [s]."""
        return self.unix - self.monotonic

    def metadata(self) -> dict[str, str]:
        """What goes into the file's metadata record: strings only, as MCAP wants them."""
        return {
            "schema": str(SCHEMA),
            "user": str(self.user),
            "name": self.name,
            "key": self.key,
            "session": self.session,
            "version": self.version or f"cotouch {version('cotouch')}",
            "monotonic": repr(self.monotonic),
            "unix": repr(self.unix),
            "body_hash": self.body_hash,
            "columns": json.dumps({name: list(entry) for name, entry in self.columns.items()}),
        }

    @classmethod
    def read(cls, metadata: Mapping[str, str], configuration: bytes, body: bytes) -> "RecordHeader":
        """Puts it together again.

        Args:
            metadata: the record `cotouch` of the file.
            configuration: the attachment, JSON.
            body: the attachment, NumPy's.

        Raises:
            RecordingError: something is missing, or of a later version of this format.
        """
        try:
            schema = int(metadata["schema"])
            if schema > SCHEMA:
                raise RecordingError(f"the recording has format {schema}; this version reads up to {SCHEMA}")
            columns: dict[str, Any] = json.loads(metadata["columns"])
            return cls(
                user=int(metadata["user"]),
                body=RecordedBody.from_bytes(body),
                monotonic=float(metadata["monotonic"]),
                unix=float(metadata["unix"]),
                configuration=json.loads(configuration),
                columns={str(name): (str(unit), str(text)) for name, (unit, text) in columns.items()},
                **{name: metadata[name] for name in _STRINGS},
            )
        except (KeyError, ValueError, TypeError) as error:
            if isinstance(error, RecordingError):
                raise
            raise RecordingError(f"the recording's header cannot be read: {repr(error)[:100]}") from None
