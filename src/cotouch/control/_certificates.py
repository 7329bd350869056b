"""Certificates that say "was invited": made for one session from its invitation, nobody is asked for anything.

The session's authority is a key that follows from the invitation's secret, so every invited member makes its own
certificate, and both ends of a connection accept what that authority signed and nothing else. TLS then says that the
other end *was invited*; *who* it is says the signature on each message (`_sign.py`).
"""

import time
from datetime import UTC, datetime, timedelta
from typing import NamedTuple

from cryptography import x509
from cryptography.hazmat.primitives.asymmetric.ed25519 import Ed25519PrivateKey
from cryptography.hazmat.primitives.serialization import Encoding, NoEncryption, PrivateFormat
from cryptography.x509.oid import ExtendedKeyUsageOID, NameOID

from cotouch.control._invitation import Invitation
from cotouch.samples import Entropy

# A session's authority lives as long as its invitation: whoever has that can make any certificate anyway.
_FROM, _UNTIL = datetime(2000, 1, 1, tzinfo=UTC), datetime(2100, 1, 1, tzinfo=UTC)
# A member's certificate is good for as long as a session may last, and from before its start for those whose clocks are
# behind. Zenoh takes no other while it runs. A key that leaks gives no more than the invitation, which lasts as long.
_BEHIND, _SESSION = timedelta(days=1), timedelta(days=31)


class TlsCertificates(NamedTuple):
    """What one member's TLS needs, each in PEM.

    Attributes:
        authority: certificate of the session's authority, the only one that is trusted.
        certificate: of this member; it names nobody, because a server shows it to strangers.
        key: private key of this certificate, made for it alone.
    """

    authority: bytes
    certificate: bytes
    key: bytes

    def __repr__(self) -> str:
        return "Certificates()"


def make_certificates(invitation: Invitation, *, entropy: Entropy, now: float | None = None) -> TlsCertificates:
    """A member's certificates [Ed25519, X.509].

    Args:
        invitation: of the session.
        entropy: gives so many bytes that nobody can guess, such as `os.urandom`.
        now: unix time from which the member's certificate is good for 31 days; None: the system's [s].
    """
    begins = datetime.fromtimestamp(time.time() if now is None else now, UTC)
    authority = Ed25519PrivateKey.from_private_bytes(invitation.derive(b"authority", 32))
    own = Ed25519PrivateKey.from_private_bytes(entropy(32))
    issuer = x509.Name([x509.NameAttribute(NameOID.COMMON_NAME, "cotouch session")])
    root = (
        _begun(issuer, issuer, 1, (_FROM, _UNTIL))
        .public_key(authority.public_key())
        .add_extension(x509.BasicConstraints(ca=True, path_length=0), critical=True)
        .sign(authority, None)
    )
    usages = [ExtendedKeyUsageOID.SERVER_AUTH, ExtendedKeyUsageOID.CLIENT_AUTH]
    member = (
        _begun(
            x509.Name([x509.NameAttribute(NameOID.COMMON_NAME, "member")]),
            issuer,
            int.from_bytes(entropy(16), "big") >> 1 | 1,
            (begins - _BEHIND, begins + _SESSION),
        )
        .public_key(own.public_key())
        .add_extension(x509.BasicConstraints(ca=False, path_length=None), critical=True)
        .add_extension(x509.ExtendedKeyUsage(usages), critical=False)
        .add_extension(x509.SubjectAlternativeName([x509.DNSName("member.cotouch.invalid")]), critical=False)
        .sign(authority, None)
    )
    key = own.private_bytes(Encoding.PEM, PrivateFormat.PKCS8, NoEncryption())
    return TlsCertificates(root.public_bytes(Encoding.PEM), member.public_bytes(Encoding.PEM), key)


def _begun(
    subject: x509.Name, issuer: x509.Name, serial: int, valid: tuple[datetime, datetime]
) -> x509.CertificateBuilder:
    builder = x509.CertificateBuilder().subject_name(subject).issuer_name(issuer).serial_number(serial)
    return builder.not_valid_before(valid[0]).not_valid_after(valid[1])
