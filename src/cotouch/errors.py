"""Every error that cotouch raises on purpose, as one tree.

::

    CotouchError
    └── InputError (also a ValueError)   what the caller handed over cannot be used; exit code 2 on the command line
        ├── BodyError                    a matrix, a shape or a mesh
        ├── NetworkError                 users, links, springs, delays
        ├── DeviceError                  a device, a hand, or what couples them to the object
        ├── ScenarioError                a scenario, one of its options, or the file it came from
        └── UnsupportedError             correct in itself, but outside what the asked-for method can do

A message is one sentence that names the thing, its value, and what would be right.
"""


class CotouchError(Exception):
    """Root of every error that cotouch raises on purpose."""


class InputError(CotouchError, ValueError):
    """What the caller handed over cannot be used."""


class BodyError(InputError):
    """A body that cannot be simulated: a matrix, a shape or a mesh is wrong."""


class NetworkError(InputError):
    """A network that makes no sense: users, links, springs or delays are wrong."""


class DeviceError(InputError):
    """A device, a hand or a coupling that cannot be simulated or would not be passive."""


class ScenarioError(InputError):
    """A scenario, one of its options, or the file it came from is wrong."""


class UnsupportedError(InputError):
    """A correct input outside what the asked-for method can do."""
