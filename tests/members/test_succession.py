"""Who decides when the host is gone, what it may do, and what a host that comes back goes on from."""

from collections.abc import Callable

import numpy as np
import pytest
from tests.members.inside import MOST_LEAP, Belief, acting, order_of, signed
from tests.session.world import Person, World, entropy

from cotouch.errors import SessionError
from cotouch.members import Decided, Decision, Entry, NameOwner, Roster, write_message
from cotouch.samples import Identity

FOUR = """
[session]
users = 4
spring = 60.0
[body]
mass = 0.5
damping = 0.2
[steps]
rate = 50
"""
NAMES = ("Ann", "Ben", "Cleo")
HOST, ANN, BEN, CLEO, DAN, EVE = (Identity.make(entropy(k)) for k in range(6))


def three(text: str = FOUR) -> World:
    world = World(text, tick=2e-3)
    for name in NAMES:
        world.join(name, moves=False)
    world.until(world.all_coupled, 15.0)
    world.run(1.0)
    return world


def say(person: Person, chain: list[Decision] | tuple[Decision, ...], to: bytes | None = None) -> None:
    person.control.send("roster", write_message(Decided(chain=list(chain))), to=to)


def lie(world: World, person: Person, roster: Roster) -> list[Decision]:
    """What a member signs on top of the host's last roster."""
    return [world.kept[-1], signed(person.identity, world.host_identity.public, roster)]


def changed(roster: Roster, *, epoch: int = 1, **fields: object) -> Roster:
    """With other fields, whatever they are, and a number that is so much higher."""
    return roster.model_copy(update={"epoch": roster.epoch + epoch, **fields})


def rosters(world: World) -> set[str]:
    return {person.member.roster.digest for person in world.people}


# -- a host that comes back ------------------------------------------------------------------------------------------


def test_the_host_dies_others_come_and_it_goes_on_from_what_it_kept() -> None:
    world = three()
    world.kill_host()
    world.run(4.0)
    dan = world.join("Dan", moves=False)
    world.until(lambda: dan.member.slot is not None and world.all_coupled(), 20.0)
    links = dict(dan.copy.neighbours)
    before = {entry.slot: entry for entry in dan.member.roster.members}
    world.revive_host(world.kept[-1])
    world.run(8.0)
    assert world.host is not None
    assert {entry.slot: entry for entry in world.host.roster.members} == before
    assert rosters(world) == {world.host.roster.digest}
    assert dan.copy.neighbours == links  # the same: nobody had to meet anew
    assert all(len(person.member._belief.chain) == 1 for person in world.people)
    world.check()


def test_a_host_that_comes_back_takes_nobody_in_anothers_name() -> None:
    """What was asked of a roster was that its sender is in it."""
    world = three()
    mallory, ben = world.people[2], world.people[1]
    world.kill_host()
    world.run(4.0)
    world.revive_host(world.kept[-1])
    kept = world.kept[-1].roster
    stolen = [
        entry.model_copy(update={"key": mallory.identity.public.hex() if entry.name == "Ben" else entry.key})
        for entry in kept.members
        if entry.name != "Cleo"
    ]
    forged = Roster(epoch=kept.epoch + 5, members=stolen)
    fake = Decision(roster=forged, signer=world.host_identity.public.hex(), signature="0" * 128)
    chains = [[fake], [signed(mallory.identity, world.host_identity.public, forged)], lie(world, mallory, forged)]
    for _ in range(40):
        for chain in chains:
            say(mallory, chain)
        world.run(0.1)
    assert world.host is not None
    assert {entry.name: entry.key for entry in world.host.roster.members} == {
        person.name: person.identity.public.hex() for person in world.people
    }
    assert ben.member.roster.digest == world.host.roster.digest


def test_a_host_with_an_older_file_goes_on_from_its_own_newest_word() -> None:
    world = World(FOUR, tick=2e-3)
    for name in NAMES:
        world.join(name, moves=False)
        world.until(lambda: all(person.member.slot is not None for person in world.people), 5.0)
    world.until(world.all_coupled, 15.0)
    older = world.kept[-2]
    assert len(older.roster.members) == 2
    links = dict(world.people[2].copy.neighbours) if world.people[2].member.replica is not None else {}
    world.kill_host()
    world.run(1.0)
    world.revive_host(older)
    world.run(8.0)
    assert links
    assert world.people[2].copy.neighbours == links  # nobody had to come anew
    assert world.host is not None
    assert {entry.name for entry in world.host.roster.members} == set(NAMES)
    assert rosters(world) == {world.host.roster.digest}
    assert world.all_coupled()


def test_what_most_say_counts_before_what_one_says() -> None:
    """The lowest slot tells the host another roster than it told everybody."""
    world = three()
    mallory = world.people[0]
    world.kill_host()
    world.run(4.0)
    dan = world.join("Dan", moves=False)
    world.until(lambda: dan.member.slot is not None and world.all_coupled(), 20.0)
    eve = Identity.make(entropy(50))
    world.controls.join(eve)
    world.revive_host(world.kept[-1])
    commanded = mallory.member.roster
    false = [
        entry if entry.name != "Dan" else entry.model_copy(update={"key": eve.public.hex()})
        for entry in commanded.members
    ]
    names = [bound for bound in commanded.names if bound.name != "Dan"] + [NameOwner(name="Dan", key=eve.public.hex())]
    send = mallory.control.send
    chain = lie(world, mallory, changed(commanded, members=false, names=names))

    def lying(topic: str, body: bytes, *, to: bytes | None = None) -> None:
        send(topic, write_message(Decided(chain=chain)) if topic == "roster" else body, to=to)

    mallory.control.send = lying
    say(mallory, chain, to=world.host_identity.public)
    world.run(6.0)
    assert world.host is not None
    assert world.host.roster.owners()["Dan"] == dan.identity.public.hex()


# -- who decides meanwhile ---------------------------------------------------------------------------------------------


HARMS: list[tuple[Callable[[Roster], Roster], str | None]] = [
    (lambda r: changed(r, members=r.members[:2], links=[(0, 1)]), "leaves out Cleo"),
    (lambda r: changed(r, members=[*r.members[:2], r.members[2].model_copy(update={"slot": 3})], links=[]), None),
    (lambda r: changed(r, members=r.members[:2], links=[], names=r.names[:2]), None),
    (lambda r: changed(r, epoch=(1 << 52) - 1 - r.epoch), None),
    (lambda r: changed(r, epoch=MOST_LEAP + 1), None),
    (lambda r: changed(r, banned=[EVE.public.hex()]), None),
    (lambda r: changed(r, members=[*r.members, Entry(slot=9, name="Eve", key=EVE.public.hex())]), None),
]


def test_who_decides_cannot_harm_who_is_there() -> None:
    world = three()
    mallory, ben, cleo = world.people
    world.kill_host()
    world.run(5.0)
    believed = ben.member.roster.members
    for harm, complaint in HARMS:
        for _ in range(3):
            say(mallory, lie(world, mallory, harm(mallory.member.roster)))
            world.run(0.2)
            assert ben.member.roster.members == believed
            assert cleo.member.roster.members == believed
        if complaint is not None:  # the others are seen by signatures alone
            assert any(complaint in said for said in ben.member.complaints)
    # And nothing is used up: an honest change is believed.
    world.leave(cleo)
    world.until(lambda: len(ben.member.roster.members) == 2, 5.0)
    world.check()


def test_who_does_not_decide_is_not_believed_by_a_newcomer_either() -> None:
    """Though what it says would be in order, if it did."""
    world = three()
    mallory = world.people[2]
    world.kill_host()
    world.run(5.0)
    root = world.kept[-1].roster
    eve = EVE.public.hex()
    names = [*root.names, NameOwner(name="Dan", key=eve)]
    forged = changed(root, epoch=9, members=[*root.members, Entry(slot=3, name="Dan", key=eve)], names=names)
    assert Belief(world.host_identity.public).vouched(lie(world, mallory, forged))
    dan = world.join("Dan", moves=False)
    for _ in range(30):
        say(mallory, lie(world, mallory, forged))
        world.run(0.1)
        assert all(person.member.roster.owners().get("Dan") != eve for person in (*world.people[:2], dan))
    world.until(lambda: dan.member.slot is not None and world.all_coupled(), 15.0)
    assert dan.member.roster.owners()["Ann"] == world.people[0].identity.public.hex()


def test_who_comes_back_to_a_place_that_was_given_away_gives_way_to_the_others() -> None:
    """Two of three decided without the lowest slot, and let somebody in there, the only place that was free."""
    world = three(FOUR.replace("users = 4", "users = 3"))
    ann, ben, cleo = world.people
    world.kill_host()
    world.run(4.0)
    for other in (ben, cleo):
        world.controls.cut(ann.identity.public, other.identity.public)
    world.run(12.0)
    dan = world.join("Dan", moves=False)
    world.controls.cut(ann.identity.public, dan.identity.public)
    world.until(lambda: dan.member.slot == 0, 15.0)
    for other in (ben, cleo, dan):
        world.controls.mend(ann.identity.public, other.identity.public)
    with pytest.raises(SessionError, match=r"Ann: all 3 slots|Ann: your slot was given"):
        world.run(40.0)
    world.people.remove(ann)
    world.run(1.0)
    assert len(rosters(world)) == 1
    assert [entry.name for entry in ben.member.roster.members] == ["Dan", "Ben", "Cleo"]


def test_who_was_cut_off_and_the_others_agree_again() -> None:
    """The lowest slot decided alone, and the others without it; more work with what the others decided."""
    world = three()
    ann, ben, cleo = world.people
    world.kill_host()
    world.run(4.0)
    for other in (ben, cleo):
        world.controls.cut(ann.identity.public, other.identity.public)
    world.run(12.0)
    assert len(ann.member.roster.members) == 1
    assert len(ben.member.roster.members) == 2
    for other in (ben, cleo):
        world.controls.mend(ann.identity.public, other.identity.public)
    world.until(lambda: len(rosters(world)) == 1 and world.all_coupled(), 20.0)
    assert {entry.name for entry in ben.member.roster.members} == set(NAMES)
    assert ann.member.slot == 0
    world.check()


def test_who_is_not_seen_by_the_one_who_decides_alone_stays_and_is_seen_again() -> None:
    world = three()
    ann, ben, cleo = world.people
    world.kill_host()
    world.run(4.0)
    held = cleo.copy.neighbours[1]
    world.controls.cut(ann.identity.public, ben.identity.public)
    world.run(12.0)
    assert len(ann.member.roster.members) == 2
    assert len(cleo.member.roster.members) == 3
    assert any("leaves out Ben, who is here" in said for said in cleo.member.complaints)
    world.controls.mend(ann.identity.public, ben.identity.public)
    world.until(lambda: len(rosters(world)) == 1 and world.all_coupled(), 15.0)
    assert len(ann.member.roster.members) == 3
    assert cleo.copy.neighbours[1] is held
    world.check()


def test_during_a_partition_nobody_takes_the_place_of_one_who_is_there() -> None:
    world = three()
    ann, ben, _ = world.people
    world.controls.cut(world.host_identity.public, ben.identity.public)
    world.run(4.0)
    mallory = world.join("Ben", moves=False, stranger=True)
    with pytest.raises(SessionError, match='"Ben" is taken'):
        world.run(20.0)
    assert mallory.member.slot is None
    assert ann.member.roster.owners()["Ben"] == ben.identity.public.hex()


def test_false_presence_of_the_host_keeps_nobody_from_deciding() -> None:
    """What the dead host said is said again, as often as one likes."""
    world = three()
    mallory = world.people[2]
    said, carry = list[bytes](), world.controls.carry

    def tapped(sender: bytes, to: bytes | None, message: bytes, *, beat: bool = False) -> None:
        if beat and sender == world.host_identity.public:
            said.append(message)
        carry(sender, to, message, beat=beat)

    world.controls.carry = tapped
    world.run(3.0)
    world.kill_host()
    world.kill(world.people[1])
    for _ in range(120):
        for raw in said[-5:]:
            carry(mallory.identity.public, None, raw, beat=True)
        world.run(0.1)
    assert len(said) >= 5
    assert {entry.name for entry in world.people[0].member.roster.members} == {"Ann", "Cleo"}
    ben = world.join("Ben", moves=False)
    world.until(lambda: ben.member.slot is not None and world.all_coupled(), 15.0)


# -- sent away ---------------------------------------------------------------------------------------------------------


def test_who_is_sent_away_is_out_and_the_others_take_new_keys() -> None:
    world = three()
    ann, ben, cleo = world.people
    epochs = {(a.name, slot): held.link.seal.epoch for a in (ann, cleo) for slot, held in a.copy.neighbours.items()}
    assert world.host is not None
    world.host.coordinator.expel("Ben")
    with pytest.raises(SessionError, match="the host expelled Ben"):
        world.run(1.0)
    world.people.remove(ben)
    ben.control.send("status", b"still here")
    ben.control.send("leave", b"")
    world.run(3.0)
    for person in (ann, cleo):
        assert {entry.name for entry in person.member.roster.members} == {"Ann", "Cleo"}
        assert ben.identity.public not in person.control.present()
        held = person.copy.neighbours[2 if person is ann else 0]
        assert held.link.seal.epoch > epochs[person.name, held.entry.slot]
    assert world.all_coupled()
    again = world.join("Ben", moves=False, stranger=True)  # the place and the name are free
    world.until(lambda: again.member.slot is not None and world.all_coupled(), 15.0)
    # Nor does anybody let it in while the host is gone.
    world.kill_host()
    world.leave(again)
    world.run(5.0)
    roster = ann.member.roster
    assert roster.banned == [ben.identity.public.hex()]


# -- without a world ---------------------------------------------------------------------------------------------------


def entry(slot: int, name: str, who: Identity) -> Entry:
    return Entry(slot=slot, name=name, key=who.public.hex())


MEMBERS = [entry(0, "Ann", ANN), entry(1, "Ben", BEN), entry(2, "Cleo", CLEO)]
BOUND = [NameOwner(name=one.name, key=one.key, slots=(one.slot,)) for one in MEMBERS]
ROOT = Roster(epoch=5, members=MEMBERS, names=BOUND)


def root(roster: Roster = ROOT) -> Decision:
    return signed(HOST, HOST.public, roster)


def api(who: Identity, roster: Roster) -> Decision:
    return signed(who, HOST.public, roster)


def test_the_host_decides_then_the_lowest_slot_that_it_let_in() -> None:
    after = api(ANN, changed(ROOT, members=[entry(0, "Dan", DAN), *ROOT.members[1:]]))
    assert order_of([root(), after]) == [BEN.public, CLEO.public, DAN.public]
    everybody = frozenset([HOST.public, BEN.public, CLEO.public, DAN.public])
    assert acting([root(), after], HOST.public, everybody) == HOST.public
    assert acting([root(), after], HOST.public, everybody - {HOST.public}) == BEN.public
    assert acting([root(), after], HOST.public, frozenset([DAN.public])) == DAN.public
    assert acting([root(), after], HOST.public, frozenset([EVE.public])) is None


def test_the_hosts_newest_word_counts_whoever_carries_it() -> None:
    belief = Belief(HOST.public)
    assert belief.receive(Decided(chain=[root()]), EVE.public, frozenset())
    newer = root(changed(ROOT, members=ROOT.members[:1]))
    assert belief.receive(Decided(chain=[newer]), EVE.public, frozenset([HOST.public]))
    assert not belief.receive(Decided(chain=[root()]), HOST.public, frozenset([HOST.public]))
    assert belief.roster == newer.roster
    # A successor cannot go back behind it.
    old = Decided(chain=[root(), api(ANN, changed(ROOT, epoch=9))])
    assert not belief.receive(old, ANN.public, frozenset([ANN.public]))
    assert belief.roster == newer.roster


def test_one_who_decides_may_go_on_from_a_lower_number_than_a_liar_before_it() -> None:
    belief, present = Belief(HOST.public), frozenset([ANN.public, BEN.public])
    belief.receive(Decided(chain=[root()]), HOST.public, present)
    high = api(ANN, changed(ROOT, epoch=MOST_LEAP))
    assert belief.receive(Decided(chain=[root(), high]), ANN.public, present)
    low = api(BEN, changed(ROOT, members=ROOT.members[1:]))
    assert not belief.receive(Decided(chain=[root(), low]), BEN.public, present)
    assert belief.receive(Decided(chain=[root(), low]), BEN.public, frozenset([BEN.public]))


def test_chains_stay_short_and_a_long_one_needs_everybody_gone() -> None:
    belief = Belief(HOST.public)
    belief.receive(Decided(chain=[root()]), HOST.public, frozenset())
    for turn in range(1, 20):
        belief.decide((ANN, BEN, CLEO)[turn % 3], changed(belief.roster))
        assert len(belief.chain) == 2
        assert belief.vouched(belief.chain)
    names = [*BOUND, NameOwner(name="Dan", key=DAN.public.hex())]
    dan = changed(belief.roster, members=[entry(3, "Dan", DAN)], names=names)
    belief.decide(ANN, dan)
    belief.decide(DAN, changed(dan))
    assert len(belief.chain) == 3
    assert belief.vouched(belief.chain)
    other = Belief(HOST.public)
    assert other.receive(Decided(chain=list(belief.chain)), DAN.public, frozenset([DAN.public]))
    assert other.roster.by_slot()[3].name == "Dan"


def test_any_change_of_a_signed_chain_is_seen() -> None:
    chain = [root(), api(ANN, changed(ROOT, members=[*ROOT.members, entry(3, "Dan", DAN)]))]
    assert Belief(HOST.public).vouched(chain)
    assert not Belief(BEN.public).vouched(chain)
    rng = np.random.default_rng(0)
    text = write_message(Decided(chain=chain))
    refused = 0
    for _ in range(300):
        body = bytearray(text)
        body[rng.integers(len(body))] = rng.choice(list(b"0123456789abcdef"))
        try:
            decided = Decided.model_validate_json(bytes(body))
        except ValueError:
            continue
        if decided != Decided(chain=chain):
            refused += 1
            assert not Belief(HOST.public).vouched(decided.chain)
    assert refused > 50
