"""What these tests take from inside the room: nothing else here imports its private modules."""

from cotouch.web._access import Access, host_of
from cotouch.web._frames import FrameEncoder
from cotouch.web._hub import MOST_PAGES, Hub
from cotouch.web._page import Page
from cotouch.web._protocol import VERSION, Do, FrameReceipt, PointerMessage, read_binary, read_text
from cotouch.web._scene import beside_nodes, held_tools, nodes_of_points

__all__ = [
    "MOST_PAGES",
    "VERSION",
    "Access",
    "Do",
    "FrameEncoder",
    "FrameReceipt",
    "Hub",
    "Page",
    "PointerMessage",
    "beside_nodes",
    "held_tools",
    "host_of",
    "nodes_of_points",
    "read_binary",
    "read_text",
]
