"""The moments of a document's motion: which pose stands at a frame, and which frames have keys."""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from functools import lru_cache
from typing import TYPE_CHECKING

from layfigure.errors import ImpossibleError
from layfigure.motions.joints import joints_of as joints_in
from layfigure.motions.keys import PLACE
from layfigure.poses.locks import anew
from layfigure.session.document import Document

if TYPE_CHECKING:
    from layfigure.figures.figure import Figure
    from layfigure.motions.motion import Motion
    from layfigure.motions.standard import Curves
    from layfigure.plugins.host import Host
    from layfigure.poses.pose import Pose

LATEST = Fraction(1_000_000)
"""No playhead goes beyond this frame."""


def motion_of(document: Document) -> Motion:
    """Return the motion in work.

    Raises:
        ImpossibleError: there is none.
    """
    if document.motion is None:
        raise ImpossibleError("there is no motion here; open one, or set a key to begin one")
    return document.motion


def known_curves(host: Host) -> Curves:
    """Return every interpolation there is: the engine's own and those of plug-ins."""
    from layfigure.motions.standard import with_plugins

    return with_plugins(host.interpolations)


def poses_at(
    document: Document, frames: Sequence[Fraction], curves: Curves, *, repeat: bool = False
) -> tuple[Pose, ...]:
    """Return the poses at some frames of the motion; joints that it does not name stand as in the present pose.

    With ``repeat`` it goes on beyond its end with another round, the root from where it has got to.

    Raises:
        ImpossibleError: there is no motion.
        LayfigureError: it uses an interpolation that is not known.
    """
    from layfigure.motions.sampling import sample  # not before a motion is there: a window has to open quickly

    motion, start = motion_of(document), document.pose
    if PLACE in motion.tracks:
        start = replace(start, translation=0 * start.translation)
    sampled = sample(document.figure, motion, list(frames), start, curves, repeat=repeat)
    return tuple(sampled.pose(index) for index in range(len(frames)))


def at_frame(document: Document, frame: Fraction, curves: Curves, rounds: int = 0) -> Document:
    """Return the document with the playhead on a frame and its pose what the motion shows there, its locks with it.

    After so many ``rounds`` of the motion the root has got as much further, and the playhead stays in the motion.
    The techniques' states are those from before; :meth:`Workshop.set_pose` tells them.
    """
    elapsed = frame + rounds * motion_of(document).duration
    (pose,) = poses_at(document, [elapsed], curves, repeat=rounds > 0)
    return replace(document, playhead=frame, pose=pose, locks=anew(document.figure, pose, document.locks))


def key_frames(document: Document, limbs: Sequence[int] = ()) -> tuple[Fraction, ...]:
    """Return the frames with a key of one of some limbs, in order; of any joint where no limb is given."""
    if document.motion is None:
        return ()
    joints = None if not limbs else frozenset(joints_of(document.figure, limbs))
    return _key_frames(document.motion, joints)


@lru_cache(maxsize=16)
def _key_frames(motion: Motion, joints: frozenset[str] | None) -> tuple[Fraction, ...]:
    tracks = motion.tracks
    named = tracks if joints is None else joints & tracks.keys()
    return tuple(sorted({key.time for joint in named for span in tracks[joint] for key in span.keys}))


def joints_of(figure: Figure, limbs: Sequence[int]) -> tuple[str, ...]:
    """Return the joint ids that limbs move by; the root is turned, and carried."""
    chosen = frozenset(limbs)
    found = (joint for joint, moved in joints_in(figure).items() if not chosen.isdisjoint(moved))
    return (*found, PLACE) if 0 in chosen else tuple(found)


def before(frames: Sequence[Fraction], frame: Fraction, count: int = 1) -> tuple[Fraction, ...]:
    """Return up to ``count`` of some ascending frames right before a frame."""
    end = bisect_left(frames, frame)
    return tuple(frames[max(end - count, 0) : end])


def after(frames: Sequence[Fraction], frame: Fraction, count: int = 1) -> tuple[Fraction, ...]:
    """Return up to ``count`` of some ascending frames right after a frame."""
    begin = bisect_right(frames, frame)
    return tuple(frames[begin : begin + count])
