"""The signs of locks and goals: one character each, so that shape and colour say the same."""

from __future__ import annotations

from layfigure.session.frame import Frame, Sign
from layfigure_frontends.terminal.paper import ROW, Paper, Tone

SHAPES = {"pin": "◆", "orientation": "◎", "band": "○", "hold": "□", "joint": "■", "goal": "✛"}
LETTERS = {"pin": "P", "orientation": "O", "band": "B", "hold": "H", "joint": "J", "goal": "+"}
OTHER = "•"


def paint_signs(paper: Paper, frame: Frame) -> None:
    """Write the signs over the views, each within its view, on whatever the picture shows there."""
    for sign in frame.signs:
        if sign.clip.contains(sign.x, sign.y):
            _paint_sign(paper, sign)


def _paint_sign(paper: Paper, sign: Sign) -> None:
    x, y = int(sign.x), int(sign.y)
    behind = int(paper.pixels[y, x]) if y < paper.pixels.shape[0] and x < paper.pixels.shape[1] else 0
    dark = (behind >> 17 & 127, behind >> 9 & 127, behind >> 1 & 127)  # half as bright, as the halo in a window is
    shape = LETTERS.get(sign.role, "*") if paper.colourless else SHAPES.get(sign.role, OTHER)
    paper.write(x, y - y % ROW, shape, Tone(paper.theme.mark(sign.role), dark, strong=True, inverse=True), 1)
