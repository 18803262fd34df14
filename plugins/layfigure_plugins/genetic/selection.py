"""Selection: which individuals become parents (thesis IV.4: tournament selection is the search engine's default)."""

from __future__ import annotations

from collections.abc import Sequence

ROUNDS = 2
"""How many individuals enter a tournament: with two, a better grade is a better chance and no more."""


def tournament(grades: Sequence[int], drawn: Sequence[int]) -> int:
    """Return which of the ``drawn`` individuals has the best grade; of equals the one drawn first."""
    return max(drawn, key=lambda individual: grades[individual])
