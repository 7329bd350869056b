"""Two members get the same keys; everybody else gets nothing, whatever is done to the messages."""

import copy
import pickle

import pytest
from cryptography.hazmat.primitives.asymmetric.x25519 import X25519PrivateKey
from hypothesis import given
from hypothesis import strategies as st
from tests.live.support import SESSION, agree, agreements, entropy, identities, in_a_fork
from tests.samples import written

from cotouch.errors import SessionError
from cotouch.samples import Agreement, Identity


def test_both_ends_get_the_same_keys_of_each_direction():
    initiator, responder = agreements(*identities())
    one, two = agree(initiator, responder)
    assert one.sending == two.receiving
    assert one.receiving == two.sending
    assert one.sending.key != one.receiving.key
    assert one.sending.iv != one.receiving.iv
    assert one.epoch == two.epoch == 1
    assert (one.wait, two.wait) == (True, False)


def test_every_agreement_gives_new_keys_and_a_later_epoch():
    initiator, responder = agreements(*identities())
    keys = [agree(initiator, responder)[0] for _ in range(5)]
    assert [made.epoch for made in keys] == [1, 2, 3, 4, 5]
    assert len({made.sending.key for made in keys}) == 5


def test_who_starts_anew_after_a_crash_gets_a_later_epoch_too():
    first, second = identities()
    initiator, responder = agreements(first, second)
    agree(initiator, responder)
    again, fresh_responder = agreements(first, second, seed=77)
    assert agree(again, responder)[0].epoch == 2  # the initiator crashed
    assert agree(initiator, fresh_responder)[0].epoch == 2  # the responder did


@pytest.mark.parametrize("side", [0, 1])
def test_exactly_one_end_begins(side: int):
    ends = agreements(*identities())
    assert [end.initiator for end in ends] == [True, False]
    with pytest.raises(SessionError, match="does not start the agreement"):
        ends[1].start()


def test_another_session_or_secret_gives_nothing():
    first, second = sorted(identities(), key=lambda who: who.public)
    initiator, responder = agreements(first, second, session=(b"this", b"that"))
    assert responder.receive(initiator.start()).refused == "another session, secret or other members"
    initiator, responder = agreements(first, second, secret=(b"invited", b"guessed"))
    assert responder.receive(initiator.start()).refused == "another session, secret or other members"
    # As if the MAC proved nothing: somebody on the way makes it true at either end.
    about = written.context(SESSION, first.public, second.public)
    reply = responder.receive(written.tagged(initiator.start()[: -written.TAG], about, b"guessed")).message
    assert reply is not None
    assert initiator.receive(written.tagged(reply[: -written.TAG], about, b"invited")).refused == "another secret"


def test_without_the_secret_nothing_is_spent(monkeypatch: pytest.MonkeyPatch):
    """Neither a signature is looked at nor a key agreed on, whatever comes."""
    first, second = sorted(identities(), key=lambda who: who.public)
    initiator, responder = agreements(first, second, secret=(b"guessed", b"invited"))
    hello = initiator.start()
    spent: list[str] = []
    for name in ("_signed", "_derive"):
        monkeypatch.setattr(Agreement, name, lambda *_, name=name: spent.append(name))
    for message in (hello, hello[:-1] + b"x", b"ctk1\1".ljust(len(hello), b"x")):
        assert responder.receive(message).refused == "another session, secret or other members"
    assert spent == []
    about = written.context(SESSION, first.public, second.public)
    responder.receive(written.tagged(hello[: -written.TAG], about, b"invited"))
    assert spent == ["_signed"]


def test_another_member_cannot_speak_for_one():
    """Mallory is a member, knows session and secret, and answers in Bob's place or greets in Alice's."""
    alice, bob, mallory = sorted(identities(3), key=lambda who: who.public)
    to_bob = Agreement(identity=alice, other=bob.public, session=b"s", connection=1, entropy=entropy(1))
    from_alice = Agreement(identity=bob, other=alice.public, session=b"s", connection=2, entropy=entropy(2))
    as_bob = Agreement(identity=mallory, other=alice.public, session=b"s", connection=3, entropy=entropy(3))
    hello = to_bob.start()
    assert as_bob.receive(hello).refused == "another session, secret or other members"
    # Mallory can write anything but a signature.
    about = written.context(b"s", alice.public, bob.public)
    ephemeral = X25519PrivateKey.from_private_bytes(entropy(4)(32)).public_key().public_bytes_raw()
    forged = written.tagged(written.reply(mallory, ephemeral, hello[: -written.TAG]), about)
    assert to_bob.receive(forged).refused == "signature"
    assert from_alice.receive(written.tagged(written.hello(mallory, ephemeral, about), about)).refused == "signature"
    # Neither did any harm.
    assert agree(to_bob, from_alice)[0].epoch == 1


def test_an_old_hello_leads_to_no_keys_and_disturbs_nothing():
    initiator, responder = agreements(*identities())
    old = [initiator.start() for _ in range(20)]
    hello = initiator.start()
    replies = [responder.receive(message).message for message in old[:10]]
    # It remembers four, and answers them as before.
    assert [responder.receive(message).message for message in old[6:10]] == replies[6:]
    assert responder.receive(old[5]).message not in {None, replies[5]}
    reply = responder.receive(hello).message
    for message in old[10:13]:
        assert responder.receive(message).keys is None
    confirm = initiator.receive(reply)
    assert responder.receive(confirm.message).keys is not None
    assert responder.receive(hello).message not in {None, reply}  # it remembers none of them any more


@pytest.mark.parametrize("others", [3, 4])
def test_what_was_replied_before_four_others_cannot_be_confirmed(others: int):
    initiator, responder = agreements(*identities())
    confirm = initiator.receive(responder.receive(initiator.start()).message).message
    for _ in range(others):
        responder.receive(initiator.start())
    confirmed = responder.receive(confirm)
    assert confirmed.refused == (None if others < 4 else "no confirmation of what was replied")


def test_what_was_replied_before_keys_were_agreed_on_cannot_be_confirmed():
    initiator, responder = agreements(*identities())
    earlier, later = (initiator.receive(responder.receive(initiator.start()).message).message for _ in range(2))
    assert responder.receive(later).keys is not None
    assert responder.receive(earlier).refused == "no confirmation of what was replied"


def test_messages_may_be_doubled():
    initiator, responder = agreements(*identities())
    hello = initiator.start()
    reply = responder.receive(hello).message
    assert responder.receive(hello).message == reply
    confirm = initiator.receive(reply)
    assert initiator.receive(reply).refused == "no reply to the last hello"
    keys = responder.receive(confirm.message).keys
    assert keys is not None
    assert responder.receive(confirm.message).refused == "no confirmation of what was replied"


def test_a_captured_exchange_is_worth_nothing_later():
    """All of it is said again, to both ends as they are and as they are after a crash."""
    first, second = identities()
    initiator, responder = agreements(first, second)
    hello = initiator.start()
    reply = responder.receive(hello).message
    confirm = initiator.receive(reply).message
    responder.receive(confirm)
    fresh = agreements(first, second, seed=9)
    fresh[0].start()
    for end in (initiator, responder, *fresh):
        assert all(end.receive(message).keys is None for message in (hello, reply, confirm))


@pytest.mark.parametrize("point", [bytes(32), b"\1" + bytes(31), b"\xec" + b"\xff" * 30 + b"\x7f"])
def test_a_point_of_small_order_is_refused(point: bytes, monkeypatch: pytest.MonkeyPatch):
    """A member that makes the keys foreseeable, and signs for it."""
    first, second = sorted(identities(), key=lambda who: who.public)
    _, responder = agreements(first, second)
    about = written.context(SESSION, first.public, second.public)
    assert responder.receive(written.tagged(written.hello(first, point, about), about)).refused == "ephemeral key"


@pytest.mark.parametrize("which", range(3))
def test_no_byte_can_be_changed(which: int):
    """Neither end gets keys, and the true message still leads to them."""
    initiator, responder = agreements(*identities())
    hello = initiator.start()
    messages, ends = [hello], [responder, initiator, responder]
    for end in ends[:which]:
        messages.append(end.receive(messages[-1]).message)
    for at in range(len(messages[which])):
        changed = bytearray(messages[which])
        changed[at] ^= 1
        result = ends[which].receive(bytes(changed))
        assert result.refused is not None
        assert result.keys is None
    for end, message in zip(ends[which:], range(which, 3), strict=True):
        result = end.receive(messages[message])
        messages.append(result.message)
    assert result.keys is not None


@given(st.binary(max_size=250))
def test_noise_is_refused(noise: bytes):
    for end in agreements(*identities()):
        for message in (noise, b"ctk1" + noise, (b"ctk1\1" + noise).ljust(141, b"\0"), (b"ctk1\3" + noise).ljust(133)):
            assert end.receive(message).refused is not None


@pytest.mark.parametrize("other", [b"", bytes(31), None])
def test_a_wrong_key_is_named(other: bytes | None):
    (mine,) = identities(1)
    with pytest.raises(SessionError, match="32 bytes"):
        Agreement(
            identity=mine,
            other=other if other is not None else mine.public,
            session=b"s",
            connection=1,
            entropy=entropy(1),
        )


def test_a_wrong_connection_is_named():
    first, second = identities()
    with pytest.raises(SessionError, match="connection 4294967296"):
        Agreement(identity=first, other=second.public, session=b"s", connection=1 << 32, entropy=entropy(1))


def test_secrets_are_not_printed():
    (mine,) = identities(1)
    keys, _ = agree(*agreements(*identities()))
    assert repr(mine.secret) not in repr(mine)
    assert "key" not in repr(keys.sending)
    assert repr(keys.sending.key) not in repr(keys)
    with pytest.raises(SessionError, match="has 3 bytes"):
        Identity(b"abc")


def test_a_forked_process_and_a_copy_agree_on_nothing():
    initiator, responder = agreements(*identities())
    for copied in (copy.copy, copy.deepcopy, pickle.dumps):
        with pytest.raises(SessionError, match="Agreement cannot be copied: nonces would be used twice"):
            copied(initiator)
    hello = initiator.start()

    def child() -> bool:
        refused = responder.receive(hello).refused == "not a message for this end"
        try:
            initiator.start()
        except SessionError:
            return refused
        return False

    assert in_a_fork(child)
    assert responder.receive(hello).message is not None


@pytest.mark.parametrize("epoch", [2**16 + 1, 2**31 - 2, 2**31 + 5, 2**32 - 2])
def test_an_epoch_that_leaps_is_refused_by_either_end(epoch: int):
    """Else the first agreement with a liar would be its last: no epoch would be left for new keys."""
    one, two = identities()
    initiator, responder = agreements(one, two)
    initiator.epoch = epoch
    assert responder.receive(initiator.start()).refused == "epoch"
    initiator, responder = agreements(one, two)
    responder.epoch = epoch
    reply = responder.receive(initiator.start())
    assert reply.message is None or initiator.receive(reply.message).refused is not None
    assert initiator.epoch == 0
