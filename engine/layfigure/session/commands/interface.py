"""Commands of the interface itself: help, the palette, cancelling, quitting."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace
from itertools import islice
from typing import TYPE_CHECKING

from layfigure.errors import ImpossibleError, LayfigureError
from layfigure.figures.library import figure_names
from layfigure.files.decimals import plain
from layfigure.kinematics.forward import place_pose
from layfigure.motions.library import SUFFIX, motion_files, shipped_length
from layfigure.motions.numbers import written
from layfigure.plugins.discovery import plugin_file
from layfigure.plugins.records import Command
from layfigure.poses.locks import tips_of
from layfigure.session.commands.arguments import named_file, selected
from layfigure.session.commands.playing import SPEEDS
from layfigure.session.commands.slots import ask_recall, ask_store
from layfigure.session.describing import allowed_angles, spoken_limb
from layfigure.session.keymap import spoken
from layfigure.session.matching import Entry
from layfigure.session.modes import HelpMode, PaletteMode, help_page
from layfigure.session.moments import key_frames, known_curves
from layfigure.session.words import WordError, join_line, no_more, one_of, required, whole_number

if TYPE_CHECKING:
    from layfigure.session.session import Session

_HIDDEN = {
    *("accept", "complete", "row", "erase", "scroll", "ask", "palette"),
    *("pick-in", "enable-in", "select-in", "camera", "follow", "dragged", "joints"),
    *("motion", "motion-part"),
}

MOST_CHOICES = 400
QUESTIONS = (
    *("select", "open", "save", "use", "hold", "set", "goal", "store", "recall"),
    *("frame-at", "speed", "interpolation"),
)

_HINTS = {
    "save": "A name; it becomes NAME.pose and NAME.png in this folder.",
    "open": "No such pose or motion in this folder; any path will do.",
    "frame-at": "The number of a frame.",
}


def shown_commands(session: Session) -> dict[str, Command]:
    """Return the commands that a person may want to type, by name; what only keys and clicks run is left out."""
    return {name: command for name, command in session.commands().items() if name not in _HIDDEN}


def _help(session: Session, words: tuple[str, ...]) -> None:
    no_more(words, 1)
    if words:
        name = one_of(words, 0, "command", session.commands())
        command = session.commands()[name]
        key = session.key_for(name)
        said = f"{name} {command.usage}".strip()
        session.say(f"{said}: {command.title}.{f' Its key is {key}.' if key else ''}")
        return
    titles = {name: command.title for name, command in session.commands().items()}
    session.modes.append(HelpMode(help_page(session.key_table(), session.situation, titles)))


def _palette(session: Session, words: tuple[str, ...]) -> None:
    no_more(words, 0)
    table, situation = session.key_table(), replace(session.situation, state="pose")
    entries = []
    for name, command in sorted(shown_commands(session).items(), key=lambda item: item[1].title):
        keys = table.keys_for(name, situation)
        entries.append(Entry(name, command.title, command.usage, spoken(keys[0]) if keys else ""))
    session.modes.append(PaletteMode(tuple(entries)))


def _ask(session: Session, words: tuple[str, ...]) -> None:
    name = one_of(words, 0, "question", QUESTIONS)
    no_more(words, 1)
    if name in ("set", "goal"):
        session.modes.append(_numbers(session, name))
        return
    if name in ("store", "recall"):
        session.modes.append(ask_store(session) if name == "store" else ask_recall(session))
        return
    entries, prompt = _choices(session, name)
    session.modes.append(PaletteMode(entries, prompt=prompt, prefix=name, hint=_HINTS.get(name, "")))


def _numbers(session: Session, name: str) -> PaletteMode:
    """Return a prompt for the numbers of the selected limb, with the present ones typed already."""
    figure, pose, limb = session.document.figure, session.document.pose, selected(session)[-1]
    if name == "set":
        joint = figure.limbs[limb]
        kinds = [kind for kind in joint.kinds if joint.turns(kind)]
        values = [pose.angles[limb][joint.kinds.index(kind)] for kind in kinds]
        prompt = f"{' '.join(kinds).capitalize()} of the {spoken_limb(figure, limb)}:"
        hint = allowed_angles(figure.limbs[limb])
    else:
        values = list(tips_of(figure, place_pose(figure, pose))[limb])
        prompt = f"Place of the end of the {spoken_limb(figure, limb)}, x y z:"
        hint = "Figure units: x to its left, y up, z to its back."
    text = " ".join(plain(value, 2) for value in values)
    prefix = join_line(name, [figure.names[limb]])
    return PaletteMode((), text=text, prompt=prompt, prefix=prefix, verbatim=True, offered=True, hint=hint)


def _choices(session: Session, name: str) -> tuple[tuple[Entry, ...], str]:
    figure = session.document.figure
    limbs = (Entry(figure.names[limb], "") for limb in figure.selectable)
    choices: dict[str, tuple[Callable[[], Iterable[Entry]], str]] = {
        "select": (lambda: limbs, "Select limb:"),
        "save": (lambda: (), "Save as:"),
        "use": (lambda: (Entry(key, record.title) for key, record in session.host.techniques.items()), "Technique:"),
        "hold": (lambda: limbs, "Keep the offset from:"),
        "frame-at": (lambda: (Entry(written(frame), "a key") for frame in key_frames(session.document)), "Frame:"),
        "speed": (lambda: (Entry(f"{speed:g}", "times as fast") for speed in SPEEDS), "Speed:"),
        "interpolation": (
            lambda: (Entry(key, record.title) for key, record in known_curves(session.host).items()),
            "Led to:",
        ),
        "open": (lambda: openable(session), "Open:"),
    }
    entries, prompt = choices[name]
    return tuple(islice(entries(), MOST_CHOICES)), prompt


def openable(session: Session) -> Iterator[Entry]:
    """Yield what can be opened by name: poses and motions in the session's folder, and the motions that are shipped."""
    folder = session.options.folder
    for suffix, what in ((".pose", "a pose in this folder"), (SUFFIX, "a motion in this folder")):
        yield from (Entry(path.name, what) for path in sorted(folder.glob(f"*{suffix}"))[:200])
    for path in motion_files():
        yield Entry(path.stem, f"{written(shipped_length(path))} frames, comes with Layfigure")


def _cancel(session: Session, words: tuple[str, ...]) -> None:
    no_more(words, 0)
    if len(session.modes) > 1:
        session.modes.pop()
    elif session.view.passing is not None:
        session.playback.give_up()
        session.say(f"Back at frame {written(session.document.playhead)}, where play began.")
    else:
        session.view = replace(session.view, selected=())


def _typing(session: Session) -> PaletteMode:
    if not isinstance(session.mode, PaletteMode):
        raise ImpossibleError("nothing is being typed")
    return session.mode


def _accept(session: Session, words: tuple[str, ...]) -> None:
    no_more(words, 0)
    mode = _typing(session)
    try:
        session.modes.pop()
        session.execute(mode.line())
    except LayfigureError as error:
        wanting = isinstance(error, WordError) and error.index == len(mode.line().split())
        session.modes.append(replace(mode.awaiting() if wanting else mode, message=str(error)))


def _complete(session: Session, words: tuple[str, ...]) -> None:
    no_more(words, 0)
    session.modes[-1] = _typing(session).completed()


def _row(session: Session, words: tuple[str, ...]) -> None:
    session.modes[-1] = _typing(session).moved(whole_number(words, 0, "a number of rows", (-100, 100)))


def _erase(session: Session, words: tuple[str, ...]) -> None:
    no_more(words, 0)
    session.modes[-1] = _typing(session).erased()


def _scroll(session: Session, words: tuple[str, ...]) -> None:
    lines = whole_number(words, 0, "a number of lines", (-1000, 1000))
    if isinstance(session.mode, HelpMode):
        session.modes[-1] = session.mode.scrolled(lines)


def _quit(session: Session, words: tuple[str, ...]) -> None:
    no_more(words, 0)
    session.close()


def _figures(session: Session, words: tuple[str, ...]) -> None:
    no_more(words, 0)
    names = (*figure_names(), *session.host.figures)
    entries = tuple(Entry(name, "a figure") for name in names)
    session.modes.append(PaletteMode(entries, prompt="Figure:", prefix="figure"))


def _plugin(session: Session, words: tuple[str, ...]) -> None:
    """Not logged: a log that runs a stranger's code from a path would be a trap."""
    path = named_file(session, required(words, 0, "a plug-in file"))
    no_more(words, 1)
    session.swap_plugin(plugin_file(path))
    brought = ", ".join(record.id for record in session.host.records_of(path.stem)) or "nothing"
    session.say(f"Plug-in {path.stem} is in service; it brings {brought}.")


COMMANDS = (
    Command("help", "Show the keys, or say what a command does", _help, "[COMMAND]", passive=True),
    Command("palette", "Type a command", _palette, passive=True),
    Command("figures", "Choose another figure", _figures),
    Command("ask", "Ask for a word and run a command with it", _ask, "|".join(QUESTIONS)),
    Command("cancel", "Let go", _cancel, passive=True),
    Command("accept", "Do what is typed", _accept, passive=True),
    Command("complete", "Complete the word", _complete, passive=True),
    Command("row", "Choose another row", _row, "ROWS", passive=True),
    Command("erase", "Erase a character", _erase, passive=True),
    Command("scroll", "Scroll the help", _scroll, "LINES", passive=True),
    Command("plugin", "Load a plug-in file, or load it again", _plugin, "FILE"),
    Command("quit", "Quit", _quit, passive=True),
)
