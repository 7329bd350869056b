"""`cotouch export`."""

import sys
from collections.abc import Sequence
from pathlib import Path

from cotouch.cli._output import print_json, working
from cotouch.files import NETCDF, check_writable
from cotouch.recording import read_recording, recordings_dataset, save_dataset


def run(files: Sequence[Path], *, out: Path, as_json: bool) -> None:
    """Writes recordings of one session into one NetCDF file.

    Args:
        files: the recordings.
        out: file to write; None: none.
        as_json: whether to print one JSON object and nothing else on standard output.
    """
    check_writable(out, NETCDF, files)
    with working("Reading ...", quiet=as_json):
        recordings = [read_recording(file) for file in files]
    run_of_all = recordings_dataset(recordings)
    with working("Writing ...", quiet=as_json):
        save_dataset(run_of_all, out)
    sizes = {str(name): int(size) for name, size in run_of_all.sizes.items()}
    if as_json:
        print_json(
            {
                "file": str(out),
                "users": [recording.name for recording in recordings],
                "sizes": sizes,
                "missing_steps": [recording.missing for recording in recordings],
                "broken": [recording.broken for recording in recordings],
                "cut": [recording.cut for recording in recordings],
            }
        )
        return
    sys.stdout.write(f"wrote {out}: " + ", ".join(_counted(name, size) for name, size in sizes.items()) + "\n")
    for recording in recordings:
        if recording.cut is not None:
            sys.stderr.write(f"{recording.path} is {recording.cut}\n")


def _counted(name: str, count: int) -> str:
    """So many of a dimension, in words."""
    many = {"axis": "axes", "body": "bodies", "index": "indices"}.get(name, f"{name}s")
    return f"{count} {name if count == 1 else many}"
