"""How the two ends of a link agree on age budgets while it runs, so that damping always covers what is in force.

Each end uses a budget of its own, A, as its clock shows ages, and the damping of both must cover the sum of both
budgets; offsets of the clocks drop out of that sum and of nothing else. So an end asks, the other end grants::

    asks for more    own damping is raised    ──ask──▶     damping is raised, then
    A is raised, once the grant has stood     ◀──grant──   it is granted
    for as long as both budgets (the first
    at once: its end has yet to catch up)
    A is lowered at once                      ──ask──▶     grant and damping are lowered

A message says all that its sender knows, so that losses and repetitions do not matter: its life and the number of its
message, the other's life and message that it heard last, what it asks for, what it grants. One that was overtaken is
dropped, and a grant counts only if whoever gave it had heard the present request. An end that begins a new life (it was
restarted) has no budget until it is granted one in that life; who hears of it gives up its own until then, because what
the old life granted is gone. Budgets of one direction are at no time above what the other end grants.

**Both budgets together have a limit**, because damping follows from them, and the other end may lie: about what it
wants, and by its stamps about the ages that this end finds. Whatever was granted stays so: an end grants no more than
the limit leaves beside its own request, and requests no more for itself than it leaves beside what is granted. It
grants nothing before it has a request of its own, for one budget alone, with the clocks' offset in it, says nothing.
Who is granted less than it asked for uses that, and its guard holds back what is older.
"""

import struct
from math import inf, isfinite, isnan
from typing import final

from cotouch.errors import SessionError
from cotouch.samples._ages import LinkAges

# magic, own life, other's life as heard, own number, other's number as heard, ask, grant (NaN: nothing)
_MESSAGE = struct.Struct("<4sQQIIdd")
_MAGIC = b"ctb1"
# Numbers and lives that are said are far below what their fields hold.
_LAST = 0x7FFF_FFFF
_LAST_LIFE = 1 << 63
_MOST = 2.1e10  # no clock shows more
# Of both budgets of a link, unless a session says otherwise: over a satellite the sum of both ages is about 0.7 s. With
# 60 N/m it comes to 60 Ns/m at most, against which a hand of 40 N/m still moves its copy within seconds [s].
MOST_AGE = 2.0
_NOTHING = float("nan")


@final
class BudgetAgreement:
    """One end of one link. Opens nothing: messages in, messages and budgets out.

    Let the guard have `budget` and `total` after every call, and the copy at least the damping of `total`; where
    `total` falls, that may come later.

    Attributes:
        budget: A in force, as this end's clock shows ages; -inf: none [s].
    """

    def __init__(
        self,
        *,
        life: int,
        quantile: float = 1.0,
        margin: float = 0.25,
        slack: float = 0.0,
        patience: float = 5.0,
        every: float = 0.25,
        limit: float = MOST_AGE,
    ) -> None:
        """Starts without a budget.

        Args:
            life: grows with every restart of this end, 1 to 2^64 - 1; a time of day in nanoseconds will do.
            quantile: of the ages in the window that the budget is to cover, in (0, 1].
            margin: what is added, as a share of both ends' ages together, >= 0.
            slack: what is added besides, such as the longest step, >= 0 [s].
            patience: for so long a smaller budget must do before it is lowered, >= 0 [s].
            every: how often a message is sent as long as the other end does not answer, > 0 [s].
            limit: that both budgets may come to, > 0 [s].

        Raises:
            SessionError: an option is out of range.
        """
        if not 0 < life < 1 << 64:
            raise SessionError(f"the life of a budget's end is {life}; it must be from 1 to 2^64 - 1")
        if not 0.0 < quantile <= 1.0:
            raise SessionError(f"the quantile of ages is {quantile:g}; it must be above 0 and at most 1")
        for name, value in (("margin", margin), ("slack", slack), ("patience", patience)):
            if not 0.0 <= value < inf:
                raise SessionError(f"a budget's {name} is {value:g}; it must be finite and at least 0")
        if not 0.0 < every < inf:
            raise SessionError(f"a budget's message is due every {every:g} s; it must be a finite time above 0")
        if not 0.0 < limit < inf:
            raise SessionError(f"the limit of a link's budgets is {limit:g} s; it must be a finite time above 0")
        self.budget = -inf
        self._life = life
        self._quantile, self._margin, self._slack = quantile, margin, slack
        self._patience, self._every, self._limit = patience, every, limit
        self._ask: float | None = None  # what this end would use, as far as the limit lets it
        self._asked_for: float | None = None  # what the other end would use
        self._grant: float | None = None  # the most that the other end may use
        self._number = 0  # of the newest thing said
        self._asked = 0  # number that the present request was said with
        self._other_life = 0
        self._other_number = 0
        self._granted: float | None = None  # by the other end, of the present request
        self._granted_since = 0.0
        self._covered = 0.0
        self._due = -inf
        self._small: tuple[float, float] | None = None  # since when less would do, and how much at most

    @property
    def total(self) -> float:
        """Sum of both budgets that this end's damping must cover, >= 0 [s]."""
        return self._covered

    @property
    def settled(self) -> bool:
        """Whether the budget in force is the one wished for."""
        return self._ask is not None and self.budget == self._ask

    @property
    def beyond(self) -> float | None:
        """What both budgets would come to by what the other end asks for, where it is granted less; else None [s]."""
        if self._ask is None or self._asked_for is None or self._grant is None or self._asked_for <= self._grant:
            return None
        return self._ask + self._asked_for

    def propose(self, now: float, ages: LinkAges) -> None:
        """Looks at the ages, and asks for another budget if they call for one; to be called now and then.

        A larger one is asked for as soon as half of the margin is used up, a smaller one when one by half the margin
        smaller would have done for as long as patience lasts.

        Args:
            now: time of this end, never backwards [s].
            ages: of the link.
        """
        own, both = ages.own_quantile(self._quantile), ages.sum_quantile(self._quantile)
        if own is None or both is None:
            return
        spare = self._margin * max(0.0, both)
        self.request(now, own + self._slack + spare, spare=spare)

    def request(self, now: float, budget: float, *, spare: float = 0.0) -> None:
        """Asks for a budget; sooner for a larger one than for a smaller one.

        Args:
            now: [s].
            budget: what would do, as this end's clock shows ages [s].
            spare: how much of it is margin [s].
        """
        if self._ask is None or budget > self._ask + 0.5 * spare:
            self._change(now, budget)
            return
        if budget >= self._ask - 0.5 * spare:
            self._small = None
            return
        since, most = self._small or (now, budget)
        self._small = (since, max(most, budget))
        if now - since >= self._patience:
            self._change(now, self._small[1])

    def _change(self, now: float, budget: float) -> None:
        self._small = None
        if self._grant is not None:
            budget = min(budget, self._limit - self._grant)
        if self._ask == budget:
            return
        self._ask = budget
        self.budget = min(self.budget, budget)
        self._granted = None
        self._say()
        self._asked = self._number
        self._regrant()
        self._cover()
        self._due = now

    def _regrant(self) -> bool:
        """Grants what is asked for, as far as the limit leaves it; whether that is another grant."""
        if self._ask is None or self._asked_for is None:
            return False
        before = self._grant
        left = self._limit - self._ask
        self._grant = min(self._asked_for, left if before is None else max(left, before))
        return self._grant != before

    def message(self, now: float) -> bytes | None:
        """What is to be said now, if anything: at once after a change, and again until it is settled; later rarely."""
        if now < self._due:
            return None
        self._due = now + (4.0 if self.settled else 1.0) * self._every
        return _MESSAGE.pack(
            _MAGIC,
            self._life,
            self._other_life,
            self._number,
            self._other_number,
            _NOTHING if self._ask is None else self._ask,
            _NOTHING if self._grant is None else self._grant,
        )

    def receive(self, now: float, message: bytes) -> bool:
        """Takes a message of the other end; False if it is of no use.

        Args:
            now: [s].
            message: as it arrived.
        """
        if len(message) != _MESSAGE.size or not message.startswith(_MAGIC):
            return False
        _, life, received_life, number, received, ask, grant = _MESSAGE.unpack(message)
        if not 0 < life < _LAST_LIFE or max(number, received) > _LAST:
            return False
        if not all(isnan(value) or abs(value) <= _MOST for value in (ask, grant)):
            return False
        if life < self._other_life or (life == self._other_life and number < self._other_number):
            return False
        if life > self._other_life:
            self._forget(now)
            self._other_life = life
        self._other_number = number
        if isfinite(ask):
            self._asked_for = ask
        if self._regrant():
            self._cover()
            self._say()
            self._due = now
        if received_life != self._life or received < self._number or number == 0:
            self._due = min(self._due, now + 0.5 * self._every)
        answered = received_life == self._life and received >= self._asked
        if answered and self._ask is not None and isfinite(grant):
            granted = min(self._ask, grant)
            if granted != self._granted:
                self._granted, self._granted_since = granted, now
                self.budget = min(self.budget, granted)
        self.advance(now)
        return True

    def advance(self, now: float) -> None:
        """Raises the budget when its time has come; to be called often [s]."""
        if self._granted is None or self._grant is None:
            return
        # Without a budget the end is guarded, and couples only after it has caught up for as long as both budgets.
        if self.budget != self._granted and (self.budget == -inf or now - self._granted_since >= self._covered):
            self.budget = self._granted
            self._cover()

    def _forget(self, now: float) -> None:
        """The other end began a new life: what its old one granted is gone, and it uses nothing."""
        self.budget = -inf
        self._grant = self._asked_for = self._granted = None
        self._other_number = 0
        if self._ask is not None:  # only a grant of the new life counts
            self._say()
            self._asked = self._number
        self._cover()
        self._due = now

    def _cover(self) -> None:
        """The damping falls only with what is in force, asked for or granted."""
        if self._ask is None or self._grant is None:
            self._covered = 0.0
            return
        self._covered = max(0.0, max(self.budget, self._ask) + self._grant)

    def _say(self) -> None:
        if self._number < _LAST:
            self._number += 1
