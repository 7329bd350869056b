"""Loops at a fixed rate: when they take their steps, and what a process needs for that."""

from cotouch.pacing._pacer import Pacer, PaceStatistics
from cotouch.pacing._process import ProcessState, few_arenas, give_back_memory, prepare_process, real_time_refused

__all__ = [
    "PaceStatistics",
    "Pacer",
    "ProcessState",
    "few_arenas",
    "give_back_memory",
    "prepare_process",
    "real_time_refused",
]
