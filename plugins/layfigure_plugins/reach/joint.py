"""One joint: turns toward a direction as far as its limits allow, in canonical joint space (posing.md 1)."""

from __future__ import annotations

import math

from layfigure.figures.definition import DOF_KINDS
from layfigure.figures.figure import Limb, limb_limits, limits_from
from layfigure_plugins.reach.vectors import Matrix, Vector, apply, cross, dot, quaternion_matrix

Angles = tuple[float, float, float]
"""Flexion, pivot, twist in degrees."""

UNITS = 10**6
"""Committed angles are whole numbers of these per degree."""

_STRAIGHT = 180 * UNITS
_POLE = 1e-6  # nearer than this to straight back the half vector keeps its horizontal direction


class Joint:
    """The degrees of freedom of one limb and how far each may turn, for a pose to start from.

    Limits reach out to where the joint starts: one that is outside may come nearer but go no farther out.
    """

    __slots__ = ("_bounds", "_units", "has", "swings", "twists")

    def __init__(self, limb: Limb, start: Angles) -> None:
        self.has = tuple(limb.turns(kind) for kind in DOF_KINDS)
        self.swings, self.twists = self.has[0] or self.has[1], self.has[2]
        room = 180.0 - sum(abs(at) for has, at in zip(self.has[:2], start, strict=False) if not has)
        self._bounds = tuple(
            (max(low, -room), min(high, room)) if has else (at, at)
            for has, (low, high), at in zip(self.has, limits_from(limb, start), start, strict=True)
        )
        self._units = tuple(
            (math.ceil(low * UNITS - 1e-6), math.floor(high * UNITS + 1e-6)) for low, high in self._bounds
        )

    def rotation(self, angles: Angles) -> Matrix:
        """Return the rotation in canonical space; angles of degrees of freedom that are missing turn nothing."""
        flexion, pivot, twist = self.has
        return rotation((angles[0] if flexion else 0.0, angles[1] if pivot else 0.0, angles[2] if twist else 0.0))

    def swing(self, angles: Angles, arm: Vector, aim: Vector) -> Angles:
        """Return angles whose swing brings ``arm``, which the joint carries, toward the direction ``aim``.

        Both are canonical. The twist stays. A lone flexion or pivot turns as a hinge does.
        """
        flexion, pivot, twist = angles
        w = _twisted(arm, twist if self.twists else 0.0)
        if self.has[0] and self.has[1]:
            return (*self._swing_both((flexion, pivot), _unit(w), _unit(aim)), twist)
        if self.has[0]:
            ideal = degrees(w[1] * aim[0] - w[0] * aim[1], w[0] * aim[0] + w[1] * aim[1], flexion)
            return (self._nearest(0, ideal, flexion), pivot, twist)
        ideal = degrees(w[1] * aim[2] - w[2] * aim[1], w[1] * aim[1] + w[2] * aim[2], pivot)
        return (flexion, self._nearest(1, ideal, pivot), twist)

    def twist(self, angles: Angles, arm: Vector, aim: Vector) -> Angles:
        """Return angles whose twist brings ``arm`` as near to the direction ``aim`` as it can; the swing stays."""
        flexion, pivot, twist = angles
        swung = self.rotation((flexion, pivot, 0.0))
        x, z = _column(swung, 0, aim), _column(swung, 2, aim)
        ideal = degrees(arm[2] * x - arm[0] * z, arm[0] * x + arm[2] * z, twist)
        return (flexion, pivot, self._nearest(2, ideal, twist))

    def _nearest(self, kind: int, ideal: float, at: float) -> float:
        """Return the allowed angle next to ``ideal``, counted on from where the joint is, so that it never wraps."""
        if self._wraps(kind):
            return ideal
        low, high = self._bounds[kind]
        ideal = at + math.remainder(ideal - at, 360.0)
        return min(max(ideal, low), high)

    def _swing_both(self, at: tuple[float, float], w: Vector, u: Vector) -> tuple[float, float]:
        """Return (flexion, pivot) of the swing that takes the unit vector w nearest to u.

        A swing turns about an axis in the plane y = 0. Of the rotations from w to u exactly one does, and its half
        vector lies along (u.x - w.x, u.y + w.y, u.z - w.z); for w = A = (0, 1, 0) that is the thesis's A + D.
        """
        x, y, z = u[0] - w[0], u[1] + w[1], u[2] - w[2]
        if math.hypot(x, y, z) < _POLE:
            x, y, z = _kept_at_the_pole(half_vector(*at), w)
        if y < 0.0:
            x, y, z = -x, -y, -z
        found = self._inside(*_swing_angles(x, y, z))
        if found == _swing_angles(x, y, z):
            return found
        # A limit was in the way. The same rotation seen from beyond the equator may be nearer to what is allowed.
        tried = [found, self._inside(*_swing_angles(-x, 0.0, -z))]
        tried += [self._slid(swing, w, u) for swing in tried]
        return max(tried, key=lambda swing: dot(self.carried((*swing, 0.0), w), u))

    def _slid(self, swing: tuple[float, float], w: Vector, u: Vector) -> tuple[float, float]:
        """Return (flexion, pivot) slid along the limit it stands at, to where w comes nearest to u."""
        flexion, pivot = swing
        if flexion in self._bounds[0]:
            return self._inside(flexion, _best_across(flexion, pivot, w, u))
        # Exchanging x and z exchanges flexion and pivot.
        return self._inside(_best_across(pivot, flexion, w[::-1], u[::-1]), pivot)

    def between(self, start: Angles, end: Angles, share: float) -> Angles:
        """Return angles a share of the way from ``start`` to ``end``: legal in is legal out (posing.md 1)."""
        moved = [at + share * change for at, change in zip(start, self.change(start, end), strict=True)]
        return (moved[0], moved[1], math.remainder(moved[2], 360.0) if self._wraps(2) else moved[2])

    def change(self, start: Angles, end: Angles) -> Angles:
        """Return how far each angle turns; a twist that goes all the way round turns by the shorter way."""
        flexion, pivot, twist = (b - a for a, b in zip(start, end, strict=True))
        return (flexion, pivot, math.remainder(twist, 360.0) if self._wraps(2) else twist)

    def _wraps(self, kind: int) -> bool:
        low, high = self._bounds[kind]
        return high - low >= 360.0

    def toward_middle(self, angles: Angles, share: float) -> Angles:
        """Return angles a share of the way to the middle of the limits."""
        flexion, pivot, twist = ((low + high) / 2 for low, high in self._bounds)
        return self.between(angles, (flexion, pivot, twist), share)

    def carried(self, angles: Angles, arm: Vector) -> Vector:
        """Return where the joint at ``angles`` carries a canonical vector."""
        return apply(self.rotation(angles), arm)

    def _inside(self, flexion: float, pivot: float) -> tuple[float, float]:
        """Return (flexion, pivot) within the limits and the domain |flexion| + |pivot| <= 180."""
        (low, high), (lower, higher) = self._bounds[:2]
        flexion, pivot = min(max(flexion, low), high), min(max(pivot, lower), higher)
        total = abs(flexion) + abs(pivot)
        if total > 180.0:
            flexion = min(max(flexion * 180.0 / total, low), high)
            room = 180.0 - abs(flexion)
            pivot = min(max(pivot, -room, lower), room, higher)
        return flexion, pivot

    def commit(self, angles: Angles, start: Angles) -> Angles:
        """Return angles as a pose holds them: rounded to 1e-6 degree, and inside the limits still.

        On the equator, where a pose turns the half vector over, one unit is kept away where that would break a limit.
        """
        units = [min(max(round(a * UNITS), low), high) for a, (low, high) in zip(angles, self._units, strict=True)]
        if units[2] == -_STRAIGHT:
            units[2] = _STRAIGHT if self._units[2][1] >= _STRAIGHT else 1 - _STRAIGHT
        excess = abs(units[0]) + abs(units[1]) - _STRAIGHT
        if excess == 0 and not self._turns_over(units):
            excess = 1
        if excess > 0 and not self._shrink(units, excess):
            return start
        return (units[0] / UNITS, units[1] / UNITS, units[2] / UNITS)

    def _turns_over(self, units: list[int]) -> bool:
        """Whether a swing on the equator may be held as its twin, if a pose will do so."""
        if units[1] > 0 or (units[1] == 0 and units[0] > 0):
            return True
        return all(low <= -unit <= high for unit, (low, high) in zip(units[:2], self._units[:2], strict=True))

    def _shrink(self, units: list[int], excess: int) -> bool:
        """Take ``excess`` off the larger swing angle, or the other where a limit forbids; whether one could."""
        for kind in (0, 1) if abs(units[0]) >= abs(units[1]) else (1, 0):
            smaller = units[kind] - int(math.copysign(excess, units[kind]))
            if abs(units[kind]) >= excess and self._units[kind][0] <= smaller <= self._units[kind][1]:
                units[kind] = smaller
                return True
        return False


def inner_twin(limb: Limb, angles: Angles) -> Angles:
    """Return a joint's angles, on the equator as the twin that lies inside the limits where only that one does."""
    flexion, pivot, twist = angles
    if abs(flexion) + abs(pivot) != 180.0 or limb.index == 0 or limb.euler:
        return angles
    limits = limb_limits(limb)[:2]
    twin = (0.0 - flexion, 0.0 - pivot)
    inside = [all(lo <= a <= hi for a, (lo, hi) in zip(at, limits, strict=True)) for at in ((flexion, pivot), twin)]
    return (*twin, twist) if inside == [False, True] else angles


def rotation(angles: Angles) -> Matrix:
    """Return the rotation in canonical space: twist about the rest axis, then swing (posing.md 1)."""
    x, y, z = half_vector(angles[0], angles[1])
    turn = math.radians(angles[2]) / 2
    c, s = math.cos(turn), math.sin(turn)
    return quaternion_matrix(y * c, z * c + x * s, y * s, z * s - x * c)


def half_vector(flexion: float, pivot: float) -> Vector:
    """Return the unit half vector of flexion and pivot in degrees, the sum of whose sizes is at most 180.

    As :func:`layfigure.kinematics.swing.half_vector`, for one joint.
    """
    plus = max(180.0 - abs(flexion + pivot), 0.0)
    minus = max(180.0 - abs(flexion - pivot), 0.0)
    height = math.sqrt(math.sin(math.radians(plus) / 2) * math.sin(math.radians(minus) / 2))
    return (math.sin(math.radians(flexion) / 2), height, math.sin(math.radians(pivot) / 2))


def _best_across(flexion: float, pivot: float, w: Vector, u: Vector) -> float:
    """Return the pivot near ``pivot`` that, at a fixed flexion, swings the unit vector w nearest to u; in degrees.

    With the half vector at (sin f/2, r cos a, r sin a), u . R w is a sum of sines and cosines of a and 2 a: Newton's
    ascent finds its top.
    """
    z, r = -math.sin(math.radians(flexion) / 2), math.cos(math.radians(flexion) / 2)
    if r < _POLE:
        return pivot
    k = cross(w, u)
    c2, s2 = r * r * (dot(w, u) - w[0] * u[0]), r * r * k[0]
    c1, s1 = 2 * r * z * k[2], 2 * r * z * (w[0] * u[2] + w[2] * u[0])
    a = math.asin(min(max(math.sin(math.radians(pivot) / 2) / r, -1.0), 1.0))
    for _ in range(5):
        c, s, cc, ss = math.cos(a), math.sin(a), math.cos(2 * a), math.sin(2 * a)
        slope = 2 * (s2 * cc - c2 * ss) + s1 * c - c1 * s
        curve = abs(4 * (c2 * cc + s2 * ss) + c1 * c + s1 * s)
        if curve < _POLE * abs(slope):
            break
        a = min(max(a + min(max(slope / (curve + 1e-12), -0.3), 0.3), -math.pi / 2), math.pi / 2)
    return math.degrees(2 * math.asin(min(max(r * math.sin(a), -1.0), 1.0)))


def _swing_angles(x: float, y: float, z: float) -> tuple[float, float]:
    flexion = 2 * math.atan2(x, math.hypot(y, z))
    return math.degrees(flexion), math.degrees(2 * math.atan2(z, math.hypot(x, y)))


def _kept_at_the_pole(half: Vector, w: Vector) -> Vector:
    """Return the half vector nearest to ``half`` of the circle of those that turn w over (posing.md 1)."""
    across = (-w[0], w[1], -w[2])
    along = dot(half, across)
    x, y, z = half[0] - along * across[0], half[1] - along * across[1], half[2] - along * across[2]
    return (x, y, z) if math.hypot(x, y, z) > _POLE else (0.0, 0.0, 1.0)


def _twisted(v: Vector, twist: float) -> Vector:
    turn = math.radians(twist)
    c, s = math.cos(turn), math.sin(turn)
    return (c * v[0] + s * v[2], v[1], c * v[2] - s * v[0])


def _column(m: Matrix, column: int, v: Vector) -> float:
    return m[column] * v[0] + m[3 + column] * v[1] + m[6 + column] * v[2]


def degrees(sine: float, cosine: float, otherwise: float) -> float:
    """Return the degrees of a sine and cosine of any scale, or ``otherwise`` where there is no angle to speak of."""
    return math.degrees(math.atan2(sine, cosine)) if math.hypot(sine, cosine) > 1e-9 else otherwise


def _unit(v: Vector) -> Vector:
    size = math.hypot(*v)
    return (v[0] / size, v[1] / size, v[2] / size)
