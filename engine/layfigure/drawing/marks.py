"""Marks: lines and points drawn over a view of a pose, in world units. They say things; they are not solids."""

from __future__ import annotations

from dataclasses import dataclass

Vector = tuple[float, float, float]

ROLES = ("goal", "pin", "orientation", "band", "hold", "joint", "chain", "cone", "guide")
"""What a mark is about; a front end gives each a colour and each point a shape, so that neither stands alone.

``goal`` where an end is wanted; ``pin``, ``orientation``, ``band``, ``hold``, ``joint`` the kinds of lock; ``chain``
limbs that move together; ``cone`` where alternatives lie; ``guide`` quiet help lines.
"""


@dataclass(frozen=True)
class Mark:
    """A path through world ``points`` in figure units; one point is drawn as its role's sign."""

    role: str
    points: tuple[Vector, ...]
