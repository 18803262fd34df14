"""Where statements end: turns everything that the grammar need not see into blanks, so that places stay as they are.

A statement ends with its line or at ``;``, but goes on behind an open bracket, a comma, an operator or a word that asks
for more, and where the next line begins with a word or sign that can only go on. Comments stand in braces. An asterisk
in the first column (the thesis's mark of what its preprocessor reads) is a blank too.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import NamedTuple, NoReturn

from layfigure.files.reading import position
from layfigure.language.places import Place

_PIECE = re.compile(
    r"""(?P<comment>\{[^}]*\}?) | (?P<text>"[^"\n]*"? | '[^'\n]*'?) | (?P<line>\n) | (?P<blank>[^\S\n]+)
    | (?P<number>(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][-+]?[0-9]+)?) | (?P<word>[^\W\d]\w*)
    | (?P<sign>:-|:=|\*\*|<=|>=|<>|!=|/=|.)""",
    re.VERBOSE,
)
_OPEN = {"(": ")", "[": "]"}
_GO_ON_AFTER = frozenset(", + - * / ** = == <> != /= < <= >= :- := ( [ and or not mod using interpolate".split())
_GO_ON_BEFORE_SIGNS = frozenset(", + - * / ** = == <> != /= < <= > >= :- := ) ]".split())
_GO_ON_BEFORE_WORDS = re.compile(
    r"(and|or|mod|then|position|interpolate|using|repeat|main|from|to|step|length|sameframe|as)\b"
    r"(?![^\S\n]*(=|:-|:=|\[))",
    re.IGNORECASE,
)


class _Piece(NamedTuple):
    kind: str
    text: str
    offset: int


def laid_out(text: str, source: str) -> str:
    """Return a text as long as the script in which only statements and what parts them are left.

    Raises:
        SourceError: a comment, a string or a bracket is not closed, or a bracket closes nothing.
    """
    return _Layout(text, source).cleaned()


class _Layout:
    def __init__(self, text: str, source: str) -> None:
        self._text = re.sub("\r(?!\n)", "\n", text)
        self._source = source
        self._open: list[_Piece] = []

    def cleaned(self) -> str:
        """Return the text with blanks for what does not matter."""
        done: list[str] = []
        before = ""  # the last piece that counts
        ends: list[int] = []  # where in ``done`` line ends stand that may turn out not to end a statement
        for piece in self._pieces():
            if piece.kind == "line":
                goes_on = bool(self._open) or before in _GO_ON_AFTER
                if not goes_on:
                    ends.append(len(done))
                done.append(" " if goes_on else "\n")
            elif piece.kind in ("comment", "blank") or self._is_flag(piece):
                done.append(" " * len(piece.text))
            else:
                if ends and self._continues(piece):
                    for index in ends:
                        done[index] = " "
                ends.clear()
                done.append(piece.text)
                before = piece.text.casefold()
                self._bracket(piece)
        if self._open:
            opened = self._open[-1]
            self._fail(opened.offset, f'this "{opened.text}" is not closed; add "{_OPEN[opened.text]}"')
        return "".join(done)

    def _pieces(self) -> Iterator[_Piece]:
        for match in _PIECE.finditer(self._text):
            piece = _Piece(match.lastgroup or "", match.group(), match.start())
            if piece.kind == "comment" and not piece.text.endswith("}"):
                self._fail(piece.offset, 'the comment that begins here is not closed; add "}"')
            if piece.kind == "text" and (len(piece.text) < 2 or piece.text[-1] != piece.text[0]):
                self._fail(piece.offset, f"the string that begins here is not closed in its line; add {piece.text[0]}")
            yield piece

    def _is_flag(self, piece: _Piece) -> bool:
        return piece.text == "*" and (piece.offset == 0 or self._text[piece.offset - 1] == "\n")

    def _continues(self, piece: _Piece) -> bool:
        if piece.kind == "sign":
            return piece.text in _GO_ON_BEFORE_SIGNS
        return piece.kind == "word" and _GO_ON_BEFORE_WORDS.match(self._text, piece.offset) is not None

    def _bracket(self, piece: _Piece) -> None:
        if piece.text in _OPEN:
            self._open.append(piece)
        elif piece.text in _OPEN.values():
            if not self._open:
                self._fail(piece.offset, f'this "{piece.text}" closes nothing; remove it')
            opened = self._open.pop()
            if piece.text != _OPEN[opened.text]:
                line, column = position(self._text[: opened.offset])
                where = f'the "{opened.text}" in line {line}, column {column}'
                self._fail(piece.offset, f'found "{piece.text}" where {where} needs its "{_OPEN[opened.text]}"')

    def _fail(self, offset: int, message: str) -> NoReturn:
        raise Place(self._source, *position(self._text[:offset])).error(message)
