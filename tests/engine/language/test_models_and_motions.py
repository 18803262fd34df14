"""JOINT, STARTMODEL, FIGURE and PRINT; keys, blocks of keys and the motion algebra; as scripts write them."""

from fractions import Fraction

import pytest

from layfigure.errors import SourceError
from layfigure.motions.motion import Motion
from layfigure.motions.motion_file import load_motion

BOXES = "a :- BOX WIDTH 1, HEIGHT 2, DEPTH 1; b :- a; c :- a\n"
JOINT = "JOINT 1, a, (0, 1, 0), b, (0, -1, 0), (0, 0), (0, 0), (-90, 90)"
WALK = "walk[5, 0] = FRAME 0 POSITION 0, 0, 0; walk[5, 1] = FRAME 10 POSITION 0, 0, 90 INTERPOLATE linear\n"


@pytest.fixture
def motion(run, tmp_path):
    """A function from a text to the motion that it calls m."""

    def of(text: str) -> Motion:
        run(f'{text}\nSAVE m, "m.motion"').write()
        return load_motion(tmp_path / "m.motion").motion

    return of


def test_a_joint_makes_a_model_that_print_shows(printed):
    (shown,) = printed(f"{BOXES}m :- {JOINT}\nPRINT m")
    assert shown.startswith("m: 2 links")
    assert "z -90..90" in shown


def test_a_model_of_joints_in_any_order_is_the_model_of_joints_one_by_one(printed):
    second = "JOINT 2, b, (0, 1, 0), c, (0, -1, 0), (-10, 10)"
    block = f"{BOXES}STARTMODEL m\n{second}\n{JOINT}\nENDMODEL\nPRINT m"
    single = f"{BOXES}m :- {JOINT}\nm :- JOINT 2, link(m, b), (0, 1, 0), c, (0, -1, 0), (-10, 10)\nPRINT m"
    assert printed(block) == printed(single)


def test_links_are_called_as_the_names_they_come_from(printed):
    (shown,) = printed(f"{BOXES}m :- JOINT 1, a <TRANS (0, 1, 0)>, (0, 1, 0), b + c, (0, -1, 0), (0, 9)\nPRINT m")
    assert [line.split()[0] for line in shown.splitlines()[2:]] == ["a", "b"]


def test_symbol_tables_are_printed_with_a_dollar(printed):
    (shown,) = printed(f"{BOXES}m :- {JOINT}\nPRINT $m")
    assert "-90..90" in shown and "velocity" in shown


def test_a_model_can_be_painted_in_one_colour_and_moves_as_before(run):
    (scene,) = run(
        'load "humanoid"; load "wave"\nother = coloured(humanoid, blue)\n'
        "INITIALIZE SCENE 1\nSTARTSCENE LENGTH 20\nANIMATE humanoid USING wave\nANIMATE other USING wave\n"
        "ENDSCENE\nSHOOTSCENES"
    ).scenes
    plain, painted = scene.pictures[19].actors
    assert painted.figure.colours == ("blue",) and len(plain.figure.colours) > 1
    assert painted.figure.names == plain.figure.names
    assert (painted.angles == plain.angles).all() and painted.angles.any()


@pytest.mark.parametrize(
    ("call", "says"), [("coloured(12, red)", "must be a graphical object or a model"), ("coloured(a, rde)", "rde")]
)
def test_only_what_can_be_seen_is_painted_in_a_colour_that_there_is(run, call, says):
    with pytest.raises(SourceError, match=says):
        run(f"{BOXES}m = {call}")


def test_model_transformations_add_up_and_multiply(printed):
    twice = f"{BOXES}m :- {JOINT}\nm :- m <TRANS JOINTS BY 2, SCALE EXTREMES 0.5> <TRANS JOINTS 3>\nPRINT m"
    assert "6 " in printed(twice)[0] and "z -45..45" in printed(twice)[0]


@pytest.mark.parametrize(
    ("text", "says"),
    [
        (f"m :- {JOINT}\nm :- JOINT 2, m, (0,0,0), m, (0,0,0), (0,1)", "joins a model to itself"),
        ("m :- JOINT 1, a, (0,0), b, (0,0,0), (0,1)", "must be a vector"),
        ("m :- JOINT 1, a, (0,0,0), b, (0,0,0), (5,1)", "smaller one first"),
        ("m :- JOINT 1, 3, (0,0,0), b, (0,0,0), (5,1)", "joins graphical objects and models"),
        (f"m :- {JOINT}\nFIGURE m MAIN LINK d", 'no link "d"'),
        (f"m :- {JOINT}\nFIGURE m MAIN JOINT 7", "no joint 7"),
        ("FIGURE a MAIN LINK b", '"a" must be a model, but is a graphical object'),
        (f"m :- {JOINT}\nm :- m <SCALE FRAMES 2>", "SCALE FRAMES is not for a model"),
        (f"m :- {JOINT}\nm :- m <TRANS (1, 2, 3)>", "once animated"),
        ("STARTMODEL m\nENDMODEL", "has no JOINT"),
        ("a :- BOX WIDTH 1, HEIGHT 2", "this box has no DEPTH"),
        ("a :- BOX WIDTH 1, HEIGHT 2, DEPTH 0", "greater than 0"),
        ("a :- BOX WIDTH 1, HEIGHT 2, DEPTH 1, RADIUS 3", "a box has no RADIUS"),
        ("a :- SPHERE RADIUS 1, COLOUR orangy", 'no colour "orangy"; did you mean "orange"'),
    ],
)
def test_what_is_wrong_with_a_model_is_told(run, text, says):
    with pytest.raises(SourceError, match=says):
        run(BOXES + text)


def test_all_solids_can_be_made_and_changed(printed):
    text = """
    a :- SPHERE RADIUS 2, AT (0, 1, 0), COLOUR red
    b :- CYLINDER FROM (0, 0, 0) TO (0, 3, 0), RADIUS 1
    c :- CONE RADIUS 1, HEIGHT 2
    d :- CUBE EDGE 2, LIGHTNESS 70
    PRINT (a + b + c + d <ROTATE Z 90, TRANS (1, 0, 0)>) <SCALE 2>
    """
    assert printed(text) == [
        "graphical object of 4 volumes (sphere, cylinder, cone, cube), from (-4, -2, -4) to (4, 6, 4)"
    ]


def test_keys_by_formula_and_in_a_block_make_one_motion(motion):
    block = "STARTMOTION m\nJOINT 5\nFRAME 10 POSITION 0, 0, 90\nINTERPOLATE linear\nENDJOINT\nENDMOTION"
    assert motion(block) == motion(WALK + "m = walk")


def test_key_zero_stands_at_frame_zero_whatever_is_asked(motion):
    assert motion(
        "m[1, 0] = FRAME 7 POSITION 1, 2, 3 INTERPOLATE linear\nm[1, 1] = FRAME 9 POSITION 0, 0, 0"
    ) == motion("m[1, 0] = FRAME 0 POSITION (1, 2, 3)\nm[1, 1] = FRAME 9 POSITION (0, 0, 0)")


def test_the_algebra_reads_as_it_is_written(motion):
    hop = "hop[1,1] = FRAME 3 POSITION 1,0,0; skip[1,1] = FRAME 5 POSITION 2,0,0; jump[1,1] = FRAME 7 POSITION 3,0,0\n"
    assert motion(hop + "m = 10 * (hop + skip + jump)").duration == 150
    assert motion(hop + "m = 10 * hop + skip") == motion(hop + "m = (10 * hop) + skip")
    assert motion(hop + "m = 2 * hop <SCALE FRAMES 1/3>").duration == 2
    assert motion(hop + "m = hop <SCALE FRAMES -1>") == motion(hop + "m = reverse(hop)")
    assert motion(hop + "m = hop <SCALE EXTREMES 2, SCALE FRAMES 2>") == motion(
        hop + "m = hop <SCALE FRAMES 2> <SCALE EXTREMES 2>"
    )


def test_strip_keeps_joints_by_number_name_or_variable(motion):
    legs = "a[5,1] = FRAME 3 POSITION 1,0,0; a[lefthand,1] = FRAME 5 POSITION 2,0,0; a[6,1] = FRAME 5 POSITION 2,0,0\n"
    assert motion(legs + "m = STRIP a, 5, lefthand").joints == ("5", "lefthand")
    assert motion(legs + "joint_number = 5\nm = STRIP a, joint_number").joints == ("5",)
    assert motion(legs + "m = SYNCHRONIZE STRIP(a, 5), strip(a, 6)").joints == ("5", "6")


@pytest.mark.parametrize(
    ("expression", "duration"),
    [
        ("hold(walk, 5)", 15),
        ("speed(walk, 2)", 5),
        ("fit(walk, 2)", 48),
        ("fit(walk, 2, 30)", 60),
        ("silence(3) + walk", 13),
        ("walk + mark(walk, 4, contact)", 20),
        ("without(walk, 5)", 10),
        ("synchronize(walk, silence(12))", 12),
    ],
)
def test_functions_of_motions(motion, expression, duration):
    assert motion(f"{WALK}m = {expression}").duration == duration


def test_a_motion_can_be_asked(printed):
    assert printed(f"{WALK}PRINT duration(walk), at(walk, 10, 5), jump(walk)") == ["10 (0, 0, 90) 90"]


def test_keys_can_be_led_through_by_the_shortest_turn(motion):
    text = 'LOAD "humanoid" AS man\nm["spine", 1] = FRAME 8 POSITION -60, -40, 40\nn = slerp(m, man)\n'
    turned, plain = motion(text.replace("n =", "m =")), motion(text)
    assert (turned.duration, turned.end()) == (8, plain.end())
    assert turned.key_count == 9 and turned.at(4) != plain.at(4)


def test_scaling_time_by_a_third_is_exact(motion):
    assert motion(f"{WALK}m = walk <SCALE FRAMES 1/3>").duration == Fraction(10, 3)


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("m = 1.5 * walk", "a whole number of times"),
        ("m = -1 * walk", "this number is negative"),
        ("m = STRIP walk, 6", "does not move joint 6; it moves 5"),
        ("m = SYNCHRONIZE walk, walk", "both motions move joint 5"),
        ("m = SYNCHRONIZE walk, 3", "must be a motion, but is a number"),
        ("m = walk <SCALE FRAMES 0>", "cannot be scaled by 0"),
        ("walk[5, 2] = FRAME 5 POSITION 0,0,0\nPRINT walk", "frame 5 follows frame 10"),
        ("walk[5, -1] = FRAME 5 POSITION 0,0,0", "keys count from 0"),
        ("walk[5, 2] = FRAME 15 POSITION 0,0", "POSITION takes x, y, z"),
        ("walk[5, 2] = FRAME 15 POSITION 0,0,0 INTERPOLATE liner", 'did you mean "linear"'),
        ("walk[1/2, 2] = FRAME 15 POSITION 0,0,0", "called by a whole number or a word"),
        ("m = walk + walk\nm[5, 3] = FRAME 99 POSITION 0,0,0", "put together from others"),
        ("n = 3\nn[5, 3] = FRAME 99 POSITION 0,0,0", '"n" is a number; keys are set in motions'),
        ("STARTMOTION m\nJOINT 1\nJOINT 1\nENDMOTION", "for the second time"),
        ('LOAD "humanoid" AS man\nm = slerp(hold(walk, 10 ** 6), man)', "more than 50000 keys"),
        ("m = 100000 * walk", "more than 50000 keys"),
        ("m = hold(walk, 10 ** 300)", "digits|frames"),
    ],
)
def test_what_is_wrong_with_a_motion_is_told(run, text, says):
    with pytest.raises(SourceError, match=says):
        run(WALK + text)


def test_a_loop_that_sets_keys_takes_steps_in_proportion(run):
    run("FOR i = 1 TO 2000\nm[1, i] = FRAME i POSITION i, 0, 0\nENDFOR\nPRINT duration(m)")


def test_keys_too_near_each_other_are_refused_where_the_script_sets_them(run):
    text = "m[5, 0] = FRAME 0 POSITION 0, 0, 0\nm[5, 1] = FRAME 12 POSITION 0, 0, 9\n"
    with pytest.raises(SourceError, match=r":3:1: joint 5, key 2: frame .* is too near frame 12; keys lie"):
        run(text + "m[5, 2] = FRAME 12 + 1 / 10000000 POSITION 0, 0, 0\nPRINT m")


def test_values_that_no_pose_can_have_are_refused_where_the_script_sets_them(run):
    with pytest.raises(SourceError, match=r":1:\d+: each number of POSITION goes from -1000000 to 1000000"):
        run("m[place, 0] = FRAME 0 POSITION 0, 1000001, 0\nPRINT m")


def test_values_of_solids_may_have_signs(printed):
    text = "r = -2\nPRINT SPHERE RADIUS -r\nPRINT BOX WIDTH +1, HEIGHT -(-2), DEPTH -(-3), AT -(1, 0, 0), LIGHTNESS +50"
    ball, box = printed(text)
    assert "from (-2, -2, -2) to (2, 2, 2)" in ball and "from (-1.5, -1, -1.5) to (-0.5, 1, 1.5)" in box


def test_words_of_solids_and_joints_are_still_names_in_differences(printed):
    text = "radius = 3; width = 4; joint = 5; strip = 6\nPRINT radius - 1, width -1\nv = (1, radius - 1)\n"
    assert printed(f"{text}x = joint - 1; y = strip - 1\nPRINT v, x, y") == ["2 3", "(1, 2) 4 5"]


def test_what_is_stripped_and_synchronized_may_have_a_sign(printed):
    text = "a = STRIP +1 * walk, 5\nb = SYNCHRONIZE +1 * walk\nPRINT duration(a), duration(b)"
    assert printed(WALK + text) == ["10 10"]


def test_a_motion_that_cannot_be_is_told_where_it_is_asked_for(run):
    with pytest.raises(SourceError, match=r"script.lay:1:1: .*frames cannot be"):
        run("m[spine, 1] = FRAME 10 ** 9 POSITION 0, 0, 0\nPRINT m")


def test_advice_is_in_the_words_of_scripts(run):
    with pytest.raises(SourceError, match="in a script b2 :- b"):
        run(f"{BOXES}m :- JOINT 1, b, (0, 1, 0), b, (0, -1, 0), (0, 9)")
