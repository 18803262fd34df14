"""LOAD: figures, motions, poses and libraries, from files or from what is shipped."""

from __future__ import annotations

import os
import re
from pathlib import Path
from typing import TYPE_CHECKING

from layfigure import resources
from layfigure.errors import FileError
from layfigure.figures.library import figure_names, load_figure
from layfigure.files.reading import read_text
from layfigure.language import syntax
from layfigure.language.evaluating import blamed
from layfigure.language.parsing import parse_script
from layfigure.language.places import Place
from layfigure.language.scope import Scope
from layfigure.language.values import PoseOf, text
from layfigure.models import Model
from layfigure.motions.library import motion_names, shipped_motion
from layfigure.motions.motion import Motion
from layfigure.motions.motion_file import load_motion
from layfigure.poses.pose_file import load_pose
from layfigure.suggestions import did_you_mean

if TYPE_CHECKING:
    from layfigure.language.executing import Executor

SUFFIXES = (".fig", ".motion", ".pose", ".lay")
MAXIMUM_DEPTH = 10  # of libraries that load libraries
_NAME = re.compile(r"[^\W\d]\w*")


def load(executor: Executor, node: syntax.Load) -> None:
    """Do LOAD: give a name the value of a file, or take over the names of a library.

    Raises:
        SourceError: there is no such thing, the file has a mistake, or a limit is passed.
    """
    what = text(executor.evaluator.value(node.what), "what is loaded", node.what.place)
    with blamed(node.what.place):
        path = _found(what, executor.folder)
        if path.suffix.lower() == ".lay":
            _library(executor, path, node)
            return
        _count(executor, path, node.what.place)
        value = _value(executor, what, path)
    if isinstance(value, Motion):
        executor.run.meter.keys(value.key_count, node.what.place)
        executor.run.meter.work("keys", value.key_count, node.place)
    executor.scope.set(node.name or _name_of(path, node.what.place), value)


def _found(what: str, folder: Path) -> Path:
    """Return the path of a file, or of what is shipped under a name."""
    suffix = Path(what).suffix.lower()
    if suffix in SUFFIXES or "/" in what or os.sep in what:
        if suffix not in SUFFIXES:
            raise FileError(f'"{what[:80]}" cannot be loaded; a script loads {", ".join(SUFFIXES)} files')
        return folder / what
    figures = {path.stem.casefold(): path for path in resources.model_files()}
    found = figures.get(what.casefold()) or shipped_motion(what)
    if found is None:
        known = [*figure_names(), *motion_names()]
        hint = did_you_mean(what, known) or f"; there are {', '.join(known)}"
        raise FileError(f'nothing is shipped under the name "{what[:80]}"{hint}')
    return found


def _count(executor: Executor, path: Path, place: Place) -> None:
    """Count a file and its bytes before it is read."""
    executor.run.meter.count("loads", 1, place)
    try:
        size = path.stat().st_size
    except (OSError, ValueError):
        return  # reading it will say why
    executor.run.meter.count("bytes", size, place)


def _value(executor: Executor, what: str, path: Path) -> object:
    suffix = path.suffix.lower()
    if suffix == ".motion":
        return load_motion(path, executor.run.curves).motion
    if suffix == ".pose":
        return PoseOf(*load_pose(path))
    return Model.of_figure(load_figure(path if Path(what).suffix else what))


def _library(executor: Executor, path: Path, node: syntax.Load) -> None:
    """Run another script and take over what it defined."""
    run, place = executor.run, node.what.place
    if node.name is not None:
        raise node.name.place.error("a library gives its own names; remove AS")
    if len(run.reading) > MAXIMUM_DEPTH or path.resolve() in [known.resolve() for known in run.reading]:
        raise place.error(f"{path.name} is being read already; a script cannot load itself")
    _count(executor, path, place)
    block = parse_script(read_text(path), str(path), run.meter)
    scope, before = Scope(), run.reading
    run.reading = (*before, path)
    type(executor)(run, scope, path.parent).block(block)
    run.reading = before
    executor.scope.adopt(scope, run.meter)


def _name_of(path: Path, place: Place) -> syntax.Identifier:
    """Return the name that a loaded file gets: its own, with _ for what no name can have."""
    spelled = re.sub(r"\W", "_", path.stem)
    if not _NAME.fullmatch(spelled):
        raise place.error(f'"{path.stem}" cannot be a name; choose one: LOAD "{path.name}" AS name')
    return syntax.Identifier(place, spelled.casefold(), spelled)
