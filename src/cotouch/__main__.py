"""`python -m cotouch` is `cotouch`."""

from cotouch.cli import main

if __name__ == "__main__":
    main()
