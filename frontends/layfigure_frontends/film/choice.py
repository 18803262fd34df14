"""What the command line asks of a film: size, rate, part, and how it is to look."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from layfigure_frontends.film.reel import Film, Size

SMALLEST, LARGEST = 16, 8192
SLOWEST, FASTEST = Fraction(1, 100), 1000
RATES = f"{float(SLOWEST):g} to {FASTEST}"
_FINEST = 1001  # the denominator of television's rates
_REPEATED = 40  # letters


@dataclass(frozen=True)
class FilmChoice:
    """What was asked for; None where nothing was.

    Attributes:
        size: (width, height) in pixels, (None, height) where only a height was given.
        rate: pictures per second.
        part: the first picture and the one before which to stop; None is the end.
        figure: what a motion moves.
        repeat: how many times a motion is shown in a row.
        in_place: whether a motion's travel over the ground is left out.
    """

    size: tuple[int | None, int] | None = None
    view: str | None = None
    renderer: str | None = None
    look: str = "full"
    rate: Fraction | None = None
    part: tuple[int, int | None] | None = None
    figure: str | None = None
    repeat: int = 1
    in_place: bool = False
    dry_run: bool = False
    no_cache: bool = False


def read_size(text: str | None) -> tuple[int | None, int] | None:
    """Return (None, height) or (width, height) of ``480`` or ``640x480``.

    Raises:
        LayfigureError: it is neither, or too small or large.
    """
    from layfigure.errors import LayfigureError

    if text is None:
        return None
    words = text.lower().split("x")
    if not (1 <= len(words) <= 2 and all(word.isdecimal() and len(word) <= 5 for word in words)):
        raise LayfigureError(
            f'--size is "{shortened(text)}"; write a height such as 480, or width and height such as 640x480'
        )
    numbers = [int(word) for word in words]
    if not all(SMALLEST <= number <= LARGEST for number in numbers):
        raise LayfigureError(f"--size is {text}; each side must be {SMALLEST} to {LARGEST} pixels")
    return (numbers[0] if len(numbers) == 2 else None), numbers[-1]


def shaped(size: tuple[int | None, int] | None, usual: Size) -> Size:
    """Return the size that was asked for: a height alone is as wide as the usual size's shape makes it."""
    if size is None:
        return usual
    width, height = size
    return Size(width or max(round(height * usual.width / usual.height), 1), height)


def read_rate(text: str | None) -> Fraction | None:
    """Return pictures per second of ``24``, ``23.976`` or ``24000/1001``.

    Raises:
        LayfigureError: it is none of these, or too slow or fast.
    """
    from layfigure.errors import LayfigureError
    from layfigure.motions.numbers import rational

    if text is None:
        return None
    try:
        rate = shown_rate(rational(text))
    except LayfigureError:
        told = f'--fps is "{shortened(text)}"'
        raise LayfigureError(f"{told}; write pictures per second such as 24, 12.5 or 24000/1001") from None
    if rate is None:
        raise LayfigureError(f"--fps is {shortened(text)}; it must be {RATES} pictures per second")
    return rate


def shown_rate(rate: Fraction) -> Fraction | None:
    """Return a rate as films have it, its denominator small enough for all formats, or None if it is out of bounds."""
    return rate.limit_denominator(_FINEST) if SLOWEST <= rate <= FASTEST else None


def shortened(text: str) -> str:
    """Return what was written as a sentence can repeat it."""
    return text if len(text) <= _REPEATED else f"{text[:_REPEATED]}..."


def read_part(text: str | None) -> tuple[int, int | None] | None:
    """Return the first picture and the one before which to stop, of ``a:b``; either may be left out.

    Raises:
        LayfigureError: it is no such part.
    """
    from layfigure.errors import LayfigureError

    if text is None:
        return None
    first, colon, end = text.partition(":")
    if not colon or not all(word == "" or (word.isdecimal() and len(word) <= 9) for word in (first, end)):
        raise LayfigureError(
            f'--frames is "{shortened(text)}"; write a:b, from picture a up to but without b, as in 0:24 or 48:'
        )
    return int(first or 0), int(end) if end else None


def part_of(film: Film, part: tuple[int, int | None] | None) -> Film:
    """Return the part of a film that was asked for.

    Raises:
        LayfigureError: no picture is in it.
    """
    from layfigure.errors import LayfigureError

    if part is None:
        return film
    first, end = part
    shown = film.part(first, film.first + len(film) if end is None else end)
    if not len(shown):
        last = film.first + len(film) - 1
        raise LayfigureError(
            f"--frames {first}:{'' if end is None else end} holds no picture; there are {film.first} to {last}"
        )
    return shown
