"""What the benchmarks need is there: they look at insides that nobody else's tests hold."""

import importlib
from pathlib import Path

import pytest
from benchmarks._layout import SECTIONS, Row, laid_out

FOLDER = Path(__file__).parent.parent / "benchmarks"


@pytest.mark.parametrize("name", sorted(path.stem for path in FOLDER.glob("*.py") if path.stem != "__init__"))
def test_a_benchmark_can_be_imported(name: str) -> None:
    importlib.import_module(f"benchmarks.{name}")


def test_every_section_of_the_results_says_how_to_repeat_it() -> None:
    parts = (FOLDER / "RESULTS.md").read_text(encoding="utf-8").split("\n## ")[1:]
    found = dict(part.split("\n", 1) for part in parts)
    assert set(found) <= set(SECTIONS)
    for name, text in found.items():
        command = SECTIONS[name].command
        assert f"To repeat: `{command}`" in text
        assert "easured on " in text
        module = command.split()[2]
        assert (FOLDER.parent / module.replace(".", "/")).with_suffix(".py").exists() or module == "benchmarks"


def test_values_for_several_networks_get_a_column_each() -> None:
    rows = [
        Row("laws", "networks", "5 ms / 25 ms, 5 % loss", "", "20 draws"),
        Row("laws", "2 users, hands: cells that paid loses", "25 ms, 5 % loss: 1.99 (best rival once 3.36, half of the "
            "rule's 1.95)", "none", "of 2"),
        Row("laws", "2 users, hands: paid", "0.02 / 1.99", "", "best passive rival: 0.26 wave / 3.36 once; half of the "
            "rule's: 0.77 / 1.95"),
        Row("laws", "2 users, hands: single tasks that paid loses (best passive rival)",
            "both on 5 ms 1.19 (1.04); carry on 25 ms, 5 % loss 1.53 (1.15)"),
        Row("laws", "2 users: paid", "0.02 ± 0.00 (0.1) / 1.99 ± 0.02 (2.0)"),
        Row("laws", "2 users, 25 ms: drag felt", "0.002 Ns/m", "≤ 10 %", "0.0 %"),
        Row("laws", "paid: energy made beyond its initial energy, at most", "0 J", "0 J", "all runs"),
    ]  # fmt: skip
    text = "\n".join(laid_out("laws", rows))
    for line in (
        "20 draws.",
        "| cost | 5 ms | 25 ms, 5 % loss |",
        "| 2 users: paid | 0.02 ± 0.00 (0.1) | 1.99 ± 0.02 (2.0) |",
        "| 2 users, hands: paid | 0.02 | 1.99 |",
        "| — best passive rival | 0.26 wave | 3.36 once |",
        "| — half of the rule's | 0.77 | 1.95 |",
        "| 2 users, hands | both | 5 ms | 1.19 | 1.04 |",
        "| 2 users, hands | carry | 25 ms, 5 % loss | 1.53 | 1.15 |",
        "| 2 users, hands | mean of all | 25 ms, 5 % loss | 1.99 | once 3.36; half of the rule's 1.95 |",
        "| paid | 0 J | 0 J |",
        "| 2 users, 25 ms: drag felt | 0.002 Ns/m | ≤ 10 % | 0.0 % |",
    ):
        assert line in text.split("\n")
