"""Replicas that are no link law: whole bodies, moved by hands' forces, whose states may be overwritten."""

from cotouch.laboratory._replicas._broadcast import broadcast
from cotouch.laboratory._replicas._lockstep import lockstep
from cotouch.laboratory._replicas._owner import owner
from cotouch.laboratory._replicas._replica import Moved, Replica, replicate
from cotouch.laboratory._replicas._rollback import rollback
from cotouch.laboratory._replicas._server import server

REPLICAS: dict[str, Replica] = {kind.name: kind for kind in (server, owner, lockstep, rollback, broadcast)}

__all__ = ["REPLICAS", "Moved", "Replica", "replicate"]
