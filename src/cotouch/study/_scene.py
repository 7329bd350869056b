"""Five users with different devices at one block of a thousand nodes: the scene of the chapter in three dimensions."""

from cotouch.network import Network
from cotouch.scenario import Mode, Scenario

# Nodes along x, y, z, and how far they are apart [m].
SHAPE = (14, 10, 8)
SMALL = (10, 8, 6)
SPACING = 0.01
# N/m: between neighbours, and of every node of the lower face to the ground; together about as stiff as the links.
STIFFNESS, GROUND = 100.0, 100.0
# s: bounds of the steps, which every user draws anew all the time.
STEPS = (2e-3, 6e-3)
# s: how long the hands take to get where they go, when they let go, and the end.
REACHED, RELEASE, DURATION = 1.0, 8.0, 12.0
FRAMES = 2.0  # Hz
SEED = 3

# In words, for the report.
DEVICES = (
    "PHANToM 1.5, own dynamics, 1 kHz",
    "omega.3, 2 kHz",
    "Touch, 500 Hz",
    "delta.3, damped",
    "Falcon, 1 kHz",
)
DOES = ("grasps, pulls", "presses", "grasps, pulls", "presses against user 2", "presses, with friction")


def scene(network: Network, mode: Mode, *, shape: tuple[int, int, int] = SHAPE, scale: float = 1.0) -> Scenario:
    """The scenario.

    Args:
        network: of the five users; a link's spring and damping are shared out evenly over the nodes.
        mode: "constant" or "freshest".
        shape: nodes along x, y, z.
        scale: of the rule's damping.
    """
    nodes = shape[0] * shape[1] * shape[2]
    return Scenario.make(
        network=network.replace(spring=network.spring / nodes),
        body={
            "kind": "lattice",
            "shape": list(shape),
            "mass": 1.0,
            "stiffness": STIFFNESS,
            "damping": 0.1,
            "spacing": SPACING,
            "ground": "z-",
            "ground_stiffness": GROUND / (shape[0] * shape[1]),
        },
        steps={"duration": DURATION, "random": {"low": STEPS[0], "high": STEPS[1]}},
        seed=SEED,
        synchronisation={"law": "spring", "mode": mode, "damping": "rule", "damping_scale": scale},
        tools=tools(shape),
        solver={"tolerance": 1e-9},
        record={"nodes": [1], "frames": FRAMES},
    )


def tools(shape: tuple[int, int, int]) -> list[dict[str, object]]:
    """Two users pull at opposite upper edges, two squeeze the block between them, one presses from above."""
    long, wide, high = ((extent - 1) * SPACING for extent in shape)
    off = 0.012  # from skin to centre before the touch
    # Where it starts, where the hand goes from there, what the tool is, what the device is.
    rows: list[tuple[list[float], list[float], dict[str, object], dict[str, object]]] = [
        (
            [0.0, 0.5 * wide, high],
            [-0.038, 0.0, 0.015],  # more than this a PHANToM's motors cannot hold
            {"kind": "grasp", "radius": 0.015, "stiffness": 400.0, "damping": 1.0},
            {"kind": "phantom", "preset": "phantom"},
        ),
        ([0.5 * long, -off, 0.6 * high], [0.0, 0.04, 0.0], _touch(), {"preset": "omega", "rate": 2000.0}),
        (
            [long, 0.5 * wide, high],
            [0.06, 0.0, 0.03],
            {"kind": "grasp", "radius": 0.015, "stiffness": 400.0, "damping": 1.0},
            {"preset": "touch", "rate": 500.0},
        ),
        (
            [0.5 * long, wide + off, 0.6 * high],
            [0.0, -0.04, 0.0],
            _touch(),
            # Its own damping pays for the sampled spring: so much, that is, as the longest step of the body needs.
            {"preset": "delta", "viscous": 3.0, "coupling": "host_force", "stiffness": 400.0, "damping": 0.2},
        ),
        ([0.55 * long, 0.5 * wide, high + off], [0.01, 0.0, -0.05], _touch(friction=0.4), {"preset": "falcon"}),
    ]
    return [
        {
            "user": user,
            "at": at,
            **tool,
            "release": RELEASE,
            "hand": {"path": [[0.0, 0.0, 0.0, 0.0], [REACHED, *goal]], "release": RELEASE},
            "device": device,
        }
        for user, (at, goal, tool, device) in enumerate(rows, start=1)
    ]


def _touch(*, friction: float = 0.0) -> dict[str, object]:
    return {"kind": "touch", "radius": 0.01, "stiffness": 2000.0, "damping": 1.0, "friction": friction}
