"""A scenario: who is joined, what they hold, how time passes, what the network does, and what the hands do."""

import json
from collections.abc import Mapping
from contextlib import AbstractContextManager
from html import escape
from math import inf
from pathlib import Path
from typing import Annotated, Any, Self, cast, final

import numpy as np
from pydantic import Field, InstanceOf, PrivateAttr, field_validator, model_validator

from cotouch.body import Body, Placed, together, with_faces
from cotouch.errors import ScenarioError, naming
from cotouch.files import list_of, read_text, toml, toml_text
from cotouch.network import Network
from cotouch.scenario._bodies_table import BetweenTable, Parts, PartTable, placed_bodies
from cotouch.scenario._body_tables import BodySource, FileTable, PointTable
from cotouch.scenario._channel import Channel
from cotouch.scenario._files import tables_with_file
from cotouch.scenario._held_nodes import held_node, refuse_axes
from cotouch.scenario._law_choice import choose_law, with_law_of_session
from cotouch.scenario._messages import refusing
from cotouch.scenario._rigid_tool_table import RigidToolTable, ToolSource
from cotouch.scenario._rigid_tools import placed_tools, refuse_unfit
from cotouch.scenario._tables import HandTable, Initial, RecordTable, Solver, Steps, Synchronisation, Table
from cotouch.scenario._tool_tables import ContactTable, CuttingTable, ToolTable
from cotouch.scenario._traces import Trace
from cotouch.scenario._world_table import WorldTable

_UNNAMED = "the scenario"  # what messages call one that is from no file
# Nodes of a truncated body next to a tool's start that keep their local stiffness.
_NEAR = 4


@final
class Scenario(Table):
    """Everything that decides a run. Read it from TOML with `read`, or make it from Python objects.

    Examples:
        >>> scenario = Scenario.from_toml('''
        ... [network]
        ... users = ["Ann", "Ben"]
        ... spring = [[0, 50], [50, 0]]
        ... delay = [[0, 0.05], [0.05, 0]]
        ... ''')
        >>> scenario.synchronisation.mode
        'freshest'
    """

    title: str = ""
    seed: Annotated[int, Field(ge=0, lt=2**63)] = 0
    network: InstanceOf[Network]
    body: BodySource = PointTable()
    bodies: Parts = Field(default_factory=list[PartTable])
    between: BetweenTable = BetweenTable()
    steps: Steps = Steps()
    synchronisation: Synchronisation = Synchronisation()
    channel: Channel = Channel()
    hands: list[HandTable] = Field(default_factory=list[HandTable])
    tools: list[ToolSource] = Field(default_factory=list[ToolSource])
    contact: ContactTable = ContactTable()
    world: WorldTable = WorldTable()
    cutting: CuttingTable | None = None
    initial: Initial = Initial()
    solver: Solver = Solver()
    record: RecordTable = RecordTable()
    _built: Body | None = PrivateAttr(default=None)
    _trace: Trace | None = PrivateAttr(default=None)
    _source: str = PrivateAttr(default="")

    def __init__(self, *, source: str = _UNNAMED, **tables: object) -> None:
        """Makes a scenario from tables or objects.

        Args:
            source: its name in messages.
            **tables: as in the file.

        Raises:
            ScenarioError: a table or value is wrong.
        """
        with refusing(source):
            super().__init__(**tables)
        self._source = source if source != _UNNAMED else ""

    @model_validator(mode="after")
    def _one_index(self) -> Self:
        """All take the steps of a constant index together: different clocks would let some copies live more slowly."""
        if self.synchronisation.mode == "constant":
            for name in ("period", "rate"):
                value = getattr(self.steps, name)
                if len(set(list_of(value) or ())) > 1:
                    raise ValueError(
                        f'steps.{name} is {value}, but in mode "constant" all users take each step together; '
                        'give one number for all, or use mode "freshest", in which each user has their own rate'
                    )
        return self

    @model_validator(mode="after")
    def _one_or_several(self) -> Self:
        if self.bodies and "body" in self.model_fields_set and self.body != PointTable():
            raise ValueError("body and bodies are given; give [body] for one object, or [[bodies]] for several")
        self.contact.refuse(self.tools)
        return self

    @field_validator("network", mode="before")
    @classmethod
    def _network(cls, value: object) -> object:
        return Network.from_table(dict(cast("Mapping[str, object]", value))) if isinstance(value, Mapping) else value

    @classmethod
    def read(cls, path: str | Path) -> "Scenario":
        """Reads a scenario from a TOML file.

        Raises:
            ScenarioError: the file is missing, is not TOML, or something in it is wrong.
            NetworkError: its network is wrong.
        """
        text = read_text(Path(path), "scenario", ScenarioError)
        return cls.from_toml(text, source=str(path), folder=Path(path).parent)

    @classmethod
    def from_toml(cls, text: str, *, source: str = _UNNAMED, folder: Path | None = None) -> "Scenario":
        """Reads a scenario from TOML text; `source` names it in messages, files it names are relative to `folder`.

        A table `[session]` says how live sessions go and is left out here, so that a session's file is a scenario too;
        only its law is that of the session.

        Args:
            text: TOML.
            source: its name in messages.
            folder: to which paths in it are relative; None: the present one.
        """
        table = toml(text, source, ScenarioError)
        table = with_law_of_session(table, table.pop("session", None))
        if "network" not in table:
            raise ScenarioError(f"{source} has no [network] table; it needs one with users, spring and delay")
        table["network"] = Network.from_table(table["network"], source=source)
        if folder is not None:
            for holder, file in tables_with_file(table):
                holder["file"] = str(folder / file)
        return cls.make(source=source, **table)

    @classmethod
    def make(cls, *, source: str = _UNNAMED, **tables: object) -> "Scenario":
        """Makes a scenario from tables or objects; errors are one sentence each.

        Args:
            source: what a message calls it.
            **tables: of the scenario, by name.

        Raises:
            ScenarioError: a table or value is wrong.
        """
        return cls(source=source, **tables)

    def replace(self, **changes: object) -> "Scenario":
        """A copy with whole tables replaced, or single options given as `table__option=value`.

        Options are those of the file, so the network's `links` are pairs of user numbers from 1.

        Args:
            **changes: tables, or options of them.

        Raises:
            ScenarioError: there is no such table, it has no options, or what is given is wrong.
            NetworkError: the network is wrong.
        """
        tables: dict[str, Any] = {name: getattr(self, name) for name in type(self).model_fields}
        for name, value in changes.items():
            table, _, option = name.partition("__")
            if table not in tables:
                raise ScenarioError(f'"{table}" is not a table of scenarios; tables are {", ".join(tables)}')
            tables[table] = {**self._options_of(table, tables[table]), option: value} if option else value
        result = type(self).make(**tables)
        result._source, changed = self._source, {name.partition("__")[0] for name in changes}
        several = {"body", "bodies", "between", "hands", "tools", "world", "cutting"}
        several |= {"network"} if self.rigid_tools else set()  # how many users there are makes up their mass
        if not changed & several:
            result._built = self._built
        if "channel" not in changed:
            result._trace = self._trace
        return result

    def _options_of(self, table: str, kept: object) -> dict[str, object]:
        """A table's options as a file gives them."""
        match kept:
            case dict():
                return cast("dict[str, object]", kept)
            case Network():
                return kept.as_table()
            case Table():
                return kept.model_dump(exclude_unset=True)
            case _:
                raise ScenarioError(f"{table} has no options to replace one by one; give all of it")

    @property
    def law(self) -> tuple[str, dict[str, float | str]]:
        """Name of the links' law, and the parameters that are given: those named, else the default of `choose_law`."""
        return self.synchronisation.law_given or (choose_law(self), {})

    @property
    def proxies(self) -> list[ToolTable]:
        """Its tools that are balls, styluses, grasps and blades."""
        return [tool for tool in self.tools if isinstance(tool, ToolTable)]

    @property
    def proxy_numbers(self) -> list[int]:
        """Which of its tools these are, from 1."""
        return [number for number, tool in enumerate(self.tools, start=1) if isinstance(tool, ToolTable)]

    @property
    def rigid_tools(self) -> list[RigidToolTable]:
        """Its tools that are rigid bodies."""
        return [tool for tool in self.tools if isinstance(tool, RigidToolTable)]

    def files(self) -> tuple[Path, ...]:
        """What it reads besides its own file: a mesh, a trace, a texture."""
        bodies = [self.body, *(part.body for part in self.bodies), *(tool.solid for tool in self.rigid_tools)]
        meshes = (*(body for body in bodies if isinstance(body, FileTable)), *self.world.meshes)
        tables = (*meshes, self.channel.trace, self.contact.texture)
        return tuple(Path(table.file) for table in tables if table is not None and table.file is not None)

    def trace(self) -> Trace | None:
        """The measured latencies of its channel, read once; None: it has none.

        Raises:
            ScenarioError: the file cannot be read, or something in it is wrong.
        """
        if self._trace is None and self.channel.trace is not None:
            self._trace = self.channel.trace.read()
        return self._trace

    def build_body(self) -> Body:
        """The shared object; read and built once."""
        if self._built is None:
            with self.naming():
                self._built = self._build()
        return self._built

    def naming(self) -> AbstractContextManager[None]:
        """Meanwhile, what is found wrong names the file that the scenario is from, if it is from one."""
        return naming(self._source)

    def _build(self) -> Body:
        body = self._weighing(self._bare())
        if isinstance(self.body, FileTable) and self.body.modes is not None:
            held = {held_node(self.hands[index], index, body) - 1 for index in range(len(self.hands))}
            for tool in self.proxies:  # what a tool meets first yields as the whole body does
                away = np.linalg.norm(body.rest - np.array(tool.at), axis=1)
                held.update(int(node) for node in np.argsort(away, kind="stable")[:_NEAR])
            body = body.truncated(modes=self.body.modes, contacts=sorted(held))
        body = self._cuttable(body)
        return body.with_places(self._places(body)) if body.rigid else body

    def _bare(self) -> Body:
        """As its tables say, without what the world adds."""
        tools = self.rigid_tools
        if self.bodies:
            placed = placed_bodies(self.bodies)
        else:
            alone = self.body if isinstance(self.body, Body) else self.body.build()
            if not (tools or self.between.self_contact or self.world.meshes):
                return alone
            placed = [Placed(body=alone, name="body")]
        numbers = [number for number, tool in enumerate(self.tools, start=1) if isinstance(tool, RigidToolTable)]
        body = together([*self.between.checked(placed), *placed_tools(tools, numbers, self.network.size)])
        if tools:
            refuse_unfit(body, body.tools[0].name)
        return body

    def _places(self, body: Body) -> list[list[float]]:
        """Where hands hold a rigid body besides its nodes and its skin's vertices."""
        for index, hand in enumerate(self.hands):
            refuse_axes(index, hand.at, body)
        return [hand.at for hand in self.hands if hand.at is not None]

    def refuse_cutters(self) -> None:
        """Refuses who may not cut, or is not there.

        Raises:
            ScenarioError: it is so.
        """
        users = None if self.cutting is None else self.cutting.users
        if self.cutting is None or users is None:
            return
        for user in users:
            if user > self.network.size:
                raise ScenarioError(f"cutting.users names user {user}; the network has users 1 to {self.network.size}")
        for number, tool in zip(self.proxy_numbers, self.proxies, strict=True):
            if tool.kind == "blade" and not self.cutting.may(tool.user):
                raise ScenarioError(
                    f'tools[{number}].kind is "blade", but cutting.users is {users}; name user {tool.user} there, or '
                    "leave one of them out"
                )

    def _cuttable(self, body: Body) -> Body:
        """A body whose elements can be cut, if any are to be."""
        if self.cutting is None and all(tool.kind != "blade" for tool in self.proxies):
            return body
        said = self.cutting or CuttingTable()
        made = body.with_cutting(said.tear or inf, strength=said.strength or inf, toughness=said.toughness)
        return with_faces(made) if said.faces else made

    def _weighing(self, body: Body) -> Body:
        """A body with the weight that the world gives it; one that meets obstacles has a material."""
        pull = self.world.gravity
        if pull is None:
            bare = body.material is None and self.world.obstacles()
            return body.with_gravity((0.0, 0.0, 0.0)) if bare else body
        return body.with_gravity((pull[0], pull[1], pull[2]))

    def placed(self) -> "Scenario":
        """The same with every hand at a node; what was given as a place has become the nearest one.

        A rigid body is held at the place itself, whose number follows those of nodes and the skin's vertices.

        Raises:
            ScenarioError: a place has not the body's number of axes, or a node is not there.
            BodyError: the body is wrong.
        """
        if all(hand.at is None and hand.body is None for hand in self.hands):
            return self
        body = self.build_body()
        hands = [
            hand.model_copy(update={"node": held_node(self.hands[index], index, body), "at": None, "body": None})
            for index, hand in enumerate(self.hands)
        ]
        result = self.model_copy(update={"hands": hands})
        result._built, result._trace = body, self._trace
        return result

    def to_toml(self) -> str:
        """The scenario as the text of a file, with what was given and no defaults; `from_toml` makes the same of it.

        Paths of files become absolute.

        Raises:
            ScenarioError: its body was made in Python, which no file can say.
        """
        if isinstance(self.body, Body) or any(isinstance(part.body, Body) for part in self.bodies):
            raise ScenarioError("body was made in Python; a file holds a body as one of its tables")
        tables: dict[str, object] = {}
        for name in type(self).model_fields:
            value: object = getattr(self, name)
            if name == "network":
                tables[name] = self.network.as_table()
            elif name not in self.model_fields_set or value is None:
                continue
            elif isinstance(value, list):
                tables[name] = [entry.model_dump(exclude_unset=True) for entry in cast("list[Table]", value)]
            else:
                tables[name] = value.model_dump(exclude_unset=True) if isinstance(value, Table) else value
        for table, file in tables_with_file(tables):
            table["file"] = str(Path(file).resolve())
        return toml_text({name: table for name, table in tables.items() if table not in ({}, [], "")})

    def _repr_html_(self) -> str:  # pyright: ignore[reportUnusedFunction]
        """What a notebook shows: the scenario's own text."""
        shown = repr(self) if isinstance(self.body, Body) else self.to_toml()
        return (
            f"<details open><summary>{escape(self.title or 'scenario')}</summary><pre>{escape(shown)}</pre></details>"
        )

    def as_json(self) -> str:
        """The whole scenario as JSON, for a result's attributes. A body made in Python is named by its size only."""
        tables: dict[str, object] = {"title": self.title, "seed": self.seed, "network": self.network.as_table()}
        if isinstance(self.body, Body):
            tables["body"] = {"kind": "made in Python", "nodes": self.body.nodes, "dimension": self.body.dimension}
        else:
            tables["body"] = self.body.model_dump()
        law = self.synchronisation.law or self.law[0]
        for name in ("steps", "synchronisation", "channel", "initial", "solver", "record"):
            table = getattr(self, name).model_dump(by_alias=True)
            tables[name] = table | {"law": law} if name == "synchronisation" else table
        tables["hands"] = [hand.model_dump() for hand in self.hands]
        if self.proxies:
            tables["tools"] = [tool.model_dump() for tool in self.proxies]
            tables["contact"] = self.contact.model_dump()
        if self.rigid_tools:
            tables["rigid_tools"] = [tool.model_dump() for tool in self.rigid_tools]
        if self.bodies:
            sources = [isinstance(part.body, Body) for part in self.bodies]
            tables["bodies"] = [
                {"name": part.name, "kind": "made in Python"} if made else part.model_dump()
                for part, made in zip(self.bodies, sources, strict=True)
            ]
        if self.bodies or self.rigid_tools or self.between.self_contact:
            tables["between"] = self.between.model_dump()
        if self.world != WorldTable():
            tables["world"] = self.world.model_dump()
        if self.cutting is not None:
            tables["cutting"] = self.cutting.model_dump()
        return json.dumps(tables)
