"""Says a pose in words: the whole body first, then trunk, head, arms and legs; joint by joint where it is no body."""

from __future__ import annotations

from collections.abc import Iterator

from layfigure.figures.definition import EULER_KINDS
from layfigure.figures.figure import Figure
from layfigure.figures.spoken import both_limbs, spoken_limb
from layfigure.poses.freedom import existing_angles
from layfigure.poses.motion_words import moved_words
from layfigure.poses.pose import Pose
from layfigure.wording import members
from layfigure.wording.anatomy import Anatomy, anatomy
from layfigure.wording.body import Body, fives
from layfigure.wording.stance import stance
from layfigure.wording.statement import Statement, told

AT_REST = Statement("", ("everything at rest",))


def describe_pose(figure: Figure, pose: Pose) -> tuple[Statement, ...]:
    """Return what there is to say of a pose, most important first; left and right are the figure's own.

    Amounts are rounded to 5 degrees, and what is less than 10 degrees from rest is left out, so that the words of a
    pose and of its mirror image differ in left and right only.
    """
    parts = anatomy(figure)
    if parts is None:
        return tuple(_joints(figure, pose)) or (AT_REST,)
    return (*_body(Body.of(figure, parts, pose)), *_beyond(figure, parts, pose))


def sentences(statements: tuple[Statement, ...]) -> tuple[str, ...]:
    """Return statements as sentences."""
    return tuple(statement.sentence for statement in statements)


def _body(body: Body) -> list[Statement]:
    return [
        *stance(body),
        *members.trunk(body),
        *members.head(body),
        *members.arms(body),
        *members.legs(body),
    ]


def _beyond(figure: Figure, parts: Anatomy, pose: Pose) -> list[Statement]:
    """Say the joints that a human body has none of: wings, a tail, fingers."""
    sides = {limb for side in parts.sides for limb in vars(side).values() if isinstance(limb, int)}
    trunk = {limb for end in (*sides, parts.head) for limb in _upward(figure, end)}
    return _joints(figure, pose, leaving_out=frozenset(sides | trunk | {0, parts.spine}))


def _upward(figure: Figure, limb: int) -> Iterator[int]:
    """Yield a limb and all above it, the root left out."""
    while limb > 0:
        yield limb
        limb = figure.limbs[limb].parent


def _joints(figure: Figure, pose: Pose, leaving_out: frozenset[int] = frozenset()) -> list[Statement]:
    """Say what every joint does, beginning from rest; twins that do the same are said at once."""
    said = {limb: _joint(figure, pose, limb) for limb in range(len(figure.limbs)) if limb not in leaving_out}
    found: list[Statement] = []
    for limb, clauses in said.items():
        twin = figure.limbs[limb].twin
        alike = twin != limb and said.get(twin) == clauses
        if not (alike and twin < limb):
            found += told(both_limbs(figure, limb) if alike else spoken_limb(figure, limb), *clauses)
    return found


def _joint(figure: Figure, pose: Pose, limb: int) -> tuple[str, ...]:
    clauses = []
    has = existing_angles(figure)[limb]
    for column, kind in enumerate(figure.limbs[limb].kinds):
        angle = fives(float(pose.angles[limb, column]))
        if has[column] and angle:
            words, moved = f"{kind} {angle} degrees", moved_words(figure, limb, kind, (0.0, angle))
            clauses.append(words if limb == 0 else moved if kind in EULER_KINDS else f"{moved} ({words})")
    return tuple(clauses)
