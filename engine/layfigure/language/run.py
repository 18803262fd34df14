"""What a run of a script gathers, whichever of its files says it."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

from layfigure.language import syntax
from layfigure.language.limits import Meter
from layfigure.language.places import Place
from layfigure.language.scope import Scope
from layfigure.motions.standard import STANDARD, Curves
from layfigure.scenes.framing import ASPECT
from layfigure.scenes.performing import Stage
from layfigure.scenes.picture import Shooting


@dataclass(frozen=True)
class Saving:
    """A file that a script wants written, with its whole text."""

    path: Path
    text: str


@dataclass(frozen=True)
class Defined:
    """A scene that waits to be shot: its statements, and the variables as they were where it was defined."""

    block: syntax.SceneBlock
    scope: Scope


@dataclass
class Run:
    """The state of a run: what was printed, warned of, saved and shot, and the scenes and models in between.

    ``folder`` is the script's own; ``aspect`` is the width of its pictures by their height.
    """

    meter: Meter
    folder: Path
    curves: Curves = field(default_factory=lambda: STANDARD)
    aspect: float = ASPECT
    printed: list[str] = field(default_factory=list)
    warnings: list[str] = field(default_factory=list)
    savings: list[Saving] = field(default_factory=list)
    waiting: dict[int, Defined] = field(default_factory=dict)
    shot: list[Shooting] = field(default_factory=list)
    stage: Stage = field(init=False)
    reading: tuple[Path, ...] = ()  # the libraries being read, one inside the other

    def __post_init__(self) -> None:
        """Set the stage that all scenes share: models keep their orientation from one to the next."""
        self.stage = Stage(self.curves)

    def warn(self, place: Place, sentence: str) -> None:
        """Note what is allowed but seldom meant, once."""
        warning = str(place.error(sentence))
        if warning not in self.warnings and len(self.warnings) < 100:
            self.warnings.append(warning)
