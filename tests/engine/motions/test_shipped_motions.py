"""The ready motions of the humanoid: they play without seams, within limits, on the ground."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest

from layfigure import resources
from layfigure.figures.library import load_figure
from layfigure.kinematics.forward import place
from layfigure.motions.motion import Motion
from layfigure.motions.motion_file import load_motion
from layfigure.motions.sampling import Sampled, sample
from layfigure.motions.seams import seams

NAMES = ("breathe", "hop", "jump", "nod", "run", "skip", "squat", "walk", "wave")
GROUND = -100.0  # of the humanoid's soles at rest
HUMANOID = load_figure("humanoid")


def shipped(name: str) -> Motion:
    return load_motion(resources.data("motions", f"{name}.motion")).motion


def sampled(motion: Motion) -> Sampled:
    return sample(HUMANOID, motion, [Fraction(i, 4) for i in range(int(motion.duration) * 4 + 1)])


def soles(found: Sampled) -> np.ndarray:
    """Return the corners of both soles, (f, 8, 3)."""
    placed = place(HUMANOID, found.angles, found.translations)
    corners = []
    for name in ("rightfoot", "leftfoot"):
        limb = HUMANOID.index(name)
        volume = int(np.flatnonzero(HUMANOID.arrays.volume_limbs == limb)[0])
        a, _, c, d = HUMANOID.arrays.volume_points[volume]
        points = np.stack([a, c, d, c + d - a])
        turned = np.einsum("fij,cj->fci", placed.limb_to_world[:, limb], points)
        corners.append(placed.origins[:, limb, None] + turned)
    return np.concatenate(corners, axis=1)


def test_all_the_promised_motions_are_there() -> None:
    assert {path.stem for path in resources.data("motions").glob("*.motion")} == set(NAMES)


def test_ten_times_hop_skip_and_jump_has_no_seam_above_one_degree() -> None:
    new_walk = 10 * (shipped("hop") + shipped("skip") + shipped("jump"))
    report = seams(new_walk)
    assert len(report.seams) >= 29
    assert report.jump <= 1.0


@pytest.mark.parametrize("name", NAMES)
def test_a_motion_can_be_repeated_without_a_jump(name: str) -> None:
    assert seams(2 * shipped(name)).jump <= 1.0


@pytest.mark.parametrize("name", NAMES)
def test_no_joint_is_clamped(name: str) -> None:
    assert sampled(shipped(name)).clamps.clamped == 0


@pytest.mark.parametrize("name", NAMES)
def test_feet_stay_above_the_ground(name: str) -> None:
    assert soles(sampled(shipped(name)))[..., 1].min() > GROUND - 1.5


@pytest.mark.parametrize("name", ["walk", "squat", "jump"])
def test_what_touches_the_ground_does_not_slide(name: str) -> None:
    points = soles(sampled(shipped(name)))
    stays = (points[1:, :, 1] < GROUND + 0.2) & (points[:-1, :, 1] < GROUND + 0.2)
    slid = np.abs(points[1:, :, 2] - points[:-1, :, 2])[stays]
    assert np.median(slid) < 0.3
    assert slid.max() < 3.0


def test_ten_strides_walk_ten_times_as_far_as_one() -> None:
    one, ten = (sampled(n * shipped("walk")).translations[-1, 2] for n in (1, 10))
    assert one < -150
    assert ten == pytest.approx(10 * one, rel=1e-6)
