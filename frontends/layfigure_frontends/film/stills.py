"""Poses as pictures that carry them: what is saved so opens again as the pose it shows."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from layfigure_frontends.film.choice import FilmChoice
from layfigure_frontends.film.opening import MOTION, SCRIPT, check_asked
from layfigure_frontends.film.outputs import moves
from layfigure_frontends.film.sinks import frames

if TYPE_CHECKING:
    from layfigure.poses.pose import Pose
    from layfigure_frontends.opening import PluginChoice

SET = ".poses"


def draw_stills(source: Path, output: Path, asked: FilmChoice, choice: PluginChoice) -> list[Path]:
    """Draw a pose, or the poses of a set into a folder; return what was written, nothing if a film is wanted.

    Pictures are written by whichever plug-in knows the format.

    Raises:
        LayfigureError: the source cannot be opened or the output cannot be written.
    """
    kind = source.suffix.lower()
    if moves(output) or kind in (MOTION, SCRIPT) or (kind == SET and output.suffix):
        return []
    check_asked(source, asked)
    from layfigure.poses.pose_set import load_poses
    from layfigure.session.picture_file import save_picture
    from layfigure_frontends.film.sources.poses import options_for, session_on

    session = session_on(source, asked, choice)
    poses: tuple[Pose, ...] = (session.document.pose,)
    paths = [output]
    if kind == SET:
        poses = load_poses(source)[1]
        frames.make_folder(output)
        paths = [output / f"{source.stem}-{number}.png" for number in range(1, len(poses) + 1)]
    for pose, path in zip(poses, paths, strict=True):
        save_picture(session, pose, path, options_for(asked))
    return paths
