"""Reads a script: layout, grammar, syntax, blocks; the first mistake is told in words a person uses."""

from __future__ import annotations

import functools
from pathlib import Path

from lark import Lark, Token
from lark.exceptions import UnexpectedCharacters, UnexpectedInput, UnexpectedToken, VisitError
from lark.parsers.lalr_interactive_parser import InteractiveParser

from layfigure.errors import SourceError
from layfigure.language.blocks import nested
from layfigure.language.building import Builder
from layfigure.language.expecting import Found, found_instead, wrong_beginning
from layfigure.language.layout import laid_out
from layfigure.language.limits import Meter
from layfigure.language.places import Place
from layfigure.language.syntax import Block


def parse_script(text: str, source: str, meter: Meter) -> Block:
    """Return the statements of a script; ``source`` names it in messages.

    Raises:
        SourceError: the first mistake, with line, column, what was found and what could stand there.
    """
    if len(text) > meter.limits.script:
        message = f"the script has more than {meter.limits.script} letters; load parts of it"
        raise Place(source, 1, 1).beyond("script", message)
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
    return _accepted(grammar().parse_interactive(""))


def _explained(error: UnexpectedInput, text: str, source: str) -> SourceError:
    place = Place(source, error.line, error.column)
    accepts = _accepted(error.interactive_parser) if error.interactive_parser else frozenset()
    if isinstance(error, UnexpectedCharacters):
        found = Found(text[error.pos_in_stream or 0], "", _is_inside(text, error.pos_in_stream or 0))
        return place.error(found_instead(found, accepts, _at_start()))
    assert isinstance(error, UnexpectedToken)
    if error.token.type == "$END":
        place = _end_of(text, source)
    begins = error.interactive_parser.parser_state.value_stack[-1:] if error.interactive_parser else []
    if begins and isinstance(begins[0], Token):
        sentence = wrong_beginning(begins[0], accepts, _at_start(), _is_inside(text, begins[0].start_pos))
        if sentence:
            return Place(source, begins[0].line or 1, begins[0].column or 1).error(sentence)
    inside = _is_inside(text, error.token.start_pos if error.token.type != "$END" else len(text))
    return place.error(found_instead(Found(str(error.token), error.token.type, inside), accepts, _at_start()))


def _is_inside(text: str, offset: int | None) -> bool:
    """Whether something of a statement stands before an offset."""
    return text[:offset].rstrip(" ")[-1:] not in ("", ";", "\n")


def _accepted(parser: InteractiveParser) -> frozenset[str]:
    """Return the names of the terminals that could stand next."""
    return frozenset(parser.accepts())  # type: ignore[no-untyped-call]


def _end_of(text: str, source: str) -> Place:
    """Return the place just behind the last thing in a text."""
    lines = text.rstrip().split("\n")
    return Place(source, len(lines), len(lines[-1]) + 1)
