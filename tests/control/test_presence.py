"""Presence without a network: who is there says so itself, and just now."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from tests.live.support import entropy, identities

from cotouch.control import Presence

SESSION = bytes(range(32))


class Pair:
    """Beats between members, all heard by all at once."""

    def __init__(self, count: int = 2) -> None:
        self.who = identities(count)
        self.members = [Presence(one, SESSION, entropy(k)) for k, one in enumerate(self.who)]
        self.now = 0.0
        self.said: list[bytes] = []

    def run(self, seconds: float, *, silent: tuple[int, ...] = (), stopped: tuple[int, ...] = ()) -> None:
        end = self.now + seconds
        while self.now < end:
            self.now += 0.05
            for k, member in enumerate(self.members):
                beat = None if k in (*silent, *stopped) else member.beat(self.now)
                if beat is not None:
                    self.said.append(beat)
                    for j, other in enumerate(self.members):
                        if j != k and j not in stopped:
                            other.receive(beat, self.now)

    def sees(self, one: int, other: int) -> bool:
        return self.who[other].public in self.members[one].present(self.now)


def tags_of(beat: bytes) -> int:
    """How many nonces of others a beat returns, as it says itself."""
    return int.from_bytes(beat[141:143], "big")


def test_two_see_each_other_soon_and_who_falls_silent_is_gone() -> None:
    pair = Pair()
    pair.run(0.5)
    assert pair.sees(0, 1)
    assert pair.sees(1, 0)
    pair.run(2.0, silent=(1,))
    assert pair.sees(0, 1)
    pair.run(1.5, silent=(1,))
    assert not pair.sees(0, 1)
    pair.run(1.0)
    assert pair.sees(0, 1)


def test_who_leaves_is_gone_and_its_next_life_is_seen() -> None:
    pair = Pair()
    pair.run(1.0)
    last = pair.members[1].beat(pair.now, leaving=True)
    assert last is not None
    pair.members[0].receive(last, pair.now)
    assert not pair.sees(0, 1)
    pair.members[0].receive(pair.said[-1], pair.now)  # an old one is not its return
    assert not pair.sees(0, 1)
    pair.members[1] = Presence(pair.who[1], SESSION, entropy(9))
    pair.run(0.5)
    assert pair.sees(0, 1)


def test_who_stood_still_takes_nobody_for_gone() -> None:
    pair = Pair(3)
    pair.run(1.0)
    pair.run(20.0, stopped=(0,))
    assert not pair.sees(1, 0)
    pair.members[0].beat(pair.now)
    assert pair.sees(0, 1)
    pair.run(1.0)
    assert pair.sees(0, 1)
    assert pair.sees(1, 0)
    pair.run(4.0, silent=(1,))
    assert not pair.sees(0, 1)


def test_a_beat_of_another_session_or_life_is_none() -> None:
    pair = Pair()
    pair.run(1.0)
    other = Presence(pair.who[1], bytes(32), entropy(5))
    for raw in pair.said:
        other.receive(raw, pair.now)
    beat = other.beat(pair.now)
    assert beat is not None
    before = pair.members[0].refused
    assert not pair.members[0].receive(beat, pair.now)
    assert pair.members[0].refused == before + 1
    pair.run(4.0, silent=(1,))
    for _ in range(60):
        pair.members[0].receive(beat, pair.now)
        pair.members[0].receive(pair.said[-1], pair.now)
        pair.run(0.05, silent=(1,))
        assert not pair.sees(0, 1)


def test_old_lives_push_out_none_that_shows_itself() -> None:
    pair = Pair()
    lives = [Presence(pair.who[1], SESSION, entropy(20 + k)).beat(0.0) for k in range(6)]
    pair.run(1.0)
    for k in range(200):
        old = lives[k % 6]
        assert old is not None
        pair.members[0].receive(old, pair.now)
        pair.run(0.05)
        assert pair.sees(0, 1)


def test_strangers_are_no_end_of_work_and_keep_nobody_out() -> None:
    """Half a thousand made-up members at once: those who show themselves stay."""
    pair = Pair()
    pair.run(1.0)
    for k in range(600):
        beat = Presence(identities(k + 10)[-1] if k < 3 else pair.who[1], SESSION, entropy(k)).beat(0.0)
        assert beat is not None
        pair.members[0].receive(beat, pair.now)
    earlier = len(pair.said)
    pair.run(0.5)
    assert pair.sees(0, 1)
    answers = [raw for raw in pair.said[earlier:] if raw[4:36] == pair.who[0].public]
    assert answers
    assert max(map(tags_of, answers)) <= 6  # of so many lives it keeps the nonces, and the keys


@given(st.binary(max_size=400), st.integers(0, 200), st.integers(0, 255))
def test_noise_and_changed_beats_show_nobody(noise: bytes, place: int, byte: int) -> None:
    pair = Pair()
    pair.run(1.0)
    member = Presence(pair.who[0], SESSION, entropy(4))
    assert not member.receive(noise, 0.0)
    for raw in pair.said:
        changed = bytearray(raw)
        changed[place % len(raw)] = byte
        assert not member.receive(bytes(changed), 0.0)
    assert member.present(0.0) == frozenset()


def test_a_word_may_be_returned_by_the_slowest_path() -> None:
    """0.8 s each way, as in the paper, with every tenth beat lost."""
    who = identities(2)
    members = [Presence(one, SESSION, entropy(k)) for k, one in enumerate(who)]
    rng, on_its_way = np.random.default_rng(0), list[tuple[float, int, bytes]]()
    seen = 0
    for tick in range(1200):
        now = 0.05 * tick
        for k in (0, 1):
            beat = members[k].beat(now)
            if beat is not None and rng.random() > 0.1:
                on_its_way.append((now + 0.8, 1 - k, beat))
        for time, to, beat in [one for one in on_its_way if one[0] <= now]:
            members[to].receive(beat, time)
        on_its_way = [one for one in on_its_way if one[0] > now]
        seen += now > 5.0 and who[1].public in members[0].present(now)
    assert seen >= 0.99 * 1100
