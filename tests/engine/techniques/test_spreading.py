"""Farthest-point sampling."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from layfigure.techniques.spreading import far_apart

POINTS = st.integers(0, 12).flatmap(lambda n: arrays(np.float64, (n, 3), elements=st.floats(-50, 50, width=32)))


def test_the_farthest_come_first_and_the_order_is_kept() -> None:
    points = np.array([[1.0], [2.0], [10.0], [9.0], [-4.0]])
    assert far_apart(points, np.array([[0.0]]), 2, 0.0) == [2, 4]


def test_what_is_near_to_what_is_taken_is_left_out() -> None:
    points = np.array([[1.0], [5.0], [5.5], [10.0]])
    assert far_apart(points, np.array([[0.0]]), 4, 2.0) == [1, 3]


def test_of_equals_the_first_is_taken() -> None:
    assert far_apart(np.array([[3.0], [-3.0], [3.0]]), np.array([[0.0]]), 1, 0.0) == [0]


@given(points=POINTS, taken=POINTS, most=st.integers(0, 9), least=st.floats(0.001, 40))
def test_what_is_chosen_is_apart(points: np.ndarray, taken: np.ndarray, most: int, least: float) -> None:
    rows = far_apart(points, taken, most, least)
    assert len(rows) <= most
    assert rows == sorted(set(rows))
    for number, row in enumerate(rows):
        others = np.concatenate([taken, points[rows[:number]]])
        assert (np.linalg.norm(others - points[row], axis=1) >= least - 1e-5).all()
