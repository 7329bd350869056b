"""cotouch: hold, push and deform one virtual object together over any packet network, stably, and feel each other.

    >>> import cotouch
    >>> run = cotouch.simulate({
    ...     "network": {"users": ["Ann", "Ben"], "spring": [[0, 50], [50, 0]], "delay": [[0, 0.05], [0.05, 0]]},
    ...     "hands": [{"user": 1, "path": 0.1}],
    ... })
    >>> run.sizes["user"]
    2

Everything here is loaded on first use, so that `import cotouch` and the command line start quickly.
"""

TYPE_CHECKING = False  # as `typing` has it, which takes long to load; Ctrl-C is not heeded yet
if TYPE_CHECKING:
    from cotouch.body import Body, body_from_surface, body_from_tetrahedra, chain, lattice, point
    from cotouch.errors import (
        BodyError,
        CotouchError,
        DeviceError,
        InputError,
        NetworkError,
        OutputError,
        RecordingError,
        ScenarioError,
        SessionError,
        TransportError,
        UnsupportedError,
    )
    from cotouch.laboratory import impedance, sweep
    from cotouch.network import Certificate, Network, certify
    from cotouch.peer import Peer
    from cotouch.planning import Plan, plan, tune_springs
    from cotouch.scenario import Scenario
    from cotouch.simulation import (
        save,
        settling_time,
        simulate,
        summary,
        tables,
    )
    from cotouch.version import __version__

_HOME = {
    "Body": "cotouch.body",
    "BodyError": "cotouch.errors",
    "Certificate": "cotouch.network",
    "CotouchError": "cotouch.errors",
    "DeviceError": "cotouch.errors",
    "InputError": "cotouch.errors",
    "Network": "cotouch.network",
    "NetworkError": "cotouch.errors",
    "OutputError": "cotouch.errors",
    "Peer": "cotouch.peer",
    "Plan": "cotouch.planning",
    "RecordingError": "cotouch.errors",
    "Scenario": "cotouch.scenario",
    "ScenarioError": "cotouch.errors",
    "SessionError": "cotouch.errors",
    "TransportError": "cotouch.errors",
    "UnsupportedError": "cotouch.errors",
    "__version__": "cotouch.version",
    "body_from_surface": "cotouch.body",
    "body_from_tetrahedra": "cotouch.body",
    "certify": "cotouch.network",
    "impedance": "cotouch.laboratory",
    "sweep": "cotouch.laboratory",
    "chain": "cotouch.body",
    "lattice": "cotouch.body",
    "point": "cotouch.body",
    "plan": "cotouch.planning",
    "save": "cotouch.simulation",
    "settling_time": "cotouch.simulation",
    "simulate": "cotouch.simulation",
    "summary": "cotouch.simulation",
    "tables": "cotouch.simulation",
    "tune_springs": "cotouch.planning",
}

__all__ = [
    "Body",
    "BodyError",
    "Certificate",
    "CotouchError",
    "DeviceError",
    "InputError",
    "Network",
    "NetworkError",
    "OutputError",
    "Peer",
    "Plan",
    "RecordingError",
    "Scenario",
    "ScenarioError",
    "SessionError",
    "TransportError",
    "UnsupportedError",
    "__version__",
    "body_from_surface",
    "body_from_tetrahedra",
    "certify",
    "chain",
    "impedance",
    "lattice",
    "plan",
    "point",
    "save",
    "settling_time",
    "simulate",
    "summary",
    "sweep",
    "tables",
    "tune_springs",
]


def __getattr__(name: str) -> object:
    home = _HOME.get(name)
    if home is None:
        raise AttributeError(f"module 'cotouch' has no attribute {name!r}")
    from importlib import import_module

    return getattr(import_module(home), name)


def __dir__() -> list[str]:
    return sorted(__all__)
