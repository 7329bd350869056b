"""What one command takes, another does not refuse."""

import inspect
from pathlib import Path

import pytest
from tests.cli.commands import here

from cotouch.cli._app import body
from cotouch.scenario import FileTable, Scenario

EXAMPLES = Path(__file__).parents[2] / "examples"


def test_a_file_of_a_live_session_is_a_scenario() -> None:
    live = Scenario.read(EXAMPLES / "live.toml")
    assert live.network.links == Scenario.read(EXAMPLES / "five-users.toml").network.links
    done = here("certify", EXAMPLES / "live.toml")
    assert done.returncode == 0, done.stderr


def test_the_body_command_takes_every_option_of_a_scenarios_body() -> None:
    own = set(inspect.signature(body).parameters)
    together = {"most_triangles", "most_elements"}  # --most: a file has one of them
    assert set(FileTable.model_fields) - {"kind"} - together <= own
    assert "most" in own


@pytest.mark.parametrize("text", ["down", "0,0", "1,2,3,4"])
def test_a_gravity_that_is_none_is_a_sentence(text: str) -> None:
    done = here("body", "x.stl", "--gravity", text)
    assert (done.returncode, done.stderr) == (
        2,
        f'cotouch: --gravity is "{text}"; it must be three numbers, as 0,0,-9.81\n',
    )
