"""A time line on one line of a terminal: numbers, keys as diamonds, marks as flags, the playhead in inverse."""

from __future__ import annotations

from layfigure.session.frame import TimeLine
from layfigure_frontends.terminal.paper import Paper, Tone

KEY, OTHER, MARK, MARKED, HEAD = "◆", "◇", "▴", "◈", "│"  # MARKED: a key with a mark on it


def paint_time_line(paper: Paper, line: TimeLine) -> None:
    """Paint a time line; in a cell the first of these is seen: playhead, mark, key, another's key, name, number."""
    theme, box = paper.theme, line.track
    ground = Tone(theme.faint, theme.raised)
    paper.fill(line.rectangle, paper.tone())
    end = int(line.x_of(line.end)) - box.x
    shown = ["─" if column <= end else "·" for column in range(box.width)]
    tones = [ground] * box.width
    _texts(line, shown)
    for frames, sign, ink in ((line.others, OTHER, theme.muted), (line.keys, KEY, theme.accent)):
        for frame in frames:
            column = _column(line, frame)
            shown[column], tones[column] = sign, Tone(ink, theme.raised)
    for frame, _ in line.marks:
        column = _column(line, frame)
        shown[column] = MARKED if shown[column] in (KEY, OTHER, MARKED) else MARK
        tones[column] = Tone(theme.warning, theme.raised)
    column = _column(line, line.playhead)
    if shown[column] not in (KEY, OTHER, MARK, MARKED):
        shown[column] = HEAD
    tones[column] = Tone(theme.on_accent, theme.accent, strong=True, inverse=True)
    for place, (sign, tone) in enumerate(zip(shown, tones, strict=True)):
        paper.write(box.x + place, box.y, sign, tone, 1)


def _texts(line: TimeLine, shown: list[str]) -> None:
    """Write names of marks and frame numbers right of where they are, those that nothing else would hide in part."""
    signs = (*line.keys, *line.others, line.playhead, *(frame for frame, _ in line.marks))
    taken = {_column(line, frame) for frame in signs}
    named = [(_column(line, frame) + 1, name) for frame, name in line.marks if name.isascii()]
    frames = range(0, int(line.last) + 1, line.every) if line.every else ()
    for column, text in (*named, *((_column(line, frame) + (frame > 0), str(frame)) for frame in frames)):
        cells = range(column, column + len(text))
        if cells.stop <= len(shown) and taken.isdisjoint(cells):
            shown[column : cells.stop] = text
            taken.update(range(column, cells.stop + 1))  # a cell apart from what follows


def _column(line: TimeLine, frame: float) -> int:
    """Return in which cell of the line a frame lies."""
    return min(max(int(line.x_of(frame)) - line.track.x, 0), line.track.width - 1)
