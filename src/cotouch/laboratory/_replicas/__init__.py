"""Replicas that are no link law: whole bodies, moved by hands' forces, whose states may be overwritten."""

from cotouch.laboratory._replicas._kinds import REPLICAS
from cotouch.laboratory._replicas._replica import Moved, ReplicaKind, replicate

__all__ = ["REPLICAS", "Moved", "ReplicaKind", "replicate"]
