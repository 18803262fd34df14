"""The stage: builds the picture of a session for a surface, and knows what is under the pointer."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from layfigure.drawing.camera import FIXED_VIEWS, Camera
from layfigure.drawing.geometry import to_pixels
from layfigure.drawing.palette import load_palette
from layfigure.drawing.picking import limbs_inside, pick
from layfigure.drawing.render_list import Rectangle, RenderList, Style
from layfigure.drawing.shots import Colouring, Shot, build_render_list, shot_rows
from layfigure.errors import ImpossibleError, PluginError
from layfigure.poses.pose import Pose
from layfigure.session.frame import Frame, Label, Outline, Pane, Size, Widget, WorldLine
from layfigure.session.layout import Areas, Column, areas, candidate_views, grid, pane_at, poser_views
from layfigure.session.panel import PanelText, panel
from layfigure.techniques.contract import Offer

if TYPE_CHECKING:
    from layfigure.session.session import Session

TOLERANCE = 5.0
WORKING = -1


@dataclass(frozen=True)
class Picture:
    """A composed frame and what it shows: poses (the working pose first), shots and their render list."""

    frame: Frame
    poses: tuple[Pose, ...]
    shots: tuple[Shot, ...]
    render_list: RenderList


class Stage:
    """Composes pictures of one session and answers where things are in the last one."""

    def __init__(self, session: Session) -> None:
        self._session = session
        self._picture: Picture | None = None

    def compose(self, size: Size) -> Picture:
        """Return the picture of the session as it is now on a surface of that size."""
        session = self._session
        offer = session.offer()
        place = areas(size, with_page=bool(offer.candidates))
        panes: list[Pane] = []
        shots: list[Shot] = []
        for candidate, view, rectangle in _views(place, offer, size.scale):
            camera = session.view.camera if view == "main" else Camera(FIXED_VIEWS[view], session.view.camera.zoom)
            background = session.theme.pane_chosen if candidate == session.view.candidate else session.theme.pane
            panes.append(Pane(candidate, view, rectangle, len(shots)))
            shots.append(Shot(candidate + 1, rectangle, camera, background))
        poses = (session.document.pose, *offer.candidates)
        widgets = tuple(self._widgets(place, panes, offer, size))
        frame = Frame(
            size=size,
            panes=tuple(panes),
            widgets=widgets,
            outlines=(*self._outlines(panes), *session.mode.outlines()),
            lines=tuple(self._overlay_lines(panes, shots)),
            overlay=session.mode.overlay(),
            status=session.status or offer.note,
            hints=session.hints(),
            title=f"Layfigure – {session.document.figure.name}",
            text_input=session.mode.state == "palette",
            theme=session.view.theme,
        )
        listed = build_render_list(session.document.figure, poses, shots, self._colouring(len(poses)))
        self._picture = Picture(frame, poses, tuple(shots), listed)
        return self._picture

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
        widgets = self.picture.frame.widgets
        return next((w for w in widgets if not isinstance(w, Label) and w.rectangle.contains(x, y)), None)

    def limb_at(self, pane: Pane, x: float, y: float) -> int | None:
        """Return the selectable limb whose front-most volume a point of a view shows, or one a few pixels off."""
        part = pick(self.picture.render_list, pane.shot, x, y, TOLERANCE * self.picture.frame.size.scale)
        return self._nearest_movable(part) if part >= 0 else None

    def limbs_in(self, candidate: int, view: str, band: Rectangle) -> tuple[int, ...]:
        """Return the movable limbs of a candidate that lie wholly inside a rectangle on one of its views."""
        pane = next((p for p in self.picture.frame.panes if (p.candidate, p.view) == (candidate, view)), None)
        if pane is None:
            raise ImpossibleError("that view is not shown")
        shot = self.picture.shots[pane.shot]
        return limbs_inside(self._session.document.figure, self.picture.poses[shot.pose], shot, band)

    def _nearest_movable(self, part: int) -> int | None:
        """A limb that cannot move stands for the nearest one above it that can (the head turns with the neck)."""
        figure = self._session.document.figure
        while part > 0 and not figure.limbs[part].movable:
            part = figure.limbs[part].parent
        return part if part > 0 else None

    def _overlay_lines(self, panes: list[Pane], shots: list[Shot]) -> Iterator[WorldLine]:
        """Yield the lines of the overlays that are on, over every view of the working pose."""
        session = self._session
        figure, pose = session.document.figure, session.document.pose
        for record in [
            session.host.overlays[key] for key in sorted(session.view.overlays & set(session.host.overlays))
        ]:
            try:
                lines = session.host.call(record, "drawing", lambda record=record: list(record.lines(figure, pose)))
            except PluginError as error:
                session.say(str(error))
                continue
            for pane in panes:
                if pane.candidate == WORKING:
                    ends = np.array([(line.begin, line.end) for line in lines], dtype=np.float64).reshape(-1, 2, 3)
                    pixels = to_pixels(figure, pose, shot_rows([shots[pane.shot]]), ends)
                    for ((x1, y1, _), (x2, y2, _)), line in zip(pixels.tolist(), lines, strict=True):
                        yield WorldLine(x1, y1, x2, y2, line.rgb)

    def _colouring(self, poses: int) -> Colouring:
        session = self._session
        figure = session.document.figure
        styles = np.zeros((poses, len(figure.limbs)), dtype=np.uint8)
        kept = [limb for limb in figure.movable if limb not in session.document.enabled]
        styles[0, kept] = Style.DIM
        styles[:, list(session.view.selected)] = Style.SELECTED
        if session.view.hover is not None and session.view.hover[0] + 1 < poses:
            styles[session.view.hover[0] + 1, session.view.hover[1]] = Style.HOVER
        return Colouring(load_palette("default").rgb(figure.colours), styles)

    def _widgets(self, place: Areas, panes: list[Pane], offer: Offer, size: Size) -> Iterator[Widget]:
        unit = size.scale
        for pane in panes:
            if pane.candidate >= 0 and pane.view == "main":
                box = Rectangle(pane.rectangle.x, pane.rectangle.y, round(26 * unit), round(26 * unit))
                yield Label(box, str(pane.candidate + 1), "number", "centre")
            if pane.candidate < 0 and place.poser.width >= 200 * unit:
                box = pane.rectangle
                yield Label(
                    Rectangle(box.x + round(6 * unit), box.y + round(4 * unit), box.width, round(16 * unit)),
                    self._view_name(pane.view),
                    "small",
                )
        heading = Rectangle(place.poser.x, place.poser.y, place.poser.width, round(20 * unit))
        yield Label(heading, self._session.document.figure.name, "title")
        text = self._panel_text(offer)
        yield from panel(Column(place.panel, unit), text, self._session.key_for)

    def _view_name(self, view: str) -> str:
        rotation = self._session.view.camera.rotation
        if view != "main":
            return view
        return next((name for name, fixed in FIXED_VIEWS.items() if fixed == rotation), "turned")

    def _panel_text(self, offer: Offer) -> PanelText:
        session = self._session
        host = session.host
        return PanelText(
            limb=session.describe_selection(),
            techniques=tuple((technique.id, technique.title) for technique in host.techniques.values()),
            technique=session.document.technique,
            controls=session.controls(),
            offer=offer,
        )

    def _outlines(self, panes: list[Pane]) -> Iterator[Outline]:
        chosen = [pane.rectangle for pane in panes if pane.candidate == self._session.view.candidate]
        if chosen:
            yield Outline(_around(chosen), "chosen")
        if self._session.mode.state == "orbit":
            yield from (Outline(pane.rectangle, "focus") for pane in panes if pane.view == "main")


def _views(place: Areas, offer: Offer, unit: float) -> Iterator[tuple[int, str, Rectangle]]:
    line = max(round(2 * unit), 1)
    heading = round(26 * unit)
    below = Rectangle(place.poser.x, place.poser.y + heading, place.poser.width, place.poser.height - heading)
    yield from ((WORKING, view, rectangle) for view, rectangle in poser_views(below, line))
    if offer.candidates:
        for candidate, cell in enumerate(grid(len(offer.candidates), place.page, round(8 * unit))):
            yield from ((candidate, view, rectangle) for view, rectangle in candidate_views(cell, line))


def _around(rectangles: list[Rectangle]) -> Rectangle:
    left, top = min(r.x for r in rectangles), min(r.y for r in rectangles)
    right, bottom = max(r.x + r.width for r in rectangles), max(r.y + r.height for r in rectangles)
    return Rectangle(left, top, right - left, bottom - top)
