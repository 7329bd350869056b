"""What a session makes of its body."""

import pytest

from cotouch.errors import SessionError
from cotouch.session import SessionFile
from cotouch.session._shared_model import SharedModel

TEXT = """
[network]
users = ["Ann", "Ben"]
spring = [[0, 50], [50, 0]]
delay = [[0, 0.01], [0.01, 0]]
[body]
kind = "lattice"
shape = [3, 3, 3]
"""


@pytest.mark.parametrize(
    ("line", "name"),
    [('model = "cells"', "cells"), ('frame = "floating"', "floating"), ("gravity = [0, 0, -9]", "linear")],
)
def test_a_session_refuses_what_its_audit_cannot_work_out(line: str, name: str) -> None:
    with pytest.raises(SessionError, match=f'body.model is "{name}"; a session takes linear bodies') as caught:
        SharedModel.build(SessionFile.from_toml(TEXT + line + "\n", source="a test"))
    assert "\n" not in str(caught.value)


def test_a_linear_body_is_taken() -> None:
    assert SharedModel.build(SessionFile.from_toml(TEXT, source="a test")).body.material is None
