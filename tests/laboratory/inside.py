"""What these tests take from inside the room: nothing else here imports its private modules."""

from cotouch.laboratory._cells import Store, cells, many, source_of
from cotouch.laboratory._compare import danger, drawn, score
from cotouch.laboratory._noticed import losing, multiples, ours
from cotouch.laboratory._replicas._kinds import REPLICAS
from cotouch.laboratory._replicas._replica import Moved, replicate
from cotouch.laboratory._score import dangerous
from cotouch.laboratory._study import spread, tunable
from cotouch.laboratory._study_tables import HandKind, LawTable, NetworkTable
from cotouch.laboratory._tasks import TASKS
from cotouch.laboratory._tune import harmless, tune

__all__ = [
    "REPLICAS",
    "TASKS",
    "HandKind",
    "LawTable",
    "Moved",
    "NetworkTable",
    "Store",
    "cells",
    "danger",
    "dangerous",
    "drawn",
    "harmless",
    "losing",
    "many",
    "multiples",
    "ours",
    "replicate",
    "score",
    "source_of",
    "spread",
    "tunable",
    "tune",
]
