"""Keys led through by the shortest turn: spherical interpolation, offered by name.

It turns a joint evenly about one axis, which the default does not. But limits are not convex on rotations: between two
legal keys it can leave them, and is then clamped and reported where it is sampled.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from layfigure.figures.figure import Figure
from layfigure.kinematics.joints import about_axes, nearest_axis_angles
from layfigure.kinematics.rotation_vector import rotation_matrix, rotation_vector
from layfigure.kinematics.swing import angles_of, rotations
from layfigure.motions.baking import exact
from layfigure.motions.joints import joint_limbs
from layfigure.motions.keys import DEFAULT, Key, Span
from layfigure.motions.motion import Motion
from layfigure.motions.size import check_size

Floats = NDArray[np.float64]


def slerp(motion: Motion, figure: Figure) -> Motion:
    """Return a motion whose joints go from key to key by the shortest turn, at an even pace; keys baked, one a frame.

    Keys stay as they are. Joints that the figure does not have, and ``place``, stay as they are.

    Raises:
        LayfigureError: there would be too many keys.
    """
    known = joint_limbs(figure)
    tracks = {}
    check_size(0, motion.duration)
    for joint, spans in motion.tracks.items():
        tracks[joint] = spans
        if joint in known:
            axes, bounds = figure.limbs[known[joint].limbs[0]].euler, known[joint].bounds(figure)
            tracks[joint] = tuple(_turned(span, axes, bounds) for span in spans)
    return Motion(motion.duration, tracks, motion.marks)


def _turned(span: Span, axes: bool, bounds: Floats) -> Span:
    check_size(int(span.end - span.begin), span.end)
    keys = [span.keys[0]]
    for left, right in pairwise(span.keys):
        times = [left.time + frame for frame in range(1, int(right.time - left.time) + 1)]
        inner = [time for time in times if time < right.time]
        shares = [float((time - left.time) / (right.time - left.time)) for time in inner]
        ends = np.array([[float(value) for value in key.values] for key in (left, right)])
        values = turns_between(ends, shares, axes, bounds)
        keys += [Key(time, exact(row)) for time, row in zip(inner, values, strict=True)]
        keys.append(right._replace(how=DEFAULT))
    return Span(span.begin, span.end, tuple(keys))


def turns_between(ends: Floats, shares: Sequence[float], axes: bool, bounds: Floats) -> Floats:
    """Return a joint's angles (f, 3) at shares of the shortest turn between two triples of angles (2, 3), in degrees.

    ``axes``: the angles are x, y and z, of which those that suit ``bounds`` (3, 2) best are taken, rather than
    flexion, pivot and twist. Shoemake, "Animating rotation with quaternion curves", SIGGRAPH 1985; here by the
    rotation vector of the turn.
    """
    first, last = about_axes(ends) if axes else rotations(ends)
    turn = rotation_vector(first.T @ last)
    found, before = np.empty((len(shares), 3)), ends[0]
    for number, share in enumerate(shares):
        matrix = first @ rotation_matrix(share * turn)
        before = nearest_axis_angles(matrix, before, bounds) if axes else angles_of(matrix)
        found[number] = before
    return found
