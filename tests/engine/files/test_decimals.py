"""Numbers as they are written."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from layfigure.files.decimals import plain


@pytest.mark.parametrize(("value", "text"), [(-1e-9, "0"), (-0.0, "0"), (12.0, "12"), (0.25, "0.25"), (-3.5, "-3.5"),
                                             (1e-6, "0.000001"), (1234567.5, "1234567.5"), (100.0, "100")])  # fmt: skip
def test_a_number_is_as_short_as_says_the_same(value, text):
    assert plain(value) == text


def test_what_rounds_to_nothing_has_no_sign():
    assert (plain(-0.04, 1), plain(-0.06, 1)) == ("0", "-0.1")


@given(st.floats(-1e6, 1e6))
def test_it_reads_back_to_the_last_decimal_and_nothing_says_minus_nothing(value):
    text = plain(value)
    assert abs(float(text) - value) <= 5e-7 and text != "-0" and "e" not in text
