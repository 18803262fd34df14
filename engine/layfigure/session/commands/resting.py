"""Commands that put limbs back to rest: everything, some limbs, what hangs below one, or one degree of freedom."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from layfigure.errors import ImpossibleError
from layfigure.figures.definition import ALL_KINDS
from layfigure.figures.figure import axis_of
from layfigure.plugins.records import Command
from layfigure.poses.pose import Pose
from layfigure.session.commands.arguments import limbs, selected
from layfigure.session.describing import listed_limbs
from layfigure.session.words import join_line, one_of
from layfigure.techniques.contract import PoseSet

if TYPE_CHECKING:
    from layfigure.session.session import Session


def _initialise(session: Session, words: tuple[str, ...]) -> None:
    if words or not session.view.selected:
        session.execute(join_line("rest", words or ("all",)))
        return
    names = [session.document.figure.names[limb] for limb in session.view.selected]
    session.execute(join_line("rest", names))


def _rest(session: Session, words: tuple[str, ...]) -> None:
    if words == ("all",):
        session.set_pose("initialise all", PoseSet(Pose.rest(session.document.figure), fresh=True))
        session.say("Everything is back to rest; the first generation begins again.")
        return
    _put_to_rest(session, limbs(session, words, 0))


def _rest_below(session: Session, words: tuple[str, ...]) -> tuple[str, ...]:
    figure = session.document.figure
    heads = limbs(session, words, 0) if words else selected(session)
    below = frozenset[int]().union(*(figure.subtree(limb) for limb in heads))
    chosen = [limb for limb in figure.selectable if limb in below]
    if not chosen:
        raise ImpossibleError(f"nothing can move from the {listed_limbs(figure, heads)} on")
    _put_to_rest(session, chosen)
    return tuple(figure.names[limb] for limb in heads)


def _put_to_rest(session: Session, chosen: Sequence[int]) -> None:
    figure, pose = session.document.figure, session.document.pose
    moved = pose.with_joints_of(Pose.rest(figure), chosen)
    session.set_pose("initialise limbs", PoseSet(moved, limbs=tuple(chosen)))
    session.say(f"Back to rest: {listed_limbs(figure, chosen)}.")


def _rest_dof(session: Session, words: tuple[str, ...]) -> tuple[str, ...]:
    kind = one_of(words, 0, "degree of freedom", ALL_KINDS)
    figure, pose = session.document.figure, session.document.pose
    named = limbs(session, words, 1) if len(words) > 1 else selected(session)
    columns = {limb: axis_of(figure.limbs[limb], kind) for limb in named}
    chosen = tuple(limb for limb, column in columns.items() if column is not None)
    if not chosen:
        raise ImpossibleError(f"the {listed_limbs(figure, named)} has no {kind}")
    angles = pose.angles.copy()
    for limb in chosen:
        angles[limb, columns[limb]] = 0.0
    session.set_pose(f"{kind} to rest", PoseSet(pose.with_angles(angles), limbs=chosen))
    session.say(f"{kind.capitalize()} back to rest: {listed_limbs(figure, chosen)}.")
    return (kind, *(figure.names[limb] for limb in chosen))


COMMANDS = (
    Command("initialise", "Selected limbs, or everything, back to rest", _initialise, "[LIMB…|all]"),
    Command("rest", "Put limbs back to rest", _rest, "LIMB…|all", logged=True),
    Command("rest-below", "Put limbs and everything below them back to rest", _rest_below, "[LIMB…]", logged=True),
    Command(
        "rest-dof",
        "Put one degree of freedom back to rest",
        _rest_dof,
        "flexion|pivot|twist|x|y|z [LIMB…]",
        logged=True,
    ),
)
