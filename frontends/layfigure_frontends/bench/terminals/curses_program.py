"""Shows the animation with curses, in 256 colours, with a colour pair for each two that stand one above the other."""

from __future__ import annotations

import curses

import numpy as np

from layfigure_frontends.bench.terminals.scene import COLUMNS, FRAMES, ROWS, asked
from layfigure_frontends.terminal.cells import Grid
from layfigure_frontends.terminal.colours import resolve
from layfigure_frontends.terminal.depth import Depth


def main(screen: curses.window) -> None:
    """Play until the time is up."""
    frames, performance = asked()
    cells = []
    for frame in frames:  # beforehand, so that only curses itself is measured
        grid = Grid(COLUMNS, ROWS)
        grid.put_picture(0, 0, frame, None)
        resolved = resolve(grid, Depth.COLOURS_256)
        cells.append((resolved[..., 1] & np.uint32(255), resolved[..., 2] & np.uint32(255)))
    curses.start_color()
    screen.timeout(2)
    pairs: dict[tuple[int, int], int] = {}
    shown = -1
    performance.begin()
    while not performance.over:
        due = performance.due()
        if due != shown:
            shown = due
            ink, paper = cells[due % FRAMES]
            for y in range(ROWS):
                for x, colours in enumerate(zip(ink[y].tolist(), paper[y].tolist(), strict=True)):
                    if colours not in pairs:
                        pairs[colours] = len(pairs) + 1
                        curses.init_pair(pairs[colours], *colours)
                    screen.addstr(y, x, "▀", curses.color_pair(pairs[colours]))
            screen.addstr(ROWS, 0, performance.line)
            screen.refresh()
            performance.frames += 1
        key = screen.getch()
        if 0 < key < 128:
            performance.letter = chr(key)
            screen.addstr(ROWS, 0, performance.line)
            screen.refresh()
    performance.end()


if __name__ == "__main__":
    curses.wrapper(main)
