"""How a law's messages tell a force that depends on where the origin is."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import final

from cotouch.errors import NetworkError


@final
@dataclass(frozen=True, kw_only=True)
class OriginForce:
    """A hand's force f as it would be at the origin, `w = f + k x̂ + b v̂`, with its integrals; names of what is sent.

    Attributes:
        force: of the field w; only where nothing acts is it 0 [N].
        integral: of ∫w, a sum [Ns].
        double: of ∫∫w, a sum [Ns²].
        stiffness: of the number k [N/m].
        damping: of the number b [Ns/m].
        plain: of the number that is above 0 where w is f itself.
    """

    force: str
    integral: str
    double: str
    stiffness: str
    damping: str
    plain: str

    def check(self, law: str, values: Sequence[str], sums: Sequence[str], numbers: Sequence[str]) -> None:
        """Whether a law sends what it says it sends.

        Args:
            law: its name, for messages.
            values: fields of its messages that are values of now.
            sums: those that are sums.
            numbers: of its messages.

        Raises:
            NetworkError: it does not.
        """
        for name, among, what in (
            (self.force, values, "a field that is no sum"),
            (self.integral, sums, "a sum"),
            (self.double, sums, "a sum"),
            *((name, numbers, "a number") for name in (self.stiffness, self.damping, self.plain)),
        ):
            if name not in among:
                raise NetworkError(f'law "{law}" declares "{name}" of a hand, which is not {what} that it sends')
