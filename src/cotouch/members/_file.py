"""A session file: a scenario's tables, and `[session]` with what only the live world needs."""

import hashlib
import json
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path, PurePosixPath
from typing import Annotated, Literal, NamedTuple, Self, final

import numpy as np
from pydantic import Field, model_validator

from cotouch.errors import ScenarioError, SessionError
from cotouch.files import look, read_bytes, read_text, table_of, toml
from cotouch.members._device_table import DeviceTable
from cotouch.members._emulate import path_laws
from cotouch.members._law_check import check_codec, check_law, check_live
from cotouch.network import Network
from cotouch.planning import Objective
from cotouch.samples import MOST_AGE, Encoding
from cotouch.scenario import (
    NonNegative,
    Positive,
    Probability,
    Scenario,
    Table,
    per_user,
    refusing,
    tables_with_file,
    with_law_of_session,
)

# Slots of a session without names: more than this many people at one object nobody has tried.
MOST_USERS = 32
# Steps per second where the file says nothing: what a computer that does other things too can keep.
DEFAULT_RATE = 500.0
# A session's description and its meshes are sent to everybody who joins.
MOST_BYTES = 256 << 20
# Of a trace, which everybody reads who joins; each byte of it may take some hundred of memory.
_MOST_TRACE = 1 << 20
_DEFAULT_SPRING = 60.0
_DEFAULT_DELAY = 0.02
_FORMAT = "cotouch session 3"


@final
class SessionTable(Table):
    """What only the live world needs.

    Attributes:
        users: instead of `[network]`: this many slots, whoever comes first; all springs are `spring`.
        spring: of every pair, with `users` [N/m].
        links: "given" (those of `[network]`, or all), or "plan" (chosen from the delays that are measured).
        link_count: how many "plan" chooses; by default 6 of 5 people's 10, and in this proportion.
        objective: of "plan".
        replan: whether links are planned anew while people hold the object, when delays have changed.
        quantile: share of the ages of a window that a budget covers.
        margin: what the budget is above that, as a share.
        window: over which ages are looked at [s].
        max_step: T is never longer; a peer that is later than this stands still for the rest [s].
        force_limit: of one link [N].
        power_limit: that one neighbour's motion can put in, on average over a second [W].
        tank: most energy that a link's tank holds [J].
        initial_energy: energy that a link has once, to begin with [J].
        allowance: energy that a newcomer's links may get once, to bring its copy from rest to where the others are;
            about what 20 N do over 0.1 m [J].
        age_limit: that the age budgets of both ends of a link may come to; samples that are older are guarded, and no
            neighbour can ask for more damping than half the spring times this [s].
        wait_for_peers: hands of the file wait until all users are there and their own copy is coupled, at most so long
            [s].
        encoding: of a number on the wire; what the rounding of others than "float64" can cost is paid for.
        max_displacement: greatest displacement of any node along an axis; what is farther is neither sent nor taken
            [m].
        send_rate: highest rate of samples on each link [1/s]; by default the sender's own.
        emulate: apply the delays of `[network]` and the impairments of `[channel]`, or its trace, to every path, to try
            them on one machine.
        per_address: slots that one address may take, this machine aside; by default half of them, rounded up.
        devices: how the devices in people's hands are coupled.
    """

    users: Annotated[int, Field(ge=1, le=MOST_USERS)] | None = None
    spring: Positive = _DEFAULT_SPRING
    links: Literal["given", "plan"] = "given"
    link_count: Annotated[int, Field(ge=1)] | None = None
    objective: Objective = "decay"
    replan: bool = False
    quantile: Probability = 1.0
    margin: NonNegative = 0.25
    window: Positive = 10.0
    max_step: Annotated[float, Field(gt=0.0, le=1.0)] = 0.05
    force_limit: Positive = 20.0
    power_limit: Positive = 50.0
    tank: NonNegative = 0.05
    initial_energy: NonNegative = 1e-3
    allowance: NonNegative = 1.0
    age_limit: Positive = MOST_AGE
    wait_for_peers: NonNegative = 0.0
    encoding: Encoding = "float64"
    max_displacement: Annotated[float, Field(gt=0.0, le=1e4)] = 10.0
    send_rate: Positive | None = None
    emulate: bool = False
    per_address: Annotated[int, Field(ge=1, le=MOST_USERS)] | None = None
    devices: list[DeviceTable] = Field(default_factory=list[DeviceTable])


@final
class _Whole(Table):
    session: SessionTable = SessionTable()

    @model_validator(mode="after")
    def _fits(self) -> Self:
        given = self.session.model_fields_set
        if self.session.users is None and "spring" in given:
            raise ValueError(
                "session.spring is only for sessions with session.users; with [network], give the springs there"
            )
        if self.session.links == "given":
            for name in ("link_count", "objective", "replan"):
                if name in given:
                    raise ValueError(f'session.{name} is for links = "plan"; leave it out')
        return self


@final
@dataclass(frozen=True, eq=False)
class SessionFile:
    """A session as it was requested, and as it travels.

    Attributes:
        scenario: body, network, steps, synchronisation, hands, tools, solver.
        options: what only the live world needs.
        content: what members fetch; its SHA-256 names the session.
        files: the meshes and the trace that it needs, by name.
    """

    scenario: Scenario
    options: SessionTable
    content: bytes
    files: dict[str, bytes]

    @classmethod
    def read(cls, path: str | Path, *, law: str | None = None) -> "SessionFile":
        """Reads a session from a TOML file, and the files that it names.

        Args:
            path: of the file.
            law: of the links, instead of the file's; None: the file's.

        Raises:
            SessionError: the file is missing or not TOML, or an option is wrong.
            ScenarioError, NetworkError, BodyError: one of its other tables is wrong.
        """
        path = Path(path)
        text = read_text(path, "session", SessionError)
        return cls.from_toml(text, source=str(path), folder=path.parent, law=law)

    @classmethod
    def from_toml(
        cls, text: str, *, source: str = "the session", folder: Path | None = None, law: str | None = None
    ) -> "SessionFile":
        """Reads a session from TOML text; files are looked for in `folder`.

        Args:
            text: the words.
            source: what messages call it.
            folder: where files are looked for; None: none is read.
            law: of the links, instead of the text's; None: the text's.
        """
        tables = toml(text, source, SessionError)
        if law is not None:
            check_live(law, "--law")
            _take_law(tables, law)
        files: dict[str, bytes] = {}
        named: dict[str, str] = {}
        for _, file in tables_with_file(tables, pictures=False):
            name = PurePosixPath(file).name
            if named.setdefault(name, file) != file:
                raise SessionError(
                    f'{source} names "{named[name]}" and "{file}"; files are sent without their folders, so '
                    "give them different names"
                )
            files[name] = read_bytes((folder or Path()) / file, "file", SessionError, MOST_BYTES)
        scenario, options = _made(tables, source, folder)
        if "law" not in (table_of(tables.get("synchronisation")) or {}):
            law = scenario.law[0]  # other versions may have another default
        described = {
            "format": _FORMAT,
            "text": text,
            "law": law,
            "files": {name: hashlib.sha256(data).hexdigest() for name, data in files.items()},
        }
        content = json.dumps(described, sort_keys=True).encode()
        if len(content) + sum(map(len, files.values())) > MOST_BYTES:
            raise SessionError(f"{source} and its files are larger than {MOST_BYTES >> 20} MB; make meshes coarser")
        return cls(scenario, options, content, files)

    @classmethod
    def needed(cls, content: bytes) -> dict[str, bytes]:
        """SHA-256 of each file that a session's description names.

        Raises:
            SessionError: it is none.
        """
        return _described(content).files

    @classmethod
    def from_content(cls, content: bytes, files: dict[str, bytes], *, folder: Path) -> "SessionFile":
        """A session that travelled.

        Args:
            content: as it was fetched.
            files: likewise, by name.
            folder: an empty, private one, where its files are put to be read.
        """
        described = _described(content)
        for name in described.files:
            (folder / name).write_bytes(files[name])
        tables = toml(described.text, "the session", SessionError)
        if described.law is not None:
            _take_law(tables, described.law)
        for table, file in tables_with_file(tables, pictures=False):
            table["file"] = PurePosixPath(file).name
        scenario, options = _made(tables, "the session", folder)
        return cls(scenario, options, content, files)

    @property
    def digest(self) -> bytes:
        """SHA-256 of the content; it names the session."""
        return hashlib.sha256(self.content).digest()

    @property
    def slots(self) -> int:
        """How many can take part at once."""
        return self.scenario.network.size

    @property
    def law(self) -> str:
        """Name of the links' law."""
        return self.scenario.law[0]

    @property
    def named(self) -> bool:
        """Whether slots are for certain names."""
        return self.options.users is None

    def period(self, slot: int) -> float:
        """T of a slot [s]."""
        steps = self.scenario.steps
        if steps.period is not None:
            return float(per_user(steps.period, self.slots, "steps.period")[slot])
        if steps.rate is not None:
            return 1.0 / float(per_user(steps.rate, self.slots, "steps.rate")[slot])
        return 1.0 / DEFAULT_RATE

    def link_count(self, members: int) -> int:
        """How many links "plan" chooses among so many members."""
        pairs = members * (members - 1) // 2
        wanted = self.options.link_count if self.options.link_count is not None else round(0.6 * pairs)
        return max(members - 1, min(wanted, pairs))


class _Described(NamedTuple):
    """What travels: TOML, the law if the text does not name it, and the SHA-256 of each file."""

    text: str
    law: str | None
    files: dict[str, bytes]


def _described(content: bytes) -> _Described:
    """What travelled, checked."""
    with suppress(ValueError, KeyError, TypeError):
        described = table_of(json.loads(content)) or {}
        text, law, files = described["text"], described["law"], table_of(described["files"])
        same = described["format"] == _FORMAT
        if same and isinstance(text, str) and isinstance(law, str | None) and files is not None:
            return _Described(text, law, {name: _digest(name, said) for name, said in files.items()})
    raise SessionError(f"the session description cannot be read ({len(content)} bytes); it may be from another version")


def _digest(name: str, said: object) -> bytes:
    """SHA-256 of a file, whose name leads into no other folder.

    Raises:
        ValueError: it is none, or the name does.
    """
    found = bytes.fromhex(said) if isinstance(said, str) else b""
    if len(found) != 32 or name != PurePosixPath(name).name or name in {"", ".", ".."} or "\\" in name:
        raise ValueError(name)
    return found


def _take_law(tables: dict[str, object], law: str) -> None:
    """Gives the links another law, by its name, with the parameters that it has by itself."""
    given = table_of(tables.get("synchronisation", {}))
    if given is not None:
        tables["synchronisation"] = {**given, "law": law}


def _made(tables: dict[str, object], source: str, folder: Path | None) -> tuple[Scenario, SessionTable]:
    given = tables.get("session", {})
    tables = with_law_of_session({name: table for name, table in tables.items() if name != "session"}, given)
    with refusing(source, SessionError):
        options = _Whole.model_validate({"session": given}).session
    users = options.users
    if users is not None:
        if "network" in tables:
            raise SessionError(f"{source}: session.users is {users} and [network] is given; leave one of them out")
        spring = options.spring * (1.0 - np.eye(users))
        tables["network"] = Network(
            users=[f"user {slot + 1}" for slot in range(users)],
            spring=spring,
            delay=_DEFAULT_DELAY * (1.0 - np.eye(users)),
        )
    elif "network" in tables:
        tables["network"] = Network.from_table(tables["network"], source=source)
    else:
        raise SessionError(f"{source} has neither session.users nor [network]; give one of them")
    if folder is not None:
        for table, file in tables_with_file(tables, pictures=False):
            table["file"] = str(folder / file)
    scenario = Scenario.make(source=source, **tables)
    _live(scenario, source)
    if options.emulate and folder is not None:
        if scenario.channel.trace is not None:
            look(Path(scenario.channel.trace.file), "trace", SessionError, _MOST_TRACE)
        path_laws(scenario, 0)
    check_codec(scenario, options.model_dump(exclude_unset=True), source)
    check_law(scenario, options.model_dump(exclude_unset=True), source)
    for number, table in enumerate(options.devices, start=1):
        users = scenario.network.size
        if table.user is not None and table.user > users:
            raise SessionError(f"{source}: session.devices[{number}].user is {table.user}; there are {users} users")
    return scenario, options


def _live(scenario: Scenario, source: str) -> None:
    """Refuses what only a simulation can do.

    Raises:
        ScenarioError: it is there.
    """
    sync = scenario.synchronisation
    if sync.damping is not None and sync.damping != "rule":
        raise ScenarioError(
            f'{source}: synchronisation.damping is {sync.damping!r}; in a session it must be "rule", with the ages '
            "that are measured, or left out"
        )
    if sync.damping_scale < 1.0:
        raise ScenarioError(
            f"{source}: synchronisation.damping_scale is {sync.damping_scale}; below 1 nothing is guaranteed to be "
            f"passive; use 1"
        )
    if scenario.contact.texture is not None and scenario.contact.texture.file is not None:
        raise ScenarioError(
            f"{source}: contact.texture.file is given, but members do not read image files of others; give heights"
        )
    if scenario.steps.random is not None:
        raise ScenarioError(f"{source}: steps.random is given; in a session, give a period or a rate")
