"""Commands that change the pose itself, whatever technique is in use, and undo."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from layfigure.figures.definition import ALL_KINDS, MAXIMUM_TURN
from layfigure.figures.figure import limits_from
from layfigure.files.decimals import plain
from layfigure.plugins.records import Command
from layfigure.poses.locks import mirrored
from layfigure.poses.packing import pack_pose
from layfigure.poses.pose import Pose
from layfigure.poses.symmetry import flipped
from layfigure.session.commands.arguments import column_of, one_limb, packed_pose, selected
from layfigure.session.commands.naming import forget_undone
from layfigure.session.describing import spoken_limb
from layfigure.session.document import Document
from layfigure.session.figures import open_figure
from layfigure.session.words import WordError, join_line, no_more, number, one_of, required
from layfigure.techniques.contract import Drag, PoseSet

if TYPE_CHECKING:
    from layfigure.session.session import Session


def _set(session: Session, words: tuple[str, ...]) -> tuple[str, ...]:
    figure = session.document.figure
    limb = one_limb(session, words, 0)
    angles = _angles(session, limb, words)
    if "drag" in session.channels:
        session.tell(f"set {figure.names[limb]}", Drag(limb, angles))
    else:
        moved = session.document.pose.with_joint(limb, *angles)
        session.set_pose(f"set {figure.names[limb]}", PoseSet(moved, limbs=(limb,)))
    return (words[0], *map(plain, angles))


def _angles(session: Session, limb: int, words: tuple[str, ...]) -> tuple[float, float, float]:
    """Return the angles in words: all three, or one for each degree of freedom that the joint has."""
    figure = session.document.figure
    joint, name = figure.limbs[limb], spoken_limb(figure, limb)
    has, most = [joint.turns(kind) for kind in joint.kinds], MAXIMUM_TURN if joint.euler else 180.0
    given = [index for index in range(3) if has[index]] if len(words) - 1 == sum(has) and any(has) else [0, 1, 2]
    angles = [0.0, 0.0, 0.0]
    for place, index in enumerate(given):
        angles[index] = number(words, place + 1, f"the {joint.kinds[index]} of the {name} in degrees")
        if angles[index] and not has[index]:
            raise WordError(place + 2, f"the {name} has no {joint.kinds[index]}; 0 is wanted here")
        if abs(angles[index]) > most:
            raise WordError(place + 2, f"{words[place + 1]} is out of bounds: angles go from {-most:.0f} to {most:.0f}")
    no_more(words, len(given) + 1)
    return (angles[0], angles[1], angles[2])


def _angle(session: Session, words: tuple[str, ...]) -> tuple[str, ...]:
    """Set one angle of a joint as ``set`` does all three."""
    limb = one_limb(session, words, 0)
    kind = one_of(words, 1, "degree of freedom", ALL_KINDS)
    number(words, 2, f"the {kind} in degrees")
    no_more(words, 3)
    angles = [plain(angle) for angle in session.document.pose.angles[limb].tolist()]
    angles[column_of(session, limb, kind)] = words[2]
    _set(session, (words[0], *angles))
    return words


def _nudge(session: Session, words: tuple[str, ...]) -> None:
    kind = one_of(words, 0, "degree of freedom", ALL_KINDS)
    step = number(words, 1, "a number of degrees")
    no_more(words, 2)
    figure = session.document.figure
    limb = figure.limbs[selected(session)[-1]]
    angles, column = session.document.pose.angles[limb.index].tolist(), column_of(session, limb.index, kind)
    low, high = limits_from(limb, angles)[column]
    angles[column] = min(max(angles[column] + step, low), high)
    session.execute(join_line("set", [limb.name, *map(plain, angles)]))


def _flip(session: Session, words: tuple[str, ...]) -> None:
    no_more(words, 0)
    figure, workshop = session.document.figure, session.workshop
    turned = workshop.set_locks(session.document, mirrored(figure, session.document.locks))
    session.commit("mirror the pose", workshop.set_pose(turned, PoseSet(flipped(figure, session.document.pose))))
    session.say("Mirrored the pose.")


def _pose(session: Session, words: tuple[str, ...]) -> None:
    pose = packed_pose(session, words, 0)
    no_more(words, 1)
    session.set_pose("open a pose", PoseSet(pose))


def _figure(session: Session, words: tuple[str, ...]) -> None:
    name = required(words, 0, "a figure's name")
    no_more(words, 1)
    document = Document.new(open_figure(session.host, name))
    session.view = replace(session.view, selected=(), hover=None, candidate=0)
    session.commit(f"figure {name}", session.workshop.use(document, session.document.technique))
    session.saved_as = None


def _undo(session: Session, words: tuple[str, ...]) -> None:
    no_more(words, 0)
    change = session.history.undo()
    session.restore(change.before)
    forget_undone(session, change)
    session.say(f"Undone: {change.title}.")


def _redo(session: Session, words: tuple[str, ...]) -> None:
    no_more(words, 0)
    change = session.history.redo()
    session.restore(change.after)
    forget_undone(session, change)
    session.say(f"Done again: {change.title}.")


def pose_line(session: Session, pose: Pose) -> str:
    """Return the command line that sets a whole pose in a log."""
    return join_line("pose", [pack_pose(session.document.figure, pose)])


COMMANDS = (
    Command("set", "Set a joint's angles", _set, "LIMB FLEXION [PIVOT TWIST]", logged=True),
    Command("angle", "Set one angle of a joint", _angle, "LIMB flexion|pivot|twist|x|y|z DEGREES", logged=True),
    Command("nudge", "Move the selected joint a little", _nudge, "flexion|pivot|twist|x|y|z DEGREES"),
    Command("flip", "Mirror the pose", _flip, logged=True),
    Command("pose", "Set the whole pose from its packed form", _pose, "PACKED", logged=True),
    Command("figure", "Begin with another figure", _figure, "NAME", logged=True),
    Command("undo", "Undo", _undo, logged=True),
    Command("redo", "Redo", _redo, logged=True),
)
