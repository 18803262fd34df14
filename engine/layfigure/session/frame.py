"""What a front end gets back: where to draw which view, which widgets, and what stands on top.

All coordinates are surface pixels (half-block pixels in a terminal: a cell is one wide and two high). A front end
draws ``shots`` through the session, then paints the widgets in order, then the marks, then the overlay. It decides
nothing.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import NamedTuple

from layfigure.drawing.render_list import Rectangle


class Size(NamedTuple):
    """A surface: width and height in pixels and ``scale`` pixels per layout unit (2.0 on a high-density screen).

    ``cells``: it is a terminal of ``width`` columns and ``height / 2`` rows, laid out for text.
    """

    width: int
    height: int
    scale: float = 1.0
    cells: bool = False


@dataclass(frozen=True)
class Pane:
    """One view on the surface. ``candidate`` is 0-based, -1 for the working pose, -2 for its skeleton.

    ``view`` is ``main``, ``right`` or ``top``. ``shot`` indexes the frame's shots.
    """

    candidate: int
    view: str
    rectangle: Rectangle
    shot: int


@dataclass(frozen=True)
class Label:
    """A line of text. ``role``: ``title``, ``text``, ``small``, ``number`` (a candidate's badge), ``status``,
    ``warning``, ``key`` (drawn as a key cap). ``align``: ``left``, ``centre``, ``right``."""

    rectangle: Rectangle
    text: str
    role: str = "text"
    align: str = "left"


@dataclass(frozen=True)
class Button:
    """Runs ``command`` when clicked. ``key`` is shown beside the text; ``active`` draws it pressed."""

    rectangle: Rectangle
    text: str
    command: str
    key: str = ""
    active: bool = False
    enabled: bool = True


@dataclass(frozen=True)
class SliderBar:
    """A number between low and high; clicking or dragging runs ``command`` with the value appended.

    ``limits``: low and high are worth saying, as a joint's are.
    """

    rectangle: Rectangle
    text: str
    command: str
    value: float
    low: float
    high: float
    step: float
    key: str = ""
    unit: str = ""
    limits: bool = False


@dataclass(frozen=True)
class ChoiceBar:
    """Options side by side; clicking one runs ``command`` with its value appended. ``options`` = (value, label)."""

    rectangle: Rectangle
    text: str
    command: str
    options: tuple[tuple[str, str], ...]
    value: str
    key: str = ""

    def edges(self) -> tuple[float, ...]:
        """Return where the options begin and end as shares of the width: longer labels get more room."""
        weights = [len(label) + 3 for _, label in self.options]
        return tuple(sum(weights[:count]) / max(sum(weights), 1) for count in range(len(weights) + 1))


@dataclass(frozen=True)
class JointBall:
    """Flexion and pivot of a joint as a ball seen along its rest direction; dragging on it runs ``command``.

    A point (x right, y up) of the unit disc is (sin p/2, sin f/2): the half vector as it looks from the front (thesis
    V.2). ``angles`` are flexion, pivot, twist in degrees; ``low`` and ``high`` (flexion, pivot) bound what is allowed.
    The command gets three angles appended.
    """

    rectangle: Rectangle
    text: str
    command: str
    angles: tuple[float, float, float]
    low: tuple[float, float]
    high: tuple[float, float]


@dataclass(frozen=True)
class JointCircle:
    """One degree of freedom of a joint as a circle: 0 at the top, +-180 at the bottom.

    ``column`` says which of ``angles`` (flexion, pivot, twist or x, y, z in degrees) it turns; -1 is an empty circle,
    for a joint without. ``low`` and ``high`` bound what is allowed. ``sense`` is 1 where clockwise is positive or -1.
    """

    rectangle: Rectangle
    text: str
    command: str
    angles: tuple[float, float, float]
    column: int
    low: float = 0.0
    high: float = 0.0
    sense: int = 1


@dataclass(frozen=True)
class TimeLine:
    """A motion's frames from left to right; pressing or dragging along the track goes to the frame under the pointer.

    The ``rectangle`` is the strip it stands in, with room for other widgets at the left. ``track`` is where frames lie:
    0 in the middle of its first pixel, ``last`` in that of its last; the motion ends at ``end``, which lies before
    ``last`` where the ``playhead`` has been taken beyond. ``keys`` are the frames of keys of the selected limbs, or of
    any; ``others`` those of the rest. ``marks`` are (frame, name). ``spoken`` is the playhead as it is written. A
    number is worth writing at every so many frames as ``every`` says, 0 where there is no room for numbers.
    """

    rectangle: Rectangle
    track: Rectangle
    last: float
    end: float
    playhead: float
    spoken: str
    keys: tuple[float, ...] = ()
    others: tuple[float, ...] = ()
    marks: tuple[tuple[float, str], ...] = ()
    every: int = 0
    playing: bool = False

    def x_of(self, frame: float) -> float:
        """Return where a frame lies across the surface."""
        return self.track.x + 0.5 + frame / self.last * (self.track.width - 1)

    def frame_at(self, x: float) -> int:
        """Return the whole frame that lies nearest to a place across the surface."""
        share = (x - 0.5 - self.track.x) / max(self.track.width - 1, 1)
        return round(min(max(share, 0.0), 1.0) * self.last)


Widget = Label | Button | SliderBar | ChoiceBar | JointBall | JointCircle | TimeLine


@dataclass(frozen=True)
class Outline:
    """A box drawn round something. ``role``: ``chosen`` (the candidate keys act on), ``hover``, ``band`` (a dragged
    selection rectangle), ``focus`` (the view that is orbited), ``pane`` (a quiet frame)."""

    rectangle: Rectangle
    role: str


@dataclass(frozen=True)
class HelpOverlay:
    """A modal page: sections of (title, ((key, what it does), ...)). ``scroll`` is the first line shown.

    Where ``keys`` is false the rows begin with amounts rather than keys, to be written and not drawn as key caps.
    ``spoken`` is the page as lines that stand alone, for front ends that say it; where empty the rows serve.
    """

    title: str
    sections: tuple[tuple[str, tuple[tuple[str, str], ...]], ...]
    scroll: int = 0
    keys: bool = True
    spoken: tuple[str, ...] = ()


@dataclass(frozen=True)
class PaletteOverlay:
    """Modal command palette: the text typed so far, matching (command, title, key) rows, and the chosen row."""

    prompt: str
    text: str
    rows: tuple[tuple[str, str, str], ...]
    chosen: int
    message: str = ""


@dataclass(frozen=True)
class QuestionOverlay:
    """A modal question: a sentence and buttons as (text, key, command)."""

    text: str
    answers: tuple[tuple[str, str, str], ...]


ModalOverlay = HelpOverlay | PaletteOverlay | QuestionOverlay


@dataclass(frozen=True)
class WorldLine:
    """A line over a view in surface pixels, clipped to ``clip``. ``role`` is one of
    :data:`layfigure.drawing.marks.ROLES`, drawn in the theme's colour for it, or empty, drawn in ``rgb``."""

    x1: float
    y1: float
    x2: float
    y2: float
    clip: Rectangle
    rgb: tuple[int, int, int] = (255, 255, 255)
    role: str = ""


@dataclass(frozen=True)
class Sign:
    """A small sign over a view at a point in surface pixels; its ``role`` decides shape and colour."""

    x: float
    y: float
    role: str
    clip: Rectangle


@dataclass(frozen=True)
class Frame:
    """Everything to show on a surface of ``size``. ``cursor`` is ``arrow``, ``hand``, ``grab`` or ``cross``.

    Two frames with the same ``page`` have views of candidates that look the same, so that one that is painted over the
    other may leave them as they are.
    """

    size: Size
    panes: tuple[Pane, ...]
    widgets: tuple[Widget, ...]
    outlines: tuple[Outline, ...] = ()
    lines: tuple[WorldLine, ...] = ()
    signs: tuple[Sign, ...] = ()
    overlay: ModalOverlay | None = None
    status: str = ""
    hints: tuple[tuple[str, str], ...] = ()
    cursor: str = "arrow"
    title: str = "Layfigure"
    text_input: bool = False
    theme: str = field(default="dark")
    page: int = 0
