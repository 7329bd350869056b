"""The tables of a scenario for tools: proxies, the devices that move them, and the hands on those."""

import math
from collections.abc import Mapping, Sequence
from typing import Annotated, Literal, Self, cast, final, get_args

from pydantic import Discriminator, Field, FiniteFloat, Tag, model_validator

from cotouch.device import PRESETS, installed_coupling
from cotouch.errors import DeviceError, ScenarioError
from cotouch.installed import check_own_name
from cotouch.kernels import written_here
from cotouch.mechanics import conform_contact_law, contact_law_named
from cotouch.scenario._surface_tables import SnapTable, TextureTable
from cotouch.scenario._tables import Coordinate, Firm, Hard, NonNegative, Number, Place, Positive, Table, check_times

# Of a device's servo, where neither a scenario nor a product says it [Hz].
DEFAULT_RATE = 1000.0
Kind = Literal["touch", "grasp", "blade"]
# A stylus is a row of balls half a radius apart; a step that asks millions of them would not end.
_SLIMMEST = 1000
# Kinds of tools that are rigid bodies.
RIGID = ("box", "cylinder", "sphere", "file")
# Options of a hand that only one on a device has, and of a device what a coupling has not.
_OF_DEVICES = ("mass", "reaction", "correction", "reach", "blend")
_WITHOUT = {
    "host_force": ("rate", "periods", "window", "cap", "reserve", "assumed_damping"),
    "virtual": ("cap", "assumed_damping"),
}


def _path_form(value: object) -> str:
    return "waypoints()" if isinstance(value, list) and any(isinstance(row, list) for row in value) else "place()"  # pyright: ignore[reportUnknownVariableType]


ToolPath = Annotated[
    Annotated[list[Coordinate], Tag("place()")] | Annotated[list[list[Coordinate]], Tag("waypoints()")],
    Discriminator(_path_form),
]


@final
class ToolHand(Table):
    """What moves a tool: a spring and damper to an equilibrium point on a path; on a device a whole hand.

    By default the hand of van Beek et al. 2015, one typical trial.

    Attributes:
        path: where the equilibrium goes, from the tool's start [m]: one place, or waypoints [time, x, y, z] with
            straight lines between them.
        amplitude: of a sine added to the path [m].
        frequency: of the sine [Hz].
        phase: of the sine [rad].
        stiffness: [N/m].
        damping: [Ns/m].
        grip: factor on stiffness and damping, ¼ to 4.
        begin: when it takes hold [s].
        release: when it lets go [s]; by default never.
        mass: that moves with the device's tip [kg]; like all that follow, with a device only.
        reaction: delay of the will [s].
        correction: how fast the will corrects the tip's error [1/s].
        reach: farthest that it goes for this [m].
        blend: over which the equilibrium comes to its path after taking hold [s].
    """

    path: ToolPath = Field(default_factory=lambda: [0.0, 0.0, 0.0])
    amplitude: Place = Field(default_factory=lambda: [0.0, 0.0, 0.0])
    frequency: NonNegative = 0.0
    phase: FiniteFloat = 0.0
    stiffness: Firm = 135.0
    damping: Firm = 6.45
    grip: Annotated[float, Field(ge=0.25, le=4.0)] = 1.0
    begin: NonNegative = 0.0
    release: NonNegative | None = None
    mass: NonNegative = 0.554
    reaction: Positive = 0.15
    correction: NonNegative = 0.0
    reach: NonNegative = 0.05
    blend: Positive = 0.3

    @model_validator(mode="after")
    def _after(self) -> Self:
        rows = [row for row in self.path if isinstance(row, list)]
        if rows and any(len(row) != 4 for row in rows):
            wrong = next(row for row in rows if len(row) != 4)
            raise ValueError(f"path has the waypoint {wrong}; it must be a time and 3 numbers")
        if not rows and len(self.path) != 3:
            raise ValueError(f"path is {self.path}; it must be 3 numbers or waypoints [time, x, y, z]")
        check_times(self.begin, self.release, [row[0] for row in rows])
        return self


@final
class SimulatedDeviceTable(Table):
    """A simulated device between a hand and a tool; see `cotouch.device`.

    Attributes:
        preset: a product with its nominal mass, force, friction, resolution and rate; what is given here goes first.
        kind: "cartesian", or "phantom" for the PHANToM 1.5 with its own dynamics (the default of that preset).
        mass: apparent at the tip of a Cartesian device [kg].
        viscous: friction [Ns/m]; of a PHANToM's joints [Nm s/rad].
        coulomb: friction [N]; of a PHANToM's joints [Nm].
        rate: of the servo [Hz]; like the others of the servo, not with "host_force", where the body's step sets the
            pace.
        periods: of the servo, used in turn, instead of a rate [s].
        window: over which velocity is measured [s].
        resolution: of the encoders [m], of a PHANToM's joints [rad].
        force: largest [N].
        coupling: "pspm" (passive whatever the rates), "virtual" (a sampled spring-damper; refused where the device's
            own damping is too little for its rate, or its dry friction for its encoders), another of
            `cotouch.mechanics.device_couplings`, or "host_force" (a virtual coupling that the body's step computes).
        stiffness: of the coupling [N/m].
        damping: of the coupling [Ns/m].
        cap: most energy that the tank keeps [J].
        reserve: debt up to which PSPM's damping stays on [J].
        assumed_damping: damping of the device itself that PSPM may count on [Ns/m].
        clip_stiffness: lower a stiffness that is too much instead of refusing it.
    """

    preset: str | None = None
    kind: Literal["cartesian", "phantom"] | None = None
    mass: Positive | None = None
    viscous: NonNegative | None = None
    coulomb: NonNegative | None = None
    rate: Positive | None = None
    periods: Annotated[list[Positive], Field(min_length=1, max_length=1000)] | None = None
    window: NonNegative = 0.02
    resolution: NonNegative | None = None
    force: Positive | None = None
    coupling: str = "pspm"
    stiffness: Positive = 500.0
    damping: NonNegative = 2.0
    cap: NonNegative = 0.1
    reserve: NonNegative = 1e-3
    assumed_damping: NonNegative = 0.0
    clip_stiffness: bool = False

    @model_validator(mode="after")
    def _after(self) -> Self:
        if self.coupling != "host_force":
            try:
                installed_coupling(self.coupling, others=("host_force",))
            except DeviceError as error:
                raise ValueError(str(error)) from None
        if self.preset is not None and self.preset not in PRESETS:
            raise ValueError(f'preset is "{self.preset}"; it must be one of {", ".join(PRESETS)}')
        if self.rate is not None and self.periods is not None:
            raise ValueError("rate and periods are given; give only one of them")
        if self.kind == "phantom" and self.preset not in (None, "phantom"):
            raise ValueError(f'kind is "phantom" but preset is "{self.preset}"; leave one of them out')
        if self.sort() == "phantom" and self.mass is not None:
            raise ValueError(f"mass is {self.mass} kg; a PHANToM has its own, leave it out")
        for name in _WITHOUT.get(self.coupling, ()):
            if name in self.model_fields_set:
                raise ValueError(f'{name} is given, but with coupling "{self.coupling}" it has no effect; leave it out')
        return self

    def sort(self) -> Literal["cartesian", "phantom"]:
        """How it moves."""
        return self.kind or ("phantom" if self.preset == "phantom" else "cartesian")


@final
class ContactTable(Table):
    """How tools touch.

    Attributes:
        law: whose energy is a function of where body and tools are: "stiffening" or "foundation".
        parameters: of the law, by name.
        viscosity: of a film on the skin: drag on each of the area that a tool covers, of each speed along it [Ns/m³].
        snap: what draws tools to the skin; by default nothing does.
        texture: a relief on the skin; by default it is smooth.
    """

    law: str = "stiffening"
    parameters: dict[str, FiniteFloat] = Field(default_factory=dict[str, float])
    viscosity: NonNegative = 0.0
    snap: SnapTable | None = None
    texture: TextureTable | None = None

    def made(self) -> tuple[float, ...]:
        """The law for the kernels.

        Raises:
            ScenarioError: there is no such law, it breaks the interface, also with these parameters, or has no such
                parameter; or it is cotouch's own, and a package brings one of the same name.
        """
        kind = contact_law_named(self.law)
        own = written_here(kind)
        if own:
            check_own_name("cotouch.contact_laws", self.law, what="contact law", error=ScenarioError)
        known = cast("tuple[str, ...]", getattr(kind, "_fields", ()))
        for name, value in self.parameters.items():
            if name not in known or not value > 0.0:
                has = f"has {', '.join(known)}, each above 0"
                raise ScenarioError(f'contact.parameters.{name} is {value:g}; law "{self.law}" {has}')
        law = kind(**self.parameters)
        for broken in [] if own or not self.parameters else conform_contact_law(law):
            raise ScenarioError(f'contact law "{self.law}" breaks the interface with {law}: {broken}')
        return law

    def refuse(self, tools: Sequence[Table]) -> None:
        """Refuses a law that cannot be, also where no tool touches, and tools that its snap or texture does not suit.

        Args:
            tools: of the file.

        Raises:
            ValueError: there is one.
        """
        self.made()
        for number, table in enumerate(tools, start=1):
            for effect in (self.snap, self.texture):
                if effect is not None and isinstance(table, ToolTable) and table.kind == "touch":
                    effect.refuse(table.radius, f"tools[{number}]")


@final
class CuttingTable(Table):
    """That the body can be cut, and where it breaks by itself.

    Attributes:
        tear: strain at which an element breaks: how much its most stretched edge is longer than at rest, as a share;
            by default none does.
        strength: tensile stress at which an element breaks [Pa]; by default none does.
        toughness: what a blade pays for new area [J/m²].
        faces: whether the body opens along faces between elements; else whole elements are cut away.
        users: who may cut, by blades or because their copy breaks; by default everybody.
    """

    tear: Positive | None = None
    strength: Positive | None = None
    toughness: NonNegative = 0.0
    faces: bool = False
    users: list[Number] | None = None

    @model_validator(mode="after")
    def _once(self) -> Self:
        if self.users is not None and len(set(self.users)) < len(self.users):
            raise ValueError(f"users is {self.users}; name each user once")
        return self

    def may(self, user: int) -> bool:
        """Whether a user's copy decides by itself.

        Args:
            user: number from 1.
        """
        return self.users is None or user in self.users


@final
class ToolTable(Table):
    """A proxy: a sphere that a hand or a device moves and that touches or holds the body, or a blade that cuts it.

    Attributes:
        user: number from 1.
        at: where it starts, in the body's rest shape [m].
        kind: "touch" (it pushes the skin away and slides on it), "grasp" (it holds the nodes within its radius, or
            the nearest, by springs that start relaxed) or "blade" (it takes away the elements that it goes through,
            and feels their toughness only).
        radius: [m].
        mass: m_i [kg].
        stiffness: of a contact, or of each held node [N/m].
        damping: touch: λ, the contact's force grows by 1 + λ times the speed of its penetration [s/m]; grasp: of each
            held node [Ns/m].
        friction: Coulomb's coefficient of a touch, of what does not slip yet.
        kinetic_friction: of what slips, at most `friction`; by default the same.
        axis: from the middle of a stylus to the middle of its round tip [m]; by default the tool is a ball. Of a blade
            its edge, from `at` to the other end.
        thickness: of a blade [m].
        begin: it acts from here [s].
        release: to here [s]; by default always.
        hand: what moves it.
        device: the device in between; without it the hand moves the proxy itself.
    """

    user: Number
    at: Place
    kind: Kind = "touch"
    radius: Positive = 0.01
    mass: Positive = 0.05
    stiffness: Hard = 1000.0
    damping: NonNegative = 0.0
    friction: NonNegative = 0.0
    kinetic_friction: NonNegative | None = None
    axis: Place | None = None
    thickness: FiniteFloat | None = None
    begin: NonNegative = 0.0
    release: NonNegative | None = None
    hand: ToolHand | None = None
    device: SimulatedDeviceTable | None = None

    @model_validator(mode="before")
    @classmethod
    def _known(cls, given: object) -> object:
        """Refuses a kind that no tool has, those of rigid bodies included."""
        if not isinstance(given, Mapping):
            return given
        table = cast("Mapping[str, object]", given)
        if (kind := table.get("kind", "touch")) not in get_args(Kind):
            known = ", ".join(f'"{name}"' for name in (*get_args(Kind), *RIGID))
            raise ValueError(f'kind is "{kind}"; it must be one of {known}')
        return table

    @model_validator(mode="after")
    def _after(self) -> Self:
        check_times(self.begin, self.release)
        if self.hand is not None and self.device is None:
            for name in _OF_DEVICES:
                if name in self.hand.model_fields_set:
                    raise ValueError(f"hand.{name} needs a device; give device or leave it out")
        if self.kinetic_friction is not None and self.kinetic_friction > self.friction:
            raise ValueError(
                f"kinetic_friction is {self.kinetic_friction} but friction is {self.friction}; what slips is not held "
                "more firmly than what does not"
            )
        if self.kind == "grasp" and self.friction > 0.0:
            raise ValueError(f"friction is {self.friction}, but a grasp holds without friction; leave it out")
        if self.kind == "grasp" and self.axis is not None:
            raise ValueError(f"axis is {self.axis}, but a grasp holds what is near its centre; leave it out")
        long = 0.0 if self.axis is None else math.dist(self.axis, (0.0, 0.0, 0.0))
        if self.kind == "touch" and long > _SLIMMEST * self.radius:
            raise ValueError(
                f"axis is {long:g} m long, but radius is {self.radius:g} m; "
                f"it must be at most {_SLIMMEST} times the radius"
            )
        if self.kind == "blade":
            self._blade()
        elif self.thickness is not None:
            raise ValueError(f'thickness is {self.thickness}, but kind is "{self.kind}"; only a blade has one')
        return self

    def _blade(self) -> None:
        """What a blade must have, and must not."""
        if self.thickness is None or not self.thickness > 0.0:
            said = "not given" if self.thickness is None else f"{self.thickness:g} m"
            raise ValueError(f'kind is "blade" and thickness is {said}; a blade needs one above 0, such as 0.001')
        if self.axis is None or not any(self.axis):
            said = "not given" if self.axis is None else "of no length"
            raise ValueError(f'kind is "blade" and axis is {said}; it must lead from one end of the edge to the other')
        if self.thickness > (long := math.hypot(*self.axis)):
            raise ValueError(
                f"thickness is {self.thickness:g} m, but axis is {long:g} m long; a blade is at most as thick as its "
                "edge is long"
            )
        for name in ("radius", "stiffness", "damping", "friction", "kinetic_friction"):
            if name in self.model_fields_set:
                raise ValueError(f"{name} is {getattr(self, name)}, but a blade does not touch; leave it out")
        if self.device is not None:
            raise ValueError("device is given, but a blade exerts no force on its user; let a hand move it")
