"""Two members' TLS, both ends checking, through memory; nobody else's certificate is taken."""

import ssl
import time
from pathlib import Path

import pytest
from tests.live.support import entropy, identities

from cotouch.control import Endpoint, Invitation, TlsCertificates, make_certificates

HOST = identities(1)[0].public


def certificates(*, secret: int = 1, own: int = 5, now: float | None = None) -> TlsCertificates:
    at = (Endpoint("127.0.0.1", 1),)
    invitation = Invitation.make(
        session="certificates", host=HOST, digest=bytes(32), endpoints=at, entropy=entropy(secret)
    )
    return make_certificates(invitation, entropy=entropy(own), now=now)


def context(made: TlsCertificates, folder: Path, *, server: bool) -> ssl.SSLContext:
    out = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER if server else ssl.PROTOCOL_TLS_CLIENT)
    out.check_hostname, out.verify_mode = False, ssl.CERT_REQUIRED
    file = folder / ("server.pem" if server else "client.pem")
    file.write_bytes(made.certificate + made.key)
    out.load_cert_chain(file)
    out.load_verify_locations(cadata=made.authority.decode())
    return out


def shake(server: TlsCertificates, client: TlsCertificates, folder: Path) -> bytes:
    """What the client hears through TLS; raises what either end objects to."""
    there, back = ssl.MemoryBIO(), ssl.MemoryBIO()
    ends = [
        context(server, folder, server=True).wrap_bio(there, back, server_side=True),
        context(client, folder, server=False).wrap_bio(back, there),
    ]
    done = [False, False]
    for _ in range(20):
        for at, end in enumerate(ends):
            try:
                end.do_handshake()
                done[at] = True
            except ssl.SSLWantReadError:
                continue
    assert done == [True, True]
    ends[0].write(b"welcome")
    return ends[1].read(100)


def test_two_of_the_invited(tmp_path: Path):
    assert shake(certificates(own=5), certificates(own=6), tmp_path) == b"welcome"


@pytest.mark.parametrize("hours", [-743, 23])
def test_clocks_may_be_hours_apart_and_a_session_last_a_month(hours: float, tmp_path: Path):
    ends = certificates(own=5), certificates(own=6, now=time.time() + 3600 * hours)
    assert shake(*ends, folder=tmp_path) == b"welcome"
    assert shake(*ends[::-1], folder=tmp_path) == b"welcome"


@pytest.mark.parametrize("days", [-31.05, 1.05])
@pytest.mark.parametrize("old", ["server", "client"])
def test_a_certificate_of_another_time(days: float, old: str, tmp_path: Path):
    ends = {"server": certificates(own=5), "client": certificates(own=6)}
    ends |= {old: certificates(own=7, now=time.time() + 86_400 * days)}
    with pytest.raises(ssl.SSLError, match=r"(?i)expired|not yet valid|certificate"):
        shake(**ends, folder=tmp_path)


@pytest.mark.parametrize("stranger", ["server", "client"])
def test_the_uninvited(tmp_path: Path, stranger: str):
    ends = {"server": certificates(own=5), "client": certificates(own=6)} | {stranger: certificates(secret=2)}
    with pytest.raises(ssl.SSLError, match=r"(?i)certificate|signature"):
        shake(**ends, folder=tmp_path)


@pytest.mark.parametrize("stranger", ["server", "client"])
def test_who_only_knows_the_authoritys_certificate(tmp_path: Path, stranger: str):
    """Any server shows it; without its key nothing can be signed."""
    ends = {"server": certificates(own=5), "client": certificates(own=6)}
    ends[stranger] = certificates(secret=2)._replace(authority=ends["server"].authority)
    with pytest.raises(ssl.SSLError, match=r"(?i)certificate|signature"):
        shake(**ends, folder=tmp_path)


def test_a_member_cannot_make_an_authority(tmp_path: Path):
    """What a member's own key signs is not taken: its certificate is no authority's."""
    import datetime

    from cryptography import x509
    from cryptography.hazmat.primitives.asymmetric.ed25519 import Ed25519PrivateKey
    from cryptography.hazmat.primitives.serialization import Encoding, load_pem_private_key

    member = certificates(own=6)
    key, parent = load_pem_private_key(member.key, None), x509.load_pem_x509_certificate(member.certificate)
    assert isinstance(key, Ed25519PrivateKey)
    child = (
        x509.CertificateBuilder()
        .subject_name(parent.subject)
        .issuer_name(parent.subject)
        .public_key(key.public_key())
        .serial_number(7)
        .not_valid_before(datetime.datetime(2000, 1, 1, tzinfo=datetime.UTC))
        .not_valid_after(datetime.datetime(2100, 1, 1, tzinfo=datetime.UTC))
        .sign(key, None)
    )
    chain = child.public_bytes(Encoding.PEM) + member.certificate
    with pytest.raises(ssl.SSLError, match=r"(?i)certificate"):
        shake(certificates(own=5), member._replace(certificate=chain), tmp_path)


def test_a_certificate_for_each_member_and_one_authority():
    one, two = certificates(own=5), certificates(own=6)
    assert one.authority == two.authority != certificates(secret=2).authority
    assert one.certificate != two.certificate
    assert one.key != two.key
    assert "KEY" not in repr(one)
