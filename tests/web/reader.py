"""The protocol read and written once more, byte by byte from its description in docs/page.md."""

import base64
import struct
from dataclasses import dataclass, field

import numpy as np

MODES = ("script", "free", "hold", "pull", "wander", "grab", "ball", "blade", "cut")


@dataclass
class Drawn:
    slot: int
    mode: str
    direct: bool
    has_hand: bool
    hands: int
    age: float
    target: tuple[float, ...]
    place: tuple[float, ...]
    force: tuple[float, ...]
    radius: float
    ledger: tuple[float, ...]  # energy, supplied, lost, linked
    node: int
    edge: tuple[float, ...]
    displacement: np.ndarray


@dataclass
class Picture:
    number: int
    time: float
    points: int
    scale: float
    echo: int
    waited_us: int
    copies: dict[int, Drawn] = field(default_factory=dict)


def u32(data: bytes, at: int) -> int:
    return int.from_bytes(data[at : at + 4], "little")


def f32(data: bytes, at: int, count: int = 1) -> tuple[float, ...]:
    return tuple(np.frombuffer(data, "<f4", count, at).tolist())


def read_frame(data: bytes) -> Picture:
    assert data[0] == 1
    assert data[1] == 3
    count = int.from_bytes(data[2:4], "little")
    picture = Picture(
        number=u32(data, 4),
        time=float(np.frombuffer(data, "<f8", 1, 8)[0]),
        points=u32(data, 16),
        scale=f32(data, 20)[0],
        echo=u32(data, 24),
        waited_us=u32(data, 28),
    )
    at = 32
    for _ in range(count):
        size = 6 * picture.points
        values = np.frombuffer(data, "<i2", 3 * picture.points, at + 80).astype(float)
        copy = Drawn(
            slot=data[at],
            mode=MODES[data[at + 1]],
            direct=bool(data[at + 2] & 1),
            has_hand=bool(data[at + 2] & 2),
            hands=data[at + 3],
            age=f32(data, at + 4)[0],
            target=f32(data, at + 8, 3),
            place=f32(data, at + 20, 3),
            force=f32(data, at + 32, 3),
            radius=f32(data, at + 44)[0],
            ledger=f32(data, at + 48, 4),
            node=int.from_bytes(data[at + 64 : at + 68], "little", signed=True),
            edge=f32(data, at + 68, 3),
            displacement=values.reshape(-1, 3) * picture.scale,
        )
        assert copy.slot not in picture.copies
        picture.copies[copy.slot] = copy
        at += 80 + size + (-size) % 4
    assert at == len(data)
    return picture


def pointer(
    number: int,
    *,
    slot: int = 0,
    action: int = 1,
    point: int = 0,
    target: tuple[float, float, float] = (0.0, 0.0, 0.0),
    radius: float = 0.0,
    stiffness: float = 0.0,
    sent: float = 0.0,
    edge: tuple[float, float, float] = (0.0, 0.0, 0.0),
) -> bytes:
    return (
        bytes([2, slot, action, 0])
        + struct.pack("<I", number)
        + struct.pack("<I", point)
        + np.array(target, "<f4").tobytes()
        + np.array([radius, stiffness], "<f4").tobytes()
        + np.array([sent], "<f8").tobytes()
        + np.array(edge, "<f4").tobytes()
    )


def ack(number: int, wait: float = 0.0, every: float = 0.0) -> bytes:
    return bytes([3, 0, 0, 0]) + number.to_bytes(4, "little") + np.array([wait, every], "<f4").tobytes()


def packed(text: str, kind: str, width: int) -> np.ndarray:
    return np.frombuffer(base64.b64decode(text), kind).reshape(-1, width)
