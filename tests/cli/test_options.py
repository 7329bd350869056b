"""What one command takes, another does not refuse."""

from pathlib import Path

import typer
from tests.cli.commands import here
from typer.testing import CliRunner

from cotouch.cli import app
from cotouch.scenario import FileTable, Scenario

EXAMPLES = Path(__file__).parents[2] / "examples"


def test_a_file_of_a_live_session_is_a_scenario() -> None:
    live = Scenario.read(EXAMPLES / "live.toml")
    assert live.network.links == Scenario.read(EXAMPLES / "five-users.toml").network.links
    done = here("certify", EXAMPLES / "live.toml")
    assert done.returncode == 0, done.stderr


def test_the_body_command_takes_every_option_of_a_scenarios_body() -> None:
    command = typer.main.get_group(app).commands["body"]
    own = {parameter.name for parameter in command.params}
    # --most: a file has one of the two; parts are tables, which only a file of a scenario can say.
    together = {"most_triangles", "most_elements", "parts"}
    assert set(FileTable.model_fields) - {"kind"} - together <= own
    assert "most" in own


def test_no_duration_is_below_zero() -> None:
    """A host of -2 seconds printed an invitation, ended at once, and called that a success."""
    for name in ("host", "join", "measure", "demo"):
        done = here(name, *([] if name == "demo" else ["nothing"]), "--duration", "-2")
        assert done.returncode == 2
        assert "Invalid value for '--duration'" in done.stderr


def test_the_list_of_commands_cuts_no_sentence() -> None:
    for words in ((), ("devices",)):
        shown = CliRunner().invoke(app, [*words, "--help"], terminal_width=80).output.partition("Commands:\n")[2]
        assert "  list " in shown or "  simulate " in shown
        assert "..." not in shown
