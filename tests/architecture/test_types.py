"""Types are known everywhere but at the border to numba."""

import importlib
import inspect
import re

import pytest
from tests.architecture.modules import PACKAGE, ROOT

STUBS = ROOT / "typings"
# Of other libraries without types, or with such as miss half, what is used has its types in `typings`.
UNTYPED = {"numba has no types"}


def test_unknown_types_are_let_pass_at_borders_only() -> None:
    reasons: dict[str, str] = {}
    for path in sorted(PACKAGE.rglob("*.py")):
        lines = path.read_text(encoding="utf-8").splitlines()
        for number, line in enumerate(lines):
            if line.startswith("# pyright:") and "reportUnknown" in line:
                assert number == 0, path
                reasons[path.relative_to(PACKAGE).as_posix()] = lines[1].removeprefix("# ")
    assert set(reasons.values()) == UNTYPED
    assert len(reasons) <= 8, "numba's border takes two files; fewer each time, not more"


def test_any_stands_at_borders_only() -> None:
    """Where numba compiles for many types they are `Any`; elsewhere only JSON and libraries without types are."""
    compiled = {"coupling", "kernels", "mechanics", "laws", "peer", "compiled.py", "passing.py", "translation.py"}
    word = re.compile(r"\bAny\b(?! \w)")
    said = [
        line
        for path in sorted(PACKAGE.rglob("*.py"))
        if path.relative_to(PACKAGE).parts[0] not in compiled
        for line in path.read_text(encoding="utf-8").splitlines()
        if word.search(line) and "import" not in line
    ]
    assert len(said) <= 34, "fewer each time, not more"


def test_types_of_arrays_have_one_name_each() -> None:
    """A module may name what an array is for, such as a flag; what it is of is named in `cotouch.arrays`."""
    plain = re.compile(
        r"^(Array|Bools?|Complex|Floats?|Ints?|Longs?|\w*Array)(?:: TypeAlias)? = npt\.NDArray", re.MULTILINE
    )
    found = {path.relative_to(PACKAGE).as_posix() for path in PACKAGE.rglob("*.py") if plain.search(path.read_text())}
    assert found == {"arrays.py"}


@pytest.mark.skipif(not STUBS.is_dir(), reason="the stubs are in the repository only")
@pytest.mark.parametrize("path", sorted(STUBS.rglob("*.pyi")), ids=lambda path: str(path.relative_to(STUBS)))
def test_stubs_name_what_there_is(path) -> None:
    name = ".".join(path.relative_to(STUBS).with_suffix("").parts).removesuffix(".__init__")
    module = importlib.import_module(name)
    text = path.read_text(encoding="utf-8")
    named = set(re.findall(r"^(?:def|class) ([A-Za-z]\w*)|^([a-z]\w*):", text, re.MULTILINE))
    for function, value in named:
        found = getattr(module, function or value)
        for argument in re.findall(rf"^def {function}\(\s*(\w+)", text, re.MULTILINE) if function else ():
            assert argument in inspect.signature(found).parameters, (name, function, argument)
