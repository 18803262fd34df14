"""Laws of techniques that are told one event at a time: declarations, controls, unknown events, storage."""

from __future__ import annotations

import json
from collections import Counter
from typing import Any

from layfigure.errors import LayfigureError
from layfigure.plugins.records import Technique
from layfigure.session.words import split_line
from layfigure.techniques.contract import Action, Choice, Control, Setting, Shortcut, Slider, Toggle
from layfigure.testing.fingerprint import lasting_print, offer_print, pose_print
from layfigure.testing.scenes import EVENTS, nonsense_for, values_of
from layfigure.testing.subject import Subject, spoken

_TERMINAL_KEYS = frozenset({"ctrl+m", "ctrl+i", "ctrl+["})


def check_declaration(record: Technique) -> None:
    """Check that controls have names and keys of their own, and none that a terminal sends for another key."""
    names = Counter(control.name for control in record.controls if not isinstance(control, Shortcut))
    keys = Counter(key for control in record.controls for key in control.keys or ())
    for kind, counted in (("controls are called", names), ("controls have the key", keys)):
        twice = [name for name, count in counted.items() if count > 1]
        assert not twice, f"technique {record.id}: two {kind} {twice[0]}"
    taken = sorted(_TERMINAL_KEYS & set(keys))
    assert not taken, f"technique {record.id}: {taken[0]} is another key in a terminal; choose one that is not"
    for control in record.controls:
        if isinstance(control, Shortcut):
            line = split_line(control.command)
            assert line is not None, f"technique {record.id}: the shortcut {control.title!r} has no command"
        if isinstance(control, Slider):
            right = control.low < control.high and control.step > 0
            assert right, f"technique {record.id}: the slider {control.name} has no range or no step"


def check_controls(subject: Subject, setting: Setting) -> None:
    """Check that every control takes what it declares, shows it, and refuses anything else with a sentence."""
    state = subject.start(setting)
    for control in subject.record.controls:
        if isinstance(control, Shortcut):
            continue
        for value in values_of(control):
            _check_taken(subject, state, control, value)
        for value in nonsense_for(control):
            event = Control(control.name, value)
            subject.require(bool(subject.tell(state, event).refusal), f"it takes {spoken(event)}, which is nonsense")


def _check_taken(
    subject: Subject, state: Any, control: Action | Slider | Choice | Toggle, value: float | str | bool | None
) -> None:
    """An action may be impossible just now; a slider, a choice and a toggle take each of their values and show it."""
    event = Control(control.name, value)
    told = subject.tell(state, event)
    shown = subject.ask(told.state).values.get(control.name)
    subject.recommend(told.state)
    if not isinstance(control, Action):
        subject.require(not told.refusal, f"it refuses {spoken(event)}, which it declares ({told.refusal})")
        subject.require(shown == value, f"after {spoken(event)} the offer's values say {shown!r}")


def check_unknown_events(subject: Subject, setting: Setting) -> None:
    """Check that events it does not understand are refused, or change nothing."""
    state = subject.start(setting)
    before = offer_print(subject.ask(state))
    limb = subject.figure.movable[0]
    samples: dict[str, tuple[Any, ...]] = {
        "limb_pick": (0, (limb,)),
        "best": (0,),
        "grade": (0, 5),
        "goal": (limb, (0.0, 10.0, 0.0)),
        "drag": (limb, (0.0, 0.0, 0.0)),
    }
    unknown = [
        EVENTS[channel](*values) for channel, values in samples.items() if channel not in subject.record.channels
    ]
    for event in (*unknown, Control("there is no such control", 1.0), _Unheard()):
        told = subject.tell(state, event)
        same = bool(told.refusal) or (
            subject.recommend(told.state) == setting.pose and offer_print(subject.ask(told.state)) == before
        )
        subject.require(same, f"{spoken(event)} is none of its events, but it changes something")


class _Unheard:
    """An event of a later version of the contract."""


def check_storage(subject: Subject, setting: Setting) -> None:
    """Check that damaged data, and data of a version to come, are refused with a sentence when they are loaded."""
    data = json.loads(subject.dump(subject.start(setting)))
    damaged: list[tuple[str, dict[str, Any]]] = [
        ("nothing", {}),
        ("only a version", {"version": data["version"]}),
        ("a version to come", {**data, "version": 10**6}),
    ]
    for what, wrong in damaged:
        try:
            subject.technique.load(wrong)
        except LayfigureError:
            continue
        except Exception as error:
            raise subject.breach(f"load raised {type(error).__name__} ({error}) on {what}") from error
        raise subject.breach(f"load takes {what} for a state")


def check_round_trip(subject: Subject, state: Any) -> None:
    """Check that another object of the technique loads what was dumped, and offers and recommends the same.

    What an offer says of a gesture that is going on, its note and its marks, need not outlast it.
    """
    data = json.loads(subject.dump(state))
    other = subject.fresh()
    try:
        loaded = other.load(data)
        shown, pose = lasting_print(other.ask(loaded)), other.recommend(loaded)
    except Exception as error:
        raise subject.breach(f"a dumped state cannot be loaded: {type(error).__name__} ({error})") from error
    subject.require(pose_print(pose) == pose_print(subject.recommend(state)), "a loaded state stands at another pose")
    subject.require(shown == lasting_print(subject.ask(state)), "a loaded state offers something else")
