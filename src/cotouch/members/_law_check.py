"""Which link laws a session may have."""

from collections.abc import Mapping

from cotouch.errors import ScenarioError
from cotouch.laws import FORCE, law_named, laws
from cotouch.scenario import Scenario, options_of_springs


def signature_of(scenario: Scenario) -> str:
    """Tells the law and codec of a session from what another version of the software makes of the same file.

    Args:
        scenario: of the session.
    """
    signature, asked = law_named(scenario.law[0]).signature, scenario.channel.codec
    if asked is None:
        return signature
    return f"{signature} codec {asked.deadband!r} {asked.quantum!r} {asked.hold} {asked.age!r}"


def check_live(name: str, what: str) -> None:
    """Refuses a law that is not for people who need not trust each other.

    Args:
        name: of the law.
        what: where it was given, for messages.

    Raises:
        ScenarioError: it is none that can go live.
        NetworkError: there is no such law.
    """
    if name == "spring" or law_named(name).live:
        return
    fit = ", ".join(f'"{known}"' for known, law in laws().items() if law.live)
    raise ScenarioError(
        f'{what} is "{name}"; a live session needs "spring", or a law that is passive by itself and bounds what a '
        f"neighbour may do: {fit}"
    )


def check_codec(scenario: Scenario, session: Mapping[str, object], source: str) -> None:
    """Refuses what a perceptual codec cannot serve live.

    Args:
        scenario: of the session.
        session: options of its table [session] that are given.
        source: of the session, for messages.

    Raises:
        ScenarioError: it is there.
    """
    if scenario.channel.codec is None:
        return
    mode, coarse = scenario.synchronisation.mode, session.get("encoding", "float64")
    if mode != "freshest":
        raise ScenarioError(
            f'{source}: channel.codec is given, but synchronisation.mode is "{mode}", which needs every sample in '
            'full; use mode "freshest", or leave the codec out'
        )
    if coarse != "float64":
        raise ScenarioError(
            f'{source}: channel.codec is given and session.encoding is "{coarse}"; a codec rounds by its quantum, so '
            "leave one of them out"
        )


def check_law(scenario: Scenario, session: Mapping[str, object], source: str) -> None:
    """Refuses what a law cannot do live.

    Args:
        scenario: of the session.
        session: options of its table [session] that are given.
        source: of the session, for messages.

    Raises:
        ScenarioError: it is there.
    """
    sync = scenario.synchronisation
    name, given = scenario.law
    if name == "spring":
        return
    check_live(name, f"{source}: synchronisation.law")
    if sync.mode != "freshest":
        raise ScenarioError(
            f'{source}: synchronisation.mode is "{sync.mode}"; with law "{name}" it must be "freshest", because '
            "a law's messages travel with the newest sample"
        )
    if sync.damping is not None:
        raise ScenarioError(
            f'{source}: synchronisation.damping is "{sync.damping}", which only law "spring" uses in a live session; '
            f'with law "{name}", leave it out'
        )
    coarse = session.get("encoding", "float64")
    if coarse != "float64":
        raise ScenarioError(
            f'{source}: session.encoding is "{coarse}"; with law "{name}" it must be "float64", because sums that '
            "keep growing need full precision"
        )
    for option in options_of_springs(session):
        raise ScenarioError(
            f'{source}: session.{option} is {session[option]}, which applies only to guarded links of law "spring"; '
            f'with law "{name}", leave it out'
        )
    if scenario.network.weights:
        raise ScenarioError(
            f'{source}: links have weights, which in a live session only law "spring" supports, not "{name}"'
        )
    if FORCE in given:
        raise ScenarioError(f"{source}: law.{FORCE} is given; in a live session, set session.force_limit instead")
