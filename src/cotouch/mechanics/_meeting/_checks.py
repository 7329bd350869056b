"""What obstacles and bodies that press each other are made of, checked."""

import math

from cotouch.errors import BodyError


def check_pressing(stiffness: float, loss: float, friction: float, kinetic: float | None, where: str = "") -> None:
    """Refuses numbers that no contact can have.

    Args:
        stiffness: κ, > 0 [N/m³].
        loss: λ, >= 0 [s/m].
        friction: Coulomb's coefficient of what does not slip, >= 0.
        kinetic: of what slips, 0 to `friction`; None: the same.
        where: what the names in a message are followed by, such as " between bodies".

    Raises:
        BodyError: one of them cannot be.
    """
    if not (math.isfinite(stiffness) and stiffness > 0.0):
        raise BodyError(f"stiffness{where} is {stiffness:g}; it must be a finite number above 0")
    for name, value in (("loss", loss), ("friction", friction)):
        if not (math.isfinite(value) and value >= 0.0):
            raise BodyError(f"{name}{where} is {value:g}; it must be a finite number at least 0")
    if kinetic is not None and not 0.0 <= kinetic <= friction:
        raise BodyError(f"kinetic friction{where} is {kinetic:g}; it must be between 0 and friction, {friction:g}")
