"""The tables of what a skin feels like besides its stiffness: what draws tools to it, and a relief on it."""

from collections.abc import Callable
from io import BytesIO
from pathlib import Path
from typing import Annotated, Literal, Self, final

import numpy as np
from pydantic import Field, FiniteFloat, model_validator

from cotouch.arrays import Float
from cotouch.errors import BodyError, ScenarioError
from cotouch.files import read_bytes
from cotouch.mechanics import Relief, Surface, relief_on
from cotouch.scenario._drawn_texture import WAVE, DrawnTexture, coarser, sides
from cotouch.scenario._tables import NonNegative, Positive, Table

# A range in radii of a tool: a shorter one drowns in rounding, and beyond a longer one a flat does not draw as is said.
_SHORTEST, _LONGEST = 0.05, 1.0
# A relief's height in radii of a tool, at most.
_HIGHEST = 0.25
# Points in a wavelength, and in a tool's radius, and of all of a skin at most.
_EACH, _OF_RADIUS, _MOST_POINTS = 8.0, 8.0, 2_000_000
# Of a picture: bytes, and pixels along a side.
_MOST_BYTES, _MOST_PIXELS = 16 << 20, 2048
# How sharply a projection gives way to the next where the skin turns from one to the other.
_SHARP = 4
# Axes that lie along a map, by that which it is seen along.
_AXES = {"x": (1, 2), "y": (0, 2), "z": (0, 1)}


@final
class SnapTable(Table):
    """That the skin draws tools to itself.

    Attributes:
        force: greatest that a flat draws a ball with: what it takes to pull it off [N].
        range: how far from the tool's surface it does [m].
    """

    force: Positive
    range: Positive

    def refuse(self, radius: float, where: str) -> None:
        """Refuses a tool that the range does not suit.

        Args:
            radius: of the tool [m].
            where: the tool's name in the file.

        Raises:
            ValueError: it does not.
        """
        if not _SHORTEST * radius <= self.range <= _LONGEST * radius:
            raise ValueError(
                f"contact.snap.range is {self.range:g} m, but {where}.radius is {radius:g} m; it must be between "
                f"{_SHORTEST * radius:g} and {_LONGEST * radius:g} m"
            )


@final
class TextureTable(Table):
    """A relief that stands on the skin: one of `pattern`, `heights`, `file`.

    Attributes:
        pattern: "ridges" (waves along one direction) or "bumps" (along two).
        wavelength: of a pattern [m].
        heights: of a map that repeats, rows along its second side [m].
        file: a PNG in their stead, relative to the scenario; black is 0, white is `height`.
        size: of the two sides of the map [m].
        height: greatest, of a pattern or a picture [m].
        angle: by which pattern or map is turned in its plane [rad].
        projection: axis along which it is laid on the skin at rest, or "triplanar": along that which the skin looks to,
            with a gradual change between them.
    """

    pattern: Literal["ridges", "bumps"] | None = None
    wavelength: Positive | None = None
    heights: Annotated[list[Annotated[list[NonNegative], Field(min_length=1)]], Field(min_length=1)] | None = None
    file: str | None = None
    size: Annotated[list[Positive], Field(min_length=2, max_length=2)] | None = None
    height: Positive | None = None
    angle: FiniteFloat = 0.0
    projection: Literal["triplanar", "x", "y", "z"] = "triplanar"

    @model_validator(mode="after")
    def _after(self) -> Self:
        given = [name for name in ("pattern", "heights", "file") if getattr(self, name) is not None]
        if len(given) != 1:
            what = f"{' and '.join(given)} are given" if given else "none is given"
            raise ValueError(f"a texture needs exactly one of pattern, heights and file, but {what}")
        needs = {"pattern": ("wavelength", "height"), "heights": ("size",), "file": ("size", "height")}[given[0]]
        for name in ("wavelength", "size", "height"):
            if (getattr(self, name) is None) == (name in needs):
                raise ValueError(
                    f"{name} is missing; a texture with {given[0]} needs it"
                    if name in needs
                    else f"{name} is {getattr(self, name)}, but a texture with {given[0]} has none; leave it out"
                )
        if self.heights is not None and len({len(row) for row in self.heights}) > 1:
            raise ValueError(
                f"heights has rows of {sorted({len(row) for row in self.heights})} numbers; all must agree"
            )
        return self

    def top(self) -> float:
        """The greatest height [m]."""
        return max(max(row) for row in self.heights) if self.heights is not None else self.height or 0.0

    def refuse(self, radius: float, where: str) -> None:
        """Refuses a tool that it is too high for.

        Args:
            radius: of the tool [m].
            where: the tool's name in the file.

        Raises:
            ValueError: it is.
        """
        if self.top() > _HIGHEST * radius:
            raise ValueError(
                f"contact.texture is {self.top():g} m high, but {where}.radius is {radius:g} m; it must be at most "
                f"{_HIGHEST * radius:g} m, a quarter of that"
            )

    def relief(self, surface: Surface, radius: float) -> Relief:
        """The relief on a skin.

        Args:
            surface: the skin.
            radius: of the smallest tool that touches it [m].

        Raises:
            ScenarioError: the picture cannot be read, or the skin is too large for so fine a relief.
        """
        try:
            return relief_on(
                surface.rest[:, :3],
                surface.corner,
                self.profile(),
                spacing=min(self._finest(), radius / _OF_RADIUS),
                most=_MOST_POINTS,
                smooth=surface.tools(),
            )
        except BodyError as error:
            waves = "waves of at least eight times that" if self._map() is None else "pixels of at least that size"
            raise ScenarioError(
                f"contact.texture: {error}; give it {waves} and tools a radius of at least eight times that, or "
                "make the body smaller"
            ) from None

    def profile(self) -> Callable[[Float, Float], Float]:
        """A function of places, (P, 3) [m], and of where the skin looks to there, (P, 3): heights, (P,) [m].

        Raises:
            ScenarioError: the picture cannot be read.
        """
        heights = self._map()
        return lambda at, normal: self._height(heights, at, normal)

    def drawn(self) -> DrawnTexture | None:
        """One tile of it, for a page; None: it is flat.

        Raises:
            ScenarioError: the picture cannot be read.
        """
        if not self.top() > 0.0:
            return None
        heights = self._map()
        if heights is None:
            across = along = self.wavelength or 1.0
            rows, columns = (1 if self.pattern == "ridges" else WAVE), WAVE
        else:
            heights, (across, along) = coarser(heights), self.size or (1.0, 1.0)
            rows, columns = sides(heights)
        u, v = (np.arange(columns) + 0.5) / columns * across, (np.arange(rows) + 0.5) / rows * along
        every = self._laid(heights, *(grid.ravel() for grid in np.meshgrid(u, v)))
        return DrawnTexture(
            heights=every.reshape(rows, columns),
            size=(across, along),
            top=self.top(),
            angle=self.angle,
            projection=self.projection,
        )

    def _map(self) -> Float | None:
        """Heights of the map, rows along its second side [m]; None: it is a pattern."""
        if self.heights is not None:
            return np.array(self.heights)
        return None if self.file is None else (self.height or 0.0) * _picture(Path(self.file))

    def _finest(self) -> float:
        """How far apart points may be [m]."""
        heights = self._map()
        if heights is None:
            return (self.wavelength or 0.0) / _EACH
        across, along = self.size or (0.0, 0.0)
        return min(across / heights.shape[1], along / heights.shape[0])

    def _height(self, heights: Float | None, at: Float, normal: Float) -> Float:
        """At places, (P, 3) [m], where the skin looks to, (P, 3): (P,) [m]."""
        if self.projection != "triplanar":
            return self._flat(heights, at, self.projection)
        share = np.abs(normal) ** _SHARP
        share /= np.maximum(share.sum(axis=1, keepdims=True), np.finfo(np.float64).tiny)
        return sum((share[:, a] * self._flat(heights, at, axis) for a, axis in enumerate(_AXES)), np.zeros(len(at)))

    def _flat(self, heights: Float | None, at: Float, axis: str) -> Float:
        """Seen along one axis."""
        first, second = (at[:, a] for a in _AXES[axis])
        u = np.cos(self.angle) * first + np.sin(self.angle) * second
        v = np.cos(self.angle) * second - np.sin(self.angle) * first
        return self._laid(heights, u, v)

    def _laid(self, heights: Float | None, u: Float, v: Float) -> Float:
        """Along the sides of the map."""
        if heights is None:
            wave, half = 2.0 * np.pi / (self.wavelength or 1.0), 0.5 * self.top()
            ridges = half * (1.0 + np.sin(wave * u))
            return ridges if self.pattern == "ridges" else 0.5 * ridges * (1.0 + np.sin(wave * v))
        from scipy.ndimage import map_coordinates

        across, along = self.size or (1.0, 1.0)
        where = [v / along * heights.shape[0] - 0.5, u / across * heights.shape[1] - 0.5]
        found = map_coordinates(heights, where, order=3, mode="grid-wrap")
        return np.clip(found, 0.0, self.top())


def _picture(path: Path) -> Float:
    """Brightness of a PNG, 0 to 1, (rows, columns).

    Raises:
        ScenarioError: it is none, or too large.
    """
    from matplotlib.image import imread

    data = read_bytes(path, "texture", ScenarioError, _MOST_BYTES)
    sides = [int.from_bytes(data[k : k + 4], "big") for k in (16, 20)]
    if not data.startswith(b"\x89PNG\r\n\x1a\n"):
        raise ScenarioError(f"the texture {path} is not a PNG; save it as one")
    if max(sides) > _MOST_PIXELS:
        raise ScenarioError(
            f"the texture {path} has {sides[0]} × {sides[1]} pixels; at most {_MOST_PIXELS} along each side are read"
        )
    try:
        pixels = np.asarray(imread(BytesIO(data), format="png"), dtype=np.float64)
    except (OSError, SyntaxError, ValueError, EOFError):
        raise ScenarioError(f"the texture {path} is a broken PNG; save it again") from None
    if pixels.ndim == 3:  # without an opacity
        pixels = pixels[:, :, : 1 if pixels.shape[2] < 3 else 3].mean(axis=2)
    return pixels
