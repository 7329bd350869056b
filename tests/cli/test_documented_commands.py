"""The commands of live sessions as the documents have them, option for option: one host, members and a measurement."""

from collections.abc import Generator
from pathlib import Path

import pytest
from tests.blocks import PAGES, ROOT, blocks_of, commands_of
from tests.cli.test_session_commands import PATIENCE, Running, interrupted

# What is different here: nobody has the documents' address, ports are anybody's, and a measurement is short.
ADDRESS, HERE = "192.0.2.7", "127.0.0.1"


def documented(command: str) -> list[list[str]]:
    """The forms of a command in all documents, but those whose words another form has too, and those with a device."""
    forms = {
        tuple(words[1:])
        for page in PAGES
        for block in blocks_of(page)
        if block.kind == "console"
        for words in commands_of(block.text)
        if words[:2] == ["cotouch", command] and "--device" not in words
    }
    return sorted(list(form) for form in forms if not any(set(form) < set(other) for other in forms))


@pytest.fixture
def desk(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Generator[Running]:
    """Processes in a folder with the examples."""
    (tmp_path / "examples").symlink_to(ROOT / "examples")
    monkeypatch.chdir(tmp_path)
    made = Running(tmp_path)
    yield made
    made.close()


def test_host_join_and_measure_as_the_documents_have_them(desk: Running) -> None:
    (hosted,), joined, (measured,) = map(documented, ("host", "join", "measure"))
    assert ADDRESS in hosted
    assert ["join", "-", "--name", "Ann", "--page"] in joined
    host = desk.start("host", *(HERE if word == ADDRESS else word for word in hosted))
    desk.until(lambda: desk.out("host").endswith("\n"), "the invitation")
    line = desk.out("host")

    here = ("--headless", "--port", "0")
    members = [
        desk.start(f"member{n}", *words, *(here if "--page" in words else here[:1]), said=line)
        for n, words in enumerate([*joined, ["join", "-", "--name", "Ben"]])
    ]
    there = [f"member{n}" for n in range(len(members))]
    desk.until(lambda: all("ready" in desk.err(name) for name in there), "all are there")
    measuring = desk.start("measure", *measured, "--duration", "2", said=line)

    assert measuring.wait(PATIENCE) == 0, desk.complaints()
    assert "Written to network.toml" in desk.out("measure")
    assert interrupted(host) == 0, desk.complaints()
    assert [member.wait(PATIENCE) for member in members] == [0] * len(members), desk.complaints()
    assert "the page is at http://127.0.0.1:" in desk.err("member0")
    assert all(f"{who} took" in desk.out(f"member{n}") for n, who in enumerate(["Ann", "Ben"]))
