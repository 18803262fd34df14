"""The order in which goals are proposed."""

from __future__ import annotations

import numpy as np

from layfigure_plugins.hybrid.directions import ROUND, directions, way_of, ways


def test_the_first_directions_go_along_one_axis_front_and_back_then_side_then_up() -> None:
    assert directions()[:6].tolist() == [[0, 0, -1], [0, 0, 1], [1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0]]


def test_directions_are_66_different_unit_vectors_all_round() -> None:
    points = directions()
    assert np.allclose(np.linalg.norm(points, axis=1), 1)
    assert len(np.unique(np.round(points, 6), axis=0)) == len(points) == 66
    assert np.allclose(points.sum(axis=0), 0)


def test_outward_and_inward_stand_beside_each_other() -> None:
    points = directions()
    sideways = np.flatnonzero(np.abs(points[:, 0]) > 1e-9)
    outward, inward = points[sideways[::2]], points[sideways[1::2]]
    assert np.allclose(outward * [-1, 1, 1], inward)
    assert (outward[:, 0] > 0).all()
    assert (np.diff(sideways)[::2] == 1).all()


def test_the_first_end_goes_through_the_ways_in_their_order() -> None:
    assert [way_of(number, 0).tolist() for number in range(len(ways()))] == ways().tolist()


def test_every_end_looks_into_every_direction_once_a_round() -> None:
    for place in range(8):
        for first in range(0, len(ways()), ROUND):
            seen = {tuple(way_of(first + step, place)) for step in range(ROUND)}
            assert seen == {tuple(way) for way in ways()[first : first + ROUND]}


def test_no_two_ends_always_go_the_same_way() -> None:
    for place in range(1, 12):
        for other in range(place):
            alike = [np.array_equal(way_of(number, place), way_of(number, other)) for number in range(ROUND)]
            assert sum(alike) < ROUND / 2
