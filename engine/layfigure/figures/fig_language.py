"""Parses the ``.fig`` language (posing.md 2) into a :class:`LimbDefinition`, or says what is wrong and where.

::

    figure    = NAME block
    block     = "{" statement* "}"
    statement = "axis" AXIS | "flexionaxis" AXIS                     x -x +x y -y +y z -z +z; defaults y and x
              | NUMBER x 6                                            begin and end of the limb
              | ("flexiondof" | "pivotdof" | "twistdof") MIN MAX      degrees
              | ("xdof" | "ydof" | "zdof") MIN MAX                    degrees; of a joint that turns about its axes
              | "id" WORD                                             what motions call the joint; else the limb's name
              | "handed" ("left" | "right")                           of all points of the figure, in its first limb
              | "sphere" x y z  radius COLOUR
              | "cylinder" x1 y1 z1  x2 y2 z2  radius COLOUR
              | "cone" x1 y1 z1  x2 y2 z2  radius COLOUR              base centre, tip, base radius
              | "cube" p0 p1 p2 p3 COLOUR                             a corner and its three neighbours
              | ["mirror" PREFIX PREFIX] "joint" x y z NAME block     joint position on the parent limb

Words are separated by white space, case does not matter, ``#`` starts a comment. A colour is a word of the palette or
``0xrrggbb``. The parser is written by hand
because it runs before the first picture: a parser library's import and grammar cost 50 ms, a third of the time a
window has to appear, this one 2 ms. It keeps its own stack and stops at the first count that no figure needs, so a
hostile file can neither exhaust the stack nor the clock.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import NamedTuple

from layfigure.drawing.palette import load_palette
from layfigure.errors import LayfigureError
from layfigure.figures.build import MAXIMUM_LIMBS, MAXIMUM_VOLUMES
from layfigure.figures.definition import (
    DOF_KINDS,
    EULER_KINDS,
    MAXIMUM_TURN,
    VOLUME_KINDS,
    Axis,
    Dof,
    JointDefinition,
    LimbDefinition,
    Vector,
    Volume,
)
from layfigure.figures.joint_names import joint_name
from layfigure.figures.solidity import flaw_of
from layfigure.files.words import Word, WordReader

MAXIMUM_NESTING = 100

_RGB = re.compile("0x([0-9a-f]{6})")
_AXES = {sign + letter: Axis(i, -1 if sign == "-" else 1) for sign in ("", "-", "+") for i, letter in enumerate("xyz")}
_POINTS = {
    "sphere": ("its centre",),
    "cylinder": ("its first end", "its second end"),
    "cone": ("the centre of its base", "its tip"),
    "cube": ("its corner", "the corner's first neighbour", "its second neighbour", "its third neighbour"),
}
_DOF_WORDS = tuple(f"{kind}dof" for kind in (*DOF_KINDS, *EULER_KINDS))
_STATEMENTS = ("axis", "flexionaxis", *_DOF_WORDS, *VOLUME_KINDS, "joint", "mirror", "handed", "id")


class ParsedFigure(NamedTuple):
    """What a file says, and where it says it: ``places`` maps ``id(limb)`` to the (line, column) of its name."""

    definition: LimbDefinition
    places: dict[int, tuple[int, int]]


def parse_fig(text: str, source: str | Path) -> LimbDefinition:
    """Return the root limb that the text of a ``.fig`` file describes; ``source`` names the file in errors.

    Raises:
        SourceError: the first mistake, with line, column, what was found and what could stand there.
    """
    return parse_with_places(text, source).definition


def parse_with_places(text: str, source: str | Path) -> ParsedFigure:
    """Return the root limb and where each limb stands, for errors that show only when the figure is built.

    Raises:
        SourceError: as for :func:`parse_fig`.
    """
    return _Parser(WordReader(text, source)).figure()


@dataclass
class _Block:
    """A limb block being read; ``seen`` maps what may stand once (``axis``, ``flexiondof``, ...) to its first word."""

    name: str
    name_word: Word
    opening: Word
    position: Vector = (0.0, 0.0, 0.0)
    mirror: tuple[str, str] | None = None
    axis: Axis = LimbDefinition.axis
    flexion_axis: Axis = LimbDefinition.flexion_axis
    begin: Vector = (0.0, 0.0, 0.0)
    end: Vector = (0.0, 0.0, 0.0)
    dofs: list[Dof] = field(default_factory=list)
    volumes: list[Volume] = field(default_factory=list)
    joints: list[JointDefinition] = field(default_factory=list)
    right_handed: bool = False
    joint_id: str = ""
    seen: dict[str, Word] = field(default_factory=dict)

    def limb(self) -> LimbDefinition:
        return LimbDefinition(
            self.name,
            self.axis,
            self.flexion_axis,
            self.begin,
            self.end,
            tuple(self.dofs),
            tuple(self.volumes),
            tuple(self.joints),
            self.right_handed,
            self.joint_id,
        )


class _Parser:
    """One pass over the words with an explicit stack of open blocks."""

    def __init__(self, words: WordReader) -> None:
        self._words = words
        self._open: list[_Block] = []
        self._places: dict[int, tuple[int, int]] = {}
        self._limbs = 0
        self._volumes = 0
        self._handlers: dict[str, Callable[[_Block, Word], None]] = {
            "axis": self._axis,
            "flexionaxis": self._axis,
            "joint": self._joint,
            "mirror": self._mirrored_joint,
            "handed": self._handed,
            "id": self._joint_id,
            **dict.fromkeys(_DOF_WORDS, self._dof),
            **dict.fromkeys(VOLUME_KINDS, self._volume),
        }

    def figure(self) -> ParsedFigure:
        if not self._words.peek().text:
            self._words.fail(self._words.peek(), 'the file is empty; a figure is a name and a block: "name { ... }"')
        self._begin_block("the name of the figure's root limb", (0.0, 0.0, 0.0), None)
        while True:
            word = self._words.take()
            if word.text == "}":
                block = self._open.pop()
                limb = self._finished(block)
                if not self._open:
                    break
                self._open[-1].joints.append(JointDefinition(block.position, limb, block.mirror))
            else:
                self._statement(self._open[-1], word)
        rest = self._words.take()
        if rest.text:
            self._words.fail(rest, f'found {rest} after the "}}" that ends the figure; nothing may follow it')
        return ParsedFigure(limb, self._places)

    def _statement(self, block: _Block, word: Word) -> None:
        handler = self._handlers.get(word.folded)
        if handler is not None:
            handler(block, word)
        elif word.is_number:
            self._segment(block, word)
        elif word.ends:
            line, column = self._words.place(block.opening.offset)
            opened = f'the block of "{block.name}", opened in line {line}, column {column},'
            self._words.fail(word, f'the file ends where {opened} is still open; add "}}"')
        else:
            self._words.unknown(word, _STATEMENTS, 'a statement, six numbers or "}"')

    def _begin_block(self, what: str, position: Vector, mirror: tuple[str, str] | None) -> None:
        name_word = self._words.peek()
        name = self._words.name(what)
        self._limbs += 1
        if self._limbs > MAXIMUM_LIMBS:
            self._words.fail(name_word, f"this is limb {self._limbs}; a figure has up to {MAXIMUM_LIMBS} limbs")
        opening = self._words.take()
        if opening.text != "{":
            self._words.fail(opening, f'found {opening} where the "{{" of the block of "{name}" should stand')
        if len(self._open) >= MAXIMUM_NESTING:
            self._words.fail(opening, f"blocks are nested deeper than {MAXIMUM_NESTING}; use fewer joints in a chain")
        self._open.append(_Block(name, name_word, opening, position, mirror))

    def _finished(self, block: _Block) -> LimbDefinition:
        same = block.axis.index == block.flexion_axis.index
        if same and any(dof.kind in ("flexion", "pivot") for dof in block.dofs):
            later = max((block.seen[word] for word in ("axis", "flexionaxis") if word in block.seen), key=_offset)
            axes = f"axis {block.axis} and flexionaxis {block.flexion_axis}"
            self._words.fail(later, f'"{block.name}" swings, but its {axes} are one line; choose another flexionaxis')
        limb = block.limb()
        self._places[id(limb)] = self._words.place(block.name_word.offset)
        return limb

    def _once(self, block: _Block, what: str, word: Word) -> None:
        first = block.seen.setdefault(what, word)
        if first is not word:
            line, _ = self._words.place(first.offset)
            self._words.fail(word, f'"{block.name}" has its {what} in line {line} already; remove one of the two')

    def _axis(self, block: _Block, word: Word) -> None:
        self._once(block, word.folded, word)
        axis = _AXES[self._words.one_of(_AXES, f"the {word.folded}")]
        if word.folded == "axis":
            block.axis = axis
        else:
            block.flexion_axis = axis

    def _handed(self, block: _Block, word: Word) -> None:
        self._once(block, "handed", word)
        if len(self._open) > 1:
            self._words.fail(word, '"handed" goes for the whole figure; write it in the block of its first limb')
        block.right_handed = self._words.one_of(("left", "right"), "the handedness of all points") == "right"

    def _joint_id(self, block: _Block, word: Word) -> None:
        self._once(block, "id", word)
        if len(self._open) == 1:
            self._words.fail(word, "the first limb hangs on no joint; write id in a limb that has one")
        given = self._words.take()
        if given.ends or given.text in "{}":
            self._words.fail(given, f"found {given} where what motions call this joint should stand, as in: id 5")
        try:
            block.joint_id = joint_name(given.text)
        except LayfigureError as error:
            self._words.fail(given, str(error))

    def _segment(self, block: _Block, first: Word) -> None:
        self._once(block, "segment", first)
        self._words.put_back(first)
        block.begin = self._point("the beginning of the limb")
        block.end = self._point("the end of the limb")

    def _dof(self, block: _Block, word: Word) -> None:
        self._once(block, word.folded, word)
        kind = word.folded.removesuffix("dof")
        if block.dofs and (kind in EULER_KINDS) != (block.dofs[0].kind in EULER_KINDS):
            message = f'"{block.name}" has a {block.dofs[0].kind}dof; a joint turns by flexion, pivot and twist'
            self._words.fail(word, f"{message} or about x, y and z, not both")
        widest = MAXIMUM_TURN if kind in EULER_KINDS else 180.0
        low_word = self._words.peek()
        low = self._words.number(f"the least angle (degrees) of this {word.folded}", widest)
        high = self._words.number(f"the greatest angle (degrees) of this {word.folded}", widest)
        if low > high:
            self._words.fail(low_word, f"this {word.folded} goes from {low:g} to {high:g}; write the smaller one first")
        block.dofs.append(Dof(kind, low, high))

    def _volume(self, block: _Block, word: Word) -> None:
        kind = word.folded
        self._volumes += 1
        if self._volumes > MAXIMUM_VOLUMES:
            self._words.fail(word, f"this is volume {self._volumes}; a figure has up to {MAXIMUM_VOLUMES} volumes")
        points = tuple(self._point(f"{label} ({kind})") for label in _POINTS[kind])
        radius = 0.0 if kind == "cube" else self._radius(kind)
        volume = Volume(kind, points, radius, self._colour())
        flaw = flaw_of(volume)
        if flaw:
            self._words.fail(word, flaw)
        block.volumes.append(volume)

    def _colour(self) -> str:
        match = _RGB.fullmatch(self._words.peek().folded)
        if match:
            self._words.take()
            return f"#{match.group(1)}"
        return self._words.one_of(load_palette().names, "a colour")

    def _radius(self, kind: str) -> float:
        word = self._words.peek()
        radius = self._words.number(f"the radius ({kind})")
        if radius <= 0.0:
            self._words.fail(word, f"the radius of this {kind} is {word}; a radius is greater than 0")
        return radius

    def _mirrored_joint(self, _: _Block, word: Word) -> None:
        first = self._words.name("the first prefix of the mirror")
        second_word = self._words.peek()
        second = self._words.name("the second prefix of the mirror")
        if second.casefold() == "joint":
            self._words.fail(second_word, f"this mirror has one prefix; it needs two: mirror {first} other joint ...")
        if first.casefold() == second.casefold():
            self._words.fail(second_word, f'both prefixes of this mirror are "{second}"; the twins need two names')
        joint = self._words.take()
        if joint.folded != "joint":
            self._words.fail(joint, f'found {joint} where "joint" should stand: mirror {first} {second} joint ...')
        self._begin_joint((first, second))

    def _joint(self, _: _Block, word: Word) -> None:
        self._begin_joint(None)

    def _begin_joint(self, mirror: tuple[str, str] | None) -> None:
        self._begin_block("the name of the limb", self._point("the joint's position"), mirror)

    def _point(self, what: str) -> Vector:
        x, y, z = (self._words.number(f"{axis} of {what}") for axis in "xyz")
        return (x, y, z)


def _offset(word: Word) -> int:
    return word.offset
