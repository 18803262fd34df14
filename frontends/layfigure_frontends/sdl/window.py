"""The window: opened and painted before anything heavy is imported, then lent out as a surface."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path

import pygame

from layfigure import resources
from layfigure.errors import LayfigureError

SIZE = (1280, 800)
SMALLEST = (640, 400)
SENTINEL = "LAYFIGURE_SENTINEL"
BACKGROUND = (21, 24, 29)
FOREGROUND = (95, 105, 120)


@dataclass(frozen=True)
class WindowOptions:
    """How the window opens: pixels per layout unit on top of the screen's own scale, and its size in window units."""

    scale: float | None = None
    size: tuple[int, int] | None = None


def require_pygame_ce() -> None:
    """Check that ``import pygame`` gave pygame-ce.

    Raises:
        LayfigureError: it gave the older pygame, which shares the name.
    """
    if not getattr(pygame, "IS_CE", False):
        raise LayfigureError(
            "the older pygame stands in the place of pygame-ce;"
            " run: pip uninstall -y pygame pygame-ce && pip install pygame-ce"
        )


class Window:
    """A resizable window. Positions of the pointer are in window units: multiply by ``ratio`` for surface pixels."""

    def __init__(self, options: WindowOptions) -> None:
        """Open the window and paint it at once.

        Raises:
            LayfigureError: no window can be opened here.
        """
        require_pygame_ce()
        self._asked_scale = options.scale or 1.0
        self._sentinel = os.environ.get(SENTINEL)
        self._flips = 0
        self.typing = True  # SDL begins with text input on; the first frame decides
        self._cursor = ""
        try:
            pygame.display.init()
            pygame.font.init()
            self._window = pygame.Window(
                "Layfigure", options.size or self._usual_size(), resizable=True, allow_high_dpi=True
            )
            self.surface = self._window.get_surface()
        except pygame.error as error:
            pygame.display.quit()
            raise LayfigureError(f"no window can be opened here ({error}); try --frontend headless") from None
        self.set_typing(on=False)
        self._window.set_icon(_icon())
        self._paint_first()
        self._window.minimum_size = self._smallest()

    @property
    def ratio(self) -> float:
        """Surface pixels per window unit: 2 on most high-density screens."""
        return float(self.surface.get_width() / max(self._window.size[0], 1))

    @property
    def scale(self) -> float:
        """Surface pixels per layout unit."""
        return self.ratio * self._asked_scale

    def renew_surface(self) -> None:
        """Take the surface anew, which a resize has replaced."""
        self.surface = self._window.get_surface()

    def flip(self, state: str) -> None:
        """Show what is painted. ``state`` is a word for those who wait for the window to get somewhere."""
        self._window.flip()
        self._flips += 1
        if self._sentinel:
            _tell(Path(self._sentinel), f"{self._flips} {state}\n")

    def set_title(self, title: str) -> None:
        """Name the window."""
        if self._window.title != title:
            self._window.title = title

    def set_cursor(self, name: str) -> None:
        """Show a cursor: ``arrow``, ``hand``, ``grab`` or ``cross``."""
        if name != self._cursor:
            self._cursor = name
            with suppress(pygame.error):  # some video drivers have no cursors
                pygame.mouse.set_cursor(CURSORS.get(name, pygame.SYSTEM_CURSOR_ARROW))

    def set_typing(self, *, on: bool) -> None:
        """Switch text input; while it is on an input method may swallow command keys, so only while text is typed."""
        if on != self.typing:
            self.typing = on
            (pygame.key.start_text_input if on else pygame.key.stop_text_input)()

    def close(self) -> None:
        """Close the window and pygame's display and fonts."""
        self._window.destroy()
        pygame.font.quit()
        pygame.display.quit()

    def _usual_size(self) -> tuple[int, int]:
        """The usual size in layout units, as far as the screen holds it with a little room around."""
        wide, high = pygame.display.get_desktop_sizes()[0]
        scale = self._asked_scale
        return min(round(SIZE[0] * scale), wide * 19 // 20), min(round(SIZE[1] * scale), high * 9 // 10)

    def _smallest(self) -> tuple[int, int]:
        now = self._window.size
        return min(round(SMALLEST[0] * self._asked_scale), now[0]), min(round(SMALLEST[1] * self._asked_scale), now[1])

    def _paint_first(self) -> None:
        """Paint the ground and the name, before the session exists."""
        self.surface.fill(BACKGROUND)
        text = _title_font(round(28 * self.scale)).render("Layfigure", True, FOREGROUND)
        place = text.get_rect(center=self.surface.get_rect().center)
        self.surface.blit(text, place)
        self.flip("opening")


CURSORS = {
    "arrow": pygame.SYSTEM_CURSOR_ARROW,
    "hand": pygame.SYSTEM_CURSOR_HAND,
    "grab": pygame.SYSTEM_CURSOR_SIZEALL,
    "cross": pygame.SYSTEM_CURSOR_CROSSHAIR,
}


@contextmanager
def opened(options: WindowOptions) -> Iterator[Window]:
    """Open a window and close it whatever happens."""
    window = Window(options)
    try:
        yield window
    finally:
        window.close()


def _title_font(pixels: int) -> pygame.font.Font:
    return pygame.font.Font(resources.data("fonts", "Inter-SemiBold.otf"), pixels)


def _icon() -> pygame.Surface:
    """A small lay figure: a head, a body and four limbs on a dark tile."""
    icon = pygame.Surface((64, 64), pygame.SRCALPHA)
    pygame.draw.rect(icon, BACKGROUND, icon.get_rect(), border_radius=14)
    skin = (108, 184, 255)
    pygame.draw.aacircle(icon, skin, (32, 15), 7)
    for begin, end in (
        ((32, 24), (32, 38)),
        ((32, 26), (16, 20)),
        ((32, 26), (49, 31)),
        ((32, 38), (22, 54)),
        ((32, 38), (45, 53)),
    ):
        pygame.draw.line(icon, skin, begin, end, 5)
        pygame.draw.aacircle(icon, skin, end, 3)
    return icon


def _tell(path: Path, line: str) -> None:
    """Replace a small file at once, so that a reader never sees half a line."""
    beside = path.with_name(path.name + ".part")
    beside.write_text(line, encoding="utf-8")
    beside.replace(path)
