"""What these tests take from inside the room: nothing else here imports its private modules."""

from cotouch.session import _requests as requests
from cotouch.session._held import HeldDevice
from cotouch.session._join import _identity as identity_of
from cotouch.session._keep import KeptHost, KeptIdentity, keep_host, kept_host
from cotouch.session._warm import _copy as warm_copy

__all__ = ["HeldDevice", "KeptHost", "KeptIdentity", "identity_of", "keep_host", "kept_host", "requests", "warm_copy"]
