"""What cells of a comparison follow from and come to, as their files hold it."""

from typing import Any, TypeAlias, TypedDict

# Multiples of what a law's parameters would be, by name.
Setting: TypeAlias = dict[str, float]


class TuneCell(TypedDict):
    """One law on one network: a `study` with no more in it, the `code` of the law, and what `files` hold."""

    study: dict[str, Any]
    code: str
    files: list[str]


class ScoreCell(TuneCell):
    """With a setting, and one number of users."""

    setting: Setting


class MapCell(ScoreCell):
    """With one kind of hand, at several delays [s]."""

    delay: list[float]


class TunedSettings(TypedDict):
    """Settings by what they are called, None where there is none, their costs [J], and why there is nothing."""

    settings: dict[str, Setting | None]
    cost: dict[str, float]
    tried: int
    problem: str


class Scored(TypedDict):
    """Each measure by hand, task, draw; what is felt; whether each hand is dangerous, and copies that nobody holds."""

    runs: dict[str, list[list[list[float]]]]
    felt: dict[str, float]
    dangerous: list[bool]
    loose: bool
    problem: str


class Mapped(TypedDict):
    """At each delay, whether a law is dangerous, what it costs, and how fast what should rest still moves [m/s]."""

    dangerous: list[bool]
    cost: list[float]
    restless: list[float]
