"""What is said: a subject and short clauses about it, which make one sentence that stands alone."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Statement:
    """Clauses about a subject; without a subject the first clause leads. Limbs are named as people say them."""

    subject: str
    clauses: tuple[str, ...]

    @property
    def sentence(self) -> str:
        """The statement as a sentence with a capital letter and a full stop."""
        text = f"{self.subject} {', '.join(self.clauses)}".strip()
        return f"{text[0].upper()}{text[1:]}."


def told(subject: str, *clauses: str) -> list[Statement]:
    """Return one statement with the clauses that are not empty, or none where all are."""
    kept = tuple(clause for clause in clauses if clause)
    return [Statement(subject, kept)] if kept else []


def told_of_both(name: str, right: tuple[str, ...], left: tuple[str, ...]) -> list[Statement]:
    """Return what is said of the right and left of two, as one statement where it is the same of both."""
    if right == left:
        return _led("both", name, right)
    return [*_led("right", name, right), *_led("left", name, left)]


_PLURALS = {
    "arm": "arms",
    "leg": "legs",
    "elbow": "elbows",
    "forearm": "forearms",
    "wrist": "wrists",
    "hand": "hands",
    "knee": "knees",
    "shin": "shins",
    "toes": "toes",
    "foot": "feet",
}


def _led(side: str, name: str, clauses: tuple[str, ...]) -> list[Statement]:
    """Let a clause that names a part of its own, such as an elbow, lead with that part."""
    if not clauses:
        return []
    part, _, rest = clauses[0].partition(" ")
    if part in _PLURALS:
        name, clauses = part, (rest, *clauses[1:])
    return [Statement(f"{side} {_PLURALS[name] if side == 'both' else name}", clauses)]
