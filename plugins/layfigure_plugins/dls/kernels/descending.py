"""From steps to answers: a solve, which goes down from several places, and a step of a drag, which never jumps."""

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
    DAMPING,
    DEGREES,
    DESCENT,
    DRAG_FLOOR,
    DRAG_PULL,
    DRAG_STRIDE,
    EAGER,
    ERROR,
    EXPECTED,
    FIRST_DAMPING,
    FLAGS,
    FLOOR,
    KEPT,
    MET,
    MOST_DAMPING,
    MUSTS,
    NEAR,
    PULL,
    REACH,
    REST,
    ROOT,
    ROOT_BEST,
    ROOT_KEPT,
    ROOT_START,
    ROWS,
    SEEDS,
    SOFT,
    SOLVE_FLOOR,
    SPENT,
    START,
    STATE,
    STRIDE,
    TOLERANCE,
    UNIT,
)
from layfigure_plugins.dls.kernels.placing import measure, place_links
from layfigure_plugins.dls.kernels.stepping import iterate, settle


@jit()
def _copy(links: Any, body: Any, knobs: Any, source: Any, to: Any) -> None:
    """Copy states, each named by its column in ``body`` and its place in ``knobs``."""
    for i in range(links.shape[0]):
        for k in range(4):
            body[links[i, 0], to[0] + k] = body[links[i, 0], source[0] + k]
    for r in range(3):
        knobs[to[1] + r] = knobs[source[1] + r]


@jit()
def _descend(work: Any, patience: float) -> float:
    """Go down until every must is met or no more is to be gained, never up; return what is left in units^2."""
    links, tasks, goals, body, normal, knobs = work.links, work.tasks, work.goals, work.body, work.normal, work.knobs
    place_links(links, body, knobs)
    left, slow = measure(tasks, goals, body, normal, knobs), 0
    knobs[DAMPING] = FIRST_DAMPING
    for _ in range(DESCENT):
        if knobs[MET] > 0.0 or slow >= 3 or knobs[DAMPING] > 1e3:
            break
        _copy(links, body, knobs, (STATE, ROOT), (KEPT, ROOT_KEPT))
        iterate(work)
        now = measure(tasks, goals, body, normal, knobs)
        knobs[SPENT] += 1
        if now > left:
            _copy(links, body, knobs, (KEPT, ROOT_KEPT), (STATE, ROOT))
            place_links(links, body, knobs)
            measure(tasks, goals, body, normal, knobs)
            knobs[DAMPING] *= 10.0
            continue
        slow = slow + 1 if now > (1.0 - patience) * left else 0
        left = now
        knobs[DAMPING] = max(knobs[DAMPING] * 0.3, 1e-5)
    return left


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
        for d in range(3):
            count += 1
            if not dofs >> d & 1:
                continue
            low, high = body[j, DEGREES + 2 * d] * UNIT, body[j, DEGREES + 2 * d + 1] * UNIT
            at = body[j, STATE + 3] if d == 2 else 2.0 * math.asin(min(max(body[j, STATE + 2 * d], -1.0), 1.0))
            if seed < 2:
                bend = 0.6 * (seed + 1)
                if dofs != 1 and dofs != 2:
                    continue
                if at >= high - 1e-6:
                    at = max(at - bend, low)
                elif at <= low + 1e-6:
                    at = min(at + bend, high)
            else:
                share = 0.5 + (seed - 2) * (0.6180339887498949 + 0.2360679774997897 * count)
                at = low + (high - low) * (0.1 + 0.8 * (share - math.floor(share)))
            if d == 2:
                body[j, STATE + 3] = at
            else:
                body[j, STATE + 2 * d] = math.sin(at / 2.0)
        if dofs & 3:
            settle(body, j, body[j, STATE], 0.0, body[j, STATE + 2])
        body[j, FLAGS] = 0.0


@jit()
def solve(work: Any) -> None:
    """Go down from the start, and where that ends in a dead end from other places; end at the best."""
    links, pairs, tasks, goals, body, normal, knobs = (
        work.links,
        work.pairs,
        work.tasks,
        work.goals,
        work.body,
        work.normal,
        work.knobs,
    )
    _copy(links, body, knobs, (START, ROOT_START), (STATE, ROOT))
    for i in range(links.shape[0]):
        body[links[i, 0], FLAGS] = 0.0
    knobs[PULL], knobs[SOFT], knobs[STRIDE], knobs[SPENT], knobs[FLOOR] = (
        0.0,
        0.0,
        1.0,
        0.0,
        SOLVE_FLOOR * knobs[REACH] ** 2,
    )
    best, agreed = _descend(work, 0.03), 0
    for seed in range(SEEDS):
        if knobs[MET] > 0.0 or agreed >= AGREED:
            break
        if seed == 0:
            _copy(links, body, knobs, (STATE, ROOT), (BEST, ROOT_BEST))
        _reseed(links, pairs, tasks, goals, body, seed)
        left = _descend(work, 0.03)
        agreed = agreed + 1 if abs(left - best) < 0.02 * best else 0
        if left < 0.999 * best:
            best = left
            _copy(links, body, knobs, (STATE, ROOT), (BEST, ROOT_BEST))
        elif knobs[MET] == 0.0:
            _copy(links, body, knobs, (BEST, ROOT_BEST), (STATE, ROOT))
            place_links(links, body, knobs)
            measure(tasks, goals, body, normal, knobs)
    if knobs[MET] == 0.0:
        _descend(work, 1e-5)
    if knobs[ROWS] > knobs[MUSTS]:
        _yield_softly(work)


@jit()
def _yield_softly(work: Any) -> None:
    """Follow the soft tasks as far as the musts allow, and see the musts met again."""
    links, tasks, goals, body, normal, knobs = work.links, work.tasks, work.goals, work.body, work.normal, work.knobs
    met = knobs[MET]
    _copy(links, body, knobs, (STATE, ROOT), (BEST, ROOT_BEST))
    knobs[SOFT], knobs[DAMPING], knobs[STRIDE] = 1.0, 0.5, 0.3
    for _ in range(DESCENT):
        turned = iterate(work)
        measure(tasks, goals, body, normal, knobs)
        if turned < 1e-4:
            break
    knobs[SOFT], knobs[STRIDE] = 0.0, 1.0
    _descend(work, 1e-3)
    if met > knobs[MET]:
        _copy(links, body, knobs, (BEST, ROOT_BEST), (STATE, ROOT))
        place_links(links, body, knobs)
        measure(tasks, goals, body, normal, knobs)


@jit()
def drag(work: Any) -> None:
    """Go after the goals by one small iteration, or two where the first left much and has helped."""
    links, tasks, goals, body, normal, knobs = work.links, work.tasks, work.goals, work.body, work.normal, work.knobs
    knobs[SOFT], knobs[STRIDE], knobs[FLOOR] = 1.0, DRAG_STRIDE, DRAG_FLOOR * knobs[REACH] ** 2
    before = measure(tasks, goals, body, normal, knobs)
    for _ in range(2):
        size = math.sqrt(before)
        if size <= knobs[REST] and knobs[ROWS] == knobs[MUSTS]:
            break
        knobs[PULL] = DRAG_PULL * knobs[EAGER] * min(1.0, size / (NEAR * knobs[REST]))
        _copy(links, body, knobs, (STATE, ROOT), (KEPT, ROOT_KEPT))
        turned = iterate(work)
        after = measure(tasks, goals, body, normal, knobs)
        _remember(knobs, before, after)
        if turned < AT_REST:
            _copy(links, body, knobs, (KEPT, ROOT_KEPT), (STATE, ROOT))
            place_links(links, body, knobs)
            measure(tasks, goals, body, normal, knobs)
            break
        if math.sqrt(after) <= NEAR * knobs[REST] or after > 0.5 * before:
            break
        before = after
        knobs[STRIDE] = max(DRAG_STRIDE - turned, 0.01)


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
