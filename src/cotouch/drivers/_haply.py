"""Haply's driver in the registry. It loads whole, as whoever must take the force away has no time to load it then."""

from dataclasses import replace

from cotouch.device import PRESETS
from cotouch.drivers._inverse import EVENTS, LIMIT, Inverse3
from cotouch.drivers._inverse_aside import SERVICE, halt, present
from cotouch.haptics import Device, Driver


def _inverse3(
    *,
    id: str | int | None = None,  # noqa: A002  the service's word
    url: str | None = None,
    events: str | None = None,
    limit: float | None = None,
    grip: str | int | None = None,
) -> Device:
    return Inverse3(
        None if id is None else str(id),
        url=url or SERVICE,
        events=None if events == "none" else events or EVENTS,
        limit=LIMIT if limit is None else float(limit),
        grip=None if grip is None else str(grip),
    )


def _halt_inverse3(*, id: str | int | None = None, **options: str | float) -> None:  # noqa: A002
    halt(None if id is None else str(id), url=str(options.get("url", SERVICE)))


HAPLY = Driver(
    name="haply",
    summary="Haply Inverse3 with or without VerseGrip, through the Inverse Service",
    make=_inverse3,
    spec=replace(PRESETS["inverse3"], force=5.0),
    options={
        "id": "identity of the device, if there are several",
        "url": "of the service; ws://localhost:10001",
        "events": "url of the service's events; ws://localhost:10020, or none",
        "grip": "identity of the VerseGrip; else the one that belongs to the device, if that can be determined",
        "limit": "within which the service must answer, 0.005 to 0.08 [s]; 0.06",
    },
    watchdog="Unknown to us: we assume that the service keeps applying the last force, and send zero from elsewhere.",
    halt=_halt_inverse3,
    present=present,
    tested="a service written from the published schema; no device",
)
"""Haply Inverse3."""
