"""What holds for any figure, any pose and any tasks."""

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from tests.plugins.dls.conftest import FIGURES, beyond, kit_of

from layfigure.kinematics.forward import place_pose
from layfigure.kinematics.rotation_vector import rotation_matrix
from layfigure.techniques.solving import DirectionTask, OffsetTask, OrientationTask, PositionTask, Problem

LAWS = settings(max_examples=150, deadline=None, suppress_health_check=[HealthCheck.too_slow])
number = st.sampled_from([0.0, 1e-9, 10.0, -40.0, 120.0, 1e9, -1e300]) | st.floats(-300, 300)
vector = st.tuples(number, number, number)
turn = st.tuples(*[st.floats(-200, 200)] * 3)


@st.composite
def cases(draw):
    """A figure's name, a pose that may be outside its limits, and a problem of any tasks."""
    name = draw(st.sampled_from(FIGURES))
    kit = kit_of(name)
    count = len(kit.figure.limbs)
    pose = kit.random_pose(np.random.default_rng(draw(st.integers(0, 99))), draw(st.sampled_from([0.0, 0.5, 1.0, 1.3])))
    limb = st.integers(0, count - 1)
    weight = st.sampled_from([1.0, 1.0, 0.05, 0.0])
    rows = turn.map(lambda t: tuple(map(tuple, rotation_matrix(t).tolist())))
    task = st.one_of(
        st.builds(PositionTask, limb, vector, weight),
        st.builds(DirectionTask, limb, vector, weight),
        st.builds(OrientationTask, limb, rows, weight),
        st.builds(OffsetTask, limb, limb, vector, weight),
    )
    tasks = tuple(draw(st.lists(task, max_size=5)))
    movable = frozenset(draw(st.sets(limb)) if draw(st.booleans()) else range(count))
    return name, pose, Problem(tasks, movable, draw(st.booleans()))


def _check(kit, pose, problem, solution):
    assert np.isfinite(solution.pose.angles).all()
    assert np.isfinite(solution.pose.translation).all()
    assert np.isfinite(solution.errors).all()
    fixed = [j for j in range(len(pose.angles)) if j not in problem.movable]
    assert solution.pose.angles[fixed].tobytes() == pose.angles[fixed].tobytes()
    if not problem.root_moves:
        assert solution.pose.translation.tobytes() == pose.translation.tobytes()
    assert (beyond(kit, solution.pose) <= beyond(kit, pose)).all()
    swings = solution.pose.angles[~kit.figure.arrays.euler, :2]
    assert (np.abs(swings).sum(axis=1) <= 180.0).all()
    assert not solution.pose.angles[~kit.figure.arrays.has_dof][3:].any()


@LAWS
@given(cases())
def test_a_solve_keeps_limits_fixed_joints_and_finite_numbers(case):
    kit, pose, problem = kit_of(case[0]), *case[1:]
    before = pose.angles.tobytes(), pose.translation.tobytes()
    solution = kit.solver.solve(pose, problem)
    _check(kit, pose, problem, solution)
    assert (pose.angles.tobytes(), pose.translation.tobytes()) == before
    assert kit.solver.solve(pose, problem).pose == solution.pose


@LAWS
@given(cases())
def test_steps_of_a_drag_keep_them_too(case):
    kit, pose, problem = kit_of(case[0]), *case[1:]
    now, memory = pose, ()
    for _ in range(4):
        solution = kit.solver.step(now, problem, memory)
        again = kit.solver.step(now, problem, memory)
        assert (again.pose, again.memory) == (solution.pose, solution.memory)
        _check(kit, now, problem, solution)
        now, memory = solution.pose, solution.memory


@LAWS
@given(cases())
def test_a_solve_tells_its_errors_as_the_reference_measures_them(case):
    kit, pose, problem = kit_of(case[0]), *case[1:]
    solution = kit.solver.solve(pose, problem)
    tips, placement = kit.tips(solution.pose), place_pose(kit.figure, solution.pose)
    for task, error in zip(problem.tasks, solution.errors, strict=True):
        match task:
            case PositionTask(limb, position):
                wanted = np.linalg.norm(np.clip(position, -1e12, 1e12) - tips[limb])
            case OffsetTask(limb, other, offset):
                wanted = np.linalg.norm(tips[limb] - tips[other] - np.clip(offset, -1e12, 1e12))
            case OrientationTask(limb, rotation):
                between = np.asarray(rotation) @ placement.limb_to_world[limb].T
                wanted = np.degrees(np.arccos(np.clip((np.trace(between) - 1) / 2, -1, 1)))
            case DirectionTask():
                continue
        assert error == pytest.approx(wanted, rel=1e-6, abs=5e-3)  # an arc cosine is blunt near its ends


@pytest.mark.parametrize("name", FIGURES)
def test_no_limb_changes_its_length(name):
    kit = kit_of(name)
    arrays = kit.figure.arrays
    lengths = np.linalg.norm(arrays.ends, axis=1)
    for seed in range(10):
        rng = np.random.default_rng(seed)
        end = int(rng.choice(kit.figure.movable))
        pose = kit.solver.solve(kit.rest, kit.problem([end], kit.tips(kit.random_pose(rng))[[end]])).pose
        placement = place_pose(kit.figure, pose)
        found = np.linalg.norm(kit.tips(pose) - placement.origins, axis=1)
        np.testing.assert_allclose(found[1:], lengths[1:], atol=1e-9)
