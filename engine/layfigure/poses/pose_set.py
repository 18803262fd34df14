"""The ``.poses`` text file: poses of one figure one after the other, each as a ``.pose`` file has it.

::

    layfigure pose 1
    figure humanoid
    spine flexion -20 pivot 0 twist 0

    layfigure pose 1
    figure humanoid
    spine flexion -25 pivot 0 twist 0

So pose files put behind one another are a set, and a set reads back exactly.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from functools import cache
from itertools import pairwise
from pathlib import Path

from layfigure.errors import SourceError
from layfigure.figures.figure import Figure
from layfigure.figures.library import load_figure
from layfigure.files.reading import read_text
from layfigure.files.writing import write_text
from layfigure.poses.pose import Pose
from layfigure.poses.pose_file import read_pose, write_pose

MAXIMUM_POSES = 1000
MAXIMUM_SET_BYTES = 4 * 1024 * 1024

_HEADER = re.compile(r"^[^\S\n]*layfigure\b", re.MULTILINE | re.IGNORECASE)


def save_poses(path: Path, figure: Figure, poses: Sequence[Pose]) -> None:
    """Write a ``.poses`` file; a figure of one's own is named relative to it.

    Raises:
        FileError: the file cannot be written.
        LayfigureError: a pose cannot belong to the figure.
    """
    write_text(path, "\n".join(write_pose(figure, pose, path.parent) for pose in poses))


def load_poses(path: Path) -> tuple[Figure, tuple[Pose, ...]]:
    """Return the figure and the poses, at least one, of a ``.poses`` file.

    Raises:
        FileError: the file cannot be read.
        SourceError: the file has a mistake.
    """
    return read_poses(read_text(path, maximum_bytes=MAXIMUM_SET_BYTES), path)


def read_poses(text: str, source: str | Path) -> tuple[Figure, tuple[Pose, ...]]:
    """Return the figure and the poses, at least one, that a text describes; ``source`` names the text in errors.

    Raises:
        SourceError: the first mistake, two figures in one set, or more than :data:`MAXIMUM_POSES` poses.
    """
    load = cache(lambda reference: load_figure(reference, Path(source).parent))
    later = [match.start() for match in _HEADER.finditer(text)][1:]
    found: list[tuple[Figure, Pose]] = []
    for begin, end in pairwise([0, *later, len(text)]):
        first_line = text.count("\n", 0, begin) + 1
        if len(found) == MAXIMUM_POSES:
            raise SourceError(source, first_line, 1, f"this is one pose too many; a set has up to {MAXIMUM_POSES}")
        found.append(read_pose(text[begin:end], source, load, first_line))
        if found[-1][0] is not found[0][0]:
            names = f"{found[-1][0].name}, but the set begins with {found[0][0].name}"
            raise SourceError(source, first_line, 1, f"this is a pose of {names}; put it into a file of its own")
    return found[0][0], tuple(pose for _, pose in found)
