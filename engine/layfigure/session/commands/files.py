"""Commands that read and write files."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from layfigure.errors import FileError, ImpossibleError
from layfigure.figures.figure import Figure
from layfigure.files.writing import write_text
from layfigure.plugins.host import Host
from layfigure.plugins.records import Command, Exchange
from layfigure.poses.pose import Pose
from layfigure.poses.pose_file import load_pose, save_pose
from layfigure.poses.pose_set import MAXIMUM_POSES, load_poses, save_poses
from layfigure.session.commands.pose import pose_line
from layfigure.session.figures import reference_to
from layfigure.session.picture_file import save_sheet
from layfigure.session.words import join_line, no_more, number, required, whole_number

if TYPE_CHECKING:
    from layfigure.session.session import Session

VARIANTS = 8
BREATH = 4.0
"""How many variants bring a still character to life, and at which intensity, unless one says otherwise."""


def _save(session: Session, words: tuple[str, ...]) -> None:
    no_more(words, 1)
    path = _save_path(session, words[0] if words else "")
    figure, pose = session.document.figure, session.document.pose
    if path.suffix not in (".pose", ""):
        if session.host.first("layfigure_write", document=Exchange(figure, (pose,)), path=path) is None:
            raise FileError(f'{path}: no plug-in writes "{path.suffix}" files; use .pose')
        session.say(f"Saved {path.name}.")
        return
    path = path.with_suffix(".pose")
    save_pose(path, figure, pose)
    session.saved_as = path
    picture = path.with_suffix(".png")
    save_sheet(session, pose, picture)
    session.say(f"Saved {_shown(path)} and its picture {picture.name}.")


def _breathe(session: Session, words: tuple[str, ...]) -> None:
    name = required(words, 0, "a file's name")
    count = whole_number(words, 1, "a number of variants", (1, MAXIMUM_POSES - 1)) if len(words) > 1 else VARIANTS
    intensity = number(words, 2, "an intensity from 0 to 100") if len(words) > 2 else BREATH
    no_more(words, 3)
    path = named_file(session, name).with_suffix(".poses")
    poses = breathing(session, count, intensity)
    save_poses(path, session.document.figure, poses)
    session.say(f"Saved {_shown(path)}: the pose and {len(poses) - 1} variants.")


def breathing(session: Session, count: int, intensity: float) -> tuple[Pose, ...]:
    """Return the present pose and up to ``count`` small variants of it, made by the technique in use.

    Raises:
        ImpossibleError: the intensity is not in 0..100, or the technique makes no variants, or none can be had.
    """
    if not 0 <= intensity <= 100:
        raise ImpossibleError(f"the intensity goes from 0 to 100, {intensity:g} is not in it")
    found = session.workshop.variants(session.document, count, intensity)
    if not found:
        raise ImpossibleError("this pose has no such variants; try a higher intensity, or free some limbs")
    return (session.document.pose, *found)


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


def _save_path(session: Session, name: str) -> Path:
    if name:
        return named_file(session, name)
    if session.saved_as is not None:
        return session.saved_as
    return free_path(session.options.folder, session.document.figure.name)


def free_path(folder: Path, figure: str) -> Path:
    """Return the first of ``figure-1.pose``, ``figure-2.pose``, … that takes no existing pose or picture's place.

    Raises:
        ImpossibleError: thousands of names are taken.
    """
    stem = "".join(character if character.isalnum() or character in "-_" else "-" for character in figure)
    for count in range(1, 10_000):
        path = folder / f"{stem}-{count}.pose"
        if not path.exists() and not path.with_suffix(".png").exists():
            return path
    raise ImpossibleError("thousands of poses are here already; save under a name of your own")


def _open(session: Session, words: tuple[str, ...]) -> None:
    path = named_file(session, required(words, 0, "a file's name"))
    no_more(words, 1)
    if path.suffix == ".fig":
        session.execute(join_line("figure", [str(path)]))
        return
    figure, pose = figure_and_pose(session.host, path)
    if reference_to(figure) != reference_to(session.document.figure):
        session.execute(join_line("figure", [reference_to(figure)]))
    session.execute(pose_line(session, pose))
    session.saved_as = path if path.suffix == ".pose" else None
    session.say(f"Opened {_shown(path)}.")


def figure_and_pose(host: Host, path: Path) -> tuple[Figure, Pose]:
    """Return what a ``.pose`` file holds, or the first pose of a set or of a file that a plug-in reads.

    Raises:
        LayfigureError: there is no such file, it has a mistake, or nothing reads its kind.
    """
    if path.suffix == ".pose":
        return load_pose(path)
    if path.suffix == ".poses":
        figure, poses = load_poses(path)
        return figure, poses[0]
    exchange = host.first("layfigure_read", path=path)
    if not isinstance(exchange, Exchange) or not exchange.poses:
        raise FileError(f'{path}: is neither a .pose nor a .fig file, and no plug-in reads "{path.suffix}" files')
    return exchange.figure, exchange.poses[0]


def _picture(session: Session, words: tuple[str, ...]) -> None:
    name = required(words, 0, "a picture's name")
    no_more(words, 1)
    path = named_file(session, name)
    path = path if path.suffix else path.with_suffix(".png")
    save_sheet(session, session.document.pose, path)
    session.say(f"Saved {_shown(path)}.")


def _save_log(session: Session, words: tuple[str, ...]) -> None:
    name = required(words, 0, "a log's name")
    no_more(words, 1)
    path = named_file(session, name).with_suffix(".log")
    write_text(path, "\n".join(session.log) + "\n")
    session.say(f"Saved {_shown(path)}; layfigure replay plays it again.")


def _screenshot(session: Session, words: tuple[str, ...]) -> None:
    no_more(words, 1)
    name = words[0] if words else ""
    path = named_file(session, name) if name else free_path(session.options.folder, "window")
    session.screenshot_request = path.with_suffix(".png")
    session.say(f"Saved {_shown(path.with_suffix('.png'))}.")


def _shown(path: Path) -> str:
    try:
        return str(path.relative_to(Path.cwd()))
    except ValueError:
        return str(path)


COMMANDS = (
    Command("save", "Save the pose and its picture", _save, "[NAME]"),
    Command("breathe", "Save small variants of the pose as a set", _breathe, "NAME [VARIANTS [INTENSITY]]"),
    Command("open", "Open a pose or a figure", _open, "FILE"),
    Command("picture", "Save a picture of the pose", _picture, "NAME"),
    Command("save-log", "Save the session as a log that can be replayed", _save_log, "NAME"),
    Command("screenshot", "Save a picture of the window", _screenshot, "[NAME]"),
)
