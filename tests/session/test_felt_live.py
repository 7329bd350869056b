"""What a hand feels of a law between two real processes, on an emulated path of 25 ± 10 ms that loses 5 %."""

from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from benchmarks.drag import OWN, measure_drag


def test_a_hand_feels_the_predicted_drag_between_two_processes(tmp_path: Path) -> None:
    """Both at once: most of the time is that of processes that start, and of the hand on its way."""
    laws = ("spring", "paid")
    folders = [tmp_path / law for law in laws]
    for folder in folders:
        folder.mkdir()
    with ThreadPoolExecutor() as threads:
        found = dict(zip(laws, threads.map(measure_drag, laws, (2.0, 2.0), folders), strict=True))
    for one in found.values():
        assert abs(one.off) < 0.15, one
    assert found["paid"].felt - OWN <= 0.25 * (found["spring"].felt - OWN), found
