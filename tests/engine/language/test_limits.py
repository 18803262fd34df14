"""A stranger's script can neither hang nor fill the machine: every bound is told by its name."""

from dataclasses import fields

import pytest

from layfigure.errors import LimitError, SourceError
from layfigure.language.limits import Limits

BOX = "o :- BOX WIDTH 1, HEIGHT 1, DEPTH 1\n"
KEY = "m[1, 1] = FRAME 5 POSITION 1, 2, 3\n"
SCENE = "INITIALIZE SCENE 1\nSTARTSCENE LENGTH {}\n{}\nENDSCENE\nSHOOTSCENES\n"


@pytest.mark.parametrize(
    ("text", "option"),
    [
        ("WHILE TRUE\nx = 1\nENDWHILE", "steps"),
        ("FOR i = 1 TO 10 ** 100\nENDFOR", "steps"),
        (f"{BOX}WHILE TRUE\no :- o <ROTATE X 1>\nENDWHILE", "steps"),
        (f"{BOX}p :- o; j :- JOINT 1, o, (0,0,0), p, (0,0,0)\nWHILE TRUE\nj :- j <SCALE MODEL 1>\nENDWHILE", "steps"),
        (f"{KEY}WHILE TRUE\nn = m + m\nENDWHILE", "steps"),
        (f"{KEY}FOR i = 2 TO 9999\nm[1, i] = FRAME 9 * i POSITION 1, 2, 3\nx = duration(m)\nENDFOR", "steps"),
        (f"{KEY}WHILE TRUE\nm = m + m\nENDWHILE", "steps|keys"),
        (f"{KEY}m = 10 ** 9 * m", "keys"),
        (f"{KEY}m = warp(hold(m, 10 ** 6), linear)", "keys"),
        (f"{KEY}m = noise(hold(m, 10 ** 6), 5, 1)", "keys"),
        (f"{KEY}m = crossfade(hold(m, 10 ** 6), hold(m, 10 ** 6), 10)", "keys"),
        (SCENE.format("10 ** 8", "x = 1"), "pictures"),
        (SCENE.format("100 SAMEFRAME 100", f"{BOX}FOR i = 1 TO 200\nBACKGROUND o\nENDFOR"), "steps|actors"),
        (f"{BOX}FOR i = 1 TO 7\no :- o + o\nENDFOR\nWHILE TRUE\np :- coloured(o, red)\nENDWHILE", "volumes|steps"),
        ("x = 2\nWHILE TRUE\nx = x * x\nENDWHILE", "digits"),
        ("x = 1/3\nWHILE TRUE\nx = x * x\nENDWHILE", "digits"),
        ('s = "ab"\nWHILE TRUE\ns = s + s\nENDWHILE', "letters"),
        ('s = "ab"\nFOR i = 1 TO 12\ns = s + s\nENDFOR\nWHILE TRUE\nPRINT s\nENDWHILE', "letters"),
        ('WHILE TRUE\nLOAD "humanoid"\nENDWHILE', "loads"),
        ("{" + "x" * 50_000 + "}", "script"),
    ],
)
def test_what_goes_too_far_is_refused_with_the_name_of_the_limit(run, text, option):
    with pytest.raises(LimitError) as refused:
        run(text)
    assert refused.value.limit in option.split("|")


def test_a_raised_limit_lets_more_through(run):
    text = "FOR i = 1 TO 1000\nx = i\nENDFOR"
    with pytest.raises(SourceError, match="more than 1000 steps"):
        run(text, steps=1000)
    run(text, steps=10_000)


def test_an_object_has_as_many_volumes_as_a_figure_can_hold(run):
    with pytest.raises(SourceError, match="up to 250 volumes"):
        run(f"{BOX}FOR i = 1 TO 9\no :- o + o\nENDFOR")


def test_every_limit_is_positive_and_has_a_default():
    assert all(field.default is False or field.default > 0 for field in fields(Limits))
