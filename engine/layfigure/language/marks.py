"""Words that open, part and close blocks, as the parser meets them: a flat run that ``blocks`` nests."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

from layfigure.language.places import Place
from layfigure.language.syntax import Expression, Identifier, Statement


class Word(Enum):
    """A word that parts or closes a block; the value is how a message spells it."""

    ELSE = "ELSE"
    ENDIF = "ENDIF"
    BEGIN = "BEGIN"
    END = "END"
    ENDFOR = "ENDFOR"
    ENDWHILE = "ENDWHILE"
    CONTINUE = "CONTINUE"
    ENDMODEL = "ENDMODEL"
    ENDJOINT = "ENDJOINT"
    ENDMOTION = "ENDMOTION"
    STARTSCENE = "STARTSCENE"
    ENDSCENE = "ENDSCENE"


@dataclass(frozen=True, slots=True)
class Separator:
    """A ``;`` or the end of a line."""


@dataclass(frozen=True, slots=True)
class Mark:
    """A word of :class:`Word`, with the label of a CONTINUE."""

    place: Place
    word: Word
    label: str = ""


@dataclass(frozen=True, slots=True)
class If:
    """IF condition THEN; ``further`` where it is ELSE IF."""

    place: Place
    condition: Expression
    further: bool


@dataclass(frozen=True, slots=True)
class Counted:
    """The head of FOR, or of DO with the label that closes it."""

    place: Place
    variable: Identifier
    first: Expression
    last: Expression
    step: Expression | None
    labelled: bool = False
    label: str = ""

    @property
    def spelled(self) -> str:
        """The head as a message names it."""
        return f"DO {self.label}".strip() if self.labelled else "FOR"


@dataclass(frozen=True, slots=True)
class WhileHead:
    """WHILE condition."""

    place: Place
    condition: Expression


@dataclass(frozen=True, slots=True)
class ModelHead:
    """STARTMODEL name."""

    place: Place
    name: Identifier


@dataclass(frozen=True, slots=True)
class MotionHead:
    """STARTMOTION name."""

    place: Place
    name: Identifier


@dataclass(frozen=True, slots=True)
class SceneHead:
    """INITIALIZE SCENE number."""

    place: Place
    number: Expression


@dataclass(frozen=True, slots=True)
class SceneStart:
    """STARTSCENE LENGTH length [SAMEFRAME images]."""

    place: Place
    length: Expression
    same_frame: Expression | None


Head = If | Counted | WhileHead | ModelHead | MotionHead | SceneHead | SceneStart
Item = Statement | Head | Mark | Separator
