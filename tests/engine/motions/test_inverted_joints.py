"""A joint that holds its primary link: several limbs share its id, and a motion moves it as if it were not turned."""

import numpy as np

from layfigure.models import Link, box, joint, model
from layfigure.motions.building import from_poses
from layfigure.motions.editing import all_joints, values_in
from layfigure.motions.mirroring import mirror
from layfigure.motions.motion import Motion
from layfigure.motions.sampling import sample
from layfigure.motions.slerp import slerp
from layfigure.scenes.performing import Performer

LIMITS = {"x": (-40, 40), "y": (-50, 50), "z": (-60, 60)}
TURN = Motion.of({1: [(0, (0, 0, 0)), (4, (20, -30, 50), "linear")]})
TOO_FAR = Motion.of({1: [(0, (0, 0, 0)), (4, (20, -30, 90), "linear")]})


def _hung_up(inverted=True):
    """Return a stand that holds a part of two links by its main link or, inverted, by the other one."""
    part = model(joint(1, Link("a", box(1, 1, 1)), (0, 1, 0), Link("b", box(1, 1, 1)), (0, -1, 0), **LIMITS))
    held = part.with_main(link="b") if inverted else part
    return model(joint("neck", Link("stand", box(1, 1, 1)), (1, 2, 3), held, (3, 2, 1), y=(-9, 9)))


INVERTED, PLAIN = _hung_up(), _hung_up(inverted=False)
LIMBS = [limb.index for limb in INVERTED.figure.limbs if limb.joint_id == "1"]


def test_a_legal_motion_is_not_clamped_and_a_joint_is_counted_once():
    assert len(LIMBS) == 3
    shown, plain = (sample(whole.figure, TURN, [0, 2, 4]) for whole in (INVERTED, PLAIN))
    assert shown.clamps == plain.clamps and str(shown.clamps) == "clamped none of 3 samples"
    assert shown.angles[2, LIMBS].sum(axis=0).tolist() == [20, -30, 50]
    assert np.count_nonzero(shown.angles[2]) == 3


def test_limits_hold_as_they_do_for_the_joint_that_is_not_inverted():
    shown, plain = (sample(whole.figure, TOO_FAR, [0, 2, 4]) for whole in (INVERTED, PLAIN))
    assert shown.clamps == plain.clamps
    assert str(shown.clamps) == "clamped 1 of 3 samples, worst 1.z +30 degrees at frame 4"


def test_keys_are_clamped_to_the_limits_of_the_limbs_that_turn_by_them():
    assert TURN.clamped(INVERTED.figure) == TURN.clamped(PLAIN.figure)
    kept, report = TOO_FAR.clamped(INVERTED.figure)
    assert kept.at(4) == {"1": (20, -30, 60)} and (report.clamped, report.kind, report.excess) == (1, "z", 30)


def test_poses_become_keys_and_keys_poses_again():
    shown = sample(INVERTED.figure, TURN, [0, 4])
    motion = from_poses(INVERTED.figure, [(0, shown.pose(0)), (4, shown.pose(1))], how="linear")
    assert motion.strip(1).tracks == TURN.tracks
    again = sample(INVERTED.figure, motion, [0, 4])
    assert (again.pose(0), again.pose(1)) == (shown.pose(0), shown.pose(1))


def test_a_key_of_the_pose_holds_all_three_angles():
    pose = sample(INVERTED.figure, TURN, [4]).pose(0)
    assert values_in(INVERTED.figure, pose, ["1"]) == {"1": (20, -30, 50)}
    assert "1" in all_joints(INVERTED.figure)


def test_the_shortest_turn_is_that_of_the_joint_that_is_not_inverted():
    assert slerp(TURN, INVERTED.figure) == slerp(TURN, PLAIN.figure)


def test_it_keeps_its_orientation_where_its_model_is_cast_anew():
    performer = Performer(INVERTED)
    performer.angles = np.array(sample(INVERTED.figure, TURN, [4]).angles[0])
    plain = performer.recast(PLAIN, 10)
    assert plain.angles[PLAIN.figure.limbs[-1].index].tolist() == [20, -30, 50]
    assert np.array_equal(plain.recast(INVERTED, 10).angles, performer.angles)


def test_a_mirror_turns_it_as_it_turns_the_joint_that_is_not_inverted():
    assert mirror(TURN, INVERTED.figure) == mirror(TURN, PLAIN.figure)
