"""What no roster may do, one fault at a time, in what is otherwise in order; without a world."""

from collections.abc import Callable

import pytest
from tests.members.inside import MOST_LEAP, Belief, order_of, signed
from tests.members.test_succession import (
    ANN,
    BEN,
    BOUND,
    CLEO,
    DAN,
    EVE,
    HOST,
    MEMBERS,
    ROOT,
    api,
    changed,
    entry,
    root,
)

from cotouch.members import Decided, Decision, Former, NameOwner, Roster, SessionFile, genuine
from cotouch.network import Network
from cotouch.samples import Identity

EVERYBODY = frozenset(one.public for one in (ANN, BEN, CLEO, DAN, EVE))


def believing(*chain: Decision, sender: Identity = HOST, **about: object) -> Belief:
    belief = Belief(HOST.public, **about)  # pyright: ignore[reportArgumentType]
    for length in range(1, len(chain) + 1):
        who = (
            sender
            if length == 1
            else next(one for one in (ANN, BEN, CLEO) if one.public.hex() == chain[length - 1].signer)
        )
        assert belief.receive(Decided(chain=list(chain[:length])), who.public, EVERYBODY - {HOST.public})
    return belief


def hears(belief: Belief, chain: list[Decision], sender: Identity, present: frozenset[bytes] = EVERYBODY) -> bool:
    return belief.receive(Decided(chain=chain), sender.public, present)


def network(size: int = 3) -> Network:
    return SessionFile.from_toml(f"[session]\nusers = {size}\n").scenario.network


FAULTS: dict[str, Callable[[], list[Decision]]] = {
    "it does not begin with the host": lambda: [api(ANN, ROOT), api(ANN, changed(ROOT))],
    "a stranger goes on": lambda: [root(), api(EVE, changed(ROOT))],
    "a stranger is between": lambda: [root(), api(EVE, changed(ROOT)), api(ANN, changed(ROOT, epoch=2))],
    "the same number": lambda: [root(), api(ANN, ROOT.model_copy(update={"links": [(0, 1)]}))],
    "a lower number": lambda: [root(), api(ANN, changed(ROOT, epoch=-1))],
    "a number that leaves none": lambda: [root(), api(ANN, changed(ROOT, epoch=(1 << 51) + 1))],
    "somebody sent away by a member": lambda: [root(), api(ANN, changed(ROOT, banned=[EVE.public.hex()]))],
    "somebody let back in by a member": lambda: [
        root(changed(ROOT, banned=[EVE.public.hex()])), api(ANN, changed(ROOT, epoch=2)),
    ],
    "somebody who never was here is gone by a member": lambda: [
        root(), api(ANN, changed(ROOT, former=[Former(key=EVE.public.hex(), slots=(2,))])),
    ],
    "a name forgotten": lambda: [root(), api(ANN, changed(ROOT, members=MEMBERS[:2], names=BOUND[:2]))],
    "a name given away": lambda: [
        root(),
        api(ANN, changed(ROOT, members=MEMBERS[:2], names=[*BOUND[:2], NameOwner(name="Cleo", key=EVE.public.hex())])),
    ],
    "another slot": lambda: [root(), api(ANN, changed(ROOT, members=[*MEMBERS[:2], entry(3, "Cleo", CLEO)]))],
    "a signature of another session": lambda: [root(), signed(ANN, BEN.public, changed(ROOT))],
    "a false signature at the end": lambda: [
        root(), api(ANN, changed(ROOT)).model_copy(update={"signature": "0" * 128}),
    ],
}  # fmt: skip


@pytest.mark.parametrize("fault", FAULTS)
def test_a_chain_with_a_fault_is_not_believed(fault: str) -> None:
    chain = FAULTS[fault]()
    assert not Belief(HOST.public).vouched(chain)
    for belief in (believing(root()), Belief(HOST.public)):
        hears(belief, chain, ANN)
        assert belief.chain in ((), (root(),), (chain[0],))
        assert belief.chain == () or belief.chain[0].signer == HOST.public.hex()
        assert belief.announced is None


def test_without_a_fault_it_is() -> None:
    assert Belief(HOST.public).vouched([root(), api(ANN, changed(ROOT, epoch=(1 << 51)))])
    assert hears(believing(root()), [root(), api(ANN, changed(ROOT, epoch=MOST_LEAP))], ANN)
    assert genuine(root(), HOST.public)


def test_a_signature_that_was_seen_is_no_other_fault_s() -> None:
    belief, good = Belief(HOST.public), root()
    assert belief.vouched([good])
    assert not belief.vouched([good.model_copy(update={"roster": changed(ROOT, members=MEMBERS[:1])})])
    chain = [good, api(ANN, changed(ROOT))]
    assert belief.vouched(chain)
    assert not belief.vouched([good, chain[1].model_copy(update={"signer": BEN.public.hex()})])


def test_a_fault_of_the_hosts_word() -> None:
    belief = believing(root())
    beside = root(ROOT.model_copy(update={"links": [(0, 1)]}))  # the same number, another roster
    assert not hears(belief, [beside], HOST)
    forged = signed(EVE, HOST.public, changed(ROOT, members=[])).model_copy(update={"signer": HOST.public.hex()})
    assert not hears(belief, [forged], HOST)
    assert belief.roster == ROOT
    # Whoever repeats the host's last word does not take back what was decided after it; the host itself does.
    without = EVERYBODY - {HOST.public}
    assert hears(belief, [root(), api(ANN, changed(ROOT, epoch=3))], ANN, without)
    assert not hears(belief, [root()], EVE, without)
    assert belief.roster.epoch == ROOT.epoch + 3
    assert belief.announced is not None
    assert len(belief.announced) == 2  # what was decided after it, still
    # Nor does the host by an older word, or with what another decided beside it.
    assert not hears(belief, [root(changed(ROOT, epoch=-1))], HOST)
    assert not hears(belief, [root(), api(ANN, changed(ROOT, epoch=4))], HOST)
    assert belief.roster.epoch == ROOT.epoch + 3
    assert hears(belief, [root()], HOST)
    assert belief.roster == ROOT


def test_what_follows_from_an_older_word_of_the_host_is_a_fault() -> None:
    belief = believing(root(changed(ROOT)))
    assert not hears(belief, [root(), api(ANN, changed(ROOT, epoch=9))], ANN)
    assert belief.roster == changed(ROOT)


def test_who_came_later_decides_where_nobody_is_left_whom_the_host_let_in() -> None:
    first = root(ROOT.model_copy(update={"members": MEMBERS[:1]}))
    second = api(ANN, changed(ROOT, members=MEMBERS[:2]))
    third = api(BEN, changed(ROOT, members=MEMBERS[1:2], epoch=2))
    belief = believing(first)
    assert hears(belief, [first, second, third], BEN, frozenset([BEN.public]))
    # Whoever went comes back last: it decides no more, though the host let it in first.
    belief = believing(root())
    present = frozenset([BEN.public, CLEO.public])
    assert hears(belief, [root(), api(BEN, changed(ROOT, members=MEMBERS[1:]))], BEN, present)
    back = api(ANN, changed(ROOT, epoch=2))
    assert not hears(belief, [root(), back], ANN, present | {ANN.public})
    assert [entry.name for entry in belief.roster.members] == ["Ben", "Cleo"]


def test_what_a_member_decides_is_as_short_as_can_be() -> None:
    with_dan = changed(ROOT, members=[*MEMBERS, entry(3, "Dan", DAN)])
    belief = Belief(HOST.public)
    belief.decide(HOST, ROOT)
    assert belief.chain == (root(),)
    for roster, decides, signers in (
        (with_dan, ANN, [HOST, ANN]),
        (changed(with_dan), DAN, [HOST, ANN, DAN]),
        (changed(with_dan, epoch=2), BEN, [HOST, BEN]),
        (changed(with_dan, epoch=3), HOST, [HOST]),
    ):
        belief.decide(decides, roster)
        assert [one.signer for one in belief.chain] == [who.public.hex() for who in signers]
        assert belief.vouched(belief.chain)


def test_who_would_be_believed() -> None:
    belief = Belief(HOST.public)
    assert belief.entitled(HOST)
    assert not belief.entitled(ANN)
    first = root(ROOT.model_copy(update={"members": MEMBERS[:1]}))
    stages = [first, api(ANN, changed(ROOT, members=MEMBERS[:2]))]
    stages += [api(BEN, changed(ROOT, members=MEMBERS[:3], epoch=2))]
    stages += [api(CLEO, changed(ROOT, members=[*MEMBERS, entry(3, "Dan", DAN)], epoch=3))]
    assert len(stages) == 4
    assert belief.vouched(stages)
    belief.chain = tuple(stages)
    assert [belief.entitled(who) for who in (HOST, ANN, BEN, CLEO, DAN, EVE)] == [True, True, True, True, False, False]


def test_a_fault_of_who_decides() -> None:
    high = api(ANN, changed(ROOT, epoch=9))
    belief = believing(root(), high)
    for what in (
        api(ANN, changed(ROOT, epoch=8, links=[(0, 1)])),  # a lower number of the same member
        api(ANN, changed(ROOT, epoch=9, links=[(0, 1)])),  # the same once more, with something else
        api(ANN, changed(ROOT, epoch=9 + MOST_LEAP + 1)),  # a leap
    ):
        assert not hears(belief, [root(), what], ANN)
        assert belief.roster.epoch == ROOT.epoch + 9
    # Another carries what who decides has signed: it is told, and not yet believed.
    carried = api(ANN, changed(ROOT, epoch=10))
    assert not hears(belief, [root(), carried], BEN)
    assert belief.announced == (root(), carried)
    assert not hears(belief, [root(), carried], BEN, EVERYBODY - {ANN.public})  # nor if that would be its turn
    assert hears(belief, [root(), carried], ANN)


def test_a_fault_of_slots_and_springs() -> None:
    far = root(changed(ROOT, members=[*MEMBERS[:2], entry(3, "Cleo", CLEO)]))
    assert Belief(HOST.public).vouched([far])
    assert not Belief(HOST.public, network=network()).vouched([far])
    assert Belief(HOST.public, network=network(4)).vouched([far])
    text = "[network]\nusers = ['Ann', 'Ben', 'Cleo']\nspring = [[0, 9, 0], [9, 0, 9], [0, 9, 0]]\n"
    few = SessionFile.from_toml(f"{text}delay = [[0, 1, 1], [1, 0, 1], [1, 1, 0]]\n").scenario.network
    assert Belief(HOST.public, network=few).vouched([root(changed(ROOT, links=[(0, 1)]))])
    assert not Belief(HOST.public, network=few).vouched([root(changed(ROOT, links=[(0, 2)]))])


def test_a_fault_that_harms_who_is_here_is_said() -> None:
    """From one stage to the next; from the host's word on signatures alone show some of it."""
    away = changed(ROOT, members=MEMBERS[:2])
    before = [root(away), api(ANN, changed(away, members=MEMBERS, epoch=2))]
    for commanded, harm in (
        ("leaves out Cleo", changed(away, epoch=4)),
        ("changes the slot or the name", changed(away, epoch=4, members=[*MEMBERS[:2], entry(3, "Cleo", CLEO)])),
        (
            "gives Cleo's name to another",
            changed(away, epoch=4, names=[*BOUND[:2], NameOwner(name="Cleo", key=EVE.public.hex())]),
        ),
    ):
        if commanded.startswith("gives"):
            first = root(changed(away, names=BOUND[:2]))
            second = api(ANN, changed(first.roster, members=MEMBERS, names=BOUND, epoch=2))
            belief, start = believing(first, second), first
        else:
            belief, start = believing(*before), before[0]
        assert not hears(belief, [start, api(ANN, harm)], ANN, EVERYBODY)
        assert belief.complaint is not None
        assert commanded in belief.complaint
        assert [one.slot for one in belief.roster.members] == [0, 1, 2]
        gone = EVERYBODY - {CLEO.public}
        assert hears(belief, [start, api(ANN, changed(harm))], ANN, gone)  # who is not here is not harmed


def test_a_fault_that_takes_this_members_place_for_another_start() -> None:
    mine = [*MEMBERS[:2], MEMBERS[2].model_copy(update={"start": "1" * 16})]
    belief = believing(root(changed(ROOT, members=mine)), own=CLEO.public, start="1" * 16)
    taken = changed(ROOT, members=[*MEMBERS[:2], MEMBERS[2].model_copy(update={"start": "2" * 16})], epoch=2)
    assert not hears(belief, [belief.chain[0], api(ANN, taken)], ANN)
    assert "another run" in str(belief.complaint)


def split(*, signer: Identity = BEN, own: Identity | None = ANN) -> tuple[Belief, Decision]:
    """One who works with what Ann decided, and heard what another did, or she herself, to somebody's harm."""
    belief = believing(root(), own=None if own is None else own.public)
    alone = api(ANN, changed(ROOT, members=MEMBERS[:1], epoch=2))
    assert hears(belief, [root(), alone], ANN, frozenset([ANN.public]))
    other = api(signer, changed(ROOT, members=MEMBERS[1:], epoch=3))
    assert not hears(belief, [root(), other], signer, frozenset([ANN.public, BEN.public, CLEO.public]))
    return belief, other


def test_a_fault_of_the_majority() -> None:
    all_three = frozenset(one.public for one in (ANN, BEN, CLEO))
    belief, other = split()
    mine, theirs = belief.roster.digest, other.roster.digest
    votes: dict[bytes, str | None] = {ANN.public: mine, CLEO.public: mine}
    assert not belief.settle(votes, all_three)  # one of three
    assert not belief.settle({}, frozenset())  # nobody is there at all
    assert not belief.settle(
        {EVE.public: theirs, DAN.public: theirs}, all_three
    )  # of those whom the host did not let in
    assert not belief.settle({ANN.public: mine}, frozenset([ANN.public, BEN.public]))  # as many: Ann's slot is lower
    assert belief.settle({ANN.public: mine, CLEO.public: theirs}, all_three)
    assert belief.roster == other.roster
    # Of a watcher, which is in no roster, the one who decides counts; the same one's other word is no better.
    watcher, _ = split(own=None)
    assert not watcher.settle({}, frozenset())
    assert not watcher.settle({}, frozenset([ANN.public, BEN.public]))
    watcher, _ = split(signer=ANN, own=None)
    assert not watcher.settle({}, frozenset([ANN.public, BEN.public]))
    # Who came later may be believed by most, but is nobody's lower slot.
    after = api(ANN, changed(ROOT, members=[*MEMBERS, entry(3, "Dan", DAN)]))
    belief = believing(root(), after, own=ANN.public)
    other = api(DAN, changed(after.roster, members=after.roster.members[2:]))
    assert not hears(belief, [root(), after, other], DAN)
    assert not belief.settle({BEN.public: other.roster.digest}, frozenset([ANN.public, BEN.public]))
    assert belief.settle({who.public: other.roster.digest for who in (BEN, CLEO)}, all_three)
    # Who is gone is not counted on either side.
    belief, other = split()
    assert belief.settle({}, frozenset([BEN.public]))
    # As many for either: the lower slot.
    belief = believing(root(), own=BEN.public)
    present = frozenset([BEN.public, CLEO.public])
    assert hears(belief, [root(), api(BEN, changed(ROOT, members=MEMBERS[1:], epoch=2))], BEN, present)
    other = api(ANN, changed(ROOT, members=MEMBERS[:1], epoch=2))
    hears(belief, [root(), other], ANN, present)
    assert not belief.settle({}, frozenset())  # of none who is there as many are for either, too
    assert belief.settle({BEN.public: belief.roster.digest}, frozenset([ANN.public, BEN.public]))
    assert belief.roster == other.roster


def test_who_left_does_not_decide_by_a_fault() -> None:
    after = api(ANN, changed(ROOT, members=MEMBERS[1:]))
    assert order_of([root(), after]) == [BEN.public, CLEO.public]


ROSTERS: dict[str, dict[str, object]] = {
    "a name has two keys": {"names": [*BOUND, {"name": "Ann", "key": EVE.public.hex()}]},
    "a key two names": {"names": [*BOUND, {"name": "Eve", "key": ANN.public.hex()}]},
    "left twice": {"former": [{"key": EVE.public.hex(), "slots": [k]} for k in (1, 2)]},
    "who was expelled": {"banned": [BEN.public.hex()]},
    "slots are not in order": {"members": [MEMBERS[1], MEMBERS[0]]},
    "a link is not between two": {"links": [(1, 0)]},
    "two users who are present": {"links": [(0, 3)]},
    "links are not in order": {"links": [(1, 2), (0, 1)]},
    "less than": {"epoch": 1 << 52},
}


@pytest.mark.parametrize("fault", ROSTERS)
def test_a_roster_with_a_fault_is_none(fault: str) -> None:
    with pytest.raises(ValueError, match=fault):
        Roster.model_validate(ROOT.model_dump() | ROSTERS[fault])
