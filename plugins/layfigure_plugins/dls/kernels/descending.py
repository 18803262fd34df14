"""The way to an answer: how a solve goes down from several places, and a drag goes a step without ever jumping.

The loop stands in :mod:`layfigure_plugins.dls.kernels.moving`, so that the iteration is compiled into one place only;
what it does next is decided here, and remembered among the knobs.
"""

# mypy: disable-error-code="operator,arg-type,type-var,call-overload,no-any-return"
# (min and max of scalars mean something narrower to numba than to the type stubs)

from __future__ import annotations

import math
from typing import Any

from layfigure_plugins.dls.kernels import jit
from layfigure_plugins.dls.kernels.layout import (
    AGREED,
    AT_REST,
    BEST,
    BEST_LEFT,
    BEST_MET,
    DAMPING,
    DEGREES,
    DESCENT,
    DRAG_FLOOR,
    DRAG_PULL,
    DRAG_STRIDE,
    DRAGGING,
    EAGER,
    ENOUGH,
    ERROR,
    EXPECTED,
    FIRST_DAMPING,
    FLAGS,
    FLOOR,
    FRESH,
    GOING,
    IN_XYZ,
    KEPT,
    LEFT,
    MENDING,
    MET,
    MOST_DAMPING,
    MUSTS,
    NEAR,
    PATIENCE,
    POLISHING,
    PULL,
    REACH,
    REST,
    ROOT,
    ROOT_BEST,
    ROOT_KEPT,
    ROOT_START,
    ROWS,
    SEARCHING,
    SEED,
    SEEDS,
    SLOW,
    SOFT,
    SOLVE_FLOOR,
    SPENT,
    STAGE,
    START,
    STATE,
    STRAIGHT,
    STRIDE,
    TOLERANCE,
    TRIES,
    UNIT,
    YIELDING,
)
from layfigure_plugins.dls.kernels.placing import measure, place_links
from layfigure_plugins.dls.kernels.stepping import settle
from layfigure_plugins.dls.kernels.xyz import range_of_xyz


@jit()
def _copy(links: Any, body: Any, knobs: Any, source: Any, to: Any) -> None:
    """Copy states, each named by its column in ``body`` and its place in ``knobs``."""
    for i in range(links.shape[0]):
        for k in range(4):
            body[links[i, 0], to[0] + k] = body[links[i, 0], source[0] + k]
    for r in range(3):
        knobs[to[1] + r] = knobs[source[1] + r]


@jit()
def _return_to(work: Any, kept: Any) -> None:
    """Go back to a state that was kept in a column of ``body`` and a place among the knobs."""
    _copy(work.links, work.body, work.knobs, kept, (STATE, ROOT))
    place_links(work.links, work.body, work.knobs)
    measure(work.tasks, work.goals, work.body, work.normal, work.knobs)


# --- beginning ----------------------------------------------------------------------------------------------------


@jit()
def begin_drag(work: Any) -> None:
    """Prepare a step of a drag: one small iteration, or two where the first leaves much and helps."""
    knobs = work.knobs
    knobs[STAGE], knobs[SOFT], knobs[STRIDE], knobs[TRIES] = DRAGGING, 1.0, DRAG_STRIDE, 0.0
    knobs[FLOOR] = DRAG_FLOOR * knobs[REACH] * knobs[REACH]
    left = measure(work.tasks, work.goals, work.body, work.normal, knobs)
    still = abs(left - knobs[LEFT]) <= 1e-3 * left
    knobs[FRESH] = 0.85 * knobs[FRESH] if still else 1.0  # while no goal moves, the pull dies out
    knobs[LEFT] = left
    _prepare_drag(work)


@jit()
def _prepare_drag(work: Any) -> None:
    knobs = work.knobs
    size = math.sqrt(knobs[LEFT])
    knobs[GOING] = 1.0 * (size > knobs[REST] or knobs[ROWS] > knobs[MUSTS])
    knobs[PULL] = DRAG_PULL * knobs[EAGER] * knobs[FRESH] * min(1.0, size / (NEAR * knobs[REST]))
    _copy(work.links, work.body, knobs, (STATE, ROOT), (KEPT, ROOT_KEPT))


@jit()
def begin_solve(work: Any) -> None:
    """Prepare a solve from the pose that was loaded."""
    links, body, knobs = work.links, work.body, work.knobs
    _copy(links, body, knobs, (START, ROOT_START), (STATE, ROOT))
    for i in range(links.shape[0]):
        body[links[i, 0], FLAGS] = 0.0
    knobs[PULL], knobs[SOFT], knobs[STRIDE], knobs[SPENT] = 0.0, 0.0, 1.0, 0.0
    knobs[STAGE], knobs[SEED], knobs[AGREED] = SEARCHING, 0.0, 0.0
    knobs[FLOOR] = SOLVE_FLOOR * knobs[REACH] * knobs[REACH]
    _begin_descent(work, 0.03)


@jit()
def _begin_descent(work: Any, patience: float) -> None:
    """Prepare a way down from the present state, which ends where steps gain less than a share of ``patience``."""
    knobs = work.knobs
    place_links(work.links, work.body, knobs)
    knobs[LEFT] = measure(work.tasks, work.goals, work.body, work.normal, knobs)
    knobs[DAMPING], knobs[SLOW], knobs[TRIES], knobs[PATIENCE] = FIRST_DAMPING, 0.0, 0.0, patience
    knobs[GOING] = 1.0 - knobs[MET]
    _copy(work.links, work.body, knobs, (STATE, ROOT), (KEPT, ROOT_KEPT))


# --- after an iteration -------------------------------------------------------------------------------------------


@jit()
def judge(work: Any, turned: float) -> None:
    """Measure what an iteration did, take it back if it did harm, and decide whether another one follows."""
    knobs = work.knobs
    now = measure(work.tasks, work.goals, work.body, work.normal, knobs)
    knobs[TRIES] += 1.0
    knobs[SPENT] += 1.0
    if knobs[STAGE] == DRAGGING:
        _judge_drag(work, turned, now)
    elif knobs[STAGE] == YIELDING:
        knobs[GOING] = 1.0 * (turned > 1e-4 and knobs[TRIES] < DESCENT)
    else:
        _judge_descent(work, now)


@jit()
def _judge_drag(work: Any, turned: float, now: float) -> None:
    knobs = work.knobs
    before = knobs[LEFT]
    _remember(knobs, before, now)
    if turned < AT_REST:
        _return_to(work, (KEPT, ROOT_KEPT))
    far = math.sqrt(now) > NEAR * knobs[REST]
    knobs[LEFT] = now
    if turned >= AT_REST and far and now <= 0.5 * before and knobs[TRIES] < 2.0:
        knobs[STRIDE] = max(DRAG_STRIDE - turned, 0.01)
        _prepare_drag(work)
    else:
        knobs[GOING] = 0.0


@jit()
def _judge_descent(work: Any, now: float) -> None:
    """Never go up: what led there is taken back and damped more."""
    knobs = work.knobs
    if now > knobs[LEFT]:
        _return_to(work, (KEPT, ROOT_KEPT))
        knobs[DAMPING] *= 10.0
    else:
        knobs[SLOW] = knobs[SLOW] + 1.0 if now > (1.0 - knobs[PATIENCE]) * knobs[LEFT] else 0.0
        knobs[LEFT] = now
        knobs[DAMPING] = max(knobs[DAMPING] * 0.3, 1e-5)
        _copy(work.links, work.body, knobs, (STATE, ROOT), (KEPT, ROOT_KEPT))
    hopeless = knobs[SLOW] >= 3.0 or knobs[DAMPING] > 1e3 or knobs[TRIES] >= DESCENT
    knobs[GOING] = 1.0 * (knobs[MET] == 0.0 and not hopeless)


@jit()
def _remember(knobs: Any, before: float, after: float) -> None:
    """Adapt what a drag remembers: damping grows where steps do not help, and the pull fades where it does harm.

    Out of reach a pull off the stretched limb shows as an error larger than the linear system expected, at a limb that
    is stuck on its limits as a smaller one; so the first stays stretched and the second comes off.
    """
    if after > 0.5 * before:
        knobs[DAMPING] = min(knobs[DAMPING] * 2.0, MOST_DAMPING)
    else:
        knobs[DAMPING] = max(knobs[DAMPING] * 0.8, 0.1)
    if after > 0.25 * before and after > knobs[EXPECTED]:
        knobs[EAGER] *= 0.7
    else:
        knobs[EAGER] = min(1.0, 1.1 * knobs[EAGER] + 0.003)


# --- after a way down ---------------------------------------------------------------------------------------------


@jit()
def turns_elsewhere(work: Any) -> bool:
    """Prepare what follows on a way that has ended, and return whether anything does."""
    knobs, stage = work.knobs, work.knobs[STAGE]
    if stage == DRAGGING:
        return False
    if stage == SEARCHING:
        if _searches_on(work):
            return True
        if knobs[MET] == 0.0:
            knobs[STAGE] = POLISHING
            _begin_descent(work, 1e-5)
            return True
    if stage == YIELDING:
        knobs[STAGE], knobs[SOFT], knobs[STRIDE] = MENDING, 0.0, 1.0
        _begin_descent(work, 1e-3)
        return True
    if stage == MENDING:
        if knobs[BEST_MET] > knobs[MET]:
            _return_to(work, (BEST, ROOT_BEST))
        return False
    if knobs[ROWS] == knobs[MUSTS]:
        return False
    _copy(work.links, work.body, knobs, (STATE, ROOT), (BEST, ROOT_BEST))
    knobs[STAGE], knobs[SOFT], knobs[STRIDE], knobs[DAMPING] = YIELDING, 1.0, 0.3, 0.5
    knobs[BEST_MET], knobs[TRIES], knobs[GOING] = knobs[MET], 0.0, 1.0
    return True


@jit()
def _searches_on(work: Any) -> bool:
    """Keep the best end of a way down; where it is a dead end, begin another way and return true."""
    knobs, left = work.knobs, work.knobs[LEFT]
    if knobs[SEED] > 0.0:
        agrees = abs(left - knobs[BEST_LEFT]) < 0.02 * knobs[BEST_LEFT]
        knobs[AGREED] = knobs[AGREED] + 1.0 if agrees else 0.0
    if knobs[SEED] == 0.0 or knobs[MET] > 0.0 or left < 0.999 * knobs[BEST_LEFT]:
        knobs[BEST_LEFT] = left
        _copy(work.links, work.body, knobs, (STATE, ROOT), (BEST, ROOT_BEST))
    else:
        _return_to(work, (BEST, ROOT_BEST))
    if knobs[MET] > 0.0 or knobs[SEED] >= SEEDS or knobs[AGREED] >= ENOUGH:
        return False
    _reseed(work.links, work.pairs, work.tasks, work.goals, work.body, int(knobs[SEED]))
    knobs[SEED] += 1.0
    _begin_descent(work, 0.03)
    return True


@jit()
def _fails(link: Any, pairs: Any, tasks: Any, goals: Any) -> bool:
    """Return whether a joint moves a must that is not met."""
    for k in range(link[2], link[3]):
        t = pairs[k, 0]
        if tasks[t, 5] and goals[t, ERROR] > goals[t, TOLERANCE]:
            return True
    return False


@jit()
def _reseed(links: Any, pairs: Any, tasks: Any, goals: Any, body: Any, seed: int) -> None:
    """Move the joints of failing tasks elsewhere: first what rests on a limit bends inward, then through the range.

    The places in the range are a low-discrepancy sequence (Roberts 2018), so that few of them cover it evenly.
    """
    count = 0
    for i in range(links.shape[0]):
        j, dofs = links[i, 0], links[i, 1]
        if j == 0 or not _fails(links[i], pairs, tasks, goals):
            continue
        hinge = dofs in (1, 2, IN_XYZ + 1, IN_XYZ + 2, IN_XYZ + 4)
        for d in range(3):
            count += 1
            if dofs >> d & 1 and (hinge or seed >= 2):
                _move_elsewhere(body, j, dofs, (d, seed, count))
        if dofs & 3 and not dofs & IN_XYZ:
            settle(body, j, body[j, STATE], 0.0, body[j, STATE + 2])
        body[j, FLAGS] = 0.0


@jit()
def _move_elsewhere(body: Any, j: int, dofs: int, which: Any) -> None:
    """Move one degree of freedom elsewhere; ``which`` is its number, the seed, and its place in the sequence."""
    d, seed, count = which
    low = max(body[j, DEGREES + 2 * d], -STRAIGHT) * UNIT  # a free twist has no limits
    high = min(body[j, DEGREES + 2 * d + 1], STRAIGHT) * UNIT
    column, angle = STATE + 2 * d, False  # what is not an angle is the sine of half of one
    if dofs & IN_XYZ:
        column, angle = STATE + d, True
        low, high = range_of_xyz(body, j, d)
    elif d == 2:
        column, angle = STATE + 3, True
    at = body[j, column] if angle else 2.0 * math.asin(min(max(body[j, column], -1.0), 1.0))
    if seed < 2:
        bend = 0.6 * (seed + 1)
        if at >= high - 1e-6:
            at = max(at - bend, low)
        elif at <= low + 1e-6:
            at = min(at + bend, high)
    else:
        share = 0.5 + (seed - 2) * (0.6180339887498949 + 0.2360679774997897 * count)
        at = low + (high - low) * (0.1 + 0.8 * (share - math.floor(share)))
    body[j, column] = at if angle else math.sin(at / 2.0)
