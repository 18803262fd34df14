"""Says what was found where something else should stand, in the language's words and not the parser's."""

from __future__ import annotations

from dataclasses import dataclass

from layfigure.suggestions import did_you_mean

_LONGEST = 40
_STATEMENT, _END = "a statement", "the end of the statement"
_SIGNS = {
    "_COMMA": '","',
    "_PART_COMMA": '","',
    "_RIGHT_ROUND": '")"',
    "_LEFT_SQUARE": '"["',
    "_RIGHT_SQUARE": '"]"',
    "EQUAL": '"="',
    "GREATER": '">"',
    "DOLLAR": '"$"',
}
_VALUE = frozenset(
    ("NUMBER", "STRING", "NAME", "TRUE", "FALSE", "LEFT_ROUND", "SOLID", "MINUS", "PLUS", "NOT", "DOLLAR")
)
_RIGHT_SIDE = frozenset(("JOINT", "FIGURE", "STRIP", "SYNCHRONIZE"))
_ARITHMETIC = frozenset(("PLUS", "MINUS", "STAR", "SLASH", "MOD", "_POWER", "_AND", "_OR", "ANGLE"))
_OPERATORS = _ARITHMETIC | {"UNEQUAL", "LESS", "LESS_EQUAL", "GREATER_EQUAL", "GREATER", "EQUAL"}
_ASSIGNING = frozenset(("EQUAL", "_COLON_MINUS", "_COLON_EQUAL"))
_TYPES = {"GRAPHICAL", "VECTOR", "REAL", "INTEGER", "MODEL", "MOTION", "SCENE", "STRING", "BOOLEAN", "POSE"}


def wrong_beginning(word: str, accepts: frozenset[str], at_start: frozenset[str], inside: bool) -> str:
    """Return the sentence for a name or number that was read as the beginning of a statement but is none, else "".

    ``accepts`` are the terminals that could have followed, ``at_start`` those that could begin a statement; ``inside``
    tells that something of a statement stands before the word, which did not end there.
    """
    is_name = accepts >= _ASSIGNING and accepts <= _ASSIGNING | {"_LEFT_SQUARE"}
    if not is_name and accepts != {"CONTINUE"}:
        return ""
    if inside:
        return f"found {quoted(word)} where an operator or {_END} should stand"
    known = (_words(at_start) - {"TYPE", "SHOOT"}) | {"SHOOTSCENES"} | _TYPES
    hint = "" if not is_name or word.upper() in known else did_you_mean(word, known)
    return f"no statement begins with {quoted(word)}{hint}" if hint else ""


@dataclass(frozen=True)
class Found:
    """What was found: its text, its terminal ("" for a sign the language does not know), and whether in a statement."""

    text: str
    kind: str
    inside: bool


def found_instead(found: Found, accepts: frozenset[str], at_start: frozenset[str]) -> str:
    """Return the sentence for something that may not stand where it was found.

    ``accepts`` is what could stand there, and ``at_start`` what could begin a statement.
    """
    hint = did_you_mean(found.text, _words(accepts - at_start)) if found.kind == "NAME" else ""
    expected = _expected(accepts, at_start)
    if found.inside and expected == _STATEMENT:
        expected = _END
    return f"found {_shown(found)} where {expected} should stand{hint}"


def quoted(text: str) -> str:
    """Return a text as messages show it: quoted, on one line and not too long."""
    shown = text if len(text) <= _LONGEST else text[:_LONGEST] + "..."
    return f'"{shown}"' if shown.isprintable() else ascii(shown)


def listed(words: list[str]) -> str:
    """Return "a, b or c"."""
    return " or ".join([", ".join(words[:-1]), words[-1]] if len(words) > 1 else words)


def _shown(found: Found) -> str:
    if found.kind == "$END":
        return "the end of the file"
    if found.kind == "SEPARATOR" and found.text == "\n":
        return "the end of the line"
    if found.kind == "STRING":
        return f"the string {quoted(found.text[1:-1])}"
    return quoted(found.text)


def _expected(accepts: frozenset[str], at_start: frozenset[str]) -> str:
    ends = "SEPARATOR" in accepts
    rest = accepts - at_start if ends else accepts
    if ends and not rest:
        return _STATEMENT
    parts: list[str] = []
    if "NUMBER" in rest and "LEFT_ROUND" in rest:
        parts.append("a value")
        rest -= _VALUE | _RIGHT_SIDE
    elif "NAME" in rest:
        parts.append("a name")
    if "PLUS" in rest:
        parts.append("an operator")
        rest -= _OPERATORS if ends or "LESS" in rest else _OPERATORS - {"GREATER"}  # which may close a list
    elif rest >= _ASSIGNING:
        parts.append('"="')
        rest -= _ASSIGNING
    parts += sorted({_SIGNS[name] for name in rest if name in _SIGNS}) + sorted(_words(rest))
    return listed(parts[:8] + ([_END] if ends else []))


def _words(accepts: frozenset[str]) -> set[str]:
    """Return the words of the language among the terminals."""
    words = {name.strip("_") for name in accepts if name not in _SIGNS and name not in _OPERATORS}
    return {word for word in words if word.isalpha()} - {"NAME", "NUMBER", "STRING", "SOLID", "SEPARATOR", "AXIS"}
