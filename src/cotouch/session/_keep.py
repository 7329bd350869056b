"""What is kept on disk, for its owner alone: a host's session, and who one is in a session.

Files are written beside and renamed, so they are whole or not there; whoever reads one can be who it says.
"""

import contextlib
import hashlib
import json
import os
import time
from pathlib import Path
from typing import IO, NamedTuple, final

from cotouch.control import Invitation
from cotouch.errors import SessionError, TransportError
from cotouch.files import read_text
from cotouch.files import write as put
from cotouch.members import Decision, SessionFile, genuine, write_message
from cotouch.samples import Entropy, Identity

_MOST = 1 << 20  # [B]
# Who one was in a session is of no use a week later [s].
_OLD = 7 * 86_400.0


class KeptHost(NamedTuple):
    """What a host goes on from.

    Attributes:
        identity: its.
        invitation: to the session.
        decision: the last roster that it signed; None: it never did.
    """

    identity: Identity
    invitation: Invitation
    decision: Decision | None


def keep_host(path: Path, kept: KeptHost) -> None:
    """Writes what a host goes on from.

    Args:
        path: the file.
        kept: what to write.

    Raises:
        OutputError: it cannot be written; what was there still is.
    """
    decision = None if kept.decision is None else json.loads(write_message(kept.decision))
    text = {"identity": kept.identity.secret.hex(), "invitation": kept.invitation.encode(), "decided": decision}
    put(path, json.dumps(text).encode(), "session's keys", private=True)


def kept_host(path: Path, session: SessionFile) -> KeptHost:
    """Reads what a host goes on from.

    Args:
        path: the file.
        session: the session's file.

    Raises:
        SessionError: the file is none of a host's, of another session, or was changed by somebody else.
    """
    try:
        kept = json.loads(read_text(path, "keys", SessionError, _MOST))
        identity = Identity(bytes.fromhex(kept["identity"]))
        invitation = Invitation.decode(kept["invitation"])
        decided = kept["decided"]
        decision = None if decided is None else Decision.model_validate(decided)
    except (ValueError, KeyError, TypeError, RecursionError) as error:
        raise SessionError(
            f"{path} does not hold the keys of a session; name a file that does not exist yet"
        ) from error
    if invitation.digest != session.digest or invitation.host != identity.public:
        raise SessionError(f"{path} holds the keys of another session; name a file that does not exist yet")
    if decision is not None and (decision.signer != identity.public.hex() or not genuine(decision, identity.public)):
        raise SessionError(f"{path} holds a roster that its host did not sign; name a file that does not exist yet")
    return KeptHost(identity, invitation, decision)


def identity_folder() -> Path:
    """Where this user's identities are kept: below XDG_STATE_HOME, or ~/.local/state."""
    state = os.environ.get("XDG_STATE_HOME", "")
    return (Path(state) if state else Path.home() / ".local" / "state") / "cotouch" / "identities"


@final
class KeptIdentity:
    """Who somebody of this name is in a session, also after a crash; held as long as the process lives.

    Attributes:
        identity: kept before, or new.
    """

    def __init__(self, folder: Path, session: bytes, name: str, entropy: Entropy) -> None:
        """Takes up the identity that is kept, if no other process has it; else makes one.

        Args:
            folder: of identities, made if it is not there.
            session: names the session.
            name: that others see.
            entropy: gives so many bytes that nobody can guess.

        Raises:
            TransportError: the folder or a file in it cannot be written.
        """
        self._held: IO[bytes] | None = None
        about = hashlib.sha256(session + name.encode()).hexdigest()[:32]
        path = folder / f"{about}.json"
        try:
            folder.mkdir(mode=0o700, parents=True, exist_ok=True)
            _tidy(folder)
            self._held = _locked(folder / f"{about}.lock")
            secret = None if self._held is None else _secret(path)
            self.identity = Identity.make(entropy) if secret is None else Identity(secret)
            if self._held is not None:
                put(path, json.dumps({"identity": self.identity.secret.hex()}).encode(), "identity", private=True)
        except OSError as error:
            self.close()
            raise TransportError(f"your identity cannot be stored in {folder}: {error.strerror}") from error

    def close(self) -> None:
        """Lets go of it; the file stays."""
        if self._held is not None:
            self._held.close()
            self._held = None


def _locked(path: Path) -> IO[bytes] | None:
    """The file, locked until it is closed or its process is gone; None: another process has it."""
    file = os.fdopen(os.open(path, os.O_RDWR | os.O_CREAT | os.O_NOFOLLOW, 0o600), "r+b")
    try:
        import fcntl
    except ImportError:  # where there are no such locks, two processes of one name are not told apart
        return file
    try:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError:
        file.close()
        return None
    return file


def _secret(path: Path) -> bytes | None:
    try:
        kept = json.loads(read_text(path, "identity", SessionError, _MOST))
        secret = bytes.fromhex(kept["identity"])
    except (SessionError, ValueError, KeyError, TypeError, RecursionError):
        return None
    return secret if len(secret) == 32 else None


def _tidy(folder: Path) -> None:
    """Lets go of what is too old to be of use."""
    now = time.time()
    for path in folder.glob("*.json"):
        with contextlib.suppress(OSError):
            if now - path.stat().st_mtime > _OLD:
                path.unlink()
                path.with_suffix(".lock").unlink(missing_ok=True)
