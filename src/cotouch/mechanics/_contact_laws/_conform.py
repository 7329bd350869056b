"""What every contact law must do, and those that other installed packages bring."""

from collections.abc import Callable
from typing import Any, TypeAlias, cast

from cotouch.errors import ScenarioError
from cotouch.installed import installed, installed_names
from cotouch.kernels import FourNumbers, as_written, raises, written_here
from cotouch.mechanics._contact_laws._law import CONTACT_LAWS

# Entry points of contact laws that other packages bring.
GROUP = "cotouch.contact_laws"
# A tool on which laws are tried: stiffness [N/m], radius [m].
_TOOL = 1000.0, 0.01
# Up to its middle, which is at half of the radius.
_DEPTHS = (1e-4, 0.01, 0.1, 0.3, 0.45, 0.49)
_Press: TypeAlias = Callable[[Any, float, float, Any], tuple[Any, Any, Any]]


def conform_contact_law(law: tuple[float, ...]) -> list[str]:
    """What a contact law breaks of the interface, in a sentence each; it is run as it is written, not compiled.

    Args:
        law: a NamedTuple of numbers, registered in `CONTACT_LAWS`.
    """
    given = CONTACT_LAWS[type(law)]
    where = raises(given)
    if where is not None:
        return [f"it raises an error or asserts ({where}), which nobody catches where it runs"]
    if not hasattr(given, "py_func"):
        return ["its function is not compiled; write `@inner` above it"]
    press = cast("_Press", as_written(given))
    try:
        return _findings(law, press)
    except Exception as error:  # noqa: BLE001 - what somebody wrote may be wrong in any way
        return [f"it cannot be evaluated: {error}"]


def _findings(law: tuple[float, ...], press: _Press) -> list[str]:
    found: list[str] = []
    stiffness, radius = _TOOL
    for part in _DEPTHS:
        depth = part * radius
        values = press(law, stiffness, radius, depth)
        if len(values) != 3:
            return [f"it returns {len(values)} values; it must return energy, pressure and slope"]
        energy, pressure, slope = values
        h = 1e-5 * depth
        below, above = press(law, stiffness, radius, depth - h), press(law, stiffness, radius, depth + h)
        if abs((above[0] - below[0]) / (2.0 * h) - pressure) > 1e-5 * abs(pressure):
            found.append("pressure is not the derivative of energy")
        if (above[1] - below[1]) / (2.0 * h) > slope + 1e-5 * abs(slope):
            found.append("slope is below the derivative of pressure")
        if not min(energy, pressure, slope) >= 0.0:
            found.append("energy, pressure or slope is negative or no number")
        four = press(law, stiffness, radius, FourNumbers(depth))
        if any(
            isinstance(n, FourNumbers) and abs(n.value - one) > 1e-12 * abs(one)
            for n, one in zip(four, values, strict=True)
        ):
            found.append("four points at once differ from one")
    if max(press(law, stiffness, radius, 0.0)[:2]) != 0.0:
        found.append("energy or pressure does not vanish at the tool's surface")
    return list(dict.fromkeys(found))


def contact_law_named(name: str) -> type[tuple[float, ...]]:
    """The contact law of a name, which is that of its class in small letters; also one of an installed package.

    Args:
        name: such as "stiffening".

    Raises:
        ScenarioError: there is none of this name, it cannot be loaded, or it breaks the interface.
    """
    kinds = {kind.__name__.lower(): kind for kind in CONTACT_LAWS}
    if name not in kinds:
        loaded = installed(GROUP, name, type, what="contact law", error=ScenarioError)
        if loaded is None:
            known = ", ".join(sorted({*kinds, *installed_names(GROUP)}))
            raise ScenarioError(f'contact.law is "{name}"; it must be one of {known}')
        if loaded not in CONTACT_LAWS or loaded.__name__.lower() != name:
            raise ScenarioError(
                f'the contact law "{name}" is the class {loaded.__name__}; its entry point must have its name in small '
                "letters, and its module must put it into CONTACT_LAWS"
            )
        kinds[name] = loaded
    kind = cast("type[Any]", kinds[name])
    lacks = [field for field in kind._fields if field not in kind._field_defaults]
    if lacks:
        raise ScenarioError(f'contact law "{name}" has no default for {", ".join(lacks)}; each number needs one')
    broken = [] if written_here(kind) else conform_contact_law(kind())
    if broken:
        raise ScenarioError(f'contact law "{name}" breaks the interface: {broken[0]}')
    return cast("type[tuple[float, ...]]", kind)
