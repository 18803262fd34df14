"""Scenes that were shot, as reels."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING

from layfigure_frontends.film.reel import Reel, Size
from layfigure_frontends.film.sources.code import code_of

if TYPE_CHECKING:
    from fractions import Fraction
    from pathlib import Path

    from layfigure.plugins.host import Host
    from layfigure.scenes.drawing import PictureDrawer, Studio
    from layfigure.scenes.picture import Shooting
    from layfigure_frontends.film.choice import FilmChoice
    from layfigure_frontends.film.reel import Pixels
    from layfigure_frontends.opening import PluginChoice

USUAL = Size(640, 480)


@dataclass(frozen=True)
class Drawers:
    """What draws scenes in a studio, a drawer for every size."""

    host: Host
    studio: Studio
    _known: dict[Size, PictureDrawer] = field(default_factory=dict, repr=False, compare=False)

    @property
    def identity(self) -> tuple[str, ...]:
        """What of this decides how pictures look, but for their size."""
        return self.studio.renderer, repr(self.studio.look), self.studio.theme, self.studio.palette

    @property
    def code(self) -> tuple[Path, ...]:
        """Where the renderer's code lies."""
        return code_of(self.host, self.studio.renderer)

    def of(self, size: Size) -> PictureDrawer:
        """Return what draws pictures of a size.

        Raises:
            LayfigureError: there is no such theme, or no picture has that size.
        """
        if size not in self._known:
            from layfigure.scenes.drawing import PictureDrawer

            self._known[size] = PictureDrawer(self.host, replace(self.studio, size=(size.width, size.height)))
        return self._known[size]


@dataclass(frozen=True)
class ScenePictures:
    """A scene's pictures with what draws them."""

    shooting: Shooting
    drawers: Drawers

    def __len__(self) -> int:
        return len(self.shooting.pictures)

    def draw(self, index: int, size: Size) -> Pixels:
        """Return a picture."""
        return self.drawers.of(size).draw(self.shooting.pictures[index])

    def digest(self, index: int) -> bytes:
        """Return what actors, camera and ground decide."""
        from layfigure.scenes.digests import digest

        return digest(self.shooting.pictures[index])


def drawers_of(asked: FilmChoice, choice: PluginChoice) -> Drawers:
    """Return what draws as the command line and the configuration ask for.

    Raises:
        LayfigureError: there is no such look or renderer.
    """
    from layfigure.configuration import load_configuration
    from layfigure.drawing.render_list import look_of
    from layfigure.scenes.drawing import Studio, renderer_of
    from layfigure_frontends.opening import open_host

    configuration = load_configuration(choice.config)
    host = open_host(choice)
    renderer = renderer_of(host, asked.renderer or configuration.renderer)
    return Drawers(host, Studio(renderer=renderer.id, look=look_of(asked.look), theme=configuration.theme))


def reels_of(shootings: Sequence[Shooting], drawers: Drawers) -> tuple[Reel, ...]:
    """Return a reel for every scene that has pictures."""
    pictures = [ScenePictures(shooting, drawers) for shooting in shootings]
    return tuple(Reel(each, range(len(each))) for each in pictures if len(each))


def told(shootings: Sequence[Shooting], rate: Fraction) -> tuple[str, ...]:
    """Return a line for every scene: its pictures, how long they last, whether no limit interfered, seams."""
    from layfigure.files.decimals import plain

    lines = []
    for shooting in shootings:
        count = len(shooting.pictures)
        facts = [f"{count} picture{'s' if count != 1 else ''}, {plain(float(count / rate), 3)} s"]
        facts += [] if shooting.clamps is None or shooting.clamps else [str(shooting.clamps)]
        facts += [str(seams) for seams in shooting.seams]
        lines.append(f"scene {shooting.number}: {'; '.join(facts)}")
    return tuple(lines)


def warned(shootings: Sequence[Shooting]) -> tuple[str, ...]:
    """Return a sentence for every scene in which limits held motions back."""
    return tuple(f"scene {shooting.number}: {shooting.clamps}" for shooting in shootings if shooting.clamps)
