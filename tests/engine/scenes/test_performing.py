"""What ANIMATE shows on every frame of a scene, held to a slow and literal reading of its rules."""

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from layfigure.errors import LayfigureError
from layfigure.figures.library import load_figure
from layfigure.models import Link, box, joint, model
from layfigure.motions.joints import joints_of
from layfigure.motions.motion import Motion
from layfigure.motions.sampling import sample
from layfigure.scenes.animating import Animate
from layfigure.scenes.camera import SceneCamera
from layfigure.scenes.performing import Performer, Stage
from layfigure.scenes.picture import Actor
from layfigure.scenes.scene import Part, Scene, shoot

HUMANOID = load_figure("humanoid")
CAMERA = SceneCamera((0, 0, 1), 300.0)
JOINTS = ("lefthand", "neck", "root")


def bars(*lengths: int):
    """Return a model of bars end on end, joints 1, 2, ... that turn freely about z."""
    links = [Link(f"bar{number}", box(0.1, length, 0.1)) for number, length in enumerate(lengths)]
    ends = [(0, -length / 2, 0) for length in lengths], [(0, length / 2, 0) for length in lengths]
    return model(
        [joint(n + 1, links[n], ends[0][n], links[n + 1], ends[1][n + 1], z=(-720, 720)) for n in range(len(links) - 1)]
    )


def turn(name: object, to: float, frames: int, start: float = 0.0) -> Motion:
    return Motion.of({name: [(0, (0, 0, start)), (frames, (0, 0, to))]})


def shown(animations, length: int, who=HUMANOID, **scene) -> list[Actor]:
    shooting = Scene(1, length, CAMERA, (Part(who, tuple(animations)),), **scene).shoot()
    return [actor for picture in shooting.pictures for actor in picture.actors]


def twists(actors: list[Actor], limb: str) -> list[float]:
    return [round(float(actor.angles[HUMANOID.index(limb), 2]), 9) for actor in actors]


def test_on_its_frames_a_model_shows_the_motion_from_its_beginning():
    motion = turn("neck", 20, 10)
    actors = shown([Animate(motion, 3, 8)], 9)
    expected = [0, 0, 0, *(motion.at(k)["neck"][2] for k in range(6))]
    np.testing.assert_allclose(twists(actors, "neck"), expected, atol=1e-9)


def test_frames_are_the_same_however_they_are_written():
    nod = turn("neck", 20, 10)
    written, counted = Animate(nod, "0.5", "7/2"), Animate(nod, 0.5, Fraction(7, 2))
    assert written == counted and hash(written) == hash(counted)
    assert (written.begin, written.end) == (Fraction(1, 2), Fraction(7, 2))
    assert [written.shows(frame) for frame in range(5)] == [False, True, True, True, False]


def test_before_its_frames_a_model_is_neutral_and_after_them_stays_as_it_was_last():
    actors = shown([Animate(turn("neck", 20, 10, start=5), 2, 4)], 8)
    seen = twists(actors, "neck")
    assert seen[:2] == [0, 0] and seen[2] == 5 and seen[4] == seen[5] == seen[7] > 5


def test_a_motion_that_ends_stays_where_it_ends():
    assert twists(shown([Animate(turn("neck", 20, 3), 0)], 6), "neck")[3:] == [20, 20, 20]


def test_repeat_shows_the_rest_of_the_division_by_the_duration():
    motion = turn("neck", 20, 4)
    seen = twists(shown([Animate(motion, 1, repeat=True)], 12), "neck")
    np.testing.assert_allclose(seen[1:], [motion.at((k - 1) % 4)["neck"][2] for k in range(1, 12)], atol=1e-9)


def test_a_duration_of_no_whole_number_repeats_exactly():
    motion = turn("neck", 20, 10).scale(frames="1/30")  # a third of a frame: every frame is a beginning
    assert twists(shown([Animate(motion, 0, repeat=True)], 40), "neck") == [0] * 40


def test_joints_that_a_motion_does_not_name_keep_their_last_value():
    nod, wave = turn("neck", 20, 4), turn("righthand", 30, 4)
    actors = shown([Animate(nod, 0, 2), Animate(wave, 4)], 10)
    assert twists(actors, "neck")[9] == pytest.approx(nod.at(2)["neck"][2])
    assert twists(actors, "righthand")[9] == pytest.approx(
        min(30, HUMANOID.arrays.limits[HUMANOID.index("righthand"), 2, 1])
    )


def test_of_two_statements_that_move_one_joint_the_later_one_holds():
    seen = twists(shown([Animate(turn("neck", 20, 4), 0), Animate(turn("neck", -20, 4), 2, 3)], 6), "neck")
    assert seen[2] == 0 and seen[3] < 0, "the second statement's own beginning"
    assert seen[4] == 20, "then the first, which still runs"


def test_a_joint_that_is_silent_at_first_keeps_what_it_had():
    late = Motion.silence(5) + turn("neck", 20, 4, start=10)
    seen = twists(shown([Animate(turn("neck", 15, 2), 0, 2), Animate(late, 3)], 12), "neck")
    assert seen[3:8] == [15] * 5 and seen[8] == 10


def test_a_scene_begins_in_the_orientation_that_an_earlier_one_left():
    first = Scene(3, 5, CAMERA, (Part(HUMANOID, (Animate(turn("neck", 20, 4)),)),))
    second = Scene(7, 3, CAMERA, (Part(HUMANOID),))
    for order in ([first, second], [second, first]):
        shootings = shoot(order)
        assert [shooting.number for shooting in shootings] == [3, 7]
        assert twists(list(shootings[1].pictures[0].actors), "neck") == [20]
    assert twists(list(second.shoot().pictures[0].actors), "neck") == [0]


def test_one_model_twice_in_a_cast_keeps_two_orientations():
    cast = (Part(HUMANOID, (Animate(turn("neck", 20, 2)),)), Part(HUMANOID, (Animate(turn("neck", -20, 2)),)))
    later = Scene(2, 1, CAMERA, (Part(HUMANOID), Part(HUMANOID)))
    _, after = shoot([Scene(1, 3, CAMERA, cast), later])
    assert twists(list(after.pictures[0].actors), "neck") == [20, -20]


# --- root motion ---


def test_a_root_that_travels_goes_on_over_repetitions_and_from_statement_to_statement():
    stride = Motion.of({"place": [(0, (0, 0, 0)), (4, (0, 0, 40))]})
    z = [float(actor.translation[2]) for actor in shown([Animate(stride, 0, 8, repeat=True), Animate(stride, 9)], 14)]
    assert z[0] == 0 and z[4] == pytest.approx(-40) and z[8] == pytest.approx(-80), "toward the viewer is -z"
    assert z[9] == pytest.approx(-80) and z[13] == pytest.approx(-120)


def test_a_place_that_does_not_travel_is_where_a_figure_stands():
    sit = Motion.of({"place": [(0, (0, 0, 0)), (4, (0, -20, 0))]})
    stay = Motion.of({"place": [(0, (0, -20, 0)), (4, (0, -20, 0))]})
    y = [
        float(actor.translation[1]) for actor in shown([Animate(sit, 0, 4), Animate(stay, 5, 9), Animate(stay, 10)], 13)
    ]
    assert y[4] == y[5] == y[10] == y[12] == -20


def test_another_scene_begins_where_its_cast_is_put():
    stride = Motion.of({"place": [(0, (0, 0, 0)), (4, (30, 0, 0))]})
    _, second = shoot([Scene(n, 5, CAMERA, (Part(HUMANOID, (Animate(stride),)),)) for n in (1, 2)])
    assert second.pictures[0].actors[0].translation[0] == 0


# --- the whole of it against a literal reading ---

keys = st.lists(st.integers(-60, 60), min_size=2, max_size=4)
ranges = st.tuples(st.integers(0, 12), st.integers(0, 12)).map(sorted)


@st.composite
def motions(draw):
    tracks = {}
    for name in draw(st.sets(st.sampled_from(JOINTS), min_size=1)):
        values = draw(keys)
        step = draw(st.integers(1, 3))
        tracks[name] = [(step * n, (value, value / 2, value / 4)) for n, value in enumerate(values)]
    motion = Motion.of(tracks)
    return Motion.silence(draw(st.integers(1, 3))) + motion if draw(st.booleans()) else motion


@st.composite
def animations(draw):
    first, last = draw(ranges)
    return Animate(draw(motions()), first, draw(st.sampled_from([last, None])), draw(st.booleans()))


def literally(statements, length: int) -> np.ndarray:
    """Return the angles (length, n, 3) that the rules ask for, by exact evaluation frame by frame."""
    known = joints_of(HUMANOID)
    limits = HUMANOID.arrays.limits.copy()
    limits[0] = (-np.inf, np.inf)
    state, answer = np.zeros((len(HUMANOID.limbs), 3)), []
    for frame in range(length):
        for each in statements:
            if frame < each.first or (each.last is not None and frame > each.last):
                continue
            time, duration = Fraction(frame) - each.first, each.motion.duration
            rounds = time // duration if each.repeat else 0
            for name, spans in each.motion.tracks.items():
                now = time - rounds * duration
                if rounds and now < spans[0].begin:
                    now = duration  # silent again: as it ended the round before
                values = each.motion.at(now).get(name)
                if values is not None:
                    for limb in known[name]:
                        state[limb] = np.clip(values, limits[limb, :, 0], limits[limb, :, 1])
        answer.append(state.copy())
    return np.array(answer)


@settings(max_examples=60, deadline=None)
@given(st.lists(animations(), max_size=4), st.integers(1, 16))
def test_every_frame_is_what_the_rules_say(statements, length):
    actors = shown(statements, length)
    np.testing.assert_allclose([actor.angles for actor in actors], literally(statements, length), atol=1e-9)


@settings(max_examples=20, deadline=None)
@given(st.lists(animations(), min_size=1, max_size=3), st.integers(1, 16))
def test_a_program_that_goes_statement_by_statement_sees_the_same(statements, length):
    stage = Stage()
    stage.begin(length)
    seen = []
    for frame in range(length):
        for each in statements:
            actor = stage.animate("man", HUMANOID, each, frame)
        seen.append(actor.angles)
    whole = shown(statements, length)
    np.testing.assert_array_equal(seen, [actor.angles for actor in whole])


def test_long_motions_are_sampled_in_parts_without_a_trace():
    motion = turn("neck", 20, 3000)
    performer = Performer(HUMANOID, 3000)
    animate = Animate(motion, 5)
    asked = [5, 6, 7, 40, 41, 700, 701, 2999, 5]
    seen = []
    for frame in asked:
        performer.act(animate, frame)
        seen.append(performer.angles.copy())
    np.testing.assert_array_equal(seen, sample(HUMANOID, motion, [frame - 5 for frame in asked]).angles)


# --- reports ---


def test_what_limits_held_back_is_told_for_the_scene_in_its_frames():
    high = HUMANOID.arrays.limits[HUMANOID.index("neck"), 2, 1]
    motion = turn("neck", high + 12, 10)
    shooting = Scene(1, 20, CAMERA, (Part(HUMANOID, (Animate(motion, 5, 15),)),)).shoot()
    assert shooting.clamps.samples == 11 and shooting.clamps.frame == 15
    assert "neck.twist +12 degrees at frame 15" in str(shooting.clamps)
    assert twists(list(shooting.pictures[19].actors), "neck") == [high]


def test_models_of_equal_structure_respond_equally_but_for_their_own_limits():
    tall, small = bars(4, 3, 2), bars(1, 2, 1).scale_extremes(0.01)
    motion = turn(1, 50, 4) | turn(2, -30, 4)
    one, other = (shown([Animate(motion)], 5, who) for who in (tall, small))
    np.testing.assert_allclose([a.angles[1:, 2] for a in one][4], [50, -30], atol=1e-9)
    np.testing.assert_allclose([a.angles[1:, 2] for a in other][4], [7.2, -7.2], atol=1e-9)
    told = Scene(1, 5, CAMERA, (Part(small, (Animate(motion),)), Part(tall, (Animate(motion),)))).shoot().clamps
    assert told.samples == 20 and 0 < told.clamped <= 8


def test_the_seam_of_a_repeated_motion_is_told_once_if_it_is_seen():
    jump = turn("neck", 20, 4)
    for length, count in ((4, 0), (5, 1), (20, 1)):
        shooting = Scene(1, length, CAMERA, (Part(HUMANOID, (Animate(jump, repeat=True),)),)).shoot()
        assert len(shooting.seams) == count
    assert shooting.seams[0].jump == 20
    assert not Scene(1, 20, CAMERA, (Part(HUMANOID, (Animate(jump),)),)).shoot().seams


def test_joints_that_nobody_has_are_told():
    shooting = Scene(1, 2, CAMERA, (Part(HUMANOID, (Animate(turn("tail", 20, 4)),)),)).shoot()
    assert shooting.unknown == ("tail",)


def test_a_scene_that_ends_before_a_motion_is_done_tells_only_of_what_it_shows():
    high = HUMANOID.arrays.limits[HUMANOID.index("neck"), 2, 1]
    motion = Motion.of({"neck": [(0, (0, 0, 0)), (10, (0, 0, high)), (20, (0, 0, high + 50))]})
    assert not Scene(1, 11, CAMERA, (Part(HUMANOID, (Animate(motion),)),)).shoot().clamps


# --- models that change, main links ---


def test_a_model_that_a_program_changes_keeps_its_orientation_by_joint():
    stage, bar = Stage(), bars(4, 3, 2)
    stage.begin(10)
    for frame in range(5):
        stage.animate("bar", bar, Animate(turn(2, 40, 4)), frame)
    held = bar.with_main(joint=2)
    np.testing.assert_allclose(stage.shown("bar", held).angles[1:, 2], [0, 40], atol=1e-9)
    np.testing.assert_allclose(stage.shown("bar", bars(1, 1, 1)).angles[1:, 2], [0, 40], atol=1e-9)


def test_a_main_link_stays_still_whatever_moves():
    from layfigure.kinematics.forward import place

    bar = bars(4, 3, 2).with_main(joint=2)
    sway = turn(1, 170, 8) | turn(2, -60, 8) | Motion.of({"place": [(0, (0, 0, 0)), (8, (5, 6, 7))]})
    for actor in shown([Animate(sway)], 9, bar):
        placement = place(bar.figure, actor.angles, actor.translation)
        np.testing.assert_allclose(placement.limb_to_world[bar.main], np.eye(3), atol=1e-12)
        tip = placement.origins[bar.main] + np.array(bar.anchor)
        np.testing.assert_allclose(tip, 0, atol=1e-12)


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [((5, 3), "FROM 5 TO 3; TO must not come before"), (("x", 3), "FROM is 'x'"), ((0, float("nan")), "TO is 'nan'")],
)
def test_an_animate_that_cannot_be_is_refused(arguments, sentence):
    with pytest.raises(LayfigureError, match=sentence):
        Animate(Motion.EMPTY, *arguments)
