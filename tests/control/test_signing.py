"""Signed messages: taken whole, once, and from whom they are; everything else is refused by name."""

import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.live.support import entropy, identities

from cotouch.control import MOST_BODY, MOST_MESSAGE, MessageReader, MessageRefusal, MessageWriter, SignedMessage
from cotouch.errors import SessionError
from cotouch.samples import Identity

SESSION = b"a session of the tests".ljust(32)
ONE, TWO, THREE = identities(3)


def writer(who: Identity = ONE, started: int = 1000) -> MessageWriter:
    return MessageWriter(who, SESSION, started=started)


def reader(who: Identity = TWO, **options: float) -> MessageReader:
    return MessageReader(who.public, SESSION, **options)


topics = st.from_regex(r"[a-z0-9]{1,9}(\.[a-z0-9]{1,9}){0,3}", fullmatch=True)


@given(topics, st.binary(max_size=2000), st.booleans())
def test_what_is_written_is_read(topic: str, body: bytes, direct: bool):
    message = writer().write(topic, body, TWO.public if direct else None)
    assert reader().read(message, 0.0) == SignedMessage(ONE.public, topic, body, direct)


def test_the_longest_message():
    topic = "t" * 64
    message = writer().write(topic, bytes(MOST_BODY))
    assert len(message) == MOST_MESSAGE
    assert reader().read(message, 0.0) == SignedMessage(ONE.public, topic, bytes(MOST_BODY), direct=False)
    longer = writer().write("t", bytes(MOST_BODY + 1))
    assert reader().read(longer, 0.0) is MessageRefusal.SIZE


def test_every_bit_counts():
    message = writer().write("a.b", b"body", TWO.public)
    listener = reader(rate=1e9, burst=1e9)
    for bit in range(8 * len(message)):
        changed = bytearray(message)
        changed[bit // 8] ^= 1 << bit % 8
        assert isinstance(listener.read(bytes(changed), 0.0), MessageRefusal)
    assert isinstance(listener.read(message, 0.0), SignedMessage)


def test_a_message_is_for_one_session_and_one_member():
    message = writer().write("a", b"", TWO.public)
    assert MessageReader(TWO.public, bytes(32)).read(message, 0.0) is MessageRefusal.FORGED
    assert reader(THREE).read(message, 0.0) is MessageRefusal.NOT_OURS
    assert reader(ONE).read(writer().write("a", b""), 0.0) is MessageRefusal.OWN


@given(st.lists(st.integers(0, 9), max_size=40))
def test_only_what_is_newer_is_taken(order: list[int]):
    said, listener, newest = writer(), reader(rate=1e9, burst=1e9), -1
    messages = [said.write("count", bytes([k])) for k in range(10)]
    for k in order:
        read = listener.read(messages[k], 0.0)
        assert (read if isinstance(read, MessageRefusal) else read.body[0]) == (
            k if k > newest else MessageRefusal.REPLAYED
        )
        newest = max(newest, k)
    assert listener.refused[MessageRefusal.REPLAYED] == sum(listener.refused.values())


def test_a_member_that_comes_back_later_is_heard():
    listener = reader()
    before, after = writer(started=10**9), writer(started=2 * 10**9)
    messages = [before.write("a", b"1"), after.write("a", b"2"), before.write("a", b"3")]
    read = [listener.read(message, 0.0) for message in messages]
    assert [one if isinstance(one, MessageRefusal) else one.body for one in read] == [
        b"1",
        b"2",
        MessageRefusal.REPLAYED,
    ]


@pytest.mark.parametrize("topic", ["", "Link", "a..b", ".a", "a b", "a/b", "ä", "a" * 65, "a\n"])
def test_topics_are_words_and_dots(topic: str):
    with pytest.raises(SessionError, match="lower-case words"):
        writer().check(topic, b"", None)
    # A body, so that it is not too short. The length of "ä" is written in letters and read in bytes.
    assert reader().read(writer().write(topic, b"body"), 0.0) is MessageRefusal.TOPIC


@pytest.mark.parametrize("started", [0, -1, 1 << 63])
def test_a_start_is_a_unix_time(started: int):
    with pytest.raises(SessionError, match="nanoseconds since 1970"):
        writer(started=started)


def test_one_sender_is_limited_before_anything_is_checked():
    listener = reader(rate=10.0, burst=30.0)
    said = writer()
    assert isinstance(listener.read(said.write("a", b""), 0.0), SignedMessage)
    out = [listener.read(said.write("a", b""), 0.0) for _ in range(100)]
    taken = sum(isinstance(one, SignedMessage) for one in out)
    assert 25 <= taken <= 30
    assert set(out[40:]) == {MessageRefusal.RATE}
    # Strangers share their buckets by chance.
    others = [writer(Identity.make(entropy(member))).write("a", b"") for member in range(20, 40)]
    assert sum(isinstance(listener.read(other, 0.0), SignedMessage) for other in others) > 10
    assert isinstance(listener.read(said.write("a", b""), 1.0), SignedMessage)


def test_long_messages_count_for_more():
    listener, said = reader(rate=10.0, burst=200.0), writer()
    listener.read(said.write("a", b""), 0.0)
    long = [listener.read(said.write("a", bytes(MOST_BODY)), 0.0) for _ in range(50)]
    assert sum(isinstance(one, SignedMessage) for one in long) == 11


def test_all_together_are_limited():
    listener = reader(rate=400.0, burst=400.0, total=0.1)
    messages = [writer(Identity.make(entropy(member))).write("a", b"") for member in range(60)]
    taken = [isinstance(listener.read(message, 0.0), SignedMessage) for message in messages]
    assert taken == [True] * 39 + [False] * 21
    assert isinstance(listener.read(writer().write("a", b""), 1.0), SignedMessage)


def test_made_up_senders_are_bounded(monkeypatch: pytest.MonkeyPatch):

    monkeypatch.setattr("cotouch.control._sign._MOST_SENDERS", 5)
    listener = reader(rate=1e9, burst=1e9)
    made = [writer(Identity.make(entropy(member))) for member in range(9)]
    out = [listener.read(one.write("a", b""), 0.0) for one in made]
    assert out[5:] == [MessageRefusal.STRANGERS] * 4
    assert isinstance(listener.read(made[0].write("a", b""), 0.0), SignedMessage)


def forged(message: bytes) -> bytes:
    return message[:-1] + bytes([message[-1] ^ 1])


def after_a_forgery(**options: float) -> MessageReader:
    """A reader that was told what is newer than all that ONE says here, but was not signed."""
    listener = reader(**options)
    assert listener.read(forged(writer(started=2000).write("a", b"")), 0.0) is MessageRefusal.FORGED
    return listener


def test_what_is_refused_changes_nothing_but_a_counter(monkeypatch: pytest.MonkeyPatch):
    said = writer()
    message = said.write("a", b"")
    assert isinstance(after_a_forgery().read(message, 0.0), SignedMessage)  # not how far its sender has counted
    listener = after_a_forgery(burst=80.0)
    lies = [listener.read(forged(said.write("a", b"")), 0.0) for _ in range(9)]  # not what a stranger may say
    assert set(lies[:2]) == {MessageRefusal.FORGED}
    assert set(lies[3:]) == {MessageRefusal.RATE}
    monkeypatch.setattr("cotouch.control._sign._MOST_SENDERS", 1)
    assert isinstance(after_a_forgery().read(writer(THREE).write("a", b""), 0.0), SignedMessage)  # nor who has a place


def test_who_left_leaves_its_last_counter_and_no_more(monkeypatch: pytest.MonkeyPatch):

    monkeypatch.setattr("cotouch.control._sign._MOST_SENDERS", 3)
    monkeypatch.setattr("cotouch.control._sign._MOST_GONE", 4)
    listener = reader(rate=1e9, burst=1e9)
    who = [Identity.make(entropy(member)) for member in range(20)]
    made = [writer(one) for one in who]
    old = [one.write("a", b"1") for one in made]
    for one, message in zip(who, old, strict=True):  # they come and go: more than are known at a time
        assert isinstance(listener.read(message, 0.0), SignedMessage)
        listener.forget(one.public)
        listener.forget(one.public)
    assert [listener.read(message, 0.0) for message in old[-4:]] == [MessageRefusal.REPLAYED] * 4
    assert isinstance(listener.read(made[-1].write("a", b"2"), 0.0), SignedMessage)  # it was only cut off
    assert listener.read(old[-1], 0.0) is MessageRefusal.REPLAYED
    # It left its place among those who are gone. All others have left theirs, so three can be here at a time again.
    assert [isinstance(listener.read(message, 0.0), SignedMessage) for message in old[:3]] == [True, True, False]
    listener.forget(who[0].public)
    assert [listener.read(message, 0.0) for message in old[-4:]] == [MessageRefusal.REPLAYED] * 4
    # Of one more than there is room for, the longest gone is forgotten altogether.
    listener.forget(who[1].public)
    assert isinstance(listener.read(old[-4], 0.0), SignedMessage)


def test_who_left_may_say_no_more_than_a_stranger():
    listener, said = reader(rate=1e-9, burst=100.0), writer()

    def heard() -> int:
        return sum(isinstance(listener.read(said.write("a", b""), 0.0), SignedMessage) for _ in range(10))

    assert heard() == 10
    listener.forget(ONE.public)
    assert isinstance(listener.read(forged(said.write("a", b"")), 0.0), MessageRefusal)
    lies = [listener.read(forged(said.write("a", b"")), 0.0) for _ in range(9)]
    assert set(lies[3:]) == {MessageRefusal.RATE}


@pytest.mark.parametrize("start", [2**63 - 1, 2**63 - 2])
def test_a_counter_near_its_end_is_refused(start: int):
    """Before it comes there: one below is heard, and what comes after it is not."""
    said, listener = writer(started=start), reader()
    received = [listener.read(said.write("a", b""), 0.0) for _ in range(3)]
    assert received[-2:] == [MessageRefusal.COUNTER] * 2
    assert isinstance(received[0], SignedMessage) == (start == 2**63 - 2)
