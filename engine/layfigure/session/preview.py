"""A preview: what a command line would do is shown in the document's place, without history or log."""

from __future__ import annotations

from typing import TYPE_CHECKING

from layfigure.poses.packing import pack_pose
from layfigure.session.words import join_line, split_line

if TYPE_CHECKING:
    from layfigure.session.document import Document
    from layfigure.session.session import Session


class Preview:
    """What of a session is shown for now only: a command under the pointer, a drag that is not let go."""

    def __init__(self, session: Session) -> None:
        self._session = session
        self._before: Document | None = None

    @property
    def going_on(self) -> bool:
        """Whether what is shown is a preview."""
        return self._before is not None

    def show(self, text: str, *, onward: bool = False) -> None:
        """Show what a command line would do until something is run or given up.

        With ``onward`` it is done from where the last preview stands, as the next step of a drag.
        """
        session = self._session
        session.playback.settle()
        before = self._before if onward else None
        if before is None:
            self.give_up()
            before = session.document
        log, session.log = session.log, list(session.log)
        callback, session.on_logged = session.on_logged, lambda line: None
        try:
            self._before = before
            line = split_line(text)
            if line is not None and line.name in session.commands():
                session.commands()[line.name].run(session, line.words)
        finally:
            session.log, session.on_logged = log, callback

    def settle(self, limb: str) -> None:
        """Make the pose that a drag of a limb's end arrived at one change and one line of the log."""
        pose = self._session.document.pose
        self.give_up()
        figure = self._session.document.figure
        if pose != self._session.document.pose:
            self._session.execute(join_line("dragged", [limb, pack_pose(figure, pose)]))

    def give_up(self) -> None:
        """Go back to the document from before."""
        if self._before is not None:
            self._session.document, self._before = self._session.in_service(self._before), None
