"""The tessellated sphere: an octahedron whose triangles are split in four again and again (thesis IV.2.2.2)."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]

_VERTICES = [[0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1], [1, 0, 0], [-1, 0, 0]]
_FACES = [[pole, z, x] for pole in (0, 1) for z in (2, 3) for x in (4, 5)]


class Mesh(NamedTuple):
    """A triangulated unit sphere: ``points`` (p, 3) and ``faces`` (t, 3) of indices into them.

    ``midpoints`` (t, 3) are the indices, in the next finer mesh, of the middles of each face's edges 0-1, 1-2, 2-0.
    Points keep their index in every finer mesh.
    """

    points: Floats
    faces: Integers
    midpoints: Integers


def meshes() -> Iterator[Mesh]:
    """Yield ever finer spheres without end; mesh n has 2 + 4^(n+1) points.

    Edge middles are pushed out to the sphere. Zero coordinates stay exactly zero, and a point's mirror images differ
    from it in signs alone, to the last bit.
    """
    points, faces = np.array(_VERTICES, dtype=np.float64), np.array(_FACES)
    while True:
        edges = np.sort(np.stack([faces, np.roll(faces, -1, axis=1)], axis=-1), axis=-1).reshape(-1, 2)
        keys, places = np.unique(edges[:, 0] * len(points) + edges[:, 1], return_inverse=True)
        midpoints = len(points) + places.reshape(-1, 3)
        yield Mesh(points, faces, midpoints)
        middles = points[keys // len(points)] + points[keys % len(points)]
        middles /= np.linalg.norm(middles, axis=1, keepdims=True)
        points, faces = np.concatenate([points, middles]), _split(faces, midpoints)


def _split(faces: Integers, midpoints: Integers) -> Integers:
    """Return the four triangles (4 t, 3) of every face: one at each corner and one in the middle."""
    corners = [np.stack([faces[:, i], midpoints[:, i], midpoints[:, i - 1]], axis=1) for i in range(3)]
    return np.concatenate([*corners, midpoints])
