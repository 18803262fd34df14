"""Runs a script: from its file to scenes ready to be drawn, the lines it printed, and the files it wants written."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from layfigure.errors import FileError, LayfigureError
from layfigure.files.reading import MAXIMUM_BYTES, read_text
from layfigure.files.writing import write_text
from layfigure.language.executing import Executor, Stopped
from layfigure.language.limits import Limits, Meter
from layfigure.language.parsing import parse_script
from layfigure.language.places import Place
from layfigure.language.run import Run, Saving
from layfigure.language.scope import Scope
from layfigure.motions.standard import STANDARD, Curves
from layfigure.scenes.framing import ASPECT
from layfigure.scenes.picture import Shooting


@dataclass(frozen=True)
class Programme:
    """What a script came to: its scenes in the order they were shot, what it printed, and warnings, a sentence each.

    ``savings`` are the files that SAVE asks for; nothing is written before :meth:`write`.
    """

    scenes: tuple[Shooting, ...]
    printed: tuple[str, ...] = ()
    warnings: tuple[str, ...] = ()
    savings: tuple[Saving, ...] = ()

    def write(self) -> tuple[Path, ...]:
        """Write the files that the script saves and return their paths.

        Raises:
            FileError: one cannot be written.
        """
        for saving in self.savings:
            write_text(saving.path, saving.text)
        return tuple(saving.path for saving in self.savings)


def run_script(
    path: Path, limits: Limits | None = None, curves: Curves = STANDARD, aspect: float = ASPECT
) -> Programme:
    """Return what a ``.lay`` file comes to; nothing is drawn and nothing is written.

    ``curves`` are the interpolations that motions may name, those of plug-ins where they count
    (:func:`layfigure.motions.standard.with_plugins`). Where the script leaves to the program how much is seen, pictures
    that are ``aspect`` times as wide as high hold all of it.

    Raises:
        FileError: the file cannot be read.
        SourceError: the script has a mistake, or does more than the limits allow; with line and column.
    """
    return run_text(read_text(path, maximum_bytes=MAXIMUM_BYTES), path, limits, curves, aspect)


def run_text(
    text: str, path: Path, limits: Limits | None = None, curves: Curves = STANDARD, aspect: float = ASPECT
) -> Programme:
    """Return what the text of a script comes to; ``path`` names it in messages, and its folder holds its files.

    Raises:
        SourceError: as for :func:`run_script`; ``printed`` is what the script had printed before.
    """
    meter = Meter(limits or Limits())
    run = Run(meter, path.parent, curves, aspect)
    run.reading = (path,)
    meter.count("bytes", len(text), Place(str(path), 1, 1))
    block = parse_script(text, str(path), meter)
    try:
        Executor(run, Scope(), path.parent).block(block)
    except Stopped:
        pass
    except LayfigureError as error:
        error.printed = tuple(run.printed)
        raise
    except RecursionError:  # the depth of trees and blocks is bounded; this is for who calls from a deep stack
        raise FileError(f"{path}: is nested too deeply; make the script flatter") from None
    for number, defined in run.waiting.items():
        run.warn(defined.block.place, f"scene {number} is never shot; add SHOOTSCENES")
    return Programme(tuple(run.shot), tuple(run.printed), tuple(run.warnings), tuple(run.savings))
