"""The stage: builds the picture of a session for a surface, and knows what is under the pointer."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from layfigure.drawing.camera import FIXED_VIEWS, Camera, framing
from layfigure.drawing.geometry import from_pixels, to_pixels
from layfigure.drawing.palette import load_palette
from layfigure.drawing.picking import limbs_inside, pick
from layfigure.drawing.render_list import Look, Rectangle, Style
from layfigure.drawing.shots import Colouring, Shot, shot_rows
from layfigure.errors import ImpossibleError, LayfigureError
from layfigure.kinematics.forward import place_pose
from layfigure.poses.locks import locked_joints, tips_of
from layfigure.poses.pose import Pose
from layfigure.session.document import Document
from layfigure.session.frame import Frame, Label, Outline, Pane, Sign, Size, Widget, WorldLine
from layfigure.session.ghosts import GhostKeeper, Scenery
from layfigure.session.joint_dials import joint_dials, joint_sliders
from layfigure.session.layout import (
    Areas,
    Column,
    areas,
    candidate_views,
    grid,
    pane_at,
    poser_views,
    three_views,
)
from layfigure.session.metrics import Metrics, metrics
from layfigure.session.moments import known_curves
from layfigure.session.panel import PanelText, panel
from layfigure.session.picture import Picture
from layfigure.session.signs import drawn, lock_marks, overlay_lines, technique_marks
from layfigure.session.time_line import time_line_widgets
from layfigure.techniques.contract import Offer

if TYPE_CHECKING:
    from layfigure.session.session import Session

WORKING, SKELETON = -1, -2
FAR = 0.35  # of what a view shows from its middle to its edge: how far the root may be carried in a still picture


class Stage:
    """Composes pictures of one session and answers where things are in the last one."""

    def __init__(self, session: Session) -> None:
        self._session = session
        self._picture: Picture | None = None
        self._ghosts = GhostKeeper()
        self._painter: tuple[str, Look] | None = None
        self._pages = 0

    def compose(self, size: Size) -> Picture:
        """Return the picture of the session as it is now on a surface of that size."""
        session = self._session
        shown, offer = session.playback.shown, session.offer()
        skeleton = session.view.skeleton
        with_page, with_line = bool(offer.candidates) or skeleton, shown.motion is not None
        place = areas(size, with_page=with_page, with_time_line=with_line)
        self._follow_root()
        poses = (shown.pose, *offer.candidates, *[shown.pose] * skeleton)
        panes: list[Pane] = []
        shots: list[Shot] = []
        for candidate, view, rectangle in _views(place, offer, self._asked(size), skeleton=skeleton):
            camera = session.view.camera if view == "main" else Camera(FIXED_VIEWS[view], session.view.camera.zoom)
            background = session.theme.pane_chosen if candidate == session.view.candidate else session.theme.pane
            panes.append(Pane(candidate, view, rectangle, len(shots)))
            pose = len(poses) - 1 if candidate == SKELETON else candidate + 1
            shots.append(Shot(pose, rectangle, camera, background, self._anchor(candidate, poses[pose])))
        scenery = self._scenery(shown)
        lines, signs = self._marked(panes, shots, offer)
        widgets = tuple(self._widgets(place, panes, offer, size))
        frame = Frame(
            size=size,
            panes=tuple(panes),
            widgets=widgets,
            outlines=(*self._outlines(panes), *session.mode.outlines()),
            lines=lines,
            signs=signs,
            overlay=session.mode.overlay(),
            status=session.status or scenery.trouble or offer.note,
            hints=session.hints(),
            title=f"Layfigure – {session.document.figure.name}",
            text_input=session.mode.state == "palette",
            theme=session.view.theme,
        )
        own, colouring = sum(pane.candidate == WORKING for pane in panes), self._colouring(len(poses), skeleton)
        picture = Picture(frame, shown.figure, poses, tuple(shots), own, colouring, scenery)
        self._picture = self._paged(picture)
        return self._picture

    def _scenery(self, shown: Document) -> Scenery:
        """Return what stands behind the figures; while a motion plays there are no ghosts, which would hide it.

        Where there can be none, the scenery says why: nothing about the session changes because it is looked at.
        """
        session = self._session
        onion = "" if session.view.playing else session.view.onion
        try:
            return Scenery(session.theme, self._ghosts.of(shown, onion, known_curves(session.host)))
        except LayfigureError as error:  # such as an interpolation whose plug-in has fallen out
            return Scenery(session.theme, trouble=str(error))

    def _paged(self, picture: Picture) -> Picture:
        """Return a picture that says in its frame whether its page looks as in the picture before."""
        before, painter = self._picture, (self._session.view.renderer, self._session.view.look)
        same = before is not None and picture.same_page(before) and painter == self._painter
        self._pages += not same
        self._painter = painter
        return replace(picture, frame=replace(picture.frame, page=self._pages))

    @property
    def picture(self) -> Picture:
        """The last picture composed.

        Raises:
            ImpossibleError: nothing has been shown yet.
        """
        if self._picture is None:
            raise ImpossibleError("nothing is shown yet")
        return self._picture

    @property
    def size(self) -> Size:
        """The surface composed for last."""
        return self._picture.frame.size if self._picture is not None else Size(0, 0)

    def pane_at(self, x: float, y: float) -> Pane | None:
        """Return the view under a point of the surface."""
        return pane_at(self.picture.frame.panes, x, y)

    def widget_at(self, x: float, y: float) -> Widget | None:
        """Return the widget under a point that is not a label."""
        widgets = reversed(self.picture.frame.widgets)  # what is painted last lies on top
        return next((w for w in widgets if not isinstance(w, Label) and w.rectangle.contains(x, y)), None)

    def limb_at(self, pane: Pane, x: float, y: float) -> int | None:
        """Return the selectable limb whose front-most volume a point of a view shows, or one a few pixels off.

        The root can be selected in the working pose only: candidates are there for their limbs.
        """
        part = self.part_at(pane, x, y)
        limb = self._nearest_movable(part) if part >= 0 else 0
        return limb if limb or (pane.candidate < 0 and part >= 0) else None

    def part_at(self, pane: Pane, x: float, y: float) -> int:
        """Return the limb, movable or not, that a point of a view shows, or -1."""
        return pick(self.picture.render_list, pane.shot, x, y, metrics(self.size).tolerance * self.size.scale)

    def end_at(self, pane: Pane, x: float, y: float) -> int | None:
        """Return the limb whose end a drag from a point of the working pose moves, or None.

        That is the limb there, movable or not; the root where nothing above it can turn.
        """
        part = self.part_at(pane, x, y)
        if part < 0:
            return None
        return part if self._nearest_movable(part) else 0

    def tip_pixels(self, pane: Pane, limb: int) -> tuple[float, float, float]:
        """Return where a limb's end is shown in a pane of the working pose: x and y in pixels, and its depth."""
        figure, pose = self._session.document.figure, self._session.playback.shown.pose
        x, y, z = to_pixels(figure, self._row(pane), tips_of(figure, place_pose(figure, pose))[limb]).tolist()
        return x, y, z

    def world_at(self, pane: Pane, x: float, y: float, depth: float) -> tuple[float, float, float]:
        """Return the world point at a pixel and depth of a pane: the pointer's ray meets the plane at that depth."""
        here = from_pixels(self._session.document.figure, self._row(pane), np.array([x, y, depth])).tolist()
        return (round(here[0], 6), round(here[1], 6), round(here[2], 6))

    def _row(self, pane: Pane) -> NDArray[np.float64]:
        return shot_rows([self.picture.shots[pane.shot]], self.picture.poses)

    def limbs_in(self, candidate: int, view: str, band: Rectangle) -> tuple[int, ...]:
        """Return the movable limbs of a candidate that lie wholly inside a rectangle on one of its views."""
        pane = next((p for p in self.picture.frame.panes if (p.candidate, p.view) == (candidate, view)), None)
        if pane is None:
            raise ImpossibleError("that view is not shown")
        shot = self.picture.shots[pane.shot]
        return limbs_inside(self._session.document.figure, self.picture.poses[shot.pose], shot, band)

    def _nearest_movable(self, part: int) -> int:
        """A limb that cannot move stands for the nearest one above it that can (the head turns with the neck)."""
        figure = self._session.document.figure
        while part > 0 and not figure.limbs[part].movable:
            part = figure.limbs[part].parent
        return max(part, 0)

    def _marked(
        self, panes: list[Pane], shots: list[Shot], offer: Offer
    ) -> tuple[tuple[WorldLine, ...], tuple[Sign, ...]]:
        """Return the lines and signs over the working pose, and the cones over its skeleton."""
        session = self._session
        own = [pane for pane in panes if pane.candidate < 0]
        bones = [pane for pane in own if pane.candidate == SKELETON]
        passing = session.view.passing is not None  # then the technique speaks of another pose than is shown
        own_marks = () if passing else technique_marks(session, offer, cones=False)
        marks = [*lock_marks(session.playback.shown), *own_marks]
        lines, signs = drawn(session, marks, own, shots)
        if bones and not passing:
            cone_lines, cone_signs = drawn(session, technique_marks(session, offer, cones=True), bones, shots)
            lines, signs = [*cone_lines, *lines], [*cone_signs, *signs]
        return (*overlay_lines(session, own, shots), *lines), tuple(signs)

    def _follow_root(self) -> None:
        """Let the cameras stay where they are until the root has been carried far, but not while it is dragged."""
        session = self._session
        root = session.playback.shown.pose.translation
        far = np.abs(root - session.view.anchor).max() > FAR * framing(session.document.figure).half_extent
        if far and not session.preview.going_on:
            smooth = session.view.passing is not None  # one that walks is accompanied, not caught up with
            x, y, z = self._kept_near(root) if smooth else root.tolist()
            session.view = replace(session.view, anchor=(x, y, z))

    def _anchor(self, candidate: int, pose: Pose) -> tuple[float, float, float]:
        """Return what a view's camera stays with: candidates whose root was carried far are kept in sight."""
        return self._session.view.anchor if candidate < 0 else self._kept_near(pose.translation)

    def _kept_near(self, root: NDArray[np.float64]) -> tuple[float, float, float]:
        """Return the anchor, moved as little as keeps a root in sight."""
        reach = FAR * framing(self._session.document.figure).half_extent
        away = root - self._session.view.anchor
        x, y, z = (root - np.clip(away, -reach, reach)).tolist()
        return (x, y, z)

    def _colouring(self, poses: int, skeleton: bool) -> Colouring:
        session = self._session
        figure, takes_goals = session.document.figure, "goal" in session.channels
        styles = np.zeros((poses, len(figure.limbs)), dtype=np.uint8)
        still = locked_joints(session.document.locks)
        kept = [limb for limb in figure.movable if limb not in session.document.enabled or limb in still]
        own = [0, poses - 1] if skeleton else [0]
        styles[0, kept] = Style.STICK if takes_goals else Style.DIM
        if skeleton:
            styles[-1, kept] = Style.DIM
        styles[:, list(session.view.selected)] = Style.SELECTED
        hover = session.view.hover
        if hover is not None and hover[0] + 1 < poses:
            styles[poses - 1 if hover[0] == SKELETON else hover[0] + 1, hover[1]] = Style.HOVER
        return Colouring(load_palette("default").rgb(figure.colours), styles, frozenset(own[1:]))

    def _widgets(self, place: Areas, panes: list[Pane], offer: Offer, size: Size) -> Iterator[Widget]:
        unit, of, shown = size.scale, metrics(size), self._asked(size).shown
        for pane in panes:
            box = pane.rectangle
            if pane.candidate >= 0 and pane.view == (shown or "main"):
                number = Rectangle(box.x, box.y, round(of.number_x * unit), round(of.number_y * unit))
                yield Label(number, str(pane.candidate + 1), "number", "centre")
                yield from _badge(offer, pane, of, unit)
            if pane.candidate < 0 and box.width >= of.name_least * unit and place.poser.width >= of.names_least * unit:
                left, top = box.x + round(of.name_x * unit), box.y + round(of.name_y * unit)
                place_of_name = Rectangle(left, top - top % of.grain, box.width, round(of.name * unit))
                yield Label(place_of_name, self._view_name(pane.view), "small")
        heading = Rectangle(place.poser.x, place.poser.y, place.poser.width, round(of.title * unit))
        yield Label(heading, self._heading(shown), "title")
        widgets = panel(Column(place.panel, unit, of), self._panel_text(offer, size), self._session.key_for)
        bottom = place.panel.y + place.panel.height
        yield from (w for w in widgets if of.overflow or w.rectangle.y + w.rectangle.height <= bottom)
        yield from time_line_widgets(self._session, place.time_line, size)

    def _asked(self, size: Size) -> Asked:
        """Return what a surface has room for, and the view that is shown where there is room for one only."""
        shown = "" if three_views(size) else self._session.view.shown
        return Asked(metrics(size), size.scale, shown)

    def _heading(self, shown: str) -> str:
        name = self._session.document.figure.name
        return f"{name}, {self._view_name(shown)}" if shown else name

    def _view_name(self, view: str) -> str:
        rotation = self._session.view.camera.rotation
        if view != "main":
            return view
        return next((name for name, fixed in FIXED_VIEWS.items() if fixed == rotation), "turned")

    def _panel_text(self, offer: Offer, size: Size) -> PanelText:
        session = self._session
        dials = joint_dials if metrics(size).dial else joint_sliders
        host = session.host
        return PanelText(
            limb=session.describe_selection(),
            techniques=tuple((technique.id, technique.title) for technique in host.techniques.values()),
            technique=session.document.technique,
            controls=session.controls(),
            offer=offer,
            dials=dials(session.playback.shown, session.view.selected) if "drag" in session.channels else (),
            on=frozenset({"symmetric"} if session.document.symmetric else ()),
        )

    def _outlines(self, panes: list[Pane]) -> Iterator[Outline]:
        chosen = [pane.rectangle for pane in panes if pane.candidate == self._session.view.candidate]
        if chosen:
            yield Outline(_around(chosen), "chosen")
        if self._session.mode.state == "orbit":
            yield from (Outline(pane.rectangle, "focus") for pane in panes if pane.view == "main")


@dataclass(frozen=True)
class Asked:
    """How views are laid out: sizes, pixels per unit, and the one view that is shown of each pose (empty: three)."""

    of: Metrics
    unit: float
    shown: str


def _badge(offer: Offer, pane: Pane, of: Metrics, unit: float) -> Iterator[Widget]:
    """Yield what the technique notes on a candidate, beside its number."""
    text = offer.badges[pane.candidate] if pane.candidate < len(offer.badges) else ""
    if text:
        box, number = pane.rectangle, round(of.badge_left * unit)
        width = box.width - number - round(of.badge_right * unit)
        beside = Rectangle(box.x + number, box.y, width, round(of.number_y * unit))
        yield Label(beside, text, "text", "right")


def _views(place: Areas, offer: Offer, asked: Asked, *, skeleton: bool) -> Iterator[tuple[int, str, Rectangle]]:
    of, unit, shown = asked.of, asked.unit, asked.shown
    line = max(round(of.views_line * unit), 1)
    heading = round(of.heading * unit)
    below = Rectangle(place.poser.x, place.poser.y + heading, place.poser.width, place.poser.height - heading)
    yield from ((WORKING, view, rectangle) for view, rectangle in _own_views(below, line, asked))
    if skeleton:
        yield from ((SKELETON, view, rectangle) for view, rectangle in _own_views(place.page, line, asked))
    elif offer.candidates:
        gap, shape = round(of.card_gap * unit), 1.0 if shown else 1.5
        for candidate, cell in enumerate(grid(len(offer.candidates), place.page, gap, shape=shape, grain=of.grain)):
            parts = [(shown, cell)] if shown else candidate_views(cell, line)
            yield from ((candidate, view, rectangle) for view, rectangle in parts)


def _own_views(area: Rectangle, line: int, asked: Asked) -> Iterable[tuple[str, Rectangle]]:
    """Return the views of the working pose in an area: the one that is shown where it is too narrow for three."""
    narrow = asked.shown and area.width < asked.of.views_least
    return [(asked.shown, area)] if narrow else poser_views(area, line)


def _around(rectangles: list[Rectangle]) -> Rectangle:
    left, top = min(r.x for r in rectangles), min(r.y for r in rectangles)
    right, bottom = max(r.x + r.width for r in rectangles), max(r.y + r.height for r in rectangles)
    return Rectangle(left, top, right - left, bottom - top)
