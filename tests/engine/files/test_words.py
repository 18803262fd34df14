"""Reading a small language word by word."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from layfigure.errors import LayfigureError, SourceError
from layfigure.figures.fig_language import parse_fig
from layfigure.files.words import WordReader
from layfigure.poses.pose_file import read_pose


def test_words_come_in_order_and_then_the_end_again_and_again():
    words = WordReader("a{ 1.5#x }\n} b", "text")
    assert [words.take().text for _ in range(7)] == ["a", "{", "1.5", "}", "b", "", ""]


def test_the_end_of_a_line_is_a_word_where_lines_matter():
    words = WordReader("a # b\n\nc", "text", lines=True)
    assert [words.take().text for _ in range(5)] == ["a", "\n", "\n", "c", ""]


@pytest.mark.parametrize("text", ["1", "-1", "+1", "1.", ".5", "-1.5e3", "1E-3", "-0"])
def test_a_decimal_number_is_read(text):
    assert repr(WordReader(text, "text").number("it")) == repr(float(text) + 0.0)


@pytest.mark.parametrize("text", ["", "x", "nan", "inf", "1e", "--1", "0x1", "1_0", "1,5", "٣", "1e7", "1e999"])
def test_anything_else_is_refused(text):
    with pytest.raises(SourceError):
        WordReader(text, "text").number("it")


@given(st.text() | st.text(alphabet="axisjoint{}0123456789 \n#-.e"))
def test_no_text_makes_the_readers_stumble(text):
    for read in (lambda: parse_fig(text, "text"), lambda: read_pose(text, "text.pose")):
        try:
            read()
        except LayfigureError as error:
            assert str(error).isprintable()
