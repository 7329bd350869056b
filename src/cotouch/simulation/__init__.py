"""Many virtual peers on a virtual network: scenario in, labelled result out."""

from cotouch.simulation._animation import HTML, Animation, PortTracks, ToolTracks, UserSeries
from cotouch.simulation._batch import Outcome, run_batch
from cotouch.simulation._body_report import BodyReport, body_report, save_body_figure
from cotouch.simulation._channel import start_of
from cotouch.simulation._figures import FIGURES, figures, save_figures, shade_hold
from cotouch.simulation._law_setup import facts_of, given_law
from cotouch.simulation._layout import TICK_RESIDUAL, TICK_STORED, TOOL_LEDGER, USER_LEDGER
from cotouch.simulation._metrics import (
    at_times,
    discrepancy,
    felt,
    force_imbalance,
    hold_window,
    judge,
    settling_time,
    summary,
)
from cotouch.simulation._outcome import run_prepared
from cotouch.simulation._peers import PeerRun, run_peers
from cotouch.simulation._prepare import Prepared, prepare, with_hands, with_law
from cotouch.simulation._result import dataset, hand_forces, save, simulate
from cotouch.simulation._schedule import Schedule, schedule
from cotouch.simulation._shown import animation, frame_rate
from cotouch.simulation._summary_tables import Judged, Numbers, RigidToolSummary, Summary, ToolSummary
from cotouch.simulation._tables import tables

__all__ = [
    "FIGURES",
    "HTML",
    "TICK_RESIDUAL",
    "TICK_STORED",
    "TOOL_LEDGER",
    "USER_LEDGER",
    "Animation",
    "BodyReport",
    "Judged",
    "Numbers",
    "Outcome",
    "PeerRun",
    "PortTracks",
    "Prepared",
    "RigidToolSummary",
    "Schedule",
    "Summary",
    "ToolSummary",
    "ToolTracks",
    "UserSeries",
    "animation",
    "at_times",
    "body_report",
    "dataset",
    "discrepancy",
    "facts_of",
    "felt",
    "figures",
    "force_imbalance",
    "frame_rate",
    "given_law",
    "hand_forces",
    "hold_window",
    "judge",
    "prepare",
    "run_batch",
    "run_peers",
    "run_prepared",
    "save",
    "save_body_figure",
    "save_figures",
    "schedule",
    "settling_time",
    "shade_hold",
    "simulate",
    "start_of",
    "summary",
    "tables",
    "with_hands",
    "with_law",
]
