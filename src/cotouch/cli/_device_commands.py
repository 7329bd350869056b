"""The commands `cotouch devices ...`."""

from typing import Annotated

import typer

from cotouch.cli._options import AsJson

devices = typer.Typer(
    no_args_is_help=True,
    help="List, check, calibrate and monitor haptic devices.",
)
DeviceName = Annotated[
    str, typer.Argument(help="name, name:variant or name:variant,option=value,...", show_default=False)
]
AllowMotion = Annotated[bool, typer.Option("--allow-motion", help="The device may move by itself to calibrate.")]


@devices.command("list")
def devices_list(as_json: AsJson = False) -> None:
    """List installed drivers and connected devices."""
    from cotouch.cli._devices import show

    show(as_json=as_json)


@devices.command("check")
def devices_check(
    device: DeviceName,
    allow_motion: AllowMotion = False,
    force: Annotated[bool, typer.Option(help="Switch the motors on, for 0.05 N.")] = True,
    as_json: AsJson = False,
) -> None:
    """Check a device against the requirements.

    The exit code is 1 if the device fails.
    """
    from cotouch.cli._devices import check

    if not check(device, allow_motion=allow_motion, force=force, as_json=as_json):
        raise typer.Exit(1)


@devices.command("calibrate")
def devices_calibrate(device: DeviceName, allow_motion: AllowMotion = False, as_json: AsJson = False) -> None:
    """Calibrate a device, so that its positions are absolute."""
    from cotouch.cli._devices import calibrate

    calibrate(device, allow_motion=allow_motion, as_json=as_json)


@devices.command("monitor")
def devices_monitor(
    device: DeviceName,
    seconds: Annotated[
        float | None,
        typer.Option("--duration", help="Duration [s]; default: until Ctrl-C.", min=0.0, show_default=False),
    ] = None,
    as_json: AsJson = False,
) -> None:
    """Show what a device measures, with its motors off."""
    from cotouch.cli._devices import monitor

    monitor(device, seconds=seconds, as_json=as_json)
