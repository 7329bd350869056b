"""The agreement's code against a network that does what it likes, and a third member that means harm.

Two honest members agree in two sessions. The network holds every message ever said and hands any of them to any end,
also changed, in any order and number. The third member has their secret, and pretends to be either to the other.
"""

from collections.abc import Callable

import pytest
from cryptography.hazmat.primitives.asymmetric.x25519 import X25519PrivateKey
from hypothesis import HealthCheck, Phase, settings
from hypothesis import strategies as st
from hypothesis.stateful import RuleBasedStateMachine, precondition, rule, run_state_machine_as_test
from tests.live.support import entropy, identities
from tests.samples import written

from cotouch.samples import Agreement, Identity, LinkKeys

ALICE, BOB, MALLORY = sorted(identities(3), key=lambda who: who.public)
FIXED = X25519PrivateKey.from_private_bytes(bytes(range(32)))
QUIET = settings(
    max_examples=100,
    stateful_step_count=40,
    derandomize=True,
    deadline=None,
    database=None,
    phases=[Phase.generate],
    suppress_health_check=list(HealthCheck),
)


class End:
    """One end of a link in one session, and what it came to."""

    def __init__(self, own: Identity, other: Identity, session: bytes, number: int, *, pretends: "End | None") -> None:
        self.pretends, self.signatures = pretends, dict[int, bytes]()
        self.honest, self.session, self.pair = pretends is None, session, frozenset((own.public, other.public))
        self.agreement = Agreement(
            identity=own, other=other.public, session=session, connection=number, entropy=entropy(number), secret=b"all"
        )
        if pretends is not None:  # everything but the signature of whom it pretends to be
            for name in ("initiator", "_context", "_secret", "_tag_key"):
                setattr(self.agreement, name, getattr(pretends.agreement, name))
        self.accepted: list[LinkKeys] = []

    @property
    def keys(self) -> set[bytes]:
        return {keys.sending.key for keys in self.accepted}


class Network(RuleBasedStateMachine):
    """Moves messages; after each, the goals must hold."""

    def __init__(self) -> None:
        super().__init__()
        self.ends: list[End] = []
        for number, session in enumerate((b"one", b"two")):
            honest = [
                End(ALICE, BOB, session, 10 * number + 1, pretends=None),
                End(BOB, ALICE, session, 10 * number + 2, pretends=None),
            ]
            self.ends += honest
            self.ends += [
                End(MALLORY, BOB, session, 10 * number + 3, pretends=honest[0]),
                End(MALLORY, ALICE, session, 10 * number + 4, pretends=honest[1]),
            ]
        self.said: list[bytes] = []

    @rule(which=st.integers(0, 3))
    def start(self, which: int) -> None:
        beginning = [end for end in self.ends if end.agreement.initiator]
        self.say(beginning[which], beginning[which].agreement.start())

    @precondition(lambda self: self.said)
    @rule(back=st.integers(0, 3) | st.integers(0, 40), first=st.integers(0, 7))
    def hand_to_all(self, back: int, first: int) -> None:
        message = self.said[-1 - back % len(self.said)]
        for end in self.ends[first:] + self.ends[:first]:
            self.deliver(end, message)

    @precondition(lambda self: self.said)
    @rule(back=st.integers(0, 40), to=st.integers(0, 7), at=st.none() | st.integers(0, 200))
    def hand_to_one(self, back: int, to: int, at: int | None) -> None:
        message = bytearray(self.said[-1 - back % len(self.said)])
        if at is not None:
            message[at % len(message)] ^= 1
        self.deliver(self.ends[to], bytes(message))

    def say(self, end: End, message: bytes) -> None:
        if message in self.said:
            return
        self.said.append(message)
        whom, kind = end.pretends, message[4]
        end.signatures[kind] = message
        if whom is None or kind not in whom.signatures:
            return
        # Who pretends takes a signature that it heard, and goes on from what it made.
        at = len(message) - (80 if kind == 1 else 112)  # signature and tag, and where there are keys their proof
        made = message[:at] + whom.signatures[kind][at : at + 64] + message[at + 64 : -16]
        about = written.context(end.session, ALICE.public, BOB.public)
        self.said.append(written.tagged(made, about, b"all"))
        if kind == 1:
            assert end.agreement._hello is not None
            end.agreement._hello = (made, end.agreement._hello[1])

    def deliver(self, end: End, message: bytes) -> None:
        progress = end.agreement.receive(message)
        if progress.message is not None:
            self.say(end, progress.message)
        if progress.keys is not None:
            self.came(end, progress.keys)

    def came(self, end: End, keys: LinkKeys) -> None:
        assert all(keys.epoch > earlier.epoch for earlier in end.accepted), "an epoch came again"
        assert keys.sending.key not in end.keys, "keys were taken twice"
        end.accepted.append(keys)
        if not end.honest:
            return
        (partner,) = (one for one in self.ends if one.honest and one.session == end.session and one is not end)
        theirs = {made.keys.receiving.key for made in partner.agreement._pending.values()} | {
            made.receiving.key for made in partner.accepted
        }
        assert keys.sending.key in theirs, "keys that the partner does not have"
        for other in self.ends:
            shared = any(keys.sending.key in (one.sending.key, one.receiving.key) for one in other.accepted)
            assert other in (end, partner) or not shared, "keys that another has"
        if not end.agreement.initiator:
            assert keys.sending.key in {one.receiving.key for one in partner.accepted}, "nobody confirmed"


@pytest.mark.slow
def test_nothing_goes_wrong_whatever_the_network_does():
    run_state_machine_as_test(Network, settings=QUIET)


def unsigned(patch: pytest.MonkeyPatch) -> None:
    patch.setattr(Agreement, "_signed", lambda *_: True)


def sessionless(patch: pytest.MonkeyPatch) -> None:
    made = Agreement.__init__

    def init(self: Agreement, **given: object) -> None:
        made(self, **given | {"session": b"any"})  # pyright: ignore[reportArgumentType]

    patch.setattr(Agreement, "__init__", init)


def transcriptless(patch: pytest.MonkeyPatch) -> None:
    """Signatures that cover no more than which message it is."""
    signed, sign = Agreement._signed, Agreement._sign
    patch.setattr(Agreement, "_signed", lambda self, what, _, signature: signed(self, what, b"", signature))
    patch.setattr(Agreement, "_sign", lambda self, what, _: sign(self, what, b""))


def stale(patch: pytest.MonkeyPatch) -> None:
    """Keys that follow from less than both ephemerals: the same in every epoch."""
    patch.setattr(
        Agreement,
        "_derive",
        lambda self, _e, _t, said, epoch, number, made=Agreement._derive: made(
            self, FIXED, FIXED.public_key().public_bytes_raw(), b"", epoch, number
        ),
    )


@pytest.mark.slow
@pytest.mark.parametrize("less", [unsigned, sessionless, transcriptless, stale])
def test_the_network_finds_what_is_left_out(less: Callable[[pytest.MonkeyPatch], None]):
    with pytest.MonkeyPatch.context() as patch:
        less(patch)
        with pytest.raises(AssertionError):
            # It ends with the first that is found.
            run_state_machine_as_test(Network, settings=settings(QUIET, max_examples=1000))
