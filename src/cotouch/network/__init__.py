"""Who is linked to whom, how fast that brings their copies together, and what damping keeps it passive."""

from cotouch.network._certificate import Certificate, certify
from cotouch.network._checks import one_user
from cotouch.network._collocation import generator_eigenvalues
from cotouch.network._consensus import mixing
from cotouch.network._damping import (
    damping_for,
    link_damping,
    rule_damping,
)
from cotouch.network._decay import Decay, closed_loop, rightmost_root
from cotouch.network._elimination import invert
from cotouch.network._exact import exact_scaling
from cotouch.network._lags import Convention, Rounding, consensus_lags
from cotouch.network._loop import Loop, characteristic
from cotouch.network._network import Network
from cotouch.network._resonance import none_beyond, slowest
from cotouch.network._returns import arrive, chain_of, on_line, value
from cotouch.network._rightmost import rate_of, rightmost
from cotouch.network._topologies import complete, connected_graphs, path, ring, star
from cotouch.network._types import Pair
from cotouch.network._walk import polish

__all__ = [
    "Certificate",
    "Convention",
    "Decay",
    "Loop",
    "Network",
    "Pair",
    "Rounding",
    "arrive",
    "certify",
    "chain_of",
    "characteristic",
    "closed_loop",
    "complete",
    "connected_graphs",
    "consensus_lags",
    "damping_for",
    "exact_scaling",
    "generator_eigenvalues",
    "invert",
    "link_damping",
    "mixing",
    "none_beyond",
    "on_line",
    "one_user",
    "path",
    "polish",
    "rate_of",
    "rightmost",
    "rightmost_root",
    "ring",
    "rule_damping",
    "slowest",
    "star",
    "value",
]
