"""Writes the bytes that turn what a terminal shows into the next frame: as few as can be found without searching.

Cells are (glyph, ink, paper, style) as ``colours.resolve`` makes them. ``state`` is what the terminal has in hand:
column, row (-1: not known), ink, paper, style of its pen (-1: not known).
"""

from __future__ import annotations

from typing import Any

from numba.types import int64, uint8, uint32

from layfigure_frontends.terminal.kernels import entry, inner, read_only

_OUT, _STATE = uint8[::1], int64[::1]
_COLUMN, _ROW, _INK, _PAPER, _STYLE = 0, 1, 2, 3, 4
_ANY = -2  # a colour that does not matter
_BOLD, _UNDERLINE, _REVERSE = 1, 2, 4
_SPACE, _UPPER, _LOWER = 0x20, 0x2580, 0x2584
_LONGEST_GAP = 4


@inner
def _digits(value: int) -> int:
    count = 1
    while value >= 10:
        value //= 10
        count += 1
    return count


@inner
def _number(out: Any, n: int, value: int) -> int:
    end = n + _digits(value)
    for at in range(end - 1, n - 1, -1):
        out[at] = 48 + value % 10
        value //= 10
    return end


@inner
def _parameter(out: Any, n: int, value: int) -> int:
    """Append a parameter and a semicolon."""
    n = _number(out, n, value)
    out[n] = 59
    return n + 1


@inner
def _step(out: Any, n: int, count: int, final: int) -> int:
    """Append ``CSI count final``; a count of one is left out."""
    out[n], out[n + 1] = 27, 91
    n += 2
    if count != 1:
        n = _number(out, n, count)
    out[n] = final
    return n + 1


@inner
def _character(out: Any, n: int, glyph: int) -> int:
    """Append a code point as UTF-8."""
    if glyph < 0x80:
        out[n] = glyph
        return n + 1
    if glyph < 0x800:
        out[n], out[n + 1] = 0xC0 | glyph >> 6, 0x80 | glyph & 63
        return n + 2
    if glyph < 0x10000:
        out[n], out[n + 1], out[n + 2] = 0xE0 | glyph >> 12, 0x80 | glyph >> 6 & 63, 0x80 | glyph & 63
        return n + 3
    out[n], out[n + 1] = 0xF0 | glyph >> 18, 0x80 | glyph >> 12 & 63
    out[n + 2], out[n + 3] = 0x80 | glyph >> 6 & 63, 0x80 | glyph & 63
    return n + 4


@inner
def _across(column: int, x: int) -> int:
    """Return what moving along a row costs in bytes; from an unknown column it begins with a carriage return."""
    if column == x:
        return 0
    home = 1 if x == 0 else 4 if x == 1 else 4 + _digits(x)
    if column < 0:
        return home
    distance = abs(x - column)
    return min(home, 3 if distance == 1 else 3 + _digits(distance))


@inner
def _move(out: Any, n: int, state: Any, x: int, y: int) -> int:
    """Append the cheapest way to a cell."""
    column, row = state[_COLUMN], state[_ROW]
    down = y - row
    absolute = 3 if x == 0 and y == 0 else 3 + _digits(y + 1) if x == 0 else 4 + _digits(y + 1) + _digits(x + 1)
    state[_COLUMN], state[_ROW] = x, y
    if row >= 0 and 0 <= down <= 3 and down + _across(column, x) <= absolute:
        for _ in range(down):
            out[n] = 10
            n += 1
        if column == x:
            return n
        distance = x - column
        if column >= 0 and _across(column, x) == (3 if abs(distance) == 1 else 3 + _digits(abs(distance))):
            return _step(out, n, abs(distance), 67 if distance > 0 else 68)
        out[n] = 13
        return n + 1 if x == 0 else _step(out, n + 1, x, int64(67))
    if x == 0:
        return _step(out, n, y + 1, int64(72))
    out[n], out[n + 1] = 27, 91
    n = _parameter(out, n + 2, y + 1)
    n = _number(out, n, x + 1)
    out[n] = 72
    return n + 1


@inner
def _colour(out: Any, n: int, code: int, ground: int) -> int:
    """Append the parameters of a colour; ``ground`` is 0 for ink, 10 for paper."""
    kind, value = code >> 24, code & 0xFFFFFF
    if kind == 0:
        return _parameter(out, n, 39 + ground)
    if kind == 3:
        return _parameter(out, n, (30 if value < 8 else 82) + value + ground)
    n = _parameter(out, n, 38 + ground)
    if kind == 2:
        return _parameter(out, _parameter(out, n, int64(5)), value)
    n = _parameter(out, n, int64(2))
    n = _parameter(out, n, value >> 16)
    n = _parameter(out, n, value >> 8 & 255)
    return _parameter(out, n, value & 255)


@inner
def _pen(out: Any, n: int, state: Any, ink: int, paper: int, style: int) -> int:
    """Append one SGR sequence that gives the pen its colours and style, or nothing."""
    if (ink == state[_INK] or ink == _ANY) and paper == state[_PAPER] and style == state[_STYLE]:
        return n
    begin = n
    out[n], out[n + 1] = 27, 91
    n += 2
    if state[_STYLE] < 0 or (paper == 0 and style == 0 and (ink == 0 or ink == _ANY)):
        n = _parameter(out, n, int64(0))
        state[_INK], state[_PAPER], state[_STYLE] = 0, 0, 0
    changed = state[_STYLE] ^ style
    if changed & _BOLD:
        n = _parameter(out, n, 1 if style & _BOLD else 22)
    if changed & _UNDERLINE:
        n = _parameter(out, n, 4 if style & _UNDERLINE else 24)
    if changed & _REVERSE:
        n = _parameter(out, n, 7 if style & _REVERSE else 27)
    if ink not in (_ANY, state[_INK]):
        n = _colour(out, n, ink, int64(0))
        state[_INK] = ink
    if paper != state[_PAPER]:
        n = _colour(out, n, paper, int64(10))
        state[_PAPER] = paper
    state[_STYLE] = style
    if n == begin + 4 and out[n - 2] == 48:  # a lone 0 may be left out
        n -= 1
    out[n - 1] = 109
    return n


@inner
def _draw(out: Any, n: int, state: Any, cell: Any) -> int:
    """Append a cell where the cursor stands."""
    glyph, ink, paper, style = int64(cell[0]), int64(cell[1]), int64(cell[2]), int64(cell[3])
    if glyph == 0:
        upright = (ink != state[_INK]) + (paper != state[_PAPER])
        turned = (paper != state[_INK]) + (ink != state[_PAPER])
        if ink != paper:
            glyph = _UPPER
            if turned < upright:
                glyph, ink, paper = _LOWER, paper, ink
        else:  # never a full block: in many fonts it leaves a seam, where the paper of another cell would show
            glyph, ink, style = _SPACE, _ANY, max(state[_STYLE], 0) & _BOLD
    return _character(out, _pen(out, n, state, ink, paper, style), glyph)


@inner
def _fits(state: Any, cell: Any) -> bool:
    """Whether a cell can be written again with one byte and the pen as it is."""
    if cell[0] == 0:
        plain = state[_STYLE] >= 0 and not state[_STYLE] & (_UNDERLINE | _REVERSE)
        return cell[1] == cell[2] and int64(cell[2]) == state[_PAPER] and plain
    same = int64(cell[1]) == state[_INK] and int64(cell[2]) == state[_PAPER] and int64(cell[3]) == state[_STYLE]
    return same and cell[0] < 0x80


@inner
def _approach(out: Any, n: int, state: Any, row: Any, x: int, y: int) -> int:
    """Append the way to a cell: over a short gap by writing what stands there, where that is cheaper than a jump."""
    gap = x - state[_COLUMN]
    if state[_ROW] == y and state[_COLUMN] >= 0 and 0 < gap <= _LONGEST_GAP:
        fits = True
        for between in range(state[_COLUMN], x):
            fits = fits and _fits(state, row[between])
        if fits:
            for between in range(state[_COLUMN], x):
                out[n] = row[between, 0] if row[between, 0] else _SPACE
                n += 1
            state[_COLUMN] = x
            return n
    if state[_ROW] != y or state[_COLUMN] != x:
        return _move(out, n, state, x, y)
    return n


@entry(int64(read_only(uint32, 3), uint32[:, :, ::1], _STATE, int64, int64, _OUT))
def write_frame(cells: Any, shown: Any, state: Any, park_x: int, park_y: int, out: Any) -> int:
    """Write the bytes that make a screen show ``cells``; return how many.

    Args:
        cells: (rows, columns, 4) the next frame.
        shown: (rows, columns, 4) what the terminal shows; becomes ``cells``.
        state: (5,) column, row, ink, paper, style; kept up to date.
        park_x: the column where the cursor is left at the end, or -1.
        park_y: the row of it.
        out: at least 64 bytes a cell and 64 more.
    """
    n = int64(0)  # else the kernels would be compiled twice, for a literal and for a number
    rows, columns = cells.shape[0], cells.shape[1]
    for y in range(rows):
        for x in range(columns):
            cell = cells[y, x]
            known = shown[y, x]
            if cell[0] == known[0] and cell[1] == known[1] and cell[2] == known[2] and cell[3] == known[3]:
                continue
            n = _approach(out, n, state, shown[y], x, y)
            n = _draw(out, n, state, cell)
            for part in range(4):
                known[part] = cell[part]
            # Behind the last column terminals differ in where the cursor stands.
            state[_COLUMN] = x + 1 if x + 1 < columns else -1
    if park_x >= 0 and (state[_COLUMN] != park_x or state[_ROW] != park_y):
        n = _move(out, n, state, park_x, park_y)
    return n
