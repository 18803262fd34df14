"""The hyper-tessellated half circle of half-angles."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from layfigure.tessellation.half_circle import LEVELS, half_circle, level_size


def test_each_level_doubles_the_alternatives() -> None:
    sizes = [level_size(level) for level in range(LEVELS)]
    assert sizes == [2, 4, 8, 16, 32, 64, 128]
    assert np.cumsum(np.bincount(half_circle().levels)).tolist() == sizes


def test_half_angles_are_multiples_of_ninety_degrees_over_a_power_of_two() -> None:
    for level in range(LEVELS):
        steps = half_circle().angles[: level_size(level)] / 2 / (90 / 2**level)
        np.testing.assert_array_equal(steps, np.rint(steps))


def test_half_a_turn_counts_once() -> None:
    angles = half_circle().angles
    assert 180.0 in angles
    assert angles.min() > -180.0
    assert len(set(angles)) == len(angles)


@given(st.floats(-720, 720), st.integers(0, LEVELS - 1))
def test_nearest_finds_what_looking_at_every_point_finds(angle: float, level: int) -> None:
    circle = half_circle()
    away = np.abs((circle.angles[: level_size(level)] - angle + 180) % 360 - 180)
    found = circle.nearest(angle, level)
    assert found < level_size(level)
    assert away[found] <= away.min() + 1e-9


def test_tables_are_read_only() -> None:
    assert not half_circle().angles.flags.writeable
    assert not half_circle().levels.flags.writeable
