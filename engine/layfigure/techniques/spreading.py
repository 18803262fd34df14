"""Candidates that look different: farthest-point sampling of what is seen of them."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


def far_apart(points: Floats, taken: Floats, most: int, least: float) -> list[int]:
    """Return up to ``most`` rows of ``points`` (k, m), each the farthest from ``taken`` (t, m) and the rows before it.

    Gonzalez (1985). Stops where the farthest is nearer than ``least`` to what is taken. The first of equals is taken;
    distances within a millionth of a unit are equal. The rows are returned in rising order.
    """
    nearest = np.full(len(points), np.inf)
    for row in taken:
        nearest = np.minimum(nearest, np.linalg.norm(points - row, axis=1))
    chosen: list[int] = []
    while len(chosen) < min(most, len(points)):
        farthest = int(np.round(nearest, 6).argmax())
        if nearest[farthest] < least:
            break
        chosen.append(farthest)
        nearest = np.minimum(nearest, np.linalg.norm(points - points[farthest], axis=1))
        nearest[farthest] = -1.0
    return sorted(chosen)
