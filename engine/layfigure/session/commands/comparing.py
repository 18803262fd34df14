"""The command that shows what sets the pose apart from another one."""

from __future__ import annotations

from typing import TYPE_CHECKING

from layfigure.errors import ImpossibleError
from layfigure.plugins.records import Command
from layfigure.poses.difference import Difference, difference
from layfigure.poses.pose import Pose
from layfigure.session.commands.files import figure_and_pose, named_file
from layfigure.session.commands.slots import pose_in, slot_number
from layfigure.session.describing import spoken_limb
from layfigure.session.figures import reference_to
from layfigure.session.frame import HelpOverlay
from layfigure.session.modes import HelpMode
from layfigure.session.words import no_more
from layfigure.wording.changes import difference_lines

if TYPE_CHECKING:
    from layfigure.figures.figure import Figure
    from layfigure.session.session import Session


def _diff(session: Session, words: tuple[str, ...]) -> None:
    no_more(words, 1)
    name, other = _other(session, words)
    figure = session.document.figure
    found = difference(figure, other, session.document.pose)
    if found.equal:
        session.say(f"The pose is the same as {name}.")
        return
    session.modes.append(HelpMode(_page(figure, found, name)))


def _other(session: Session, words: tuple[str, ...]) -> tuple[str, Pose]:
    """Return what to compare with: a slot, a file, or else the pose before it last changed; and what to call it."""
    if not words:
        return "the pose before the last change", _earlier(session)
    if words[0].isdecimal():
        slot = slot_number(words)
        return f"slot {slot}", pose_in(session, slot)
    path = named_file(session, words[0])
    figure, pose = figure_and_pose(session.host, path)
    if reference_to(figure) != reference_to(session.document.figure):
        raise ImpossibleError(f"{path.name} is a pose of {figure.name}, not of {session.document.figure.name}")
    return path.name, pose


def _earlier(session: Session) -> Pose:
    present = session.document
    for change in reversed(session.history.done):
        if change.before.figure is not present.figure:
            break
        if change.before.pose != present.pose:
            return change.before.pose
    raise ImpossibleError("the pose has not changed yet; diff takes a slot or a file to compare with")


def _page(figure: Figure, found: Difference, name: str) -> HelpOverlay:
    rows = [(f"{found.closeness:.1f}", f"closeness: {found.share:.1%} of the figure's length")]
    if found.carried_words:
        rows.append((" ".join(f"{way:+.4g}" for way in found.carried), f"the root carried {found.carried_words}"))
    sections = [("In all", tuple(rows))]
    for change in found.limbs:
        angles = [(f"{angle.kind} {angle.degrees:+.4g}°", angle.words) for angle in change.angles]
        sections.append(
            (spoken_limb(figure, change.limb), (*angles, (f"{change.tip_distance:.1f}", "its tip moved, in units")))
        )
    spoken = tuple(difference_lines(figure, found))
    return HelpOverlay(f"Compared with {name}", tuple(sections), keys=False, spoken=spoken)


COMMANDS = (Command("diff", "Compare the pose with another one", _diff, "[SLOT|FILE]"),)
