"""Which values a control takes: said once, for every technique that declares controls."""

from __future__ import annotations

import math
from collections.abc import Iterable

from layfigure.errors import ImpossibleError
from layfigure.techniques.contract import Action, Choice, Control, Controls, Shortcut, Slider, Toggle

Value = float | str | bool | None


def checked_value(controls: Iterable[Controls], event: Control) -> Value:
    """Return the value of a control event: a float in a slider's range, an option, a bool, a word or None.

    Raises:
        ImpossibleError: no such control is declared, or the value is not one that it takes.
    """
    for control in controls:
        if not isinstance(control, Shortcut) and control.name == event.name:
            return _checked(control, event.value)
    raise ImpossibleError(f'there is no control "{event.name}" here')


def _checked(control: Action | Slider | Choice | Toggle, value: Value) -> Value:
    match control:
        case Slider(low=low, high=high):
            number = isinstance(value, int | float) and not isinstance(value, bool)
            if number and math.isfinite(float(value or 0)) and low <= float(value or 0) <= high:
                return float(value or 0)
            raise ImpossibleError(f"{control.title} goes from {low:g} to {high:g}, {value!r} is not in it")
        case Choice(options=options):
            if isinstance(value, str) and value in [option for option, _ in options]:
                return value
            known = ", ".join(option for option, _ in options)
            raise ImpossibleError(f"{control.title} can be {known}, not {value!r}")
        case Toggle():
            if isinstance(value, bool):
                return value
            raise ImpossibleError(f"{control.title} is on or off, not {value!r}")
        case Action(argument=argument):
            if value is None or (argument and isinstance(value, str)):
                return value
            raise ImpossibleError(f"{control.title} takes {argument or 'no word'}, not {value!r}")
