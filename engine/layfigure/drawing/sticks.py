"""Limbs drawn thin: their solids are exchanged for a rod along the segment and a ball at the joint."""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from layfigure.drawing.camera import framing
from layfigure.drawing.geometry import Geometry
from layfigure.drawing.render_list import RenderList
from layfigure.figures.definition import VOLUME_KINDS
from layfigure.figures.figure import Figure

_SPHERE, _CYLINDER = VOLUME_KINDS.index("sphere"), VOLUME_KINDS.index("cylinder")
ROD, BALL = 0.011, 0.022
"""Radii as shares of what a view shows from its middle to its edge."""
LEFT = 0.5  # of a broken rod's length
LEAST_ROD, LEAST_BALL = 0.55, 1.1  # pixels: thinner ones slip between the middles of pixels


def draw_thin(figure: Figure, thin: NDArray[np.bool_], kinds: NDArray[np.uint8], geometry: Geometry) -> None:
    """Exchange the solids of thin limbs, (m, n) per view and limb, in ``kinds`` (m * v,) and ``geometry``.

    A limb's first solid becomes its rod, the second its ball; further ones get no radius, which draws nothing.
    """
    limbs, rank = figure.arrays.volume_limbs, _ranks(figure)
    views, volumes = len(thin), len(limbs)
    chosen = thin[:, limbs].reshape(-1)
    ends = geometry.segments.reshape(views, -1, 2, 3)[:, limbs].reshape(-1, 2, 3)
    ranks = np.tile(rank, views)
    sizes = np.repeat(geometry.scales * np.float32(framing(figure).half_extent), volumes)
    rods, balls, others = chosen & (ranks == 0), chosen & (ranks == 1), chosen & (ranks > 1)
    kinds[rods], kinds[balls | others] = _CYLINDER, _SPHERE
    geometry.points[rods] = ends[rods][:, [0, 1, 1, 1]]
    geometry.points[balls] = ends[balls][:, [0, 0, 0, 0]]
    geometry.radii[rods], geometry.radii[balls] = sizes[rods] * np.float32(ROD), sizes[balls] * np.float32(BALL)
    geometry.radii[others] = 0


def nowhere_too_thin(listed: RenderList) -> RenderList:
    """Return a render list of limbs that are all thin, with rods a pixel wide at least, as on a terminal's few."""
    least = np.where(listed.kinds == _SPHERE, np.float32(LEAST_BALL), np.float32(LEAST_ROD))
    return replace(listed, radii=np.where(listed.radii > 0, np.maximum(listed.radii, least), np.float32(0)))


def broken(figure: Figure, listed: RenderList) -> RenderList:
    """Return a render list of a figure whose limbs are all thin, as bare rods with gaps where the joints are."""
    ranks = np.tile(_ranks(figure), len(listed.rectangles))
    radii, points = listed.radii.copy(), listed.points.copy()
    radii[ranks == 1] = 0
    points[ranks == 0] = _shortened(points[ranks == 0])
    return replace(listed, radii=radii, points=points, segments=_shortened(listed.segments))


def _shortened(points: NDArray[np.float32]) -> NDArray[np.float32]:
    """Return the middles (n, m, 3) of lines that go from the first of m points to the others."""
    middle = (points[:, :1] + points[:, 1:2]) / 2
    return np.asarray(middle + np.float32(LEFT) * (points - middle))


@lru_cache(maxsize=16)
def _ranks(figure: Figure) -> NDArray[np.int64]:
    """Return the place (v,) of each solid among those of its limb."""
    limbs = figure.arrays.volume_limbs
    return np.array([int((limbs[:place] == limb).sum()) for place, limb in enumerate(limbs)], dtype=np.int64)
