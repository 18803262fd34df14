"""Snapping: joints turn to the points of the finest tessellation, as the thesis's program always did (V.2)."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from layfigure.kinematics.swing import half_vector
from layfigure.tessellation.half_circle import half_circle
from layfigure.tessellation.half_sphere import half_sphere

Floats = NDArray[np.float64]


def snapped(angles: Floats, has: NDArray[np.bool_]) -> Floats:
    """Return flexion, pivot, twist (3,) in degrees at the nearest points of the finest level; ``has`` (3,) says which
    of them the joint has."""
    answer = angles.copy()
    if has[0] and has[1]:
        sphere = half_sphere()
        answer[:2] = sphere.angles[sphere.nearest(half_vector(angles[0], angles[1]))]
    else:
        answer[:2] = np.where(has[:2], _on_circle(angles[:2]), angles[:2])
    if has[2]:
        answer[2] = _on_circle(angles[2:])[0]
    return answer


def snapped_about_axes(angles: Floats) -> Floats:
    """Return x, y, z (3,) in degrees at the nearest points of the finest level, in the turns they are in."""
    turns = 360.0 * np.round(angles / 360.0)
    return np.asarray(_on_circle(angles - turns) + turns)


def _on_circle(angles: Floats) -> Floats:
    circle = half_circle()
    return np.asarray(circle.angles[circle.nearest(angles)])
