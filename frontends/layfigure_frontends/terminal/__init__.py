"""The terminal: takes it over, reads keys and pointer, shows grids of cells or pictures of pixels, decides nothing.

How the pieces fit, without a session::

    depth = choose_depth(os.environ, color)                # depth.py: what the terminal shows
    with open_terminal(places.state()) as terminal:        # driver.py: raw mode, alternate screen, given back always
        parser, abilities = Parser(), Abilities()          # parser.py, depth.py
        encoder, fence = CellEncoder(depth), Fence(depth)  # encoder.py, fence.py
        terminal.write(queries(os.environ) + fence.probe(time.monotonic()))
        while True:
            arrival = terminal.wait(seconds)               # the least of what parser and fence ask for; fence only
                                                           # where there is something to draw and nothing unwritten
            if arrival.ended: break                        # "closed", "SIGTERM", "SIGHUP"
            now = time.monotonic()
            events = parser.feed(arrival.data, now) if arrival.data else parser.expire(now)
            # CursorReport: fence.answered(now); other replies: abilities = abilities.told(reply), and
            # encoder.synchronised = abilities.synchronised; KeyEvent, PointerEvent: session.handle(event);
            # arrival.resized or Resize: a new Grid; arrival.resumed: encoder.forget()
            if changed and not fence.seconds_left(now) and not terminal.unwritten:
                encoder.depth = fence.quality.depth        # draw again when it has changed
                grid.put_picture(...); grid.write(...)     # cells.py
                frame = encoder.encode(grid, cursor)       # nothing at rest
                if frame: terminal.write(frame + fence.sent(len(frame), now))

``coalesced(events)`` keeps one pointer move of many. ``parser.pointer.scale`` says in which units places are told:
cells, half blocks (the default), or pixels of a cell where real pictures are shown.

Nothing here waits for an answer: half blocks are drawn at once, and ``abilities.picture(...)`` says later whether sixel
or kitty's graphics (graphics.py) may take their place. ``encoder.speed_up()`` loads the machine code; until it has been
called frames are written by slow_stream.py, so the first paint need not wait for numba.

After a program that was killed, ``open_terminal`` sets the terminal right at the next start; for those who do not start
again, ``reset``, or ``printf`` of :func:`layfigure_frontends.terminal.modes.restore_sequence` and ``stty sane``, does.

Terminal control is written in this package only, and nothing here imports pygame.
"""
