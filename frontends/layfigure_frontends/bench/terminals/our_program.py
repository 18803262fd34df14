"""Shows the animation with the terminal front end's own pieces."""

from __future__ import annotations

import os
import time

from layfigure.session.events import KeyEvent
from layfigure_frontends.bench.terminals.scene import COLUMNS, FRAMES, ROWS, asked
from layfigure_frontends.terminal.cells import Grid
from layfigure_frontends.terminal.depth import choose_depth
from layfigure_frontends.terminal.driver import open_terminal
from layfigure_frontends.terminal.encoder import CellEncoder
from layfigure_frontends.terminal.fence import Fence
from layfigure_frontends.terminal.parser import Parser
from layfigure_frontends.terminal.replies import CursorReport


def main() -> None:
    """Play until the time is up, each key answered in the next frame."""
    frames, performance = asked()
    depth = choose_depth(os.environ)
    encoder, fence, parser, grid = CellEncoder(depth), Fence(depth), Parser(), Grid(COLUMNS, ROWS + 1)
    encoder.speed_up()
    with open_terminal() as terminal:
        terminal.write(fence.probe(time.monotonic()))
        shown, urgent = -1, False
        performance.begin()
        while not performance.over:
            now = time.monotonic()
            wait = fence.seconds_left(now, urgent=urgent)
            due = performance.due()
            if not wait and (due != shown or urgent) and not terminal.unwritten:
                shown, urgent = due, False
                encoder.depth = fence.quality.depth
                grid.put_picture(0, 0, frames[due % FRAMES], None)
                grid.write(0, ROWS, performance.line)
                data = encoder.encode(grid)
                terminal.write(data + fence.sent(len(data), now))
                performance.frames += 1
            arrival = terminal.wait(max(wait, 0.002))
            for event in parser.feed(arrival.data, time.monotonic()):
                if isinstance(event, CursorReport):
                    fence.answered(time.monotonic())
                elif isinstance(event, KeyEvent):
                    performance.letter, urgent = event.key, True
    performance.end()


if __name__ == "__main__":
    main()
