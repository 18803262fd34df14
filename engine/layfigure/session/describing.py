"""Says in words what is selected."""

from __future__ import annotations

from collections.abc import Sequence

from layfigure.figures.definition import DOF_KINDS
from layfigure.figures.figure import Figure, Limb
from layfigure.figures.spoken import spoken_limb
from layfigure.poses.locks import kind_of
from layfigure.session.document import Document

__all__ = ["describe_limbs", "describe_locks", "freedom", "listed_limbs", "spoken_limb"]

_FREEDOM = {
    0: "cannot move",
    1: "flexion only",
    3: "flexion and pivot",
    7: "flexion, pivot and twist",
}


def describe_limbs(document: Document, selected: tuple[int, ...]) -> tuple[str, ...]:
    """Return one line for the name and one or two for how a limb stands; a hint where nothing is selected."""
    figure = document.figure
    if not selected:
        kept = len(figure.movable) - len(document.enabled & frozenset(figure.movable))
        state = "every limb may change" if not kept else f"{kept} of {len(figure.movable)} limbs are kept as they are"
        return ("No limb selected", f"{state}{_both_sides(document)}", *describe_locks(document))
    if len(selected) > 1:
        named = ", ".join(spoken_limb(figure, limb) for limb in selected[:4])
        return (f"{len(selected)} limbs selected", f"{named}{_both_sides(document)}")
    limb = figure.limbs[selected[0]]
    kept_note = "" if limb.index in document.enabled or limb.index == 0 else " (kept)"
    angles = document.pose.angles[limb.index]
    stands = "  ".join(f"{kind} {angles[i]:.4g}°" for i, kind in enumerate(limb.kinds) if limb.turns(kind))
    heading = f"{spoken_limb(figure, limb.index)}{kept_note}: {freedom(limb)}"
    return (heading, f"{stands}{_both_sides(document)}", *describe_locks(document))


def _both_sides(document: Document) -> str:
    return "; both sides move alike" if document.symmetric else ""


_LOCKED = {
    "place": "pinned",
    "orientation": "turn pinned",
    "band": "on a band",
    "hold": "held",
    "joint": "joint locked",
}


_MOST_SPOKEN = 2


def describe_locks(document: Document) -> tuple[str, ...]:
    """Return a line that says what is locked, or nothing; of many locks it names the limbs only, so that all fit."""
    if not document.locks:
        return ()
    named = [(spoken_limb(document.figure, lock.limb), _LOCKED[kind_of(lock)]) for lock in document.locks]
    if len(named) > _MOST_SPOKEN:
        return (f"{len(named)} locks: {', '.join(dict.fromkeys(limb for limb, _ in named))}",)
    return (f"Locked: {', '.join(' '.join(words) for words in named)}",)


def listed_limbs(figure: Figure, limbs: Sequence[int]) -> str:
    """Return the names of up to three limbs as people say them, else their number."""
    names = [spoken_limb(figure, limb) for limb in limbs]
    return ", ".join(names) if len(names) <= 3 else f"{len(names)} limbs"


def freedom(limb: Limb) -> str:
    """Return in words how a limb can move, what its colour says in pictures; the root always carries the figure."""
    if limb.parent < 0:
        return "turns and carries the figure"
    if limb.euler:
        about = [kind for kind in limb.kinds if limb.dof(kind)]
        return f"turns about {' and '.join([', '.join(about[:-1]), about[-1]] if len(about) > 1 else about)}"
    bits = sum(1 << i for i, kind in enumerate(DOF_KINDS) if limb.dof(kind))
    kinds = [kind for kind in DOF_KINDS if limb.dof(kind)]
    return _FREEDOM.get(bits, " and ".join(kinds) + (" only" if len(kinds) == 1 else ""))


def allowed_angles(limb: Limb) -> str:
    """Return in words between which angles each degree of freedom of a limb lies, or nothing for one without."""
    dofs = [dof for kind in limb.kinds if (dof := limb.dof(kind))]
    spoken = ", ".join(f"{dof.kind} {dof.low:g} to {dof.high:g}" for dof in dofs)
    return f"Degrees; the joint allows {spoken}." if spoken else ""
