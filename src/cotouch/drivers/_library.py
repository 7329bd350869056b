"""Loading a vendor's library when it is asked for, and saying what to do if it is not there."""

import ctypes
import os
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
        linux: file names to try on Linux, the usual one first.
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
        tried = _candidates(given, self.names) if given else self.names
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


def _candidates(given: str, names: tuple[str, ...]) -> tuple[str, ...]:
    folder = Path(given)
    return tuple(str(folder / name) for name in names) if folder.is_dir() else (given,)
