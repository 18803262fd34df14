"""A mistake as the command line tells it: one sentence, with the option that would allow what was refused."""

from __future__ import annotations

from layfigure.errors import LayfigureError, LimitError, visible


def told(error: LayfigureError) -> str:
    """Return the one sentence that a command ends in."""
    sentence = visible(" ".join(str(error).split()))
    if not isinstance(error, LimitError):
        return sentence
    if error.limit == "outside":
        return f"{sentence}; --outside lets it save elsewhere"
    return f"{sentence}; raise the limit with --most-{error.limit}"
