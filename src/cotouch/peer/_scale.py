"""A copy's share of the body as members come and go: it changes at once, but rises only as far as energy pays."""

from typing import final

from cotouch.errors import NetworkError
from cotouch.mechanics import Operator, State, rescaled, slowed


@final
class CopyScale:
    """Which share of M, B and K a copy carries.

    With one member more, M/N, B/N and K/N fall at once, and energy with them; the newcomer starts with that share. With
    one less, velocity is scaled so that momentum stays, which lowers kinetic energy, and K/N rises only as far as
    energy pays: what the velocity lost, and what the body's own and the extra dampers take until it is done.

    Weight and obstacles go with K, so that what is in balance stays so. Their potential may be below 0; what it costs
    to carry more of it is counted from the lowest place at which the copy got lighter. Without that, getting lighter
    below and heavier above would be a source of energy.

    Attributes:
        operator: the body's matrices in these shares.
        stiffness: share of K, weight and obstacles; that of M and B is `operator.copy_scale`.
        tank: what there is to pay with [J].
    """

    def __init__(self, operator: Operator) -> None:
        """Starts with the shares of the model."""
        self.operator = operator
        self.stiffness = operator.copy_scale
        self.tank = 0.0
        self._model = operator
        self._low = 0.0  # least potential of the whole body at which the share fell [J]

    @property
    def rising(self) -> bool:
        """Whether the share of K still has to rise."""
        return self.stiffness < self.operator.copy_scale

    @property
    def softness(self) -> float:
        """How much softer the copy is than the model's."""
        return self._model.copy_scale / self.stiffness

    def rescale(self, copies: int, state: State, kinetic: float, elastic: float) -> float:
        """Takes part in another number of copies.

        Args:
            copies: N, >= 1.
            state: of the copy; changed in place.
            kinetic: energy [J].
            elastic: energy, of weight and obstacles too [J].

        Returns:
            What the energy changed by [J].
        """
        if copies < 1:
            raise NetworkError(f"copies is {copies}; there must be at least 1 user")
        copy_scale, before = 1.0 / copies, self.operator.copy_scale
        if copy_scale > before:
            slower = before / copy_scale
            state.velocity[:] *= slower
            state.momentum[:] *= slower
            if state.memory.size:
                slowed(state, slower)
            change = kinetic * (slower - 1.0)
            self.tank -= change
            self._set(copy_scale, self.stiffness, state)
            return change
        stiffness = min(self.stiffness, copy_scale)
        if stiffness < self.stiffness:
            self._low = min(self._low, elastic / self.stiffness)
        change = kinetic * (copy_scale / before - 1.0) + elastic * (stiffness / self.stiffness - 1.0)
        self._set(copy_scale, stiffness, state)
        return change

    def rise(self, state: State, elastic: float) -> float:
        """Raises K's share as far as the tank pays; before a step.

        Args:
            state: of the copy; changed in place.
            elastic: energy, of weight and obstacles too [J].

        Returns:
            What it rose by [J].
        """
        copy_scale, before = self.operator.copy_scale, self.stiffness
        above = elastic - before * self._low
        price = above * (copy_scale / before - 1.0)
        if price <= self.tank:
            self._set(copy_scale, copy_scale, state)
        elif self.tank > 0.0:
            self._set(copy_scale, before * (1.0 + self.tank / above), state)
        else:
            return 0.0
        self.tank = 0.0
        return elastic * (self.stiffness / before - 1.0)

    def _set(self, copy_scale: float, stiffness: float, state: State) -> None:
        before = self.stiffness / self.operator.copy_scale
        self.operator = rescaled(self._model, copy_scale=copy_scale, stiffness=stiffness)
        self.stiffness = stiffness
        state.tension[:] *= (stiffness / copy_scale) / before
