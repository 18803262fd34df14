"""Where ends are, and how far and which way each could go: what goals are made of."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from layfigure.figures.figure import Figure
from layfigure.kinematics.forward import Placement, limb_begins, limb_ends, place_pose
from layfigure.kinematics.measures import body_height
from layfigure.poses.locks import tips_of
from layfigure.poses.pose import Pose
from layfigure.techniques.solving import chain_of
from layfigure_plugins.hybrid.directions import way_of
from layfigure_plugins.hybrid.ends import reach, stretches

Floats = NDArray[np.float64]

STRETCH = 0.96
"""The share of a chain's reach that goals stay within: fully stretched limbs look stiff."""

BODY_WAY = 0.5
"""How far the body is carried at intensity 100, as a share of the reach of the shortest chain that holds it."""


class Way(NamedTuple):
    """A way that proposals go, by its ``place`` among all ways: ``turn`` (3, 3) takes it to the world, x outward."""

    place: int
    turn: Floats
    longest: float

    def to(self, number: int, intensity: float) -> Floats:
        """Return how far (3,) proposal ``number`` goes at an intensity of 0..1."""
        way = way_of(number, self.place)
        return np.asarray(self.turn @ way[:3] * (way[3] * intensity * self.longest))


class Ball(NamedTuple):
    """A ball that a point has to stay in."""

    centre: Floats
    radius: float

    def hold(self, point: Floats, carried: Floats | float = 0.0) -> Floats:
        """Return the nearest point to ``point`` within the ball, the ball being carried along."""
        centre = self.centre + carried
        away = point - centre
        length = float(np.linalg.norm(away))
        return np.asarray(centre + away * (self.radius / length) if length > self.radius else point)


class End(NamedTuple):
    """An end that gets goals: where it is (3,), the ways it goes, what it can reach, and its direction (3,).

    The first way is the end's own; the others it shares with all ends that the same stretch of its chain moves.
    """

    limb: int
    tip: Floats
    ways: tuple[Way, ...]
    reach: Ball
    along: Floats

    def goal(self, number: int, intensity: float, carried: Floats) -> Floats:
        """Return the goal (3,) of a proposal, carried along with the body."""
        way = sum((each.to(number, intensity) for each in self.ways), carried)
        return self.reach.hold(self.tip + way, carried)

    def aim(self, number: int, intensity: float) -> Floats:
        """Return the present direction (3,), turned toward another way than the goal's."""
        own = self.ways[0]
        wanted = self.along + Way(own.place + 3, own.turn, 2.0).to(number, intensity)
        length = float(np.linalg.norm(wanted))
        return np.asarray(wanted / length if length > 1e-6 else self.along)


class Body(NamedTuple):
    """The root: where it is (3,), the way it is carried, and the balls round pinned ends that it has to stay in."""

    origin: Floats
    way: Way
    anchors: tuple[Ball, ...]

    def goal(self, number: int, intensity: float) -> Floats:
        """Return where a proposal carries the root (3,); chains that hold it are not torn."""
        goal = self.origin + self.way.to(number, intensity)
        for _ in range(3):
            for anchor in self.anchors:
                goal = anchor.hold(goal)
        return goal


def ends_at(figure: Figure, pose: Pose, limbs: tuple[int, ...]) -> tuple[End, ...]:
    """Return ends as they are in a pose, with a way for each and one for each stretch that moves several."""
    placement = place_pose(figure, pose)
    chains = [stretches(figure, limb, limbs) for limb in limbs]
    shared = sorted({stretch.ends for chain in chains for stretch in chain if len(stretch.ends) > 1})
    places: dict[tuple[int, ...], int] = {(limb,): place for place, limb in enumerate(limbs)}
    places |= {ends: len(limbs) + number for number, ends in enumerate(shared)}
    return tuple(
        _end(
            figure,
            placement,
            limb,
            tuple(
                Way(places[stretch.ends], _outward(figure, placement, stretch.ends), 2 * stretch.length)
                for stretch in chain
                if stretch.ends
            ),
        )
        for limb, chain in zip(limbs, chains, strict=True)
    )


def body_at(figure: Figure, pose: Pose, held: tuple[int, ...], place: int) -> Body:
    """Return the root as it is in a pose, with the way at ``place``; ``held`` are the ends pinned in the world."""
    placement = place_pose(figure, pose)
    tips, origin = tips_of(figure, placement), placement.origins[0]
    anchors = []
    for limb in held:
        base = min(chain_of(figure, limb, 0), default=limb)
        farthest = reach(figure, limb) + float(np.linalg.norm(placement.origins[base] - origin))
        anchors.append(Ball(tips[limb], max(STRETCH * farthest, float(np.linalg.norm(tips[limb] - origin)))))
    longest = min((reach(figure, limb) for limb in held), default=body_height(figure))
    return Body(origin, Way(place, _outward(figure, placement, ()), BODY_WAY * longest), tuple(anchors))


def _end(figure: Figure, placement: Placement, limb: int, ways: tuple[Way, ...]) -> End:
    tip = tips_of(figure, placement)[limb]
    base = placement.origins[min(chain_of(figure, limb, 0))]
    along = limb_ends(figure, placement)[limb] - limb_begins(figure, placement)[limb]
    length = float(np.linalg.norm(along))
    radius = max(STRETCH * reach(figure, limb), float(np.linalg.norm(tip - base)))
    return End(limb, tip, ways, Ball(base, radius), along / length if length else along)


def _outward(figure: Figure, placement: Placement, ends: tuple[int, ...]) -> Floats:
    """Return the matrix (3, 3) that takes ways to the world: x is outward on the ends' side of the body.

    What is in the middle goes to its right first, as the mirror image of a figure is read from its right too.
    """
    rest = tips_of(figure, place_pose(figure, Pose.rest(figure)))[list(ends)]
    side = 1.0 if rest[:, 0].sum() > 1e-6 else -1.0
    return np.asarray(placement.limb_to_world[0] @ np.diag([side, 1.0, 1.0]))
