"""Interface states. A state answers an event with what shall happen and never does it itself.

The session keeps a stack of them; the top one hears first. ``None`` means "not mine": keys then go to the keymap.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Protocol

from layfigure.session import dialogs
from layfigure.session.events import Event, KeyEvent, PointerEvent
from layfigure.session.frame import HelpOverlay, ModalOverlay, Outline, PaletteOverlay, QuestionOverlay, Size
from layfigure.session.keymap import KeyTable, Situation, spoken, spoken_keys
from layfigure.session.matching import Entry, complete, matching
from layfigure.session.words import join_line


@dataclass(frozen=True)
class Push:
    """Put a state on top."""

    mode: Mode


@dataclass(frozen=True)
class Pop:
    """Leave the state on top."""


@dataclass(frozen=True)
class Become:
    """Replace the state on top."""

    mode: Mode


@dataclass(frozen=True)
class Run:
    """Run a command line."""

    line: str


@dataclass(frozen=True)
class Preview:
    """Show what a command line would do, until it is run or the gesture is given up."""

    line: str


@dataclass(frozen=True)
class Continue:
    """Show what a command line would do from where the last preview stands: the next step of a drag."""

    line: str


@dataclass(frozen=True)
class Settle:
    """End a drag: the pose it arrived at becomes one change and one line of the log, ``dragged LIMB PACKED``."""

    limb: str


@dataclass(frozen=True)
class GiveUp:
    """End a gesture without a trace."""


@dataclass(frozen=True)
class Hover:
    """The pointer is over (candidate, limb), or over nothing."""

    over: tuple[int, int] | None


@dataclass(frozen=True)
class Scrub:
    """The time line is dragged along: show a frame of the motion, until the gesture ends."""

    frame: int


Outcome = Push | Pop | Become | Run | Preview | Continue | Settle | GiveUp | Hover | Scrub


class Mode(Protocol):
    """A state of the interface."""

    @property
    def state(self) -> str:
        """The name keymaps know it by."""

    def hear(self, event: Event, size: Size) -> Sequence[Outcome] | None:
        """Return what shall happen on a surface of that size, or None to let the keymap decide."""

    def overlay(self) -> ModalOverlay | None:
        """Return what stands on top of the window, if anything."""

    def outlines(self) -> tuple[Outline, ...]:
        """Return boxes to draw, such as a rubber band."""


class Plain:
    """Defaults for a state: hears nothing, shows nothing."""

    @property
    def state(self) -> str:
        """The name keymaps know it by."""
        return "pose"

    def hear(self, event: Event, size: Size) -> Sequence[Outcome] | None:
        """Return None: the keymap decides."""
        del event, size
        return None

    def overlay(self) -> ModalOverlay | None:
        """Return nothing."""
        return None

    def outlines(self) -> tuple[Outline, ...]:
        """Return nothing."""
        return ()


@dataclass(frozen=True)
class HelpMode(Plain):
    """The help page, made from the key table."""

    page: HelpOverlay

    @property
    def state(self) -> str:
        """The name keymaps know it by."""
        return "help"

    def hear(self, event: Event, size: Size) -> Sequence[Outcome] | None:
        """Swallow everything but keys; a click closes."""
        del size
        if isinstance(event, KeyEvent):
            return None
        return [Pop()] if isinstance(event, PointerEvent) and event.pressed else []

    def overlay(self) -> ModalOverlay:
        """Return the help page."""
        return self.page

    def scrolled(self, lines: int) -> HelpMode:
        """Return the page scrolled by some lines, within its length."""
        length = sum(len(rows) + 2 for _, rows in self.page.sections)
        return HelpMode(replace(self.page, scroll=min(max(self.page.scroll + lines, 0), max(length - 12, 0))))


def help_page(table: KeyTable, situation: Situation, titles: dict[str, str]) -> HelpOverlay:
    """Return the help of everything that works in a situation; ``titles`` names commands without a title of theirs."""
    groups: dict[str, dict[tuple[str, str], tuple[str, ...]]] = {}
    for binding in table.valid(situation):
        example = binding.line(binding.keys[0]) if binding.keys else binding.command
        mine = [key for key in binding.keys if table.resolve(key, situation) == binding.line(key)]
        if mine:
            row = (binding.title or titles.get(example.split()[0], example), binding.command)
            group = groups.setdefault(binding.group, {})
            group[row] = (*group.get(row, ()), *mine)
    order = sorted(groups, key=lambda group: (group == "Everywhere", 0))
    sections = ((group, tuple((spoken_keys(keys), row[0]) for row, keys in groups[group].items())) for group in order)
    return HelpOverlay("Keys that work now", tuple(sections))


@dataclass(frozen=True)
class PaletteMode(Plain):
    """A line to type a command into, with the commands that match.

    With a ``prefix`` what is typed is the word that follows it; ``verbatim`` takes it as several words. A text that is
    ``offered`` stands there to be accepted or edited; typing at once replaces it. ``hint`` says what to type where no
    row can.
    """

    entries: tuple[Entry, ...]
    text: str = ""
    chosen: int = 0
    prompt: str = ":"
    prefix: str = ""
    message: str = ""
    verbatim: bool = False
    offered: bool = False
    hint: str = ""

    @property
    def state(self) -> str:
        """The name keymaps know it by."""
        return "palette"

    @property
    def rows(self) -> tuple[Entry, ...]:
        """The entries that match what is typed, best first."""
        return matching(self.entries, self.text)

    def hear(self, event: Event, size: Size) -> Sequence[Outcome] | None:
        """Take typed text or a click on a row; editing keys go to the keymap; a click outside closes."""
        if isinstance(event, KeyEvent):
            typed = event.text if event.text.isprintable() and "ctrl+" not in event.key else ""
            plain = len(event.key) == 1 or event.key == "space" or event.key.startswith(("shift+", "kp"))
            if typed and plain:
                kept = "" if self.offered else self.text
                return [Become(replace(self, text=kept + typed, chosen=0, message="", offered=False))]
            return None
        if not isinstance(event, PointerEvent) or not event.pressed:
            return []
        places = dialogs.palette(size, len(self.rows), self.chosen)
        for row, place in enumerate(places.rows, start=places.first):
            if place.contains(event.x, event.y):
                return [Become(replace(self, chosen=row)), Run("accept")]
        return [] if places.box.contains(event.x, event.y) else [Pop()]

    def erased(self) -> PaletteMode:
        """Return the state without the last character."""
        return replace(self, text=self.text[:-1], chosen=0, message="", offered=False)

    def moved(self, rows: int) -> PaletteMode:
        """Return the state with another row chosen."""
        count = len(self.rows)
        return replace(self, chosen=(self.chosen + rows) % count) if count else self

    def completed(self) -> PaletteMode:
        """Return the state with the chosen row's command typed out."""
        return replace(self, text=complete(self.rows, self.chosen, self.text), chosen=0)

    def awaiting(self) -> PaletteMode:
        """Return the state with the command it would run typed out, so that the word it lacks is typed after it."""
        return self if self.prefix else replace(self, text=f"{self.line()} ", chosen=0)

    def line(self) -> str:
        """Return the command line to run: what is typed if it names a command, else the chosen row."""
        if self.verbatim:
            return f"{self.prefix} {self.text.strip()}"
        if self.prefix:
            rows = self.rows
            exact = any(entry.command == self.text for entry in rows)
            return join_line(self.prefix, [self.text.strip() if exact or not rows else rows[self.chosen].command])
        words = self.text.split()
        if len(words) > 1 or any(entry.command == self.text.strip() for entry in self.entries) or not self.rows:
            return self.text.strip()
        return self.rows[self.chosen].command

    def overlay(self) -> PaletteOverlay:
        """Return the palette."""
        rows = tuple((" ".join((e.command, e.usage)).strip(), e.title, e.key) for e in self.rows)
        return PaletteOverlay(self.prompt, self.text, rows, self.chosen, self.message or ("" if rows else self.hint))


@dataclass(frozen=True)
class QuestionMode(Plain):
    """A question with a few answers, each (text, key, command)."""

    text: str
    answers: tuple[tuple[str, str, str], ...]

    @property
    def state(self) -> str:
        """The name keymaps know it by."""
        return "question"

    def hear(self, event: Event, size: Size) -> Sequence[Outcome] | None:
        """Take an answer's key or a click on it; Enter is the first answer, Esc the last."""
        if isinstance(event, PointerEvent) and event.pressed:
            places = dialogs.question(size, len(self.answers)).answers
            hit = [
                command
                for place, (*_, command) in zip(places, self.answers, strict=True)
                if place.contains(event.x, event.y)
            ]
            return [Pop(), *(Run(command) for command in hit)] if hit else []
        if not isinstance(event, KeyEvent):
            return []
        keys = {key: command for _, key, command in self.answers}
        keys.setdefault("enter", self.answers[0][2])
        keys.setdefault("escape", self.answers[-1][2])
        return [Pop(), Run(keys[event.key])] if event.key in keys else []

    def overlay(self) -> QuestionOverlay:
        """Return the question."""
        return QuestionOverlay(self.text, tuple((text, spoken(key), command) for text, key, command in self.answers))
