"""By which names the server is called, from which pages, and how often."""

import pytest
from tests.web.inside import Access, host_of

LOCAL = Access(listen="127.0.0.1", token="right")
EVERYWHERE = Access(listen="0.0.0.0", token="right")
NAMED = Access(listen="lab.example", token="right")


@pytest.mark.parametrize(
    ("access", "host", "arrived", "let_in"),
    [
        (LOCAL, "127.0.0.1:8765", "127.0.0.1", True),
        (LOCAL, "localhost:8765", "127.0.0.1", True),
        (LOCAL, "LOCALHOST", "127.0.0.1", True),
        (LOCAL, "localhost:9000", "127.0.0.1", True),  # a forwarded port
        (LOCAL, "[::1]:8765", "::1", True),
        (LOCAL, "evil.example:8765", "127.0.0.1", False),
        (LOCAL, "127.0.0.1.evil.example", "127.0.0.1", False),
        (LOCAL, "localhost.evil.example", "127.0.0.1", False),
        (LOCAL, "192.168.1.5:8765", "127.0.0.1", False),
        (LOCAL, "127.0.0.1:8765@evil.example", "127.0.0.1", False),
        (LOCAL, "evil@127.0.0.1:8765", "127.0.0.1", False),
        (LOCAL, "127.0.0.1:port", "127.0.0.1", False),
        (LOCAL, "127.0.0.1/x", "127.0.0.1", False),
        (LOCAL, "[::1", "127.0.0.1", False),
        (LOCAL, "", "127.0.0.1", False),
        (LOCAL, None, "127.0.0.1", False),
        (EVERYWHERE, "192.168.1.5:8765", "192.168.1.5", True),
        (EVERYWHERE, "192.168.1.5:8765", "::ffff:192.168.1.5", True),
        (EVERYWHERE, "192.168.1.6:8765", "192.168.1.5", False),
        (EVERYWHERE, "evil.example:8765", "192.168.1.5", False),
        (EVERYWHERE, "localhost:8765", "192.168.1.5", False),
        (EVERYWHERE, "localhost:8765", "127.0.0.1", True),
        (NAMED, "lab.example:8765", "192.168.1.5", True),
        (NAMED, "evil.example:8765", "192.168.1.5", False),
    ],
)
def test_host(access: Access, host: str | None, arrived: str, let_in: bool):
    assert access.host_allowed(host, arrived) is let_in


@pytest.mark.parametrize(
    ("origin", "needed", "let_in"),
    [
        ("http://127.0.0.1:8765", True, True),
        ("HTTP://127.0.0.1:8765", True, True),
        (None, False, True),
        (None, True, False),
        ("null", True, False),
        ("https://127.0.0.1:8765", True, False),
        ("http://127.0.0.1:8766", True, False),
        ("http://127.0.0.1", True, False),
        ("http://localhost:8765", True, False),
        ("http://evil.example", False, False),
        ("http://127.0.0.1:8765.evil.example", True, False),
        ("file://", True, False),
        ("", True, False),
    ],
)
def test_origin(origin: str | None, needed: bool, let_in: bool):
    assert Access.origin_allowed(origin, "127.0.0.1:8765", needed=needed) is let_in


@pytest.mark.parametrize("token", [None, "", "Right", "right ", "righ", "rightt", "\ud800", "ü"])
def test_wrong_tokens(token: str | None):
    assert LOCAL.token_right("right")
    assert not LOCAL.token_right(token)


def test_host_of():
    assert host_of("[fe80::1]:80") == "fe80::1"
    assert host_of("a:99999999") is None
