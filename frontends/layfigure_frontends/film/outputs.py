"""Which sink writes a film, by the name of its output."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from layfigure_frontends.film.reel import Film

if TYPE_CHECKING:
    from layfigure_frontends.film.reel import Pixels

Writer = Callable[[Film, "Iterator[Pixels]", Path], None]
MOVING = (".gif", ".apng", ".webp", ".mp4")


class Sink(NamedTuple):
    """What writes a film in one way.

    Attributes:
        name: what the way is called; part of what finished films are known by.
        write: takes the film, its pictures in order (a sink may ask the film for others instead), and the output.
        paths: which files it writes.
        notes: what there is to say about how the film fits the format.
    """

    name: str
    write: Writer
    paths: Callable[[Film, Path], list[Path]]
    notes: Callable[[Film], tuple[str, ...]]


def moves(output: Path) -> bool:
    """Return whether a name asks for pictures one after the other: a moving format or numbered pictures."""
    from layfigure_frontends.film.sinks import frames

    return output.suffix.lower() in MOVING or frames.is_pattern(output)


def sink_for(film: Film, output: Path) -> Sink:
    """Return the sink for a name: one picture, a contact sheet, numbered pictures, or a moving format.

    Raises:
        FileError: nothing writes such a name.
        LayfigureError: what writes it is not installed.
    """
    from layfigure.errors import FileError
    from layfigure_frontends.film.sinks import frames

    if frames.is_pattern(output):
        frames.check(output)
        return Sink("frames", frames.write, frames.paths, _nothing)
    suffix = output.suffix.lower()
    if suffix == ".png":
        return _still(film)
    if suffix not in MOVING:
        kinds = ".png, frames/%04d.png, .gif, .apng, .webp or .mp4"
        raise FileError(f'{output}: films are not written as "{suffix or output.name}"; name it {kinds}')
    return _moving(suffix)


def _still(film: Film) -> Sink:
    from layfigure_frontends.film.sinks import png, sheet

    if len(film) > 1:
        return Sink("sheet", sheet.write, _itself, sheet.notes)
    return Sink("png", lambda _, pictures, path: png.write_picture(next(pictures), path), _itself, _nothing)


def _moving(suffix: str) -> Sink:
    if suffix == ".gif":
        from layfigure_frontends.film.sinks import gif

        return Sink("gif", gif.write, _itself, gif.notes)
    if suffix == ".apng":
        from layfigure_frontends.film.sinks import png

        return Sink("apng", png.write_film, _itself, _nothing)
    if suffix == ".webp":
        from layfigure_frontends.film.sinks import webp

        return Sink("webp", webp.write, _itself, _nothing)
    from layfigure_frontends.film.sinks import mp4

    mp4.check()
    return Sink("mp4", mp4.write, _itself, mp4.notes)


def _itself(_: Film, output: Path) -> list[Path]:
    return [output]


def _nothing(_: Film) -> tuple[str, ...]:
    return ()
