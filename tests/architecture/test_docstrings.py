"""Docstrings keep what CONTRIBUTING promises: who calls a function learns what each of its parameters is."""

import ast
from collections.abc import Iterator

import pytest
from tests.architecture.modules import ROOMS, parsed

_Function = ast.FunctionDef | ast.AsyncFunctionDef


def functions(body: list[ast.stmt], prefix: str = "", *, method: bool = False) -> Iterator[tuple[str, _Function]]:
    """Public functions with two parameters or more, and those of public classes."""
    for node in body:
        if isinstance(node, ast.ClassDef) and not node.name.startswith("_"):
            yield from functions(node.body, f"{node.name}.", method=True)
        elif isinstance(node, _Function) and not node.name.startswith("_"):
            taken = node.args
            names = [entry.arg for entry in (*taken.posonlyargs, *taken.args, *taken.kwonlyargs)]
            names += [entry.arg for entry in (taken.vararg, taken.kwarg) if entry is not None]
            names = [name for name in names if name != "typingctx"]  # of numba's intrinsics, which nobody hands over
            if len(names[1:] if method and names[:1] in (["self"], ["cls"]) else names) >= 2:
                yield prefix + node.name, node


def is_command(node: _Function) -> bool:
    """Whether it is a command: each of its parameters has its help, and the docstring is the command's.

    Every command, and nothing else, takes `AsJson`.
    """
    return any(isinstance(entry.annotation, ast.Name) and entry.annotation.id == "AsJson" for entry in node.args.args)


def without_args(tree: ast.Module) -> list[str]:
    """Names of those whose docstring does not say what their parameters are."""
    found = [(name, ast.get_docstring(node)) for name, node in functions(tree.body) if not is_command(node)]
    return [name for name, text in found if text is None or "Args:" not in text]


@pytest.mark.parametrize("room", ROOMS)
def test_parameters_are_described(room: str):
    found = [(name, entry) for name in ROOMS[room] for entry in without_args(parsed(name))]
    assert found == []


def test_a_parameter_that_is_not_described_is_found():
    source = 'class A:\n    def b(self, c, d):\n        """Does."""\ndef e(f, g):\n    """Args: f, g."""\n'
    assert without_args(ast.parse(source)) == ["A.b"]
    command = 'def c(d: Annotated[int, typer.Option(help="Of it.")], e: AsJson = False):\n    """Does."""\n'
    assert without_args(ast.parse(command)) == []
    assert without_args(ast.parse(command.replace("AsJson", "bool"))) == ["c"]
