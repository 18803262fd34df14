"""The technique: an end gets a goal, a solver turns its chain, locks are kept, the rest stays where it is."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from layfigure.drawing.marks import Mark
from layfigure.errors import ImpossibleError
from layfigure.figures.figure import Figure
from layfigure.kinematics.forward import limb_begins, limb_ends, place_pose
from layfigure.kinematics.measures import body_height
from layfigure.poses.locks import Lock, Pin, broken, tips_of
from layfigure.poses.packing import pack_pose, unpack_pose
from layfigure.poses.pose import Pose
from layfigure.techniques.contract import (
    Bench,
    Control,
    EnabledSet,
    Event,
    Goal,
    LocksSet,
    Offer,
    PoseSet,
    Setting,
)
from layfigure.techniques.keeping import careful_problem, tasks_of
from layfigure.techniques.plain_data import limb_names, limbs_named, lock_lists, locks_listed, reading
from layfigure.techniques.solving import DirectionTask, PositionTask, Problem, Solution, Task, chain_of, vector
from layfigure_plugins.inverse.chains import Following, following

VERSION = 1
LONGEST = 12
SOLVERS = ("ik.dls", "ik.reach")
YIELDING = 0.9
"""The weight of a goal beside locks: where both cannot be had, the locks are kept."""

PRECISION = 0.0005
"""How near to its goal an end comes, as a share of the figure's height."""

STRIDE = 0.02
"""The longest step of a drag, as a share of the figure's height: a pointer that jumps is followed in several."""

BESIDE_LOCKS = 0.004
"""The same beside locks: less than what locks allow."""

MOST_STRIDES, PATIENCE, PROGRESS = 60, 2, 0.02
"""How many strides one movement of the pointer may take, how many in vain, and what share of one is not in vain."""

MENDED = 0.5
"""The share of what locks allow that a drag may use up before they are met again."""

FARTHEST = 1e5
"""How far from the origin a goal may be on each axis, in figure units; poses farther off could not be stored."""


@dataclass(frozen=True)
class InverseState:
    """The pose, the switches, and of a drag that is going on the end, its goal and the solver's memory."""

    pose: Pose
    enabled: frozenset[int]
    locks: tuple[Lock, ...] = ()
    chain: int = 3
    solver: str = SOLVERS[0]
    aim: bool = False
    limb: int = -1
    goal: tuple[float, float, float] | None = None
    memory: tuple[float, ...] = ()
    note: str = ""


@dataclass(frozen=True)
class Inverse:
    """Inverse kinematics on one figure."""

    bench: Bench = field(repr=False)

    @staticmethod
    def on(bench: Bench) -> Inverse:
        """Return the technique for the bench's figure."""
        return Inverse(bench)

    @property
    def figure(self) -> Figure:
        """The figure being posed."""
        return self.bench.figure

    def start(self, setting: Setting) -> InverseState:
        """Return the state to begin with; the option ``solver`` chooses one by id."""
        solver = str(self.bench.option("solver", SOLVERS[0]))
        return InverseState(setting.pose, setting.enabled, setting.locks, solver=_known(solver))

    def ask(self, state: InverseState) -> Offer:
        """Return the values of the controls, and marks on the chain that moved last."""
        reach = "up to the root" if state.chain == 0 else f"the last {state.chain} limbs"
        return Offer(
            title=f"Dragging an end moves {reach}",
            note=state.note,
            values={"chain": float(state.chain), "solver": state.solver, "aim": state.aim},
            marks=lambda: self._marks(state),
        )

    def tell(self, state: InverseState, event: Event) -> InverseState:
        """Return the state after an event.

        Raises:
            ImpossibleError: the end cannot be moved, the locks would break, or the event is not for this technique.
        """
        match event:
            case Goal():
                return self._moved(state, event)
            case Control(name, value):
                return _controlled(replace(state, note=""), name, value)
            case PoseSet():
                return self._taken_over(state, event)
            case EnabledSet(enabled):
                return replace(state, enabled=enabled)
            case LocksSet(locks):
                return replace(state, locks=locks)
            case _:
                raise ImpossibleError(f"inverse kinematics has no use for {event}"[:160])

    def recommend(self, state: InverseState) -> Pose:
        """Return the pose."""
        return state.pose

    def dump(self, state: InverseState) -> dict[str, Any]:
        """Return the state as JSON-ready plain data; a drag that is going on is left out."""
        return {
            "version": VERSION,
            "pose": pack_pose(self.figure, state.pose),
            "enabled": limb_names(self.figure, state.enabled),
            "locks": lock_lists(self.figure, state.locks),
            "chain": state.chain,
            "solver": state.solver,
            "aim": state.aim,
        }

    def load(self, data: Mapping[str, Any]) -> InverseState:
        """Return the state that :meth:`dump` described.

        Raises:
            LayfigureError: another version, another figure, or damaged data.
        """
        with reading("inverse kinematics", data, VERSION):
            return InverseState(
                unpack_pose(self.figure, data["pose"]),
                limbs_named(self.figure, data["enabled"]),
                locks_listed(self.figure, data["locks"]),
                _chain(data["chain"]),
                _known(data["solver"]),
                bool(data["aim"]),
            )

    def _moved(self, state: InverseState, goal: Goal) -> InverseState:
        self._check(state, goal)
        follow = following(self.figure, goal.limb, state.chain, state.enabled, state.locks)
        if goal.limb and not follow.movable:
            name = self.figure.names[goal.limb]
            raise ImpossibleError(f"nothing that the {name} hangs on may move; enable or unlock a limb of its chain")
        solution = self._dragged(state, goal, follow) if goal.dragging else self._solved(state, goal, follow)
        if broken(self.figure, solution.pose, follow.locks):
            raise ImpossibleError("the locks do not allow that; release one, or lengthen the chain")
        missed = solution.errors[0]
        note = f"out of reach by {missed:.1f} units" if missed > 10 * PRECISION * body_height(self.figure) else ""
        return replace(
            state,
            pose=solution.pose,
            limb=goal.limb,
            goal=goal.position if note else None,
            memory=solution.memory if goal.dragging else (),
            note=note,
        )

    def _taken_over(self, state: InverseState, event: PoseSet) -> InverseState:
        """Go on with another pose; a drag goes on too where its own chain was left alone, as when twins follow it."""
        moved = replace(state, pose=event.pose)
        if event.limbs is not None and state.limb >= 0:
            chain = sorted(chain_of(self.figure, state.limb, state.chain))
            if np.array_equal(event.pose.angles[chain], state.pose.angles[chain]):
                return moved
        return replace(moved, memory=(), note="", goal=None, limb=state.limb if event.limbs else -1)

    def _check(self, state: InverseState, goal: Goal) -> None:
        near = np.abs(goal.position).max() <= FARTHEST  # not so for what is no number
        if not 0 <= goal.limb < len(self.figure.limbs) or not near:
            raise ImpossibleError(f"a goal needs a limb of the figure and a place within {FARTHEST:.0f} units")
        if any(isinstance(lock, Pin) and lock.limb == goal.limb for lock in state.locks):
            raise ImpossibleError(f"the {self.figure.names[goal.limb]} is pinned in its place; release it first")

    def _solved(self, state: InverseState, goal: Goal, follow: Following) -> Solution:
        """Meet the goal with all locks if that can be done, else come as near to it as they let."""
        solver = self.bench.solver(state.solver)
        solution = solver.solve(state.pose, self._problem(state, goal, follow, 1.0))
        if solution.met or not follow.locks:
            return solution
        return solver.solve(state.pose, self._problem(state, goal, follow, YIELDING))

    def _dragged(self, state: InverseState, goal: Goal, follow: Following) -> Solution:
        """Follow the pointer in strides, so that neither its jumps nor its going out of reach are jumps of the limbs.

        Beside locks a stride is so short that the compromise between goal and locks stays within what locks allow;
        where the end comes no nearer any more, it has come as near as it can.
        """
        solver, height = self.bench.solver(state.solver), body_height(self.figure)
        stride = (BESIDE_LOCKS if follow.locks else STRIDE) * height
        wanted = np.array(goal.position)
        tip = self._tip(state.pose, goal.limb)
        left = float(np.linalg.norm(wanted - tip))
        whole = self._problem(state, goal, follow, 1.0)
        solution, stuck = Solution(state.pose, (left,), met=False, memory=state.memory), 0
        for _ in range(MOST_STRIDES):
            if left <= PRECISION * height or stuck > PATIENCE:
                break
            near = PositionTask(goal.limb, vector(tip + (wanted - tip) * min(1.0, stride / left)))
            stepped = solver.step(solution.pose, replace(whole, tasks=(near, *whole.tasks[1:])), solution.memory)
            pose = self._mended(state, stepped.pose, follow)
            tip = self._tip(pose, goal.limb)
            before, left = left, float(np.linalg.norm(wanted - tip))
            stuck = stuck + 1 if left > before - PROGRESS * stride else 0
            solution = replace(stepped, pose=pose, errors=(left,))
        return solution

    def _mended(self, state: InverseState, pose: Pose, follow: Following) -> Pose:
        """Return the pose with its locks met again where the last stride has used up half of what they allow."""
        if not broken(self.figure, pose, follow.locks, MENDED):
            return pose
        return self.bench.solver(state.solver).solve(pose, self._problem(state, None, follow, 1.0)).pose

    def _problem(self, state: InverseState, goal: Goal | None, follow: Following, weight: float) -> Problem:
        tasks: tuple[Task, ...] = (PositionTask(goal.limb, goal.position, weight),) if goal else ()
        if goal and state.aim and self.figure.limbs[goal.limb].length:
            tasks += (DirectionTask(goal.limb, self._direction(state.pose, goal.limb), YIELDING / 2),)
        tasks = (*tasks, *tasks_of(follow.locks))
        problem = careful_problem(self.figure, tasks, follow.movable, root_moves=follow.root_moves)
        return problem if follow.locks else replace(problem, tolerance=PRECISION * body_height(self.figure))

    def _tip(self, pose: Pose, limb: int) -> NDArray[np.float64]:
        return np.asarray(tips_of(self.figure, place_pose(self.figure, pose))[limb])

    def _direction(self, pose: Pose, limb: int) -> tuple[float, float, float]:
        placement = place_pose(self.figure, pose)
        along = limb_ends(self.figure, placement)[limb] - limb_begins(self.figure, placement)[limb]
        return vector(along / np.linalg.norm(along))

    def _marks(self, state: InverseState) -> Iterator[Mark]:
        """Yield the chain that moved last as a line through its joints, and a goal that could not be reached."""
        if state.limb < 0:
            return
        placement = place_pose(self.figure, state.pose)
        joints = sorted(chain_of(self.figure, state.limb, state.chain))
        points = [*placement.origins[joints], tips_of(self.figure, placement)[state.limb]]
        yield Mark("chain", tuple(map(vector, points)))
        if state.goal is not None:
            yield Mark("goal", (state.goal,))
            yield Mark("goal", (vector(points[-1]), state.goal))


def _controlled(state: InverseState, name: str, value: object) -> InverseState:
    match name, value:
        case "chain", int() | float():
            return replace(state, chain=_chain(value))
        case "solver", str():
            return replace(state, solver=_known(value), memory=())
        case "aim", bool():
            return replace(state, aim=value)
        case _:
            raise ImpossibleError(f'inverse kinematics has no control "{name}" that can be {value!r}')


def _chain(value: Any) -> int:
    if isinstance(value, bool) or not 0 <= value <= LONGEST or value != int(value):
        raise ImpossibleError(f"a chain has 0 to {LONGEST} limbs, {value} is not in it")
    return int(value)


def _known(solver: str) -> str:
    if solver not in SOLVERS:
        raise ImpossibleError(f"inverse kinematics works with {' or '.join(SOLVERS)}, not {solver!r}")
    return solver
