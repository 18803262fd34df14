"""Reads a script: layout, grammar, syntax, blocks; the first mistake is told in words a person uses."""

from __future__ import annotations

import functools
from pathlib import Path

from lark import Lark, Token
from lark.exceptions import UnexpectedCharacters, UnexpectedInput, UnexpectedToken, VisitError

from layfigure.errors import SourceError
from layfigure.language.blocks import nested
from layfigure.language.building import Builder
from layfigure.language.expecting import found_instead, unknown_statement
from layfigure.language.layout import laid_out
from layfigure.language.limits import Meter
from layfigure.language.places import Place
from layfigure.language.syntax import Block


def parse_script(text: str, source: str, meter: Meter) -> Block:
    """Return the statements of a script; ``source`` names it in messages.

    Raises:
        SourceError: the first mistake, with line, column, what was found and what could stand there.
    """
    clean = laid_out(text, source)
    try:
        tree = grammar().parse(clean)
    except UnexpectedInput as error:
        raise _explained(error, clean, source) from None
    try:
        items = Builder(source, meter).transform(tree)
    except VisitError as error:
        if isinstance(error.orig_exc, SourceError):
            raise error.orig_exc from None
        raise
    return nested(items, _end_of(clean, source))


@functools.cache
def grammar() -> Lark:
    """Return the parser, made once in a process (0.2 s)."""
    text = Path(__file__).with_name("grammar.lark").read_text(encoding="utf-8")
    return Lark(text, parser="lalr", lexer="contextual", propagate_positions=False, maybe_placeholders=True)


@functools.cache
def _at_start() -> frozenset[str]:
    """Return the names of the terminals that may begin a statement."""
    return frozenset(grammar().parse_interactive("").accepts())


def _explained(error: UnexpectedInput, text: str, source: str) -> SourceError:
    place = Place(source, error.line, error.column)
    accepts = frozenset(error.interactive_parser.accepts()) if error.interactive_parser else frozenset()
    if isinstance(error, UnexpectedCharacters):
        return place.error(found_instead(text[error.pos_in_stream or 0], "", accepts, _at_start()))
    assert isinstance(error, UnexpectedToken)
    if error.token.type == "$END":
        place = _end_of(text, source)
    before = error.interactive_parser.parser_state.value_stack[-1:] if error.interactive_parser else []
    if before and isinstance(before[0], Token) and before[0].type == "NAME":
        sentence = unknown_statement(before[0], accepts)
        if sentence:
            return Place(source, before[0].line or 1, before[0].column or 1).error(sentence)
    return place.error(found_instead(str(error.token), error.token.type, accepts, _at_start()))


def _end_of(text: str, source: str) -> Place:
    """Return the place just behind the last thing in a text."""
    lines = text.rstrip().split("\n")
    return Place(source, len(lines), len(lines[-1]) + 1)
