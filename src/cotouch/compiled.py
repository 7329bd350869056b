# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false, reportUnknownArgumentType=false, reportUnknownLambdaType=false, reportUnknownParameterType=false
# numba has no types
"""How a function becomes machine code, and how its cache on disk stays true."""

import contextlib
import errno
import hashlib
import importlib
import os
import time
import warnings
from collections.abc import Callable, Sequence
from itertools import islice
from pathlib import Path
from typing import Any, TypeVar, final

import numba
from llvmlite import binding
from numba.core import types
from numba.core.caching import CompileResultCacheImpl, FunctionCache, IndexDataCacheFile, NullCache
from numba.core.runtime.nrt import rtsys
from numba.extending import intrinsic as numba_intrinsic

from cotouch.stamps import stamp_of
from cotouch.translation import compiler, entry_of, rebuilt

try:
    import fcntl
except ImportError:  # no Unix: each process compiles for itself
    fcntl = None

F = TypeVar("F", bound=Callable[..., object])
_PACKAGE = Path(__file__).parent


def intrinsic(generator: Any) -> Any:
    """Numba's decorator; what it makes takes the arguments after `typingctx`, which types cannot say."""
    return numba_intrinsic(generator)


@intrinsic
def raised(typingctx: Any, flag: Any) -> Any:  # noqa: ARG001
    """Whether a flag of `cotouch.interrupt` is raised: a load that no optimisation takes out of a loop."""

    def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        data = context.make_array(signature.args[0])(context, builder, arguments[0]).data
        value = builder.load_atomic(data, "monotonic", 8)
        return builder.icmp_signed("!=", value, value.type(0))

    return types.boolean(flag), generate


def routine(function: F) -> F:
    """Compiles a function on first call and keeps the machine code on disk; it may allocate, and holds no lock."""
    njit: Any = numba.njit
    return stamped(njit(nogil=True, error_model="numpy", no_cfunc_wrapper=True)(function), apart=_LARGE)


def subroutine(function: F) -> F:
    """A routine that only routines call. What lets Python call one takes its share of the compilation's time."""
    njit: Any = numba.njit
    options = {"no_cpython_wrapper": True, "no_cfunc_wrapper": True}
    return stamped(njit(nogil=True, error_model="numpy", **options)(function), apart=_LARGE)


class CacheWarning(UserWarning):
    """Machine code cannot be kept on disk, so every process compiles it anew."""


# What is at least so large, in LLVM's instructions, is called by its symbol. LLVM would not inline it either, but numba
# would copy it into each caller, to optimise and translate it there once more.
_LARGE = 150
# Where functions are found that may be called so.
_apart: dict[str, tuple[str, str, tuple[Any, ...]]] = {}


@final
class _Kept(CompileResultCacheImpl):
    """What is kept of a compiled function: numba's own, and which others must be there before it."""

    apart: int | None = None

    def reduce(self, cres: Any) -> Any:
        code = _code_of(cres)
        made = code._final_module
        needs = {
            value.name: _apart[value.name] for value in made.functions if value.is_declaration and value.name in _apart
        }
        defined, apart = entry_of(cres), False
        if self.apart is not None and _large(cres, self.apart):
            defined |= {value.name for value in (*made.functions, *made.global_variables) if not value.is_declaration}
            code._shared_module = binding.parse_assembly("")
            _set_apart(cres)
            apart = True
        return needs, defined, apart, super().reduce(cres)

    def rebuild(self, target_context: Any, payload: Any) -> Any:
        needs, defined, apart, kept = payload
        for symbol, (module, name, arguments) in needs.items():
            dispatcher = getattr(importlib.import_module(module), name)
            dispatcher.compile(arguments)
            if dispatcher.overloads[arguments].fndesc.mangled_name != symbol or symbol not in _apart:
                # LLVM ends the process when it misses a symbol.
                message = f"{module}.{name} has another symbol than when this was compiled"
                raise LookupError(message)
        # Numba reads them from what is kept for linking, which lacks them.
        target_context.codegen()._engine._defined_symbols |= defined
        cres = rebuilt(target_context, kept)
        if apart:
            _set_apart(cres)
        return cres


def _code_of(cres: Any) -> Any:
    """What LLVM has of a compiled function."""
    return cres._asdict()["library"]


def _large(cres: Any, least: int) -> bool:
    """Whether a function stays apart: of so many instructions, and another process finds it by the same symbol."""
    description = cres.fndesc
    if description.inline or description.uid != 0:
        return False
    function = _code_of(cres).get_function(description.llvm_func_name)
    instructions = (instruction for block in function.blocks for instruction in block.instructions)
    return next(islice(instructions, least - 1, None), None) is not None


def _set_apart(cres: Any) -> None:
    description = cres.fndesc
    _apart[description.mangled_name] = description.modname, description.qualname, tuple(cres.signature.args)


@final
class _Files(IndexDataCacheFile):
    """Numba's files of one function, each with what it was compiled for.

    Numba's own only numbers them: two processes that keep two overloads at once may give both one number, and the next
    one would call machine code with arguments of other types.
    """

    def save(self, key: Any, data: Any) -> None:
        super().save(key, (self._source_stamp, key, data))

    def load(self, key: Any) -> Any:
        stamp, held, data = super().load(key) or (None, None, None)
        return data if (stamp, held) == (self._source_stamp, key) else None


@final
class _Turns:
    """Who compiles a function for the cache, of all processes: the others wait for it, and find it there.

    A lock is a byte of a file beside the machine code. The system takes it from a process that ends.
    """

    def __init__(self) -> None:
        self._files: dict[str, int] = {}

    def take(self, folder: str, key: Any) -> None:
        """Waits for one's turn to compile a function.

        Args:
            folder: of its cache.
            key: the function and its arguments' types.
        """
        if fcntl is None:
            return
        try:
            if folder not in self._files:
                self._files[folder] = os.open(Path(folder, _LOCKS), os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o600)
        except OSError:  # where nothing can be kept, each compiles for itself
            return
        end = time.monotonic() + _TURN
        while time.monotonic() < end:
            try:
                fcntl.lockf(self._files[folder], fcntl.LOCK_EX | fcntl.LOCK_NB, 1, _byte(key))
            except OSError as error:
                if error.errno in {errno.EACCES, errno.EAGAIN}:
                    time.sleep(_LOOK)
                    continue
            return

    def give(self, folder: str, key: Any) -> None:
        """Lets the others go on.

        Args:
            folder: of the cache.
            key: as it was taken.
        """
        if fcntl is not None and folder in self._files:
            with contextlib.suppress(OSError):
                fcntl.lockf(self._files[folder], fcntl.LOCK_UN, 1, _byte(key))


def _byte(key: Any) -> int:
    return int.from_bytes(hashlib.blake2b(repr(key).encode(), digest_size=7).digest(), "little")


# For one function another process is waited for so long, and looked for so often [s].
_TURN, _LOOK = 120.0, 0.02
_LOCKS = "kernels.lock"
_turns = _Turns()
_made = [0]


def compiled_so_far() -> int:
    """How many functions this process has compiled, for whoever tells what takes so long."""
    return _made[0]


def compile_for(dispatcher: Any, arguments: Sequence[object]) -> None:
    """Compiles a function for arguments of such types, without calling it.

    Args:
        dispatcher: what a decorator here has made.
        arguments: such as it is called with.
    """
    dispatcher.compile(tuple(numba.typeof(argument) for argument in arguments))


@final
class _Cache(FunctionCache):
    """Numba's cache of one function, without which everything works as well: only the start takes longer."""

    _impl_class = _Kept

    def __init__(self, function: Any) -> None:
        super().__init__(function)
        impl: Any = self._impl
        self._cache_file = _Files(self.cache_path, impl.filename_base, impl.locator.get_source_stamp())
        self._turn: list[Any] = []
        self._own = _PACKAGE in Path(function.__code__.co_filename).parents

    def load_overload(self, sig: Any, target_context: Any) -> Any:
        if not self._own:
            return super().load_overload(sig, target_context)
        # Numba would read in all that it compiles with, as its compiler does anyway. Our machine code calls none of it.
        rtsys.initialize(target_context)
        return self._load_overload(sig, target_context)

    def _load_overload(self, sig: Any, target_context: Any) -> Any:
        found = self._loaded(sig, target_context)
        if found is None:
            self._turn.append(self._key(sig))
            _turns.take(self.cache_path, self._turn[-1])
            found = self._loaded(sig, target_context)  # another process may have compiled it meanwhile
            if found is not None:
                self.give_turn()
        return found

    def give_turn(self) -> None:
        """Lets others compile what is compiled here now, which was kept or is given up."""
        if self._turn:
            _turns.give(self.cache_path, self._turn.pop())

    def _key(self, sig: Any) -> Any:
        impl: Any = self._impl
        return impl.filename_base, sig

    def _loaded(self, sig: Any, target_context: Any) -> Any:
        try:
            return super()._load_overload(sig, target_context)
        except Exception:  # noqa: BLE001  (a file that was cut off can raise anything)
            self.mend()
            return None

    def _save_overload(self, sig: Any, data: Any) -> None:
        try:
            self.mend()
            super()._save_overload(sig, data)
        except OSError as error:
            _not_kept(f"{self.cache_path}: {error.strerror or error}")
        finally:
            self.give_turn()
            _made[0] += 1

    def bind(self, stamp: tuple[str, int]) -> None:
        """What is kept is valid as long as the sources have this stamp."""
        index: Any = self._cache_file
        index._source_stamp = stamp

    def mend(self) -> dict[Any, Any]:
        """The index; a new one in place of one that cannot be read."""
        index: Any = self._cache_file
        try:
            return index._load_index()
        except Exception:  # noqa: BLE001  (likewise)
            with contextlib.suppress(OSError):
                index.flush()
            return {}


def _not_kept(reason: str) -> None:
    """Says once in a process why machine code is not kept."""
    if not _told:
        _told.append(reason)
        text = f"kernels are compiled anew in every process, for up to some minutes: they cannot be kept ({reason})"
        warnings.warn(text, CacheWarning, stacklevel=2)


_told: list[str] = []


@final
class _WhenAsked:
    """A function's cache, opened when something is asked of it: most of what a process imports it never calls."""

    def __init__(self, function: Any, apart: int | None, stamp: tuple[str, int] | None) -> None:
        self._as, self._opened = (function, apart, stamp), None

    def opened(self) -> Any:
        """The cache; one that holds nothing where nothing can be kept."""
        if self._opened is None:
            self._opened = _open(*self._as)
        return self._opened

    def give_turn(self) -> None:
        """Lets others compile what could not be compiled here."""
        if isinstance(self._opened, _Cache):
            self._opened.give_turn()

    def __getattr__(self, name: str) -> Any:
        return getattr(self.opened(), name)


def _open(function: Any, apart: int | None, stamp: tuple[str, int] | None) -> Any:
    try:
        cache: Any = _Cache(function)
    except (OSError, RuntimeError) as error:
        _not_kept(str(error) if isinstance(error, OSError) else "neither this package nor a home can be written")
        return NullCache()
    cache._impl.apart = apart
    if stamp is not None:
        cache.bind(stamp)
    return cache


def stamped(compiled: Any, *, apart: int | None = None) -> Any:
    """The compiled function with a cache on disk, which is bound to all sources that it is made of.

    numba checks only the file of the function itself when it reads its cache, so a function that calls one of another
    file would go on running old code after an edit there.

    Args:
        compiled: the function.
        apart: from how many of LLVM's instructions it is called by its symbol; None: it never is.
    """
    copied = apart is None and compiled.targetoptions.get("no_cpython_wrapper", False)
    compiled._compiler.pipeline_class = compiler(copied=copied)
    # As it is, this would compile it once more for each constant that another calls it with.
    find, plain = compiled.get_call_template, types.unliteral
    compiled.get_call_template = lambda args, kws: find(tuple(map(plain, args)), {k: plain(kws[k]) for k in kws})
    # Numba tells the cache of what was compiled, but not that it could not be.
    compile_it = compiled.compile

    def compiled_or_given_up(arguments: Any) -> Any:
        try:
            return compile_it(arguments)
        except BaseException:
            compiled._cache.give_turn()
            raise

    compiled.compile = compiled_or_given_up
    source = Path(compiled.py_func.__code__.co_filename)
    # Of the sources as they are now: by the time that it is asked they may have been edited.
    compiled._cache = _WhenAsked(compiled.py_func, apart, stamp_of(source) if source.is_file() else None)
    return compiled


def cold(compiled: Any) -> bool:
    """Whether the next call of a function compiles it, because neither memory nor the disk holds its machine code."""
    if getattr(compiled, "signatures", None):
        return False
    cache = getattr(compiled, "_cache", None)
    return isinstance(cache, _WhenAsked) and (isinstance(cache.opened(), NullCache) or not cache.mend())
