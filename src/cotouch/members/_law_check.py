"""Which link laws a session may have."""

from collections.abc import Mapping
from typing import Any

from cotouch.errors import ScenarioError
from cotouch.laws import FORCE, law_named, laws
from cotouch.scenario import Scenario, options_of_springs


def signature_of(scenario: Scenario) -> str:
    """Tells the law of a session from one of the same name in another version of the software.

    Args:
        scenario: of the session.
    """
    return law_named(scenario.law[0]).signature


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
        f'{what} is "{name}"; live it is "spring", or one of those that are passive by themselves and bound what a '
        f"neighbour may do: {fit}"
    )


def check_law(scenario: Scenario, session: Mapping[str, Any], source: str) -> None:
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
            f'{source}: synchronisation.mode is "{sync.mode}"; with law "{name}" it must be "freshest", for messages '
            "of laws go with the newest sample"
        )
    if sync.damping is not None:
        raise ScenarioError(
            f'{source}: synchronisation.damping is "{sync.damping}", which only law "spring" needs live; with law '
            f'"{name}" leave it out'
        )
    coarse = session.get("encoding", "float64")
    if coarse != "float64":
        raise ScenarioError(
            f'{source}: session.encoding is "{coarse}"; with law "{name}" it must be "float64", for sums that only '
            "grow need all their digits"
        )
    for option in options_of_springs(session):
        raise ScenarioError(
            f'{source}: session.{option} is {session[option]}, which only guarded links of law "spring" have; with law '
            f'"{name}" leave it out'
        )
    if scenario.network.weights:
        raise ScenarioError(f'{source}: links have weights, which live only law "spring" can do, not "{name}"')
    if FORCE in given:
        raise ScenarioError(f"{source}: law.{FORCE} is given; live it is session.force_limit")
