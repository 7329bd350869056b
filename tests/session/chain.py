"""Two nodes on a line, one of them held, which the first user moves."""

_TEXT = """
[session]
users = {users}
spring = 60.0
{more}
[body]
kind = "chain"
nodes = 2
spacing = 1.0
dimension = 1
mass = 0.5
damping = 0.5
stiffness = 50.0
ground = [1]
ground_stiffness = 30.0
[steps]
rate = {rate}
[synchronisation]
law = "{law}"
{mode}
[[hands]]
user = 1
at = [1.0]
path = {path}
stiffness = 40.0
damping = 1.0
"""


def chain(
    *,
    users: int = 3,
    rate: int = 100,
    law: str = "spring",
    mode: str = "",
    path: str = "[[0, 0], [1, 0.2]]",
    more: str = "",
) -> str:
    """The file of a session of it.

    Args:
        users: how many slots.
        rate: of steps [Hz].
        law: of the links.
        mode: of the synchronisation; by default that of a session.
        path: of the hand.
        more: options of the session.
    """
    mode = f'mode = "{mode}"' if mode else ""
    return _TEXT.format(users=users, rate=rate, law=law, mode=mode, path=path, more=more)
