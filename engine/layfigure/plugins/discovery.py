"""Where plug-ins come from: installed entry points, the user's plug-ins folder, and files named on the command line."""

from __future__ import annotations

import importlib.metadata
import importlib.util
import sys
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from importlib.machinery import SourceFileLoader
from pathlib import Path
from typing import NoReturn

from layfigure.errors import PluginError

GROUP = "layfigure"
_OWN_DISTRIBUTION = "layfigure"


@dataclass(frozen=True)
class Selection:
    """Which plug-ins to let in: extra one-file plug-ins, a folder of them, names to leave out, built-ins only."""

    files: tuple[Path, ...] = ()
    folder: Path | None = None
    without: frozenset[str] = frozenset()
    safe: bool = False


@dataclass(frozen=True)
class Found:
    """A plug-in not yet loaded: its name, where it lives, and how to import it."""

    name: str
    origin: str
    load: Callable[[], object] = field(repr=False)


def find_plugins(selection: Selection) -> Iterator[Found]:
    """Yield the plug-ins of a selection: the house's own first, then installed ones by name, then files."""
    yield from (found for found in _candidates(selection) if found.name not in selection.without)


def _candidates(selection: Selection) -> Iterator[Found]:
    points = importlib.metadata.entry_points(group=GROUP)
    ours = sorted((point for point in points if _is_own(point)), key=lambda point: point.name)
    theirs = sorted((point for point in points if not _is_own(point)), key=lambda point: point.name)
    for point in ours if selection.safe else ours + theirs:
        yield Found(point.name, point.value, point.load)
    if selection.safe:
        return
    in_folder = sorted(selection.folder.glob("*.py")) if selection.folder and selection.folder.is_dir() else []
    for path in [*in_folder, *selection.files]:
        yield plugin_file(path)


def plugin_file(path: Path) -> Found:
    """Return a one-file plug-in; it is called like its file."""
    return Found(path.stem, str(path), _loader(path))


def _is_own(point: importlib.metadata.EntryPoint) -> bool:
    return point.dist is not None and point.dist.name == _OWN_DISTRIBUTION


class _FreshSource(SourceFileLoader):
    """Reads the file at each load: Python's compiled files cannot tell two saves within one second apart."""

    def path_stats(self, path: str) -> NoReturn:
        """Refuse, which is how a loader says that there is nothing to go by."""
        raise OSError(f"{path}: compiled files are not kept for plug-in files")


def _loader(path: Path) -> Callable[[], object]:
    def load() -> object:
        if not path.is_file():
            raise PluginError(f"{path}: there is no such plug-in file; check the name")
        if path.suffix != ".py":
            raise PluginError(f"{path}: is not a Python file; a plug-in file ends in .py")
        name = f"layfigure_plugin_file_{path.stem}"
        spec = importlib.util.spec_from_file_location(name, path, loader=_FreshSource(name, str(path)))
        assert spec is not None
        assert spec.loader is not None
        module = importlib.util.module_from_spec(spec)
        before = sys.modules.get(name)
        sys.modules[name] = module
        try:
            spec.loader.exec_module(module)
        except BaseException:
            sys.modules.pop(name)
            sys.modules.update({name: before} if before is not None else {})
            raise
        return module

    return load
