"""Which limbs follow an end that is moved, with and without locks."""

import pytest

from layfigure.figures.library import load_figure
from layfigure.poses.locks import Band, Hold, JointLock, Pin
from layfigure.techniques.solving import chain_of
from layfigure_plugins.inverse.chains import following

HUMANOID = load_figure("humanoid")
ALL = frozenset(HUMANOID.movable)
HERE = (0.0, 0.0, 0.0)


def index(name: str) -> int:
    return HUMANOID.index(name)


def names(limbs) -> set[str]:
    return {HUMANOID.names[limb] for limb in limbs}


ARM = {"righthand", "rightforearm", "rightupperarm"}
LEGS = {side + part for side in ("left", "right") for part in ("thigh", "leg", "foot")}


@pytest.mark.parametrize(
    ("limb", "length", "expected"),
    [
        ("righthand", 3, ARM),
        ("righthand", 1, {"righthand"}),
        ("righthand", 4, ARM | {"spine"}),
        ("righthand", 0, ARM | {"spine"}),
        ("head", 1, {"neck"}),
        ("leftfoot", 0, {"leftfoot", "leftleg", "leftthigh"}),
        ("top", 0, set()),
    ],
)
def test_the_chain_length_counts_limbs_that_can_move(limb, length, expected):
    assert names(chain_of(HUMANOID, index(limb), length)) == expected


def test_without_locks_only_the_chain_moves_and_the_root_stays():
    found = following(HUMANOID, index("righthand"), 0, ALL, ())
    assert names(found.movable) == ARM | {"spine"} and not found.root_moves and found.locks == ()


def test_a_chain_up_to_the_root_carries_the_body_over_planted_feet():
    pins = (Pin(index("leftfoot"), HERE), Pin(index("rightfoot"), HERE))
    found = following(HUMANOID, index("righthand"), 0, ALL, pins)
    assert names(found.movable) == ARM | {"spine", "top"} | LEGS and found.root_moves and found.locks == pins


def test_a_short_chain_leaves_planted_feet_and_body_alone():
    pins = (Pin(index("leftfoot"), HERE), Pin(index("rightfoot"), HERE))
    found = following(HUMANOID, index("righthand"), 3, ALL, pins)
    assert names(found.movable) == ARM and not found.root_moves and found.locks == ()


def test_the_other_hand_stays_where_it_is_pinned_when_the_spine_moves():
    pin = Pin(index("lefthand"), HERE)
    found = following(HUMANOID, index("righthand"), 4, ALL, (pin,))
    assert {"leftupperarm", "leftforearm", "lefthand"} < names(found.movable) and found.locks == (pin,)


def test_a_held_hand_comes_along():
    hold = Hold(index("lefthand"), index("righthand"), (10.0, 0.0, 0.0))
    found = following(HUMANOID, index("righthand"), 3, ALL, (hold,))
    assert names(found.movable) == ARM | {"leftupperarm", "leftforearm", "lefthand"} and found.locks == (hold,)


def test_dragging_the_root_carries_it_and_bends_the_legs_whose_feet_are_planted():
    pin = Pin(index("leftfoot"), HERE)
    found = following(HUMANOID, 0, 3, ALL, (pin,))
    assert found.root_moves and names(found.movable) == {"leftfoot", "leftleg", "leftthigh"}


def test_kept_limbs_and_locked_joints_never_follow():
    locks = (JointLock(index("rightforearm")), Band(index("leftfoot"), HERE), JointLock(0))
    found = following(HUMANOID, index("righthand"), 0, ALL - {index("spine")}, locks)
    assert names(found.movable) == {"righthand", "rightupperarm"} and not found.root_moves
