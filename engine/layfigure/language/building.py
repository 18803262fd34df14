"""Makes syntax out of what the parser finds: one method for each rule of ``grammar.lark``, called from the leaves up.

The tree is walked without recursion, so that deep nesting is a mistake like others and not the end of the program.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from fractions import Fraction
from typing import Any

from lark import Token
from lark.visitors import Transformer_NonRecursive

from layfigure.language import syntax as s
from layfigure.language.limits import MAXIMUM_NESTING, Meter
from layfigure.language.marks import (
    Counted,
    If,
    Item,
    Mark,
    ModelHead,
    MotionHead,
    SceneHead,
    SceneStart,
    Separator,
    WhileHead,
    Word,
)
from layfigure.language.places import Place

_NUMBER = re.compile(r"([0-9]*)\.?([0-9]*)(?:[eE]([-+]?[0-9]+))?°?")
_SEPARATOR = Separator()
_ASSIGNED = "EQUAL"


class Builder(Transformer_NonRecursive[Token, Any]):
    """Turns rules into values of :mod:`layfigure.language.syntax` and :mod:`layfigure.language.marks`.

    The methods are called by lark with the list of what the rule's parts became.
    """

    def __init__(self, source: str, meter: Meter) -> None:
        super().__init__()
        self._source = source
        self._meter = meter

    def start(self, items: list[Any]) -> tuple[Item, ...]:
        """Return the whole script, flat."""
        return tuple(_SEPARATOR if isinstance(item, Token) else item for item in items)

    # -- statements ------------------------------------------------------------------------------------------------

    def assignment(self, found: list[Any]) -> s.Assignment:
        """NAME = value."""
        target = self._identifier(found[0])
        return s.Assignment(target.place, target, found[-1])

    def key(self, found: list[Any]) -> s.KeyAssignment:
        """NAME[joint, key] = FRAME f POSITION p INTERPOLATE how."""
        name, joint, number, *_, frame, position, how = found
        target = self._identifier(name)
        return s.KeyAssignment(target.place, target, joint, number, frame, position, self._optional(how))

    def declaration(self, found: list[Any]) -> s.Declaration:
        """TYPE names."""
        kind, *names = found
        return s.Declaration(self._place(kind), kind.lower(), tuple(map(self._identifier, names)))

    def print_values(self, found: list[Any]) -> s.Print:
        """PRINT items."""
        return s.Print(self._place(found[0]), tuple(found[1:]))

    def symbols(self, found: list[Any]) -> s.Symbols:
        """$name."""
        return s.Symbols(self._identifier(found[1]))

    def load(self, found: list[Any]) -> s.Load:
        """LOAD what AS name."""
        return s.Load(self._place(found[0]), found[1], self._optional(found[2]))

    def save(self, found: list[Any]) -> s.Save:
        """SAVE value, file."""
        return s.Save(self._place(found[0]), found[1], found[2])

    def stop(self, found: list[Any]) -> s.Stop:
        """STOP."""
        return s.Stop(self._place(found[0]))

    def shoot(self, found: list[Any]) -> s.Shoot:
        """SHOOTSCENES."""
        return s.Shoot(self._place(found[0]))

    def view(self, found: list[Any]) -> s.View:
        """VIEW POINT = value."""
        return s.View(self._place(found[0]), found[1].lower(), found[-1])

    def floor(self, found: list[Any]) -> s.Floor:
        """FLOOR height."""
        return s.Floor(self._place(found[0]), found[1])

    def background(self, found: list[Any]) -> s.Background:
        """BACKGROUND objects."""
        return s.Background(self._place(found[0]), tuple(found[1:]))

    def animate(self, found: list[Any]) -> s.Animate:
        """ANIMATE model FROM f TO g USING motion REPEAT."""
        word, model, first, last, motion, repeat = found
        return s.Animate(self._place(word), self._identifier(model), first, last, motion, repeat is not None)

    def first_frame(self, found: list[Any]) -> s.Expression:
        """FROM f."""
        return self._last_of(found)

    def last_frame(self, found: list[Any]) -> s.Expression:
        """TO g."""
        return self._last_of(found)

    def model_joint(self, found: list[Any]) -> s.ModelJoint:
        """JOINT ... inside STARTMODEL."""
        return s.ModelJoint(found[0].place, found[0])

    def rerooting(self, found: list[Any]) -> s.Rerooting:
        """FIGURE ... as a statement."""
        return s.Rerooting(found[0].place, found[0])

    def motion_joint(self, found: list[Any]) -> s.MotionJoint:
        """JOINT id POSITION p inside STARTMOTION."""
        return s.MotionJoint(self._place(found[0]), found[1], found[2])

    def motion_key(self, found: list[Any]) -> s.MotionKey:
        """FRAME f POSITION p INTERPOLATE how inside STARTMOTION."""
        return s.MotionKey(self._place(found[0]), found[1], found[2], self._optional(found[3]))

    def position(self, found: list[Any]) -> tuple[s.Expression, ...]:
        """POSITION values."""
        return tuple(found[1:])

    # -- heads and marks of blocks -----------------------------------------------------------------------------------

    def condition(self, found: list[Any]) -> If:
        """IF condition THEN."""
        return If(self._place(found[0]), found[1], further=False)

    def further_condition(self, found: list[Any]) -> If:
        """ELSE IF condition THEN."""
        return If(self._place(found[0]), found[1], further=True)

    def for_head(self, found: list[Any]) -> Counted:
        """FOR name = first TO last STEP step."""
        word, name, _, first, last, step = found
        return Counted(self._place(word), self._identifier(name), first, last, step)

    def do_head(self, found: list[Any]) -> Counted:
        """DO label name = first, last, step."""
        word, label, name, _, first, last, step = found
        return Counted(self._place(word), self._identifier(name), first, last, step, True, str(label or ""))

    def while_head(self, found: list[Any]) -> WhileHead:
        """WHILE condition."""
        return WhileHead(self._place(found[0]), found[1])

    def model_head(self, found: list[Any]) -> ModelHead:
        """STARTMODEL name."""
        return ModelHead(self._place(found[0]), self._identifier(found[1]))

    def motion_head(self, found: list[Any]) -> MotionHead:
        """STARTMOTION name."""
        return MotionHead(self._place(found[0]), self._identifier(found[1]))

    def scene_head(self, found: list[Any]) -> SceneHead:
        """INITIALIZE SCENE number."""
        return SceneHead(self._place(found[0]), found[1])

    def scene_start(self, found: list[Any]) -> SceneStart:
        """STARTSCENE LENGTH k SAMEFRAME i."""
        return SceneStart(self._place(found[0]), found[1], found[2])

    def continue_mark(self, found: list[Any]) -> Mark:
        """Label CONTINUE."""
        label, word = found
        return Mark(self._place(label or word), Word.CONTINUE, str(label or ""))

    def mark(self, found: list[Any]) -> Mark:
        """Any other word that parts or closes a block."""
        return Mark(self._place(found[0]), Word[found[0].type])

    # -- values ------------------------------------------------------------------------------------------------------

    def joint(self, found: list[Any]) -> s.JointOf:
        """JOINT operands."""
        return self._node(s.JointOf, found[0], tuple(found[1:]))

    def figure(self, found: list[Any]) -> s.FigureOf:
        """FIGURE name MAIN LINK link."""
        word, name, by, main = found
        return self._node(s.FigureOf, word, self._identifier(name), by.lower() if by else "", main)

    def strip(self, found: list[Any]) -> s.Strip:
        """STRIP motion, joints."""
        return self._node(s.Strip, found[0], tuple(found[1:]))

    def synchronize(self, found: list[Any]) -> s.Synchronize:
        """SYNCHRONIZE motions."""
        return self._node(s.Synchronize, found[0], tuple(found[1:]))

    def disjunction(self, found: list[Any]) -> s.Logic:
        """Conditions joined by OR."""
        return self._node(s.Logic, found[0], False, tuple(found))

    def conjunction(self, found: list[Any]) -> s.Logic:
        """Conditions joined by AND."""
        return self._node(s.Logic, found[0], True, tuple(found))

    def negation(self, found: list[Any]) -> s.Negation:
        """NOT condition."""
        return self._node(s.Negation, found[0], found[1])

    def comparison(self, found: list[Any]) -> s.Comparison:
        """Left operator right."""
        left, operator, right = found
        return self._node(s.Comparison, left, left, operator.type, right)

    def chain(self, found: list[Any]) -> s.Chain:
        """Operands with operators of equal rank between them."""
        pairs = zip(found[1::2], found[2::2], strict=True)
        rest = tuple((operator.type, self._place(operator), operand) for operator, operand in pairs)
        return self._node(s.Chain, found[0], found[0], rest, below=found[::2])

    def power(self, found: list[Any]) -> s.Chain:
        """Base ** exponent."""
        base, exponent = found
        return self._node(s.Chain, base, base, (("POWER", base.place, exponent),), below=found)

    def sign(self, found: list[Any]) -> s.Sign:
        """-value or +value."""
        return self._node(s.Sign, found[0], found[0] == "-", found[1])

    def modified(self, found: list[Any]) -> s.Modified:
        """Value <modifier, modifier>."""
        item, modifiers = found[0], tuple(part for part in found[1:] if isinstance(part, s.Modifier))
        return self._node(s.Modified, item, item, modifiers, below=[item, *(part.value for part in modifiers)])

    def trans_joints(self, found: list[Any]) -> s.Modifier:
        """TRANS JOINTS BY number."""
        return s.Modifier(self._place(found[0]), "trans joints", found[-1])

    def trans(self, found: list[Any]) -> s.Modifier:
        """TRANS vector."""
        return s.Modifier(self._place(found[0]), "trans", found[-1])

    def scale_part(self, found: list[Any]) -> s.Modifier:
        """SCALE MODEL, EXTREMES or FRAMES number."""
        return s.Modifier(self._place(found[0]), f"scale {found[1].type.lower()}", found[-1])

    def scale(self, found: list[Any]) -> s.Modifier:
        """SCALE number or vector."""
        return s.Modifier(self._place(found[0]), "scale", found[-1])

    def rotate_axis(self, found: list[Any]) -> s.Modifier:
        """ROTATE X angle."""
        return s.Modifier(self._place(found[0]), f"rotate {found[1].lower()}", found[-1])

    def rotate(self, found: list[Any]) -> s.Modifier:
        """ROTATE vector."""
        return s.Modifier(self._place(found[0]), "rotate", found[-1])

    def number(self, found: list[Token]) -> s.Literal:
        """A number, exact."""
        return s.Literal(self._place(found[0]), 0, self._number(found[0]))

    def string(self, found: list[Token]) -> s.Literal:
        """A string without its quotes."""
        place = self._place(found[0])
        return s.Literal(place, 0, self._meter.text(str(found[0][1:-1]), place))

    def true(self, found: list[Token]) -> s.Literal:
        """TRUE."""
        return s.Literal(self._place(found[0]), 0, True)

    def false(self, found: list[Token]) -> s.Literal:
        """FALSE."""
        return s.Literal(self._place(found[0]), 0, False)

    def name(self, found: list[Token]) -> s.Variable:
        """A name that stands for a value."""
        return s.Variable(self._place(found[0]), 0, found[0].casefold(), str(found[0]))

    def call(self, found: list[Any]) -> s.Call:
        """Function(arguments)."""
        name, _, *arguments = found
        given = tuple(argument for argument in arguments if argument is not None)
        return self._node(s.Call, name, name.casefold(), str(name), given, below=given)

    def group(self, found: list[Any]) -> s.Expression:
        """An expression in brackets."""
        return self._last_of(found)

    def vector(self, found: list[Any]) -> s.VectorOf:
        """Several expressions in brackets."""
        return self._node(s.VectorOf, found[0], tuple(found[1:]))

    def solid(self, found: list[Any]) -> s.Solid:
        """BOX, SPHERE, ... with its parts."""
        kind, *parts = found
        values = [value for _, given in parts for value in given]
        return self._node(s.Solid, kind, kind.lower(), tuple(parts), below=values)

    def solid_part(self, found: list[Any]) -> tuple[s.Identifier, tuple[s.Expression, ...]]:
        """A word of a solid and its value."""
        word = self._identifier(found[0])
        return s.Identifier(word.place, found[0].type.lower(), word.spelled), (found[1],)

    def ends(self, found: list[Any]) -> tuple[s.Identifier, tuple[s.Expression, ...]]:
        """FROM point TO point."""
        return self._identifier(found[0]), (found[1], found[2])

    # -- parts -------------------------------------------------------------------------------------------------------

    def _place(self, at: Any) -> Place:
        if isinstance(at, Token):
            return Place(self._source, at.line or 1, at.column or 1)
        place = at.place
        assert isinstance(place, Place)
        return place

    def _identifier(self, token: Token) -> s.Identifier:
        return s.Identifier(self._place(token), token.casefold(), str(token))

    def _optional(self, token: Token | None) -> s.Identifier | None:
        return None if token is None else self._identifier(token)

    def _last_of(self, found: list[Any]) -> s.Expression:
        value = found[-1]
        assert isinstance(value, s.Expression)
        return value

    def _node(self, kind: Callable[..., Any], at: Any, *fields: Any, below: Any = None) -> Any:
        """Return a node one deeper than the deepest expression below it: in ``below``, or else among the fields."""
        place = self._place(at)
        under = below if below is not None else [item for field in fields for item in _listed(field)]
        depth = 1 + max((item.depth for item in under if isinstance(item, s.Expression)), default=0)
        if depth > MAXIMUM_NESTING:
            raise place.error(f"this expression is nested deeper than {MAXIMUM_NESTING}; give its parts names")
        return kind(place, depth, *fields)

    def _number(self, token: Token) -> int | Fraction:
        match = _NUMBER.fullmatch(token)
        assert match is not None
        place, digits = self._place(token), match[1] + match[2]
        exponent = (match[3] or "0")[:8]
        most = self._meter.limits.digits
        if len(digits) > most or abs(int(exponent)) > most or len(match[3] or "") > 8:
            self._meter.number(10 ** (most + 1), place)
        return self._meter.number(Fraction(int(digits)) * Fraction(10) ** (int(exponent) - len(match[2])), place)


def _listed(field: Any) -> Any:
    return field if isinstance(field, tuple) else (field,)
