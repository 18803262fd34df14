"""What the terminal shows: paints frames, sends them no faster than they are drawn, knows when one is due."""

from __future__ import annotations

import os
import time
from pathlib import Path
from typing import TYPE_CHECKING

from layfigure.drawing.render_list import Rectangle
from layfigure.errors import LayfigureError
from layfigure.session.frame import Frame, Size
from layfigure_frontends.terminal.app import small
from layfigure_frontends.terminal.cells import Grid
from layfigure_frontends.terminal.depth import Abilities, Depth, Picture
from layfigure_frontends.terminal.encoder import CellEncoder
from layfigure_frontends.terminal.fence import Fence
from layfigure_frontends.terminal.painter import Painted, paint
from layfigure_frontends.terminal.paper import ROW
from layfigure_frontends.terminal.sharp import SharpViews

if TYPE_CHECKING:
    from layfigure_frontends.door import Door
    from layfigure_frontends.terminal.app import TerminalOptions
    from layfigure_frontends.terminal.driver import Driver


class Screen:
    """One terminal's screen, behind a fence."""

    def __init__(self, terminal: Driver, session: Door, depth: Depth, options: TerminalOptions) -> None:
        """Begin with nothing shown, at a colour depth."""
        self._terminal = terminal
        self._session = session
        self._fence = Fence(depth)
        self._encoder = CellEncoder(depth)
        self._pace = 1.0 / max(options.fps, 1.0)
        self._sent_at = 0.0
        self._urgent = False
        self._graphics, self._best = options.graphics, depth
        self._sharp: SharpViews | None = None
        self._sharp_now = False
        self._size = terminal.size()
        self._painted: Painted | None = None
        self._shown: tuple[object, ...] | None = None
        self.typing = False

    def probe(self, now: float) -> bytes:
        """Return the question whose answer tells how long a round trip takes."""
        return self._fence.probe(now)

    def abilities(self, abilities: Abilities) -> None:
        """Take in what the terminal can do; sharp pictures take the place of half blocks where it shows them."""
        self._encoder.synchronised = abilities.synchronised
        kind, cell = abilities.picture(os.environ, self._graphics), abilities.cell_pixels
        if kind == Picture.CELLS or cell is None:
            return
        if self._sharp is None or (self._sharp.kind, self._sharp.cell) != (kind, cell):
            self._sharp = SharpViews(kind, cell, abilities.sixel_colours)
            self._shown = None

    def answered(self, now: float) -> None:
        """Hear that the terminal has drawn a frame."""
        self._fence.answered(now)

    def hurry(self) -> None:
        """Let the next frame not wait for its turn: it answers a key."""
        self._urgent = True

    def speed_up(self) -> None:
        """Use machine code from now on."""
        self._encoder.speed_up()

    def begin_anew(self) -> None:
        """Take it that the terminal's size may have changed, and that nothing is left of what it showed."""
        self._size = self._terminal.size()
        if self._sharp is not None:
            self._terminal.write(self._sharp.forget())
        self._encoder.forget()
        self._shown = None
        self._urgent = True

    def seconds_left(self, now: float, *, pending: bool) -> float | None:
        """Return how long to wait before something is to be shown, None where nothing is; ``pending``: soon will be."""
        if self._terminal.unwritten or not (pending or self._stale()):
            return None
        return self._wait(now)

    def ready(self, now: float) -> bool:
        """Whether a frame may be sent now."""
        return not self._terminal.unwritten and self._wait(now) <= 0.0

    def show(self, now: float, *, urgent: bool = False) -> None:
        """Paint and send what the session looks like, if the terminal shows something else."""
        self._urgent |= urgent
        if not self._stale():
            return
        self._shown = self._state()
        self._encoder.depth = self._fence.quality.depth
        grid, cursor, pictures = self._paint()
        data = self._encoder.encode(grid, cursor) + pictures
        self._urgent = False
        if data:
            self._sent_at = time.monotonic()
            self._terminal.write(data + self._fence.sent(len(data), self._sent_at))

    def save(self, path: Path) -> None:
        """Save the picture behind the text; what goes wrong is said in the status line."""
        from layfigure_frontends.terminal.screenshots import save_screenshot

        if self._painted is None:
            return
        try:
            save_screenshot(self._painted.pixels, path)
        except LayfigureError as error:
            self._session.say(str(error))
            self._shown = None

    def _wait(self, now: float) -> float:
        pace = 0.0 if self._urgent else self._sent_at + self._pace - now
        return max(self._fence.seconds_left(now, urgent=self._urgent), pace)

    def _state(self) -> tuple[object, ...]:
        return self._session.revision, self._size, self._fence.quality.depth

    def _stale(self) -> bool:
        return self._state() != self._shown

    def _paint(self) -> tuple[Grid, tuple[int, int], bytes]:
        sentence = small(self._size)
        if sentence:
            blank = Grid(self._size.columns, self._size.rows)
            pictures = self._sharpen(None)
            return _sentence(sentence, blank), (0, 0), pictures
        frame = self._session.frame(Size(self._size.columns, self._size.rows * ROW, cells=True))
        self.typing = frame.text_input
        self._painted = paint(frame, self._session, self._encoder.depth)
        return self._painted.grid, self._painted.cursor, self._sharpen(frame)

    def _sharpen(self, frame: Frame | None) -> bytes:
        """Return the bytes of pictures over the cells; under a dialog and on a slow link there are none."""
        if self._sharp is None:
            return b""
        banding = frame is not None and any(outline.role == "band" for outline in frame.outlines)
        usable = frame is not None and frame.overlay is None and not banding
        if frame is None or self._painted is None or not usable or self._fence.quality.depth != self._best:
            if self._sharp_now:
                self._sharp_now = False
                self._encoder.forget()
                return self._sharp.forget()
            return b""
        gone = b""
        if self._sharp.misplaced(frame):
            self._encoder.forget()
            gone = self._sharp.forget()
        self._sharp_now = True
        return gone + self._sharp.draw(frame, self._session, self._painted.grid)


def _sentence(text: str, grid: Grid) -> Grid:
    """Return a blank screen with a sentence on it, broken where it must be."""
    from layfigure_frontends.terminal.paper import wrapped

    grid.fill(Rectangle(0, 0, grid.columns, grid.rows))
    for row, line in enumerate(wrapped(text[:1].upper() + text[1:], max(grid.columns, 1))):
        grid.write(0, row, line)
    return grid
