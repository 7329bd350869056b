"""How much memory a run takes, so that one that does not fit is refused before it begins."""

from pathlib import Path

from cotouch.body import Body
from cotouch.errors import ScenarioError
from cotouch.mechanics import Model
from cotouch.scenario import Scenario
from cotouch.simulation._channel import certain
from cotouch.simulation._clocks import most_steps
from cotouch.simulation._layout import CLOSED_LEDGER, SLOT_LEDGER, TICK_LEDGER, TOOL_LEDGER, USER_LEDGER, WORLD_LEDGER

_NUMBER = 8  # bytes
# What remains of a record, and the copy of it that goes into the result.
_COPIES = 2
# Numbers of each step of a tool and its device.
_TOOL = 40
# And of what a peer reports of a step, as Python keeps it.
_REPORT = 400


def needed(scenario: Scenario, body: Body, ready: Model, kept: int) -> int:
    """Memory that a run and its result take at most, about [bytes].

    Args:
        scenario: what is asked for.
        body: the shared object.
        ready: the same for the kernels.
        kept: how many nodes are recorded.

    Raises:
        ScenarioError: there are too many steps to count.
    """
    steps, users, links = most_steps(scenario), scenario.network.size, len(scenario.network.links)
    slots, width = 2 * links, ready.width
    clocks = users * 6 + slots * (2 if certain(scenario.channel) else 6)
    records = steps // scenario.record.every + 1
    ledgers = len(USER_LEDGER) + (len(TOOL_LEDGER) if scenario.proxies else 0)
    ledgers += 0 if ready.force is None else len(CLOSED_LEDGER) + (ready.force.world is not None) * len(WORLD_LEDGER)
    axes = body.dimension if ready.full else 1
    own = 2 * kept * width * axes + ledgers + 2 + width
    entry = users * own + len(scenario.hands) * width * axes + slots * (len(SLOT_LEDGER) + 1)
    entry += links + len(TICK_LEDGER) + len(scenario.tools) * _TOOL + users * len(body.tools) * 8 * width
    frames = 0 if scenario.record.frames is None else scenario.steps.duration * scenario.record.frames
    shown = frames * users * (ready.operator_rows * width + body.nodes * body.dimension)
    if scenario.channel.codec is not None:  # every step of every peer, as it was reported
        entry += users * (2 * ready.operator_rows * ready.width + _REPORT) * scenario.record.every
    return int(_NUMBER * (steps * clocks + _COPIES * (records * entry + shown)))


def refuse_beyond(wanted: int, free: int) -> None:
    """Refuses what does not fit.

    Args:
        wanted: by the run [bytes].
        free: [bytes].

    Raises:
        ScenarioError: it does not fit.
    """
    if wanted > free:
        raise ScenarioError(
            f"the run needs about {wanted / 1e9:.3g} GB of memory, but {free / 1e9:.3g} GB are free; make "
            "steps.duration shorter, or keep less of it with record.every, record.nodes and record.frames"
        )


def free_memory() -> int:
    """Memory that this process may still take: the machine's, or of what confines the process [bytes]."""
    import psutil

    free = int(psutil.virtual_memory().available)
    for most, used in (
        ("memory.max", "memory.current"),
        ("memory/memory.limit_in_bytes", "memory/memory.usage_in_bytes"),
    ):
        try:
            limit = (Path("/sys/fs/cgroup") / most).read_text(encoding="ascii").strip()
            if limit != "max":
                free = min(free, int(limit) - int((Path("/sys/fs/cgroup") / used).read_text(encoding="ascii")))
        except (OSError, ValueError):
            continue
    return max(free, 0)
