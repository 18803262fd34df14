"""Joints about x, y and z: swings and twists about the limb, converted, and tested against limits in x, y, z."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from tests.plugins.axis_figures import AXIS_FIGURES, axis_figure, beyond_limits
from tests.plugins.generator.conftest import PlainBench

from layfigure.figures.figure import Figure
from layfigure.figures.library import read_figure
from layfigure.kinematics.forward import limb_ends, place_pose
from layfigure.kinematics.joints import about_axes
from layfigure.kinematics.swing import rotations
from layfigure.poses.pose import Pose
from layfigure.techniques.contract import Control, LimbPick, Setting
from layfigure_plugins.generator.alternatives import FARTHEST, SWING, TWIST, Rule, alternatives, freedoms, reach_of
from layfigure_plugins.generator.cones import cones
from layfigure_plugins.generator.generator import Generator
from layfigure_plugins.generator.state import GeneratorState, mutated

WIDE = "xdof -360 360 ydof -360 360 zdof -360 360"
FREE = "axis y flexionaxis x flexiondof -180 180 pivotdof -180 180 twistdof -180 180"
ZERO = np.zeros(3)


@cache
def lever(dofs: str, end: str = "0 1 0") -> Figure:
    """Return a figure of one joint."""
    before, after = (dofs, "") if dofs.startswith("axis") else ("", dofs)
    words = before.split(" flexiondof")
    text = f"{words[0]} 0 0 0 {end} {'flexiondof' + words[1] if before else after}"
    return read_figure("lever", f"base {{ 0 0 0 0 0 0 joint 0 0 0 arm {{ {text} }} }}", "lever.fig")


def offered(figure: Figure, rule: Rule, seed: tuple[float, float, float] = (0, 0, 0)) -> np.ndarray:
    return alternatives(figure, 1, np.array(seed, dtype=np.float64), rule)


def opened(name: str) -> tuple[Generator, GeneratorState]:
    figure = axis_figure(name)
    generator = Generator.on(PlainBench(figure))
    return generator, generator.start(Setting(Pose.rest(figure), frozenset(figure.movable), fresh=True))


def alike(a: np.ndarray, b: np.ndarray) -> bool:
    """Whether two heaps of arrays (n, ...) are the same but for their order."""
    flat, other = (np.round(heap.reshape(len(heap), -1), 5) + 0.0 for heap in (a, b))
    return flat.shape == other.shape and np.allclose(*(rows[np.lexsort(rows.T)] for rows in (flat, other)), atol=1e-4)


@pytest.mark.parametrize("kind", [SWING, TWIST])
@pytest.mark.parametrize("intensity", [10.0, 45.0, 100.0])
def test_a_free_joint_shows_the_same_turns_whichever_way_its_angles_are_meant(kind: str, intensity: float) -> None:
    rule = Rule(kind, reach=reach_of(intensity))
    about = about_axes(offered(lever(WIDE), rule))
    swinging = lever(FREE)
    frame = swinging.arrays.frames[1]
    assert alike(about, frame @ rotations(offered(swinging, rule)) @ frame.T)


@settings(max_examples=40, deadline=None)
@given(seed=st.tuples(*[st.floats(-170, 170)] * 3), intensity=st.sampled_from([8.0, 40.0, 100.0]))
def test_a_twist_leaves_where_the_limb_points_and_a_swing_its_twist(
    seed: tuple[float, float, float], intensity: float
) -> None:
    end = np.array([1.0, 2.0, -3.0]) / np.sqrt(14.0)
    figure = lever(WIDE, "1 2 -3")
    here = about_axes(seed)
    for angles in offered(figure, Rule(TWIST, reach=reach_of(intensity)), seed):
        np.testing.assert_allclose(about_axes(angles) @ end, here @ end, atol=1e-6)
    swings = offered(figure, Rule(SWING, reach=reach_of(intensity)), seed)
    assume(here @ end @ end > -0.99)  # straight backwards every twist is another swing
    kept = [_twist_free(end, turned) for turned in about_axes(swings) if turned @ end @ end > -0.99]
    np.testing.assert_allclose(kept, [_twist_free(end, here)] * len(kept), atol=1e-5)


def _twist_free(end: np.ndarray, rotation: np.ndarray) -> np.ndarray:
    """Return a rotation without its swing: the shortest one from ``end`` to where it is brought is taken back."""
    there = rotation @ end
    axis, cosine = np.cross(end, there), float(end @ there)
    x, y, z = axis
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return (np.eye(3) + cross + cross @ cross / (1.0 + cosine)).T @ rotation


def test_two_swinging_angles_point_the_limb_wherever_a_swing_would_if_they_reach_it() -> None:
    thigh = lever("xdof -360 360 zdof -360 360")
    rule = Rule(SWING, reach=FARTHEST)
    pointed = about_axes(offered(thigh, rule))[:, :, 1]
    assert alike(pointed, about_axes(offered(lever(WIDE), rule))[:, :, 1])
    slanted = offered(lever("xdof -360 360 zdof -360 360", "3 4 0"), rule)  # its x axis is not across the limb
    assert len(slanted) >= 9
    assert not slanted[:, 1].any()


def test_two_angles_have_no_twist_and_one_about_the_limb_has_no_swing() -> None:
    assert freedoms(lever("xdof -90 90 zdof -90 90"), 1, TWIST) == 0
    assert freedoms(lever("ydof -90 90"), 1, SWING) == 0
    assert freedoms(lever("ydof -90 90"), 1, TWIST) == 1
    neck = lever("xdof -90 90 ydof -60 60")
    assert not offered(neck, Rule(SWING, within_limits=True))[:, 1:].any()
    assert not offered(neck, Rule(TWIST, within_limits=True))[:, [0, 2]].any()


def test_a_single_angle_goes_round_the_half_circle() -> None:
    hinge = offered(lever("xdof -135 0"), Rule(SWING, within_limits=True))
    assert hinge[:3].tolist() == [[-90, 0, 0], [-45, 0, 0], [-135, 0, 0]]
    assert not hinge[:, 1:].any()


def test_angles_are_brought_into_wide_limits_by_whole_turns() -> None:
    rule = Rule(SWING, within_limits=True)
    hand = offered(lever("zdof 0 720"), rule)
    assert (hand[:, 2] >= 0).all()
    assert {90.0, 180.0, 270.0} <= set(hand[:, 2])
    later = offered(lever("zdof 0 720"), Rule(SWING, within_limits=True, reach=reach_of(10)), (0, 0, 540))
    assert len(later) >= 9
    assert np.abs(later[:, 2] - 540.0).max() <= 17.0
    beyond = offered(lever("xdof 200 380 ydof 170 200 zdof 160 260"), rule, (210, 180, 190))
    assert len(beyond) >= 9
    assert (beyond >= [200, 170, 160]).all()
    assert (beyond <= [380, 200, 260]).all()


def test_the_seed_stands_for_itself_to_the_last_digit_where_it_is_the_only_one() -> None:
    stiff = lever("xdof 0 1 ydof 0 1 zdof 0 1")
    assert offered(stiff, Rule(SWING, within_limits=True)).tolist() == [[0, 0, 0]]
    assert offered(lever("xdof 1 2"), Rule(SWING, within_limits=True), (1.5, 0, 0)).tolist() == []


@pytest.mark.parametrize("name", AXIS_FIGURES)
def test_the_first_generation_fills_pages_of_nine_within_limits(name: str) -> None:
    generator, state = opened(name)
    figure = generator.figure
    for page in range(3):
        poses = generator.ask(state).candidates
        assert len(set(poses)) == 9
        for pose in poses:
            assert beyond_limits(figure, pose.angles) <= 0.0
            assert not pose.angles[1:][~figure.arrays.has_dof[1:]].any()
            np.testing.assert_array_equal(pose.euler, figure.arrays.euler)
        state = generator.tell(state, Control("next")) if page < 2 else state


@pytest.mark.parametrize("kind", [SWING, TWIST])
def test_generations_that_keep_to_the_limits_do_so_round_any_pose(kind: str) -> None:
    generator, state = opened("puppet")
    figure = generator.figure
    for word in (Control("within-limits", True), Control("kind", kind), Control("intensity", 30.0)):
        state = generator.tell(state, word)
    for _ in range(4):
        state = generator.tell(state, LimbPick(4, tuple(figure.movable)))
        state = generator.tell(state, Control("mutate"))
        assert all(beyond_limits(figure, pose.angles) <= 0.0 for pose in generator.ask(state).candidates)


def test_twins_turn_alike_and_so_look_like_mirror_images() -> None:
    generator, state = opened("puppet")
    for pose in generator.ask(state).candidates:
        for limb in generator.figure.limbs:
            assert (pose.angles[limb.index] == pose.angles[limb.twin]).all()


def test_a_picked_limb_keeps_the_numbers_that_it_was_shown_with() -> None:
    generator, state = opened("puppet")
    limb = generator.figure.index("leftupperarm")
    shown = generator.ask(state).candidates[5]
    picked = generator.tell(state, LimbPick(5, (limb,)))
    assert all((pose.angles[limb] == shown.angles[limb]).all() for pose in generator.ask(picked).candidates)
    assert (generator.recommend(picked).angles[limb] == shown.angles[limb]).all()
    again = generator.tell(generator.tell(picked, Control("intensity", 0.0)), Control("mutate"))
    assert generator.ask(again).candidates[0] == generator.recommend(again)


def test_what_cannot_bend_or_twist_is_said() -> None:
    generator, state = opened("puppet")
    assert "handle cannot bend" in generator.ask(state).note
    twisted = generator.tell(generator.tell(state, Control("kind", TWIST)), Control("mutate"))
    assert "cannot twist" in generator.ask(twisted).note


@pytest.mark.parametrize("kind", [SWING, TWIST])
def test_cones_open_round_the_limbs_that_can_turn(kind: str) -> None:
    generator, state = opened("puppet")
    figure = generator.figure
    for word in (Control("kind", kind), Control("intensity", 25.0)):
        state = generator.tell(state, word)
    able = [limb for limb in np.flatnonzero(figure.arrays.euler).tolist() if freedoms(figure, limb, kind)]
    placement = place_pose(figure, state.seed)
    ends = limb_ends(figure, placement)
    for limb in able:
        marks = cones(figure, _alone(state, limb))
        points = np.array([point for mark in marks for point in mark.points])
        assert np.isfinite(points).all()
        hub = placement.origins[limb] if kind == SWING else ends[limb]
        assert np.linalg.norm(points - hub, axis=1).min() <= 1e-5
        if kind == SWING:
            length = np.linalg.norm(ends[limb] - placement.origins[limb])
            rim = np.linalg.norm(points - placement.origins[limb], axis=1)
            np.testing.assert_allclose(rim[rim > 1e-5], length, atol=1e-5)
    assert able
    assert mutated(state).generation.enabled == frozenset(figure.movable)


def _alone(state: GeneratorState, limb: int) -> GeneratorState:
    """Return a state in which one limb alone may change."""
    return replace(state, enabled=frozenset({limb}))
