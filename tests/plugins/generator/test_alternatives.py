"""The ordered alternatives of one joint, against a plain reading of the rules."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from layfigure.figures.build import build_figure
from layfigure.figures.definition import Axis, Dof, JointDefinition, LimbDefinition
from layfigure.figures.figure import Figure
from layfigure.kinematics.swing import canonical, half_distance, half_vector
from layfigure.tessellation.half_circle import half_circle
from layfigure.tessellation.half_sphere import half_sphere
from layfigure_plugins.generator.alternatives import FARTHEST, Rule, alternatives, reach_of

KINDS = st.sampled_from(["swing", "twist"])


def one_joint(**limits: tuple[float, float]) -> Figure:
    dofs = tuple(Dof(kind, low, high) for kind, (low, high) in limits.items())
    arm = LimbDefinition("arm", Axis(1, 1), Axis(0, 1), end=(0.0, 1.0, 0.0), dofs=dofs)
    return build_figure("lever", LimbDefinition("base", joints=(JointDefinition((0.0, 0.0, 0.0), arm),)))


def offered(figure: Figure, rule: Rule, seed: tuple[float, float, float] = (0, 0, 0)) -> list[tuple[float, ...]]:
    return [tuple(row) for row in alternatives(figure, 1, np.array(seed, dtype=np.float64), rule).tolist()]


def plain_reading(figure: Figure, limb: int, seed: np.ndarray, rule: Rule) -> list[tuple[float, ...]]:
    """Every tessellation point in turn, tested and sorted by the words of posing.md 5."""
    columns = [column for column in ((0, 1) if rule.kind == "swing" else (2,)) if figure.arrays.has_dof[limb, column]]
    tessellation = half_sphere() if len(columns) == 2 else half_circle()
    found = []
    for point, level in zip(tessellation.angles.tolist(), tessellation.levels.tolist(), strict=True) if columns else ():
        angles = seed.copy()
        angles[columns] = point
        pair = (angles[columns[0]], angles[columns[1]] if len(columns) == 2 else 0.0)
        home = (seed[columns[0]], seed[columns[1]] if len(columns) == 2 else 0.0)
        if rule.within_limits and not all(
            figure.arrays.limits[limb, column, 0] <= angles[column] <= figure.arrays.limits[limb, column, 1]
            for column in columns
        ):
            continue
        if rule.reach is not None and half_distance(half_vector(*pair), half_vector(*home)) > rule.reach:
            continue
        key = (pair[1] != 0, level, round(sum(map(abs, pair)), 6), abs(pair[1]), pair[0] < 0, pair[1] < 0)
        found.append((key, level, tuple(angles.tolist())))
    others = [item for item in found if item[2] != tuple(seed.tolist())]
    taken: list[tuple[tuple[float, ...], int, tuple[float, ...]]] = []
    for level in range(7):
        if len(taken) < 9:
            taken += [item for item in others if item[1] == level]
    return [angles for _, _, angles in sorted(taken or found)]


@settings(max_examples=12, deadline=None)
@given(limb=st.integers(1, 19), numbers=st.integers(0, 2**32 - 1), kind=KINDS, first=st.booleans())
@pytest.mark.parametrize("intensity", [1.0, 7.0, 40.0, 100.0])
def test_alternatives_are_those_of_the_plain_reading(
    humanoid: Figure, limb: int, numbers: int, kind: str, first: bool, intensity: float
) -> None:
    low, high = humanoid.arrays.limits[limb].T
    seed = canonical(np.random.default_rng(numbers).uniform(low, high))[0]
    rule = Rule(kind, first, None if first else reach_of(intensity))
    found = alternatives(humanoid, limb, seed, rule).tolist()
    assert [tuple(row) for row in found] == plain_reading(humanoid, limb, seed, rule)


def test_the_first_alternatives_of_a_thigh_are_pure_flexion_from_coarse_to_fine(humanoid: Figure) -> None:
    found = alternatives(humanoid, humanoid.index("rightthigh"), np.zeros(3), Rule("swing", within_limits=True))
    assert found[:7, 0].tolist() == [90, 45, 135, 22.5, 67.5, 112.5, 157.5]
    assert not found[:7, 1].any()
    assert found[7:, 1].all()


def test_levels_are_taken_until_there_are_nine(humanoid: Figure) -> None:
    everywhere = one_joint(flexion=(-180, 180), pivot=(-180, 180))
    assert len(offered(everywhere, Rule("swing", within_limits=True))) == 33 - 1
    assert len(offered(one_joint(twist=(-180, 180)), Rule("twist", within_limits=True))) == 16 - 1


def test_a_joint_with_little_room_uses_up_the_finest_level() -> None:
    tight = one_joint(twist=(-3, 3))
    assert offered(tight, Rule("twist", within_limits=True)) == [(0, 0, 2.8125), (0, 0, -2.8125)]


def test_the_seed_stands_for_itself_where_it_is_the_only_alternative() -> None:
    stiff = one_joint(flexion=(0, 1))
    assert offered(stiff, Rule("swing", within_limits=True)) == [(0, 0, 0)]


def test_a_joint_whose_limits_hold_no_point_has_no_alternatives() -> None:
    assert offered(one_joint(flexion=(1, 2)), Rule("swing", within_limits=True), (1.5, 0, 0)) == []


def test_full_intensity_reaches_everything_whatever_the_seed() -> None:
    free = one_joint(flexion=(-10, 10), pivot=(-10, 10))
    assert len(offered(free, Rule("swing", reach=FARTHEST), (17.3, -4.2, 0))) == 9


def test_next_generations_leave_the_limits(humanoid: Figure) -> None:
    leg = humanoid.index("rightleg")
    found = alternatives(humanoid, leg, np.zeros(3), Rule("swing", reach=FARTHEST))
    assert found[:, 0].max() == 180.0


def test_one_missing_swing_angle_never_moves(humanoid: Figure) -> None:
    seed = np.array([10.0, 30.0, 5.0])
    found = alternatives(humanoid, humanoid.index("leftleg"), seed, Rule("swing", reach=FARTHEST))
    assert (found[:, 1:] == seed[1:]).all()
    np.testing.assert_array_equal(canonical(found), found)


def test_limits_that_hold_only_the_other_spelling_of_a_rotation_still_offer_it() -> None:
    backwards = one_joint(flexion=(-180, 0))
    assert (180.0, 0.0, 0.0) in offered(backwards, Rule("swing", within_limits=True))
    outwards = one_joint(flexion=(-180, 180), pivot=(-180, 0))
    straight_back = [row for row in offered(outwards, Rule("swing", within_limits=True)) if abs(row[0]) + row[1] == 180]
    assert (0.0, 180.0, 0.0) in straight_back


def test_left_and_right_stand_side_by_side() -> None:
    free = one_joint(flexion=(-90, 90), pivot=(-90, 90))
    for rule in (
        Rule("swing", within_limits=True),
        Rule("swing", reach=reach_of(60)),
        Rule("swing", reach=reach_of(9)),
    ):
        found = offered(free, rule, (22.5, 0, 0))
        for place, (flexion, pivot, twist) in enumerate(found):
            if pivot > 0 and abs(flexion) + pivot < 180:
                assert found[place + 1] == (flexion, -pivot, twist)


@given(st.floats(0, 100), st.floats(0, 100))
def test_a_higher_intensity_never_reaches_less(a: float, b: float) -> None:
    assert reach_of(min(a, b)) <= reach_of(max(a, b)) <= FARTHEST
