"""What the terminal says of a session's law."""

from cotouch.cli._table import felt_words, traffic_words, verdict
from cotouch.members import LinkStatus, Status


def said(slot: int, **entries: object) -> Status:
    links = [LinkStatus(slot=1 - slot, state="coupled", given=0.002, taken=0.0015)]
    return Status.model_validate({"slot": slot, "steps": 1, "law": "paid", "links": links} | entries)


def test_the_law_its_energy_on_the_way_and_its_drag() -> None:
    both = [said(slot, drag=0.5, braked=0.03, moved=0.04) for slot in (0, 1)]
    assert felt_words(both) == (
        "Law paid: 1 mJ on its way; felt drag 1.50 Ns/m measured and 1.00 Ns/m predicted (people notice 0.8 Ns/m)."
    )
    still = [said(slot, law="spring", drag=2.0) for slot in (0, 1)]
    assert felt_words(still) == "Law spring: felt drag 4.00 Ns/m predicted (people notice 0.8 Ns/m)."
    assert "felt drag unknown until the object moves" in felt_words([said(0)])
    assert felt_words([]) == ""


def test_what_is_sent_and_what_the_codec_saves() -> None:
    sent = {"slot": 1, "state": "coupled", "datagrams": 480.0, "size": 60e3}
    both = [said(0, links=[sent]), said(1, links=[sent | {"slot": 0, "size": 20e3}])]
    assert traffic_words(both) == "Samples: 960 datagrams and 80.0 kB a second."
    both[1] = said(1, links=[sent | {"slot": 0, "size": 20e3, "saved": 0.8}])  # of 100 kB/s
    assert traffic_words(both) == "Samples: 960 datagrams and 80.0 kB a second; the codec saves 50 %."
    assert traffic_words([said(0)]) == ""


def test_nobody_is_accused_of_energy_whose_ledger_went_with_who_left() -> None:
    took = [said(0, supplied=-0.062, initial=0.0)]
    assert verdict(took, left=False) == "NOT PASSIVE: 0.062 J came out that nobody had put in."
    assert "cannot be judged" in verdict(took, left=True)
    assert verdict([said(0, supplied=0.062)], left=True).startswith("Passive")
