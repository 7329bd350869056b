"""Orders that are typed where a host runs."""

import os

import pytest
from tests.cli.inside import Console
from tests.session.world import World

from cotouch.members import Host

TEXT = "[session]\nusers = 3\n[body]\nmass = 0.5\n[steps]\nrate = 50\n"


def host_of(world: World) -> Host:
    assert world.host is not None
    return world.host


def filled() -> World:
    world = World(TEXT, tick=5e-3)
    for name in ("Ann", "Ben Bo"):
        world.join(name, moves=False)
    world.until(lambda: all(person.member.slot is not None for person in world.people), 5.0)
    return world


def test_orders_are_read_as_they_come_and_answered(capsys: pytest.CaptureFixture[str]) -> None:
    world = filled()
    reading, writing = os.pipe()
    console = Console(host_of(world), descriptor=reading)
    try:
        console.service(0.0)
        os.write(writing, b"who\nexp")
        console.service(0.0)
        os.write(writing, b"el Ben Bo\nexpel Zoe\nrelease Ann\nrelease\nsing\n\n")
        console.service(0.0)
    finally:
        os.close(writing)
    console.service(0.0)
    os.close(reading)
    console.service(0.0)
    said = capsys.readouterr().err.splitlines()
    assert said[0] == "cotouch: 1 Ann, 2 Ben Bo"
    assert said[1].startswith("cotouch: Ben Bo was expelled")
    assert said[2] == 'cotouch: nobody here has the name "Zoe"; there are: Ann'
    assert said[3] == 'cotouch: "Ann" has joined; only the name of a user who has left can be released'
    assert said[4].startswith('cotouch: "release" is not a command; commands are: expel NAME')
    assert said[5].startswith('cotouch: "sing" is not a command')
    assert len(said) == 6
    assert [entry.name for entry in host_of(world).roster.members] == ["Ann"]
    assert len(host_of(world).roster.banned) == 1


def test_a_line_without_an_end_is_bounded(capsys: pytest.CaptureFixture[str]) -> None:
    world = filled()
    reading, writing = os.pipe()
    console = Console(host_of(world), descriptor=reading)
    for written in [b"x" * 4096] * 7 + [b" " * 4096, b"expel Zoe\n"]:
        os.write(writing, written)
        console.service(0.0)
    assert 'nobody here has the name "Zoe"' in capsys.readouterr().err  # what stood before was let go
    os.close(writing)
    os.close(reading)
