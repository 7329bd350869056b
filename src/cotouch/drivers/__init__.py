"""Devices of vendors, each behind the interface of `cotouch.haptics`; a vendor's library is loaded when asked for."""
