"""The last line: what just happened, in words, and the keys that work now."""

from __future__ import annotations

from layfigure.drawing.render_list import Rectangle
from layfigure.session.frame import Frame
from layfigure_frontends.terminal.paper import Paper, Tone

LEAST_STATUS = 0.25  # of the line, kept for the sentence however many hints there are
BETWEEN = 2


def paint_status_line(paper: Paper, frame: Frame, bar: Rectangle) -> None:
    """Paint the sentence at the left, and at the right as many hints as fit, the first ones first."""
    theme = paper.theme
    tone = Tone(theme.text, theme.panel)
    paper.fill(bar, tone)
    sentence = min(max(len(frame.status) + 3, round(bar.width * LEAST_STATUS)), bar.width)
    room = bar.width - sentence - 1
    hints = list(frame.hints)
    while hints and _width(hints) > room:
        hints.pop()
    x = bar.x + bar.width - 1 - _width(hints)
    paper.write(bar.x + 1, bar.y, frame.status, tone, max(x - bar.x - 2, bar.width - 2 if not hints else 0))
    for key, text in hints:
        x += paper.write(x, bar.y, key, Tone(theme.key_text, theme.key, strong=True), len(key))
        x += paper.write(x, bar.y, f" {text}", Tone(theme.muted, theme.panel), len(text) + 1) + BETWEEN


def _width(hints: list[tuple[str, str]]) -> int:
    return sum(len(key) + 1 + len(text) + BETWEEN for key, text in hints) - BETWEEN * bool(hints)
