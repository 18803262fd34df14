"""A motion on a figure: absent joints, seams, limits, the root's way, and what is reported."""

from fractions import Fraction
from itertools import pairwise

import numpy as np
import pytest

from layfigure.errors import LayfigureError
from layfigure.figures.library import load_figure, read_figure
from layfigure.kinematics.forward import place
from layfigure.motions.clamping import merged
from layfigure.motions.motion import Motion
from layfigure.motions.sampling import frame_times, sample
from layfigure.motions.seams import seams
from layfigure.motions.standard import STANDARD
from layfigure.plugins.records import Interpolation
from layfigure.poses.pose import Pose

HUMANOID = load_figure("humanoid")
ARM, SPINE = HUMANOID.index("leftforearm"), HUMANOID.index("spine")
BEND = Motion.of({"leftforearm": [(0, (0, 0, 0)), (12, (90, 0, 0))]})
BOW = Motion.of({"spine": [(0, (0, 0, 0)), (12, (-40, 0, 0))]})
WALK = Motion.of({"place": [(0, (0, 0, 0)), (12, (0, 2, 15)), (24, (0, 0, 30))], "spine": [(24, (-9, 0, 0))]})


def place_of(motion, *times, **manner):
    """Return where the root is at times, in script coordinates."""
    return (sample(HUMANOID, motion, times, **manner).translations * [1, 1, -1]).tolist()


def test_joints_that_a_motion_does_not_name_stand_as_they_did_and_one_that_falls_silent_stays():
    start = Pose.rest(HUMANOID).with_joint(SPINE, -10, 5, 0).with_joint(ARM, 20, 0, 0)
    shown = sample(HUMANOID, BEND + BOW, [0, 6, 11, 12, 18, 24], start)
    assert shown.angles[:3, SPINE].tolist() == [[-10, 5, 0]] * 3
    assert shown.angles[3:, ARM].tolist() == [[90, 0, 0]] * 3
    assert shown.angles[3, SPINE].tolist() == [0, 0, 0] and shown.angles[5, SPINE, 0] == -40
    assert shown.pose(0) == start.with_joint(ARM, 0, 0, 0)


def test_at_a_seam_the_right_motion_holds_even_where_a_float_cannot_tell():
    third = (BEND + BEND).scale(frames=Fraction(1, 7))
    seam, just_before = Fraction(12, 7), Fraction(12, 7) - Fraction(1, 10**20)
    assert float(seam) == float(just_before)
    shown = sample(HUMANOID, third, [just_before, seam, Fraction(24, 7)])
    np.testing.assert_allclose(shown.angles[:, ARM, 0], [90, 0, 90], atol=1e-9)
    assert sample(HUMANOID, BEND + BEND, np.array([11.999999, 12.0])).angles[:, ARM, 0].round(3).tolist() == [90, 0]


def test_times_may_come_in_any_order_and_form():
    wanted = sample(HUMANOID, BEND, [3, 1, 12, 40, -2]).angles
    for times in (np.array([3.0, 1.0, 12.0, 40.0, -2.0]), np.array([3, 1, 12, 40, -2]), ["3", "2/2", "12", 40.0, -2]):
        assert np.array_equal(sample(HUMANOID, BEND, times).angles, wanted)
    assert len(sample(HUMANOID, BEND, [])) == 0
    with pytest.raises(LayfigureError, match="finite"):
        sample(HUMANOID, BEND, np.array([np.nan]))


def test_frame_times_cover_a_motion_from_end_to_end():
    assert frame_times(BEND).tolist() == list(range(13))
    assert frame_times(BEND, 60).tolist() == [frame * 24 / 60 for frame in range(31)]
    for fps, rate in ((0, 24), (24, 0), (-1, 24), (10**12, 24)):
        with pytest.raises(LayfigureError):
            frame_times(BEND, fps, rate)


def test_ten_strides_lead_ten_strides_far():
    assert place_of(10 * WALK, 0, 12, 24, 239, 240)[-1] == [0, 0, 300]
    assert place_of(10 * WALK, 36)[0] == [0, 2, 45]
    assert place_of(WALK, 240, 241, 252, repeat=True)[0] == [0, 0, 300]
    np.testing.assert_allclose(place_of(WALK, *range(60), repeat=True), place_of(3 * WALK, *range(60)), atol=1e-9)


def test_a_way_back_leads_back_and_a_height_that_is_held_is_taken_as_written():
    assert place_of(WALK + WALK.reverse(), 24, 36, 48) == [[0, 0, 30], [0, 2, 15], [0, 0, 0]]
    assert place_of(10 * WALK.reverse(), 240)[0] == [0, 0, -270]
    sit = Motion.of({"place": [(0, (0, -20, 0)), (8, (0, -20, 0))]})
    stand = Motion.of({"place": [(0, (0, 0, 0)), (8, (0, 0, 0))]})
    assert [y for _, y, _ in place_of(stand + 2 * sit + WALK, 0, 8, 16, 24)] == [0, -20, -20, 0]
    assert place_of(WALK.scale(extremes=0.5), 24)[0] == [0, 0, 15]


def test_the_place_is_added_to_where_the_figure_stood():
    start = Pose.of(Pose.rest(HUMANOID).angles, (5, 6, 7))
    assert sample(HUMANOID, WALK, [24], start).translations.tolist() == [[5, 6, 7 - 30]]


def test_repeating_goes_round_and_joints_begin_where_they_ended():
    late = (BOW + BEND).strip("leftforearm", "spine")
    shown = sample(HUMANOID, late, [6, 24, 30, 42], repeat=True)
    assert shown.angles[:, ARM, 0].tolist() == [0, 90, 90, 45]
    assert shown.angles[:, SPINE, 0].tolist() == [-20, 0, -20, -40]


def test_limits_win_and_the_report_says_where():
    far = Motion.of({"spine": [(0, (0, 0, 0)), (30, (0, 0, 57), "linear")], "leftforearm": [(30, (90, 3, 0))]})
    shown = sample(HUMANOID, far, frame_times(far))
    low, high = np.moveaxis(HUMANOID.arrays.limits[1:], -1, 0)
    assert ((low <= shown.angles[:, 1:]) & (shown.angles[:, 1:] <= high)).all()
    worst = shown.clamps
    assert (worst.joint, worst.kind, worst.frame, worst.samples) == ("spine", "twist", 30, 62)
    assert str(shown.clamps).startswith("clamped 36 of 62 samples, worst spine.twist +12 degrees at frame 30")
    free = sample(HUMANOID, far, frame_times(far), clamp=False)
    assert free.angles[30, SPINE, 2] == pytest.approx(57) and not free.clamps
    assert str(free.clamps) == "clamped none of 0 samples"


def test_a_motions_own_keys_can_be_clamped_and_reports_merge():
    far = Motion.of({"spine": [(0, (0, 0, 0)), (30, (-90, 0, 57))], "nobody": [(3, (999, 0, 0))]})
    kept, report = far.clamped(HUMANOID)
    assert kept.end() == {"nobody": (999.0, 0.0, 0.0), "spine": (-70.0, 0.0, 45.0)}
    assert str(report) == "clamped 1 of 2 keys, worst spine.flexion -20 degrees at frame 30"
    again, nothing = kept.clamped(HUMANOID)
    assert again == kept and not nothing
    assert str(merged([nothing, report, report])).startswith("clamped 2 of 6 samples, worst spine.flexion -20")


def test_limits_are_those_of_the_figure_that_the_motion_is_applied_to():
    child = read_figure("child", "r { joint 0 0 0 spine { axis y 0 0 0 0 5 0 flexiondof -9 9 } }", "child.fig")
    assert sample(child, BOW, [12]).angles[0, 1].tolist() == [-9, 0, 0]
    assert sample(HUMANOID, BOW, [12]).angles[0, SPINE].tolist() == [-40, 0, 0]


def test_joints_that_the_figure_lacks_are_told():
    assert sample(HUMANOID, BEND | Motion.of({"tail": [(3, (1, 1, 1))]}), [0]).unknown == ("tail",)


def test_a_somersault_goes_on_through_half_a_turn():
    over = Motion.of({"root": [(0, (0, 0, 0)), (8, (-360, 0, 0))]})
    shown = sample(HUMANOID, over, frame_times(over))
    turned = place(HUMANOID, shown.angles, shown.translations).limb_to_world[:, 0]
    for left, right in pairwise(turned):
        assert np.degrees(np.arccos((np.trace(left.T @ right) - 1) / 2)) < 46
    np.testing.assert_allclose(turned[-1], np.eye(3), atol=1e-9)


def test_limbs_that_share_a_joint_move_alike_by_x_y_and_z():
    twin = "{ 0 0 0 0 5 0 id 7 zdof 0 720 }"
    clock = read_figure("clock", f"r {{ handed right joint 0 0 0 one {twin} joint 0 9 0 two {twin} }}", "clock.fig")
    hours = Motion.of({7: [(0, (0, 0, 0)), (120, (0, 0, 800))]})
    shown = sample(clock, hours, [60, 120])
    np.testing.assert_allclose(shown.angles[:, 1:], [[[0, 0, 400]] * 2, [[0, 0, 720]] * 2])
    assert str(shown.clamps) == "clamped 1 of 2 samples, worst 7.z +80 degrees at frame 120"
    assert shown.pose(0).angles[1].tolist() == [0, 0, 400]


def test_a_seam_report_names_the_worst_jump_in_degrees_and_degrees_a_second():
    report = seams(BEND + BEND + BOW)
    (seam,) = report.seams
    assert (seam.joint, seam.time, seam.jump) == ("leftforearm", 12, 90)
    assert str(report) == "1 seam, worst leftforearm 90 degrees and 0 degrees/s at frame 12"
    back = BEND + BEND.reverse()
    assert seams(back).jump == 0 and seams(back).worst.velocity_jump == pytest.approx(2 * 90 / 12 * 24)
    assert BEND.loop().worst.jump == 90 and BOW.then(BEND)[1].seams == ()
    assert BEND.then(BEND)[0] == BEND + BEND and str(BOW.then(BEND)[1]) == "no seams"
    assert seams(10 * WALK).worst.joint == "spine"


@pytest.mark.parametrize("asked", [Motion.end, Motion.loop, lambda m, curves: m.then(m, curves)])
def test_ends_and_seams_know_the_interpolations_that_they_are_given(asked):
    swing = Motion.of({5: [(12, (0, 0, 90), "square")]})
    with pytest.raises(LayfigureError, match="square"):
        asked(swing, curves=STANDARD)
    assert asked(swing, curves={**STANDARD, "square": Interpolation("square", "Square", lambda u: u * u)})


def test_too_many_samples_are_refused_before_they_are_made():
    with pytest.raises(LayfigureError, match="too many"):
        sample(HUMANOID, BEND, np.zeros(2_000_000))
