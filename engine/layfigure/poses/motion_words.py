"""What a change of a joint's angle looks like, in words, for any figure.

The words come from where the angle takes the limb: a flexion moves its tip along the first axis of its joint space, a
pivot along the third (posing.md 1). At rest these axes lie along the world's, and the figure faces -Z, its right being
-X; so "forward" is the figure's own, as it would stand. A limb that has a twin goes outward or inward.

- A hinge (flexion only) bends more, or straightens.
- A limb that hangs across its parent (an arm from the shoulders, a thigh from the hips) is raised, or lowered.
- An upright limb, or one in line with its parent, bends to a side, or straightens.
- A level limb (a foot, a muzzle) tilts up or down and turns to a side.
- A twist turns an upright or hanging limb as its front goes, and rolls a level one as its top goes.

A joint that turns about x, y and z is said to do so, with a sign: where that takes the limb depends on the order.

The root has no parent to move against; its angles are named as they are.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from layfigure.figures.definition import EULER_KINDS
from layfigure.figures.figure import Figure, Limb
from layfigure.files.decimals import plain

Floats = NDArray[np.float64]
_UP, _FRONT = np.array([0.0, 1.0, 0.0]), np.array([0.0, 0.0, -1.0])


def moved_words(figure: Figure, limb: int, kind: str, change: tuple[float, float]) -> str:
    """Return in words what ``change`` does to a limb: (the angle before, the way to the angle after), in degrees."""
    joint, (start, way) = figure.limbs[limb], change
    if limb == 0:
        return f"{kind} {way:+.6g}"
    size = degrees(abs(way))
    if kind in EULER_KINDS:
        return f"turned {'-' if way <= -0.05 else ''}{size} about {kind}"
    if kind == "twist":
        return _twisted(figure, joint, way, size)
    where = _side(figure, joint, _axis(joint, kind) * np.sign(way))
    return _swung(figure, joint, (where, size), _course(start, start + way))


def degrees(number: float) -> str:
    """Return an amount of degrees as people say it."""
    return f"{amount(number)} degree{'' if amount(number) == '1' else 's'}"


def amount(number: float) -> str:
    """Return a positive number with at most one decimal, and never as nothing."""
    return plain(number, 1) if number >= 0.05 else "less than 0.1"


def _swung(figure: Figure, joint: Limb, words: tuple[str, str], course: str) -> str:
    where, size = words
    if len(joint.dofs) == 1 and course != "across":
        return f"bent {size} more" if course == "away" else f"straightened {size}"
    main = _main(joint)
    if main[1] == 0.0:
        return f"tilted {size} {where}" if where in ("up", "down") else f"turned {size} {_to(where)}"
    if main[1] < 0.0 and not _in_line(figure, joint):
        return {
            "away": f"raised {size} {_raised_to(where)}",
            "back": f"lowered {size}",
            "across": f"swung {size} {_raised_to(where)}",
        }[course]
    return f"straightened {size}" if course == "back" else f"bent {size} {_to(where)}"


def _twisted(figure: Figure, joint: Limb, way: float, size: str) -> str:
    """A positive twist is the right-handed turn about +Y in joint space: it takes z to x (posing.md 1)."""
    frame = np.array(joint.frame, dtype=np.float64)
    level = _main(joint)[1] == 0.0
    seen = frame.T @ (_UP if level else _FRONT)
    goes = frame @ np.cross([0.0, 1.0, 0.0], seen) * np.sign(way)
    return f"{'rolled' if level else 'turned'} {size} {_to(_side(figure, joint, goes))}"


def _course(start: float, end: float) -> str:
    """Say whether an angle goes away from rest, back towards it, or across it to the other side."""
    if start * end < 0.0:
        return "across"
    return "away" if abs(end) > abs(start) else "back"


def _main(joint: Limb) -> Floats:
    """Return the limb's main axis at rest."""
    return np.array(joint.frame, dtype=np.float64)[:, 1]


def _axis(joint: Limb, kind: str) -> Floats:
    """Return where a positive flexion or pivot moves the tip of the limb at rest."""
    return np.array(joint.frame, dtype=np.float64)[:, 0 if kind == "flexion" else 2]


def _in_line(figure: Figure, joint: Limb) -> bool:
    return bool((_main(joint) == _main(figure.limbs[joint.parent])).all())


def _side(figure: Figure, joint: Limb, direction: Floats) -> str:
    """Return the word for a direction along one of the world's axes."""
    axis = int(np.abs(direction).argmax())
    positive = bool(direction[axis] > 0)
    if axis != 0:
        return ("down", "up", "forward", "back")[2 * (axis == 2) + positive]
    if joint.twin == joint.index:
        return "left" if positive else "right"
    other = figure.limbs[joint.twin]
    outward = _resting_x(figure, joint) > _resting_x(figure, other)
    return "outward" if positive == outward else "inward"


def _resting_x(figure: Figure, joint: Limb) -> float:
    """Return where the limb's joint stands at rest, to the figure's left."""
    x = 0.0
    while joint.parent >= 0:
        x, joint = x + joint.position[0], figure.limbs[joint.parent]
    return x


def _to(where: str) -> str:
    return f"to the {where}" if where in ("left", "right") else where


def _raised_to(where: str) -> str:
    words = {"forward": "to the front", "back": "to the back", "outward": "to the side"}
    return words.get(where, _to(where))
