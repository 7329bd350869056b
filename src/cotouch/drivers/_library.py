"""Loading a vendor's library when it is asked for, and saying what to do if it is not there."""

import ctypes
import os
import re
import sys
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, final

from cotouch.errors import DeviceError


@final
@dataclass(frozen=True, kw_only=True)
class Library:
    """A vendor's library.

    Attributes:
        product: whose it is, in words.
        linux: file names to try on Linux, the usual one first; with a version behind them, too.
        windows: likewise.
        mac: likewise; empty: there is none.
        variable: environment variable that names the file or its folder.
        install: where to get it, in words that end the sentence "install ...".
    """

    product: str
    linux: tuple[str, ...]
    windows: tuple[str, ...]
    mac: tuple[str, ...]
    variable: str
    install: str

    @property
    def names(self) -> tuple[str, ...]:
        """File names on this system."""
        return {"win32": self.windows, "darwin": self.mac}.get(sys.platform, self.linux)

    def load(self, path: str | None = None) -> ctypes.CDLL:
        """Loads it.

        Args:
            path: of the file or its folder; None: what the environment variable says, or else where the system looks.

        Raises:
            DeviceError: it is not there or cannot be loaded.
        """
        given = path or os.environ.get(self.variable)
        tried = _candidates(given, self.names) if given else (*self.names, *_installed(self.names))
        failed: list[str] = []
        for name in tried:
            try:
                return ctypes.CDLL(name)
            except OSError as error:
                failed.append(str(error))
        where = f"at {given}" if given else "where this system looks for libraries"
        if not self.names:
            raise DeviceError(f"{self.product} has no library for {sys.platform}; use it on Linux or Windows")
        if given and any(Path(name).exists() for name in tried):
            raise DeviceError(f"the library {given} of {self.product} cannot be loaded: {failed[-1]}")
        raise DeviceError(
            f"the library {self.names[0]} of {self.product} is not {where}; install {self.install}, or set "
            f"{self.variable} to the file or its folder"
        )

    def bind(self, library: ctypes.CDLL, name: str, result: object, arguments: Sequence[object]) -> Callable[..., Any]:
        """A function of it with its types.

        Args:
            library: as loaded.
            name: of the function.
            result: ctypes type that it returns; None: nothing.
            arguments: ctypes types that it takes.

        Raises:
            DeviceError: the library has no such function; it is too old, or another one.
        """
        try:
            function = getattr(library, name)
        except AttributeError:
            raise DeviceError(
                f"the library of {self.product} has no function {name}, so it is too old; install {self.install}"
            ) from None
        function.restype, function.argtypes = result, list(arguments)
        return function


# Where a system's own loader looks, but only for names without a version.
_FOLDERS = ("/usr/local/lib", "/usr/lib", "/usr/lib64")
_MOST_FILES = 10_000


def _candidates(given: str, names: tuple[str, ...]) -> tuple[str, ...]:
    folder = Path(given)
    if not folder.is_dir():
        return (given,)
    return (*(str(folder / name) for name in names), *_versioned(folder, names))


def _installed(names: tuple[str, ...]) -> tuple[str, ...]:
    """With a version in their names, where the system looks for libraries."""
    searched = os.environ.get("LD_LIBRARY_PATH", "").split(os.pathsep) if sys.platform.startswith("linux") else []
    folders = [*filter(None, searched), *_FOLDERS] if sys.platform != "win32" else []
    return tuple(found for folder in folders for found in _versioned(Path(folder), names))


def _versioned(folder: Path, names: tuple[str, ...]) -> tuple[str, ...]:
    """Files such as libdrd.so.3.17.5 or libdrd.3.17.5.dylib, which is all that some vendors ship; the newest first."""
    patterns = [_with_version(name) for name in names]
    found: list[tuple[tuple[int, ...], str]] = []
    try:
        with os.scandir(folder) as entries:
            for _, entry in zip(range(_MOST_FILES), entries, strict=False):
                version = next((match[1] for pattern in patterns if (match := pattern.fullmatch(entry.name))), None)
                if version is not None:
                    found.append((tuple(int(part) for part in version.split(".")), entry.path))
    except OSError:
        return ()
    return tuple(path for _, path in sorted(found, reverse=True))


def _with_version(name: str) -> re.Pattern[str]:
    stem, _, kind = name.rpartition(".")
    if kind == "dylib":
        return re.compile(rf"{re.escape(stem)}\.([0-9]{{1,9}}(?:\.[0-9]{{1,9}})*)\.dylib")
    return re.compile(rf"{re.escape(name)}\.([0-9]{{1,9}}(?:\.[0-9]{{1,9}})*)")
