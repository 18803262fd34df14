"""A swing beyond half a turn is brought back, is reported, and stays inside limits that leave rest out."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from layfigure.figures.library import read_figure
from layfigure.motions.motion import Motion
from layfigure.motions.sampling import sample


def _arm(flexion, pivot):
    low, high = flexion
    dofs = f"flexiondof {low} {high} pivotdof {pivot[0]} {pivot[1]}"
    return read_figure("arm", f"r {{ joint 0 0 0 arm {{ axis y 0 0 0 0 5 0 {dofs} }} }}", "arm.fig")


def _to(flexion, pivot, joint="arm"):
    return Motion.of({joint: [(0, (0, 0, 0)), (4, (flexion, pivot, 0), "linear")]})


def test_a_swing_beyond_half_a_turn_is_clamped_and_reported():
    shown = sample(_arm((-150, 150), (-150, 150)), _to(120, 120), [0, 4])
    np.testing.assert_allclose(shown.angles[:, 1], [[0, 0, 0], [90, 90, 0]])
    assert str(shown.clamps) == "clamped 1 of 2 samples, worst arm.flexion +30 degrees at frame 4"


def test_it_is_reported_where_limits_are_left_alone_and_of_the_root_too():
    assert sample(_arm((-9, 9), (-9, 9)), _to(120, 120), [4], clamp=False).clamps.clamped == 1
    report = sample(_arm((-9, 9), (-9, 9)), _to(120, 90, "root"), [4]).clamps
    assert (report.clamped, report.joint) == (1, "root")


@pytest.mark.parametrize("turn", [(-360, 0), (0, 270)])
def test_a_root_that_turns_over_is_not_clamped(turn):
    assert not sample(_arm((-9, 9), (-9, 9)), _to(*turn, "root"), [0, 1, 2, 3, 4]).clamps


@given(st.integers(0, 120), st.integers(-180, 180), st.integers(-180, 180))
def test_limits_that_leave_rest_out_are_kept_on_the_way_back(low, flexion, pivot):
    shown = sample(_arm((low, 180), (-150, 150)), _to(flexion, pivot), [4]).angles[0, 1]
    assert low <= shown[0] <= 180 and -150 <= shown[1] <= 150
    assert abs(shown[0]) + abs(shown[1]) <= 180 + 1e-9
