"""Commands that read and write files."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from layfigure.errors import FileError, ImpossibleError, LayfigureError, SourceError
from layfigure.figures.figure import Figure
from layfigure.files.writing import write_text
from layfigure.motions.library import SUFFIX as MOTION
from layfigure.motions.library import is_shipped, shipped_motion
from layfigure.plugins.host import Host
from layfigure.plugins.records import Command, Exchange
from layfigure.poses.pose import Pose
from layfigure.poses.pose_file import load_pose, save_pose
from layfigure.poses.pose_set import MAXIMUM_POSES, load_poses, save_poses
from layfigure.session.commands.arguments import named_file
from layfigure.session.commands.naming import free_path, save_path
from layfigure.session.commands.pose import pose_line
from layfigure.session.document import Document
from layfigure.session.figures import figure_beside, reference_to
from layfigure.session.moments import known_curves, motion_of
from layfigure.session.picture_file import save_sheet
from layfigure.session.words import join_line, no_more, number, required, whole_number

if TYPE_CHECKING:
    from layfigure.motions.motion import Motion
    from layfigure.session.session import Session

VARIANTS = 8
BREATH = 4.0
"""How many variants bring a still character to life, and at which intensity, unless one says otherwise."""
STEP = 12
"""Frames from one pose to the next where poses become keys."""


def _save(session: Session, words: tuple[str, ...]) -> None:
    no_more(words, 1)
    path = named_file(session, words[0]) if words and words[0] else save_path(session)
    if path.suffix == MOTION or (not path.suffix and session.document.motion is not None):
        _save_motion(session, path.with_suffix(MOTION))
        return
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


def _save_motion(session: Session, path: Path) -> None:
    from layfigure.motions.motion_file import save_motion

    document = session.document
    save_motion(path, motion_of(document), document.figure, document.rate)
    session.saved_as = path
    session.say(f"Saved {_shown(path)}.")


def _breathe(session: Session, words: tuple[str, ...]) -> None:
    name = required(words, 0, "a file's name")
    count = whole_number(words, 1, "a number of variants", (1, MAXIMUM_POSES - 1)) if len(words) > 1 else VARIANTS
    intensity = number(words, 2, "an intensity from 0 to 100") if len(words) > 2 else BREATH
    no_more(words, 3)
    path = named_file(session, name)
    poses = breathing(session, count, intensity)
    if path.suffix == MOTION:
        save_breath(path, session.document, poses)
        session.say(f"Saved {_shown(path)}: a loop through the pose and {len(poses) - 1} variants.")
        return
    path = path.with_suffix(".poses")
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


def save_breath(path: Path, document: Document, poses: Sequence[Pose]) -> None:
    """Write a motion file that loops through poses of a document's figure.

    Raises:
        FileError: the file cannot be written.
    """
    from layfigure.motions.motion_file import save_motion

    save_motion(path, looped_motion(document, poses), document.figure, document.rate)


def looped_motion(document: Document, poses: Sequence[Pose], step: int = STEP) -> Motion:
    """Return the motion that goes through poses of a document's figure, ``step`` frames each, and to the first again.

    Raises:
        LayfigureError: the motion would grow too large.
    """
    from layfigure.motions.building import from_poses

    return from_poses(document.figure, [(step * index, pose) for index, pose in enumerate(poses)], loop=True)


def _open(session: Session, words: tuple[str, ...]) -> None:
    name = required(words, 0, "a file's name")
    path = named_file(session, name)
    no_more(words, 1)
    if path.suffix == ".fig":
        session.execute(join_line("figure", [str(path)]))
        return
    motion = _motion_path(path, name)
    if motion is not None:
        _open_motion(session, motion)
        return
    figure, pose = figure_and_pose(session.host, path)
    if reference_to(figure) != reference_to(session.document.figure):
        session.execute(join_line("figure", [reference_to(figure)]))
    session.execute(pose_line(session, pose))
    session.saved_as = path if path.suffix == ".pose" else None
    session.say(f"Opened {_shown(path)}.")


def _motion_path(path: Path, name: str) -> Path | None:
    """Return the motion file that a name means: in the folder, else one that is shipped; None: it means no motion."""
    own = path.with_suffix(MOTION)
    if path.suffix not in ("", MOTION):
        return None
    if os.path.exists(own):  # noqa: PTH110 - a name that no file can have is no error here
        return own
    return shipped_motion(name) or (own if path.suffix else None)


def _open_motion(session: Session, path: Path) -> None:
    """Open a motion; its figure comes with it."""
    from layfigure.motions.motion_file import load_motion
    from layfigure.session.motion_packing import motion_lines

    found = load_motion(path, known_curves(session.host))
    if found.figure is not None:
        try:
            figure = figure_beside(session.host, found.figure, path.parent)
        except SourceError:  # a figure there is, with a mistake of its own
            raise
        except LayfigureError as error:
            raise found.without_figure(error) from None
        if reference_to(figure) != reference_to(session.document.figure):
            session.execute(join_line("figure", [reference_to(figure)]))
    for line in motion_lines(found.motion, found.rate):
        session.execute(line)
    session.saved_as = None if is_shipped(path) else path
    said = session.status[:1].lower() + session.status[1:]
    session.say(f"Opened {path.stem if is_shipped(path) else _shown(path)}: {said}")


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
    if path.suffix.lower() == MOTION:
        sentence = f"is a motion, not a pose; layfigure check tells of it, and layfigure render {path.name} draws it"
        raise FileError(f"{path}: {sentence}")
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
    Command("save", "Save the motion, or the pose and its picture", _save, "[NAME]"),
    Command("breathe", "Save small variants of the pose as a set", _breathe, "NAME [VARIANTS [INTENSITY]]"),
    Command("open", "Open a pose, a motion or a figure", _open, "FILE"),
    Command("picture", "Save a picture of the pose", _picture, "NAME"),
    Command("save-log", "Save the session as a log that can be replayed", _save_log, "NAME"),
    Command("screenshot", "Save a picture of the window", _screenshot, "[NAME]"),
)
