"""A scenario: who is joined, what they hold, how time passes, what the network does, and what the hands do."""

import json
import tomllib
from collections.abc import Mapping
from pathlib import Path
from typing import Annotated, Any, final

import numpy as np
import numpy.typing as npt
from pydantic import Field, InstanceOf, PrivateAttr, ValidationError, field_validator

from cotouch.body import Body
from cotouch.errors import ScenarioError
from cotouch.network import Network
from cotouch.scenario._body_tables import BodySource, FileTable, PointTable
from cotouch.scenario._messages import sentence
from cotouch.scenario._tables import (
    Channel,
    Hand,
    Initial,
    Recording,
    Solver,
    Steps,
    Synchronisation,
    Table,
)
from cotouch.scenario._tool_tables import ToolTable

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
    seed: Annotated[int, Field(ge=0)] = 0
    network: InstanceOf[Network]
    body: BodySource = PointTable()
    steps: Steps = Steps()
    synchronisation: Synchronisation = Synchronisation()
    channel: Channel = Channel()
    hands: list[Hand] = Field(default_factory=list[Hand])
    tools: list[ToolTable] = Field(default_factory=list[ToolTable])
    initial: Initial = Initial()
    solver: Solver = Solver()
    record: Recording = Recording()
    _built: Body | None = PrivateAttr(default=None)

    @field_validator("network", mode="before")
    @classmethod
    def _network(cls, value: object) -> object:
        return Network.from_table(dict(value)) if isinstance(value, Mapping) else value

    @classmethod
    def read(cls, path: str | Path) -> "Scenario":
        """Reads a scenario from a TOML file.

        Raises:
            ScenarioError: the file is missing, is not TOML, or something in it is wrong.
            NetworkError: its network is wrong.
        """
        try:
            text = Path(path).read_text(encoding="utf-8")
        except (OSError, UnicodeDecodeError) as error:
            reason = error.strerror if isinstance(error, OSError) else "it is not UTF-8 text"
            raise ScenarioError(f"the scenario {path} cannot be read: {reason}") from error
        return cls.from_toml(text, source=str(path), folder=Path(path).parent)

    @classmethod
    def from_toml(cls, text: str, *, source: str = "the scenario", folder: Path | None = None) -> "Scenario":
        """Reads a scenario from TOML text; `source` names it in messages, files it names are relative to `folder`."""
        try:
            table = tomllib.loads(text)
        except tomllib.TOMLDecodeError as error:
            raise ScenarioError(f"{source} is not TOML: {error}") from error
        if "network" not in table:
            raise ScenarioError(f"{source} has no [network] table; it needs one with users, spring and delay")
        table["network"] = Network.from_table(table["network"], source=source)
        body = table.get("body")
        if folder is not None and isinstance(body, dict) and isinstance(body.get("file"), str):
            table["body"] = {**body, "file": str(folder / body["file"])}
        return cls.make(source=source, **table)

    @classmethod
    def make(cls, *, source: str = "the scenario", **tables: Any) -> "Scenario":
        """Makes a scenario from tables or objects; errors are one sentence each.

        Raises:
            ScenarioError: a table or value is wrong.
        """
        try:
            return cls(**tables)
        except ValidationError as error:
            raise ScenarioError(sentence(error, source)) from None

    def replace(self, **changes: Any) -> "Scenario":
        """A copy with whole tables replaced, or single options given as `table__option=value`."""
        tables: dict[str, Any] = {name: getattr(self, name) for name in type(self).model_fields}
        for name, value in changes.items():
            table, _, option = name.partition("__")
            if option:
                kept: Any = tables[table]
                tables[table] = {**kept.model_dump(exclude_unset=True), option: value}
            else:
                tables[table] = value
        result = type(self).make(**tables)
        if not {name.partition("__")[0] for name in changes} & {"body", "hands", "tools"}:
            result._built = self._built
        return result

    def build_body(self) -> Body:
        """The shared object; read and built once."""
        if self._built is None:
            body = self.body if isinstance(self.body, Body) else self.body.build()
            if isinstance(self.body, FileTable) and self.body.modes is not None:
                held = {self._node(index, body) - 1 for index in range(len(self.hands))}
                for tool in self.tools:  # what a tool meets first yields as the whole body does
                    away = np.linalg.norm(body.rest - np.array(tool.at), axis=1)
                    held.update(int(node) for node in np.argsort(away, kind="stable")[:_NEAR])
                body = body.truncated(modes=self.body.modes, contacts=sorted(held))
            self._built = body
        return self._built

    def placed(self) -> "Scenario":
        """The same with every hand at a node; what was given as a place has become the nearest one.

        Raises:
            ScenarioError: a place has not the body's number of axes, or a node is not there.
            BodyError: the body is wrong.
        """
        if all(hand.at is None for hand in self.hands):
            return self
        body = self.build_body()
        hands = [
            hand.model_copy(update={"node": self._node(index, body), "at": None})
            for index, hand in enumerate(self.hands)
        ]
        result = self.model_copy(update={"hands": hands})
        result._built = body
        return result

    def _node(self, index: int, body: Body) -> int:
        """Number of the node that a hand holds."""
        hand = self.hands[index]
        if hand.at is None:
            if hand.node > body.nodes:
                raise ScenarioError(f"hands[{index + 1}].node is {hand.node}; the body has nodes 1 to {body.nodes}")
            return hand.node
        if len(hand.at) != body.dimension:
            raise ScenarioError(f"hands[{index + 1}].at is {hand.at}; it must be {body.dimension} coordinates [m]")
        return 1 + int(np.argmin(np.linalg.norm(body.rest - np.array(hand.at), axis=1)))

    def as_json(self) -> str:
        """The whole scenario as JSON, for a result's attributes. A body made in Python is named by its size only."""
        network = self.network
        numbered = [[a + 1, b + 1] for a, b in network.links]
        tables: dict[str, Any] = {
            "title": self.title,
            "seed": self.seed,
            "network": {
                "users": list(network.users),
                "spring": network.spring.tolist(),
                "delay": network.delay.tolist(),
                "links": numbered,
            },
        }
        if isinstance(self.body, Body):
            tables["body"] = {"kind": "made in Python", "nodes": self.body.nodes, "dimension": self.body.dimension}
        else:
            tables["body"] = self.body.model_dump()
        for name in ("steps", "synchronisation", "channel", "initial", "solver", "record"):
            tables[name] = getattr(self, name).model_dump()
        tables["hands"] = [hand.model_dump() for hand in self.hands]
        if self.tools:
            tables["tools"] = [tool.model_dump() for tool in self.tools]
        return json.dumps(tables)


def per_user(value: float | list[float], users: int, name: str) -> npt.NDArray[np.float64]:
    """One number for all users, or a list with one for each.

    Raises:
        ScenarioError: the list has another length.
    """
    if isinstance(value, list):
        if len(value) != users:
            raise ScenarioError(f"{name} has {len(value)} entries; the network has {users} users")
        return np.asarray(value, dtype=np.float64)
    return np.full(users, float(value))
