"""Draws with the renderer that was chosen, or with the next that works."""

from __future__ import annotations

from collections.abc import Callable

from layfigure.drawing.render_list import Look, RenderList, Target
from layfigure.errors import ImpossibleError, PluginError
from layfigure.plugins.host import Host
from layfigure.plugins.records import RendererObject


class Renderers:
    """The renderers of one session, made when they are first wanted.

    ``compiled`` says whether machine code is ready, so that compiled ones may draw. ``say`` is told of those that fail.
    """

    def __init__(self, host: Host, say: Callable[[str], None], *, compiled: bool) -> None:
        self.compiled = compiled
        self._host = host
        self._say = say
        self._made: dict[str, RendererObject] = {}

    def draw(self, render_list: RenderList, target: Target, look: Look, *, preferred: str) -> None:
        """Draw with the renderer ``preferred`` by id, or the next that works.

        Raises:
            ImpossibleError: none is in service.
        """
        for identifier in self._order(preferred):
            record = self._host.renderers[identifier]
            try:
                if identifier not in self._made:
                    self._made[identifier] = self._host.call(record, "making", record.make)
                self._host.call(record, "drawing", self._made[identifier].draw, render_list, target, look)
            except PluginError as error:
                self._say(str(error))
            else:
                return
        raise ImpossibleError("no renderer is in service; start without --no-plugin, or with --safe")

    def forget(self) -> None:
        """Make renderers anew from now on, because plug-ins have changed."""
        self._made.clear()

    def _order(self, preferred: str) -> list[str]:
        usable = [key for key, record in self._host.renderers.items() if self.compiled or not record.compiled]
        return sorted(usable, key=lambda key: key != preferred)
