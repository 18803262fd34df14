"""Live symmetric editing: what is done to a limb by hand is done to its mirror twin as well."""

from __future__ import annotations

from dataclasses import replace

from layfigure.poses.locks import locked_joints
from layfigure.poses.pose import Pose
from layfigure.poses.symmetry import with_twins
from layfigure.session.document import Document
from layfigure.techniques.contract import Drag, Event, Goal, LimbPick, PoseSet

EDITS = (Drag, Goal, LimbPick)
"""What a technique hears when a person works on limbs; whole candidates and whole poses stay as they are."""


def symmetric_edit(document: Document, change: PoseSet) -> PoseSet:
    """Return an edit by hand as it is to be made on a document: on both sides while editing is symmetric."""
    if change.limbs is None:
        return change
    pose, twins = _mirrored(document, change.pose)
    return replace(change, pose=pose, limbs=(*change.limbs, *twins)) if twins else change


def symmetric_echo(before: Document, event: Event, after: Document) -> PoseSet | None:
    """Return the edit that brings the twins after what a technique did on one side, or None."""
    if not isinstance(event, EDITS):
        return None
    pose, twins = _mirrored(before, after.pose)
    return PoseSet(pose, limbs=twins) if twins else None


def _mirrored(document: Document, pose: Pose) -> tuple[Pose, tuple[int, ...]]:
    """Return the pose with the twins of changed limbs set, and which were: none that is kept or locked."""
    if not document.symmetric:
        return pose, ()
    figure = document.figure
    held = (frozenset(range(len(figure.limbs))) - document.enabled) | locked_joints(document.locks)
    return with_twins(figure, document.pose, pose, held)
