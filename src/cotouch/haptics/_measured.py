"""What measured places tell of one port of the motors: how fast it moves, and the work of the forces that were held."""

from collections import deque
from typing import final

from cotouch.haptics._ends import WINDOW, DeviceEnd
from cotouch.haptics._port import less
from cotouch.haptics._safety import ZERO, Vector, dot, multiple, norm

# The safety chain's speed is that over this [s]: shorter, and one step of an encoder looks quick; longer, and a device
# that is flung away has been so for long.
_QUICK = 0.004
# Slack of the passivity observer for rounding [J].
_SLACK = 1e-6


@final
class MeasuredMotion:
    """Velocity, and the passivity observer's own ledger: nothing but forces that were told and measured places.

    Attributes:
        work: of the motors [J].
        bound: what sampling alone may have made of the motion so far, at most [J]; part of the d² of two-port
            passivity.
        place: as measured last; None: never with this coupling [m].
        rate: velocity over the window, as the law takes it [m/s].
    """

    def __init__(self, most: float) -> None:
        """Has seen nothing.

        Args:
            most: largest force [N].
        """
        self.rate = ZERO
        self._most = most
        self._path = deque[tuple[float, Vector, Vector]]()
        self.restart()

    def restart(self) -> None:
        """Begins a new ledger, with no force."""
        self.place: Vector | None = None
        self.work = self.bound = 0.0
        self._farthest = self._longest = 0.0
        self._acted = ZERO

    def observe(self, place: Vector, T: float, force: Vector, end: DeviceEnd) -> None:
        """Books the tick that has passed.

        Args:
            place: measured now [m].
            T: since the last time [s].
            force: that acts from here on [N].
            end: of the coupling, which knows what sampling can make.
        """
        if self.place is not None:
            moved = less(place, self.place)
            self.work += dot(self._acted, moved)
            far = norm(moved)
            if T > 0.0 and (far > self._farthest or self._longest < T):
                self._farthest, self._longest = max(self._farthest, far), max(self._longest, T)
                self.bound = max(self.bound, end.bound(far / T, T, self._most))
        self._acted, self.place = force, place

    def excess(self, end: DeviceEnd) -> float:
        """Work of the motors beyond what the peer gave, the initial energy and the bound of sampling [J].

        Args:
            end: of the coupling.
        """
        return self.work - (end.due + end.start + self.bound + _SLACK)

    def quick(self, time: float, taken: Vector, place: Vector) -> float:
        """The quickest of the last moments, as measured [m/s]; takes `rate`, over the window, as the law takes it.

        Times are those of the measurements: a loop that is late takes nothing for quick.

        Args:
            time: of the measurement [s].
            taken: place as the law takes it [m].
            place: as measured [m].
        """
        path = self._path
        if path and time <= path[-1][0]:
            return 0.0
        path.append((time, taken, place))
        while len(path) > 2 and path[1][0] <= time - WINDOW:
            path.popleft()
        if len(path) < 2:
            return 0.0
        then, start, _ = path[0]
        self.rate = multiple(1.0 / (time - then), less(taken, start))
        for recent, _, there in reversed(path):
            if time - recent >= _QUICK:
                return norm(less(place, there)) / (time - recent)
        return 0.0
