"""Shows the animation with Textual, as strips of styled half blocks."""

from __future__ import annotations

from functools import lru_cache

from rich.segment import Segment
from rich.style import Style
from textual import events
from textual.app import App, ComposeResult
from textual.strip import Strip
from textual.widget import Widget

from layfigure_frontends.bench.terminals.scene import FRAMES, PER_SECOND, ROWS, asked

PICTURES, PERFORMANCE = asked()


@lru_cache(maxsize=65536)
def _style(upper: int, lower: int) -> Style:
    return Style.parse(f"#{upper:06x} on #{lower:06x}")


class Picture(Widget):
    """The animation and the line below it."""

    def render_line(self, y: int) -> Strip:
        """Return one line of cells."""
        if y >= ROWS:
            return Strip([Segment(PERFORMANCE.line if y == ROWS else "")])
        picture = PICTURES[PERFORMANCE.due() % FRAMES]
        upper, lower = picture[2 * y].tolist(), picture[2 * y + 1].tolist()
        return Strip([Segment("▀", _style(*colours)) for colours in zip(upper, lower, strict=True)])


class Player(App[None]):
    """Plays until the time is up."""

    CSS = "Picture { width: 100%; height: 100%; }"

    def compose(self) -> ComposeResult:
        """Show the picture alone."""
        yield Picture()

    def on_mount(self) -> None:
        """Begin."""
        PERFORMANCE.begin()
        self.set_interval(1 / PER_SECOND, self._next)

    def _next(self) -> None:
        PERFORMANCE.frames += 1
        self.query_one(Picture).refresh()
        if PERFORMANCE.over:
            PERFORMANCE.end()
            self.exit()

    def on_key(self, event: events.Key) -> None:
        """Answer a key."""
        PERFORMANCE.letter = event.key
        self.query_one(Picture).refresh()


if __name__ == "__main__":
    Player().run()
