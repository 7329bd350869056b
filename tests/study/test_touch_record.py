"""The record of random scenarios with tools: each is its number's alone, and what it looks for would be found."""

import numpy as np
import pytest
from benchmarks import touch_record as record


def test_a_number_is_a_scenario():
    one, kind = record.scenario(5)
    again, same = record.scenario(5)
    assert (one.as_json(), kind) == (again.as_json(), same)
    assert record.scenario(6)[0].as_json() != one.as_json()


def test_kinds_and_tools_vary():
    made = [record.scenario(number) for number in range(1, 41)]
    assert {kind for _, kind in made} == {"nodal", "elastic", "truncated"}
    tools = [tool for scenario, _ in made for tool in scenario.tools]
    assert {tool.kind for tool in tools} == {"touch", "grasp"}
    assert min(tool.stiffness for tool in tools) < 2e3
    assert max(tool.stiffness for tool in tools) > 5e5
    assert {tool.device.coupling for tool in tools if tool.device} == {"pspm", "host_force"}
    assert any(tool.device is None for tool in tools)


def test_a_finding():
    found = record.examine(5)
    assert isinstance(found, record.Finding)
    assert found.residual <= record.TOLERANCE
    assert found.given <= record.TOLERANCE
    assert found.margin >= -record.TOLERANCE
    assert found.switches > 10


def test_nearest_points_of_triangles():
    corners = np.array([[[0.0, 0, 0], [1, 0, 0], [0, 1, 0]]])
    for point, nearest in (
        ([0.2, 0.2, 1.0], [0.2, 0.2, 0.0]),
        ([0.5, -1.0, 0.5], [0.5, 0.0, 0.0]),
        ([2.0, 2.0, 0.0], [0.5, 0.5, 0.0]),
        ([-1.0, -1.0, 2.0], [0.0, 0.0, 0.0]),
    ):
        np.testing.assert_allclose(record._nearest(corners, np.array(point))[0], nearest, atol=1e-15)


def test_findings_are_kept_and_taken_up_again(tmp_path, monkeypatch: pytest.MonkeyPatch):
    kept = tmp_path / "findings.jsonl"
    first, refused = record.run(2, 1, kept)
    assert refused == []

    def never(number: int):
        raise AssertionError(number)

    monkeypatch.setattr(record, "examine", never)
    again, _ = record.run(2, 1, kept)
    assert again == first
