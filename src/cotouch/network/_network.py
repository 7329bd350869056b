"""Who is joined to whom, how strongly, and how late."""

import dataclasses
import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from html import escape
from pathlib import Path
from typing import Self, final

import numpy as np
import numpy.typing as npt
from scipy import sparse
from scipy.sparse import csgraph

from cotouch.arrays import Float, Long
from cotouch.errors import NetworkError
from cotouch.network import _checks, _file
from cotouch.network._round_trips import delays_of_round_trips
from cotouch.network._types import Pair
from cotouch.units import user_number

# A delay this little above a whole number of steps is round-off of its decimal fraction, not a further step.
_STEP_ROUND_OFF = 1e-9


@final
@dataclass(frozen=True, init=False, eq=False)
class Network:
    """Users, the springs that may join them, the delays between them, and the links in use.

    Undirected means `K_ij = K_ji`; the delays of the two directions may differ [Lee & Huang 2010, section II-A]. Users
    are indices from 0 here, numbers from 1 in messages and files. Arrays are read-only.

    Attributes:
        users: names, all different, N of them.
        spring: strengths in N/m, (N, N), symmetric; 0 means that this pair cannot be linked.
        delay: seconds, (N, N), entry [i][j] from j to i.
        links: the pairs that are linked, sorted, the smaller index first.
        weights: SPD matrices (r, r) that shape springs: `K_ij = spring[i, j] * weights[weight_of[i, j]]`. One given as
            the common `weight` is kept as it is; those found in (N, N, r, r) springs have mean eigenvalue 1.
        weight_of: (N, N) index into `weights`; -1 means the identity.
    """

    users: tuple[str, ...]
    spring: Float
    delay: Float
    links: tuple[Pair, ...]
    weights: tuple[Float, ...]
    weight_of: Long

    def __init__(
        self,
        *,
        users: Iterable[str],
        spring: npt.ArrayLike,
        delay: npt.ArrayLike,
        links: Iterable[Sequence[int]] | None = None,
        weight: npt.ArrayLike | None = None,
    ) -> None:
        """Checks everything once.

        Args:
            users: names, unique and not empty.
            spring: N/m; (N, N) symmetric, at least 0, zero diagonal; or (N, N, r, r) with an SPD (or zero) matrix for
                each pair.
            delay: s; (N, N), at least 0, zero diagonal; [i][j] from j to i.
            links: pairs of user indices (from 0); None links every pair that has a spring.
            weight: one SPD matrix (r, r) common to all links: `K_ij = spring_ij * weight`; not with (N, N, r, r)
                springs.

        Raises:
            NetworkError: anything else; the message names the users, the value, and what would be right.
        """
        names = _checks.check_users(users)
        springs = _checks.check_springs(names, spring, weight)
        self._store(
            users=names,
            spring=springs.strength,
            delay=_checks.check_delay(names, delay),
            links=_checks.check_links(names, springs.strength, links),
            weights=springs.weights,
            weight_of=springs.weight_of,
        )

    def _store(self, **parts: object) -> None:
        for name, part in parts.items():
            for array in part if name == "weights" else (part,):  # pyright: ignore[reportGeneralTypeIssues, reportUnknownVariableType]
                if isinstance(array, np.ndarray):
                    array.flags.writeable = False
            object.__setattr__(self, name, part)

    @classmethod
    def read(cls, path: str | Path) -> Self:
        """Reads the `[network]` table of a TOML file; other tables of the file belong to others.

        Keys: `users`, `spring`, `delay`, and optionally `links` (pairs of user numbers from 1) and `weight`.

        Raises:
            NetworkError: the file is missing, is not TOML, or holds something wrong; the message names file and key.
        """
        return cls.from_table(_file.read_table(Path(path)), source=str(path))

    @classmethod
    def from_table(cls, table: object, *, source: str = "[network]") -> Self:
        """Makes a network from the contents of a `[network]` table, as `read` finds it in a file.

        Args:
            table: mapping with keys as in `read`; users in `links` are numbered from 1.
            source: where the table came from, for messages.

        Raises:
            NetworkError: no mapping, an unknown or missing key, or anything that the constructor rejects.
        """
        arguments = _file.arguments(table, source)
        try:
            return cls(**arguments)  # pyright: ignore[reportArgumentType]
        except NetworkError as error:
            raise NetworkError(f"{source}: {error}") from None

    def as_table(self) -> dict[str, object]:
        """The contents of a `[network]` table that `from_table` makes this network of: users are numbered from 1."""
        spring: object = self.spring.tolist()
        table: dict[str, object] = {"users": list(self.users)}
        if self.weights and (self.weight_of[self.spring > 0] == 0).all():
            table["weight"] = self.weights[0].tolist()
        elif self.weights:
            units = np.stack([*self.weights, np.eye(len(self.weights[0]))])  # -1, the identity, is the last
            spring = (self.spring[..., None, None] * units[self.weight_of]).tolist()
        links = [[user_number(a), user_number(b)] for a, b in self.links]
        return {**table, "spring": spring, "delay": self.delay.tolist(), "links": links}

    @classmethod
    def from_delays(
        cls,
        paths: str | Path | Sequence[str | Path],
        *,
        pick: Sequence[str] = (),
        spring: float = 50.0,
        quantile: float = 1.0,
    ) -> Self:
        """Users of a table of measured round trips, all of whom may be linked.

        The delay of each direction is half of the round trip. A round trip does not tell how its two ways share it;
        only their sum enters the rule and, but for round-off, the consensus and the decay of a tree.

        Args:
            paths: a CSV file, or several with the same names: measured at different times, say. The first row and
                column are names, fields are ms, an empty one was not measured.
            pick: names of the users to take; none takes all.
            spring: N/m, of each pair whose round trip was measured one way or the other.
            quantile: of what was measured of one pair, both ways and in all files: 1 takes the worst, 0.5 the median.

        Raises:
            NetworkError: a file is wrong, files or picks name others, or a value is out of its range.
        """
        if not (math.isfinite(spring) and spring > 0):
            raise NetworkError(f"spring is {spring:g} N/m; it must be finite and above 0")
        files = [paths] if isinstance(paths, str | Path) else list(paths)
        users, delay, measured = delays_of_round_trips(files, pick, quantile)
        return cls(users=users, spring=np.where(measured, spring, 0.0), delay=delay)

    def _repr_html_(self) -> str:  # pyright: ignore[reportUnusedFunction]
        """What a notebook shows: users, and of each link its spring and its delays there and back."""
        rows = "".join(
            f"<tr><td>{escape(self.users[a])}</td><td>{escape(self.users[b])}</td><td>{self.spring[a, b]:g}</td>"
            f"<td>{self.delay[b, a]:g}</td><td>{self.delay[a, b]:g}</td></tr>"
            for a, b in self.links
        )
        heads = "".join(f"<th>{head}</th>" for head in ("one", "other", "N/m", "s there", "s back"))
        return f"<p>{self.size} users, {len(self.links)} links</p><table><tr>{heads}</tr>{rows}</table>"

    def with_links(self, links: Iterable[Sequence[int]] | None) -> Self:
        """The same users, springs and delays with other links; None links every pair that has a spring."""
        return self._copy(links=_checks.check_links(self.users, self.spring, links))

    def replace(
        self,
        *,
        users: Iterable[str] | None = None,
        spring: npt.ArrayLike | None = None,
        delay: npt.ArrayLike | None = None,
        links: Iterable[Sequence[int]] | None = None,
    ) -> Self:
        """A copy in which what is given replaces what was, checked again.

        Args:
            users: new names, as many as before.
            spring: new strengths (N, N) in N/m on the same weights, or new (N, N, r, r) matrices.
            delay: new delays (N, N) in s.
            links: new links; left out, the present links stay, and they must still have springs.

        Raises:
            NetworkError: as in the constructor.
        """
        names = self.users if users is None else _checks.check_users(users)
        if len(names) != self.size:
            raise NetworkError(f"users has {len(names)} names; this network has {self.size} users")
        parts: dict[str, object] = {"users": names}
        strength = self.spring
        if spring is not None:
            springs = _checks.check_springs(names, spring, None)
            strength = springs.strength
            parts["spring"] = strength
            if np.ndim(spring) == 4:
                parts |= {"weights": springs.weights, "weight_of": springs.weight_of}
            else:
                new = (strength > 0) & (self.spring == 0)
                if len(self.weights) > 1 and new.any():
                    i, j = np.argwhere(new)[0]
                    raise NetworkError(
                        f"spring between {_checks.two_users(names, i, j)} is new, and this network has "
                        f"{len(self.weights)} weights to choose from; give spring as {self.size} x {self.size} x r x r"
                    )
                parts["weight_of"] = np.where(new, self._usual_weight(), self.weight_of)
        if delay is not None:
            parts["delay"] = _checks.check_delay(names, delay)
        parts["links"] = _checks.check_links(names, strength, self.links if links is None else links)
        return self._copy(**parts)

    def _usual_weight(self) -> int:
        """The weight of a pair that had none: the common one, where there is one."""
        used = np.unique(self.weight_of[self.spring > 0])
        return int(used[0]) if used.size == 1 else -1

    def _copy(self, **parts: object) -> Self:
        copy = object.__new__(type(self))
        copy._store(**{field.name: getattr(self, field.name) for field in dataclasses.fields(self)} | parts)
        return copy

    @property
    def size(self) -> int:
        """Number of users, N."""
        return len(self.users)

    @property
    def weight_rows(self) -> int | None:
        """Rows r of the weights; None when every spring is a scalar, which fits a body of any size."""
        return len(self.weights[0]) if self.weights else None

    def neighbours(self, i: int) -> tuple[int, ...]:
        """Users linked to user i, ascending."""
        return tuple(sorted(b if a == i else a for a, b in self.links if i in (a, b)))

    def adjacency(self) -> Long:
        """(N, N), 1 where two users are linked."""
        matrix = np.zeros((self.size, self.size), dtype=np.int64)
        for i, j in self.links:
            matrix[i, j] = matrix[j, i] = 1
        return matrix

    def linked_spring(self) -> Float:
        """(N, N) strengths in N/m, 0 where two users are not linked."""
        return self.spring * self.adjacency()

    def laplacian(self) -> Long:
        """Unweighted graph Laplacian (N, N) [Lee & Huang 2010, section II-A]."""
        adjacency = self.adjacency()
        return np.diag(adjacency.sum(axis=1)) - adjacency

    def link_matrix(self, i: int, j: int) -> float | Float:
        """`K_ij` in N/m: a scalar where its weight is the identity, else an (r, r) matrix; 0 where there is no link.

        Args:
            i: index of one end.
            j: of the other.
        """
        if (min(i, j), max(i, j)) not in self.links:
            return 0.0
        index = int(self.weight_of[i, j])
        strength = float(self.spring[i, j])
        return strength if index < 0 else strength * self.weights[index]

    def stiffness_matrix(self, rows: int = 1) -> sparse.csr_array:
        """`P` (N*rows square, N/m) of the synchronisation springs [Lee & Huang 2010, eq. 5].

        Args:
            rows: coordinates of one copy of the body; must be r when the springs have weights.

        Raises:
            NetworkError: `rows` does not fit the weights, or is less than 1.
        """
        if rows < 1 or self.weight_rows not in (None, rows):
            right = (
                "at least 1" if self.weight_rows is None else f"{self.weight_rows}, as the weights of the springs have"
            )
            raise NetworkError(f"rows is {rows}; it must be {right}")
        spring = self.linked_spring()
        total = sparse.csr_array((self.size * rows, self.size * rows), dtype=np.float64)
        for index in range(-1, len(self.weights)):
            part = np.where(self.weight_of == index, spring, 0.0)
            unit = np.eye(rows) if index < 0 else self.weights[index]
            laplacian = sparse.csr_array(np.diag(part.sum(axis=1)) - part)
            total = total + sparse.csr_array(sparse.kron(laplacian, sparse.csr_array(unit)))
        total.eliminate_zeros()
        return total

    def components(self) -> tuple[tuple[int, ...], ...]:
        """Groups of users that links join, each ascending, in the order of their first users."""
        count, label = csgraph.connected_components(self.adjacency(), directed=False)
        return tuple(tuple(int(i) for i in np.flatnonzero(label == group)) for group in range(count))

    def is_connected(self) -> bool:
        """Whether links join every user to every other, directly or through others."""
        return len(self.components()) == 1

    def index_delays(self, period: float) -> Long:
        """Indexing delays `N_ij` (N, N) in steps of `period` seconds: rounded up, at least 1; 0 off the links.

        Raises:
            NetworkError: `period` is not a positive finite number.
        """
        if not (np.isfinite(period) and period > 0):
            raise NetworkError(f"period is {period:g} s; it must be finite and above 0")
        steps = np.maximum(np.ceil(self.delay / period - _STEP_ROUND_OFF), 1).astype(np.int64)
        return steps * self.adjacency()
