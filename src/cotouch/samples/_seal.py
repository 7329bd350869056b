"""Datagrams sealed for one link: AES-128-GCM under keys of one direction and one epoch.

A sealed datagram is a header of 16 bytes, the ciphertext, and a tag of 16 bytes::

    version u8 | 0 u8 | epoch of keys, low 16 bits u16 | connection u32 | sequence u64        (big-endian)

The header is authenticated with the rest. The nonce is the sequence number added (xor) to the direction's iv, as in
TLS 1.3 [RFC 8446, section 5.3]; a number is used once, and the keys of two directions or two epochs have nothing in
common. Nothing of a datagram is believed before its tag fits, and a refused one changes nothing.
"""

import struct
from typing import NamedTuple, final

from cryptography.exceptions import InvalidTag
from cryptography.hazmat.primitives.ciphers.aead import AESGCM

from cotouch.samples._chunk import Refusal
from cotouch.samples._keys import DirectionKeys, LinkKeys
from cotouch.samples._replay import ReplayWindow
from cotouch.samples._unique import Unique

VERSION = 0xC1
HEADER = struct.Struct(">BBHIQ")
TAG_BYTES = 16
OVERHEAD = HEADER.size + TAG_BYTES
# AES-GCM hides what it should for 2^28 datagrams of this size under one key [RFC 9001, appendix B.1]; half of it, with
# no hurry, is when new keys are asked for. At 1 kHz and five chunks that is after 7 hours.
MOST_SEALED = 1 << 28
RENEW_AFTER = MOST_SEALED // 2
# And after an hour, however little was sealed: a key that leaks opens no more than that. An agreement costs each end a
# millisecond, so this could be more often; TLS and WireGuard live with from two minutes to a day [s].
RENEW_EVERY = 3600.0
# How long datagrams of the epoch before are still opened, once the other end is heard in the new one: longer than any
# of them is worth anything [s].
_GRACE = 2.0


class Opened(NamedTuple):
    """A datagram whose seal was verified.

    Attributes:
        payload: what the other end sealed.
        newest: whether nothing later of it was seen; only then its address is believed.
    """

    payload: bytes
    newest: bool


class _Receiving(NamedTuple):
    epoch: int
    cipher: AESGCM
    iv: int
    window: ReplayWindow


class _Sending(NamedTuple):
    epoch: int
    cipher: AESGCM
    iv: int
    connection: int


def connection_of(datagram: bytes) -> int | Refusal:
    """The link to which a datagram claims to belong; none of it is verified yet."""
    if len(datagram) < OVERHEAD:
        return Refusal.SHORT
    version, reserved, _, connection, _ = HEADER.unpack_from(datagram)
    return connection if version == VERSION and reserved == 0 else Refusal.VERSION


@final
class SealedLink(Unique):
    """Seals and opens the datagrams of one link, across epochs of keys. In a forked process it seals nothing."""

    def __init__(self) -> None:
        """Begins without keys."""
        super().__init__()
        self._since: float | None = None
        self._sending: _Sending | None = None
        self._next: _Sending | None = None
        self._receiving: list[_Receiving] = []
        self._connection: int | None = None
        self._sequence = 0
        self._retire = float("inf")

    @property
    def connection(self) -> int | None:
        """Number of the link at this end; None without keys."""
        return self._connection

    @property
    def epoch(self) -> int:
        """Of the newest keys; 0 without."""
        return self._receiving[0].epoch if self._receiving else 0

    @property
    def sealed(self) -> int:
        """Datagrams sealed with the present keys; also the number of the next one."""
        return self._sequence

    @property
    def received(self) -> tuple[int, int]:
        """Greatest sequence number opened in the newest epoch (-1: none), and how many were."""
        if not self._receiving:
            return -1, 0
        window = self._receiving[0].window
        return window.newest, window.count

    def wants_keys(self, now: float) -> bool:
        """Whether it is time to agree on new keys.

        Args:
            now: time, never backwards; keys age from the first call after they came [s].
        """
        if self._since is None:
            self._since = now
        return self._sending is None or self._sequence >= RENEW_AFTER or now >= self._since + RENEW_EVERY

    def install(self, keys: LinkKeys) -> None:
        """Takes the keys of a new epoch; those of the last one still open until the other end is heard in the new one.

        Keys of an epoch that is not later than the present one are ignored, as a replayed agreement would give.
        """
        if keys.epoch <= self.epoch:
            return
        self._since = None
        self._connection = keys.receiving.connection
        cipher, iv = _cipher(keys.receiving)
        self._receiving = [_Receiving(keys.epoch, cipher, iv, ReplayWindow()), *self._receiving[:1]]
        self._retire = float("inf")
        sending = _Sending(keys.epoch, *_cipher(keys.sending), keys.sending.connection)
        if keys.wait and self._sending is not None:
            self._next = sending
        else:
            self._switch(sending)

    def seal(self, payload: bytes) -> bytes | None:
        """The sealed datagram, `OVERHEAD` longer; None without keys, when they are used up, or in a forked process."""
        sending, sequence = self._sending, self._sequence
        if sending is None or sequence >= MOST_SEALED or not self.here:
            return None
        self._sequence = sequence + 1
        header = HEADER.pack(VERSION, 0, sending.epoch & 0xFFFF, sending.connection, sequence)
        return header + sending.cipher.encrypt((sending.iv ^ sequence).to_bytes(12, "big"), payload, header)

    def open(self, datagram: bytes, now: float) -> Opened | Refusal:
        """What the other end sealed, or why this is not it.

        Args:
            datagram: as it arrived.
            now: time, never backwards [s].
        """
        if len(datagram) < OVERHEAD:
            return Refusal.SHORT
        version, reserved, epoch, connection, sequence = HEADER.unpack_from(datagram)
        if version != VERSION or reserved != 0:
            return Refusal.VERSION
        if connection != self._connection:
            return Refusal.CONNECTION
        if now >= self._retire:
            del self._receiving[1:]
        receiving, present = self._receiving[0], True
        if receiving.epoch & 0xFFFF != epoch:
            receiving, present = self._receiving[-1], False
            if receiving.epoch & 0xFFFF != epoch:
                return Refusal.EPOCH_OF_KEYS
        window = receiving.window
        if sequence >= MOST_SEALED or not window.fresh(sequence):
            return Refusal.REPLAYED
        nonce = (receiving.iv ^ sequence).to_bytes(12, "big")
        try:
            payload = receiving.cipher.decrypt(nonce, datagram[16:], datagram[:16])
        except InvalidTag:
            return Refusal.FORGED
        newest = present and sequence > window.newest
        window.mark(sequence)
        if present and self._retire == float("inf"):
            self._received_in_new_epoch(now)
        return Opened(payload, newest)

    def _received_in_new_epoch(self, now: float) -> None:
        self._retire = now + _GRACE
        if self._next is not None:
            self._switch(self._next)

    def _switch(self, sending: _Sending) -> None:
        self._sending, self._next, self._sequence = sending, None, 0


def _cipher(keys: DirectionKeys) -> tuple[AESGCM, int]:
    return AESGCM(keys.key), int.from_bytes(keys.iv, "big")
