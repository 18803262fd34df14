"""Makes a command of each control that a technique declares, so that keys, clicks, scripts and logs all reach it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

from layfigure.plugins.records import Command
from layfigure.session.words import WordError, no_more, number, one_of, switched
from layfigure.techniques.contract import Action, Choice, Control, Controls, Slider, Toggle

if TYPE_CHECKING:
    from layfigure.session.session import Session


def control_commands(controls: Iterable[Controls]) -> Iterator[Command]:
    """Yield the commands of controls; a shortcut is for another command and has none of its own."""
    for control in controls:
        match control:
            case Action():
                yield _action(control)
            case Slider():
                yield _slider(control)
            case Choice():
                yield _choice(control)
            case Toggle():
                yield _toggle(control)


def _action(control: Action) -> Command:
    def run(session: Session, words: tuple[str, ...]) -> None:
        value = words[0] if words and control.argument else None
        no_more(words, 1 if control.argument else 0)
        session.tell(control.title, Control(control.name, value), entry=not control.navigates)

    return Command(control.name, control.title, run, usage=control.argument, logged=True)


def _slider(control: Slider) -> Command:
    def run(session: Session, words: tuple[str, ...]) -> tuple[str, ...]:
        no_more(words, 1)
        value = number(words, 0, f"a number from {control.low:g} to {control.high:g}")
        if words[0][0] in "+-":
            present = session.offer().values.get(control.name, control.low)
            value = min(max(float(present) + value, control.low), control.high)
        if not control.low <= value <= control.high:
            raise WordError(
                1, f"{words[0]} is out of bounds: {control.title} goes from {control.low:g} to {control.high:g}"
            )
        session.tell(f"{control.title} {value:g}", Control(control.name, value))
        return (f"{value:g}",)

    return Command(control.name, control.title, run, usage=f"{control.low:g}…{control.high:g}", logged=True)


def _choice(control: Choice) -> Command:
    values = [value for value, _ in control.options]

    def run(session: Session, words: tuple[str, ...]) -> tuple[str, ...]:
        no_more(words, 1)
        if words:
            value = one_of(words, 0, control.title, values)
        else:
            present = str(session.offer().values.get(control.name, values[-1]))
            value = values[(values.index(present) + 1) % len(values)] if present in values else values[0]
        session.tell(f"{control.title}: {value}", Control(control.name, value))
        return (value,)

    return Command(control.name, control.title, run, usage="|".join(values), logged=True)


def _toggle(control: Toggle) -> Command:
    def run(session: Session, words: tuple[str, ...]) -> tuple[str, ...]:
        on = switched(words, lambda: session.offer().values.get(control.name) is True)
        word = "on" if on else "off"
        session.tell(f"{control.title}: {word}", Control(control.name, on))
        return (word,)

    return Command(control.name, control.title, run, usage="[on|off]", logged=True)
