"""A run as xarray has it, but for one method that would cross dimensions which have nothing to do with each other."""

from collections.abc import Hashable, Sequence
from math import prod
from typing import TYPE_CHECKING, final

import xarray as xr

from cotouch.errors import ScenarioError

if TYPE_CHECKING:
    import pandas as pd


@final
class Run(xr.Dataset):
    """A dataset whose `to_dataframe` refuses to make a row for every user beside every link and every node."""

    __slots__ = ()

    def to_dataframe(self, dim_order: Sequence[Hashable] | None = None) -> "pd.DataFrame":
        """As xarray's, of variables that have their dimensions in common, such as `run[["kinetic", "elastic"]]`.

        Args:
            dim_order: as for `xarray.Dataset.to_dataframe`.

        Raises:
            ScenarioError: no variable has all dimensions.
        """
        # A dimension of nothing, such as hands of a run without any, would leave no row of anything.
        rows = prod(max(size, 1) for size in self.sizes.values())
        full = (prod(max(size, 1) for size in variable.shape) for variable in self.variables.values())
        if rows > max(full, default=0):
            raise ScenarioError(
                f"a table of this run would cross {' with '.join(map(str, self.sizes))}, which is {rows:.2g} rows; "
                "take cotouch.tables(run), a table for each set of dimensions, or choose variables that share them"
            )
        return super().to_dataframe(dim_order)
