"""`python -m cotouch` is `cotouch`."""

from cotouch.cli import main

main()
