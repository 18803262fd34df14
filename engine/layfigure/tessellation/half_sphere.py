"""The hyper-tessellated half sphere of swing half vectors, for joints with flexion and pivot (posing.md 5).

Seven levels; level n holds 2 * 4^n + 1 points, because h and -h on the equator are one rotation and one point. Points
are sorted by the coarsest level that has them, so level n is the first 2 * 4^n + 1 rows.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from itertools import islice

import numpy as np
from numpy.typing import ArrayLike, NDArray

from layfigure.kinematics.swing import DECIMALS, half_vector, swing_angles
from layfigure.tessellation.octahedron import Floats, Integers, Mesh, meshes

LEVELS = 7
_NEIGHBOURS = 13


def level_size(level: int) -> int:
    """Return the number of points of a level, 0 to :data:`LEVELS` - 1."""
    return int(2 * 4**level + 1)


@dataclass(frozen=True, eq=False)
class HalfSphere:
    """The tables, read-only. ``angles`` (n, 2) are flexion and pivot in degrees, as committed poses hold them.

    ``points`` (n, 3) are the half vectors of those angles and ``levels`` (n,) the coarsest level of each point.
    ``finer[k]`` (level_size(k), 13) are the points of level k + 1 around each point of level k: itself, the middles
    of its triangles' edges, and itself again where there are fewer than thirteen.
    """

    points: Floats
    angles: Floats
    levels: Integers
    finer: tuple[Integers, ...]

    def nearest(self, half: ArrayLike, level: int = LEVELS - 1) -> NDArray[np.int64]:
        """Return the index (...,) of the level's point nearest to unit half vectors (..., 3).

        h and -h count as one. Goes from coarse to fine: each level looks only round the point found a level before.
        """
        wanted = np.asarray(half, dtype=np.float64)
        found = np.argmax(np.abs(wanted @ self.points[: level_size(0)].T), axis=-1)
        for table in self.finer[:level]:
            around = table[found]
            likeness = np.abs(np.einsum("...kc,...c->...k", self.points[around], wanted))
            best = np.argmax(likeness, axis=-1)
            found = np.take_along_axis(around, best[..., None], axis=-1)[..., 0]
        return np.asarray(found, dtype=np.int64)


@cache
def half_sphere() -> HalfSphere:
    """Return the tables, built at the first call of a process.

    Building takes about as long as reading and checking a cached file would, so nothing is kept on disk.
    """
    levels = list(islice(meshes(), LEVELS))
    places = _places(levels[-1].points)
    kept = np.flatnonzero(_kept(levels[-1].points))
    exact = np.stack(swing_angles(levels[-1].points[kept]), axis=-1)
    angles: Floats = np.round(exact, DECIMALS) + 0.0
    tables = HalfSphere(
        points=half_vector(angles[:, 0], angles[:, 1]),
        angles=angles,
        levels=np.repeat(np.arange(LEVELS), np.diff([0, *map(level_size, range(LEVELS))])),
        finer=tuple(_finer(mesh, places) for mesh in levels[:-1]),
    )
    for table in (tables.points, tables.angles, tables.levels, *tables.finer):
        table.flags.writeable = False
    return tables


def _kept(points: Floats) -> NDArray[np.bool_]:
    """Tell which sphere points stand for a rotation: the upper half and half of the equator (posing.md 1)."""
    x, y, z = points.T
    return np.asarray((y > 0) | ((y == 0) & ((z > 0) | ((z == 0) & (x > 0)))))


def _places(points: Floats) -> Integers:
    """Return each sphere point's row (p,) in the half sphere; a dropped equator point has its antipode's, else -1."""
    kept = _kept(points)
    places = np.where(kept, np.cumsum(kept) - 1, -1)
    equator = points[:, 1] == 0
    rows = {
        tuple(point): places[row] for row, point in zip(np.flatnonzero(equator), points[equator] + 0.0, strict=True)
    }
    for row in np.flatnonzero(equator & ~kept):
        places[row] = rows[tuple(0.0 - points[row])]
    return places


def _finer(mesh: Mesh, places: Integers) -> Integers:
    """Return the table (m, 13) from a level's points to the next level's points on the triangles around them."""
    upper = (mesh.points[mesh.faces, 1] >= 0).all(axis=1)
    corners, middles = places[mesh.faces[upper]], places[mesh.midpoints[upper]]
    keys = np.unique(corners[:, :, None] * len(places) + middles[:, None, :])
    points, neighbours = keys // len(places), keys % len(places)
    starts = np.searchsorted(points, np.arange(points[-1] + 1))
    table = np.repeat(np.arange(points[-1] + 1)[:, None], _NEIGHBOURS, axis=1)
    table[points, np.arange(len(keys)) - starts[points] + 1] = neighbours
    return table
