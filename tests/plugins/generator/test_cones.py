"""Cones: where limbs can go next."""

from __future__ import annotations

import numpy as np
import pytest

from layfigure.figures.figure import Figure
from layfigure.kinematics.forward import limb_ends, place_pose
from layfigure.poses.locks import JointLock
from layfigure.techniques.contract import Control, EnabledSet, Event, LocksSet
from layfigure_plugins.generator.cones import cones
from layfigure_plugins.generator.generator import Generator
from layfigure_plugins.generator.state import GeneratorState, mutated
from layfigure_plugins.generator.stream import Stream


def told(generator: Generator, state: GeneratorState, *events: Event) -> GeneratorState:
    for event in events:
        state = generator.tell(state, event)
    return state


def only(generator: Generator, figure: Figure, state: GeneratorState, limb: str, *events: Event) -> GeneratorState:
    return told(generator, state, *events, EnabledSet(frozenset({figure.index(limb)})))


def test_every_mark_is_a_path_of_the_cones_role(generator: Generator, opening: GeneratorState) -> None:
    marks = tuple(generator.ask(told(generator, opening, Control("intensity", 30))).cones())
    assert {mark.role for mark in marks} == {"cone"}
    assert all(len(mark.points) > 1 and np.isfinite(mark.points).all() for mark in marks)


def test_disabled_and_locked_joints_have_no_cone(
    generator: Generator, humanoid: Figure, opening: GeneratorState
) -> None:
    neck = only(generator, humanoid, opening, "neck")
    assert 1 < len(cones(humanoid, neck)) <= 6
    assert cones(humanoid, told(generator, neck, LocksSet((JointLock(humanoid.index("neck")),)))) == ()
    assert cones(humanoid, told(generator, opening, EnabledSet(frozenset()))) == ()
    assert cones(humanoid, told(generator, opening, Control("intensity", 0))) == ()


@pytest.mark.parametrize("limb", ["leftthigh", "spine", "righthand", "leftfoot"])
def test_a_cone_opens_from_the_joint_round_all_that_the_next_page_shows(
    generator: Generator, humanoid: Figure, opening: GeneratorState, limb: str
) -> None:
    state = only(generator, humanoid, opening, limb, Control("intensity", 20))
    index = humanoid.index(limb)
    placement = place_pose(humanoid, state.seed)
    joint, tip = placement.origins[index], limb_ends(humanoid, placement)[index]
    rim, *spokes = (np.array(mark.points) for mark in cones(humanoid, state))
    length = np.linalg.norm(tip - joint)
    np.testing.assert_allclose(np.linalg.norm(rim - joint, axis=1), length, rtol=1e-6)
    assert (rim[0] == rim[-1]).all()
    assert all((spoke[0] == joint).all() and spoke[1].tolist() in rim.tolist() for spoke in spokes)
    shown = Stream.of(humanoid, mutated(state).generation).poses(range(9))
    widest = np.min((rim - joint) @ (tip - joint))
    for pose in shown:
        there = limb_ends(humanoid, place_pose(humanoid, pose))[index]
        assert (there - joint) @ (tip - joint) >= widest - 1e-6 * length**2


def test_a_higher_intensity_opens_the_cone(generator: Generator, humanoid: Figure, opening: GeneratorState) -> None:
    sizes = []
    for intensity in (5, 15, 30):
        state = only(generator, humanoid, opening, "leftupperarm", Control("intensity", intensity))
        sizes.append(float(np.ptp(np.array(cones(humanoid, state)[0].points), axis=0).max()))
    assert sizes == sorted(sizes)
    assert sizes[0] < sizes[2]


def test_a_hinge_has_a_fan_and_twist_a_dial(generator: Generator, humanoid: Figure, opening: GeneratorState) -> None:
    hinge = only(generator, humanoid, opening, "rightleg", Control("intensity", 30))
    (fan,) = cones(humanoid, hinge)
    assert np.ptp(np.array(fan.points)[:, 0]) < 1e-9  # flexion stays in its plane
    turned = only(generator, humanoid, opening, "rightthigh", Control("intensity", 30), Control("kind", "twist"))
    dial, hand = cones(humanoid, turned)
    assert np.ptp(np.array(dial.points)[:, 1]) < 1e-9  # round the hanging thigh
    assert len(hand.points) == 2
