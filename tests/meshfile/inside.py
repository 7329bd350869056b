"""What these tests take from inside the room: nothing else here imports its private modules."""

from cotouch.meshfile import _surfaces as surfaces
from cotouch.meshfile import _volumes as volumes
from cotouch.meshfile._inside import answer
from cotouch.meshfile._promises import promised
from cotouch.meshfile._read import _START as START
from cotouch.meshfile._wire import receive, send

__all__ = ["START", "answer", "promised", "receive", "send", "surfaces", "volumes"]
