"""The one entry point of the solver's machine code: load a pose, go a step, solve, commit."""

# mypy: disable-error-code="operator,arg-type,type-var,call-overload,no-any-return"
# (min and max of scalars mean something narrower to numba than to the type stubs)

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numba.types import float64, int64

from layfigure_plugins.dls.kernels import array, digest, jit
from layfigure_plugins.dls.kernels.descending import begin_drag, begin_solve, judge, turns_elsewhere
from layfigure_plugins.dls.kernels.layout import (
    BUILT,
    COMMIT,
    DEGREES,
    DRAG,
    FARTHEST,
    FLAGS,
    GOING,
    HORIZON,
    IN_XYZ,
    LOAD,
    OFFSET,
    POSITION,
    REACH,
    ROOT,
    ROOT_START,
    ROOT_STIFF,
    START,
    STATE,
    STRAIGHT,
    TURNS,
    UNIT,
    WORST,
    XYZ,
    Work,
)
from layfigure_plugins.dls.kernels.placing import bring_near, measure, place
from layfigure_plugins.dls.kernels.stepping import iterate
from layfigure_plugins.dls.kernels.xyz import commit_xyz, take_angles


@jit()
def _load(body: Any, knobs: Any, angles: Any) -> None:
    """Take every limb's state from a pose's angles in degrees, and place all limbs."""
    for j in range(body.shape[0]):
        if body[j, XYZ] > 0.0:
            take_angles(body, j, angles[j])
        else:
            _take_swing(body, j, angles[j])
        body[j, FLAGS] = 0.0
        for k in range(4):
            body[j, START + k] = body[j, STATE + k]
        place(body, knobs, j)
    for r in range(3):
        knobs[ROOT_START + r] = knobs[ROOT + r]


@jit()
def _take_swing(body: Any, j: int, angles: Any) -> None:
    """Take limb j's state from its flexion, pivot and twist (3,) in degrees."""
    turn = np.pi / 360.0
    f, p = angles[0] * body[j, TURNS], angles[1] * body[j, TURNS + 1]
    left, right = max(180.0 - abs(f + p), 0.0) * turn, max(180.0 - abs(f - p), 0.0) * turn
    body[j, STATE], body[j, STATE + 2] = math.sin(f * turn), math.sin(p * turn)
    body[j, STATE + 1] = math.sqrt(math.sin(left) * math.sin(right))
    body[j, STATE + 3] = angles[2] * body[j, TURNS + 2] * 2.0 * turn


@jit()
def _commit(links: Any, body: Any, angles: Any) -> None:
    """Write the joints' angles in whole millionths of a degree, inside limits and domain whatever was rounded."""
    for i in range(links.shape[0]):
        j, dofs = links[i, 0], links[i, 1]
        if dofs & IN_XYZ:
            commit_xyz(body, j, dofs, angles[j])
            continue
        x, w, z = body[j, STATE], body[j, STATE + 1], body[j, STATE + 2]
        flexion, pivot = 2.0 * math.atan2(x, math.hypot(w, z)) / UNIT, 2.0 * math.atan2(z, math.hypot(x, w)) / UNIT
        limits = body[j, DEGREES : DEGREES + 6]
        flexion = min(max(np.rint(flexion), limits[0]), limits[1])
        pivot = min(max(np.rint(pivot), limits[2]), limits[3])
        twin = limits[0] <= -flexion <= limits[1] and limits[2] <= -pivot <= limits[3]
        over = abs(flexion) + abs(pivot) - (STRAIGHT if twin or pivot > 0.0 else STRAIGHT - 1.0)
        if over > 0.0 and dofs & 3 == 3:
            less = pivot - math.copysign(over, pivot)
            if limits[2] <= less <= limits[3]:
                pivot = less
            else:
                flexion -= math.copysign(over, flexion)
        elif over > 0.0:
            flexion, pivot = (
                flexion - math.copysign(over * (flexion != 0.0), flexion),
                pivot - math.copysign(over * (pivot != 0.0), pivot),
            )
        if dofs & 1:
            angles[j, 0] = flexion / 1e6
        if dofs & 2:
            angles[j, 1] = pivot / 1e6
        if dofs & 4:
            angles[j, 2] = min(max(np.rint(body[j, STATE + 3] / UNIT), limits[4]), limits[5]) / 1e6


@jit()
def _take_goals(tasks: Any, goals: Any, knobs: Any, positions: Any) -> None:
    """Take new positions (k, 3) of the position tasks, if there are any, and bring near what is far away.

    A root that may be carried goes all the way.
    """
    k, still = 0, knobs[ROOT_STIFF] == 0.0
    for t in range(tasks.shape[0]):
        if tasks[t, 0] == POSITION and k < positions.shape[0]:
            for r in range(3):
                goals[t, r] = min(max(positions[k, r], -FARTHEST), FARTHEST)
            k += 1
        horizon = HORIZON * knobs[REACH] if still else 4.0 * FARTHEST
        if tasks[t, 0] == POSITION:
            bring_near(goals[t], (knobs[ROOT], knobs[ROOT + 1], knobs[ROOT + 2]), horizon)
        elif tasks[t, 0] == OFFSET:
            bring_near(goals[t], (0.0, 0.0, 0.0), horizon)


def _entry(sources: int) -> Any:
    """Return the kernel that Python calls.

    numba looks for changes in this file only, but its cache also tells apart what a function closes over: the digest
    of all kernels' sources makes a change in any of them compile anew.
    """

    @jit(
        float64(
            int64,
            *(array(int64, 2, readonly=True), array(int64, 2, readonly=True), array(int64, 2, readonly=True)),
            *(array(float64, 2), array(float64, 2), array(float64, 2), array(float64, 2), array(float64, 1)),
            *(array(float64, 2), array(float64, 2, readonly=True)),
        )
    )
    def run(
        mode: int,
        links: Any,
        pairs: Any,
        tasks: Any,
        goals: Any,
        body: Any,
        jacobian: Any,
        normal: Any,
        knobs: Any,
        angles: Any,
        positions: Any,
    ) -> float:
        knobs[BUILT] = sources
        _take_goals(tasks, goals, knobs, positions)
        work = Work(links, pairs, tasks, goals, body, jacobian, normal, knobs)
        if mode == LOAD:
            _load(body, knobs, angles)
        elif mode == COMMIT:
            _commit(links, body, angles)
        else:
            if mode == DRAG:
                begin_drag(work)
            else:
                begin_solve(work)
            ahead = True
            while ahead:
                while knobs[GOING] > 0.0:
                    judge(work, iterate(work))
                ahead = turns_elsewhere(work)
        if mode in (LOAD, COMMIT):
            measure(tasks, goals, body, normal, knobs)
        return knobs[WORST]

    return run


run = _entry(digest())
"""``run(mode, links, pairs, tasks, goals, body, jacobian, normal, knobs, angles, positions)``.

Loads ``angles`` (n, 3) in degrees, goes a step of a drag, solves from the loaded pose, or commits to ``angles``;
returns the worst error of the position tasks. ``positions`` (k, 3) are their new goals in order; none (0, 3) keeps the
old ones.
"""
