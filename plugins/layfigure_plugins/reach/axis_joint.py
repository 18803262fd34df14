"""One joint that turns about x, y and z: turned freely, converted into its angles, and kept in its limits there.

It answers as :class:`layfigure_plugins.reach.joint.Joint` does; its canonical space is the one its angles are meant in,
and its main axis runs from the joint to the limb's end.
"""

from __future__ import annotations

import math

from layfigure.figures.figure import Limb, limits_from
from layfigure_plugins.reach.joint import UNITS, Angles, degrees
from layfigure_plugins.reach.vectors import (
    Matrix,
    Vector,
    apply,
    apply_back,
    cross,
    dot,
    length,
    product,
    quaternion_matrix,
    rotation_between,
    scale,
    subtract,
)

SWEEPS = 4
"""How often each angle in turn is set to the best there is, the others as they are, where the limits are in the way."""

_ALONG = 0.999  # the cosine from which on an axis runs along the limb
_ENOUGH = 1e-9  # the sine of an angle between directions that are one
_TURN = 360 * UNITS


class AxisJoint:
    """The angles x, y, z of one limb and how far each may turn, for a pose to start from.

    Limits reach out to where the joint starts. An angle that may turn all the way round is not held by its limits; it
    is brought back into them by whole turns when it is committed.
    """

    __slots__ = ("_along", "_bounds", "_main", "_round", "_units", "has", "swings", "twists")

    def __init__(self, limb: Limb, start: Angles) -> None:
        self.has = tuple(limb.turns(kind) for kind in limb.kinds)
        bounds = [
            limits if has else (at, at)
            for has, limits, at in zip(self.has, limits_from(limb, start), start, strict=True)
        ]
        self._units = [(math.ceil(low * UNITS - 1e-6), math.floor(high * UNITS + 1e-6)) for low, high in bounds]
        self._round = tuple(high - low >= _TURN for low, high in self._units)
        self._bounds = [(-math.inf, math.inf) if wide else pair for wide, pair in zip(self._round, bounds, strict=True)]
        self._main = _main_axis(limb)
        self._along = [d for d in range(3) if self.has[d] and abs(self._main[d]) > _ALONG]
        self.swings = sum(self.has) > len(self._along)
        self.twists = all(self.has) or bool(self._along)

    def rotation(self, angles: Angles) -> Matrix:
        """Return the rotation in canonical space; angles of degrees of freedom that are missing turn nothing."""
        x, y, z = (angle if has else 0.0 for has, angle in zip(self.has, angles, strict=True))
        return rotation((x, y, z))

    def carried(self, angles: Angles, arm: Vector) -> Vector:
        """Return where the joint at ``angles`` carries a canonical vector."""
        return apply(self.rotation(angles), arm)

    def swing(self, angles: Angles, arm: Vector, aim: Vector) -> Angles:
        """Return angles that bring ``arm``, which the joint carries, toward the direction ``aim``; both canonical."""
        here = self.rotation(angles)
        found = self._converted(product(rotation_between(apply(here, arm), aim), here), angles)
        if self._is_along(found, arm, aim):
            return found
        tried = [self._improved(found, arm, aim), self._improved(angles, arm, aim)]
        return max(tried, key=lambda at: dot(self.carried(at, arm), aim))

    def twist(self, angles: Angles, arm: Vector, aim: Vector) -> Angles:
        """Return angles whose turn about the main axis brings ``arm`` nearer to the direction ``aim``, if one does."""
        if not all(self.has):
            return self._turned(self._along[0], angles, arm, aim)
        here, m = self.rotation(angles), self._main
        seen = apply_back(here, aim)
        flat = subtract(arm, scale(m, dot(m, arm)))
        turn = math.radians(degrees(dot(m, cross(arm, seen)), dot(flat, seen), 0.0)) / 2
        s = math.sin(turn)
        found = self._converted(product(here, quaternion_matrix(math.cos(turn), s * m[0], s * m[1], s * m[2])), angles)
        return found if dot(self.carried(found, arm), aim) > dot(apply(here, arm), aim) else angles

    def between(self, start: Angles, end: Angles, share: float) -> Angles:
        """Return angles a share of the way from ``start`` to ``end``: legal in is legal out."""
        x, y, z = (a + share * (b - a) for a, b in zip(start, end, strict=True))
        return (x, y, z)

    def change(self, start: Angles, end: Angles) -> Angles:
        """Return how far each angle turns."""
        return subtract(end, start)

    def toward_middle(self, angles: Angles, share: float) -> Angles:
        """Return angles a share of the way to the middle of the limits; what turns all the way round has none."""
        x, y, z = (
            at if wide else (low + high) / 2
            for wide, (low, high), at in zip(self._round, self._bounds, angles, strict=True)
        )
        return self.between(angles, (x, y, z), share)

    def commit(self, angles: Angles, start: Angles) -> Angles:
        """Return angles as a pose holds them: rounded to 1e-6 degree, and inside the limits still."""
        del start
        x, y, z = (
            _into(round(a * UNITS), *limits, wide) / UNITS
            for a, limits, wide in zip(angles, self._units, self._round, strict=True)
        )
        return (x, y, z)

    def _is_along(self, angles: Angles, arm: Vector, aim: Vector) -> bool:
        there = self.carried(angles, arm)
        return dot(there, aim) > 0.0 and length(cross(there, aim)) <= _ENOUGH * length(arm) * length(aim)

    def _converted(self, matrix: Matrix, at: Angles) -> Angles:
        """Return the angles of a rotation that are the least outside the limits, and nearest, brought inside."""
        triples = [self._near(triple, at) for triple in _triples(matrix)]
        inside = [self._clamped(triple, at) for triple in triples]
        outside = [max(map(abs, subtract(a, b))) for a, b in zip(triples, inside, strict=True)]
        away = [max(map(abs, subtract(triple, at))) for triple in triples]
        return inside[min((0, 1), key=lambda which: (round(outside[which], 9), away[which]))]

    def _near(self, triple: Angles, at: Angles) -> Angles:
        x, y, z = (b + math.remainder(a - b, 360.0) for a, b in zip(triple, at, strict=True))
        return (x, y, z)

    def _clamped(self, triple: Angles, at: Angles) -> Angles:
        x, y, z = (
            min(max(a, low), high) if has else b
            for a, b, (low, high), has in zip(triple, at, self._bounds, self.has, strict=True)
        )
        return (x, y, z)

    def _improved(self, angles: Angles, arm: Vector, aim: Vector) -> Angles:
        """Return angles after every one in turn was set to the best; coordinate ascent, which no limit can stop."""
        for _ in range(SWEEPS):
            before = angles
            for d in range(3):
                if self.has[d]:
                    angles = self._turned(d, angles, arm, aim)
            if max(map(abs, subtract(angles, before))) < 1e-3:
                break
        return angles

    def _turned(self, d: int, angles: Angles, arm: Vector, aim: Vector) -> Angles:
        """Return angles with the angle ``d`` alone set to where ``arm`` comes nearest to ``aim``, as a hinge does."""
        effective = tuple(angle if has else 0.0 for has, angle in zip(self.has, angles, strict=True))
        inner, outer = [0.0] * 3, [0.0] * 3
        inner[d + 1 :], outer[:d] = effective[d + 1 :], effective[:d]
        w = apply(rotation((inner[0], inner[1], inner[2])), arm)
        u = apply_back(rotation((outer[0], outer[1], outer[2])), aim)
        p, q = (d + 1) % 3, (d + 2) % 3
        ideal = degrees(w[p] * u[q] - w[q] * u[p], w[p] * u[p] + w[q] * u[q], angles[d])
        low, high = self._bounds[d]
        answer = list(angles)
        answer[d] = min(max(angles[d] + math.remainder(ideal - angles[d], 360.0), low), high)
        return (answer[0], answer[1], answer[2])


def rotation(angles: Angles) -> Matrix:
    """Return Rx Ry Rz for x, y, z in degrees, x outermost, as :func:`layfigure.kinematics.joints.about_axes` does."""
    (cx, sx), (cy, sy), (cz, sz) = ((math.cos(a), math.sin(a)) for a in map(math.radians, angles))
    return (
        *(cy * cz, -cy * sz, sy),
        *(cx * sz + sx * sy * cz, cx * cz - sx * sy * sz, -sx * cy),
        *(sx * sz - cx * sy * cz, sx * cz + cx * sy * sz, cx * cy),
    )


def _triples(m: Matrix) -> tuple[Angles, Angles]:
    """Return both triples x, y, z in degrees that a rotation has, up to whole turns."""
    level = math.hypot(m[0], m[1])
    y = math.degrees(math.atan2(m[2], level))
    if level < 1e-9:  # x and z turn about one line
        return ((math.degrees(math.atan2(m[7], m[4])), y, 0.0),) * 2
    x, z = math.degrees(math.atan2(-m[5], m[8])), math.degrees(math.atan2(-m[1], m[0]))
    return (x, y, z), (x + 180.0, 180.0 - y, z + 180.0)


def _main_axis(limb: Limb) -> Vector:
    """Return the unit direction from joint to end as the joint's angles see it; +y where the limb has no length."""
    (a, b, c), (d, e, f), (g, h, i) = limb.frame
    end = apply_back((a, b, c, d, e, f, g, h, i), limb.end)
    size = length(end)
    return scale(end, 1.0 / size) if size > 0.0 else (0.0, 1.0, 0.0)


def _into(units: int, low: int, high: int, wide: bool) -> int:
    """Return a whole number of units inside limits, by whole turns where they are wide enough for one."""
    if wide and units > high:
        units -= -(-(units - high) // _TURN) * _TURN
    elif wide and units < low:
        units += -(-(low - units) // _TURN) * _TURN
    return min(max(units, low), high)
