"""What joins a device to its proxy without making energy: one law for simulated devices and for servos."""

from cotouch.coupling._conform import conform_coupling
from cotouch.coupling._end import (
    END,
    EndFields,
    EnergyMessage,
    available_energy,
    book_end,
    discard,
    end_row,
    hear,
    hear_end,
    hold_gap,
    message_of,
    pool,
    share,
    squared,
    unheard,
)
from cotouch.coupling._law import (
    NAME_BYTES,
    DeviceCoupling,
    HeldForce,
    coupling_at,
    device_couplings,
    register_coupling,
    run_end,
)
from cotouch.coupling._modulation import (
    checked_virtual_coupling,
    modulate,
    modulation_bound,
    unseen_place,
    virtual_coupling_limit,
)
from cotouch.coupling._pspm import PSPM_COUPLING
from cotouch.coupling._rest import REST_DRIFT, REST_FIELDS, place_at_rest, rest_fraction
from cotouch.coupling._toll import checked_toll, encoder_toll, opening_energy
from cotouch.coupling._virtual import VIRTUAL_COUPLING

__all__ = [
    "END",
    "NAME_BYTES",
    "PSPM_COUPLING",
    "REST_DRIFT",
    "REST_FIELDS",
    "VIRTUAL_COUPLING",
    "DeviceCoupling",
    "EndFields",
    "EnergyMessage",
    "HeldForce",
    "available_energy",
    "book_end",
    "checked_toll",
    "checked_virtual_coupling",
    "conform_coupling",
    "coupling_at",
    "device_couplings",
    "discard",
    "encoder_toll",
    "end_row",
    "hear",
    "hear_end",
    "hold_gap",
    "message_of",
    "modulate",
    "modulation_bound",
    "opening_energy",
    "place_at_rest",
    "pool",
    "register_coupling",
    "rest_fraction",
    "run_end",
    "share",
    "squared",
    "unheard",
    "unseen_place",
    "virtual_coupling_limit",
]
