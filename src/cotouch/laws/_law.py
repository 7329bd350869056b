"""What a link law declares: its two functions, its parameters, what it sends and keeps, and what it may give out."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from hashlib import sha256
from math import inf, isfinite, nan
from typing import TypeAlias, final

from cotouch.errors import NetworkError
from cotouch.installed import check_own_name, installed, installed_names
from cotouch.kernels import beyond, raises, reason, written_here
from cotouch.laws._checks import factor, worked_out
from cotouch.laws._end import CompiledHalf, End
from cotouch.laws._origin_force import OriginForce
from cotouch.laws._trial import ends

# Entry points of laws that other packages bring.
GROUP = "cotouch.laws"
# Parameter of laws that can go live: most that a neighbour may push with [N].
FORCE = "force"

Half: TypeAlias = Callable[[End], None]


@final
@dataclass(frozen=True, kw_only=True)
class Tone:
    """One end of a link at one frequency.

    Attributes:
        s: complex frequency, not 0 [1/s].
        spring: K [N/m].
        parameters: of the law.
        there: `e^(-s T_ij)`, what a signal from the neighbour is multiplied by on its way.
        back: `e^(-s T_ji)`.
    """

    s: complex
    spring: float
    parameters: Sequence[float]
    there: complex
    back: complex


# Of one end: Z_ii and Z_ij of `F_ij = Z_ij v_j - Z_ii v_i` [Ns/m].
Linear: TypeAlias = Callable[[Tone], tuple[complex, complex]]


@final
@dataclass(frozen=True, kw_only=True)
class Facts:
    """What is known of one end of a link before a run.

    Attributes:
        spring: K of the link [N/m for the identity weight].
        age: greatest age of a sample at this end, at the end of the step that uses it [s].
        age_back: likewise at the other end [s].
        usual: mean age of the samples that both ends use, the same number at both; None: `delay` [s].
        spread: greatest less least age, the initial state left out, at the end where it is more [s].
        period: longest step of this end [s].
        period_back: of the other end; None: the same [s].
        mass: of a row of the whole body, in the mean, for the identity weight [kg].
        lightest: likewise of the lightest row; None: `mass` [kg].
        degree: links of this end's copy.
        degree_back: of the copy at the other end.
        tree: whether the links of three copies or more make a tree.
        rows: of the body's model; a point has one.
    """

    spring: float
    age: float
    age_back: float
    usual: float | None = None
    spread: float = 0.0
    period: float = 1e-3
    period_back: float | None = None
    mass: float = 1.0
    lightest: float | None = None
    degree: int = 1
    degree_back: int = 1
    tree: bool = False
    rows: int = 1

    @property
    def delay(self) -> float:
        """Half of what there and back take together, the same number at both ends [s]."""
        return 0.5 * (self.age + self.age_back)

    def spring_damping(self) -> float:
        """K d [Ns/m]: a damper that takes what the delay makes in a spring and damper between the copies."""
        return self.spring * self.delay

    def lag(self, filtered: float) -> float:
        """Half of what a line lags there and back that takes up what arrives over some time, the same at both ends [s].

        What has arrived is taken up in a step at the fastest, which the age of a sample has in it already.

        Args:
            filtered: that time [s].
        """
        other = self.period if self.period_back is None else self.period_back
        usual = self.delay if self.usual is None else self.usual
        return usual + 0.5 * (max(filtered - self.period, 0.0) + max(filtered - other, 0.0))


@final
@dataclass(frozen=True, kw_only=True)
class Parameter:
    """A number that a law can be given.

    Attributes:
        name: in `[synchronisation] law`.
        meaning: one sentence, with the unit.
        default: the number, or how it follows from what is known of the link.
        least: smallest that is taken.
        most: largest that is taken.
        tuned: whether it is a matter of degree, which a comparison tunes.
    """

    name: str
    meaning: str
    default: float | Callable[[Facts], float]
    least: float = 0.0
    most: float = inf
    tuned: bool = True

    def usual(self, facts: Facts, whose: str) -> float:
        """Its default at one end.

        Args:
            facts: what is known of the end.
            whose: it is, for messages.

        Raises:
            NetworkError: it cannot be worked out, or is out of its range.
        """
        what = f'{whose}: the default of "{self.name}"'
        default = self.default
        usual = worked_out(what, lambda: float(default(facts) if callable(default) else default))
        if not self.least <= usual <= self.most:
            raise NetworkError(f"{what} is {usual:g}; it must be a number from {self.least:g} to {self.most:g}")
        return usual


@final
@dataclass(frozen=True, kw_only=True)
class Law:
    """A link law; see `cotouch.laws.End` for what its functions read and write.

    Attributes:
        name: in `[synchronisation] law`.
        before: called before a step; writes `target`, `push` and `gains`. It is called for every link of the copy, in
            their order, before any of them moves.
        after: called after it; writes `sent` and `sent_scalars`.
        source: where it is published.
        parameters: in the order of `End.parameters`.
        sends: names of the fields in a message.
        sends_scalars: names of the numbers in a message.
        keeps: names of the fields that an end keeps.
        keeps_scalars: names of the numbers that an end keeps.
        shares: names of the fields that the ends of a copy share.
        shares_scalars: names of the numbers that the ends of a copy share.
        feels: whether it reads `End.hand` and `End.touch`.
        passive: whether it promises that all ends together make no more energy than they begin with.
        initial_energy: name of the parameter that says what an end may make; None: nothing.
        springs: whether its links hold `½‖x_i - x_j‖²_K` at the start, which they may give back.
        rule: multiple of the rule's local damping B_i that a copy gets with it, if the scenario says nothing else.
        drag: local damping on top of it [Ns/m].
        dragless: whether copies that move evenly together feel nothing of its links, however old samples are.
        linear: what it is at one frequency and constant delay, if it is linear; `cotouch.impedance` predicts with it.
        holds: whether its promise holds with these parameters at an end; None: it does with all in their ranges.
        constant_delay: whether its promise needs samples of a constant age.
        sums: of the fields in a message, those that are integrals and go on at their rate; others are values of now.
        energies: of the numbers in a message, those by which the neighbour pays for what this end does: sums that only
            grow. Whoever believes them only up to a power bounds what a neighbour that lies can do.
        length: of the numbers in a message, the length of the sender's step, which any sample says; None: none is.
        counts: of the numbers in a message, those that tell one thing from another, so that none is near enough to the
            next; a codec says them exactly.
        origin_force: of a message, the force that depends on where the origin is; a codec judges it by what it is
            where the copy is. None: there is none.
        store: of the numbers that the ends of a copy share, the energy that they hold and what they should hold; None:
            they share none.
    """

    name: str
    before: Half
    after: Half
    source: str = ""
    parameters: tuple[Parameter, ...] = ()
    sends: tuple[str, ...] = ()
    sends_scalars: tuple[str, ...] = ()
    keeps: tuple[str, ...] = ()
    keeps_scalars: tuple[str, ...] = ()
    shares: tuple[str, ...] = ()
    shares_scalars: tuple[str, ...] = ()
    feels: bool = False
    passive: bool = True
    initial_energy: str | None = None
    springs: bool = False
    rule: float = 0.0
    drag: float = 0.0
    dragless: bool = False
    linear: Linear | None = None
    holds: Callable[[Facts, Sequence[float]], bool] | None = None
    constant_delay: bool = False
    sums: tuple[str, ...] = ()
    energies: tuple[str, ...] = ()
    length: str | None = None
    counts: tuple[str, ...] = ()
    origin_force: OriginForce | None = None
    store: tuple[str, str] | None = None
    _parts: list[CompiledHalf] = field(default_factory=list[CompiledHalf], repr=False, compare=False)

    @property
    def parts(self) -> tuple[CompiledHalf, CompiledHalf]:
        """Its two functions as machine code, made on first use.

        Raises:
            NetworkError: one cannot be compiled, or leaves an array that it works on.
        """
        if not self._parts:
            parts = [self._part(half) for half in (self.before, self.after)]
            self._keep_within()
            self._parts.extend(parts)
        return self._parts[0], self._parts[1]

    @property
    def coarse(self) -> tuple[int, ...]:
        """Which of the fields that it sends are values of now, not sums."""
        return tuple(nth for nth, name in enumerate(self.sends) if name not in self.sums)

    @property
    def live(self) -> bool:
        """Whether it can run between people who need not trust each other.

        It is passive by itself, says by which numbers a neighbour pays, and bounds a neighbour's `force`.
        """
        itself = self.passive and self.rule == 0.0 and not self.constant_delay
        return itself and bool(self.energies) and any(known.name == FORCE for known in self.parameters)

    @property
    def signature(self) -> str:
        """Tells it from another law of the same name: what messages hold, what parameters it takes."""
        held = self.sends, self.sends_scalars, self.sums, self.energies, self.length, self.counts, self.origin_force
        said = (*held, [known.name for known in self.parameters])
        return f"{self.name} {sha256(repr(said).encode()).hexdigest()[:16]}"

    def _part(self, half: Half) -> CompiledHalf:
        where = None if written_here(half) else raises(half)
        if where is not None:
            raise NetworkError(
                f'law "{self.name}" raises an error or asserts ({where}), which nobody catches where laws run; it must '
                "do without"
            )
        try:
            return CompiledHalf(half)
        except Exception as error:  # what somebody wrote may be wrong in any way
            raise NetworkError(f'law "{self.name}" cannot be compiled: {reason(error, half)}') from error

    def _keep_within(self) -> None:
        """Runs what others wrote once as Python does, because machine code checks no index."""
        halves = self.before, self.after
        if all(map(written_here, halves)):
            return
        fields, numbers = (self.sends, self.keeps, self.shares), (self.sends_scalars, self.keeps_scalars)
        usual = self.values(Facts(spring=50.0, age=0.05, age_back=0.05), {})
        said = beyond(halves, ends(usual, *map(len, fields), *map(len, (*numbers, self.shares_scalars))))
        if said is not None:
            raise NetworkError(f'law "{self.name}" leaves an array: {said}')

    def check(self, given: Mapping[str, object]) -> None:
        """Whether parameters are its own, and in range.

        Raises:
            NetworkError: one is not.
        """
        known = {parameter.name: parameter for parameter in self.parameters}
        for name, value in given.items():
            if name not in known:
                may = ", ".join(known) or "none"
                raise NetworkError(f'law.{name} is not a parameter of law "{self.name}", which has: {may}')
            own = known[name]
            if isinstance(value, str):
                if factor(value) is None:
                    raise NetworkError(
                        f'law.{name} is "{value}"; it must be a number, or a multiple of the default such as "2x"'
                    )
                continue
            number = float(value) if isinstance(value, int | float) and not isinstance(value, bool) else nan
            if not (isfinite(number) and own.least <= number <= own.most):
                bounds = f"at least {own.least:g}" if own.most == inf else f"from {own.least:g} to {own.most:g}"
                raise NetworkError(f"law.{name} is {value!r}; it must be a number {bounds}")

    def values(self, facts: Facts, given: Mapping[str, float | str]) -> list[float]:
        """All parameters of one end: what was given, or as many times the default as "2x" says, else the default.

        Args:
            facts: what is known of the end.
            given: parameters by name.

        Raises:
            NetworkError: a default cannot be worked out, or is out of its range.
        """
        result: list[float] = []
        for parameter in self.parameters:
            usual = parameter.usual(facts, f'law "{self.name}"')
            value = given.get(parameter.name, usual)
            if isinstance(value, str):
                value = min(max((factor(value) or 0.0) * usual, parameter.least), parameter.most)
            result.append(float(value))
        return result

    def response(self, tone: Tone) -> tuple[complex, complex]:
        """What `linear` says of one end at one frequency, Z_ii and Z_ij [Ns/m].

        Args:
            tone: the end; the law is linear.

        Raises:
            NetworkError: `linear` fails, or gives anything but two finite numbers.
        """
        linear = self.linear
        assert linear is not None
        own, other = worked_out(f'law "{self.name}": linear(tone)', lambda: _pair(linear, tone))
        if not (isfinite(abs(own)) and isfinite(abs(other))):
            raise NetworkError(
                f'law "{self.name}": linear(tone) is {own:g}, {other:g} at {abs(tone.s):g} 1/s; it must be finite'
            )
        return own, other

    def initial_energy_of(self, values: list[float]) -> float:
        """What an end with these parameters may make [J]."""
        names = [parameter.name for parameter in self.parameters]
        return 0.0 if self.initial_energy is None else values[names.index(self.initial_energy)]


def _pair(linear: Linear, tone: Tone) -> tuple[complex, complex]:
    own, other = linear(tone)
    return complex(own), complex(other)


_KNOWN: dict[str, Law] = {}


def register(law: Law) -> Law:
    """Makes a law known by its name, instead of one of the same name.

    Raises:
        NetworkError: its initial energy is none of its parameters, or something else that it declares none of what it
            sends.
    """
    if law.initial_energy is not None and law.initial_energy not in {parameter.name for parameter in law.parameters}:
        raise NetworkError(
            f'law "{law.name}" declares the initial energy "{law.initial_energy}", which is not one of its parameters'
        )
    for name in {*law.energies, *law.counts, *(() if law.length is None else (law.length,))} - set(law.sends_scalars):
        raise NetworkError(f'law "{law.name}" declares "{name}", which is not one of the numbers that it sends')
    for name in set(law.sums) - set(law.sends):
        raise NetworkError(f'law "{law.name}" declares the sum "{name}", which is not one of the fields that it sends')
    if law.origin_force is not None:
        law.origin_force.check(law.name, [law.sends[nth] for nth in law.coarse], law.sums, law.sends_scalars)
    _KNOWN[law.name] = law
    return law


def laws() -> dict[str, Law]:
    """All laws that are known, by name."""
    return dict(_KNOWN)


def law_named(name: str) -> Law:
    """The law of a name: one that is registered here, else one of an installed package.

    Raises:
        NetworkError: there is none of this name, it cannot be loaded, or it is no law; or it is cotouch's own, and a
            package brings one of the same name.
    """
    if name in _KNOWN:
        if written_here(_KNOWN[name].before):
            check_own_name(GROUP, name, what="law", error=NetworkError)
        return _KNOWN[name]
    loaded = installed(GROUP, name, Law, what="law", error=NetworkError)
    if loaded is None:
        names = dict.fromkeys([*_KNOWN, *installed_names(GROUP)])
        raise NetworkError(f'law is "{name}"; it must be one of {", ".join(names)}')
    if loaded.name != name:
        raise NetworkError(f'the law "{name}" calls itself "{loaded.name}"; its entry point must have this name')
    return register(loaded)
