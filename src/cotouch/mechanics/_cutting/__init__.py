"""Cutting: which elements a blade takes away, and what they held."""
