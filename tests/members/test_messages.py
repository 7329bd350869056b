"""Whatever a member says, the others take it or leave it."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from tests.members.test_member import three

from cotouch.members import Entry, Join, LinkStatus, Refused, Roster, Status, read_message, write_message

KINDS = (Entry, Join, Refused, Roster, Status)
TOPICS = ("join", "leave ", "roster", "refused", "status", "link.keys", "link.budget", "path.candidates", "end", "x.y")


@given(st.binary(max_size=300), st.sampled_from(KINDS))
def test_noise_is_nothing(noise: bytes, kind) -> None:
    assert read_message(kind, noise) is None


@given(st.integers(0, 400), st.integers(0, 255))
def test_a_changed_byte_is_read_or_not_but_never_raises(place: int, byte: int) -> None:
    status = Status(slot=3, links=[LinkStatus(slot=1, state="coupled", age_sum=0.1)])
    body = bytearray(write_message(status))
    body[place % len(body)] = byte
    commanded = read_message(Status, bytes(body))
    assert commanded is None or isinstance(commanded, Status)


def test_numbers_that_are_none_are_not_taken() -> None:
    body = write_message(Status(slot=0))
    assert read_message(Status, body.replace(b'"energy":0.0', b'"energy":NaN')) is None
    assert read_message(Status, body.replace(b'"energy":0.0', b'"energy":1e300')) is None
    assert read_message(Status, body.replace(b'"slot":0', b'"slot":32')) is None
    assert read_message(Roster, b'{"members": ' + b"[" * 100_000) is None


def test_a_member_that_says_anything_at_all_changes_nothing_for_the_others() -> None:
    world = three()
    mallory = world.people[1]
    rng = np.random.default_rng(0)
    spoken = [
        write_message(mallory.member.roster),
        write_message(mallory.copy.status(world.now)),
        rng.bytes(44),
        b"ctk1" + rng.bytes(180),
    ]
    roster = world.people[0].member.roster
    for _ in range(40):
        for _ in range(8):
            body = bytearray(spoken[rng.integers(len(spoken))])
            for _ in range(rng.integers(0, 6)):
                body[rng.integers(len(body))] = rng.integers(256)
            topic = TOPICS[rng.integers(len(TOPICS))].strip()
            if topic != "leave":
                to = [None, world.people[0].identity.public, world.people[2].identity.public][rng.integers(3)]
                mallory.control.send(topic, bytes(body), to=to)
        world.run(0.05)
    assert world.people[0].member.roster == roster
    assert world.people[2].states()[0] == "coupled"
    assert not world.people[2].member.ended
    world.check()
