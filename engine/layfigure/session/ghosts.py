"""Onion skins: the poses a motion has a little before and after, drawn as ghosts behind the working pose.

They are told apart from it by shape, being thin sticks, and from each other by colour and shape: those before are
cold and broken at their joints, those after are warm and whole, with balls there. So they differ without colours too.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from layfigure.drawing.gathering import gathered
from layfigure.drawing.joint_kinds import coded_as_still
from layfigure.drawing.render_list import RenderList
from layfigure.drawing.shots import Colouring, Shot, build_render_list
from layfigure.drawing.sticks import broken, nowhere_too_thin
from layfigure.drawing.theme import ViewTheme
from layfigure.figures.figure import Figure
from layfigure.poses.pose import Pose
from layfigure.session.document import Document
from layfigure.session.moments import after, before, key_frames, poses_at

if TYPE_CHECKING:
    from layfigure.motions.standard import Curves

EACH_SIDE = 2
KEYS = "keys"


class Ghosts(NamedTuple):
    """The poses before and after, nearest last and nearest first."""

    before: tuple[Pose, ...] = ()
    after: tuple[Pose, ...] = ()


NONE = Ghosts()


def ghosts_of(document: Document, onion: str, curves: Curves) -> Ghosts:
    """Return the ghosts of a document: of the keys beside the playhead, or of frames ``onion`` and twice that away."""
    motion, here = document.motion, document.playhead
    if motion is None or not onion:
        return NONE
    if onion == KEYS:
        keys = key_frames(document)
        earlier, later = before(keys, here, EACH_SIDE), after(keys, here, EACH_SIDE)
    else:
        steps = [int(onion) * count for count in range(1, EACH_SIDE + 1)]
        earlier = tuple(here - step for step in reversed(steps) if here >= step)
        later = tuple(here + step for step in steps if here + step <= motion.duration)
    found = poses_at(document, [*earlier, *later], curves) if earlier or later else ()
    return Ghosts(found[: len(earlier)], found[len(earlier) :])


class GhostKeeper:
    """Keeps the ghosts that were asked for last: a window is drawn more often than they change."""

    def __init__(self) -> None:
        self._asked: tuple[object, object, Fraction, str] | None = None
        self._found = NONE

    def of(self, document: Document, onion: str, curves: Curves) -> Ghosts:
        """Return :func:`ghosts_of` a document."""
        if not onion:
            return NONE
        asked = (document.motion, document.pose, document.playhead, onion)
        known = self._asked
        if known is None or any(a is not b for a, b in zip(asked[:2], known[:2], strict=True)) or asked != known:
            self._asked, self._found = asked, ghosts_of(document, onion, curves)
        return self._found


@dataclass(frozen=True)
class Scenery:
    """What stands behind the figures of a picture: the theme's colours, and ghosts in the working pose's views.

    ``trouble`` is a sentence where ghosts were asked for and there can be none.
    """

    theme: ViewTheme
    ghosts: Ghosts = NONE
    trouble: str = ""


def ghost_lists(figure: Figure, scenery: Scenery, shots: Sequence[Shot]) -> Iterator[RenderList]:
    """Yield the render list of every ghost, in all the views that ``shots`` show."""
    theme, ghosts = scenery.theme, scenery.ghosts
    yield from (broken(figure, _thin(figure, pose, shots, theme.before)) for pose in ghosts.before)
    yield from (_thin(figure, pose, shots, theme.after) for pose in ghosts.after)


def with_ghosts(listed: RenderList, ghosts: Iterable[RenderList], *, kinds: bool) -> RenderList:
    """Return a render list with those of ghosts in it; with ``kinds`` they look like limbs that cannot move."""
    return gathered([listed, *(map(coded_as_still, ghosts) if kinds else ghosts)])


def _thin(figure: Figure, pose: Pose, shots: Sequence[Shot], colour: tuple[int, int, int]) -> RenderList:
    palette = np.tile(np.array(colour, dtype=np.uint8), (len(figure.colours), 1))
    styles = np.zeros((1, len(figure.limbs)), dtype=np.uint8)
    placed = [replace(shot, pose=0) for shot in shots]
    listed = build_render_list(figure, (pose,), placed, Colouring(palette, styles, frozenset({0})))
    return nowhere_too_thin(listed)
