"""What a script says, as a tree of frozen values; every node knows its place.

Names are held casefolded, with ``spelled`` as the author wrote them. ``depth`` of an expression is the length of its
longest branch; it is bounded when the tree is built, so that walking the tree cannot exhaust the stack.
"""

from __future__ import annotations

from dataclasses import dataclass, fields
from fractions import Fraction

from layfigure.language.places import Place


@dataclass(frozen=True, slots=True)
class Identifier:
    """A name where it stands."""

    place: Place
    name: str
    spelled: str


@dataclass(frozen=True, slots=True)
class Expression:
    """Anything that has a value."""

    place: Place
    depth: int


@dataclass(frozen=True, slots=True)
class Literal(Expression):
    """A number, a string, TRUE or FALSE."""

    value: int | Fraction | str | bool


@dataclass(frozen=True, slots=True)
class Variable(Expression):
    """A name that stands for a value."""

    name: str
    spelled: str


@dataclass(frozen=True, slots=True)
class VectorOf(Expression):
    """Numbers in brackets: a point, a range."""

    items: tuple[Expression, ...]


@dataclass(frozen=True, slots=True)
class Call(Expression):
    """A function with its arguments."""

    name: str
    spelled: str
    arguments: tuple[Expression, ...]


@dataclass(frozen=True, slots=True)
class Chain(Expression):
    """Operations of equal rank, worked from the left: ``rest`` holds (operator, where it stands, operand)."""

    first: Expression
    rest: tuple[tuple[str, Place, Expression], ...]


@dataclass(frozen=True, slots=True)
class Comparison(Expression):
    """Two values compared by ``=``, ``<>``, ``<``, ``<=``, ``>`` or ``>=``."""

    left: Expression
    operator: str
    right: Expression


@dataclass(frozen=True, slots=True)
class Logic(Expression):
    """Truth values joined by AND (``every``) or OR; stops at the first that decides."""

    every: bool
    items: tuple[Expression, ...]


@dataclass(frozen=True, slots=True)
class Negation(Expression):
    """NOT of a truth value."""

    item: Expression


@dataclass(frozen=True, slots=True)
class Sign(Expression):
    """A value with ``-`` or ``+`` before it."""

    negative: bool
    item: Expression


@dataclass(frozen=True, slots=True)
class Solid(Expression):
    """A graphical object made from nothing: ``parts`` holds (word, its values)."""

    kind: str
    parts: tuple[tuple[Identifier, tuple[Expression, ...]], ...]


@dataclass(frozen=True, slots=True)
class Modifier:
    """One transformation between angle brackets.

    ``kind`` is trans, trans joints, scale, scale model, scale extremes, scale frames, rotate, or rotate x, y, z.
    """

    place: Place
    kind: str
    value: Expression


@dataclass(frozen=True, slots=True)
class Modified(Expression):
    """A changed instance of a value."""

    item: Expression
    modifiers: tuple[Modifier, ...]


@dataclass(frozen=True, slots=True)
class JointOf(Expression):
    """JOINT id, primary, point, secondary, point and up to three ranges."""

    operands: tuple[Expression, ...]


@dataclass(frozen=True, slots=True)
class Strip(Expression):
    """STRIP motion, joints."""

    operands: tuple[Expression, ...]


@dataclass(frozen=True, slots=True)
class Synchronize(Expression):
    """SYNCHRONIZE motions."""

    operands: tuple[Expression, ...]


@dataclass(frozen=True, slots=True)
class FigureOf(Expression):
    """FIGURE model MAIN LINK link, MAIN JOINT joint, or with neither; as a statement it changes the variable."""

    model: Identifier
    by: str  # "", "link" or "joint"
    main: Expression | None


def names_in(node: object) -> set[str]:
    """Return the folded names that an expression reads."""
    if isinstance(node, Variable | Identifier):
        return {node.name}
    if isinstance(node, tuple) and not isinstance(node, Place):
        return {name for part in node for name in names_in(part)}
    if isinstance(node, Expression | Modifier):
        return {name for part in fields(node) for name in names_in(getattr(node, part.name))}
    return set()


@dataclass(frozen=True, slots=True)
class Statement:
    """Anything that does something."""

    place: Place


@dataclass(frozen=True, slots=True)
class Assignment(Statement):
    """A value given to a name."""

    target: Identifier
    value: Expression


@dataclass(frozen=True, slots=True)
class KeyAssignment(Statement):
    """motion[joint, key] = FRAME ... POSITION ... INTERPOLATE ..."""

    target: Identifier
    joint: Expression
    number: Expression
    frame: Expression
    position: tuple[Expression, ...]
    how: Identifier | None


@dataclass(frozen=True, slots=True)
class Declaration(Statement):
    """Names that hold values of one kind only."""

    kind: str
    names: tuple[Identifier, ...]


@dataclass(frozen=True, slots=True)
class Symbols:
    """$name: a model's symbol table."""

    target: Identifier


@dataclass(frozen=True, slots=True)
class Print(Statement):
    """Values and symbol tables to show."""

    items: tuple[Expression | Symbols, ...]


@dataclass(frozen=True, slots=True)
class Load(Statement):
    """A file, or what is shipped under a name, to be given a name."""

    what: Expression
    name: Identifier | None


@dataclass(frozen=True, slots=True)
class Save(Statement):
    """A value to be written to a file."""

    value: Expression
    file: Expression


@dataclass(frozen=True, slots=True)
class Stop(Statement):
    """The end of the run."""


@dataclass(frozen=True, slots=True)
class ModelJoint(Statement):
    """A joint inside STARTMODEL ... ENDMODEL."""

    joint: JointOf


@dataclass(frozen=True, slots=True)
class Rerooting(Statement):
    """FIGURE as a statement."""

    figure: FigureOf


@dataclass(frozen=True, slots=True)
class MotionJoint(Statement):
    """JOINT id [POSITION ...] inside STARTMOTION ... ENDMOTION."""

    joint: Expression
    position: tuple[Expression, ...] | None


@dataclass(frozen=True, slots=True)
class MotionKey(Statement):
    """FRAME f POSITION ... [INTERPOLATE how] inside STARTMOTION ... ENDMOTION."""

    frame: Expression
    position: tuple[Expression, ...]
    how: Identifier | None


@dataclass(frozen=True, slots=True)
class View(Statement):
    """VIEW POINT, VIEW WIDTH or VIEW TARGET; ``what`` is point, width or target."""

    what: str
    value: Expression


@dataclass(frozen=True, slots=True)
class Floor(Statement):
    """FLOOR height: the ground that figures stand on."""

    height: Expression


@dataclass(frozen=True, slots=True)
class Background(Statement):
    """Objects that stand behind."""

    objects: tuple[Expression, ...]


@dataclass(frozen=True, slots=True)
class Animate(Statement):
    """A model moved by a motion in the frames ``first`` to ``last`` of a scene."""

    model: Identifier
    first: Expression | None
    last: Expression | None
    motion: Expression
    repeat: bool


@dataclass(frozen=True, slots=True)
class Shoot(Statement):
    """SHOOTSCENES."""


Block = tuple[Statement, ...]


@dataclass(frozen=True, slots=True)
class Choice(Statement):
    """IF: the block of the first true condition, else ``otherwise``."""

    branches: tuple[tuple[Expression, Block], ...]
    otherwise: Block


@dataclass(frozen=True, slots=True)
class Count(Statement):
    """FOR and DO: a block for every value of a variable from ``first`` to ``last``."""

    variable: Identifier
    first: Expression
    last: Expression
    step: Expression | None
    body: Block


@dataclass(frozen=True, slots=True)
class While(Statement):
    """A block as long as a condition holds."""

    condition: Expression
    body: Block


@dataclass(frozen=True, slots=True)
class ModelBlock(Statement):
    """STARTMODEL name ... ENDMODEL."""

    name: Identifier
    joints: tuple[JointOf, ...]


@dataclass(frozen=True, slots=True)
class MotionBlock(Statement):
    """STARTMOTION name ... ENDMOTION: joints, each with its keys."""

    name: Identifier
    tracks: tuple[tuple[MotionJoint, tuple[MotionKey, ...]], ...]


@dataclass(frozen=True, slots=True)
class SceneBlock(Statement):
    """INITIALIZE SCENE n ... STARTSCENE LENGTH k [SAMEFRAME i] ... ENDSCENE."""

    number: Expression
    initial: Block
    length: Expression
    same_frame: Expression | None
    body: Block
