"""Reads a command, runs it, says what it did, and again."""

from __future__ import annotations

import sys
from collections.abc import Callable
from typing import TYPE_CHECKING

from layfigure.errors import LayfigureError
from layfigure.session.commands.interface import shown_commands
from layfigure.session.modes import QuestionMode
from layfigure_frontends.plain.interruptions import EndedError, Interruptions
from layfigure_frontends.plain.reading import Pipe, Reader, Terminal
from layfigure_frontends.plain.readying import Readying
from layfigure_frontends.plain.telling import Before, outcome
from layfigure_frontends.plain.voice import Voice, as_sentence, at_terminal
from layfigure_frontends.plain.words import ALIASES, completions, understood

if TYPE_CHECKING:
    from layfigure.session.session import Session

FAILED = 2
INTERRUPTED = 130


def run(make_session: Callable[[], Session], *, strict: bool = False) -> int:
    """Make the session and work in it, line by line, until it ends; return the exit status.

    With ``strict`` the first command that fails in a pipe ends it with status 2.

    Raises:
        LayfigureError: the session cannot be made.
    """
    terminal = at_terminal()
    voice, interruptions = Voice(terminal=terminal), Interruptions()
    with interruptions.handled():
        session = make_session()
        reader: Reader = Terminal(lambda line, word: completions(session, line, word)) if terminal else Pipe()
        readying = Readying(session, voice)
        prompt = _Prompt(session, voice, reader, interruptions)
        status = FAILED
        try:
            prompt.greet()
            if terminal:
                readying.begin()
            status = prompt.work(strict=strict and not terminal)
        finally:
            kept = bool(interruptions.caught) or status == INTERRUPTED or sys.exc_info()[0] is not None
            session.close(interrupted=kept)
            readying.stop()
            reader.close()
    return 128 + interruptions.caught[0] if interruptions.caught else status


class _Prompt:
    """A conversation about one session."""

    def __init__(self, session: Session, voice: Voice, reader: Reader, interruptions: Interruptions) -> None:
        self._session = session
        self._voice = voice
        self._reader = reader
        self._interruptions = interruptions
        self._terminal = isinstance(reader, Terminal)
        self._question: QuestionMode | None = None

    def greet(self) -> None:
        """Say where one is, at a terminal, and what stands open, such as a session to restore."""
        session = self._session
        if self._terminal:
            technique = session.workshop.record(session.document.technique).title
            name = session.document.figure.name
            self._voice.say([f"{name.capitalize()}, technique {technique}. Type help, describe or quit."])
        if session.status:
            self._voice.warn(as_sentence(session.status))
        if isinstance(session.mode, QuestionMode):
            self._question = session.mode if self._terminal else None
            for line in outcome(session, Before.of(session)):
                self._voice.warn(line)

    def work(self, *, strict: bool) -> int:
        """Run commands until the session or the input ends; return the exit status."""
        pressed = False
        while self._session.running:
            try:
                with self._interruptions.awaiting():
                    line = self._reader.line()
            except EndedError:
                return FAILED
            except KeyboardInterrupt:
                if pressed or not self._terminal:
                    return INTERRUPTED
                pressed = True
                self._voice.say(["", "Line cancelled. Ctrl-C again quits and keeps the session for the next start."])
                continue
            except LayfigureError as error:
                self._voice.warn(as_sentence(str(error)))
                if strict:
                    return FAILED
                continue
            pressed = False
            if line is None:
                self._voice.say([""] if self._terminal else [])
                return 0
            if not self._do(line) and strict:
                return FAILED
        return 0

    def _do(self, line: str) -> bool:
        """Run one line and say what it did; return whether it went well."""
        session = self._session
        try:
            text = understood(session, self._answer(line))
            if text == "help":
                self._voice.say(self._help())
            elif text:
                before = Before.of(session)
                session.status = ""
                session.execute(text)
                self._refuse_screenshot()
                self._voice.say(outcome(session, before) if session.running else [])
        except LayfigureError as error:
            del session.modes[1:]
            self._voice.warn(as_sentence(str(error)))
            return False
        finally:
            session.revision += 1
        return True

    def _answer(self, line: str) -> str:
        """Return the command that a line means as an answer to the question asked last, or the line as it is."""
        question, self._question = self._question, None
        if question is None:
            return line
        answers = {key: command for _, key, command in question.answers}
        return answers.get(line.strip().casefold(), line)

    def _refuse_screenshot(self) -> None:
        if self._session.screenshot_request is not None:
            self._session.screenshot_request = None
            raise LayfigureError("there is no window to take a picture of; picture NAME saves one of the pose")

    def _help(self) -> list[str]:
        names = sorted({*shown_commands(self._session), *ALIASES} - {"?"})
        return [
            "Type a command and Enter; the beginning of its name is enough where no other begins so.",
            "help COMMAND says what one does, list commands says what each does.",
            f"Commands: {', '.join(names)}.",
        ]
