"""What is compared: a study's file, and the scenario of each of its runs."""

from collections.abc import Mapping, Sequence
from itertools import chain
from pathlib import Path
from typing import Annotated, Literal, Self, final
from zlib import crc32

import numpy as np
from pydantic import Field, PrivateAttr, model_validator

from cotouch.arrays import Float
from cotouch.body import Body
from cotouch.errors import NetworkError, ScenarioError
from cotouch.files import list_of, read_text, table_of, toml
from cotouch.laboratory._replicas._kinds import REPLICAS
from cotouch.laboratory._study_tables import HandKind, LawTable, MapTable, NetworkTable, Tuning, Users
from cotouch.laboratory._tasks import JUDGED, TASKS, Hands, Task
from cotouch.laws import FORCE, law_named
from cotouch.network import Network, complete, path, ring, star
from cotouch.scenario import Positive, Scenario, Table, refusing

_MOST_DRAWS = 1000
# A law that needs a constant delay gets samples so late that this share of them has come.
_PLAYED_OUT = 0.99
# Fewest steps of a run: costs of fewer say nothing of laws.
_FEWEST = 100
_GRAPHS = {"complete": complete, "path": path, "ring": ring, "star": star}


@final
class Study(Table):
    """A comparison of link laws: every law on every network, with every number of users, task, hand and draw.

    Attributes:
        title: of the report.
        seed: of all draws.
        draws: of each task and channel; intervals are over them.
        laws: that take part.
        ours: name of the one whose losing cases are shown first; by default the passive one that costs least.
        users: numbers of them.
        graph: who is linked to whom, of those whose round trip was measured where a network says round trips.
        spring: of every link, before tuning [N/m].
        networks: that laws meet.
        tasks: by name.
        hands: kinds of them; laws are tuned with the first.
        stiffer: laws must also be stable with hands so many times stiffer.
        body: as in a scenario.
        period: of the steps [s].
        duration: of a run [s].
        felt: whether drag, mass and stiffness that a hand feels are measured too.
        tuning: how laws are tuned; with nothing to try, settings are the published ones.
        map: where they become dangerous; None: not asked.
    """

    title: str = "Link laws compared"
    seed: Annotated[int, Field(ge=0)] = 0
    draws: Annotated[int, Field(ge=2, le=_MOST_DRAWS)] = 20
    laws: Annotated[list[LawTable], Field(min_length=1, max_length=100)]
    ours: str | None = None
    users: Annotated[list[Users], Field(min_length=1, max_length=20)] = Field(default_factory=lambda: [2])
    graph: Literal["complete", "path", "ring", "star"] = "complete"
    spring: Positive = 50.0
    networks: Annotated[list[NetworkTable], Field(min_length=1, max_length=100)]
    tasks: Annotated[list[str], Field(min_length=1)] = Field(default_factory=lambda: list(JUDGED))
    hands: Annotated[list[HandKind], Field(min_length=1, max_length=20)] = Field(default_factory=lambda: [HandKind()])
    stiffer: Annotated[float, Field(ge=1.0, le=100.0)] = 6.0
    body: dict[str, object] = Field(default_factory=lambda: {"kind": "point", "mass": 1.0})
    period: Positive = 1e-3
    duration: Annotated[float, Field(ge=4.0, le=600.0)] = 5.0
    felt: bool = True
    tuning: Tuning = Tuning()
    map: MapTable | None = None
    _built: Body | None = PrivateAttr(default=None)

    @model_validator(mode="before")
    @classmethod
    def _short_laws(cls, value: object) -> object:
        """A law may be just its name, or a table as in `[synchronisation]`."""
        tables = table_of(value)
        named = None if tables is None else list_of(tables.get("laws"))
        if tables is None or named is None:
            return value
        laws = [{"law": law} if (own := table_of(law)) is None or "kind" in own else law for law in named]
        return {**tables, "laws": laws}

    @model_validator(mode="after")
    def _known(self) -> Self:
        for name in self.tasks:
            if name not in TASKS:
                raise ValueError(f'tasks holds "{name}"; it must be one of {", ".join(TASKS)}')
        for what, names in (
            ("laws", [law.label for law in self.laws]),
            ("networks", [network.name for network in self.networks]),
            ("users", self.users),
            ("tasks", self.tasks),
            ("hands", [hand.label for hand in self.hands]),
        ):
            said = [str(name) for name in names]
            for name in said:
                if said.count(name) > 1:
                    raise ValueError(f'{what} holds "{name}" twice; give each a different name')
        if self.duration < _FEWEST * self.period:
            raise ValueError(
                f"period is {self.period:g} s; in a run of {self.duration:g} s it must be at most "
                f"{self.duration / _FEWEST:g} s"
            )
        known = [network.name for network in self.networks]
        for network in self.networks:
            if network.tuned_on is not None and network.tuned_on not in known:
                raise ValueError(
                    f'network "{network.name}" is tuned_on "{network.tuned_on}", which is not one of the networks'
                )
        if self.ours is not None and self.ours not in [law.label for law in self.laws]:
            raise ValueError(f'ours is "{self.ours}", which is not one of the laws')
        for law in self.laws:
            try:
                law_named(law.kind).check(law.given)
            except NetworkError as error:
                raise ValueError(str(error)) from None
        return self

    @classmethod
    def make(cls, *, source: str = "the study", **tables: object) -> "Study":
        """Makes a study from tables; errors are one sentence each.

        Args:
            source: what a message calls it.
            **tables: of the study, by name.

        Raises:
            ScenarioError: something in it is wrong.
        """
        with refusing(source):
            return cls.model_validate(tables)

    @classmethod
    def read(cls, file: str | Path) -> "Study":
        """Reads a study from a TOML file; files that it names are relative to its folder.

        Raises:
            ScenarioError: the file is missing, is not TOML, or something in it is wrong.
        """
        place = Path(file)
        tables = toml(read_text(place, "study", ScenarioError), str(place), ScenarioError)
        entries = [entry for entry in map(table_of, list_of(tables.get("networks")) or []) if entry is not None]
        _root(tables, "body", "file", place.parent)
        for entry in entries:
            _root(entry.get("channel"), "trace", "file", place.parent)
            if isinstance(delays := entry.get("delays"), str):
                entry["delays"] = str(place.parent / delays)
        return cls.make(source=str(place), **tables)

    def files(self, only: Sequence[NetworkTable] | None = None) -> tuple[Path, ...]:
        """What it reads besides its own file: for its body and its networks.

        Args:
            only: networks of it; None: all.
        """
        networks = self.networks if only is None else only
        traces = [table_of(network.channel.get("trace")) for network in networks]
        named = chain(
            [self.body.get("file")],
            (trace.get("file") for trace in traces if trace is not None),
            (network.delays for network in networks),
        )
        return tuple(Path(file) for file in named if isinstance(file, str))

    @property
    def tunes(self) -> bool:
        """Whether laws are tuned at all."""
        return self.tuning.search + self.tuning.local > 0

    @property
    def settings(self) -> list[str]:
        """Names of the settings that laws are run with."""
        if not self.tunes:
            return ["published"]
        return [*["published"] * (not self.tuning.only), "tuned", *["safe"] * bool(self.tuning.safe)]

    def law(self, label: str) -> LawTable:
        """A law of the study by its name in it."""
        return next(law for law in self.laws if law.label == label)

    def network(self, name: str) -> NetworkTable:
        """A network of the study by its name."""
        return next(network for network in self.networks if network.name == name)

    def joined(self, network: NetworkTable, users: int, factor: float) -> Network:
        """The network of a run.

        Args:
            network: of the study.
            users: how many.
            factor: of the springs.

        Raises:
            ScenarioError: it has not as many users.
            NetworkError: its table of round trips is wrong.
        """
        if network.delays is not None:
            whole = Network.from_delays(network.delays, pick=network.pick, spring=self.spring * factor)
            if users > whole.size:
                raise ScenarioError(f'network "{network.name}" has {whole.size} users; {users} are required')
            names, delay, known = whole.users[:users], whole.delay[:users, :users], whole.spring[:users, :users]
        else:
            names, delay = [f"user {i + 1}" for i in range(users)], np.full((users, users), network.delay)
            known = np.full((users, users), self.spring * factor)
            np.fill_diagonal(delay, 0.0)
        spring = np.zeros((users, users))
        # Of two, as in a map or while tuning, a ring is their link.
        for a, b in _GRAPHS["path" if users == 2 else self.graph](users):
            spring[a, b], spring[b, a] = known[a, b], known[b, a]
        return Network(users=names, spring=spring, delay=delay)

    def scenario(
        self,
        law: LawTable,
        network: NetworkTable,
        users: int,
        hands: Sequence[Mapping[str, object]],
        *,
        seed: int = 0,
        setting: Mapping[str, float] | None = None,
        duration: float | None = None,
        initial: Mapping[str, object] | None = None,
    ) -> Scenario:
        """A run.

        Args:
            law: of its links.
            network: that it meets.
            users: how many.
            hands: of the task.
            seed: of the channel.
            setting: multiples of parameters' defaults, and of the springs as "spring".
            duration: by default the study's [s].
            initial: state.

        Raises:
            ScenarioError: it cannot be.
        """
        factors = dict(setting or {})
        if law.replica is not None and network.channel.get("codec") is not None:
            raise ScenarioError(
                f'network "{network.name}" has a codec, but replica "{law.replica}" says all in full; '
                "leave one of them out"
            )
        joined = self.joined(network, users, factors.pop("spring", 1.0))
        given = {**{name: f"{factor!r}x" for name, factor in factors.items()}, **law.given}
        synchronisation: dict[str, object] = {"mode": network.mode, "law": {"kind": law.kind, **given}}
        if law_named(law.kind).constant_delay and network.varies and network.mode != "constant":
            synchronisation |= {"mode": "constant", "quantile": _PLAYED_OUT}
        if law.damping is not None or law.replica is not None:
            synchronisation["damping"] = law.damping or 0.0
        return Scenario.make(
            network=joined,
            seed=seed,
            body=self.build_body(),
            steps={"duration": self.duration if duration is None else duration, "period": self.period},
            synchronisation=synchronisation,
            channel=network.channel,
            hands=list(hands),
            initial=dict(initial or {}),
        )

    def task(self, name: str, users: int, hand: HandKind, draw: int) -> Hands:
        """What hands do in a draw; negative draws are those that laws are tuned with.

        Args:
            name: of the task.
            users: how many.
            hand: what they are like.
            draw: number of the draw.
        """
        rng = np.random.default_rng((self.seed, crc32(name.encode()), draw + 1_000_000))
        return self.placed(TASKS[name](users, hand.stiffness, hand.damping, rng), users)

    def placed(self, hands: Task, users: int) -> Hands:
        """Hands with nodes, which users share evenly, and with as many axes as the body has.

        Args:
            hands: of a task, whose users count from 1 and whose places have one axis [m].
            users: how many share the body, >= 1.
        """
        body = self.build_body()
        more = [0.0] * (body.dimension - 1)

        def wide(value: float | list[list[float]]) -> list[float] | list[list[float]]:
            return [[*row, *more] for row in value] if isinstance(value, list) else [value, *more]

        return [
            dict(hand)
            | {"node": 1 + (hand["user"] - 1) * (body.nodes - 1) // max(users - 1, 1)}
            | ({"path": wide(hand["path"])} if "path" in hand else {})
            | ({"amplitude": wide(hand["amplitude"])} if "amplitude" in hand else {})
            for hand in hands
        ]

    def build_body(self) -> Body:
        """The object; built once.

        Raises:
            ScenarioError: its table is wrong.
        """
        if self._built is None:
            alone = Network(users=["one"], spring=[[0.0]], delay=[[0.0]])
            self._built = Scenario.make(source="the study", network=alone, body=self.body).build_body()
        return self._built

    def channel_seed(self, network: NetworkTable, draw: int) -> int:
        """The same for all laws, so that they meet the same network.

        Args:
            network: one of the study's; its name counts.
            draw: number of the draw, from 0.
        """
        return int(
            np.random.SeedSequence((self.seed, crc32(network.name.encode()), draw + 1_000_000)).generate_state(1)[0]
        )


def tunable(law: LawTable) -> list[str]:
    """Parameters that tuning may change: not those that say what a law, or a neighbour, may do."""
    if law.replica is not None and REPLICAS[law.replica].join is None:
        return []
    kind = law_named(law.kind)
    return [
        "spring",
        *(p.name for p in kind.parameters if p.tuned and p.name not in {kind.initial_energy, FORCE, *law.given}),
    ]


def spread(draws: Float) -> tuple[float, float]:
    """Mean of draws, and half of its 95 % interval by Student's t; infinite where a draw is.

    Args:
        draws: one number each.
    """
    from scipy import stats

    if not np.isfinite(draws).all():
        return float("inf"), float("inf")
    if draws.size < 2:
        return float(draws.mean()), float("inf")
    return float(draws.mean()), float(stats.t.ppf(0.975, draws.size - 1) * draws.std(ddof=1) / np.sqrt(draws.size))


def _root(holder: object, name: str, key: str, folder: Path) -> None:
    """Makes the file that a table names relative to a folder."""
    tables = table_of(holder)
    named = None if tables is None else table_of(tables.get(name))
    if tables is not None and named is not None and isinstance(file := named.get(key), str):
        tables[name] = {**named, key: str(folder / file)}
