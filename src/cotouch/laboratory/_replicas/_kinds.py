"""All kinds of replicas, by name."""

from cotouch.laboratory._replicas._broadcast import broadcast
from cotouch.laboratory._replicas._lockstep import lockstep
from cotouch.laboratory._replicas._owner import owner
from cotouch.laboratory._replicas._replica import ReplicaKind
from cotouch.laboratory._replicas._rollback import rollback
from cotouch.laboratory._replicas._server import server

REPLICAS: dict[str, ReplicaKind] = {kind.name: kind for kind in (server, owner, lockstep, rollback, broadcast)}
