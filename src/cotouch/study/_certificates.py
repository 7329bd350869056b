"""What damping it takes, by which argument, and what each argument covers."""

from dataclasses import dataclass
from typing import final

from cotouch.arrays import Float
from cotouch.network import Certificate, Network, certify, rightmost_root
from cotouch.study._attack import CORNERS, worst_force


@final
@dataclass(frozen=True, kw_only=True, eq=False)
class Proof:
    """One certificate with what its damping does.

    Attributes:
        name: "rule", "minimax" or "exact".
        certificate: as `cotouch.network.certify` gives it.
        rate: rightmost root of the closed loop with this damping [1/s].
        least: least work of the worst hands against it, for each N²s of force [J].
    """

    name: str
    certificate: Certificate
    rate: float
    least: float

    @property
    def damping(self) -> Float:
        """B_i [Ns/m]."""
        return self.certificate.damping[:, 0]


@final
@dataclass(frozen=True, kw_only=True, eq=False)
class Certificates:
    """Certificates for constant index delays, and what the age rule covers beside them.

    Attributes:
        proofs: of the network with constant index delays and one period.
        by_age: the rule from ages.
        period: T [s].
    """

    proofs: tuple[Proof, ...]
    by_age: Certificate
    period: float

    def numbers(self) -> dict[str, object]:
        """For JSON."""
        return {
            proof.name: {
                "damping_ns_m": proof.damping.tolist(),
                "largest_ns_m": float(proof.damping.max()),
                "sum_ns_m": float(proof.damping.sum()),
                "rate_1_s": proof.rate,
                "worst_force_j": proof.least,
                "modes": list(proof.certificate.modes),
                "holds": proof.certificate.holds,
            }
            for proof in self.proofs
        }


def certificates(network: Network, *, period: float, corners: int = CORNERS) -> Certificates:
    """Designs the damping by each method and tries it.

    Args:
        network: users and the links in question.
        period: length of the steps [s].
        corners: of the worst force; see `worst_force`.
    """
    found = certify(network, periods=period)
    proofs: list[Proof] = []
    for name in ("rule", "minimax", "exact"):
        damping = found[name].damping[:, 0]
        attack = worst_force(network, period=max(period, 5e-3), corners=corners, damping=name)
        rate = rightmost_root(network, sync_damping=damping).rate
        proofs.append(Proof(name=name, certificate=found[name], rate=rate, least=attack.least))
    return Certificates(proofs=tuple(proofs), by_age=certify(network)["rule"], period=period)
