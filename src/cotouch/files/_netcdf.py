"""A dataset as a NetCDF 4 file."""

from pathlib import Path
from typing import TYPE_CHECKING, Final

from cotouch.files._write import check_writable, write

if TYPE_CHECKING:
    import xarray as xr

# NetCDF 4 is HDF5 too.
NETCDF: Final = (".nc", ".nc4", ".h5", ".hdf5")


def write_netcdf(run: "xr.Dataset", path: str | Path, what: str) -> None:
    """Writes a dataset, compressed, whole or not at all; the same dataset gives the same bytes.

    The file is made in memory, so that HDF5 never meets a disk that is full: it does not get over one, and takes the
    process down at its end. That costs as much memory as the file is large, about half of what the dataset itself has.

    Args:
        run: to be written.
        path: of the file, ending in ".nc", ".nc4", ".h5" or ".hdf5" if it is an ordinary one.
        what: it is, for the message: "result".

    Raises:
        OutputError: it cannot be written; what was there before still is.
    """
    check_writable(Path(path), NETCDF)
    packed: dict[str, object] = {"zlib": True, "complevel": 1, "shuffle": True}
    encoding = {name: packed for name, values in run.data_vars.items() if values.dtype.kind == "f"}
    write(path, run.to_netcdf(None, engine="h5netcdf", encoding=encoding), what)
