"""Benchmarks: `python -m benchmarks` prints everything in one table, `python -m benchmarks.step` one of them."""
