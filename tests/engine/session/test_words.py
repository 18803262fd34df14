"""Command lines are split into words that know their columns, and joined back."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from layfigure.session.words import WordError, join_line, number, split_line, whole_number


def test_a_line_knows_the_column_of_every_word():
    line = split_line('  pick 3 "left hand"  # a comment')
    assert line is not None
    assert (line.name, line.words, line.columns) == ("pick", ("3", "left hand"), (3, 8, 10))


@pytest.mark.parametrize("text", ["", "   ", "# only a comment", "\t# x"])
def test_a_line_that_says_nothing_is_none(text):
    assert split_line(text) is None


def test_an_open_quote_is_refused_with_its_word():
    with pytest.raises(WordError, match="quote") as caught:
        split_line('save "my pose')
    assert caught.value.index == 1


def test_absurdly_many_words_are_refused():
    with pytest.raises(WordError, match="more than"):
        split_line("pick " + "a " * 5000)


@given(st.lists(st.text(st.characters(blacklist_categories=["Cs", "Cc", "Zl", "Zp"])), max_size=6))
def test_what_is_joined_splits_back(words):
    line = split_line(join_line("command", words))
    assert line is not None and line.words == tuple(words)


@pytest.mark.parametrize("word", ["nan", "inf", "1e999", "x", "1e10"])
def test_a_number_must_be_finite_and_sane(word):
    with pytest.raises(WordError) as caught:
        number((word,), 0, "an angle")
    assert caught.value.index == 1


def test_a_missing_word_says_what_is_wanted():
    with pytest.raises(WordError, match="a candidate is wanted here"):
        whole_number((), 0, "a candidate", (1, 9))
