"""`cotouch measure`."""

from pathlib import Path

from rich.console import Console

from cotouch.cli._output import literal, new_table, print_json, working
from cotouch.cli._session import stop_signals, typed
from cotouch.control import Invitation
from cotouch.errors import printable
from cotouch.files import check_writable, write
from cotouch.session import MeasuredNetwork, measure


def run(invitation: str, *, seconds: float, listen: str | None, out: Path | None, as_json: bool) -> None:
    """Watches a session, and prints or writes how far its members are from each other.

    Args:
        invitation: as the host printed it.
        seconds: how long to watch.
        listen: address to listen at; None: one that fits the invitation.
        out: file to write; None: none.
        as_json: whether to print one JSON object and nothing else on standard output.
    """
    if out is not None:
        check_writable(out, (".toml",))
    decoded = Invitation.decode(typed() if invitation == "-" else invitation)
    with stop_signals() as stopped, working(f"measuring for {seconds:g} s ...", quiet=as_json):
        found = measure(decoded, seconds=seconds, listen=listen, stopped=stopped)
    if out is not None:
        write(out, found.toml().encode(), "network")
    if as_json:
        print_json(numbers(found))
    else:
        _print(found, out)


def numbers(found: MeasuredNetwork) -> dict[str, object]:
    """What was measured, for JSON; users are numbered from 1."""
    network = found.network
    return {
        "users": list(network.users),
        "delay_s": network.delay.tolist(),
        "spring_n_m": network.spring.tolist(),
        "links": [[a + 1, b + 1] for a, b in network.links],
        "not_measured": [[a + 1, b + 1] for a, b in found.missing],
        "emulated": found.emulated,
    }


def _print(found: MeasuredNetwork, out: Path | None) -> None:
    network = found.network
    missing = {*found.missing, *((b, a) for a, b in found.missing)}
    linked = {*network.links, *((b, a) for a, b in network.links)}
    shown = new_table("", *map(literal, network.users), title="One-way delay, ms")
    for i, name in enumerate(network.users):
        cells = [
            "" if i == j else "?" if (i, j) in missing else f"{1e3 * network.delay[i, j]:.1f}"
            + ("*" if (i, j) in linked else " ")
            for j in range(network.size)
        ]  # fmt: skip
        shown.add_row(literal(name), *cells)
    console = Console()
    console.print(shown)
    notes = ["Half of the shortest round trip; * marks current links."]
    if missing:
        notes.append("? marks pairs not measured: they reach each other only through the relay.")
    if found.emulated:
        notes.append("The session emulates a network, whose delays are included.")
    if out is not None:
        notes.append(f"Written to {out}; plan with: cotouch plan {out} --links {max(1, len(network.links))}")
    console.print("\n".join(map(printable, notes)), highlight=False, markup=False, soft_wrap=True)
