"""Left and right of a motion: masks that choose joints, and the mirror image."""

from __future__ import annotations

from fractions import Fraction
from functools import partial

from layfigure.errors import LayfigureError
from layfigure.figures.figure import Figure
from layfigure.motions.joints import joint_limbs, joints_of
from layfigure.motions.keys import PLACE, ROOT_JOINT, Values
from layfigure.motions.motion import Motion
from layfigure.poses.symmetry import mirror_map

SIDES = ("left", "right", "middle")


def mask(figure: Figure, *parts: str) -> frozenset[str]:
    """Return the joint ids of parts of a figure, for ``strip`` and ``without``.

    A part is a side (``left``, ``right``, ``middle``), a limb, or ``LIMB+``: the limb and all below it; ``root`` is the
    root with its place.

    Raises:
        LayfigureError: the figure has no such limb; the sentence names the nearest.
    """
    by_limb = {limb: joint for joint, limbs in joints_of(figure).items() for limb in limbs}
    found: set[str] = set()
    for part in parts:
        word = part.strip().casefold()
        if word in (ROOT_JOINT, f"{ROOT_JOINT}+"):
            found |= {ROOT_JOINT, PLACE} | (set(by_limb.values()) if word.endswith("+") else set())
        elif word in SIDES and word not in joints_of(figure):
            found |= {by_limb[limb.index] for limb in figure.limbs[1:] if _side(figure, limb.index) == word}
        else:
            top = figure.index(word.removesuffix("+"))
            found |= {by_limb[limb] for limb in (figure.subtree(top) if word.endswith("+") else (top,))}
    return frozenset(found)


def _side(figure: Figure, index: int) -> str:
    """Return on which side of the figure a limb grows: where its nearest ancestor that has a twin stands."""
    partners, _ = mirror_map(figure)
    if partners[index] == index:
        return "middle"
    x, limb = 0.0, figure.limbs[index]
    while limb.parent >= 0:
        x += limb.position[0] + (limb.end[0] if limb.index == index else 0.0)
        limb = figure.limbs[limb.parent]
    if x == 0.0:
        return "middle"
    return "left" if x > 0 else "right"


def mirror(motion: Motion, figure: Figure) -> Motion:
    """Return a motion as a mirror shows it: twins change places, a limb in the middle turns the other way.

    The root's place has x negated. Joints that the figure does not have stay as they are. Twice is the motion again.

    Raises:
        LayfigureError: two joints would become one.
    """
    partners, signs = mirror_map(figure)
    known = joint_limbs(figure)
    by_limb = {limb: joint for joint, own in known.items() for limb in own.limbs}
    tracks = {}
    for joint, spans in motion.tracks.items():
        limb = known[joint].limbs[0] if joint in known else None
        to = joint if limb is None else by_limb[int(partners[limb])]
        if limb is None:
            sign = (-1, 1, 1) if joint == PLACE else (1, 1, 1)
        else:
            x, y, z = known[joint].read(signs).astype(int).tolist()
            sign = (x, y, z)
        if to in tracks:
            raise LayfigureError(f'two joints would become "{to}" in the mirror; {figure.name} is not symmetric there')
        tracks[to] = tuple(span.revalued(partial(_times, signs=sign)) for span in spans)
    return Motion(motion.duration, tracks, motion.marks)


def _times(values: Values, signs: tuple[int, int, int]) -> Values:
    x, y, z = (value * Fraction(sign) for value, sign in zip(values, signs, strict=True))
    return (x, y, z)
