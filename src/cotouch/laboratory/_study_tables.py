"""What a study's file says of the laws, networks and hands of a comparison, and of how laws are tuned."""

from typing import Annotated, Self, cast, final

from pydantic import Field, model_validator

from cotouch.device import HAND_DAMPING
from cotouch.laboratory._replicas._kinds import REPLICAS
from cotouch.scenario import Mode, NonNegative, Positive, Table

_MOST_USERS = 64
Users = Annotated[int, Field(ge=2, le=_MOST_USERS)]
Name = Annotated[str, Field(min_length=1, max_length=60)]


@final
class LawTable(Table):
    """A law that takes part, or replicas that are none.

    Attributes:
        name: in the report; by default the law's.
        law: as in `[synchronisation]`.
        replica: instead, the name of one: "server", "owner", "lockstep", "rollback" or "broadcast". A server's spokes
            have the law, by default springs.
        damping: B_i instead of what the law needs [Ns/m].
    """

    name: Name | None = None
    law: str | dict[str, object] | None = None
    replica: str | None = None
    damping: NonNegative | None = None

    @model_validator(mode="after")
    def _one(self) -> Self:
        if self.law is None and self.replica is None:
            raise ValueError("an entry of laws needs either law or replica")
        if self.replica is not None and self.replica not in REPLICAS:
            raise ValueError(f'replica is "{self.replica}"; it must be one of {", ".join(REPLICAS)}')
        if self.law is not None and self.replica is not None and REPLICAS[self.replica].join is None:
            raise ValueError(f'replica "{self.replica}" has no links, so it takes no law; "server" does')
        if self.replica is not None and self.damping is not None:
            raise ValueError(f'replica "{self.replica}" has no damping to choose')
        return self

    @property
    def label(self) -> str:
        """What it is called."""
        if self.replica is None:
            return self.name or self.kind
        return self.name or (self.replica if self.law is None else f"{self.replica}, {self.kind}")

    @property
    def kind(self) -> str:
        """Name of the law; by default "spring", whose schedule, channel and springs are theirs too."""
        if self.law is None:
            return "spring"
        return self.law if isinstance(self.law, str) else str(self.law.get("kind", ""))

    @property
    def given(self) -> dict[str, float | str]:
        """Parameters that it is given."""
        if self.law is None or isinstance(self.law, str):
            return {}
        given = cast("dict[str, float | str]", self.law)  # what a law checks when it is looked up
        return {key: value for key, value in given.items() if key != "kind"}


@final
class NetworkTable(Table):
    """A network that laws meet.

    Attributes:
        name: in the report.
        delay: of every link, one way [s].
        delays: instead, a table of round trips as `Network.from_delays` takes it.
        pick: users of it, in order; as many as there are users in a run, from the first.
        channel: as in a scenario.
        mode: as in a scenario.
        tuned_on: name of the network that laws were tuned on; by default this one. Another one makes it held out.
    """

    name: Name
    delay: NonNegative | None = None
    delays: str | None = None
    pick: list[str] = Field(default_factory=list[str])
    channel: dict[str, object] = Field(default_factory=dict[str, object])
    mode: Mode = "freshest"
    tuned_on: str | None = None

    @model_validator(mode="after")
    def _one(self) -> Self:
        if (self.delay is None) == (self.delays is None):
            raise ValueError(f'network "{self.name}" needs either delay or delays')
        if self.pick and self.delays is None:
            raise ValueError(f'network "{self.name}" has pick, which picks users of a table of delays; give delays')
        return self

    @property
    def varies(self) -> bool:
        """Whether its delay is not always the same."""
        return bool(self.channel.keys() - {"codec"})


@final
class HandKind(Table):
    """What hands are like.

    Attributes:
        stiffness: [N/m].
        damping: [Ns/m].
    """

    stiffness: Positive = 300.0
    damping: NonNegative = HAND_DAMPING

    @property
    def label(self) -> str:
        """What it is called."""
        return f"{self.stiffness:g} N/m"


@final
class Tuning(Table):
    """How laws are tuned, all alike: springs and every parameter but initial energies, as multiples of the usual.

    Attributes:
        search: settings tried that fill the space evenly.
        local: settings tried near the best so far.
        draws: of each task, other ones than those that count.
        users: in the runs.
        range: each multiple is between 1/range and range.
        only: whether the published settings are left out, which else are run beside the tuned ones.
        safe: random runs in which a setting that is called safe makes no more than the initial energy; 0: not asked.
    """

    search: Annotated[int, Field(ge=0, le=4096)] = 64
    local: Annotated[int, Field(ge=0, le=4096)] = 64
    draws: Annotated[int, Field(ge=1, le=100)] = 2
    users: Users = 2
    range: Annotated[float, Field(gt=1.0, le=1000.0)] = 10.0
    only: bool = False
    safe: Annotated[int, Field(ge=0, le=10_000)] = 0


@final
class MapTable(Table):
    """Where laws become dangerous: runs of two users over delay and stiffness of hands.

    Attributes:
        delay: one way [s].
        stiffness: of hands [N/m].
    """

    delay: Annotated[list[NonNegative], Field(min_length=1, max_length=60)]
    stiffness: Annotated[list[Positive], Field(min_length=1, max_length=60)]
