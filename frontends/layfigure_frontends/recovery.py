"""Keeps the journal of an interactive session, and offers back what a killed one left."""

from __future__ import annotations

import datetime
from pathlib import Path
from typing import TYPE_CHECKING

from layfigure.errors import LayfigureError
from layfigure.plugins.hookspecs import hookimpl
from layfigure.plugins.records import Command
from layfigure.session import journal
from layfigure.session.document import Document
from layfigure.session.figures import open_figure
from layfigure.session.log import parse_log
from layfigure.session.modes import QuestionMode
from layfigure.session.replay import play

if TYPE_CHECKING:
    from layfigure.session.session import Session


class Recovery:
    """A plug-in object of the front ends: journals one session and brings the commands ``restore`` and ``forget``."""

    def __init__(self, session: Session) -> None:
        self._session = session
        self._orphans = journal.orphans()
        self._journal = journal.Journal.begin(session.log)
        session.on_logged = self._logged
        session.host.register(self, "recovery")
        if self._journal is None:
            session.say("The state folder cannot be written, so this session is not kept safe against a crash.")

    def offer(self) -> None:
        """Ask whether to restore the newest session that was not closed, if there is one."""
        if self._orphans:
            lost = self._orphans[0]
            count = max(len(journal.read(lost).splitlines()) - 3, 1)
            when = datetime.datetime.fromtimestamp(lost.stat().st_mtime).astimezone().strftime("%H:%M on %d %B")
            steps = "1 step" if count == 1 else f"{count} steps"
            text = f"The last session was not closed ({steps}, until {when}). Restore it?"
            answers = (("Restore", "y", "restore"), ("Throw it away", "d", "forget"), ("Later", "n", "cancel"))
            self._session.modes.append(QuestionMode(text, answers))

    def close(self, interrupted: bool = False) -> None:
        """End the session; the journal is kept for the next start only if the session was interrupted."""
        if self._journal is not None:
            self._journal.close(keep=interrupted)

    @hookimpl
    def layfigure_commands(self) -> list[Command]:
        """Return the commands that answer the question."""
        return [
            Command("restore", "Restore the session that was not closed", self._restore),
            Command("forget", "Throw away the session that was not closed", self._forget),
        ]

    def _restore(self, session: Session, words: tuple[str, ...]) -> None:
        path = self._take()
        log = parse_log(journal.read(path), path)
        session.begin(Document.new(open_figure(session.host, log.figure)))
        session.on_logged = lambda line: None
        try:
            if log.technique in session.host.techniques:
                session.use(log.technique)
            play(session, log)
        except LayfigureError as error:
            self._rewrite()
            session.say(f"Restored as far as it goes: {error}")
            return
        self._rewrite()
        journal.discard(path)
        session.say(f"Restored {len(log.commands)} steps; undo reaches back through them.")

    def _forget(self, session: Session, words: tuple[str, ...]) -> None:
        journal.discard(self._take())
        session.say("Thrown away.")

    def _take(self) -> Path:
        if not self._orphans:
            raise LayfigureError("no session is waiting to be restored")
        return self._orphans.pop(0)

    def _logged(self, line: str) -> None:
        if self._journal is not None:
            self._journal.append(line)

    def _rewrite(self) -> None:
        """Begin a new journal that holds the whole restored session."""
        self._session.on_logged = self._logged
        if self._journal is not None:
            self._journal.close()
        self._journal = journal.Journal.begin(self._session.log)
