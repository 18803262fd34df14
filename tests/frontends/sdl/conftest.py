"""A window without a screen, and a session that shows a hand-made frame and remembers what it heard."""

import os

os.environ["SDL_VIDEODRIVER"] = os.environ["SDL_VIDEO_DRIVER"] = "dummy"

from dataclasses import replace
from types import SimpleNamespace

import pygame
import pytest

import layfigure_frontends.sdl  # noqa: F401
from layfigure.drawing.render_list import Rectangle
from layfigure.session.frame import (
    Button,
    ChoiceBar,
    Frame,
    Label,
    Outline,
    Pane,
    Size,
    SliderBar,
)
from layfigure.session.layout import Column, areas, candidate_views, grid, poser_views
from layfigure_frontends.sdl import fonts

HINTS = (("1–9", "choose"), ("M", "mutate"), ("N", "next page"), ("F", "first page"), ("Ctrl-Z", "undo"), ("?", "keys"))


@pytest.fixture(autouse=True)
def display():
    """Pygame's display and fonts."""
    pygame.display.init()
    pygame.font.init()
    yield
    fonts.forget()
    pygame.font.quit()
    pygame.display.quit()


def views(size: Size) -> list[Pane]:
    place = areas(size, with_page=True)
    heading = round(26 * size.scale)
    below = place.poser._replace(y=place.poser.y + heading, height=place.poser.height - heading)
    panes = [Pane(-1, view, box, index) for index, (view, box) in enumerate(poser_views(below, 2))]
    for candidate, cell in enumerate(grid(9, place.page, round(8 * size.scale))):
        panes += [Pane(candidate, view, box, 0) for view, box in candidate_views(cell, 2)]
    return panes


def widgets(size: Size, panes: list[Pane]):
    place = areas(size, with_page=True)
    unit = size.scale
    for pane in panes:
        if pane.candidate >= 0 and pane.view == "main":
            side = round(26 * unit)
            box = Rectangle(pane.rectangle.x, pane.rectangle.y, side, side)
            yield Label(box, str(pane.candidate + 1), "number", "centre")
    yield Label(Rectangle(place.poser.x, place.poser.y, place.poser.width, round(20 * unit)), "humanoid", "title")
    column = Column(place.panel, unit)
    yield Label(column.row(18, 2), "left forearm: flexion 45°, pivot 0°, twist -12°")
    yield Label(column.row(18, 2), "limits -5 … 145, no pivot, -90 … 90", "small")
    yield ChoiceBar(column.row(48), "Technique", "use", (("generator", "Generator"), ("ga", "Genetic")), "generator")
    yield Label(column.row(22), "Generation 2, page 1 of 3", "title")
    yield SliderBar(column.row(44), "Mutation intensity", "intensity", 60, 0, 100, 5, "-  +", " %")
    options = (("swing", "Flexion & pivot"), ("twist", "Twist"))
    yield ChoiceBar(column.row(48), "What changes", "kind", options, "swing", "T")
    for pair in ((("Mutate", "M"), ("Next page", "N")), (("First page", "F"), ("Undo", "Ctrl-Z"))):
        for box, (text, key) in zip(column.split(2, 32), pair, strict=True):
            yield Button(box, text, text.lower(), key)
    if column.fits(32):
        boxes = column.split(2, 32)
        yield Button(boxes[0], "Initialise everything that can be", "initialise", "I", active=True)
        yield Button(boxes[1], "Redo", "redo", "Ctrl-Y", enabled=False)


def rich_frame(size: Size) -> Frame:
    panes = views(size)
    chosen = [pane.rectangle for pane in panes if pane.candidate == 4]
    box = pygame.Rect(chosen[0]).unionall([pygame.Rect(other) for other in chosen[1:]])
    return Frame(
        size=size,
        panes=tuple(panes),
        widgets=tuple(widgets(size, panes)),
        outlines=(Outline(Rectangle(*box), "chosen"),),
        status="Copied the left forearm from candidate 5 into the seed and all candidates.",
        hints=HINTS,
    )


class FakeSession:
    """Shows ``rich_frame`` with some fields replaced, fills the views grey, notes every event and command."""

    def __init__(self) -> None:
        self.running = True
        self.ticks: list[float] = []
        self.revision = 0
        self.clipboard_out = None
        self.screenshot_request = None
        self.host = SimpleNamespace(renderers={})
        self.changes: dict = {}
        self.heard: list = []
        self.ran: list[str] = []
        self.said: list[str] = []
        self.frames = 0
        self.pages: list[bool] = []
        self.playback = SimpleNamespace(ticking=False, due=None, tick=self.ticks.append)
        self.ready = False
        self.on_event = lambda event: None

    def handle(self, event) -> None:
        self.heard.append(event)
        self.revision += 1
        self.on_event(event)

    def frame(self, size: Size) -> Frame:
        self.frames += 1
        return replace(rich_frame(size), **self.changes)

    def draw(self, frame: Frame, target, *, page: bool = True) -> None:
        self.pages.append(page)
        for pane in frame.panes:
            x, y, width, height = pane.rectangle
            target.pixels[y : y + height, x : x + width] = 0x23272E

    def run(self, text: str) -> None:
        self.ran.append(text)
        if text == "quit":
            self.running = False

    def say(self, sentence: str) -> None:
        self.said.append(sentence)

    def kernels_ready(self) -> None:
        self.ready = True
        self.revision += 1

    def close(self, *, interrupted: bool = False) -> None:
        self.running = False


@pytest.fixture
def session() -> FakeSession:
    """A session that is only a stand-in."""
    return FakeSession()


@pytest.fixture
def frame_of():
    """The hand-made frame for a size, with fields replaced."""
    return lambda size, **changes: replace(rich_frame(size), **changes)
