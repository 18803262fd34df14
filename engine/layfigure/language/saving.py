"""SAVE: what a script wants written, checked and put into words; nothing is written here."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from layfigure.language import syntax, values
from layfigure.language.evaluating import blamed
from layfigure.language.run import Saving
from layfigure.language.values import PoseOf
from layfigure.models import Model
from layfigure.models.saving import fig_text
from layfigure.motions.motion import Motion
from layfigure.motions.motion_file import write_motion
from layfigure.poses.pose_file import write_pose

if TYPE_CHECKING:
    from layfigure.language.executing import Executor


def saving(executor: Executor, node: syntax.Save) -> Saving:
    """Return what SAVE writes, and where.

    Raises:
        SourceError: the value cannot be saved in such a file, the file lies outside the script's folder, or a limit
            is passed.
    """
    value = executor.evaluator.value(node.value)
    name = values.text(executor.evaluator.value(node.file), "the file's name", node.file.place)
    run, place = executor.run, node.file.place
    suffix = {Motion: ".motion", PoseOf: ".pose", Model: ".fig"}.get(type(value))
    if suffix is None:
        raise node.value.place.error(f"motions, poses and models can be saved, but this is {values.kind_of(value)}")
    path = run.folder / name
    if path.suffix.lower() != suffix:
        raise place.error(f"{values.kind_of(value)} is saved in a file that ends in {suffix}")
    if not run.meter.limits.outside and not _inside(path, run.folder):
        raise place.beyond("outside", "a script saves into its own folder and those below")
    if isinstance(value, Motion):
        run.meter.work("keys", value.key_count, place)
    with blamed(place):
        text = _text(value, path)
    run.meter.count("loads", 1, place)
    run.meter.count("bytes", len(text), place)
    return Saving(path, text)


def _text(value: object, path: Path) -> str:
    if isinstance(value, Motion):
        return write_motion(value)
    if isinstance(value, PoseOf):
        return write_pose(value.figure, value.pose, path.parent)
    assert isinstance(value, Model)
    return fig_text(value)


def _inside(path: Path, folder: Path) -> bool:
    """Whether a path lies in a folder once links and dots are followed."""
    try:
        return path.resolve().is_relative_to(folder.resolve())
    except (OSError, RuntimeError, ValueError):
        return False
