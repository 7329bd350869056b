"""Shapes that stand still: how deep a point is in them, one file for each."""
