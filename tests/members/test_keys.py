"""Keys of a link over a slow control plane: renewed in time, and no more looked at than an honest end says."""

import pytest
from tests.control.memory import MemoryControl, MemoryControlNetwork
from tests.live.support import entropy, identities
from tests.members.inside import KeyExchange

from cotouch.samples import RENEW_EVERY, Agreement, Opened, SealedLink


class Ends:
    def __init__(self, delay: float) -> None:
        self.network = MemoryControlNetwork(delay=delay)
        who = identities()
        self.planes: list[MemoryControl] = [self.network.join(one) for one in who]
        self.seals = SealedLink(), SealedLink()
        self.exchanges = [
            KeyExchange(
                plane,
                seal,
                other=who[1 - k].public,
                session=b"session",
                connection=k,
                entropy=entropy(k),
                secret=b"secret",
            )
            for k, (plane, seal) in enumerate(zip(self.planes, self.seals, strict=True))
        ]

    def move(self, seconds: float, step: float = 0.05) -> None:
        ends = self.network.now + seconds
        while self.network.now < ends:
            self.network.now += step
            for plane, exchange in zip(self.planes, self.exchanges, strict=True):
                for message in plane.poll():
                    exchange.receive(message.body)
                exchange.service(self.network.now, asked=False)


@pytest.mark.parametrize("delay", [0.01, 1.0])
def test_keys_are_renewed_every_hour_however_long_the_way_is(delay: float):
    ends = Ends(delay)
    ends.move(5.0)
    assert [seal.epoch for seal in ends.seals] == [1, 1]
    ends.move(RENEW_EVERY - 10.0, step=5.0)
    assert [seal.epoch for seal in ends.seals] == [1, 1]
    ends.move(20.0)
    assert [seal.epoch for seal in ends.seals] == [2, 2]
    sealed = ends.seals[0].seal(b"in the new epoch")
    assert sealed is not None
    assert isinstance(ends.seals[1].open(sealed, ends.network.now), Opened)


def test_a_flood_of_one_neighbour_costs_little(monkeypatch: pytest.MonkeyPatch):
    ends, looked = Ends(0.0), list[bytes]()
    honest = Agreement.receive
    monkeypatch.setattr(Agreement, "receive", lambda self, message: (looked.append(message), honest(self, message))[1])
    ends.move(1.0)
    looked.clear()
    for number in range(1000):
        ends.exchanges[0].receive(number.to_bytes(100, "big"))
    assert len(looked) <= 16
    ends.move(5.0)
    looked.clear()
    ends.exchanges[0].receive(b"heard again")
    assert looked == [b"heard again"]
