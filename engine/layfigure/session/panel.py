"""The panel: what the technique in use declares, as widgets, and the buttons that are always there."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import TypeVar

from layfigure.session.frame import Button, ChoiceBar, JointBall, JointCircle, Label, SliderBar, Widget
from layfigure.session.layout import Column
from layfigure.techniques.contract import Action, Choice, Controls, Offer, Slider, Toggle


@dataclass(frozen=True)
class PanelText:
    """What the panel says: the selected limb in words, the techniques as (id, title), the one in use, its controls.

    ``dials`` are the joint's widgets, still without a place.
    """

    limb: tuple[str, ...]
    techniques: tuple[tuple[str, str], ...]
    technique: str
    controls: tuple[Controls, ...]
    offer: Offer
    dials: tuple[JointBall | JointCircle | SliderBar, ...] = ()
    on: frozenset[str] = frozenset()  # the buttons that are always there and stand pressed, by command


T = TypeVar("T")

ALWAYS = (
    ("Initialise", "initialise"),
    ("Mirror", "flip"),
    ("Undo", "undo"),
    ("Redo", "redo"),
    ("Save", "save"),
    ("Help", "help"),
    ("Symmetric", "symmetric"),
    ("Compare", "diff"),
)


def panel(column: Column, text: PanelText, key: Callable[[str], str]) -> Iterator[Widget]:
    """Yield the panel's widgets from top to bottom; ``key`` names the key of a command line."""
    of = column.of
    for line in text.limb:
        yield Label(column.row(of.limb, of.limb_gap), line, "text" if line == text.limb[0] else "small")
    column.row(of.limb_after, 0)
    yield from _dials(column, text)
    if len(text.techniques) > 1:
        yield ChoiceBar(column.row(of.choice), "Technique", "use", text.techniques, text.technique, key("use"))
    if text.offer.title:
        yield Label(column.row(of.caption), text.offer.title, "title")
    yield from _values(column, text, key)
    actions = [(c.title, c.name) for c in text.controls if isinstance(c, Action) and not c.argument]
    buttons = [*actions, *ALWAYS]
    yield from _toggles(column, text, key, -(-len(buttons) // column.across(of.across)) * (of.button + of.gap_y))
    yield from _buttons(column, buttons, text, key)


def _dials(column: Column, text: PanelText) -> Iterator[Widget]:
    """Yield the joint's dials side by side, or where those have no height a slider a line."""
    high = column.of.dial
    if not text.dials or not column.fits(high):
        return
    places = column.split(len(text.dials), high) if high else [column.row(column.of.slider) for _ in text.dials]
    for rectangle, dial in zip(places, text.dials, strict=True):
        yield replace(dial, rectangle=rectangle)


def _values(column: Column, text: PanelText, key: Callable[[str], str]) -> Iterator[Widget]:
    for control in text.controls:
        if isinstance(control, Slider):
            value = text.offer.values.get(control.name)
            keys = "  ".join(key(f"{control.name} {sign}{control.step:g}") for sign in "-+")
            shown = float(value) if isinstance(value, int | float) else control.low
            yield SliderBar(
                column.row(column.of.slider),
                control.title,
                control.name,
                shown,
                control.low,
                control.high,
                control.step,
                keys.strip(),
                control.unit,
            )
        elif isinstance(control, Choice):
            value = text.offer.values.get(control.name)
            row = column.row(column.of.choice)
            yield ChoiceBar(row, control.title, control.name, control.options, str(value), key(control.name))


def _toggles(column: Column, text: PanelText, key: Callable[[str], str], below: float) -> Iterator[Widget]:
    """Yield the toggles that leave room for the buttons ``below`` them; the palette has them all."""
    toggles = [control for control in text.controls if isinstance(control, Toggle)]
    across, of = column.across(2 if len(toggles) <= 2 else column.of.toggles_across), column.of
    for row in _rows(toggles, across):
        if not column.fits(of.toggle + of.gap_y + below):
            return
        for rectangle, toggle in zip(column.split(across, of.toggle), row, strict=False):
            on = text.offer.values.get(toggle.name) is True
            yield Button(rectangle, toggle.title, toggle.name, key(toggle.name), active=on)


def _buttons(
    column: Column, buttons: Sequence[tuple[str, str]], text: PanelText, key: Callable[[str], str]
) -> Iterator[Widget]:
    across, height = column.across(column.of.across), column.of.button
    for row in _rows(buttons, across):
        if not column.fits(height):
            return
        for rectangle, (title, command) in zip(column.split(across, height), row, strict=False):
            yield Button(rectangle, title, command, key(command), active=command in text.on)


def _rows(items: Sequence[T], across: int) -> Iterator[Sequence[T]]:
    yield from (items[i : i + across] for i in range(0, len(items), across))
