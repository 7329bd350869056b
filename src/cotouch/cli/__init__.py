"""The `cotouch` command. Each command is a thin shell over the library; heavy imports happen inside them."""

from cotouch.cli._app import app, main

__all__ = ["app", "main"]
