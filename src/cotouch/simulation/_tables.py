"""A run as tidy tables: a row for each step of whoever took it."""

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr


def tables(run: "xr.Dataset") -> "dict[str, pd.DataFrame]":
    """Data frames of a run, for pandas, R or a spreadsheet; `to_dataframe` would cross every user with every link.

    Args:
        run: a result of `simulate`, or recordings of a session as a dataset.

    Returns:
        A table for each set of dimensions that variables have, by the names of those dimensions without `step`, joined
        by "_": "user", "user_node_axis", "direction", "hand_axis", "tick", "tick_link", and so on. Rows are the steps
        that were taken: those that a slower user never reached are left out. Steps count from 0, the initial state;
        tables of directions, hands and tools have the users' names and the time of the step.
    """
    owner = {"direction": "receiver", "hand": "hand_user", "tool": "tool_user", "rigid_tool": "rigid_tool_user"}
    groups: dict[tuple[str, ...], list[str]] = {}
    for name, variable in run.data_vars.items():
        groups.setdefault(tuple(map(str, variable.dims)), []).append(str(name))
    users = {str(name): index for index, name in enumerate(run["user"].values)}
    time = run["time"].values
    result: dict[str, pd.DataFrame] = {}
    for dims, names in groups.items():
        part = run[names]
        table = part.to_dataframe().reset_index()
        whose = "user" if "user" in dims else next((owner[dim] for dim in dims if dim in owner), None)
        if "step" in dims and whose is not None:
            row = np.array([users[str(name)] for name in table[whose]], dtype=np.int64)
            table["time"] = time[row, table["step"].to_numpy()]
            table = table[np.isfinite(table["time"])].reset_index(drop=True)
        unwanted = [name for name in table.columns if name in {"one", "other"} and "link" not in dims]
        result["_".join(dim for dim in dims if dim != "step") or "run"] = table.drop(columns=unwanted)
    return result
