"""Pointer gestures: a press becomes a click, a rectangle, a turned view or a moved slider."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from layfigure.drawing.camera import Camera
from layfigure.drawing.render_list import Rectangle
from layfigure.session.events import Event, KeyEvent, PointerEvent
from layfigure.session.frame import JointBall, JointCircle, Outline, Pane, Size, SliderBar, TimeLine
from layfigure.session.joint_dials import ball_line, circle_line
from layfigure.session.metrics import metrics
from layfigure.session.modes import Become, Continue, GiveUp, Outcome, Plain, Pop, Preview, Run, Scrub, Settle
from layfigure.session.words import join_line, split_line


@dataclass(frozen=True)
class PointerDrag(Plain):
    """What a press began: it hears the pointer until it is let go, and Esc gives it up."""

    def hear(self, event: Event, size: Size) -> Sequence[Outcome] | None:
        """Answer moves and the release; keys but Esc wait until the gesture has ended."""
        if isinstance(event, KeyEvent):
            return [Pop(), *self.given_up()] if event.key == "escape" else []
        if not isinstance(event, PointerEvent) or event.kind not in ("move", "release"):
            return []
        return self.dragged(event, size)

    def given_up(self) -> Sequence[Outcome]:
        """Return what takes back what the gesture has shown."""
        return [GiveUp()]

    def dragged(self, event: PointerEvent, size: Size) -> Sequence[Outcome]:
        """Return what a move means, or the release."""
        raise NotImplementedError


@dataclass(frozen=True)
class SliderDrag(PointerDrag):
    """A slider's knob follows the pointer; the value counts when the button is let go."""

    bar: SliderBar
    line: str = ""

    def dragged(self, event: PointerEvent, size: Size) -> Sequence[Outcome]:
        """Preview while moving, run on release."""
        line = slider_line(self.bar, event.x)
        if event.kind == "release":
            return [Pop(), Run(line)]
        return [Become(replace(self, line=line)), Preview(line)]


@dataclass(frozen=True)
class TimeLineDrag(PointerDrag):
    """The playhead follows the pointer along the time line, and stays where it is let go."""

    line: TimeLine

    def dragged(self, event: PointerEvent, size: Size) -> Sequence[Outcome]:
        """Show the frame while moving, go there on release."""
        frame = self.line.frame_at(event.x)
        return [Scrub(frame)] if event.kind == "move" else [Pop(), Scrub(frame), Run("pause")]


def slider_line(bar: SliderBar, x: float) -> str:
    """Return the command line that a pointer at ``x`` on a slider means."""
    share = (x - bar.rectangle.x) / max(bar.rectangle.width, 1)
    raw = bar.low + min(max(share, 0.0), 1.0) * (bar.high - bar.low)
    steps = round((raw - bar.low) / bar.step)
    return f"{bar.command} {min(bar.low + steps * bar.step, bar.high):g}"


@dataclass(frozen=True)
class DialDrag(PointerDrag):
    """A joint's dial is turned; the figure follows, and the angles count when the button is let go.

    Under locks the way matters, because the rest of the figure follows: there it counts where the figure arrived.
    """

    dial: JointBall | JointCircle
    locked: bool = False

    def dragged(self, event: PointerEvent, size: Size) -> Sequence[Outcome]:
        """Preview while moving, run on release."""
        line = dial_line(self.dial, event.x, event.y)
        follow = Continue(line) if self.locked else Preview(line)
        if event.kind == "move":
            return [follow]
        return [follow, Pop(), Settle(split_limb(line))] if self.locked else [Pop(), Run(line)]


def split_limb(line: str) -> str:
    """Return the limb that a dial's command line names."""
    parts = split_line(line)
    return parts.words[0] if parts else ""


def dial_line(dial: JointBall | JointCircle, x: float, y: float) -> str:
    """Return the command line that a pointer on a joint's dial means."""
    return ball_line(dial, x, y) if isinstance(dial, JointBall) else circle_line(dial, x, y)


@dataclass(frozen=True)
class GoalDrag(PointerDrag):
    """The end of a limb is dragged in the plane through it that faces the viewer; let go unmoved it is a click.

    ``tip`` is where the end was shown at first, in pixels and depth: the pointer keeps its distance from it.
    """

    pane: Pane
    start: tuple[float, float]
    click: str
    limb: str
    tip: tuple[float, float, float]
    moved: bool = False

    def dragged(self, event: PointerEvent, size: Size) -> Sequence[Outcome]:
        """Follow while moving, settle on release."""
        moved = self.moved or _far(self.start, event, size)
        if not moved:
            return [Pop(), Run(self.click)] if event.kind == "release" else []
        x, y = self.tip[0] + event.x - self.start[0], self.tip[1] + event.y - self.start[1]
        where = f"{self.pane.shot} {x:.2f} {y:.2f} {self.tip[2]:.4f}"
        follow = Continue(join_line("follow", [self.limb, *where.split()]))
        if event.kind == "release":
            return [follow, Pop(), Settle(self.limb)]
        return [Become(replace(self, moved=True)), follow]


@dataclass(frozen=True)
class OrbitDrag(PointerDrag):
    """The figure is grabbed and turned on the virtual ball; a press let go without moving runs ``click``."""

    pane: Pane
    start: tuple[float, float]
    camera: Camera
    click: str = ""
    moved: bool = False

    def given_up(self) -> Sequence[Outcome]:
        """Turn the view back."""
        return [Run(camera_line(self.camera))]

    def dragged(self, event: PointerEvent, size: Size) -> Sequence[Outcome]:
        """Turn while moving."""
        moved = self.moved or _far(self.start, event, size)
        turn = [Run(camera_line(self._turned(event)))] if moved else []
        if event.kind == "release":
            return [Pop(), *turn] if moved or not self.click else [Pop(), Run(self.click)]
        return [Become(replace(self, moved=moved)), *turn]

    def _turned(self, event: PointerEvent) -> Camera:
        return self.camera.turned(ball_point(self.pane, *self.start), ball_point(self.pane, event.x, event.y))


def ball_point(pane: Pane, x: float, y: float) -> tuple[float, float]:
    """Return a pointer position in units of the virtual ball's radius from the pane's centre, y up."""
    left, top, width, height = pane.rectangle
    radius = min(width, height) / 2
    return ((x - left - width / 2) / radius, -(y - top - height / 2) / radius)


def camera_line(camera: Camera) -> str:
    """Return the command line that sets a camera."""
    return join_line("camera", [*(f"{value:.9g}" for row in camera.rotation for value in row), f"{camera.zoom:.4g}"])


@dataclass(frozen=True)
class BandDrag(PointerDrag):
    """A press on a view: let go at once it is a click, dragged it is a rectangle over limbs.

    ``band`` is the command that gets the view and the rectangle; ``click`` runs where the pointer did not move.
    """

    pane: Pane
    start: tuple[float, float]
    click: str
    band: str
    now: tuple[float, float] | None = None

    def given_up(self) -> Sequence[Outcome]:
        """Nothing was done yet."""
        return []

    def dragged(self, event: PointerEvent, size: Size) -> Sequence[Outcome]:
        """Grow the rectangle while moving, take what is inside on release."""
        moved = self.now is not None or _far(self.start, event, size)
        grown = replace(self, now=(event.x, event.y) if moved else None)
        if event.kind == "move":
            return [Become(grown)]
        if not moved:
            return [Pop(), *([Run(self.click)] if self.click else [])]
        box = grown.rectangle()
        where = f"{self.pane.candidate} {self.pane.view} {box.x} {box.y} {box.width} {box.height}"
        return [Pop(), *([Run(f"{self.band} {where}")] if self.band else [])]

    def rectangle(self) -> Rectangle:
        """Return the rubber band in surface pixels, kept within the pane."""
        left, top, width, height = self.pane.rectangle
        (x1, y1), (x2, y2) = self.start, self.now or self.start
        low_x, high_x = max(min(x1, x2), left), min(max(x1, x2), left + width)
        low_y, high_y = max(min(y1, y2), top), min(max(y1, y2), top + height)
        return Rectangle(round(low_x), round(low_y), round(high_x - low_x), round(high_y - low_y))

    def outlines(self) -> tuple[Outline, ...]:
        """Return the rubber band once it is one."""
        return (Outline(self.rectangle(), "band"),) if self.now is not None else ()


def _far(start: tuple[float, float], event: PointerEvent, size: Size) -> bool:
    slack = metrics(size).slack
    return abs(event.x - start[0]) > slack or abs(event.y - start[1]) > slack
