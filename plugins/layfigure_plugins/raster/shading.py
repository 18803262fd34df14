"""Light and colour: where the light stands in each view, and the 64 shades of every colour in every style."""

from __future__ import annotations

from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from layfigure.drawing.render_list import Look, RenderList, Style
from layfigure.errors import LayfigureError

Floats = NDArray[np.float64]

SHADES = 64
RAMPS = 256  # what the 8 bits of a key can tell apart
TO_LIGHT = np.array([-0.62, -0.60, -0.50])  # x right, y down, z away: over the viewer's left shoulder
SKY_SHARE = 0.28  # of the hemisphere's up against the lamp
ACCENT = np.array([96.0, 178.0, 255.0])  # what a selected limb is tinted with
_WARM, _COOL = np.array([1.02, 1.0, 0.965]), np.array([0.93, 0.98, 1.1])
_GREY = np.array([0.2126, 0.7152, 0.0722])  # luminance, ITU-R BT.709


class Shading(NamedTuple):
    """``codes`` (k,) uint8 names each primitive's ramp; view v looks it up in ``tables[table_of_view[v]]``.

    ``lights`` is (m, 4), see :func:`light_vectors`.
    """

    codes: NDArray[np.uint8]
    lights: NDArray[np.float32]
    tables: NDArray[np.uint32]  # (t, RAMPS * SHADES)
    table_of_view: NDArray[np.int64]


def light_vectors(rotations: NDArray[np.float32], look: Look) -> NDArray[np.float32]:
    """Return (m, 4) lights in pixel space: shade 0..64 = N . light[:3] + light[3] for an outward unit normal N.

    The lamp hangs over the viewer's shoulder, so every view is lit well. Plain shading is Lambert's law, cut at 0.
    With a hemisphere, ``a N.L + b N.up`` is still one dot product, and half-Lambert (0.5 + 0.5 of it) leaves no part
    flat (rasterizers.md 3).
    """
    lamp = TO_LIGHT / np.linalg.norm(TO_LIGHT)
    lights = np.empty((len(rotations), 4))
    if not look.hemisphere:
        lights[:, :3], lights[:, 3] = lamp * SHADES, 0.0
        return lights.astype(np.float32)
    sky = rotations[:, :, 1] * np.array([1.0, -1.0, 1.0])
    mixed = (1 - SKY_SHARE) * lamp + SKY_SHARE * sky
    lights[:, :3] = mixed * (SHADES / 2 / np.linalg.norm(mixed, axis=1))[:, None]
    lights[:, 3] = SHADES / 2
    return lights.astype(np.float32)


def shade(render_list: RenderList, look: Look) -> Shading:
    """Return which ramp each primitive has, the ramps, and the lights.

    Raises:
        LayfigureError: there are more combinations of colour and style than a key can tell apart.
    """
    colours = len(render_list.palette)
    pairs = render_list.styles.astype(np.int64) * colours + render_list.colours
    if len(Style) * colours <= RAMPS:
        used, codes = np.arange(len(Style) * colours), pairs
    else:
        used, codes = np.unique(pairs, return_inverse=True)
    if len(used) > RAMPS:
        raise LayfigureError(f"the picture has {len(used)} colours and highlights; use at most {RAMPS} in one figure")
    backgrounds, table_of_view = _distinct_rows(render_list.backgrounds)
    tables = _tables(render_list.palette.tobytes(), used.tobytes(), backgrounds, look.hemisphere)
    lights = light_vectors(render_list.rotations, look)
    return Shading(codes.astype(np.uint8), lights, tables, table_of_view)


def _distinct_rows(backgrounds: NDArray[np.uint8]) -> tuple[bytes, NDArray[np.int64]]:
    """Return the distinct (3,) rows as bytes and which of them each row is; most pages have just one."""
    if (backgrounds == backgrounds[:1]).all():
        return backgrounds[:1].tobytes(), np.zeros(len(backgrounds), dtype=np.int64)
    distinct, which = np.unique(backgrounds, axis=0, return_inverse=True)
    return distinct.tobytes(), which.reshape(-1).astype(np.int64)


@lru_cache(maxsize=16)
def _tables(palette: bytes, used: bytes, backgrounds: bytes, hemisphere: bool) -> NDArray[np.uint32]:
    """Return (t, RAMPS * SHADES) packed colours for style * colours + colour pairs in ``used``, one per background."""
    base = np.frombuffer(palette, dtype=np.uint8).reshape(-1, 3).astype(np.float64)
    styles, colours = np.divmod(np.frombuffer(used, dtype=np.int64), len(base))
    normal = ramps(base, hemisphere)
    behind = np.frombuffer(backgrounds, dtype=np.uint8).reshape(-1, 3).astype(np.float64)
    tables = np.zeros((len(behind), RAMPS, SHADES), dtype=np.uint32)
    for table, background in zip(tables, behind, strict=True):
        for ramp, (style, colour) in enumerate(zip(styles, colours, strict=True)):
            table[ramp] = pack(styled(normal[colour], Style(style), background))
    packed = tables.reshape(len(behind), -1)
    packed.flags.writeable = False
    return packed


def ramps(base: Floats, hemisphere: bool) -> Floats:
    """Return (c, SHADES, 3) shades 0..255 of base colours (c, 3), dark to light; hues stay, lightness moves a quarter.

    Light multiplies linear intensities. Under a hemisphere the dark end is cool, the light end warm, and the last few
    shades take a soft highlight.
    """
    level = (np.arange(SHADES) + 0.5) / SHADES
    if hemisphere:
        strength = 0.24 + 1.02 * level**1.5
        tint = _COOL + (_WARM - _COOL) * level[:, None]
        highlight = 0.16 * np.clip((level - 0.86) / 0.14, 0, 1) ** 2
    else:
        strength, tint, highlight = 0.40 + 0.68 * level, np.ones((SHADES, 3)), np.zeros(SHADES)
    lit = _to_linear(base)[:, None] * (strength[:, None] * tint) + highlight[:, None]
    return _from_linear(lit)


def styled(ramp: Floats, style: Style, background: Floats) -> Floats:
    """Return a (SHADES, 3) ramp as the style shows it over a background (3,)."""
    edge = (1 - (np.arange(SHADES) + 0.5) / SHADES)[:, None] ** 2.5  # faces that turn away: a rim of light
    if style is Style.HOVER:
        return _mix(ramp, np.full(3, 255.0), 0.26 + 0.42 * edge)
    if style is Style.SELECTED:
        return _mix(_mix(ramp, ACCENT, 0.5), np.array([190.0, 228.0, 255.0]), 0.55 * edge)
    if style in {Style.DIM, Style.STICK}:
        grey = (ramp @ _GREY)[:, None]
        faded = _mix(ramp, grey, 0.6)
        return _mix(faded, background, 0.5 if style is Style.DIM else 0.72)
    return ramp


def pack(colours: Floats) -> NDArray[np.uint32]:
    """Return 0x00RRGGBB of colours (..., 3) in 0..255."""
    rgb = np.clip(np.rint(colours), 0, 255).astype(np.uint32)
    return np.asarray(rgb[..., 0] << 16 | rgb[..., 1] << 8 | rgb[..., 2], dtype=np.uint32)


def _mix(colours: Floats, other: Floats, share: float | Floats) -> Floats:
    return colours + (other - colours) * share


def _to_linear(colours: Floats) -> Floats:
    """Return linear intensities 0..1 of sRGB values 0..255 (IEC 61966-2-1)."""
    value = colours / 255.0
    return np.where(value <= 0.04045, value / 12.92, ((value + 0.055) / 1.055) ** 2.4)


def _from_linear(intensities: Floats) -> Floats:
    """Return sRGB values 0..255 of linear intensities, cut to 0..1 (IEC 61966-2-1)."""
    value = np.clip(intensities, 0.0, 1.0)
    return 255.0 * np.where(value <= 0.0031308, value * 12.92, 1.055 * value ** (1 / 2.4) - 0.055)
