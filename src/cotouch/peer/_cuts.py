"""What was cut of one copy, and what it is told to cut: a set that only grows."""

from typing import final

import numpy as np

from cotouch.arrays import Bool, Float, Int
from cotouch.errors import NetworkError
from cotouch.mechanics import (
    BodyForce,
    Contact,
    Cutting,
    Model,
    Operator,
    State,
    Tools,
    begin_cut,
    cutting_of,
    decide_cuts,
    expose,
    sever,
)


@final
class CutSet:
    """The elements that a copy has lost, and who decided to cut each.

    Attributes:
        by: the user who decided to cut each element, from 1; 0 of those that are whole, (elements,).
        decides: whether its own blades cut, and elements break in it.
        tears: whether elements break, if it decides.
        own: which of them this copy decided itself, (elements,).
        new: elements that the last step took away.
    """

    def __init__(self, model: Model, state: State, tools: Tools | None, user: int, *, decides: bool = True) -> None:
        """Begins with a whole body.

        Args:
            model: of a body that can be cut.
            state: of the copy.
            tools: of the user; None: none.
            user: whose copy it is, from 1.
            decides: whether its own blades cut, and elements break in it.
        """
        cutting = cutting_of(model, tools=0 if tools is None else tools.mass.size)
        assert cutting is not None
        assert model.force is not None
        self.by = np.zeros(cutting.wanted.size, dtype=np.int32)
        self.new: tuple[int, ...] = ()
        self.own = np.zeros(cutting.wanted.size, dtype=np.bool_)
        self.decides, self.tears = decides, True
        self._cutting: Cutting = cutting
        self._force: BodyForce = model.force
        self._state, self._tools, self._user, self._lanes = state, tools, user, model.lanes
        self._heard, self._told = np.zeros_like(self.by), np.zeros_like(self.by)

    @property
    def debris(self) -> Bool:
        """Which rows have lost their last element, (rows,)."""
        bonds = self._cutting.bonds
        rows = bonds.debris.size
        at_row = np.repeat(np.arange(rows), np.diff(bonds.hung))
        whole = np.bincount(at_row, weights=self.by[bonds.hangs] == 0, minlength=rows)
        return np.logical_and(np.diff(bonds.hung) > 0, whole == 0.0)

    def hear(self, by: Int) -> None:
        """Takes over, after the next step, what others decided.

        Args:
            by: as `CutSet.by`; what is cut already stays as it is.

        Raises:
            NetworkError: it is of another body.
        """
        if by.shape != self.by.shape:
            raise NetworkError(f"the cuts are of {by.size} elements, but this body has {self.by.size}")
        np.copyto(self._heard, by, where=by != 0)

    def begin(self, contact: Contact | None) -> None:
        """Before a step.

        Args:
            contact: whose skin must know what is gone; None: nobody touches.
        """
        begin_cut(self._cutting, self._force.world, self._state, self._tools)
        if contact is not None:
            expose(self._cutting, self._state.memory, contact.work.fit.hidden)

    def end(self, op: Operator, step: int, ledger: Float) -> None:
        """After it: decides, and takes away what is to go.

        Args:
            op: the body, as the copy has it.
            step: number of the step, from 0.
            ledger: of it; changed.
        """
        cutting, memory, wanted = self._cutting, self._state.memory, self._cutting.wanted
        if self.decides:
            decide_cuts(cutting, memory, self._state.position, self._tools, self._user, self.tears)
        np.copyto(wanted, self._heard, where=self._heard != 0)
        self._told, self._heard = self._heard, self._told
        self._heard[:] = 0
        self.new = ()
        if sever(cutting, op, self._force, self._state, step, ledger, self._lanes):
            self.own |= (wanted != 0) & (self._told == 0) & (self.by == 0)
            self.new = tuple(np.flatnonzero((wanted != 0) & (self.by == 0)).tolist())
            self.by = np.where(self.by == 0, wanted, self.by).astype(np.int32)


def without_debris(cuts: CutSet | None, position: Float) -> Float:
    """A copy's positions without those of nodes that have lost their last element and left the object.

    Args:
        cuts: what the copy has lost; None: it cannot be cut.
        position: displacements of the rows, (rows, width) [m].

    Returns:
        Likewise, NaN in rows of debris.
    """
    if cuts is None or not cuts.by.any():
        return position
    return np.where(cuts.debris[:, None], np.nan, position)
