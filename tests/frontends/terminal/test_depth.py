"""Colours and pictures are chosen by what the environment says and by what the terminal answers, never by its name."""

import pytest

from layfigure.errors import LayfigureError
from layfigure_frontends.terminal.depth import (
    QUERY_NUMBER,
    Abilities,
    Depth,
    Picture,
    choose_depth,
    is_nested,
    is_plain,
    queries,
)
from layfigure_frontends.terminal.parser import Parser

ENVIRONMENTS = [
    ({"TERM": "xterm-256color", "COLORTERM": "truecolor"}, Depth.TRUE),
    ({"TERM": "xterm-256color"}, Depth.COLOURS_256),
    ({"TERM": "xterm-direct"}, Depth.TRUE),
    ({"TERM": "tmux"}, Depth.COLOURS_256),
    ({"TERM": "xterm"}, Depth.CLASSES_16),
    ({"TERM": "linux"}, Depth.CLASSES_16),
    ({"WT_SESSION": "1"}, Depth.TRUE),
    ({"OS": "Windows_NT"}, Depth.TRUE),
    ({"TERM": "screen", "STY": "1.tty", "COLORTERM": "truecolor"}, Depth.COLOURS_256),
    ({"TERM": "xterm-256color", "COLORTERM": "truecolor", "NO_COLOR": "1"}, Depth.MONO),
    ({"TERM": "xterm-256color", "NO_COLOR": ""}, Depth.COLOURS_256),
]
ALL_ANSWERS = (
    b"\x1b[?2026;2$y\x1b[?0u\x1b[6;16;8t\x1b[?1;0;256S\x1bP>|Term 1\x1b\\\x1b_Gi=%d;OK\x1b\\\x1b[?62;4c" % QUERY_NUMBER
)


def abilities(answers):
    told = Abilities()
    for reply in Parser().feed(answers, 0.0):
        told = told.told(reply)
    return told


@pytest.mark.parametrize(("environment", "depth"), ENVIRONMENTS)
def test_the_environment_says_how_many_colours_there_are(environment, depth):
    assert choose_depth(environment) == depth


def test_the_option_wins_over_the_environment_and_a_wrong_word_is_told():
    assert choose_depth({"NO_COLOR": "1"}, "truecolor") == Depth.TRUE
    assert choose_depth({"COLORTERM": "truecolor"}, "never") == Depth.MONO
    with pytest.raises(LayfigureError, match='did you mean "truecolor"'):
        choose_depth({}, "truecolour")


def test_only_lines_of_text_go_to_a_dumb_terminal_or_a_pipe():
    assert is_plain({"TERM": "dumb"}, terminals=True)
    assert is_plain({}, terminals=True)
    assert is_plain({"TERM": "xterm"}, terminals=False)
    assert not is_plain({"TERM": "xterm"}, terminals=True)
    assert not is_plain({"OS": "Windows_NT"}, terminals=True)


def test_nothing_is_believed_before_it_is_said():
    assert Abilities().picture({}) == Picture.CELLS
    assert abilities(b"abc\x1b[A").picture({}) == Picture.CELLS


def test_kitty_graphics_come_before_sixel_and_sixel_before_cells():
    told = abilities(ALL_ANSWERS)
    assert told == Abilities(True, True, True, True, 256, (8, 16))
    assert told.picture({}) == Picture.KITTY
    assert abilities(ALL_ANSWERS.replace(b";OK", b";EINVAL")).picture({}) == Picture.SIXEL
    assert abilities(ALL_ANSWERS.replace(b";OK", b";EINVAL").replace(b";4c", b"c")).picture({}) == Picture.CELLS


@pytest.mark.parametrize("environment", [{"TMUX": "/tmp/x"}, {"STY": "1"}, {"TERM": "screen-256color"}])
def test_inside_tmux_and_screen_cells_are_drawn_unless_pictures_are_forced(environment):
    assert is_nested(environment)
    assert abilities(ALL_ANSWERS).picture(environment) == Picture.CELLS
    assert abilities(ALL_ANSWERS).picture(environment, "sixel") == Picture.SIXEL
    assert b"_G" not in queries(environment)


def test_a_wrong_word_for_graphics_is_told():
    with pytest.raises(LayfigureError, match='did you mean "kitty"'):
        Abilities().picture({}, "kity")


def test_the_linux_console_is_asked_nothing_that_it_would_print():
    assert b"_G" not in queries({"TERM": "linux"})
    assert b"_G" in queries({"TERM": "xterm-kitty"})
    assert queries({"TERM": "linux"}).endswith(b"\x1b[c")
