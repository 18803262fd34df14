"""The window: translates pygame's events, shows the session's frames, decides nothing.

SDL's hints are set here, because they must stand in the environment before any module of this package starts it.
"""

import os

HINTS = {
    "PYGAME_HIDE_SUPPORT_PROMPT": "1",
    "SDL_MOUSE_FOCUS_CLICKTHROUGH": "1",  # else the click that focuses the window is lost
    "SDL_FRAMEBUFFER_ACCELERATION": "0",  # shared memory: without a GPU the default costs 15 to 30 times the drawing
    "SDL_WINDOWS_DPI_AWARENESS": "permonitorv2",
    "SDL_VIDEO_X11_WMCLASS": "layfigure",
}
for _name, _value in HINTS.items():
    os.environ.setdefault(_name, _value)
