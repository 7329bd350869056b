"""What the terminal says of a session's law."""

from tests.cli.shown import table
from tests.control.memory import MemoryControlNetwork
from tests.live.support import identities

from cotouch.members import Entry, LinkStatus, MemberState, SessionWatch, Status


def said(slot: int, **entries: object) -> Status:
    links = [LinkStatus(slot=1 - slot, state="coupled", given=0.002, taken=0.0015)]
    return Status.model_validate({"slot": slot, "steps": 1, "law": "paid", "links": links} | entries)


def told(statuses: list[Status], *, left: bool = False) -> list[str]:
    """The lines of the table of a session whose members say this."""
    host = identities()[0]
    watch = SessionWatch(MemoryControlNetwork().join(host), host=host.public)
    watch.left = left
    for status in statuses:
        entry = Entry(slot=status.slot, name=f"user {status.slot}", key=f"{status.slot:064x}")
        watch.members[status.slot] = MemberState(entry, status, 0.0)
    return table(watch, 0.0).splitlines()


def test_the_law_its_energy_on_the_way_and_its_drag() -> None:
    both = [said(slot, drag=0.5, braked=0.03, moved=0.04) for slot in (0, 1)]
    measured = "Law paid: 1 mJ on its way; felt drag 1.50 Ns/m measured and 1.00 Ns/m predicted"
    assert f"{measured} (people notice 0.8 Ns/m)." in told(both)
    still = [said(slot, law="spring", drag=2.0) for slot in (0, 1)]
    assert "Law spring: felt drag 4.00 Ns/m predicted (people notice 0.8 Ns/m)." in told(still)
    assert any("felt drag not known yet" in line for line in told([said(0)]))
    assert not any("Law" in line for line in told([]))


def test_who_is_too_far_away_to_be_told_of() -> None:
    away = "user 2: the copy is farther away than samples can tell, so neighbours hear nothing of it"
    assert away in told([said(0), said(1, unsent=True)])
    assert not any("farther" in line for line in told([said(0), said(1)]))


def test_what_is_sent_and_what_the_codec_saves() -> None:
    sent = {"slot": 1, "state": "coupled", "datagram_rate": 480.0, "byte_rate": 60e3}
    both = [said(0, links=[sent]), said(1, links=[sent | {"slot": 0, "byte_rate": 20e3}])]
    assert "Samples: 960 datagrams and 80.0 kB a second." in told(both)
    both[1] = said(1, links=[sent | {"slot": 0, "byte_rate": 20e3, "saved": 0.8}])  # of 100 kB/s
    assert "Samples: 960 datagrams and 80.0 kB a second; the codec saves 50 %." in told(both)
    assert not any("Samples" in line for line in told([said(0)]))


def test_nobody_is_accused_of_energy_whose_ledger_went_with_who_left() -> None:
    took = [said(0, supplied=-0.062, initial=0.0)]
    assert any(line.endswith("NOT PASSIVE: 0.062 J came out that nobody had put in.") for line in told(took))
    fell = told([took[0].model_copy(update={"depth": 0.5})])  # the weight of the object gave it
    assert any(line.endswith("Passive: nobody took out energy that nobody had put in.") for line in fell)
    assert any("cannot be judged" in line for line in told(took, left=True))
    lost = told([said(0, supplied=0.062)], left=True)
    assert any(line.endswith("Passive: nobody took out energy that nobody had put in.") for line in lost)
