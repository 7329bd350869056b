"""Of what a kernel's machine code is made: the content of all sources that it is compiled from."""

import functools
import hashlib
import re
from pathlib import Path

_PACKAGE = Path(__file__).parent
_IMPORT = re.compile(r"^[ \t]*from (cotouch[.\w]*) import (\([^)]*\)|.*)|^[ \t]*import (cotouch)", re.MULTILINE)
_COMMENT = re.compile(r"#.*")


@functools.cache
def _file_of(module: str) -> Path | None:
    """The file of a module of this package; of a package its `__init__.py`."""
    path = _PACKAGE.joinpath(*module.split(".")[1:])
    found = path / "__init__.py" if path.is_dir() else path.with_suffix(".py")
    return found if found.is_file() else None


@functools.cache
def _read(path: Path) -> tuple[bytes, dict[str, str]]:
    """A source, and from which modules it imports which names."""
    source = path.read_bytes()
    names: dict[str, str] = {}
    for module, listed, everything in _IMPORT.findall(_COMMENT.sub("", source.decode(errors="replace"))):
        for name in listed.strip("()").split(",") if listed else (everything,):
            words = name.split()
            if words:
                names[words[-1]] = f"{module}.{words[0]}" if module else everything
    return source, names


@functools.cache
def _digest(path: Path) -> bytes:
    """Of a source and its name."""
    source = _read(path)[0]
    name = path.relative_to(_PACKAGE).as_posix() if _PACKAGE in path.parents else path.name
    return hashlib.blake2b(f"{name}\n".encode() + source, digest_size=16).digest()


@functools.cache
def _imported(path: Path) -> frozenset[Path]:
    """Files from which one imports something. A room only hands names on: what counts is where they come from."""
    found: set[Path] = set()
    for whole in _read(path)[1].values():
        name = whole
        while True:
            module, _, last = name.rpartition(".")
            file = _file_of(module) if module else _file_of(name)
            if file is not None and file.name == "__init__.py":
                file = _file_of(name) or file
            if file is None:
                break
            if file.name != "__init__.py":
                found.add(file)
                break
            handed = _read(file)[1]
            if last not in handed or handed[last] == name:
                found.update(file.parent.rglob("*.py"))  # Made on the spot, or the room as a whole.
                break
            name = handed[last]
    return frozenset(found)


def _sources(path: Path) -> set[Path]:
    """Files whose content decides what the kernels of one are compiled to: those that it imports, and they in turn."""
    found, new = {path, *(_PACKAGE / f"{name}.py" for name in ("compiled", "passing", "translation"))}, [path]
    while new:
        more = _imported(new.pop()) - found
        found |= more
        new.extend(more)
    return found


@functools.cache
def stamp_of(path: Path) -> tuple[str, int]:
    """Of what a file's kernels are made of: by content, so that neither a checkout nor a copy compiles them anew."""
    sources = _sources(path)
    digest = hashlib.blake2b(b"".join(sorted(map(_digest, sources))), digest_size=16)
    return digest.hexdigest(), sum(len(_read(file)[0]) for file in sources)
