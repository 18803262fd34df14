"""Scenes that were shot, as reels."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from layfigure_frontends.film.reel import Reel, Size
from layfigure_frontends.film.sources.code import code_of

if TYPE_CHECKING:
    from fractions import Fraction
    from pathlib import Path

    from layfigure.drawing.render_list import Look
    from layfigure.plugins.host import Host
    from layfigure.scenes.drawing import PictureDrawer
    from layfigure.scenes.picture import Shooting
    from layfigure_frontends.film.choice import FilmChoice
    from layfigure_frontends.film.reel import Pixels
    from layfigure_frontends.opening import PluginChoice

USUAL = Size(640, 480)


@dataclass(frozen=True)
class Studio:
    """What draws scenes: the host's renderer of a name, a look, and a theme. Nothing is loaded before it is needed."""

    host: Host
    renderer: str
    look: Look
    theme: str
    _drawers: dict[Size, PictureDrawer] = field(default_factory=dict, repr=False, compare=False)

    @property
    def identity(self) -> tuple[str, ...]:
        """What of this decides how pictures look."""
        return self.renderer, repr(self.look), self.theme

    @property
    def code(self) -> tuple[Path, ...]:
        """Where the renderer's code lies."""
        return code_of(self.host, self.renderer)

    def drawer(self, size: Size) -> PictureDrawer:
        """Return what draws pictures of a size.

        Raises:
            LayfigureError: there is no such renderer or theme, or no picture has that size.
        """
        if size not in self._drawers:
            from layfigure.scenes import drawing

            asked = drawing.Studio((size.width, size.height), self.renderer, self.look, self.theme)
            self._drawers[size] = drawing.PictureDrawer(self.host, asked)
        return self._drawers[size]


@dataclass(frozen=True)
class ScenePictures:
    """A scene's pictures in a studio."""

    shooting: Shooting
    studio: Studio

    def __len__(self) -> int:
        return len(self.shooting.pictures)

    def draw(self, index: int, size: Size) -> Pixels:
        """Return a picture."""
        return self.studio.drawer(size).draw(self.shooting.pictures[index])

    def digest(self, index: int) -> bytes:
        """Return what actors, camera and ground decide."""
        from layfigure.scenes.digests import digest

        return digest(self.shooting.pictures[index])


def studio_of(asked: FilmChoice, choice: PluginChoice) -> Studio:
    """Return the studio that the command line and the configuration ask for.

    Raises:
        LayfigureError: there is no such look or renderer.
    """
    from layfigure.configuration import load_configuration
    from layfigure.drawing.render_list import LOOKS
    from layfigure_frontends.opening import open_host

    configuration = load_configuration(choice.config)
    host = open_host(choice)
    renderer = asked.renderer or configuration.renderer
    known("look", asked.look, LOOKS)
    known("renderer", renderer, host.renderers)
    return Studio(host, renderer, LOOKS[asked.look], configuration.theme)


def known(kind: str, name: str, names: Iterable[str]) -> None:
    """Refuse a name that is not among the known ones.

    Raises:
        LayfigureError: it is not.
    """
    from layfigure.errors import LayfigureError
    from layfigure.suggestions import did_you_mean

    listed = list(names)
    if name not in listed:
        hint = did_you_mean(name, listed)
        raise LayfigureError(f'there is no {kind} "{name}"; it can be {", ".join(listed)}{hint}')


def reels_of(shootings: Sequence[Shooting], studio: Studio) -> tuple[Reel, ...]:
    """Return a reel for every scene that has pictures."""
    pictures = [ScenePictures(shooting, studio) for shooting in shootings]
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
