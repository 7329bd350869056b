"""The sample plane: what sealing costs, from sample to sample over loopback, and the work of five neighbours.

Two processes, 1 kHz, 1.2 kB; raw and sealed datagrams take turns, so that other work weighs on both alike.
"""

import contextlib
import json
import os
import select
import socket
import struct
import subprocess
import sys
import time
from time import perf_counter_ns

import numpy as np

from benchmarks._report import Row, command, interleave
from cotouch.peer import Sample
from cotouch.samples import (
    OVERHEAD,
    Agreement,
    Assembly,
    Heading,
    Identity,
    Layout,
    LinkKeys,
    SampleCodec,
    SampleLink,
    SamplePlane,
    SealedLink,
    SendRate,
    UdpTransport,
)

LAYOUT = Layout(rows=44, width=4, axes=3)  # one datagram of 1,180 bytes; one node more takes two
STATE = np.pad(np.random.default_rng(0).normal(0.0, 0.1, (LAYOUT.rows, 3)), ((0, 0), (0, 1)))
HEADING = Heading(0, 0, 1, 0.0, 0.001)
SECONDS = 20.0
STAMP = struct.Struct("<d")
RAW_BYTES = 1180
# What is sealed of it: heading and state.
PLAIN_BYTES = RAW_BYTES - OVERHEAD


def agree(one: int, two: int) -> dict[int, LinkKeys]:
    """Keys of a link between two users, from seeds, so that two processes make the same."""
    rng = np.random.default_rng([one, two])
    members = {user: Identity.make(np.random.default_rng(user).bytes) for user in (one, two)}
    ends = {
        user: Agreement(
            identity=members[user], other=members[other].public, session=b"", connection=other, entropy=rng.bytes
        )
        for user, other in ((one, two), (two, one))
    }
    first, second = sorted(ends, key=lambda user: not ends[user].initiator)
    reply = ends[second].receive(ends[first].start())
    confirm = ends[first].receive(reply.message or b"")
    done = ends[second].receive(confirm.message or b"")
    assert confirm.keys
    assert done.keys
    return {first: confirm.keys, second: done.keys}


def link_to(user: int, other: int) -> SampleLink:
    link = SampleLink(Assembly(LAYOUT, sender=other, initial=np.zeros((LAYOUT.rows, 4))), rate=SendRate(lowest=1000.0))
    link.seal.install(agree(*sorted((user, other)))[user])
    return link


def receive(port_raw: int, port_sealed: int, seconds: float) -> None:
    """The other process: prints the seconds from sample to sample, raw and sealed."""
    raw = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    raw.bind(("127.0.0.1", port_raw))
    raw.setblocking(False)
    transport = UdpTransport(port=port_sealed)
    plane = SamplePlane(transport, LAYOUT, user=1)
    link = link_to(1, 0)
    plane.connect(0, link)
    print("ready", flush=True)
    times: tuple[list[float], list[float]] = ([], [])
    end = time.monotonic() + seconds + 1.0
    while time.monotonic() < end:
        ready, _, _ = select.select([raw, transport], [], [], 0.2)
        for source in ready:
            if source is raw:
                payload = raw.recv(2000)
                state = np.frombuffer(payload, offset=8, count=3 * LAYOUT.rows)
                del state
                times[0].append(time.monotonic() - STAMP.unpack_from(payload)[0])
            elif plane.poll(time.monotonic()):
                times[1].append(time.monotonic() - link.assembly.oldest)
    print(json.dumps(times), flush=True)


def latency() -> list[Row]:
    with (
        socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as one,
        socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as two,
    ):
        for probe in (one, two):
            probe.bind(("127.0.0.1", 0))
        ports = one.getsockname()[1], two.getsockname()[1]
    code = f"from benchmarks.live import receive; receive({ports[0]}, {ports[1]}, {SECONDS})"
    with subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE) as child:
        assert child.stdout
        child.stdout.readline()
        raw = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        transport = UdpTransport()
        plane = SamplePlane(transport, LAYOUT, user=0)
        plane.connect(1, link_to(0, 1), at=("127.0.0.1", ports[1]))
        body, begin, busy = bytes(RAW_BYTES - 8), time.monotonic(), [0, 0]
        for k in range(round(2000 * SECONDS)):
            due = begin + 0.0005 * (k + 1)
            time.sleep(max(0.0, due - time.monotonic() - 0.0001))
            while (now := time.monotonic()) < due:
                pass
            then = perf_counter_ns()
            if k % 2:
                plane.send(now, Sample(sender=0, index=k, stamp=now, position=STATE), 0.001)
            else:
                raw.sendto(STAMP.pack(now) + body, ("127.0.0.1", ports[0]))
            busy[k % 2] += perf_counter_ns() - then
        seen = [np.array(times) for times in json.loads(child.stdout.readline())]
        raw.close()
        transport.close()
    rows, marks = [], (50, 99, 99.9)
    values = [np.percentile(times * 1e6, marks) for times in seen]
    for name, times, value in zip(("raw UDP", "sealed, as used"), seen, values, strict=True):
        numbers = " / ".join(f"{number:,.0f}" for number in value)
        rows.append(
            Row(
                "live",
                f"sample to sample, 1.2 kB, 1 kHz: {name}, p50 / p99 / p99.9",
                f"{numbers} µs",
                "",
                f"{len(times):,} of {round(1000 * SECONDS):,} arrived",
            )
        )
    beside = f"{values[1][0] / values[0][0]:.2f} ×; coding, sealing, opening, checking and assembling included"
    rows.append(Row("live", "— sealed compared with raw, p50", f"+{values[1][0] - values[0][0]:.0f} µs", "", beside))
    each = [spent / (1e6 * SECONDS) for spent in busy]
    note = f"raw {each[0]:.0f} µs; once a millisecond; in a loop it takes what the next rows say"
    rows.append(Row("live", "— of which in the sender", f"{each[1]:.0f} µs", "", note))
    return rows


def costs() -> list[Row]:
    from cryptography.hazmat.primitives.ciphers.aead import AESGCM, ChaCha20Poly1305

    one, two = SealedLink(), SealedLink()
    keys = agree(0, 1)
    one.install(keys[0])
    two.install(keys[1])
    codec, assembly = SampleCodec(LAYOUT), Assembly(LAYOUT, sender=0, initial=np.zeros((LAYOUT.rows, 4)))
    count, body = 0, codec.write(STATE).bodies[0]

    def send() -> bytes:
        nonlocal count
        count += 1
        return one.seal(codec.datagram(HEADING._replace(step=count, stamp=float(count)), 0, body)) or b""

    def both() -> None:
        opened = two.open(send(), 0.0)
        assembly.take(codec.read(opened.payload, epoch=0, sender=0))

    payload, head, nonce = bytes(PLAIN_BYTES), bytes(16), bytes(12)
    ciphers = {"AES-128-GCM": AESGCM(bytes(16)), "AES-256-GCM": AESGCM(bytes(32))}
    ciphers |= {"ChaCha20-Poly1305": ChaCha20Poly1305(bytes(32))}
    alone = {
        name: lambda cipher=cipher: cipher.decrypt(nonce, cipher.encrypt(nonce, payload, head), head)
        for name, cipher in ciphers.items()
    }
    three, four = SealedLink(), SealedLink()
    three.install(keys[0])
    four.install(keys[1])
    noise = three.seal(bytes(PLAIN_BYTES)) or b""
    noise = noise[:-1] + bytes([noise[-1] ^ 1])
    work = {"write": lambda: codec.write(STATE), "send": send, "both": both, "forged": lambda: four.open(noise, 0.0)}
    dtls = _dtls()
    if dtls is not None:
        alone["DTLS 1.2 through pyOpenSSL"] = dtls
    seconds = {name: 1e6 * float(np.median(times)) for name, times in interleave(work | alone, 30, least=0.01).items()}
    rows = [
        Row("live", f"writing a state of {LAYOUT.rows} nodes, once for all neighbours", f"{seconds['write']:.1f} µs"),
        Row("live", "header and sealing, per neighbour", f"{seconds['send']:.1f} µs"),
        Row("live", "opening, reading, checking and assembling", f"{seconds['both'] - seconds['send']:.1f} µs"),
        Row("live", "refusing a forged datagram", f"{seconds['forged']:.1f} µs"),
    ]
    rows += [Row("live", f"— cipher alone, round trip: {name}", f"{seconds[name]:.1f} µs") for name in alone]
    return rows


def _dtls() -> object:
    """One datagram there and back through DTLS in memory, the handshake done; None without pyOpenSSL."""
    try:
        from OpenSSL import SSL, crypto
    except ImportError:
        return None
    import datetime

    from cryptography import x509
    from cryptography.hazmat.primitives.asymmetric import ec
    from cryptography.hazmat.primitives.hashes import SHA256

    key = ec.generate_private_key(ec.SECP256R1())
    name = x509.Name([x509.NameAttribute(x509.NameOID.COMMON_NAME, "bench")])
    now = datetime.datetime.now(tz=datetime.UTC)
    made = x509.CertificateBuilder(name, name, key.public_key(), 1, now, now + datetime.timedelta(days=1))
    certificate = made.sign(key, SHA256())
    ends = []
    for server in (False, True):
        context = SSL.Context(SSL.DTLS_METHOD)
        context.use_certificate(crypto.X509.from_cryptography(certificate))
        context.use_privatekey(crypto.PKey.from_cryptography_key(key))
        context.set_verify(SSL.VERIFY_NONE, lambda *_: True)
        end = SSL.Connection(context, None)
        end.set_ciphertext_mtu(1400)
        (end.set_accept_state if server else end.set_connect_state)()
        ends.append(end)

    def pump(source: SSL.Connection, sink: SSL.Connection) -> None:
        with contextlib.suppress(SSL.WantReadError):
            while True:
                sink.bio_write(source.bio_read(65536))

    for _ in range(20):
        for end, other in (ends, ends[::-1]):
            with contextlib.suppress(SSL.WantReadError):
                end.do_handshake()
            pump(end, other)
    payload = bytes(PLAIN_BYTES)

    def there_and_back() -> bytes:
        ends[0].send(payload)
        ends[1].bio_write(ends[0].bio_read(2000))
        return ends[1].recv(2000)

    return there_and_back


def neighbours(count: int = 5, steps: int = 3000) -> list[Row]:
    """CPU of one user's plane: the others send in the same process, but outside the stopwatch."""
    transports = [UdpTransport() for _ in range(count + 1)]
    planes = [SamplePlane(transport, LAYOUT, user=user) for user, transport in enumerate(transports)]
    for other in range(1, count + 1):
        planes[0].connect(other, link_to(0, other), at=transports[other].address)
        planes[other].connect(0, link_to(other, 0), at=transports[0].address)
    taken, useful, begin = np.zeros((steps, 2)), 0, time.monotonic()
    for k in range(steps):
        time.sleep(max(0.0, begin + 0.001 * k - time.monotonic()))
        for plane in planes[1:]:
            now = time.monotonic()
            plane.poll(now)
            plane.stepped(now)
            plane.send(now, Sample(sender=plane.user, index=k, stamp=now, position=STATE), 0.001)
        now, then = time.monotonic(), perf_counter_ns()
        useful += planes[0].poll(now)
        planes[0].stepped(now)
        middle = perf_counter_ns()
        planes[0].send(now, Sample(sender=0, index=k, stamp=now, position=STATE), 0.001)
        taken[k] = middle - then, perf_counter_ns() - middle
    for transport in transports:
        transport.close()
    reading, sending = np.median(taken, axis=0) / 1e3
    total = float(np.median(taken.sum(axis=1))) / 1e3
    return [
        Row(
            "live", f"{count} neighbours, 1.2 kB each way, every step", f"{total:.0f} µs", "",
            f"reading {reading:.0f}, sending {sending:.0f}; {total / 10:.1f} % of a core at 1 kHz; {useful:,} used",
        )
    ]  # fmt: skip


def measure() -> list[Row]:
    assert LAYOUT.chunks == 1
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    return [*latency(), *costs(), *neighbours()]


if __name__ == "__main__":
    command(measure, __doc__)
