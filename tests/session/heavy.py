"""A block on a table in a session on a virtual clock, and two tools that lift it."""

TABLE = """
[[world.planes]]
stiffness = 1e6
damping = 1.0
friction = 0.5
kinetic_friction = 0.4
"""
SLICK = """
[[world.planes]]
stiffness = 1e6
"""
# Far below: what meets nothing moves by the machine code of what does.
FAR = """
[[world.planes]]
point = [0, 0, -1e3]
"""
MASS, WEIGHT = 0.3, 0.3 * 9.81
_LIFT = """
[[tools]]
user = {user}
at = [{x}, 0.02, 0.02]
radius = 0.012
mass = 0.05
stiffness = 2000
damping = 1.0
friction = 0.9
kinetic_friction = 0.8
[tools.hand]
stiffness = 600
damping = 12
path = [[0, 0, 0, 0], [0.2, 0, 0, 0], [0.5, {way}, 0, 0], [0.9, {way}, 0, 0.04], [9, {way}, 0, 0.04]]
"""
LIFT = _LIFT.format(user=1, x=-0.013, way=0.016) + _LIFT.format(user=2, x=0.053, way=-0.016)


def session(
    *, users: int = 3, world: str = TABLE, hands: str = "", more: str = "", rate: int = 500, law: str = "spring"
) -> str:
    """Its file."""
    return f"""
[session]
users = {users}
spring = 25.0
wait_for_peers = 1.5
{more}
[body]
kind = "lattice"
shape = [3, 3, 3]
mass = {MASS}
stiffness = 4000
damping = 4
spacing = 0.02
frame = "floating"
[world]
gravity = [0, 0, -9.81]
{world}
[steps]
rate = {rate}
[synchronisation]
law = "{law}"
{hands}"""
