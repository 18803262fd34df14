"""Where something stands in a script, so that every mistake can say it."""

from __future__ import annotations

from typing import NamedTuple

from layfigure.errors import LimitError, SourceError


class Place(NamedTuple):
    """A file as messages name it, a line and a column, both from 1."""

    source: str
    line: int
    column: int

    def error(self, message: str) -> SourceError:
        """Return the error of a mistake at this place."""
        return SourceError(self.source, self.line, self.column, message)

    def beyond(self, limit: str, message: str) -> LimitError:
        """Return the error of what goes beyond a limit at this place; ``limit`` is a field of ``Limits``."""
        return LimitError(self, message, limit)
