"""Left and right: the mirror image of a pose."""

from __future__ import annotations

from collections.abc import Container, Iterable
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from layfigure.figures.figure import Figure
from layfigure.poses.pose import Pose

_MIRROR = np.diag([-1.0, 1.0, 1.0])


def flipped(figure: Figure, pose: Pose) -> Pose:
    """Return the pose mirrored across the plane x = 0 of the root; flipping twice gives the same bits.

    Twins exchange their angles as they are (a mirrored limb mirrors the sense, posing.md 1); a limb in the middle has
    the signs of its angles changed. The root keeps its place with x negated.
    """
    partners, signs = mirror_map(figure)
    return pose.with_angles(pose.angles[partners] * signs, pose.translation * [-1.0, 1.0, 1.0])


def mirrored_joints(figure: Figure, pose: Pose, limbs: Iterable[int]) -> tuple[Pose, tuple[int, ...]]:
    """Return a pose whose named joints stand as the mirror images of ``limbs`` do in ``pose``, and their names.

    Only the limbs named are to be taken from it; what else it holds is the rest of the mirrored pose.
    """
    partners, _ = mirror_map(figure)
    return flipped(figure, pose), tuple(sorted(int(partners[limb]) for limb in limbs))


def with_twins(figure: Figure, before: Pose, after: Pose, held: Container[int]) -> tuple[Pose, tuple[int, ...]]:
    """Return ``after`` with every joint that changed mirrored onto a twin that did not, and the twins that moved.

    A limb in the middle stays as it was edited, and so do twins that are ``held`` or that changed themselves.
    """
    images, _ = mirror_map(figure)
    changed = before.differs_from(after)
    follows = changed[images] & ~changed & (images != np.arange(len(images)))
    twins = [twin for twin in np.flatnonzero(follows).tolist() if twin not in held]
    if not twins:
        return after, ()
    moved = after.with_joints_of(flipped(figure, after), twins)
    return moved, tuple(twin for twin in twins if (moved.angles[twin] != after.angles[twin]).any())


@lru_cache(maxsize=16)
def mirror_map(figure: Figure) -> tuple[NDArray[np.int64], NDArray[np.float64]]:
    """Return each limb's mirror image across x = 0 (n,) and the signs (n, 3) that angles take there; read-only.

    A limb in the middle, or one that nothing mirrors, is its own image.

    A rotation R of the image reads N R N in the limb's canonical space, where N = diag(s) is the mirror seen from
    there. It takes the direction D to s1 N D, and the twist about +Y to one about det(N) s1 Y.
    """
    partners: list[int] = []
    signs = np.ones((len(figure.limbs), 3))
    frames = figure.arrays.frames
    for limb in figure.limbs:
        partner = _partner(figure, limb.index, partners)
        partners.append(partner)
        s = np.diag(frames[limb.index].T @ _MIRROR @ frames[partner])
        about = (s[1] * s[2], s[0] * s[2], s[0] * s[1])  # what becomes of turns about x, y and z
        signs[limb.index] = about if limb.euler else (about[2], about[0], about[1])
    images = np.array(partners)
    images.flags.writeable = signs.flags.writeable = False
    return images, signs


def _partner(figure: Figure, index: int, partners: list[int]) -> int:
    """Return the limb whose rest stands where the limb's mirror image would: its twin, itself, or one like a twin.

    ``partners`` are those of the limbs before this one; partners always have each other. A limb that nothing mirrors,
    because the figure is not symmetric, stands for itself. Partners turn in the same ways: they exchange their angles.
    """
    limbs, frames = figure.limbs, figure.arrays.frames
    kinds = [frozenset(dof.kind for dof in limb.dofs) for limb in limbs]
    if index in partners:
        return partners.index(index)
    if index == 0:
        return 0
    opposite = partners[limbs[index].parent]
    free = [other.index for other in limbs[index:] if other.parent == opposite and other.index not in partners]
    for candidate in sorted(free, key=lambda other: (other != limbs[index].twin, other != index)):
        seen = frames[index].T @ _MIRROR @ frames[candidate]
        turned_alike = bool((np.abs(np.diag(seen)) == 1.0).all()) and kinds[candidate] == kinds[index]
        if turned_alike and np.allclose(_rest(figure, candidate), _rest(figure, index) @ _MIRROR):
            return candidate
    return index


def _rest(figure: Figure, index: int) -> NDArray[np.float64]:
    arrays = figure.arrays
    return np.stack([arrays.offsets[index], arrays.begins[index], arrays.ends[index]])
