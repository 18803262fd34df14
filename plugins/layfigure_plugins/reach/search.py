"""The search for a pose: passes along one chain after the other, under frame correlation (posing.md 8)."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

from layfigure.poses.freedom import MAXIMUM_DISTANCE
from layfigure.poses.pose import Pose
from layfigure.techniques.solving import PositionTask, Problem
from layfigure_plugins.reach.chain import Chain, Skeleton, Stance
from layfigure_plugins.reach.passes import PASSES
from layfigure_plugins.reach.vectors import Vector, add, length, scale, subtract

FAR = 1e6
"""A goal farther away than this many lengths of its chain is as good as a direction."""

LEAST = 0.01
"""The share of the tolerance by which a pass has to come nearer to be worth having: rest is rest."""

SLOW = 0.1
"""Where passes close less than this share of the gap the chain has done what it can, and the root is carried."""

GOOD = 0.3
"""A pass that closes this share of the gap is taken at once; else the other kind is tried too, and the better kept."""

LARGEST_TURN = 20.0
"""No joint turns farther in one step of a drag, in degrees."""

Pass = Callable[[Chain, Stance, Vector], Stance]
Pulls = list[tuple[PositionTask, Chain]]


class Place(NamedTuple):
    """Where the search stands: the joints, the root's place, each task's distance from its goal, and their sum.

    ``gap`` is that sum by weight; goals that are very far away count in it as :func:`_goal` brings them near.
    """

    stance: Stance
    root: Vector
    errors: tuple[float, ...]
    gap: float


class Search:
    """A problem on a pose, made ready: chains, joints and their limits. Nothing in it changes."""

    def __init__(self, skeleton: Skeleton, pose: Pose, problem: Problem, tasks: tuple[PositionTask, ...]) -> None:
        self.problem = problem
        chained = frozenset(limb for task in tasks for limb in skeleton.ancestors(task.limb))
        self._joints, stance = skeleton.joints(pose, problem.movable & chained)
        self._pairs = [(task, skeleton.chain(pose, task.limb, self._joints)) for task in tasks]
        # Musts come last in a round, so that rubber bands yield to them.
        self._pulls = sorted((pair for pair in self._pairs if pair[0].weight > 0.0), key=lambda pair: pair[0].weight)
        self._musts = [pair for pair in self._pulls if pair[0].weight >= 1.0]
        x, y, z = pose.translation.tolist()
        self.start = self._place(stance, (x, y, z))
        reach = max((chain.reach for _, chain in self._pulls), default=0.0)
        self._least = max(problem.tolerance * LEAST, reach * 1e-6)

    def met(self, place: Place) -> bool:
        """Whether every must is met."""
        errors = zip(self._pairs, place.errors, strict=True)
        return all(error <= self.problem.tolerance for (task, _), error in errors if task.weight >= 1.0)

    def at_rest(self, place: Place) -> bool:
        """Whether nothing pulls any more."""
        errors = zip(self._pairs, place.errors, strict=True)
        return all(error <= self.problem.tolerance for (task, _), error in errors if task.weight > 0.0)

    def no_farther(self, place: Place, other: Place) -> bool:
        """Whether ``place`` is as near to the goals as ``other``, however far away they are."""
        pairs = zip(self._pairs, place.errors, other.errors, strict=True)
        pulls = [(task.weight * here, task.weight * there) for (task, _), here, there in pairs if task.weight > 0.0]
        return place.gap <= other.gap and sum(here for here, _ in pulls) <= sum(there for _, there in pulls)

    def descend(self, place: Place, rounds: int) -> Place:
        """Return where rounds lead that each come nearer: at the goals, or where none does."""
        for _ in range(rounds):
            if self.at_rest(place):
                break
            nearer = self.round(place)
            if nearer is place:
                break
            place = nearer
        return place

    def round(self, place: Place, largest: float = math.inf) -> Place:
        """Return the place after one pass along every chain, or ``place`` itself if none came nearer.

        Frame correlation: a configuration that is no closer than the last is discarded, so limbs do not jump. Joints
        turn by ``largest`` degrees at most.
        """
        nearer = self._nearer(place, self._pulls, largest)
        if nearer is place and len(self._musts) < len(self._pulls):
            nearer = self._nearer(place, self._musts, largest)
        if self.problem.root_moves and nearer.gap > place.gap * (1.0 - SLOW):
            return self._carried(nearer, largest)
        return nearer

    def _nearer(self, place: Place, pulls: Pulls, largest: float) -> Place:
        """Return the nearest place that a pass along the chains of ``pulls`` leads to, or ``place`` itself."""
        best = place
        for one_pass in PASSES:
            stance = self._limited(place.stance, self._passed(one_pass, place, pulls), largest)
            found = self._place(stance, place.root)
            if found.gap < best.gap - self._least:
                best = found
            if best.gap < place.gap * (1.0 - GOOD):
                break
        return best

    def from_the_middle(self, share: float) -> Place:
        """Return another place to start from: every joint of a chain a share of the way to its limits' middle."""
        stance = dict(self.start.stance)
        for _, chain in self._pulls:
            for link in chain.links:
                stance[link.limb] = link.joint.toward_middle(self.start.stance[link.limb], share)
        return self._place(stance, self.start.root)

    def committed(self, place: Place) -> Place:
        """Return a place as a pose will hold it: rounded, inside limits, untouched where nothing turned."""
        before = self.start.stance
        stance = {
            limb: at if at == before[limb] else self._joints[limb].commit(at, before[limb])
            for limb, at in place.stance.items()
        }
        return self._place(stance, place.root)

    def _place(self, stance: Stance, root: Vector) -> Place:
        gap, errors = 0.0, []
        for task, chain in self._pairs:
            tip = chain.tip(stance)
            errors.append(math.dist(add(root, tip), task.position))
            if task.weight > 0.0:
                gap += task.weight * length(subtract(_goal(task, chain, root), tip))
        return Place(stance, root, tuple(errors), gap)

    def _passed(self, one_pass: Pass, place: Place, pulls: Pulls) -> Stance:
        stance = place.stance
        for task, chain in pulls:
            goal = _goal(task, chain, place.root)
            if chain.reach > 0.0 and length(subtract(goal, chain.tip(stance))) > self.problem.tolerance:
                stance = one_pass(chain, stance, goal)
        return stance

    def _limited(self, before: Stance, after: Stance, largest: float) -> Stance:
        changes = (self._joints[limb].change(before[limb], after[limb]) for limb in after)
        most = max((abs(angle) for change in changes for angle in change), default=0.0)
        if most <= largest:
            return after
        return {limb: self._joints[limb].between(before[limb], after[limb], largest / most) for limb in after}

    def _carried(self, place: Place, largest: float) -> Place:
        """Return the place with the root carried by what the chains could not reach, if that is nearer."""
        total = sum(task.weight for task, _ in self._pulls)
        rest = (0.0, 0.0, 0.0)
        for task, chain in self._pulls:
            missing = subtract(_goal(task, chain, place.root), chain.tip(place.stance))
            rest = add(rest, scale(missing, task.weight / total))
        moved = self._place(place.stance, self._bounded(add(place.root, rest)))
        if len(self._pulls) > 1:  # the others follow before it is judged whether that was any good
            after = self._passed(PASSES[0], moved, self._pulls)
            moved = self._place(self._limited(place.stance, after, largest), moved.root)
        return moved if moved.gap < place.gap - self._least else place

    def _bounded(self, root: Vector) -> Vector:
        """Return a place for the root, rounded, and no farther out than files can hold or than it was."""
        out = [max(MAXIMUM_DISTANCE, abs(at)) for at in self.start.root]
        x, y, z = (round(min(max(value, -most), most), 6) for value, most in zip(root, out, strict=True))
        return (x, y, z)


def _goal(task: PositionTask, chain: Chain, root: Vector) -> Vector:
    """Return the goal relative to the root's place; one that is very far away is brought near along its direction."""
    # Halved, because the difference of two huge numbers may not be a number.
    half = subtract(scale(task.position, 0.5), scale(add(root, chain.origin), 0.5))
    size = max(abs(value) for value in half)
    most = FAR * max(chain.reach, 1.0)
    if size > most:
        return add(chain.origin, scale(scale(half, 1.0 / size), 2.0 * most))
    return subtract(task.position, root)
