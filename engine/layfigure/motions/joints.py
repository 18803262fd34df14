"""Which limbs of a figure answer to a motion's joint ids."""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache
from types import MappingProxyType

from layfigure.figures.figure import Figure
from layfigure.motions.keys import ROOT_JOINT


@lru_cache(maxsize=64)
def joints_of(figure: Figure) -> Mapping[str, tuple[int, ...]]:
    """Return limb indices by joint id: ``root``, and every limb's own id; limbs that share one move alike."""
    found: dict[str, tuple[int, ...]] = {ROOT_JOINT: (0,)}
    for limb in figure.limbs[1:]:
        found[limb.joint_id] = (*found.get(limb.joint_id, ()), limb.index)
    return MappingProxyType(found)
