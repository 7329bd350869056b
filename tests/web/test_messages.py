"""The page's types are what the server's models say."""

import importlib.util
from pathlib import Path

import pytest

PAGE = Path(__file__).parents[2] / "page"


@pytest.mark.skipif(not PAGE.is_dir(), reason="the page's sources are in the repository only")
def test_the_page_and_the_server_mean_the_same_messages() -> None:
    spec = importlib.util.spec_from_file_location("page_messages", PAGE / "messages.py")
    assert spec is not None
    assert spec.loader is not None
    made = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(made)
    assert made.MESSAGES.read_text(encoding="utf-8") == made.messages(), (
        "run `python page/messages.py`, build the page, and commit both"
    )
