"""What a summary of a run holds."""

from typing import Any, NotRequired, TypeAlias, TypedDict

# A number, or lists of them as deep as the body has nodes and axes.
Numbers: TypeAlias = Any


class Judged(TypedDict):
    """What the links made beside what their law promises; see `judge`."""

    law: str
    made_j: float
    initial_energy_j: float
    extracted_j: float
    promised: bool
    kept: bool


class StateAtTime(TypedDict):
    """All users at a time [m, N]."""

    position: list[Numbers]
    force: list[Numbers]
    force_sum: Numbers


class Hold(StateAtTime):
    """Likewise at the end of the hold; see `force_imbalance`."""

    time_s: float
    force_imbalance: float | None


class CouplingSummary(TypedDict):
    """Most that a device's coupling gave, and may give."""

    law: str
    excess_j: float
    bound_j: float
    passive: bool


class ToolSummary(TypedDict):
    """What a tool came to; the last three of one with a device."""

    user: int
    kind: str
    device: str | None
    peak_force_n: float
    mean_force_n: float
    most_contacts: int
    contact_time_s: float
    rms_force_n: NotRequired[float]
    continuous_force_n: NotRequired[float | None]
    coupling: NotRequired[CouplingSummary]


class RigidToolSummary(TypedDict):
    """What the hand on a rigid tool felt at most."""

    user: int
    kind: str
    peak_force_n: float
    peak_torque_nm: float


class Summary(TypedDict):
    """The figures of a run that fit on one screen, ready for JSON."""

    title: str
    mode: str
    steps: int
    duration_s: float
    rate_hz: dict[str, Numbers]
    behind_s: Numbers
    finished: bool
    energy_residual: float
    passivity_margin_j: float
    slack_j: dict[str, float]
    judge: Judged
    settling_time_s: dict[str, float | None]
    settling_window_s: list[float]
    discrepancy_m: dict[str, float]
    hold: Hold
    final: StateAtTime
    energy_j: dict[str, float]
    age_s: dict[str, float]
    underruns: int
    messages_lost: int
    codec: NotRequired[dict[str, float]]
    local_damping: list[Numbers]
    tools: NotRequired[list[ToolSummary]]
    rigid_tools: NotRequired[list[RigidToolSummary]]
    device_residual: NotRequired[float]
