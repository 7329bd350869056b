"""Who may come in, and to which slot: one rule at a time."""

from tests.members.test_coordinator import BODY, NETWORK, World, key
from tests.session.world import entropy
from tests.traversal.shown import place_at

from cotouch.laws import law_named
from cotouch.members import AddressProof, Admission, Entry, Join, NameOwner, Roster, SessionFile, addresses_of
from cotouch.samples import Identity
from cotouch.traversal import Addresses

SESSION = SessionFile.from_toml(NETWORK)
GUESTS = SessionFile.from_toml("[session]\nusers = 4\n", law=SESSION.law)


def request(name: str, *, place: AddressProof | None = None) -> Join:
    return Join(name=name, fingerprint=BODY, version="1", law=law_named(SESSION.law).signature, place=place)


def entry(slot: int, name: str, number: int) -> Entry:
    return Entry(slot=slot, name=name, key=key(number).hex())


def full(count: int = 256) -> Roster:
    """With so many names of people who are gone."""
    return Roster(names=[NameOwner(name=f"gone {k}", key=f"{k + 1000:064x}") for k in range(count)])


def test_a_session_knows_only_so_many_names() -> None:
    admission = Admission(GUESTS, fingerprint=BODY)
    assert "256 names" in str(admission.slot(request("Ann"), key(1).hex(), full(), 0.0))
    assert admission.slot(request("gone 0"), f"{1000:064x}", full(), 0.0) == 0
    assert admission.slot(request("Ann"), key(1).hex(), full(255), 0.0) == 0


def test_a_process_that_begins_anew_again_and_again_is_let_in_every_two_seconds() -> None:
    admission, mine = Admission(GUESTS, fingerprint=BODY), key(1).hex()
    roster = Roster(members=[entry(0, "Ann", 1)])
    admission.came(request("Ann"), mine, roster, 10.0)
    assert admission.slot(request("Ann"), mine, roster, 11.9) is None
    assert admission.slot(request("Ann"), mine, roster, 12.1) == 0


def test_who_has_a_slot_from_the_host_gets_it_or_none() -> None:
    admission = Admission(GUESTS, fingerprint=BODY)
    admission.mine = {key(1).hex(): 0, key(2).hex(): 1}
    nobody = Roster()
    assert admission.slot(request("Ben"), key(2).hex(), nobody, 0.0) == 1
    assert admission.slot(request("Dan"), key(4).hex(), nobody, 0.0) == 2  # others' slots only when there is no other
    crowd = Roster(members=[entry(2, "Dan", 4), entry(3, "Eve", 5)])
    assert admission.slot(request("Fay"), key(6).hex(), crowd, 0.0) == 0
    taken = Roster(members=[entry(0, "Dan", 4)])
    assert "given to somebody else" in str(admission.slot(request("Ann"), key(1).hex(), taken, 0.0))


def test_who_comes_back_has_its_slot_if_it_is_free() -> None:
    admission = Admission(GUESTS, fingerprint=BODY)
    both = Roster(members=[entry(0, "Ann", 1), entry(1, "Ben", 2)])
    admission.came(request("Ben"), key(2).hex(), both, 0.0)
    names = [NameOwner(name=one.name, key=one.key) for one in both.members]
    assert admission.slot(request("Ben"), key(2).hex(), Roster(names=names), 9.0) == 1
    taken = Roster(names=names, members=[entry(1, "Cleo", 3)])
    assert admission.slot(request("Ben"), key(2).hex(), taken, 9.0) == 0


def test_only_who_shows_it_is_on_this_machine_or_at_an_address() -> None:
    addresses, who = Addresses(entropy(1)), Identity.make(entropy(2)).public
    where = addresses_of(addresses, {"192.0.2.1"})

    def shown(host: str, *, true: bool) -> str | None:
        nonce, host, cookie = place_at(addresses, who, host)
        proof = AddressProof(nonce=nonce.hex(), host=host, cookie=cookie.hex() if true else "00000000")
        return where(who, request("Ann", place=proof))

    for host, counted in (("127.0.0.1", ""), ("192.0.2.1", ""), ("192.0.2.9", "192.0.2.9")):
        assert shown(host, true=True) == counted
        assert shown(host, true=False) is None
    assert where(who, request("Ann")) is None


def test_nobody_is_taken_up_who_was_sent_away_has_no_slot_or_one_name_too_many() -> None:
    world = World()
    world.join(1, "Ann")
    world.join(2, "Ben")
    world.coordinator.expel("Ben")
    present = frozenset([key(1), key(2), key(3)])

    def commanded(one: Entry) -> None:
        world.coordinator.take_up(Roster(epoch=9, members=[one]), present, world.now)

    commanded(entry(1, "Bob", 2))
    assert world.names == {0: "Ann"}
    commanded(entry(4, "Cleo", 3))
    assert world.names == {0: "Ann"}
    world.coordinator.adopt(world.roster.model_copy(update={"names": full().names[:-1]}), world.now)
    commanded(entry(2, "Cleo", 3))
    assert world.names == {0: "Ann"}
    world.coordinator.adopt(world.roster.model_copy(update={"names": []}), world.now)
    commanded(entry(2, "Cleo", 3))
    assert world.names == {0: "Ann", 2: "Cleo"}


def test_links_of_another_law_are_refused_by_both_names() -> None:
    admission = Admission(GUESTS, fingerprint=BODY)
    own = law_named(GUESTS.law).signature.split()[0]
    for theirs, name in (("wave 0123", '"wave"'), ("", '"none"'), (f"{own} of-another-version", f'"{own}"')):
        why = admission.slot(request("Ann").model_copy(update={"law": theirs}), key(1).hex(), Roster(), 0.0)
        assert isinstance(why, str)
        assert f'law "{own}"' in why
        assert f"({name})" in why


def test_who_is_named_in_the_file_has_that_slot_while_it_is_free() -> None:
    admission = Admission(SESSION, fingerprint=BODY)
    assert admission.slot(request("Cleo"), key(1).hex(), Roster(), 0.0) == 2
    assert admission.slot(request("Eve"), key(1).hex(), Roster(), 0.0) == 0
    taken = Roster(members=[entry(2, "Dan", 4)])
    assert admission.slot(request("Cleo"), key(1).hex(), taken, 0.0) == 0
    guests = Admission(GUESTS, fingerprint=BODY)
    users = list(GUESTS.scenario.network.users)
    assert guests.slot(request(users[2]), key(1).hex(), Roster(), 0.0) == 0


def test_who_was_forgotten_does_not_wait_for_what_it_did_before() -> None:
    admission = Admission(GUESTS, fingerprint=BODY)
    mine, roster = key(1).hex(), Roster(members=[entry(0, "Ann", 1)])
    admission.came(request("Ann"), mine, roster, 10.0)
    admission.came(request("Ben"), key(2).hex(), Roster(members=[entry(1, "Ben", 2)]), 10.5)
    assert admission.slot(request("Ann"), mine, roster, 11.0) == 0
