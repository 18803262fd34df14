"""The thesis's own programs: the squat of appendix A with either main link, and the clock of chapter 4."""

import re
from functools import cache

import numpy as np
import pytest

from layfigure.kinematics.forward import place
from layfigure.language import run_script
from layfigure.language.programme import run_text


@cache
def shot(path):
    """Return the one scene of a shipped script."""
    (scene,) = run_script(path).scenes
    return scene


def stands(actor, name: str) -> tuple[np.ndarray, np.ndarray]:
    """Return where a limb's joint is and how the limb is turned, left-handed."""
    placed = place(actor.figure, actor.angles[None], actor.translation[None])
    index = actor.figure.index(name)
    return placed.origins[0, index], placed.limb_to_world[0, index]


def test_six_figures_squat_progressively_in_one_picture_with_a_foot_fixed_to_the_ground(scripts):
    (picture,) = shot(scripts / "squat.lay").pictures
    assert len(picture.actors) == 6
    foot, turn = stands(picture.actors[0], "FOOT")
    heights = [stands(actor, "TORSO")[0][1] for actor in picture.actors]
    for image, actor in enumerate(picture.actors):
        at, turned = stands(actor, "FOOT")
        assert np.abs(at - foot - [1.2 * image, 0, 0]).max() < 1e-9
        assert np.abs(turned - turn).max() < 1e-9
    assert (np.diff(heights) < 0).all()
    assert heights[0] - heights[5] > 0.5


def test_with_the_torso_as_main_link_the_feet_rise(scripts):
    (picture,) = shot(scripts / "squat-torso.lay").pictures
    torsos = [stands(actor, "TORSO")[0][1] for actor in picture.actors]
    feet = [stands(actor, "FOOT")[0][1] for actor in picture.actors]
    assert np.ptp(torsos) < 1e-9
    assert (np.diff(feet) > 0).all()
    assert feet[5] - feet[0] > 0.5


def test_both_squats_are_the_same_movement_seen_from_two_links(scripts):
    pairs = zip(*(shot(scripts / name).pictures[0].actors for name in ("squat.lay", "squat-torso.lay")), strict=True)
    for one, other in pairs:
        assert np.array_equal(one.angles[1:], other.angles[1:])


def hand(path_or_scene, name: str) -> np.ndarray:
    """Return the angles (f,) of a hand of the clock in every picture."""
    return np.array(
        [picture.actors[0].angles[picture.actors[0].figure.index(name), 2] for picture in path_or_scene.pictures]
    )


def test_the_hands_run_two_hours_in_two_minutes_of_film(scripts):
    scene = shot(scripts / "clock.lay")
    assert len(scene.pictures) == 2 * 60 * 24 + 1
    minute, hour = hand(scene, "minute_hand"), hand(scene, "hour_hand")
    assert not scene.clamps
    assert minute[::24] == pytest.approx(np.arange(121) * 6.0)
    assert hour[::24] == pytest.approx(np.arange(121) * 0.5)
    assert (np.diff(minute) > 0).all()


def test_the_hands_run_clockwise_as_seen(scripts):
    quarter_past = shot(scripts / "clock.lay").pictures[360]
    (clock,) = quarter_past.actors
    _, turn = stands(clock, "minute_hand")
    tip = turn @ np.array([0.0, 1.0, 0.0])
    right, up, _ = np.array(quarter_past.camera.rotation)
    assert right @ tip == pytest.approx(1.0)
    assert up @ tip == pytest.approx(0.0, abs=1e-9)


def test_mod_of_the_listing_swings_the_hand_back_a_whole_turn_at_the_hour(scripts):
    text = (scripts / "clock.lay").read_text(encoding="utf-8")
    literal = text.replace("    angle = (0, 0, angle_z)", "    angle_z = angle_z MOD 360\n    angle = (0, 0, angle_z)")
    (scene,) = run_text(literal, scripts / "clock.lay").scenes
    minute = hand(scene, "minute_hand")
    assert minute[59 * 24] == pytest.approx(354.0)
    assert minute[60 * 24] == pytest.approx(0.0)
    back = np.diff(minute[59 * 24 : 60 * 24 + 1])
    assert (back < 0).all()
    assert minute[61 * 24] == pytest.approx(6.0)


def test_the_tour_runs_without_a_warning_and_within_limits(scripts):
    programme = run_script(scripts / "tour.lay")
    assert programme.warnings == ()
    assert len(programme.scenes[0].pictures) == 85
    assert re.search("the greeting takes 60 frames", programme.printed[0])


def test_ten_times_hop_skip_and_jump_plays_without_a_seam(run):
    load = 'load "humanoid"; load "hop"; load "skip"; load "jump"\n'
    scene = "INITIALIZE SCENE 1\nSTARTSCENE LENGTH 300\nANIMATE humanoid USING new_walk REPEAT\nENDSCENE\nSHOOTSCENES"
    programme = run(f"{load}new_walk = 10 * (hop + skip + jump)\nPRINT jump(hop + skip + jump)\n{scene}")
    assert programme.printed == ("0",)
    assert programme.warnings == ()
