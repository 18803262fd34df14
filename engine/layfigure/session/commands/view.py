"""Commands that steer the picture; none of them touches the document."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from layfigure.drawing.camera import Camera, as_matrix, fixed_view
from layfigure.drawing.render_list import LOOKS
from layfigure.drawing.theme import theme_names
from layfigure.errors import ImpossibleError
from layfigure.plugins.records import Command
from layfigure.session.layout import three_views
from layfigure.session.modes import Plain
from layfigure.session.words import no_more, number, one_of, required, switched

if TYPE_CHECKING:
    from layfigure.session.session import Session

VIEWS = ("main", "right", "top")
SEEN = {"main": "in the main view", "right": "from the right", "top": "from the top"}


class OrbitMode(Plain):
    """Dragging and arrows turn the view until V or Esc."""

    @property
    def state(self) -> str:
        """The name keymaps know it by."""
        return "orbit"


def _view(session: Session, words: tuple[str, ...]) -> None:
    name = required(words, 0, "a view")
    no_more(words, 1)
    session.view = replace(session.view, camera=fixed_view(name))


def _orbit(session: Session, words: tuple[str, ...]) -> None:
    across = np.radians(number(words, 0, "degrees to the right"))
    upward = np.radians(number(words, 1, "degrees upward"))
    no_more(words, 2)
    rotation = np.array(session.view.camera.rotation)
    about_world_up = np.array([[np.cos(across), 0, -np.sin(across)], [0, 1, 0], [np.sin(across), 0, np.cos(across)]])
    about_screen = np.array([[1, 0, 0], [0, np.cos(upward), np.sin(upward)], [0, -np.sin(upward), np.cos(upward)]])
    turned = as_matrix(about_screen @ rotation @ about_world_up)
    session.view = replace(session.view, camera=Camera(turned, session.view.camera.zoom))


def _camera(session: Session, words: tuple[str, ...]) -> None:
    values = [number(words, index, "a number of the rotation") for index in range(9)]
    zoom = number(words, 9, "the zoom")
    no_more(words, 10)
    session.view = replace(session.view, camera=Camera(as_matrix(np.reshape(values, (3, 3))), min(max(zoom, 0.1), 20)))


def _zoom(session: Session, words: tuple[str, ...]) -> None:
    factor = number(words, 0, "a factor")
    no_more(words, 1)
    zoom = min(max(session.view.camera.zoom * factor, 0.25), 8.0)
    session.view = replace(session.view, camera=replace(session.view.camera, zoom=zoom))


def _orbit_mode(session: Session, words: tuple[str, ...]) -> None:
    no_more(words, 0)
    session.modes.append(OrbitMode())
    session.say("Turning the view: drag or use the arrows; V or Esc ends it.")


def _renderer(session: Session, words: tuple[str, ...]) -> None:
    identifier = one_of(words, 0, "renderer", session.host.renderers)
    no_more(words, 1)
    session.view = replace(session.view, renderer=identifier)


def _look(session: Session, words: tuple[str, ...]) -> None:
    name = one_of(words, 0, "look", LOOKS)
    no_more(words, 1)
    session.view = replace(session.view, look=LOOKS[name])


def _theme(session: Session, words: tuple[str, ...]) -> None:
    name = one_of(words, 0, "theme", theme_names())
    no_more(words, 1)
    session.view = replace(session.view, theme=name)


def _overlay(session: Session, words: tuple[str, ...]) -> None:
    name = one_of(words, 0, "overlay", session.host.overlays)
    no_more(words, 1)
    session.view = replace(session.view, overlays=session.view.overlays ^ {name})


def _skeleton(session: Session, words: tuple[str, ...]) -> None:
    on = switched(words, lambda: session.view.skeleton)
    session.view = replace(session.view, skeleton=on)
    session.say("The skeleton: drag a rectangle to let limbs change, with Shift to keep them." if on else "")


def _next_view(session: Session, words: tuple[str, ...]) -> None:
    no_more(words, 0)
    if three_views(session.stage.size):
        raise ImpossibleError("every pose is shown from three sides already")
    shown = VIEWS[(VIEWS.index(session.view.shown) + 1) % len(VIEWS)]
    session.view = replace(session.view, shown=shown, hover=None)
    session.say(f"Every pose is shown {SEEN[shown]}.")


def _frame(session: Session, words: tuple[str, ...]) -> None:
    no_more(words, 0)
    x, y, z = session.document.pose.translation.tolist()
    session.view = replace(session.view, anchor=(x, y, z), camera=replace(session.view.camera, zoom=1.0))


COMMANDS = (
    Command("skeleton", "Show the skeleton and where limbs can go", _skeleton, "[on|off]", passive=True),
    Command("frame", "Bring the figure to the middle of the views", _frame, passive=True),
    Command("next-view", "Show every pose from the next side", _next_view, passive=True),
    Command("view", "Go to a fixed view", _view, "front|right|left|back|top", passive=True),
    Command("orbit", "Turn the view by degrees", _orbit, "ACROSS UPWARD", passive=True),
    Command("camera", "Set the camera", _camera, "R11…R33 ZOOM", passive=True),
    Command("zoom", "Zoom by a factor", _zoom, "FACTOR", passive=True),
    Command("orbit-mode", "Turn the view by dragging or arrows", _orbit_mode, passive=True),
    Command("renderer", "Draw with another renderer", _renderer, "RENDERER", passive=True),
    Command("look", "Choose how much care a picture takes", _look, "plain|smooth|full", passive=True),
    Command("overlay", "Show or hide a plug-in's overlay", _overlay, "OVERLAY", passive=True),
    Command("theme", "Change the colours of the window", _theme, "THEME", passive=True),
)
