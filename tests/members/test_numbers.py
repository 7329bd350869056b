"""No number that anybody says is an error in the host or in a member, however large."""

import json
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from pydantic import TypeAdapter
from tests.cli.shown import shown
from tests.members.test_succession import lie, say
from tests.session.world import World
from tests.thorough import examples

from cotouch.members import Decided, Entry, Join, LinkStatus, NameOwner, Refused, Roster, Status, read_message

PLANNED = """
[session]
users = 3
spring = 60.0
links = "plan"
replan = true
[body]
mass = 0.5
[steps]
rate = 50
"""
KEYS = st.sampled_from(["a" * 64, "0" * 64, "f" * 64, "0123456789abcdef" * 4])
NAMES = st.sampled_from(["Ann", "Ben", "Eve", "x" * 32, "[bold]", "🂡", " "])
ENDS = st.sampled_from(
    [0, 1, -1, 31, 32, 2**31, 2**32 - 1, 2**32, 2**52 - 1, 2**52, 2**53 - 1, 2**53, 2**63, 2**64, 10**400]
)
FLOATS = st.sampled_from([0.0, -0.0, 5e-324, 1e-300, 1e12, -1e12, 1e13, 1e300, -1e300, 1e6, 1e999])
STARTS = st.sampled_from(["0" * 16, "f" * 16])


def record(**fields: Any) -> st.SearchStrategy[dict[str, Any]]:
    return st.fixed_dictionaries({}, optional=fields)


SLOTS = st.sampled_from([0, 1, 2, 3, 31, 32, -1, 2**64])
ENTRY = st.fixed_dictionaries({"slot": SLOTS, "name": NAMES, "key": KEYS, "start": STARTS})
LINK = st.fixed_dictionaries({"slot": SLOTS, "state": st.sampled_from(["coupled", "keys", "?", "x" * 200])}).flatmap(
    lambda base: record(
        age=FLOATS, age_sum=FLOATS, budget=FLOATS, round_trip=FLOATS, loss=FLOATS, rate=FLOATS, force=FLOATS,
        work=FLOATS, difference=FLOATS, guarded=ENDS,
    ).map(lambda more: base | more)
)  # fmt: skip
STATUS = st.fixed_dictionaries({"slot": SLOTS}).flatmap(
    lambda base: record(
        epoch=ENDS, time=FLOATS, steps=ENDS, rate=FLOATS, nominal_period=FLOATS, longest_period=FLOATS, missed=ENDS,
        stood=FLOATS, force=FLOATS, position=st.lists(FLOATS, max_size=4), supplied=FLOATS, lost=FLOATS, linked=FLOATS,
        rescaled=FLOATS, energy=FLOATS, initial=FLOATS, residual=FLOATS, damping=FLOATS, damping_margin=FLOATS,
        links=st.lists(LINK, max_size=4), unsent=st.booleans(), alarms=ENDS, roster=KEYS,
        closure=FLOATS, closure_factor=FLOATS, closure_alarms=ENDS,
        round_trips=st.lists(st.tuples(SLOTS, FLOATS), max_size=4), initial_energies=FLOATS,
    ).map(lambda more: base | more)
)  # fmt: skip
ROSTER = record(
    epoch=ENDS,
    members=st.lists(ENTRY, max_size=4),
    links=st.lists(st.tuples(SLOTS, SLOTS), max_size=4),
    names=st.lists(st.fixed_dictionaries({"name": NAMES, "key": KEYS}), max_size=4),
    banned=st.lists(KEYS, max_size=3),
    former=st.lists(st.fixed_dictionaries({"key": KEYS, "slots": st.lists(SLOTS, max_size=4)}), max_size=3),
)
JOIN = st.fixed_dictionaries(
    {"name": NAMES, "fingerprint": st.lists(FLOATS, max_size=17), "version": st.text(max_size=9)}
)
DECIDED = st.lists(
    st.fixed_dictionaries({"roster": ROSTER, "signer": KEYS, "signature": st.just("0" * 128)}), min_size=1, max_size=5
).map(lambda chain: {"chain": chain})
SAID = st.one_of(
    st.tuples(st.just("status"), STATUS),
    st.tuples(st.just("seen"), STATUS),
    st.tuples(st.just("join"), JOIN),
    st.tuples(st.just("roster"), DECIDED),
    st.tuples(st.just("refused"), record(reason=st.text(max_size=300))),
    st.tuples(st.just("leave"), st.just({})),
)


@pytest.fixture(scope="module")
def world() -> World:
    """With a host that plans from what members say, and one who decides without a host in the end."""
    made = World(PLANNED, tick=5e-3, planner=lambda slots, paths: [(a, b) for a in slots for b in slots if a < b])
    for name in ("Ann", "Ben", "Cleo"):
        made.join(name, moves=False)
    made.until(lambda: all(person.member.slot is not None for person in made.people), 8.0)
    control: Any = made.people[2].control
    poll = control.poll
    # Whoever is refused for what it said itself goes on all the same: it does not hear so.
    control.poll = lambda: [message for message in poll() if message.topic != "refused"]
    return made


@settings(max_examples=examples(60), suppress_health_check=[HealthCheck.function_scoped_fixture, HealthCheck.too_slow])
@given(said=st.lists(SAID, min_size=1, max_size=6), late=st.booleans())
def test_nothing_that_a_member_says_is_an_error(world: World, said: list[tuple[str, Any]], late: bool) -> None:
    mallory = world.people[2]
    for topic, body in said:
        text = json.dumps(body).encode()
        mallory.control.send(topic, text)
        if late:
            mallory.control.send(topic, text, to=world.people[0].identity.public)
    world.run(0.06)
    assert world.host is not None
    world.host.watch.events.clear()
    assert shown(world)
    assert world.people[0].member.slot is not None
    assert world.people[1].member.slot is not None


def test_signed_rosters_with_any_numbers_are_no_error_and_harm_nobody(world: World) -> None:
    """By the one who decides: the lowest slot, the host being gone."""
    mallory = min(world.people, key=lambda person: person.member.slot or 0)
    others = [person for person in world.people if person is not mallory]
    world.kill_host()
    world.run(5.0)
    root = world.kept[-1]
    for epoch in (0, root.roster.epoch, 2**32 - 1, 2**32, 2**52 - 1):
        for members in ([], root.roster.members, [*root.roster.members[:2], Entry(slot=31, name="Eve", key="f" * 64)]):
            names = [NameOwner(name="Eve", key="f" * 64)] if members[-1:] and members[-1].name == "Eve" else []
            roster = Roster(epoch=epoch, members=members, names=[*root.roster.names, *names])
            chain = lie(world, mallory, roster)
            say(mallory, chain)
            say(mallory, chain[1:])
            world.run(0.1)
            for person in others:
                assert person.member.slot is not None
                assert person.member.roster.epoch < 2**31


@pytest.mark.parametrize("kind", [Join, Refused, Roster, Status, Decided, Entry, LinkStatus, NameOwner])
def test_no_whole_number_is_without_an_end(kind: type) -> None:
    """A counter that anybody can say, and that may be anything, is an OverflowError somewhere."""

    def open_ended(schema: Any, at: str) -> list[str]:
        if isinstance(schema, list):
            return [found for part in schema for found in open_ended(part, at)]
        if not isinstance(schema, dict):
            return []
        found = (
            [at]
            if schema.get("type") in {"integer", "number"} and not ({"maximum", "exclusiveMaximum"} & set(schema))
            else []
        )
        return found + [one for name, part in schema.items() for one in open_ended(part, f"{at}.{name}")]

    assert open_ended(TypeAdapter(kind).json_schema(), kind.__name__) == []


def test_a_number_beyond_its_end_is_no_message() -> None:
    assert read_message(Roster, b'{"epoch": 4503599627370496}') is None
    assert read_message(Roster, b'{"epoch": 4503599627370495}') is not None
    assert read_message(Status, b'{"slot": 0, "steps": ' + b"9" * 4000 + b"}") is None
    two = b'{"members": [{"slot": 1, "name": "A", "key": "' + b"a" * 64 + b'"}, {"slot": 1, "name": "B", "key": "'
    assert read_message(Roster, two + b"b" * 64 + b'"}]}') is None
