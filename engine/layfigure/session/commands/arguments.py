"""What the words of commands stand for in a session: limbs, packed poses, rectangles, files; and the selection."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from layfigure.drawing.render_list import Rectangle
from layfigure.errors import FileError, ImpossibleError, LayfigureError
from layfigure.figures.figure import axis_of
from layfigure.figures.spoken import spoken_limb
from layfigure.poses.packing import unpack_pose
from layfigure.poses.pose import Pose
from layfigure.session.words import WordError, no_more, number, one_of, required, whole_number

if TYPE_CHECKING:
    from layfigure.session.session import Session


def limbs(session: Session, words: tuple[str, ...], first: int) -> tuple[int, ...]:
    """Return the limbs that the words from ``first`` name; "all" means every movable limb.

    Raises:
        WordError: a name is unknown or none is given.
    """
    figure = session.document.figure
    required(words, first, "a limb's name")
    if words[first:] == ("all",):
        return figure.movable
    found = []
    for index, word in enumerate(words[first:], start=first):
        try:
            found.append(figure.index(word))
        except LayfigureError as error:
            raise WordError(index + 1, str(error)) from None
    return tuple(dict.fromkeys(found))


def one_limb(session: Session, words: tuple[str, ...], index: int) -> int:
    """Return the limb that word ``index`` names.

    Raises:
        WordError: it is missing, unknown, or "all".
    """
    if required(words, index, "a limb's name") == "all":
        raise WordError(index + 1, "one limb is wanted here, not all of them")
    return limbs(session, words[: index + 1], index)[0]


def column_of(session: Session, limb: int, kind: str) -> int:
    """Return which of a joint's three angles a degree of freedom is.

    Raises:
        ImpossibleError: the joint has no such angle.
    """
    figure = session.document.figure
    column = axis_of(figure.limbs[limb], kind)
    if column is None:
        raise ImpossibleError(f"the {spoken_limb(figure, limb)} has no {kind}")
    return column


def selected(session: Session) -> tuple[int, ...]:
    """Return the selected limbs, at least one, the one selected last at the end.

    Raises:
        ImpossibleError: none is selected.
    """
    if not session.view.selected:
        raise ImpossibleError("no limb is selected; Tab selects one")
    return session.view.selected


def packed_pose(session: Session, words: tuple[str, ...], index: int) -> Pose:
    """Return word ``index`` as a pose of the session's figure.

    Raises:
        WordError: it is missing, or no packed pose of this figure.
    """
    token = required(words, index, "a packed pose")
    try:
        return unpack_pose(session.document.figure, token)
    except LayfigureError as error:
        raise WordError(index + 1, str(error)) from None


def rectangle(words: tuple[str, ...]) -> tuple[int, str, Rectangle]:
    """Return candidate, view and pixel rectangle from six words.

    Raises:
        WordError: a word is missing or wrong.
    """
    shown = whole_number(words, 0, "a candidate", (-2, 10_000))
    view = one_of(words, 1, "view", ("main", "right", "top"))
    sides = [round(number(words, index, "a pixel coordinate")) for index in range(2, 6)]
    no_more(words, 6)
    return shown, view, Rectangle(*sides)


def named_file(session: Session, name: str) -> Path:
    """Return the file that a person names, beside the session's others; ``~`` stands for a home folder.

    Raises:
        FileError: that cannot be the name of a file.
    """
    try:
        path = Path(name).expanduser()
    except RuntimeError:
        raise FileError(f"{name[:60]}: there is no such home folder; write the whole path") from None
    if path.name in ("", ".."):
        raise FileError(f'"{name[:60]}" is a folder; name a file inside it')
    return session.options.folder / path
