"""The net under every technique: whatever proposed a pose, locked joints stay and locked ends are brought back."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from layfigure.errors import ImpossibleError
from layfigure.figures.figure import Figure
from layfigure.poses.locks import Band, Lock, broken, kind_of, locked_joints
from layfigure.poses.pose import Pose
from layfigure.session.bench import KEEPER, Solvers
from layfigure.session.describing import spoken_limb
from layfigure.session.document import Document
from layfigure.techniques.keeping import keep

_WORDS = {"place": "the pin on", "orientation": "the pinned turn of", "hold": "the hold of"}


def changed_limbs(before: Pose, after: Pose) -> frozenset[int]:
    """Return the limbs whose angles differ; the root also where it was carried."""
    limbs = frozenset(np.flatnonzero(before.differs_from(after)).tolist())
    carried = not np.array_equal(before.translation, after.translation)
    return limbs | {0} if carried else limbs


def within_locks(solvers: Solvers, before: Document, pose: Pose, *, settled: bool = False) -> Pose:
    """Return ``pose`` with what the document's locks ask; joints that were changed on purpose keep their change.

    A ``settled`` pose comes from a drag that has heeded rubber bands already.

    Raises:
        ImpossibleError: the locks on ends do not allow the change, or no solver is to be had.
    """
    locks, figure = before.locks, before.figure
    if not locks:
        return pose
    pose = _joints_kept(before, pose)
    changed = changed_limbs(before.pose, pose)
    pulled = not settled and any(isinstance(lock, Band) for lock in locks)
    if not changed or not (pulled or broken(figure, pose, locks)):
        return pose
    movable = (before.enabled | {0}) - changed
    (kept,) = keep(lambda: solvers.get(KEEPER, figure), figure, ((pose,), locks, movable))
    if not kept.met:
        raise ImpossibleError(
            f"{blame(figure, broken(figure, kept.pose, locks))} does not allow that; release it first"
        )
    return kept.pose


def _joints_kept(before: Document, pose: Pose) -> Pose:
    """Return the pose with locked joints as they were; a locked root is not carried either."""
    still = changed_limbs(before.pose, pose) & locked_joints(before.locks)
    if still and still >= changed_limbs(before.pose, pose):
        names = ", ".join(spoken_limb(before.figure, limb) for limb in sorted(still)[:3])
        raise ImpossibleError(f"the joint of the {names} is locked; unlock it first")
    return pose.with_joints_of(before.pose, sorted(still)) if still else pose


def blame(figure: Figure, locks: Iterable[Lock]) -> str:
    """Return which lock is in the way, in words."""
    first = next(iter(locks), None)
    if first is None:
        return "a lock"
    return f"{_WORDS[kind_of(first)]} the {spoken_limb(figure, first.limb)}"
