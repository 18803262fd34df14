"""Films: reels in order, parts of them, and pictures chosen from them."""

from fractions import Fraction
from itertools import pairwise

from hypothesis import given
from hypothesis import strategies as st

from layfigure_frontends.film.reel import evenly
from layfigure_frontends.film.timing import whole_delays

from .conftest import Disc, film_of


def test_a_part_keeps_the_numbers_of_the_whole():
    first, second = Disc(4, "a"), Disc(5, "b")
    part = film_of(first, second).part(3, 6)
    list(part.run())
    assert (first.drawn, second.drawn) == ([3], [0, 1])
    assert part.first == 3
    assert part.part(4, 5).first == 4
    assert len(part.part(4, 5)) == 1


def test_a_part_beyond_the_end_is_empty_and_has_no_reels():
    assert film_of(Disc(4)).part(4, 9).reels == ()


def test_chosen_pictures_come_from_the_reels_they_are_in():
    first, second = Disc(4, "a"), Disc(5, "b")
    assert len(list(film_of(first, second).chosen([0, 3, 4, 8]))) == 4
    assert (first.drawn, second.drawn) == ([0, 3], [0, 4])


@given(st.integers(1, 500), st.integers(2, 60))
def test_evenly_chosen_places_ascend_from_the_first_to_the_last_in_like_steps(count, most):
    places = evenly(count, most)
    steps = {b - a for a, b in pairwise(places)}
    assert places[0] == 0
    assert places[-1] == count - 1
    assert len(places) == min(count, most)
    assert max(steps, default=1) - min(steps, default=1) <= 1
    assert min(steps, default=1) >= 1


rates = st.fractions(Fraction(1, 100), 1000, max_denominator=1001)


@given(st.integers(1, 400), rates, st.sampled_from([100, 1000]))
def test_whole_delays_never_stray_more_than_half_a_unit(count, rate, per_second):
    shown = 0
    for number, delay in enumerate(whole_delays(count, rate, per_second), start=1):
        shown += delay
        assert abs(shown - number * per_second / rate) <= Fraction(1, 2)
        assert delay >= 0
