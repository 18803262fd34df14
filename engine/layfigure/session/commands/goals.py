"""Commands that say where the end of a limb is wanted; a technique that understands goals moves it there."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from layfigure.errors import ImpossibleError, LayfigureError
from layfigure.kinematics.forward import place_pose
from layfigure.plugins.records import Command
from layfigure.poses.lock_words import plain
from layfigure.poses.locks import rounded, tips_of
from layfigure.poses.packing import unpack_pose
from layfigure.session.commands.candidates import one_limb
from layfigure.session.describing import spoken_limb
from layfigure.session.lock_keeping import changed_limbs
from layfigure.session.words import WordError, join_line, no_more, number, required, whole_number
from layfigure.techniques.contract import Goal, PoseSet

if TYPE_CHECKING:
    from layfigure.session.session import Session

FARTHEST = 1e6  # figure units


def _goal(session: Session, words: tuple[str, ...]) -> tuple[str, ...]:
    limb = one_limb(session, words, 0)
    position = _position(words)
    no_more(words, 4)
    _check_takes_goals(session)
    name = spoken_limb(session.document.figure, limb)
    session.tell(f"move {name}", Goal(limb, position))
    _report(session, name)
    return (words[0], *(plain(value) for value in position))


def _position(words: tuple[str, ...]) -> tuple[float, float, float]:
    values = [number(words, index, "a coordinate in figure units") for index in (1, 2, 3)]
    for index, value in enumerate(values, start=2):
        if abs(value) > FARTHEST:
            raise WordError(index, f"{words[index - 1]} is too far away; coordinates go to {FARTHEST:.0f}")
    return rounded(np.array(values))


def _follow(session: Session, words: tuple[str, ...]) -> None:
    limb = one_limb(session, words, 0)
    panes = session.stage.picture.frame.panes
    pane = panes[whole_number(words, 1, "a view", (0, len(panes) - 1))]
    x, y, depth = (number(words, index, "a pixel coordinate") for index in (2, 3, 4))
    no_more(words, 5)
    _check_takes_goals(session)
    name = spoken_limb(session.document.figure, limb)
    session.tell(f"drag {name}", Goal(limb, session.stage.world_at(pane, x, y, depth), dragging=True))
    _report(session, name)


def _dragged(session: Session, words: tuple[str, ...]) -> None:
    limb = one_limb(session, words, 0)
    token = required(words, 1, "a packed pose")
    no_more(words, 2)
    try:
        pose = unpack_pose(session.document.figure, token)
    except LayfigureError as error:
        raise WordError(2, str(error)) from None
    changed = tuple(sorted(changed_limbs(session.document.pose, pose)))
    title = f"drag {spoken_limb(session.document.figure, limb)}"
    session.set_pose(title, PoseSet(pose, limbs=changed), settled=True)


def _move(session: Session, words: tuple[str, ...]) -> None:
    steps = np.array([number(words, index, "figure units") for index in (0, 1, 2)])
    no_more(words, 3)
    _check_takes_goals(session)
    if not session.view.selected:
        raise ImpossibleError("no limb is selected; Tab selects one")
    figure, limb = session.document.figure, session.view.selected[-1]
    tip = tips_of(figure, place_pose(figure, session.document.pose))[limb]
    right, up, away = np.array(session.view.camera.rotation)
    goal = tip + steps[0] * right + steps[1] * up + steps[2] * away
    session.execute(join_line("goal", [figure.names[limb], *(plain(value) for value in rounded(goal))]))


def _check_takes_goals(session: Session) -> None:
    if "goal" not in session.channels:
        able = [record.title for record in session.host.techniques.values() if "goal" in record.channels]
        hint = f"; use {' or '.join(able)}" if able else ""
        raise ImpossibleError(f"this technique moves no ends{hint}")


def _report(session: Session, name: str) -> None:
    """Say what the technique has to say, such as how far out of reach the goal is."""
    note = session.offer().note
    session.say(note or f"Moved the {name}.")


COMMANDS = (
    Command("goal", "Move the end of a limb to a place", _goal, "LIMB X Y Z", logged=True),
    Command("move", "Move the end of the selected limb as seen", _move, "RIGHT UP AWAY"),
    Command("follow", "Let the end of a limb follow the pointer", _follow, "LIMB VIEW X Y DEPTH"),
    Command("dragged", "Set the pose that a drag arrived at", _dragged, "LIMB PACKED", logged=True),
)
