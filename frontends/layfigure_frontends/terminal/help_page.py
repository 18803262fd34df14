"""The help page and its like: sections of keys and what they do, flowing through columns of text."""

from __future__ import annotations

from layfigure.drawing.render_list import Rectangle
from layfigure.session.frame import HelpOverlay, Size
from layfigure_frontends.terminal.paper import ROW, Paper, Tone, cells_of

Line = tuple[str, str]  # keys and text; no keys: a section's title; neither: room between sections
COLUMN, BETWEEN = 46, 3


def help_lines(overlay: HelpOverlay) -> list[Line]:
    """Return the page as lines, sections one after another."""
    lines: list[Line] = []
    for title, rows in overlay.sections:
        lines.extend([("", "")] * bool(lines))
        lines.append(("", title))
        lines.extend(rows)
    return lines


def paint_help(paper: Paper, overlay: HelpOverlay, size: Size) -> tuple[int, int]:
    """Paint the page over the screen, as many columns as it needs and the screen holds; return the focused cell."""
    lines = help_lines(overlay)
    rows = max(size.height // ROW - 5, 3)  # borders, the title, and the status line
    most = max((size.width - 2) // (COLUMN + BETWEEN), 1)
    count = max(min(most, -(-len(lines) // rows)), 1)
    start = min(overlay.scroll, max(len(lines) - count * rows, 0))
    shown = lines[start : start + count * rows]
    length = min(rows, -(-len(shown) // count))
    column = min(COLUMN, size.width - 4)
    width = count * column + (count - 1) * BETWEEN
    left, top = (size.width - width) // 2, max((rows - length) // 2, 0) + 2
    _frame(paper, Rectangle(left - 2, (top - 2) * ROW, width + 4, (length + 3) * ROW), overlay.title)
    for index, (keys, text) in enumerate(shown):
        x = left + index // length * (column + BETWEEN)
        _paint_line(paper, Rectangle(x, (top + index % length) * ROW, column, ROW), (keys, text), caps=overlay.keys)
    if start + len(shown) < len(lines):
        more = Rectangle(left, (top + length) * ROW, width, ROW)
        paper.text(more, " ↓ more ", Tone(paper.theme.muted, paper.theme.panel), "centre")
    return left, top


def _frame(paper: Paper, box: Rectangle, title: str) -> None:
    tone = Tone(paper.theme.text, paper.theme.panel)
    paper.fill(box, tone)
    paper.box(cells_of(box), Tone(paper.theme.muted, paper.theme.panel))
    paper.text(Rectangle(box.x + 2, box.y, box.width - 4, ROW), f" {title} ", tone._replace(strong=True))


def _paint_line(paper: Paper, box: Rectangle, line: Line, *, caps: bool) -> None:
    keys, text = line
    theme = paper.theme
    if not keys:
        paper.text(box, text, Tone(theme.accent, theme.panel, strong=True))
        return
    tone = Tone(theme.key_text, theme.panel, strong=True) if caps else Tone(theme.muted, theme.panel)
    paper.text(box, keys, tone, "right")
    paper.write(box.x, box.y, text, Tone(theme.text, theme.panel), box.width - len(keys) - 1)
