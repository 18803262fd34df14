"""Motions mixed, mirrored, masked, warped, shaken and slowed."""

from fractions import Fraction

import numpy as np
import pytest

from layfigure.errors import LayfigureError, PluginError
from layfigure.figures.library import load_figure
from layfigure.motions.blending import additive, blend, crossfade
from layfigure.motions.mirroring import mask
from layfigure.motions.motion import Motion
from layfigure.motions.noise import noise
from layfigure.motions.pieces import Piece
from layfigure.motions.rates import rates, within_rates
from layfigure.motions.sampling import frame_times, sample
from layfigure.motions.standard import STANDARD
from layfigure.motions.warping import ease_of, warp
from layfigure.plugins.records import Interpolation
from layfigure.poses.pose import Pose
from layfigure.poses.symmetry import flipped

HUMANOID = load_figure("humanoid")
RISE = Motion.of({5: [(0, (0, 0, 0)), (12, (0, 0, 60))], 6: [(0, (1, 1, 1)), (12, (2, 2, 2), "linear")]})
FALL = Motion.of({5: [(0, (0, 0, 90)), (18, (0, 0, 0))], 7: [(0, (3, 3, 3))]}, 18)
WALK = Motion.of({"place": [(0, (0, 0, 0)), (24, (0, 0, 30))], "spine": [(0, (0, 0, 0)), (24, (-9, 0, 0))]})


def z(motion, time, joint="5"):
    return motion.at(time)[joint][2]


def test_a_crossfade_begins_in_the_one_and_ends_in_the_other():
    faded = crossfade(RISE, FALL, 6)
    assert faded.duration == 24
    assert z(faded, 6) == pytest.approx(z(RISE, 6), abs=1e-6) and z(faded, 12) == pytest.approx(z(FALL, 6), abs=1e-6)
    assert z(faded, 9) == pytest.approx((z(RISE, 9) + z(FALL, 3)) / 2, abs=1e-6)
    assert faded.tracks["6"] == RISE.tracks["6"] and faded.tracks["7"][0].begin == 6
    assert crossfade(RISE, FALL, 0) == RISE + FALL
    for frames in (13, -1):
        with pytest.raises(LayfigureError, match="0 to 12"):
            crossfade(RISE, FALL, frames)


def test_a_crossfade_keeps_the_keys_of_what_lies_outside_it():
    faded = crossfade(3 * RISE, 2 * FALL, 6)
    assert faded.tracks["5"][:2] == (3 * RISE).tracks["5"][:2]
    assert faded.tracks["5"][-1] == (2 * FALL).tracks["5"][-1].shifted(Fraction(30))


def test_a_crossfade_of_walks_walks_on():
    far = sample(HUMANOID, crossfade(WALK, WALK, 6) + WALK, [0, 18, 21, 24, 42, 66]).translations[:, 2]
    np.testing.assert_allclose(far, [0, -22.5, -26.25, -30, -52.5, -82.5], atol=1e-5)


def test_a_blend_is_the_weighted_mean_of_those_that_move_a_joint():
    mixed = blend((RISE, 1), (FALL, 3))
    assert mixed.duration == 18 and mixed.joints == ("5", "6", "7")
    assert z(mixed, 6) == pytest.approx((z(RISE, 6) + 3 * z(FALL, 6)) / 4, abs=1e-6)
    assert mixed.tracks["6"] == RISE.hold(6).tracks["6"] and mixed.tracks["7"] == FALL.tracks["7"]
    assert blend((RISE, 2), (FALL, 0)) == RISE
    for weights in ((1, -1), (0, 0)):
        with pytest.raises(LayfigureError, match="weight"):
            blend((RISE, weights[0]), (FALL, weights[1]))


def test_a_layer_is_added_beyond_its_reference():
    lifted = Motion.of({5: [(0, (0, 0, 10)), (12, (0, 0, 30))], 9: [(0, (5, 0, 0)), (12, (7, 0, 0))]})
    laid = additive(RISE, lifted, "1/2")
    assert z(laid, 6) == pytest.approx(z(RISE, 6) + 5, abs=1e-6) and laid.at(12)["9"] == (1.0, 0.0, 0.0)
    assert laid.tracks["6"] == RISE.tracks["6"]
    absolute = additive(RISE, lifted, reference={"5": (0, 0, 0)})
    assert z(absolute, 0) == 10 and absolute.at(0)["9"] == (5.0, 0.0, 0.0)


def test_a_layer_may_break_limits_and_is_clamped_and_reported():
    bow = Motion.of({"spine": [(0, (-60, 0, 0)), (12, (-60, 0, 0))]})
    more = Motion.of({"spine": [(0, (0, 0, 0)), (12, (-30, 0, 0))]})
    shown = sample(HUMANOID, additive(bow, more), [12])
    assert shown.angles[0, HUMANOID.index("spine"), 0] == -70
    assert str(shown.clamps) == "clamped 1 of 1 samples, worst spine.flexion -20 degrees at frame 12"


def test_a_blend_of_walks_walks():
    slow = WALK.scale(extremes=0.5)
    assert sample(HUMANOID, 2 * blend((WALK, 1), (slow, 1)), [48]).translations[0, 2] == pytest.approx(-45)


def test_masks_choose_sides_limbs_and_all_below_a_limb():
    left, right, middle = (mask(HUMANOID, side) for side in ("left", "right", "middle"))
    assert "leftforearm" in left and "rightthigh" in right and "spine" in middle and not left & right
    assert {joint.replace("left", "right") for joint in left} == right
    assert mask(HUMANOID, "leftthigh+") == {"leftthigh", "leftleg", "leftfoot"}
    assert mask(HUMANOID, "neck", "spine") == {"neck", "spine"} and mask(HUMANOID, "root") == {"root", "place"}
    with pytest.raises(LayfigureError, match="leftthigh"):
        mask(HUMANOID, "leftthih+")


def test_the_mirror_image_of_a_motion_shows_the_mirror_images_of_its_poses():
    motion = Motion.of({
        "spine": [(0, (-20, 10, 5)), (8, (10, -30, 20))],
        "leftupperarm": [(0, (10, 60, 30)), (8, (50, 20, -30))],
        "righthand": [(8, (10, 20, 0))],
        "root": [(8, (3, 4, 5))],
        "place": [(8, (7, 8, 9))],
        "nobody": [(8, (1, 2, 3))],
    })  # fmt: skip
    mirrored = motion.mirror(HUMANOID)
    assert mirrored.mirror(HUMANOID) == motion and mirrored.tracks["nobody"] == motion.tracks["nobody"]
    shown, image = (sample(HUMANOID, each, range(9)) for each in (motion, mirrored))
    for frame in range(9):
        assert np.allclose(image.pose(frame).angles, flipped(HUMANOID, shown.pose(frame)).angles, atol=2e-6)
        assert image.pose(frame).translation.tolist() == (shown.pose(frame).translation * [-1, 1, 1]).tolist()


def test_a_warped_motion_stands_where_its_ease_says_and_takes_its_marks_along():
    marked = RISE.marked(3, "foot")
    slow = warp(marked, lambda u: u * u)
    assert slow.duration == 12 and slow.end() == RISE.end() and slow.at(0) == RISE.at(0)
    assert z(slow, 6) == pytest.approx(z(RISE, 3), abs=1e-5)
    assert float(slow.marks[0].time) == pytest.approx(6, abs=1e-5)
    assert RISE.warp(Interpolation("half", "Half", lambda u: u * u)) == RISE.warp(lambda u: u * u)
    late = (RISE.strip() + RISE).warp(lambda u: u)
    assert late.tracks["5"][0].begin == 12 and Motion.EMPTY.warp(lambda u: u) == Motion.EMPTY
    with pytest.raises(LayfigureError, match="finite"):
        RISE.warp(lambda u: float("nan"))


@pytest.mark.parametrize(
    ("how", "ease"),
    [
        ("linear", lambda u: u),
        ("accelerate", lambda u: u * u),
        ("decelerate", lambda u: u * (2 - u)),
        ("accdcc", lambda u: u * u * (3 - 2 * u)),
        ("cubic", lambda u: u * u * (3 - 2 * u)),
        (Interpolation("half", "Half", lambda u: u * u), lambda u: u * u),
        (Interpolation("even", "Even", pieces=lambda s: [Piece(s.frames, 0, 1 / s.frames)]), float),
    ],
)
def test_time_is_eased_as_an_interpolation_moves_from_rest(how, ease):
    eased = ease_of(STANDARD.get(how, how))
    assert [eased(u / 16) for u in range(17)] == pytest.approx([ease(u / 16) for u in range(17)], abs=1e-4)


def test_an_interpolation_that_leads_nowhere_eases_no_time():
    with pytest.raises(PluginError, match="lost does not lead from one key to the next"):
        warp(RISE, Interpolation("lost", "Lost", pieces=lambda s: [Piece(s.frames, s.start)]))


def test_noise_is_the_same_for_the_same_seed_stays_within_its_size_and_loops():
    shaken = noise(["spine", 5], 100, (2, 3, 0), seed=4)
    assert shaken == noise([5, "spine"], 100, (2, 3, 0), seed=4) != noise([5, "spine"], 100, (2, 3, 0), seed=5)
    assert noise([5], 100, (2, 3, 0), seed=4) == shaken.strip(5) and shaken.loop().jump == 0
    found = np.array([shaken.at(frame)["5"] for frame in range(101)])
    assert (np.abs(found).max(axis=0) <= [2, 3, 0]).all() and (np.abs(found).max(axis=0) > [1, 1.5, -1]).all()
    for duration, amplitude, period in ((0, 2, 12), (9, 2, 0), (9, (1, 2), 12), (9**7, 2, "1/100")):
        with pytest.raises(LayfigureError):
            noise([5], duration, amplitude, period=period)


def test_rates_are_the_largest_anywhere():
    even = Motion.of({5: [(0, (0, 0, 0)), (12, (0, 0, 60)), (24, (0, 0, 120))]})
    assert rates(even)["5"].velocity == pytest.approx(120) and rates(even)["5"].acceleration == pytest.approx(
        0, abs=1e-9
    )
    quick = Motion.of({5: [(12, (0, 0, 72), "accelerate")]})
    assert rates(quick, rate=12)["5"].velocity == pytest.approx(144)
    assert rates(quick, rate=12)["5"].acceleration == pytest.approx(144)
    smooth = Interpolation("smooth", "Smooth", lambda u: u * u * (3 - 2 * u))
    eased = Motion.of({5: [(12, (0, 0, 72), "smooth")]})
    assert rates(eased, 12, {**STANDARD, "smooth": smooth})["5"].velocity == pytest.approx(108, rel=0.01)


@pytest.mark.parametrize("how", sorted(STANDARD))
def test_a_motion_can_be_slowed_to_keep_rates_and_its_joints_stay_in_step(how):
    fast = Motion.of({
        5: [(0, (0, 0, 0)), (24, (0, 0, 20), how), (28, (0, 0, 120), how), (52, (0, 0, 90), how)],
        6: [(0, (0, 0, 0)), (26, (0, 9, 0), how), (52, (0, 0, 0), how)],
    }).marked(28, "hit")  # fmt: skip
    slow = fast.within_rates(velocity=200, acceleration=1500)
    found = rates(slow)
    assert all(each.velocity <= 200.001 and each.acceleration <= 1500.01 for each in found.values())
    assert slow.duration > fast.duration and slow.at(slow.marks[0].time)["5"] == fast.at(28)["5"]
    assert [key.values for key in slow.tracks["5"][0].keys] == [key.values for key in fast.tracks["5"][0].keys]
    assert slow.within_rates(velocity=200, acceleration=1500) == slow
    assert within_rates(fast, {"6": 10**6}) == fast
    with pytest.raises(LayfigureError, match="over 0"):
        fast.within_rates(velocity=0)


def test_what_keeps_the_rates_keeps_its_time():
    fast = Motion.of({5: [(0, (0, 0, 0)), (24, (0, 0, 0)), (28, (0, 0, 100)), (52, (0, 0, 100)), (76, (0, 0, 90))]})
    keys = fast.within_rates(velocity=300).tracks["5"][0].keys
    assert keys[1].time == 24 and keys[2].time - keys[1].time > 4 and keys[4].time - keys[2].time == 48


def test_a_shake_over_a_walk_on_the_humanoid_stays_legal_where_there_is_room():
    walk = Motion.of({"spine": [(0, (-10, 0, 0)), (12, (0, 5, 0)), (24, (-10, 0, 0))]})
    shaken = additive(4 * walk, noise(mask(HUMANOID, "spine"), 96, 3), reference={})
    assert not sample(HUMANOID, shaken, frame_times(shaken, 60), Pose.rest(HUMANOID)).clamps
