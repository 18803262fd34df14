"""Motion files: exact, readable, and with one sentence for the first mistake."""

import random
from fractions import Fraction

import pytest

from layfigure.errors import FileError, LayfigureError, SourceError
from layfigure.figures.library import load_figure
from layfigure.motions.motion import Motion
from layfigure.motions.motion_file import load_motion, read_motion, save_motion, write_motion
from layfigure.motions.standard import STANDARD

SCRAPS = ["", "0", " ", "\n", "-", "/", "span", "1e9", "é", "{", "#"]
SHOWN = ["Motion.parse('duration 3')", "duration 3", " duration 3 ;", "layfigure motion 1\nduration 3"]
HAND = """layfigure motion 1
figure humanoid   # whose limbs are named
rate 30
mark 6 contact
joint LeftForearm
0 0 0 0
1/3 10 0 0 linear
12 90.5 0 0
joint 5
span 0 6
0 1 2 3
span 6 12
8 1 2 3
"""


def sentence(text, **known):
    with pytest.raises(SourceError) as error:
        read_motion(text, "m.motion", **known)
    assert "\n" not in str(error.value) and len(str(error.value)) < 300
    return str(error.value)


def test_a_file_written_by_hand_is_read():
    found = read_motion(HAND, "hand.motion")
    assert (found.figure, found.rate, found.motion.duration) == ("humanoid", 30, 12)
    assert found.motion.at(12) == {"5": (1.0, 2.0, 3.0), "leftforearm": (90.5, 0.0, 0.0)}
    assert found.motion.tracks["leftforearm"][0].keys[1].time == Fraction(1, 3)
    assert found.motion.tracks["5"][1].keys[0].time == 8 and len(found.motion.marks) == 1


def test_what_is_written_reads_back_exactly_and_is_written_alike_again():
    motion = read_motion(HAND, "hand.motion").motion
    text = write_motion(3 * motion.scale(frames="-7/3", extremes="1/7"), load_figure("humanoid"), "29.97")
    again = read_motion(text, "again.motion")
    assert again.motion == 3 * motion.scale(frames="-7/3", extremes="1/7")
    assert (again.figure, again.rate) == ("humanoid", Fraction("29.97"))
    assert write_motion(again.motion, load_figure("humanoid"), again.rate) == text


def test_one_changed_key_is_one_changed_line():
    rows = [(frame, (frame, 0, 0)) for frame in range(0, 60, 6)]
    changed = [row if row[0] != 30 else (30, (99, 0, 0)) for row in rows]
    before, after = (write_motion(Motion.of({"spine": keys, "neck": rows})).splitlines() for keys in (rows, changed))
    assert sum(a != b for a, b in zip(before, after, strict=True)) == 1


def test_a_file_is_saved_whole_and_names_a_figure_of_ones_own_beside_it(tmp_path):
    (tmp_path / "my figure.fig").write_text("r { joint 0 0 0 spine { 0 0 0 0 5 0 flexiondof -9 9 } }")
    figure = load_figure(tmp_path / "my figure.fig")
    motion = Motion.of({"spine": [(12, (5, 0, 0))]})
    save_motion(tmp_path / "bow.motion", motion, figure)
    found = load_motion(tmp_path / "bow.motion", STANDARD)
    assert found.motion == motion and (tmp_path / found.figure).is_file()
    assert [path.name for path in tmp_path.iterdir() if path.suffix == ".part"] == []
    with pytest.raises(FileError):
        save_motion(tmp_path / "none" / "bow.motion", motion)


@pytest.mark.parametrize(
    ("lines", "told"),
    [
        ("", "1:1: "),
        ("joint a", "1:1: "),
        ("layfigure pose 1", '1:11: found "pose"'),
        ("layfigure motion", "1:17: "),
        ("layfigure motion 2", "newer"),
        ("layfigure motion 1 2", "line should end"),
        ("layfigure motion 1\nfigure", "figure's name"),
        ('layfigure motion 1\nfigure "x', "quotation"),
        ("layfigure motion 1\nrate 0", "over 0"),
        ("layfigure motion 1\nrate 24\nrate 24", "3:1: "),
        ("layfigure motion 1\nduration -1", "2:10: "),
        ("layfigure motion 1\nduration 1e9", "1e+09 frames"),
        ("layfigure motion 1\nduration 1\nduration 1", "twice"),
        ("layfigure motion 1\n0 0 0 0", "before any joint"),
        ("layfigure motion 1\nspan 0 1", "before any joint"),
        ("layfigure motion 1\njoint", "a joint"),
        ("layfigure motion 1\njoint a{b", "line should end"),
        ("layfigure motion 1\njoint a\njoint A", "line 2"),
        ("layfigure motion 1\njiont a", 'did you mean "joint"'),
        ("layfigure motion 1\njoint a\n0 0 0", "3:6: "),
        ("layfigure motion 1\njoint a\n0 0 x 0", "3:5: y or pivot"),
        ("layfigure motion 1\njoint a\n0 0 0 1/0", "3:7: "),
        ("layfigure motion 1\njoint a\n0 0 0 0 linear 3", "3:16: "),
        ("layfigure motion 1\njoint a\n5 0 0 0\n5 0 0 0", "4:1: "),
        ("layfigure motion 1\njoint a\n-5 0 0 0", "3:1: "),
        ("layfigure motion 1\nduration 3\njoint a\n5 0 0 0", 'joint "a"'),
        ("layfigure motion 1\njoint a\nspan 0 5\nspan 4 6\n4 0 0 0", "without keys"),
        ("layfigure motion 1\njoint a\nspan 0 5\n0 0 0 0\nspan 4 6\n4 0 0 0", "overlap"),
        ("layfigure motion 1\njoint a\nspan 5 5\n5 0 0 0", "no length"),
        ("layfigure motion 1\nmark 5 x\nduration 3", "mark"),
        ("layfigure motion 1\njoint a\n" + "9" * 90 + " 0 0 0", "characters"),
    ],
)
def test_the_first_mistake_is_told_with_its_place(lines, told):
    assert told in sentence(lines)


def test_letters_in_a_number_are_no_number():
    assert sentence("layfigure motion 1\njoint a\n0 0 0 x0").startswith("m.motion:3:7: ")


def test_an_interpolation_can_be_checked_where_it_stands():
    text = "layfigure motion 1\njoint a\n0 0 0 0\n5 0 0 0 acelerate"
    assert read_motion(text, "x").motion.tracks["a"][0].keys[1].how == "acelerate"
    assert '4:9: found "acelerate"' in sentence(text, known=STANDARD) and "accelerate" in sentence(text, known=STANDARD)


def test_a_file_beyond_all_bounds_is_refused():
    keys = "\n".join(f"{frame} 0 0 0" for frame in range(200_002))
    assert "50000 keys" in sentence(f"layfigure motion 1\njoint a\n{keys}")


def test_whatever_happens_to_a_file_it_is_a_motion_or_one_sentence():
    source = random.Random(3)
    for _ in range(400):
        text = list(HAND)
        for _ in range(source.randint(1, 6)):
            at = source.randrange(len(text))
            text[at : at + source.randint(0, 3)] = source.choice(
                ["", "0", " ", "\n", "-", "/", "span", "1e9", "é", "{", "#"]
            )
        try:
            found = read_motion("".join(text), "m.motion")
        except SourceError as error:
            assert "\n" not in str(error)
        else:
            assert read_motion(write_motion(found.motion), "again").motion == found.motion


@pytest.mark.parametrize("text", SHOWN)
def test_parse_reads_what_shows_a_motion_in_any_of_its_forms(text):
    assert Motion.parse(text) == Motion.silence(3)
    with pytest.raises(LayfigureError):
        Motion.parse(text + "; x")


def test_keys_that_floats_could_not_tell_apart_are_refused_with_their_line():
    text = "layfigure motion 1\njoint 5\n0 0 0 0\n12 90 0 0\n12.00000000000000000001 0 0 0\n"
    assert sentence(text).startswith("m.motion:5:1: frame 1200000000000000000001/100000000000000000000 is too near")
    with pytest.raises(LayfigureError, match="too near"):
        Motion.of({"5": [(0, (0, 0, 0)), (1, (0, 0, 9))]}, 2).scale(frames="1e-7")


@pytest.mark.parametrize("joint", ["spine", "place"])
@pytest.mark.parametrize("number", ["1e35", "-1000001", "1000000.5"])
def test_values_that_no_pose_can_have_are_refused_with_their_line(joint, number):
    text = f"layfigure motion 1\njoint {joint}\n0 0 0 0\n12 0 {number} 0\n"
    assert sentence(text).startswith("m.motion:4:6: y or pivot goes from -1000000 to 1000000;")
    with pytest.raises(LayfigureError, match="goes from -1000000 to 1000000"):
        Motion.of({joint: [(0, (0, 0, 1))]}).scale(extremes=number)


@pytest.mark.parametrize("rate", ["1e-30", "0", "-24", "1000.5", "1e30"])
def test_rates_are_bounded(rate):
    text = f"layfigure motion 1\nrate {rate}\nduration 2\n"
    assert sentence(text).startswith("m.motion:2:6: the frames a second must be over 0, from 0.01 to 1000")


def test_marks_and_blank_lines_are_counted_while_reading():
    marks = "mark 1 a\n" * 10_001
    assert sentence(f"layfigure motion 1\nduration 2\n{marks}").startswith("m.motion:10003:1: a motion file has up to")
    blank = "\n" * 100_001
    assert "blank lines" in sentence(f"layfigure motion 1\n{blank}duration 2\n")


def test_a_motion_that_could_not_be_read_again_is_not_written():
    large = Motion.of({"5": [(0, (0, 0, 0)), (1, (0, 0, 9))]}) * 25_001
    with pytest.raises(LayfigureError, match="up to 50000 keys"):
        write_motion(large)
