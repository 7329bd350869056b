"""What cotouch uses of scipy, typed: it has no types of its own. tests/architecture/test_types.py holds it to scipy."""
