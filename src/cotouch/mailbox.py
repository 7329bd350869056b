"""Named numbers that one process writes and others on the same machine read: newest wins, and nobody waits.

A mailbox is a file that is mapped into memory, with four slots. The writer fills the slot after the newest and then
says that it is the newest; a reader copies the newest and looks whether it was overtaken meanwhile, for which the
writer would have to write four times. Neither ever holds the other up, whether it is slow, stopped or dead.
"""

import json
import mmap
import os
import struct
import zlib
from collections.abc import Mapping
from pathlib import Path
from typing import Final, final

import numpy as np

from cotouch.arrays import Array
from cotouch.errors import InputError

Fields = Mapping[str, tuple[tuple[int, ...], str]]

_MAGIC: Final = b"mailbox format 2"
# Magic, bytes of the description, bytes of a slot.
_HEAD: Final = struct.Struct("<16sqq")
_NEWEST: Final = struct.Struct("<q")
# In front of each slot: its number while it is whole, else -1; CRC-32 of its bytes if it is checked.
_SLOT: Final = struct.Struct("<qq")
_SLOTS: Final = 4
_TRIES: Final = 8
_LINE: Final = 64
_MOST: Final = 1 << 30


def _aligned(size: int) -> int:
    return -(-size // _LINE) * _LINE


@final
class _Layout:
    """Where everything is in the file."""

    def __init__(self, fields: Fields, *, checked: bool) -> None:
        self.fields = {name: (tuple(shape), np.dtype(kind)) for name, (shape, kind) in fields.items()}
        self.checked = checked
        self.places: dict[str, int] = {}
        size = 0
        for name, (shape, kind) in self.fields.items():
            self.places[name] = size
            size += -(-int(np.prod(shape)) * kind.itemsize // 8) * 8
        self.size = size
        entries = {name: [list(shape), kind.str] for name, (shape, kind) in self.fields.items()}
        self.description = json.dumps({"fields": entries, "checked": checked}).encode()
        self.newest = _aligned(_HEAD.size + len(self.description))
        self.first = self.newest + _LINE
        self.stride = _aligned(_SLOT.size + size)
        self.total = self.first + _SLOTS * self.stride

    def views(self, content: memoryview) -> dict[str, Array]:
        """The fields in what a slot holds."""
        return {
            name: np.ndarray(shape, kind, buffer=content, offset=self.places[name])
            for name, (shape, kind) in self.fields.items()
        }


@final
class MailboxWriter:
    """The end that writes; there is one.

    Attributes:
        fields: arrays to fill before `publish`; what is not written anew keeps its value.
        number: of the newest that was published; 0 before the first.
    """

    def __init__(self, path: Path, fields: Fields, *, checked: bool = False) -> None:
        """Makes a mailbox, readable by this user alone.

        Args:
            path: of the file; must not exist. It is removed by `close`.
            fields: shape and dtype of each array, by name.
            checked: whether readers are to compare a checksum, for what must not be torn even on machines that reorder
                what others wrote.

        Raises:
            InputError: the file cannot be made.
        """
        self.path = path
        self._layout = layout = _Layout(fields, checked=checked)
        part = path.with_name(path.name + ".part")
        try:
            if path.exists():
                raise FileExistsError(17, os.strerror(17))
            handle = os.open(part, os.O_RDWR | os.O_CREAT | os.O_EXCL, 0o600)
        except OSError as error:
            raise InputError(f"the mailbox {path} cannot be created: {error.strerror}") from error
        try:
            os.truncate(handle, layout.total)
            self._map = mmap.mmap(handle, layout.total)
        finally:
            os.close(handle)
        self._map[: _HEAD.size] = _HEAD.pack(_MAGIC, len(layout.description), layout.size)
        self._map[_HEAD.size : _HEAD.size + len(layout.description)] = layout.description
        part.rename(path)  # so that nobody attaches to half a mailbox
        self.number = 0
        self._content = bytearray(layout.size)
        self.fields: dict[str, Array] = layout.views(memoryview(self._content))

    def publish(self) -> None:
        """Makes what the fields hold now the newest."""
        layout, number = self._layout, self.number + 1
        slot = number % _SLOTS
        start = layout.first + slot * layout.stride
        content = start + _SLOT.size
        _SLOT.pack_into(self._map, start, -1, 0)
        self._map[content : content + layout.size] = self._content
        check = zlib.crc32(self._content) if layout.checked else 0
        _SLOT.pack_into(self._map, start, number, check)
        _NEWEST.pack_into(self._map, layout.newest, number)
        self.number = number

    def close(self) -> None:
        """Removes the mailbox; readers keep what they have mapped. May be called again."""
        self.path.unlink(missing_ok=True)


@final
class MailboxReader:
    """An end that reads.

    Attributes:
        number: of what was read last; 0 before.
    """

    def __init__(self, path: Path) -> None:
        """Attaches to a mailbox.

        Args:
            path: of its file.

        Raises:
            InputError: there is none, or it is no mailbox of this version.
        """
        try:
            with path.open("rb") as file:
                self._map = mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ)
        except (OSError, ValueError) as error:
            reason = error.strerror if isinstance(error, OSError) else "it is empty"
            raise InputError(f"the mailbox {path} cannot be opened: {reason}") from error
        self.number = 0
        try:
            self._layout = self._described()
        except (ValueError, KeyError, TypeError, struct.error) as error:
            raise InputError(f"the file {path} is not a mailbox of this version; remove it and start again") from error

    def _described(self) -> _Layout:
        magic, length, size = _HEAD.unpack_from(self._map)
        if magic != _MAGIC or not 0 < length < _MOST:
            raise ValueError
        described = json.loads(self._map[_HEAD.size : _HEAD.size + length])
        fields = {name: (tuple(shape), kind) for name, (shape, kind) in described["fields"].items()}
        layout = _Layout(fields, checked=bool(described["checked"]))
        if layout.size != size or layout.total != len(self._map):
            raise ValueError
        return layout

    def read(self, *, anew: bool = False) -> dict[str, Array] | None:
        """The newest, as a copy; None before the first, or if nothing came since the last call.

        Args:
            anew: whether to give the newest although it was given before.
        """
        layout = self._layout
        for _ in range(_TRIES):
            (number,) = _NEWEST.unpack_from(self._map, layout.newest)
            if number <= 0 or (number == self.number and not anew):
                return None
            start = layout.first + number % _SLOTS * layout.stride
            before, check = _SLOT.unpack_from(self._map, start)
            content = self._map[start + _SLOT.size : start + _SLOT.size + layout.size]
            after, _ = _SLOT.unpack_from(self._map, start)
            if before == after == number and (not layout.checked or zlib.crc32(content) == check):
                self.number = number
                return layout.views(memoryview(bytearray(content)))
        return None

    def close(self) -> None:
        """Lets go of the mailbox."""
        self._map.close()
