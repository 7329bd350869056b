"""Replicas that are no link law: whole bodies, moved by hands' forces, whose states may be overwritten."""
