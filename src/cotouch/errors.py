"""Every error that cotouch raises on purpose, as one tree.

::

    CotouchError
    ├── InputError (also a ValueError)   what the caller handed over cannot be used; exit code 2 on the command line
    │   ├── BodyError                    a matrix, a shape or a mesh
    │   ├── NetworkError                 users, links, springs, delays
    │   ├── DeviceError                  a device, a hand, or what couples them to the object
    │   ├── ScenarioError                a scenario, one of its options, or the file it came from
    │   ├── SessionError                 a live session: an address, keys, a layout of samples
    │   ├── RecordingError               a recording that cannot be read, written or used for what was asked
    │   ├── PageError                    what a page in a browser sent is nothing that pages send
    │   └── UnsupportedError             correct in itself, but outside what the asked-for method can do
    ├── OutputError                      a file cannot be written: the disk is full, the folder read-only, say
    └── TransportError                   this machine or its network refused: a port that is taken, say

A message is one sentence that names the thing, its value, and what would be right.
"""

import unicodedata
from collections.abc import Generator
from contextlib import contextmanager

# Control and format characters, halves of pairs and separators of lines: a terminal may obey them.
_UNPRINTABLE = {"Cc", "Cf", "Cs", "Zl", "Zp"}


def printable(text: str) -> str:
    """A text on one line, with what a terminal may obey written out as in Python; names come from anywhere."""
    return "".join(repr(letter)[1:-1] if unicodedata.category(letter) in _UNPRINTABLE else letter for letter in text)


class CotouchError(Exception):
    """Root of every error that cotouch raises on purpose."""

    def __str__(self) -> str:
        return printable(super().__str__())


class InputError(CotouchError, ValueError):
    """What the caller handed over cannot be used."""


class BodyError(InputError):
    """A body that cannot be simulated: a matrix, a shape or a mesh is wrong."""


class NetworkError(InputError):
    """A network that makes no sense: users, links, springs or delays are wrong."""


class DeviceError(InputError):
    """A device, a hand or a coupling that cannot be simulated or would not be passive."""


class ScenarioError(InputError):
    """A scenario, one of its options, or the file it came from is wrong."""


class SessionError(InputError):
    """A live session that cannot be: an address, a key, a layout of samples or one of the options is wrong."""


class RecordingError(InputError):
    """A recording that cannot be read, written or used for what was asked."""


class PageError(InputError):
    """What a page in a browser sent is nothing that pages of this version send; whoever sent it is told, and closed."""


class UnsupportedError(InputError):
    """A correct input outside what the asked-for method can do."""


@contextmanager
def naming(source: str) -> Generator[None]:
    """Names a file in what is found wrong with it meanwhile, unless it is named already.

    Args:
        source: what messages call the file; empty: nothing.
    """
    try:
        yield
    except InputError as error:
        if not source or source in str(error):
            raise
        raise type(error)(f"{source}: {error}") from error


class OutputError(CotouchError):
    """A file cannot be written; what was there before still is."""


class TransportError(CotouchError):
    """What was asked for makes sense, but this machine or its network refused it: a port that is taken, say."""
