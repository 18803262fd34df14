"""The compiled Jacobian against finite differences of the numpy reference, and compiled code against plain Python."""

import json
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from tests.plugins.axis_figures import AXIS_FIGURES
from tests.plugins.dls.conftest import kit_of

from layfigure.kinematics.forward import place
from layfigure.kinematics.swing import half_vector, swing_angles
from layfigure.poses.locks import tips_of
from layfigure.techniques.solving import OffsetTask, PositionTask, Problem
from layfigure_plugins.dls.kernels import layout

STEP = 1e-6
ROOT = Path(__file__).parents[3]


def tips_after(kit, angles, limb, axis, twist):
    """Return the tips after a small rotation of a joint's half vector about a canonical axis, and a small twist."""
    flexion, pivot, turn = angles[limb]
    half = half_vector(flexion, pivot)
    half = half + np.cross(axis, half) / 2.0
    half /= np.linalg.norm(half)
    moved = angles.copy()
    moved[limb] = *swing_angles(half), turn + np.degrees(twist)
    return tips_of(kit.figure, place(kit.figure, moved, np.zeros(3)))


def tips_after_an_axis(kit, angles, limb, column, radians):
    """Return the tips after a small turn of one of a joint's angles x, y, z."""
    moved = angles.copy()
    moved[limb, column] += np.degrees(radians)
    return tips_of(kit.figure, place(kit.figure, moved, np.zeros(3)))


@pytest.mark.parametrize("name", ["humanoid", "horse", "hand", "robotarm", *AXIS_FIGURES])
def test_the_jacobian_is_the_derivative_of_the_reference(name):
    kit = kit_of(name)
    rng = np.random.default_rng(5)
    ends = [int(limb) for limb in rng.choice(kit.figure.movable, 3)]
    far = (1e6, 2e6, -1e6)  # so far that one step is all there is
    tasks = (*(PositionTask(end, far) for end in ends), OffsetTask(ends[0], ends[1], far))
    pose = kit.random_pose(rng, 0.8)
    drag = kit.solver.follow(pose, Problem(tasks, frozenset(kit.figure.movable)))
    links, pairs = drag._arrays[0], drag._arrays[1]
    drag.step(np.empty((0, 3)))
    room, checked = drag._room, 0
    for limb, dofs, first, last, column in links.tolist():
        kinds = [bit for bit in range(3) if dofs >> bit & 1]
        for q, kind in enumerate(kinds):
            twisting = kind == 2
            axis = room.body[limb, layout.AXES + 3 * q : layout.AXES + 3 * q + 3]
            swing = np.zeros(3) if twisting else STEP * axis
            there, back = (
                tips_after_an_axis(kit, pose.angles, limb, kind, sign * STEP)
                if dofs & layout.IN_XYZ
                else tips_after(kit, pose.angles, limb, sign * swing, sign * STEP * twisting)
                for sign in (1.0, -1.0)
            )
            change = (there - back) / (2.0 * STEP)
            for pair in range(first, last):
                task = tasks[pairs[pair, 0]]
                wanted = change[task.limb] - (change[task.other] if isinstance(task, OffsetTask) else 0.0)
                found = room.jacobian[column + q, 3 * (pair - first) : 3 * (pair - first) + 3]
                np.testing.assert_allclose(found, wanted, atol=1e-4)
                checked += 1
    assert checked > 5


_SCRIPT = """
import json, sys
import numpy as np
from tests.plugins.dls.conftest import kit_of
from tests.plugins.dls.test_jacobian import answers
print(json.dumps(answers()))
"""


def answers():
    """Return what a few solves and drags arrive at."""
    found = []
    for name in ("humanoid", "spider", "puppet"):
        kit = kit_of(name)
        rng = np.random.default_rng(8)
        ends = [kit.figure.movable[-1], kit.figure.movable[2]]
        for moves in (False, True):
            problem = kit.problem(ends, kit.tips(kit.random_pose(rng, 0.5))[ends], root_moves=moves)
            found.append(kit.solver.solve(kit.rest, problem).pose.angles.tolist())
            found.append(kit.solver.step(kit.rest, problem).pose.angles.tolist())
    return found


def test_compiled_code_does_what_the_same_code_does_in_plain_python():
    environment = {**os.environ, "NUMBA_DISABLE_JIT": "1"}
    command = [sys.executable, "-W", "ignore", "-c", _SCRIPT]
    plain = subprocess.run(command, env=environment, capture_output=True, text=True, check=True, cwd=ROOT)
    for compiled, reference in zip(answers(), json.loads(plain.stdout), strict=True):
        np.testing.assert_allclose(compiled, reference, atol=2e-6)
