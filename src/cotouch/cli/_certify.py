"""`cotouch certify`."""

from pathlib import Path
from typing import TypeAlias

import numpy as np
from rich.console import Console

from cotouch.arrays import Float
from cotouch.cli._output import literal, new_table, number, print_json
from cotouch.errors import ScenarioError
from cotouch.interrupt import interruptible
from cotouch.network import Certificate, Network, certify


def run(path: Path, *, period: float, damping: str | None, as_json: bool) -> None:
    """Designs damping by each method, or checks the one given, for both ways of counting delay.

    Args:
        path: of the file to read.
        period: of the steps [s].
        damping: to check, as on the command line; None: designs one.
        as_json: whether to print one JSON object and nothing else on standard output.
    """
    network = Network.read(path)
    given = None if damping is None else _numbers(damping, network.size)
    tables, spare = interruptible(_worked_out)(network, period, given)
    if as_json:
        print_json(_as_json(network, period, tables, spare))
    else:
        _print(network, period, tables, spare)


_Tables: TypeAlias = "dict[str, dict[str, Certificate]]"
_Spare: TypeAlias = dict[tuple[str, str], float]


def _worked_out(network: Network, period: float, given: list[float] | None) -> tuple[_Tables, _Spare]:
    """The certificates by basis and method, and how far the exact test would let each damping fall."""
    # A step's sample is dated at its middle and used until the end of a step: one and a half steps on top of the delay.
    linked = network.adjacency() > 0
    ages = np.where(linked, network.delay + 1.5 * period, 0.0)
    tables = {
        "index": certify(network, periods=period, damping=given),
        "age": certify(network, ages=ages, damping=given),
    }
    spare = {
        (basis, method): certify(network, periods=period, damping=certificate.damping)["exact"].margin
        for basis, certificates in tables.items()
        for method, certificate in certificates.items()
    }
    return tables, spare


def _numbers(text: str, users: int) -> list[float]:
    try:
        values = [float(part) for part in text.replace(",", " ").split()]
    except ValueError:
        values = []
    if len(values) == 1:
        values *= users
    if len(values) != users:
        raise ScenarioError(
            f'--damping is "{text}"; it must be one number [Ns/m], or one for each of the {users} users'
        )
    return values


def _as_json(network: Network, period: float, tables: _Tables, spare: _Spare) -> dict[str, object]:
    certificates = [
        {
            "basis": basis,
            "method": method,
            "covers": certificate.covers,
            "modes": list(certificate.modes),
            "damping": _flat(certificate.damping),
            "largest": float(certificate.damping.sum(axis=1).max(initial=0.0)),
            "sum": float(certificate.damping.sum()),
            "holds": certificate.holds,
            "margin": certificate.margin,
            "user_margin": None if certificate.user_margin is None else certificate.user_margin.tolist(),
            "link_margin": None if certificate.link_margin is None else certificate.link_margin.tolist(),
            "exact_margin": spare[basis, method],
        }
        for basis, table in tables.items()
        for method, certificate in table.items()
    ]
    return {
        "users": list(network.users),
        "links": [[a + 1, b + 1] for a, b in network.links],
        "connected": network.is_connected(),
        "period_s": period,
        "certificates": certificates,
    }


def _flat(damping: Float) -> list[float] | list[list[float]]:
    """(N,) where a single column is in use, else (N, 1 + weights)."""
    used = np.flatnonzero(damping.any(axis=0))
    return damping[:, used[0] if used.size else 0].tolist() if used.size < 2 else damping.tolist()


_TITLES = {
    "index": "Constant and self-paced modes, steps up to {period:g} s",
    "age": "Freshest mode, ages up to delay + 1.5 steps of {period:g} s",
}


def _print(network: Network, period: float, tables: _Tables, spare: _Spare) -> None:
    console = Console()
    if not network.is_connected():
        console.print("[yellow]The links do not connect all users; each part is certified on its own.[/yellow]")
    for basis, certificates in tables.items():
        shown = {
            method: certificate
            for method, certificate in certificates.items()
            # With equal costs the smallest sum is the plain rule.
            if method != "sum" or not np.allclose(certificate.damping, certificates["rule"].damping, rtol=1e-9)
        }
        grid = new_table("damping, Ns/m", *shown, title=_TITLES[basis].format(period=period))
        columns = [certificate.damping.sum(axis=1) for certificate in shown.values()]
        for i, name in enumerate(network.users):
            grid.add_row(
                f"user {literal(name)}",
                *(number(float(column[i])) for column in columns),
                end_section=i + 1 == network.size,
            )
        grid.add_row("largest", *(number(float(column.max(initial=0.0))) for column in columns))
        grid.add_row("sum", *(number(float(column.sum())) for column in columns), end_section=True)
        verdicts = ("passive" if certificate.holds else "[red]not proved[/red]" for certificate in shown.values())
        grid.add_row("verdict", *verdicts)
        grid.add_row("margin", *(_percent(certificate.margin) for certificate in shown.values()))
        grid.add_row("margin, exact test", *(_percent(spare[basis, method]) for method in shown))
        console.print(grid)
        for covers in dict.fromkeys(certificate.covers for certificate in shown.values()):
            methods = [method for method, certificate in shown.items() if certificate.covers == covers]
            said = f"{' and '.join(methods)} cover{'s' * (len(methods) == 1)}"
            console.print(f"  [dim]{said}[/dim] {covers}.", highlight=False)
        console.print()
    console.print("[dim]This is for links of law spring; laws that are passive by themselves need no damping.[/dim]")


def _percent(fraction: float) -> str:
    if not np.isfinite(fraction):
        return "unlimited"
    return f"{100.0 * fraction:.1f} %" if abs(fraction) > 5e-10 else "0 %"
