"""Says what was found where something else should stand, in the language's words and not the parser's."""

from __future__ import annotations

from layfigure.suggestions import did_you_mean

_LONGEST = 40
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
_OPERATORS = frozenset(
    "PLUS MINUS STAR SLASH MOD _POWER _AND _OR UNEQUAL LESS LESS_EQUAL GREATER_EQUAL GREATER EQUAL ANGLE".split()
)
_ASSIGNING = frozenset(("EQUAL", "_COLON_MINUS", "_COLON_EQUAL"))
STATEMENTS = tuple(
    "ANIMATE BACKGROUND BEGIN BOOLEAN CONTINUE DO ELSE END ENDFOR ENDIF ENDJOINT ENDMODEL ENDMOTION ENDSCENE ENDWHILE "
    "FIGURE FLOOR FOR FRAME GRAPHICAL IF INITIALIZE INTEGER JOINT LOAD MODEL MOTION POSE PRINT REAL SAVE SCENE SHOOTSCENES "
    "STARTMODEL STARTMOTION STARTSCENE STOP STRING VECTOR VIEW WHILE".split()
)


def unknown_statement(word: str, accepts: frozenset[str]) -> str:
    """Return the sentence for a statement that begins with a word and has no ``=`` behind it, or "" for anything else.

    ``accepts`` are the terminals that could have followed.
    """
    if not (accepts >= _ASSIGNING and accepts <= _ASSIGNING | {"_LEFT_SQUARE"}):
        return ""
    hint = did_you_mean(word, STATEMENTS)
    return f"no statement begins with {quoted(word)}{hint}" if hint else ""


def found_instead(found: str, kind: str, accepts: frozenset[str], at_start: frozenset[str]) -> str:
    """Return the sentence for something that may not stand where it was found.

    ``kind`` is its terminal ("" for a sign the language does not know), ``accepts`` what could stand there, and
    ``at_start`` what could begin a statement.
    """
    shown = _shown(found, kind)
    hint = did_you_mean(found, _words(accepts - at_start)) if kind == "NAME" else ""
    return f"found {shown} where {_expected(accepts, at_start)} should stand{hint}"


def quoted(text: str) -> str:
    """Return a text as messages show it: quoted, on one line and not too long."""
    shown = text if len(text) <= _LONGEST else text[:_LONGEST] + "..."
    return f'"{shown}"' if shown.isprintable() else ascii(shown)


def listed(words: list[str]) -> str:
    """Return "a, b or c"."""
    return " or ".join([", ".join(words[:-1]), words[-1]] if len(words) > 1 else words)


def _shown(found: str, kind: str) -> str:
    if kind == "$END":
        return "the end of the file"
    if kind == "SEPARATOR" and found == "\n":
        return "the end of the line"
    return quoted(found)


def _expected(accepts: frozenset[str], at_start: frozenset[str]) -> str:
    ends = "SEPARATOR" in accepts
    rest = accepts - at_start if ends else accepts
    if ends and not rest:
        return "a statement"
    parts: list[str] = []
    if "NUMBER" in rest and "LEFT_ROUND" in rest:
        parts.append("a value")
        rest -= _VALUE | _RIGHT_SIDE
    elif "NAME" in rest:
        parts.append("a name")
    if "PLUS" in rest:
        parts.append("an operator")
        rest -= _OPERATORS if ends or not _closes(rest) else _OPERATORS - {"GREATER"}
    elif rest >= _ASSIGNING:
        parts.append('"="')
        rest -= _ASSIGNING
    parts += sorted({_SIGNS[name] for name in rest if name in _SIGNS}) + sorted(_words(rest))
    return listed(parts[:8] + (["the end of the statement"] if ends else []))


def _closes(rest: frozenset[str]) -> bool:
    """Whether ``>`` would close a list of transformations rather than compare: nothing else that compares may stand."""
    return "GREATER" in rest and "LESS" not in rest


def _words(accepts: frozenset[str]) -> set[str]:
    """Return the words of the language among the terminals."""
    known = {"FRAME", "JOINT", "FIGURE", "STRIP", "SYNCHRONIZE", "AXIS"}
    words = {name.strip("_") for name in accepts if name not in _SIGNS and name not in _OPERATORS}
    words -= {"NAME", "NUMBER", "STRING", "LEFT_ROUND", "SOLID", "$END", "SEPARATOR", "COLON_MINUS", "COLON_EQUAL"}
    return {word for word in words if word.isalpha() or word in known} - {"AXIS"}
