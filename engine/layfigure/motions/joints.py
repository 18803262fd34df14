"""Which limbs of a figure answer to a motion's joint ids, and which of a joint's three angles each of them turns by."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray

from layfigure.figures.figure import Figure
from layfigure.kinematics.forward import turns
from layfigure.motions.keys import ROOT_JOINT

Floats = NDArray[np.float64]
_COMPONENTS = np.arange(3)


@dataclass(frozen=True, eq=False)
class JointLimbs:
    """The limbs (k,) that answer to one joint id, and which of the joint's three angles each of them owns.

    Limbs that share an id move alike, or are the parts of one joint, as of an inverted one of several axes; an angle
    is owned by the limbs that can turn by it, and by the first limb where none can, which then has the limits 0 and 0.
    """

    limbs: tuple[int, ...]
    owned: NDArray[np.bool_]  # (k, 3)

    def read(self, rows: Floats) -> Floats:
        """Return the joint's three of rows (..., n, 3) that a figure's limbs have, each from the limb that owns it."""
        owners = np.array(self.limbs)[self.owned.argmax(axis=0)]
        return np.asarray(rows[..., owners, _COMPONENTS])

    def spread(self, values: Floats) -> Floats:
        """Return what each limb turns by, (..., k, 3), of the joint's three angles (..., 3); 0 where it owns none."""
        return np.where(self.owned, values[..., None, :], 0.0)

    def bounds(self, figure: Figure) -> Floats:
        """Return the limits (3, 2) in degrees that all owners of an angle allow; where they share none, one's low."""
        limits = figure.arrays.limits[list(self.limbs)]
        low = np.where(self.owned, limits[..., 0], -np.inf).max(axis=0)
        high = np.where(self.owned, limits[..., 1], np.inf).min(axis=0)
        return np.stack([low, np.maximum(low, high)], axis=-1)


@lru_cache(maxsize=64)
def joint_limbs(figure: Figure) -> Mapping[str, JointLimbs]:
    """Return the limbs of every joint id, and which of the angles they own; the root owns all of its."""
    return MappingProxyType({joint: _owners(figure, limbs) for joint, limbs in joints_of(figure).items()})


def _owners(figure: Figure, limbs: tuple[int, ...]) -> JointLimbs:
    owned = turns(figure)[list(limbs)]
    owned[0] |= ~owned.any(axis=0)
    owned.flags.writeable = False
    return JointLimbs(limbs, owned)


@lru_cache(maxsize=64)
def joints_of(figure: Figure) -> Mapping[str, tuple[int, ...]]:
    """Return limb indices by joint id: ``root``, and every limb's own id; limbs that share one move alike."""
    found: dict[str, tuple[int, ...]] = {ROOT_JOINT: (0,)}
    for limb in figure.limbs[1:]:
        found[limb.joint_id] = (*found.get(limb.joint_id, ()), limb.index)
    return MappingProxyType(found)
