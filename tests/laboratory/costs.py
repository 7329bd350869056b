"""What a task costs by a law."""

from typing import Any

from cotouch.laboratory import Study, ideal, measures_of
from cotouch.simulation import prepare

DELAY = 0.025


def cost(law: Any, task: str, *, delay: float = DELAY, measure: str = "cost", **tables: Any) -> float:
    """J of a task, over so long a way [s]; or another measure."""
    whole = Study.make(laws=[{"law": law}], networks=[{"name": "there", "delay": delay}], **tables)
    users = whole.users[0]
    hands = whole.task(task, users, whole.hands[0], 0)
    prepared = prepare(whole.scenario(whole.laws[0], whole.networks[0], users, hands))
    return measures_of(whole.laws[0], prepared, ideal(whole, hands))[measure]
