"""Understands what is typed: abbreviated commands, limbs' names in two words; and completes it."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from layfigure.errors import LayfigureError
from layfigure.session.commands.interface import openable, shown_commands
from layfigure.session.moments import known_curves
from layfigure.session.words import join_line, split_line

if TYPE_CHECKING:
    from layfigure.session.session import Session

ALIASES = {"candidates": "list candidates", "render": "picture", "exit": "quit", "?": "help"}
"""Other names of commands, that people try at a prompt."""


def understood(session: Session, text: str) -> str:
    """Return a command line with its command's name in full and limbs' names as the figure writes them.

    Raises:
        LayfigureError: the name can mean several commands, or a quote is not closed.
    """
    line = split_line(text)
    if line is None:
        return ""
    name = full_name(session, line.name)
    words = line.words
    if name == "help" and words:
        words = (full_name(session, words[0]), *words[1:])
    head, *more = ALIASES.get(name, name).split()
    return join_line(head, [*more, *_joined(session, words)])


def full_name(session: Session, name: str) -> str:
    """Return the command that a name or the beginning of one means; what begins no command comes back as it is.

    Raises:
        LayfigureError: it can mean several.
    """
    commands = session.commands()
    lower = name.casefold()
    if lower in commands or lower in ALIASES:
        return lower
    found = sorted(word for word in {*shown_commands(session), *ALIASES} if word.startswith(lower))
    if len(found) > 1:
        raise LayfigureError(f'"{name[:40]}" can mean {", ".join(found[:-1])} or {found[-1]}; type more of it')
    return found[0] if found else name


def _joined(session: Session, words: tuple[str, ...]) -> list[str]:
    """Return words with "left hand" as "lefthand", where that is a limb and neither is "left"."""
    names = {name.casefold(): name for name in session.document.figure.names}
    found: list[str] = []
    for word in words:
        together = f"{found[-1]}{word}".casefold() if found else ""
        if together in names and found[-1].casefold() not in names:
            found[-1] = names[together]
        else:
            found.append(word)
    return found


def completions(session: Session, line: str, word: str) -> list[str]:
    """Return the words that can stand where ``word`` is being typed at the end of ``line``."""
    name, *rest = line.split(maxsplit=1) or [""]
    if not rest and not line.endswith(" "):
        return _beginning({*shown_commands(session), *ALIASES}, word)
    try:
        full = ALIASES.get(full_name(session, name), full_name(session, name)).split()[0]
    except LayfigureError:
        return []
    command = session.commands().get(full)
    if full == "help":
        return _beginning(shown_commands(session), word)
    return _beginning(_nameable(session, command.usage), word) if command is not None else []


def _nameable(session: Session, usage: str) -> Iterable[str]:
    """Yield the words that a command's usage speaks of."""
    for part in usage.strip("[]").split():
        for option in part.strip("[]…").split("|"):
            if option.islower():
                yield option
    if "LIMB" in usage:
        yield from session.document.figure.names
    if "TECHNIQUE" in usage:
        yield from session.host.techniques
    if "CANDIDATE" in usage:
        yield from map(str, range(1, len(session.offer().candidates) + 1))
    if "FILE" in usage:
        yield from (entry.command for entry in openable(session))
    if "INTERPOLATION" in usage:
        yield from known_curves(session.host)


def _beginning(words: Iterable[str], start: str) -> list[str]:
    return sorted(word for word in set(words) if word.casefold().startswith(start.casefold()))
