"""Stand-ins for devices: stub libraries with a firmware behind them, and the Inverse Service."""

import os
import shutil
import subprocess
import sys
from collections.abc import Generator
from contextlib import contextmanager
from pathlib import Path

from tests.drivers.board import Board, Fault

__all__ = ["COMPILER", "Board", "Fault", "Service", "build", "firmware", "inverse_service"]

STUBS = Path(__file__).parent / "stubs"
COMPILER = shutil.which("cc") or shutil.which("gcc") or shutil.which("clang")


def build(folder: Path) -> Path:
    """Compiles the stubs; returns the folder with libdrd.so, libHD.so and firmware."""
    assert COMPILER is not None
    common = [COMPILER, "-O1", "-Wall", "-Wextra", "-Werror", "-Wno-unused-function"]
    for name in ("libdrd", "libHD"):
        subprocess.run(
            [*common, "-shared", "-fPIC", "-o", f"{folder}/{name}.so", f"{STUBS}/{name}.c", "-lm", "-lpthread"],
            check=True,
        )
    subprocess.run([*common, "-o", f"{folder}/firmware", f"{STUBS}/firmware.c", "-lm"], check=True)
    return folder


@contextmanager
def firmware(
    built: Path, folder: Path, *, system: int = 33, initialized: int = 1, wrist: bool = False
) -> Generator[Board]:
    """A device that runs by itself, for either of the stub libraries; sets $COTOUCH_STANDIN meanwhile."""
    board = Board(folder)
    board.set("system", system)
    board.set("initialized", initialized)
    board.set("wrist", int(wrist))
    board.set("offset", 3)  # numbers that the SDK gives devices need not be their order
    before = os.environ.get("COTOUCH_STANDIN")
    os.environ["COTOUCH_STANDIN"] = str(board.path)
    process = subprocess.Popen([str(built / "firmware"), str(board.path), str(board.log)])
    try:
        yield board
    finally:
        board.set("open", 0)  # whatever a test left open, the library is to look for the next board
        board.set("stop", 1)
        process.wait(5)
        if before is None:
            del os.environ["COTOUCH_STANDIN"]
        else:
            os.environ["COTOUCH_STANDIN"] = before


class Service:
    """A running Inverse Service."""

    def __init__(self, board: Board, url: str, events: str, process: subprocess.Popen[str]) -> None:
        self.board, self.url, self.events, self.process = board, url, events, process


@contextmanager
def inverse_service(folder: Path, *arguments: str) -> Generator[Service]:
    """The stand-in for the Inverse Service, as a process of its own, on free ports of 127.0.0.1."""
    board = Board(folder)
    board.set("initialized", 1)
    command = [sys.executable, str(Path(__file__).parent / "inverse_service.py"), str(folder), *arguments]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        try:
            assert process.stdout is not None
            port, events = process.stdout.readline().split()
            yield Service(board, f"ws://127.0.0.1:{port}", f"ws://127.0.0.1:{events}", process)
        finally:
            process.kill()
