"""What a hand feels of a law between two real processes, on an emulated path of 25 ± 10 ms that loses 5 %."""

from pathlib import Path

from benchmarks.drag import OWN, measure_drag


def test_a_hand_feels_the_predicted_drag_between_two_processes(tmp_path: Path) -> None:
    found = {}
    for law in ("spring", "paid"):
        (tmp_path / law).mkdir()
        found[law] = measure_drag(law, 3.0, tmp_path / law)
        assert abs(found[law].off) < 0.15, found[law]
    assert found["paid"].felt - OWN <= 0.25 * (found["spring"].felt - OWN), found
