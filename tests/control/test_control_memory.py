"""What only the control plane in memory can do: delays and cuts at will, on a clock that is moved by hand."""

import pytest
from tests.control.memory import MemoryControl, MemoryControlNetwork
from tests.live.support import identities

from cotouch.errors import SessionError
from cotouch.samples import PathLaw

ONE, TWO, THREE = (one.public for one in identities(3))


def session(**options: object) -> tuple[MemoryControlNetwork, list[MemoryControl]]:
    network = MemoryControlNetwork(**options)  # pyright: ignore[reportArgumentType]
    members = [network.join(one) for one in identities(3)]
    network.now = 10.0
    assert all(len(member.present()) == 2 for member in members)
    return network, members


def said(member: MemoryControl) -> list[bytes]:
    return [message.body for message in member.poll()]


def test_a_message_takes_its_time():
    network, (one, two, _) = session(delay=0.25)
    one.send("a", b"later")
    network.now = 10.24
    assert said(two) == []
    network.now = 10.25
    assert said(two) == [b"later"]


def test_a_cut_loses_what_is_on_its_way_and_is_noticed_after_the_window():
    network, (one, two, three) = session(delay=0.25, window=2.0)
    one.send("a", b"on its way")
    network.cut(ONE, TWO)
    one.send("a", b"into the void")
    two.send("a", b"back")
    network.now = 10.5
    assert (said(two), said(one)) == ([], [])
    assert said(three) == [b"on its way", b"into the void", b"back"]
    assert TWO in one.present()
    network.now = 12.0
    assert (one.present(), two.present(), three.present()) == ({THREE}, {THREE}, {ONE, TWO})
    network.mend(ONE, TWO)
    network.now = 12.2
    assert TWO not in one.present()
    network.now = 13.6  # a beat there, an answer back, and the other's
    assert (one.present(), two.present()) == ({TWO, THREE}, {ONE, THREE})
    one.send("a", b"again")
    network.now = 14.0
    assert said(two) == [b"again"]


def test_a_short_cut_is_not_noticed():
    network, (one, _, _) = session(delay=0.1, window=3.0)
    network.cut(ONE, TWO)
    for network.now in (10.5, 11.4):
        assert TWO in one.present()
    network.mend(ONE, TWO)
    for network.now in (11.45, 11.6, 13.0, 15.0):
        assert TWO in one.present()


def test_who_is_killed_is_missed_after_the_window_and_comes_back():
    network, (one, two, _) = session(delay=0.1, window=2.0)
    two.send("a", b"received")
    network.now = 10.1
    two.send("a", b"lost")
    network.kill(TWO)
    network.now = 10.9
    assert TWO in one.present()
    assert said(one) == [b"received"]
    network.now = 12.0
    assert TWO not in one.present()
    again = network.join(identities(3)[1])
    network.now = 12.7
    assert (one.present(), again.present()) == ({TWO, THREE}, {ONE, THREE})
    again.send("a", b"back")
    network.now = 12.8
    assert said(one) == [b"back"]


def test_who_leaves_is_missed_at_once():
    network, (one, two, three) = session(delay=0.1)
    two.close()
    network.now = 10.15
    assert (one.present(), three.present()) == ({THREE}, {ONE})


def test_relayed_datagrams_obey_the_law_of_their_path():
    network, (one, two, _) = session(law=PathLaw(delay=0.05, loss=0.3), seed=3)
    for k in range(1000):
        assert one.relay(TWO, k.to_bytes(2, "big"))
    network.now = 10.04
    assert two.relayed() == []
    network.now = 10.06
    came = two.relayed()
    assert 620 < len(came) < 780
    assert {one.time for one in came} == {10.05}
    _, (other, there, _) = other_session = session(law=PathLaw(delay=0.05, loss=0.3), seed=3)
    for k in range(1000):
        other.relay(TWO, k.to_bytes(2, "big"))
    other_session[0].now = 10.06
    assert there.relayed() == came


def test_a_file_takes_there_and_back():
    network, (one, two, _) = session(delay=0.25)
    digest = one.offer(b"body")
    assert two.fetch(digest) is None
    network.now = 10.4
    assert two.fetch(digest) is None
    network.cut(ONE, TWO)
    network.now = 10.6
    assert two.fetch(digest) is None
    network.mend(ONE, TWO)
    assert two.fetch(digest) == b"body"


def test_an_identity_is_there_once():
    network, _ = session()
    with pytest.raises(SessionError, match="every member needs its own"):
        network.join(identities(1)[0])
    with pytest.raises(SessionError, match="never in the session together"):
        network.cut(ONE, bytes(32))
