"""A time line on one line of a terminal: numbers, keys as diamonds, marks as flags, the playhead in inverse."""

from __future__ import annotations

from layfigure.session.frame import TimeLine
from layfigure_frontends.terminal.paper import Paper, Tone

KEY, OTHER, MARK, HEAD = "◆", "◇", "▴", "│"


def paint_time_line(paper: Paper, line: TimeLine) -> None:
    """Paint a time line; what stands in the same cell hides the other: playhead, key, another's key, mark, number."""
    theme, box = paper.theme, line.track
    ground = Tone(theme.faint, theme.raised)
    paper.fill(line.rectangle, paper.tone())
    end = int(line.x_of(line.end)) - box.x
    shown = ["─" if column <= end else "·" for column in range(box.width)]
    tones = [ground] * box.width
    _numbers(line, shown)
    for frames, sign, ink in (
        ([frame for frame, _ in line.marks], MARK, theme.warning),
        (line.others, OTHER, theme.muted),
        (line.keys, KEY, theme.accent),
    ):
        for frame in frames:
            column = _column(line, frame)
            shown[column], tones[column] = sign, Tone(ink, theme.raised)
    column = _column(line, line.playhead)
    if shown[column] not in (KEY, OTHER):
        shown[column] = HEAD
    tones[column] = Tone(theme.on_accent, theme.accent, strong=True, inverse=True)
    for place, (sign, tone) in enumerate(zip(shown, tones, strict=True)):
        paper.write(box.x + place, box.y, sign, tone, 1)


def _numbers(line: TimeLine, shown: list[str]) -> None:
    """Write frame numbers right of where their frames are, those that nothing else would hide in part."""
    if not line.every:
        return
    signs = (*line.keys, *line.others, line.playhead, *(frame for frame, _ in line.marks))
    taken = {_column(line, frame) for frame in signs}
    for frame in range(0, int(line.last) + 1, line.every):
        text, column = str(frame), _column(line, frame) + (frame > 0)
        if column + len(text) <= len(shown) and taken.isdisjoint(range(column, column + len(text))):
            shown[column : column + len(text)] = text


def _column(line: TimeLine, frame: float) -> int:
    """Return in which cell of the line a frame lies."""
    return min(max(int(line.x_of(frame)) - line.track.x, 0), line.track.width - 1)
