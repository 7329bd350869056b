# pyright: reportIncompatibleMethodOverride=false, reportPrivateUsage=false, reportUnknownMemberType=false, reportUnknownVariableType=false, reportUnknownArgumentType=false, reportUnknownParameterType=false
# numba has no types
"""What LLVM makes of a kernel.

Numba optimises each function by itself, then again with what it calls, and makes machine code of it with an entry for
Python; all of it is copied into each caller, where it is optimised and translated once more. A kernel that only kernels
call needs none of that but a form that is good to copy.
"""

import gc
import os
from pathlib import Path
from typing import Any, final

from llvmlite import binding
from llvmlite.binding import newpassmanagers
from numba.core.analysis import compute_live_variables
from numba.core.bytecode import FunctionIdentity
from numba.core.codegen import JITCodeLibrary
from numba.core.compiler import Compiler, CompileResult
from numba.core.environment import lookup_environment
from numba.core.event import Event, Listener, register
from numba.core.ir import FunctionIR, Inst, Loc, Var
from numba.core.postproc import PostProcessor, VariableLifetime
from numba.core.targetconfig import ConfigStack, TargetConfig
from numba.core.transforms import canonicalize_cfg
from numba.core.types.functions import BaseFunction

_PACKAGE = Path(__file__).parent
# How numba names a function's entry for Python, and its global variable for what it finds in Python.
_ENTRY, _ENVIRONMENT = "_ZN7cpython", "_ZN08NumbaEnv"
_COPIED = "copied"


@final
class _Numbers:
    """By which functions of one name are told apart, as two that were made inside others may be.

    Numba counts them in each process. What one has kept then meets another function of the same name and number, and
    LLVM takes one for the other.
    """

    def __next__(self) -> int:
        return int.from_bytes(os.urandom(8), "little")


_identity: Any = FunctionIdentity
_identity._unique_ids = _Numbers()


def _equal(one: Any, other: object) -> Any:
    """Numba's comparison of two sets of options, which it makes for every call that it finds the types of."""
    if not isinstance(other, TargetConfig):
        return NotImplemented
    if one._values == other._values:
        return True
    given = one._values.keys() | other._values.keys()
    return type(one) is type(other) and all(getattr(one, name) == getattr(other, name) for name in given)


def _number(options: Any) -> int:
    """Numba's hash of a set of options is one of their names, which it sorts each time."""
    return hash(type(options))


_options: Any = TargetConfig
_options.__eq__, _options.__hash__ = _equal, _number


def _call_type(self: Any, context: Any, args: Any, kws: Any) -> Any:
    """Numba's search for what a function of its own returns, which tries some ten forms, for each call several times.

    What was found once for arguments of such types and such options is found again.
    """
    key = self, context, args, tuple(kws.items()), ConfigStack.top_or_none()
    if key not in _found:
        found = _find_call_type(self, context, args, kws)
        _found[key] = found, self._impl_keys[found.args]
    found, code = _found[key]
    self._impl_keys[found.args] = code  # the last that was found is what the call becomes, whatever its options
    return found


def _variables(self: Any, value: Any) -> list[Any]:
    """Numba's list of what variables are in a part of a statement, of which most are none; it is asked very often."""
    if isinstance(value, Var):
        return [value]
    if isinstance(value, Inst):
        return value.list_vars()
    inner = value.values() if isinstance(value, dict) else value if isinstance(value, (list, tuple)) else ()
    return [variable for each in inner if type(each) not in _PLAIN for variable in _variables(self, each)]


_PLAIN = frozenset({str, int, bool, type(None), Loc})
_found: dict[Any, Any] = {}
_functions: Any = BaseFunction
_find_call_type = _functions.get_call_type
_functions.get_call_type = _call_type
_instructions: Any = Inst
_instructions._rec_list_vars = _variables


def _process(self: Any, emit_dels: bool = False, extend_lifetimes: bool = False) -> None:
    """What numba does nine times while it compiles a function, without what lives where each of its blocks begins.

    Only generators and functions of Python's objects ever ask for that, and it took a sixteenth of compiling.
    """
    function = self.func_ir
    if function.is_generator:
        _process_all(self, emit_dels, extend_lifetimes)
        return
    function.blocks = canonicalize_cfg(function.blocks)
    function.variable_lifetime, function.generator_info = VariableLifetime(function.blocks), None
    if emit_dels:
        self._insert_var_dels(extend_lifetimes=extend_lifetimes)


def _living(self: Any, block: Any) -> Any:
    """What lives where a block begins, worked out as soon as somebody asks."""
    if block not in self.block_entry_vars:
        life = VariableLifetime(self.blocks)
        found = compute_live_variables(life.cfg, self.blocks, life.usedefs.defmap, life.deadmaps.combined)
        self.block_entry_vars |= {each: found[offset] for offset, each in self.blocks.items()}
    return self.block_entry_vars[block]


_processor: Any = PostProcessor
_process_all = _processor.run
_processor.run = _process
_function: Any = FunctionIR
_function.get_block_entry_vars = _living


@final
class _Collected(Listener):
    """While something is compiled, which takes much memory and gives most of it back, it is looked through less often.

    Otherwise a tenth of the time of compiling went into looking for circles of references.
    """

    def __init__(self) -> None:
        self._depth, self._before, self._set = 0, gc.get_threshold(), gc.get_threshold()

    def on_start(self, event: Event) -> None:  # noqa: ARG002
        """Something is compiled, perhaps within something else."""
        if not self._depth:
            self._before = self._set = gc.get_threshold()
            if 0 < self._before[0] < _OBJECTS:  # 0: whoever runs this wants none of it
                self._set = (_OBJECTS, *self._before[1:])
                gc.set_threshold(*self._set)
        self._depth += 1

    def on_end(self, event: Event) -> None:  # noqa: ARG002
        """It is done."""
        self._depth -= 1
        if not self._depth and gc.get_threshold() == self._set:
            gc.set_threshold(*self._before)


# How many objects more than before are looked through; Python's own is 700.
_OBJECTS = 50_000
register("numba:compile", _Collected())


class _Code(JITCodeLibrary):
    """Code of a kernel, which counts no references: what numba does for those is left out."""

    def _optimize_functions(self, ll_module: Any) -> None:
        ll_module.data_layout = self._codegen._data_layout


@final
class EnteredCode(_Code):
    """Of a kernel that Python calls, or that is called by its symbol."""

    def _get_module_for_linking(self) -> Any:
        if self._shared_module is None:
            self._ensure_finalized()
            copied = self._final_module.clone()
            for function in copied.functions:
                if function.name.startswith(_ENTRY) and not function.is_declaration:
                    function.linkage = "internal"
            # Whoever copies it would optimise the entry, which nobody calls there.
            manager = newpassmanagers.create_new_module_pass_manager()
            manager.add_global_dead_code_eliminate_pass()
            manager.run(copied, self._codegen._pass_builder())
            for function in copied.functions:
                if function.linkage == binding.Linkage.external and not function.is_declaration:
                    function.linkage = "linkonce_odr"
            self._shared_module = copied
        return self._shared_module

    def _finalize_final_module(self) -> None:
        super()._finalize_final_module()
        translator: Any = self._codegen
        # What was copied in has had no machine code of its own, in which this would have been set.
        for variable in self._final_module.global_variables:
            if variable.name.startswith(_ENVIRONMENT) and not variable.is_declaration:
                environment = lookup_environment(variable.name)
                if environment is not None:
                    translator.set_env(variable.name, environment)


@final
class CopiedCode(_Code):
    """Of a kernel that only kernels call and that is part of each of them: there is no machine code of it alone."""

    @property
    def codegen(self) -> Any:
        """Numba's translator."""
        return _Nowhere(self._codegen)

    def _optimize_final_module(self) -> None:
        # Those that copy it optimise it as a part of themselves.
        manager = newpassmanagers.create_new_module_pass_manager()
        manager.add_always_inliner_pass()
        manager.add_sroa_pass()
        manager.add_simplify_cfg_pass()
        manager.add_instruction_combine_pass()
        manager.add_global_dead_code_eliminate_pass()
        manager.run(self._final_module, self._codegen._pass_builder())

    def _finalize_final_module(self) -> None:
        self._finalize_dynamic_globals()
        self._verify_declare_only_symbols()
        self._finalized = True

    def get_pointer_to_function(self, name: str) -> int:  # noqa: ARG002
        """None."""
        self._ensure_finalized()
        return 0

    def serialize_using_object_code(self) -> tuple[str, str, bytes]:
        """What is kept of it: only what others copy."""
        return self.name, _COPIED, self._get_module_for_linking().as_bitcode()


@final
class _Nowhere:
    """Numba's translator, for code without a place in memory: there is nothing to set."""

    def __init__(self, codegen: Any) -> None:
        self._codegen = codegen

    def __getattr__(self, name: str) -> Any:
        return getattr(self._codegen, name)

    def set_env(self, name: str, environment: Any) -> None:
        del name, environment


class _Compiler(Compiler):
    """Numba's, but a kernel of this package has one symbol in all processes, so that one may call what another made."""

    kind: type[_Code] = EnteredCode

    def define_pipelines(self) -> Any:
        identity: Any = self.state.func_id
        # Two that were made inside functions may share a name; one at the top of a module has it for itself.
        if _PACKAGE in Path(identity.filename).parents and "." not in identity.func_qualname:
            identity.unique_id = 0
            identity.unique_name = f"{identity.func_qualname}$0"
        if not self.state.flags.nrt:
            code = self.kind(self.state.targetctx.codegen(), identity.func_qualname)
            code.enable_object_caching()
            self.state["library"] = code
        return super().define_pipelines()


@final
class _EnteredCompiler(_Compiler):
    pass


@final
class _CopiedCompiler(_Compiler):
    kind = CopiedCode


def compiler(*, copied: bool) -> type[Compiler]:
    """What compiles a kernel.

    Args:
        copied: whether only kernels call it, and it is part of each of them.
    """
    return _CopiedCompiler if copied else _EnteredCompiler


def entry_of(result: Any) -> set[str]:
    """The symbol by which Python enters a function, as far as what others copy of it lacks it."""
    entered = isinstance(result._asdict()["library"], EnteredCode)
    return {result.fndesc.llvm_cpython_wrapper_name} if entered else set()


def rebuilt(context: Any, kept: Any) -> Any:
    """A compiled function from what numba has kept of it, or of `CopiedCode`.

    Args:
        context: numba's, of the processor.
        kept: what `CompileResult` was reduced to.
    """
    (name, kind, code), description, environment, signature, objectmode, lifted, annotation, start, _ = kept
    if kind != _COPIED:
        return CompileResult._rebuild(context, *kept)
    library = CopiedCode(context.codegen(), name)
    library._final_module = binding.parse_bitcode(code)
    library._finalize_final_module()
    return CompileResult(
        target_context=context,
        typing_context=context.typing_context,
        library=library,
        environment=environment,
        entry_point=context.get_executable(library, description, environment),
        fndesc=description,
        type_annotation=annotation,
        signature=signature,
        objectmode=objectmode,
        lifted=lifted,
        typing_error=None,
        call_helper=None,
        metadata=None,
        reload_init=start,
        referenced_envs=(),
    )
