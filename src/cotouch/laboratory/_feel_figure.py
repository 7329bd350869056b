"""The Bode plot of what a hand feels."""

from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from cotouch.drawing import INK, USERS, drawn, sheet, style
from cotouch.files import write

if TYPE_CHECKING:
    import xarray as xr


def impedance_figure(found: "xr.Dataset", path: Path) -> Path:
    """Draws a result of `impedance`: magnitude and phase, the prediction as a line, the measurement as marks.

    Args:
        found: the result.
        path: of the picture, PNG.

    Raises:
        OutputError: it cannot be written.
    """
    frequency = found["frequency"].values
    with style():
        figure = sheet(4.2)
        above, below = figure.subplots(2, 1, sharex=True)
        for kind, look in (("predicted", {"color": INK}), ("measured", {"color": USERS[0], "marker": "o", "ls": ""})):
            if f"{kind}_real" not in found:
                continue
            z = found[f"{kind}_real"].values + 1j * found[f"{kind}_imag"].values
            if np.isfinite(z).any():
                above.loglog(frequency, np.abs(z), label=kind, markersize=3.5, **look)
                below.semilogx(frequency, np.degrees(np.angle(z)), markersize=3.5, **look)
        above.set(
            title=f"What user {found.attrs['user']} feels, law {found.attrs['law']}, others {found.attrs['others']}",
            ylabel="|f/v| [Ns/m]",
        )
        above.legend()
        below.set(ylabel="phase [°]", xlabel="frequency [Hz]")
        write(path, drawn(figure, dpi=160), "figure")
    return path
