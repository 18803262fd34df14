"""Lines and signs over the views: plug-ins' overlays, locks, and what the technique in use wants to show."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from itertools import compress, islice, pairwise
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from layfigure.drawing.geometry import Floats, to_pixels
from layfigure.drawing.marks import ROLES, Mark
from layfigure.drawing.shots import Shot, shot_rows
from layfigure.errors import PluginError
from layfigure.figures.figure import Figure
from layfigure.kinematics.forward import place_pose
from layfigure.plugins.records import Overlay, OverlayLine
from layfigure.poses.locks import Band, Hold, JointLock, Pin, PinOrientation, tips_of
from layfigure.poses.pose import Pose
from layfigure.session.document import Document
from layfigure.session.frame import Pane, Sign, WorldLine
from layfigure.techniques.contract import Offer

if TYPE_CHECKING:
    from layfigure.session.session import Session

MOST = 4000  # marks of one kind; a plug-in that gives more is cut, not waited for

FARTHEST = 1e5  # pixels; no window is so large, and what is not a number is not nearer


def overlay_lines(session: Session, panes: Sequence[Pane], shots: Sequence[Shot]) -> Iterator[WorldLine]:
    """Yield the lines of the plug-ins' overlays that are on, over every given pane."""
    figure, pose = session.document.figure, session.playback.shown.pose
    for key in sorted(session.view.overlays & set(session.host.overlays)):
        record = session.host.overlays.get(key)
        if record is None:  # its plug-in fell out over the overlay before
            continue
        try:
            lines, ends = session.host.call(record, "drawing", _listed, record, figure, pose)
        except PluginError as error:
            session.say(str(error))
            continue
        for pane in panes:
            pixels = to_pixels(figure, _row_of(session, shots[pane.shot]), ends)
            sane = np.all(np.abs(pixels) < FARTHEST, axis=(1, 2)).tolist()
            shown = compress(zip(pixels.tolist(), lines, strict=True), sane)
            for ((x1, y1, _), (x2, y2, _)), line in shown:
                yield WorldLine(x1, y1, x2, y2, pane.rectangle, rgb=line.rgb)


def _listed(record: Overlay, figure: Figure, pose: Pose) -> tuple[list[OverlayLine], NDArray[np.float64]]:
    """Return an overlay's lines and their ends (k, 2, 3); a wrong form is the plug-in's fault."""
    lines = list(islice(record.lines(figure, pose), MOST))
    return lines, np.array([(line.begin, line.end) for line in lines], dtype=np.float64).reshape(-1, 2, 3)


def technique_marks(session: Session, offer: Offer, *, cones: bool) -> tuple[Mark, ...]:
    """Return the marks of the technique in use, or its cones; one that fails is left for another technique."""
    record = session.host.techniques.get(session.document.technique)
    if record is None:
        return ()
    try:
        given = session.host.call(
            record, "drawing", lambda: list(islice(offer.cones() if cones else offer.marks(), MOST))
        )
    except PluginError as error:
        session.say(str(error))
        return ()
    return tuple(mark for mark in given if isinstance(mark, Mark) and mark.role in ROLES and _has_points(mark))


def _has_points(mark: Mark) -> bool:
    """Whether a stranger's mark is a path of points at all, whatever its numbers."""
    try:
        return np.array(mark.points, dtype=np.float64).shape == (len(mark.points), 3)
    except (TypeError, ValueError):
        return False


def lock_marks(document: Document) -> Iterator[Mark]:
    """Yield a sign for every lock where it holds, and a line from there to where its limb is."""
    if not document.locks:
        return
    figure = document.figure
    placement = place_pose(figure, document.pose)
    tips = [tuple(tip) for tip in tips_of(figure, placement).tolist()]
    origins = [tuple(origin) for origin in placement.origins.tolist()]
    for lock in document.locks:
        match lock:
            case Pin(limb, position):
                yield Mark("pin", (position,))
                yield Mark("pin", (tips[limb], position))
            case Band(limb, position):
                yield Mark("band", (position,))
                yield Mark("band", (tips[limb], position))
            case PinOrientation(limb):
                yield Mark("orientation", (tips[limb],))
            case Hold(limb, other):
                yield Mark("hold", (tips[limb],))
                yield Mark("hold", (tips[other],))
                yield Mark("hold", (tips[limb], tips[other]))
            case JointLock(limb):
                yield Mark("joint", (origins[limb],))


def drawn(
    session: Session, marks: Iterable[Mark], panes: Sequence[Pane], shots: Sequence[Shot]
) -> tuple[list[WorldLine], list[Sign]]:
    """Return marks as lines and signs over every given pane; those with a number that is not finite are left out."""
    lines: list[WorldLine] = []
    signs: list[Sign] = []
    listed = list(marks)
    points = np.array([point for mark in listed for point in mark.points], dtype=np.float64).reshape(-1, 3)
    for pane in panes:
        row = _row_of(session, shots[pane.shot])
        pixels = to_pixels(session.document.figure, row, points)
        sane = np.all(np.abs(pixels) < FARTHEST, axis=1).tolist()  # false for what is not a number, too
        first = 0
        for mark in listed:
            path = pixels[first : first + len(mark.points)]
            if all(sane[first : first + len(mark.points)]):
                _add(mark.role, path.tolist(), pane, (lines, signs))
            first += len(mark.points)
    return lines, signs


def _row_of(session: Session, shot: Shot) -> Floats:
    """Return the row (1, 18) of a view as it shows the working pose, whichever pose it is a view of."""
    return shot_rows([replace(shot, pose=0)], [session.playback.shown.pose])


def _add(role: str, path: list[list[float]], pane: Pane, into: tuple[list[WorldLine], list[Sign]]) -> None:
    lines, signs = into
    if len(path) == 1:
        signs.append(Sign(path[0][0], path[0][1], role, pane.rectangle))
    for (x1, y1, _), (x2, y2, _) in pairwise(path):
        lines.append(WorldLine(x1, y1, x2, y2, pane.rectangle, role=role))
