"""Copy and paste of limbs. The clipboard holds the text of a ``.pose`` file with only the copied joints in it."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from layfigure.errors import ImpossibleError, LayfigureError
from layfigure.figures.figure import Figure
from layfigure.plugins.records import Command
from layfigure.poses.locks import locked_joints
from layfigure.poses.packing import pack_pose
from layfigure.poses.pose import Pose
from layfigure.poses.pose_file import MAXIMUM_POSE_BYTES, read_joints, write_pose
from layfigure.poses.symmetry import mirrored_joints
from layfigure.session.commands.arguments import limbs, packed_pose
from layfigure.session.describing import listed_limbs, spoken_limb
from layfigure.session.words import WordError, join_line, no_more
from layfigure.techniques.contract import PoseSet

if TYPE_CHECKING:
    from layfigure.session.session import Session


class Joints(NamedTuple):
    """Some joints of a pose: only ``limbs`` of it are meant."""

    pose: Pose
    limbs: tuple[int, ...]


def _copy(session: Session, words: tuple[str, ...]) -> None:
    no_more(words, 0)
    document = session.document
    movable = [limb for limb in session.view.selected if limb in document.figure.selectable]
    chosen = tuple(sorted(movable)) or document.figure.movable
    session.clipboard = session.clipboard_out = write_pose(document.figure, document.pose, limbs=chosen)
    session.say(f"Copied {listed_limbs(document.figure, chosen)}; paste puts it back, or on the other side.")


def _paste(session: Session, words: tuple[str, ...]) -> None:
    no_more(words, 0)
    copied = _copied(session)
    _put(session, _onto_selected(session, copied))


def _paste_mirrored(session: Session, words: tuple[str, ...]) -> None:
    no_more(words, 0)
    copied = _copied(session)
    _put(session, Joints(*mirrored_joints(session.document.figure, copied.pose, copied.limbs)))


def _copied(session: Session) -> Joints:
    """Return the joints on the clipboard: the system's where it holds a pose, else what was copied here."""
    text = session.clipboard_in() if session.clipboard_in is not None else ""
    if not text.lstrip().lower().startswith("layfigure pose"):
        text = session.clipboard
    if not text:
        raise ImpossibleError("no limbs are on the clipboard; select some and copy them first")
    if len(text) > MAXIMUM_POSE_BYTES:
        raise ImpossibleError("the text on the clipboard is too long to be a pose")
    figure = session.document.figure
    _, pose, named = read_joints(text, "clipboard", lambda reference: _same(figure, reference))
    if not named:
        raise ImpossibleError("the pose on the clipboard names no joints")
    return Joints(pose, named)


def _same(figure: Figure, reference: str) -> Figure:
    """Return the figure if it is what a pose calls so; a path counts by its file, wherever the text came from."""
    name = figure.path.name if figure.path is not None else figure.name
    if Path(reference).name.casefold() != name.casefold():
        raise LayfigureError(f"these are joints of the figure {reference[:60]}, and {name} is posed here")
    return figure


def _onto_selected(session: Session, copied: Joints) -> Joints:
    """A single limb goes onto the selected ones, if all of them can move as it can."""
    figure, chosen = session.document.figure, session.view.selected
    if len(copied.limbs) > 1 or not chosen or copied.limbs == (0,):
        return copied
    (source,) = copied.limbs
    kinds = [{dof.kind for dof in limb.dofs} for limb in figure.limbs]
    if 0 in chosen or any(kinds[limb] != kinds[source] for limb in chosen):
        return copied
    pose = Pose.rest(figure)
    for limb in chosen:
        pose = pose.with_joint(limb, *copied.pose.angles[source].tolist())
    return Joints(pose, tuple(sorted(chosen)))


def _put(session: Session, joints: Joints) -> None:
    """Run the logged command that sets joints, leaving locked ones as they are."""
    figure = session.document.figure
    locked = locked_joints(session.document.locks)
    free = tuple(limb for limb in joints.limbs if limb not in locked)
    if not free:
        raise ImpossibleError(f"{listed_limbs(figure, joints.limbs)}: locked; unlock the joint to paste onto it")
    token = pack_pose(figure, Pose.rest(figure).with_joints_of(joints.pose, free))
    session.execute(join_line("joints", [token, *(figure.names[limb] for limb in free)]))
    note = "; locked joints stay as they are" if len(free) < len(joints.limbs) else ""
    session.say(f"Pasted onto {listed_limbs(figure, free)}{note}.")


def _joints(session: Session, words: tuple[str, ...]) -> None:
    figure, source = session.document.figure, packed_pose(session, words, 0)
    chosen = limbs(session, words, 1)
    for index, limb in enumerate(chosen, start=2):
        if limb not in figure.selectable:
            raise WordError(index, f"the {spoken_limb(figure, limb)} cannot move")
    moved = session.document.pose.with_joints_of(source, chosen)
    session.set_pose(f"set {listed_limbs(figure, chosen)}", PoseSet(moved, limbs=chosen))


COMMANDS = (
    Command("copy-limbs", "Copy the selected limbs, or all, to the clipboard", _copy),
    Command("paste", "Paste the copied limbs", _paste),
    Command("paste-mirrored", "Paste the copied limbs on the other side, mirrored", _paste_mirrored),
    Command("joints", "Set several joints from a packed pose", _joints, "PACKED LIMB…", logged=True),
)
