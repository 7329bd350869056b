"""Which link laws a session may have."""

from cotouch.errors import ScenarioError
from cotouch.laws import FORCE, law_named, laws
from cotouch.scenario import Scenario


def signature_of(scenario: Scenario) -> str:
    """Tells the law of a session from one of the same name in another version of the software.

    Args:
        scenario: of the session.
    """
    return law_named(scenario.synchronisation.law_given[0]).signature


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


def check_law(scenario: Scenario, encoding: str, source: str) -> None:
    """Refuses what a law cannot do live.

    Args:
        scenario: of the session.
        encoding: of numbers on the wire.
        source: of the session, for messages.

    Raises:
        ScenarioError: it is there.
    """
    sync = scenario.synchronisation
    name, given = sync.law_given
    if name == "spring":
        return
    check_live(name, f"{source}: synchronisation.law")
    for option, value, wanted, why in (
        ("synchronisation.mode", sync.mode, "freshest", "messages of laws go with the newest sample"),
        ("session.encoding", encoding, "float64", "sums that only grow need all their digits"),
    ):
        if value != wanted:
            raise ScenarioError(f'{source}: {option} is "{value}"; with law "{name}" it must be "{wanted}", for {why}')
    if scenario.network.weights:
        raise ScenarioError(f'{source}: links have weights, which live only law "spring" can do, not "{name}"')
    if FORCE in given:
        raise ScenarioError(f"{source}: law.{FORCE} is given; live it is session.force_limit")
