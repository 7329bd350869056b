# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false, reportUnknownArgumentType=false, reportUnknownLambdaType=false, reportUnknownParameterType=false
# numba has no types
"""What a device coupling is: what its two ends do, a file for each law; simulated devices and real ones call the same.

A law is two functions of the row of an end (`EndFields`), which read what is known there and write the spring, the
damper and the push that act until the next time:

    device   F = k s + c - b v        held by the motors until the next tick; v as measured
    proxy    τ = k (s - Δy/2) + c - b ŵ       in the implicit step; Δy = T ŵ

s is `stretch`, from the place to the set position, c is `push`. Both call `share` or `pool` first, which take in what
the other end said, and hold no more in the spring than `available_energy`. Work is booked outside, so that a law cannot
forget it.
"""

import itertools
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, NamedTuple, final

import numba
from llvmlite import ir
from numba.core import types
from numba.core.types.function_type import CompileResultWAP

from cotouch.arrays import Float
from cotouch.compiled import intrinsic, stamped
from cotouch.coupling._end import END, end_row
from cotouch.errors import DeviceError
from cotouch.kernels import beyond, raises, reason, written_here

# The row of an end as machine code gets it.
_SIGNATURE: Any = types.void(types.CPointer(types.float64))


class HeldForce(NamedTuple):
    """What is known of the forces that a device's motors held.

    Attributes:
        stiffness: of all springs at the device [N/m].
        damping: b [Ns/m].
        period: longest between ticks [s].
        speed: highest of the tip from tick to tick [m/s].
        reserve: debt up to which the damping stays on [J].
        force: largest [N].
        resolution: of the tip's place [m].
    """

    stiffness: float
    damping: float
    period: float
    speed: float
    reserve: float
    force: float
    resolution: float


def held_bound(held: HeldForce) -> float:
    """What one tick can take beyond what there is, if any force may be held [J].

    Args:
        held: by the motors.
    """
    unseen = 1.5 * held.resolution * held.force * 3.0**0.5
    return (held.force + held.damping * held.speed) * held.speed * held.period + held.reserve + unseen


@final
@dataclass(frozen=True, kw_only=True)
class DeviceCoupling:
    """A law of the coupling between a device and its proxy.

    Attributes:
        name: as it is chosen.
        device: what the device's end does at a tick; reads and writes its row.
        proxy: what the proxy's end does before a step.
        source: where it is published.
        bound: what the device's end may take beyond what there is, in one tick of a held force [J].
        pools: whether both ends count on one pool of energy; else on gifts. Then the motors may give both initial
            energies, as the proxy's end may be ahead.
        rests: whether it takes the place of a tip at rest with less of its flicker (`place_at_rest`).
        parameters: that have an effect with this law only, of `friction`, `coulomb`, `ages` and `weight`.
    """

    name: str
    device: Callable[[Float], None]
    proxy: Callable[[Float], None]
    source: str = ""
    bound: Callable[[HeldForce], float] = held_bound
    pools: bool = False
    rests: bool = False
    parameters: tuple[str, ...] = ()
    _made: dict[bool, Any] = field(default_factory=dict[bool, Any], repr=False, compare=False)

    def half(self, *, proxy: bool) -> Any:
        """One of both functions, compiled on first use; takes a row, as a kernel or from Python.

        Args:
            proxy: which.

        Raises:
            DeviceError: it cannot be compiled, leaves the row of its end, or raises.
        """
        if proxy not in self._made:
            half = self.proxy if proxy else self.device
            where = None if written_here(half) else raises(half)
            if where is not None:
                raise DeviceError(
                    f'coupling "{self.name}" raises an error or asserts ({where}), which nobody catches where '
                    "couplings run; it must do without"
                )
            made = self._compiled(half)
            said = None if written_here(half) else beyond([half], _rows())
            if said is not None:
                raise DeviceError(f'coupling "{self.name}" leaves its row: {said}')
            self._made[proxy] = made
        return self._made[proxy]

    def _compiled(self, half: Callable[[Float], None]) -> Any:
        try:
            made = _compiled(half)
            made.compile((types.Array(types.float64, 1, "C"),))
        except Exception as error:  # what somebody wrote may be wrong in any way
            raise DeviceError(f'coupling "{self.name}" cannot be compiled: {reason(error, half)}') from error
        return made

    def address(self, *, proxy: bool) -> int:
        """Where `run_end` finds one of both functions, in this process.

        Args:
            proxy: which.
        """
        made = self.half(proxy=proxy)
        made.compile(_SIGNATURE)
        address = int(CompileResultWAP(made.overloads[_SIGNATURE.args]).__wrapper_address__())
        _at[address] = self
        return address


def _compiled(function: Callable[[Float], None]) -> Any:
    njit: Any = numba.njit
    made = njit(nogil=True, fastmath={"contract"}, error_model="numpy", _nrt=False)(function)
    # Without a file there is nothing beside which the machine code could be kept.
    return stamped(made) if Path(function.__code__.co_filename).is_file() else made


def _rows() -> Iterator[tuple[Float]]:
    """Ends on which a law of others is tried: without a place, near and far, rich and poor."""
    for known, gap, energy in itertools.product((0.0, 1.0), (0.0, 1e-4, 0.1), (-1.0, 0.0, 1e-3, 1.0)):
        row = end_row(stiffness=500.0, damping=2.0, cap=0.1, reserve=1e-3, initial=1e-3, most=3.0)
        row[END.T], row[END.known], row[END.energy] = 1e-3, known, energy
        row[END.gap : END.acting] = gap
        yield (row,)


@intrinsic
def run_end(typingctx: Any, address: Any, ends: Any, e: Any) -> Any:  # noqa: ARG001
    """Calls one function of a law on an end, inside kernels, which so are compiled once for all laws.

    Args:
        typingctx: of numba.
        address: of the function, in this process.
        ends: rows of ends, C-contiguous, (ends, END.length).
        e: which one.
    """

    def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        data = context.make_array(signature.args[1])(context, builder, args[1]).data
        row = builder.gep(data, [builder.mul(args[2], ir.Constant(args[2].type, END.length))])
        kind = ir.FunctionType(ir.VoidType(), [data.type])
        builder.call(builder.inttoptr(args[0], kind.as_pointer()), [row])
        return context.get_dummy_value()

    return types.void(types.intp, ends, types.intp), generate


# Whose function is at an address.
_at: dict[int, DeviceCoupling] = {}


def coupling_at(address: int) -> DeviceCoupling:
    """The coupling of which this process has a function at an address.

    Args:
        address: as `DeviceCoupling.address` gave it.
    """
    return _at[address]


# A servo is told the name of its coupling in so many bytes.
NAME_BYTES = 32

_KNOWN: dict[str, DeviceCoupling] = {}


def register_coupling(law: DeviceCoupling) -> DeviceCoupling:
    """Makes a coupling known by its name, instead of one of the same name.

    Args:
        law: the coupling.

    Raises:
        DeviceError: its name is empty, or longer than a servo is told.
    """
    if not 0 < len(law.name.encode()) <= NAME_BYTES:
        raise DeviceError(f'the name of the coupling "{law.name}" must have 1 to {NAME_BYTES} bytes')
    _KNOWN[law.name] = law
    return law


def device_couplings() -> dict[str, DeviceCoupling]:
    """All couplings that are known, by name."""
    return dict(_KNOWN)
