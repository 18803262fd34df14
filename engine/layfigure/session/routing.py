"""Takes an event to where it belongs: the interface state on top, the widgets, the views, the keymap."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from typing import TYPE_CHECKING

from layfigure.errors import ImpossibleError
from layfigure.session.events import DropEvent, Event, KeyEvent, PointerEvent
from layfigure.session.frame import Button, ChoiceBar, JointBall, JointCircle, Pane, SliderBar, TimeLine, Widget
from layfigure.session.gestures import (
    BandDrag,
    DialDrag,
    GoalDrag,
    OrbitDrag,
    SliderDrag,
    TimeLineDrag,
    camera_line,
    dial_line,
    slider_line,
)
from layfigure.session.modes import (
    Become,
    Continue,
    GiveUp,
    Hover,
    Outcome,
    Pop,
    Preview,
    Push,
    Run,
    Scrub,
    Settle,
)
from layfigure.session.stage import SKELETON
from layfigure.session.words import join_line

if TYPE_CHECKING:
    from layfigure.session.session import Session

LEFT, RIGHT = 1, 3
BESIDE = 8  # layout units left of the first frame that are the first frame's


def route(session: Session, event: Event) -> None:
    """Let the state on top hear an event, else decide by the keymap or by what is under the pointer."""
    outcomes = session.mode.hear(event, session.stage.size)
    if outcomes is None:
        outcomes = _default(session, event)
    for outcome in outcomes:
        happen(session, outcome)


def happen(session: Session, outcome: Outcome) -> None:
    """Make one outcome true."""
    match outcome:
        case Push(mode):
            session.modes.append(mode)
        case Pop():
            if len(session.modes) > 1:
                session.modes.pop()
        case Become(mode):
            session.modes[-1] = mode
        case Run(line):
            session.execute(line)
        case Preview(line):
            session.preview.show(line)
        case Continue(line):
            _go_on(session, line)
        case Settle(limb):
            session.preview.settle(limb)
        case GiveUp():
            session.preview.give_up()
            session.playback.give_up()
        case Scrub(frame):
            session.playback.scrub(Fraction(frame))
        case Hover(over):
            session.view = replace(session.view, hover=over)


def _go_on(session: Session, line: str) -> None:
    """Take a drag's next step; one that cannot be done leaves the figure at the last that could."""
    try:
        session.preview.show(line, onward=True)
    except ImpossibleError as error:
        session.say(str(error))


def _default(session: Session, event: Event) -> Sequence[Outcome]:
    match event:
        case KeyEvent():
            line = _line_of(session, event)
            return [Run(line)] if line else []
        case DropEvent():
            return [Run(join_line("open", [event.path]))]
        case PointerEvent(pressed=True):
            return _pressed(session, event)
        case PointerEvent(kind="move"):
            return [Hover(_over(session, event))]
        case PointerEvent(kind="wheel"):
            return _wheel(session, event)
    return []


def _line_of(session: Session, event: KeyEvent) -> str | None:
    """Return what a key means, else what the sign means that it types: ``(`` where nothing is on ``shift+9``."""
    table, now = session.key_table(), session.situation
    line = table.resolve(event.key, now)
    typed = "" if event.key.startswith(("ctrl+", "alt+")) or event.text.isalnum() else event.text
    return line or (table.resolve(typed, now) if typed else None)


def _pressed(session: Session, event: PointerEvent) -> Sequence[Outcome]:
    widget = session.stage.widget_at(event.x, event.y)
    if widget is not None:
        return _widget_pressed(session, widget, event) if event.button == LEFT else []
    pane = session.stage.pane_at(event.x, event.y)
    if pane is None:
        return []
    return _pane_pressed(session, pane, event)


def _widget_pressed(session: Session, widget: Widget, event: PointerEvent) -> Sequence[Outcome]:
    match widget:
        case Button(enabled=True):
            return [Run(widget.command)]
        case ChoiceBar(options=options):
            share = (event.x - widget.rectangle.x) / max(widget.rectangle.width, 1)
            chosen = sum(1 for edge in widget.edges()[1:-1] if share >= edge)
            return [Run(f"{widget.command} {options[chosen][0]}")]
        case SliderBar():
            line = slider_line(widget, event.x)
            return [Push(SliderDrag(widget, line)), Preview(line)]
        case TimeLine(track=track) if event.x >= track.x - BESIDE * session.stage.size.scale:
            return [Push(TimeLineDrag(widget)), Scrub(widget.frame_at(event.x))]
        case JointBall() | JointCircle() if not (isinstance(widget, JointCircle) and widget.column < 0):
            line = dial_line(widget, event.x, event.y)
            return [Push(DialDrag(widget, locked=bool(session.document.locks))), Preview(line)]
    return []


def _pane_pressed(session: Session, pane: Pane, event: PointerEvent) -> Sequence[Outcome]:
    start = (event.x, event.y)
    camera = session.view.camera
    limb = session.stage.limb_at(pane, event.x, event.y)
    if event.kind == "double" and event.ctrl and limb is None:
        return [Run("view front")]
    turning = session.mode.state == "orbit"
    vary = "twist" if event.ctrl else "swing" if event.shift else ""
    click = _click(session, pane, limb, vary)
    if pane.view == "main" and (event.button == RIGHT or event.ctrl or turning):
        return [Push(OrbitDrag(pane, start, camera, click if event.ctrl and not turning else ""))]
    if event.button != LEFT:
        return []
    if pane.candidate >= 0:
        return [Push(BandDrag(pane, start, click, f"pick-in {vary or 'plain'}"))]
    return [Push(_own_gesture(session, pane, event, click))]


def _own_gesture(session: Session, pane: Pane, event: PointerEvent, click: str) -> GoalDrag | BandDrag:
    """Return what a press on the working pose begins: a limb's end is dragged, or a rectangle enables limbs."""
    start = (event.x, event.y)
    if "goal" not in session.channels or pane.candidate == SKELETON:
        return BandDrag(pane, start, click, f"enable-in {'off' if event.shift else 'on'}")
    end = session.stage.end_at(pane, event.x, event.y)
    if end is None or event.shift:
        return BandDrag(pane, start, click, "enable-in only" if event.shift else "select-in")
    session.playback.settle()
    return GoalDrag(pane, start, click, session.document.figure.names[end], session.stage.tip_pixels(pane, end))


def _click(session: Session, pane: Pane, limb: int | None, vary: str) -> str:
    """Return the command line of a click on a view."""
    if limb is None:
        return f"choose {pane.candidate + 1}" if pane.candidate >= 0 else "select-none"
    name = session.document.figure.names[limb]
    if pane.candidate < 0:
        return join_line("select-more" if vary == "swing" else "select", [name])
    number = str(pane.candidate + 1)
    return join_line("vary", [number, vary, name]) if vary else join_line("pick", [number, name])


def _over(session: Session, event: PointerEvent) -> tuple[int, int] | None:
    if session.stage.widget_at(event.x, event.y) is not None:
        return None
    pane = session.stage.pane_at(event.x, event.y)
    limb = session.stage.limb_at(pane, event.x, event.y) if pane else None
    return (pane.candidate, limb) if pane is not None and limb is not None else None


def _wheel(session: Session, event: PointerEvent) -> Sequence[Outcome]:
    widget = session.stage.widget_at(event.x, event.y)
    if isinstance(widget, SliderBar):
        return [Run(f"{widget.command} {event.steps * widget.step:+g}")]
    if isinstance(widget, TimeLine):
        return [Run("step -1" if event.steps > 0 else "step 1")]
    if session.stage.pane_at(event.x, event.y) is None:
        return []
    camera = session.view.camera
    zoom = min(max(camera.zoom * 1.1**event.steps, 0.25), 8.0)
    return [Run(camera_line(replace(camera, zoom=zoom)))]
