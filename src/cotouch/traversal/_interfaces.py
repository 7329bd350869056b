"""The addresses of this machine, as its system lists them."""

import socket


def interface_hosts() -> list[str]:
    """IPv4 and IPv6 addresses of all interfaces that are up, except those that need an interface's name."""
    import psutil  # loaded where a socket listens on all interfaces, and nowhere else

    up = {name for name, state in psutil.net_if_stats().items() if state.isup}
    return [
        entry.address
        for name, entries in psutil.net_if_addrs().items()
        for entry in entries
        if name in up and entry.family in {socket.AF_INET, socket.AF_INET6} and "%" not in entry.address
    ]
