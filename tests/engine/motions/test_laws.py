"""The laws of the algebra of motions (animation.md 2), each on exact rational time; and the two that do not hold."""

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import HealthCheck, assume, example, given, settings
from hypothesis import strategies as st

from layfigure.errors import LayfigureError
from layfigure.figures.library import load_figure, read_figure
from layfigure.motions.blending import crossfade
from layfigure.motions.building import from_poses
from layfigure.motions.motion import Motion, synchronize
from layfigure.motions.sampling import frame_times, sample
from layfigure.motions.slerp import slerp
from layfigure.motions.standard import STANDARD
from layfigure.poses.pose import Pose

JOINTS, OTHERS = ("5", "6", "lefthand", "root"), ("7", "8", "righthand")
HUMANOID = load_figure("humanoid")
DOFS = "xdof -1e6 1e6 ydof -1e6 1e6 zdof -1e6 1e6"
FREE = read_figure(
    "free", "r { " + " ".join(f"joint 0 0 0 {name} {{ 0 0 0 0 1 0 {DOFS} }}" for name in "abcd") + " }", "free.fig"
)

lawful = settings(max_examples=40, deadline=None, suppress_health_check=list(HealthCheck))
lengths = st.builds(Fraction, st.integers(1, 90), st.sampled_from([1, 3, 4, 7]))
angles = st.builds(Fraction, st.integers(-1800, 1800), st.just(10))
factors = st.builds(Fraction, st.integers(-12, 12).filter(bool), st.sampled_from([1, 4, 7]))
sizes = st.builds(Fraction, st.integers(-500, 500), st.just(10))  # two of them keep every angle within a million
shares = st.builds(Fraction, st.integers(0, 96), st.just(96))
counts = st.integers(0, 4)
ways, cubic = st.sampled_from(sorted(STANDARD)), st.just("cubic")
data = st.data()


@st.composite
def keys(draw, hows):
    """Ascending keys of one joint, the first at 0."""
    times = [Fraction(0)]
    for step in draw(st.lists(lengths, max_size=5)):
        times.append(times[-1] + step)
    return [(time, draw(st.tuples(angles, angles, angles)), draw(hows)) for time in times]


@st.composite
def primitives(draw, joints=JOINTS, hows=ways):
    """A motion made of keys, now and then longer than they are, with marks."""
    rows = {joint: draw(keys(hows)) for joint in draw(st.lists(st.sampled_from(joints), unique=True, max_size=3))}
    last = max((row[-1][0] for row in rows.values()), default=Fraction(0))
    duration = last + draw(st.just(Fraction(0)) | lengths) or Fraction(bool(rows))
    motion = Motion.of(rows, duration)
    marks = st.lists(st.tuples(shares, st.sampled_from(["lift", "land"])), max_size=2)
    for share, name in draw(marks) if duration else ():
        motion = motion.marked(duration * share, name)
    return motion


def motions(joints=JOINTS, hows=ways):
    """Motions of any make: primitives, rows, repetitions, stretched and reversed ones, some with silent stretches."""
    return st.recursive(
        primitives(joints, hows),
        lambda inner: st.one_of(
            st.builds(lambda a, b: a + b, inner, inner),
            st.builds(lambda n, a: n * a, st.integers(0, 3), inner),
            st.builds(lambda a, s: a.scale(frames=s), inner, factors),
            st.builds(lambda a, kept: a.strip(kept), inner, st.sets(st.sampled_from(joints))),
            st.builds(lambda a, n: a.hold(n), inner, lengths),
        ),
        max_leaves=4,
    )


any_motion, other_motion, plain_motion = motions(), motions(OTHERS), motions(hows=cubic)
joint_sets = st.sets(st.sampled_from(JOINTS))


def moment(draw, motion):
    """Draw a time within a motion: any, or one where something begins or ends."""
    spans = [span for spans in motion.tracks.values() for span in spans]
    special = {Fraction(0), motion.duration} | {time for span in spans for time in (span.begin, span.end)}
    return draw(shares.map(lambda u: u * motion.duration) | st.sampled_from(sorted(special)))


def values(motion, time):
    """Return exact values by joint at a time."""
    return {joint: tuple(state.value for state in row) for joint, row in motion.states(time).items()}


def seams_of(motion):
    return {time for spans in motion.tracks.values() for span in spans for time in (span.begin, span.end)}


@lawful
@given(any_motion, any_motion, any_motion)
def test_plus_is_associative(a, b, c):
    assert (a + b) + c == a + (b + c)


@lawful
@given(any_motion)
def test_the_empty_motion_changes_nothing_on_either_side(a):
    assert a + Motion.EMPTY == a == Motion.EMPTY + a
    assert a + 0 == a == 0 + a == sum([a])


@lawful
@given(any_motion, any_motion)
def test_durations_add(a, b):
    assert (a + b).duration == a.duration + b.duration


@lawful
@given(any_motion, counts)
def test_n_times_a_motion_lasts_n_times_as_long(m, n):
    assert (n * m).duration == n * m.duration


@lawful
@given(any_motion, factors)
def test_a_scaled_motion_lasts_as_long_as_the_size_of_the_factor_says(m, s):
    assert m.scale(frames=s).duration == abs(s) * m.duration


@lawful
@given(any_motion, counts, counts)
def test_repetitions_add(m, n, k):
    assert (n + k) * m == n * m + k * m


@lawful
@given(any_motion, st.integers(0, 3), st.integers(0, 3))
def test_repetitions_multiply(m, n, k):
    assert n * (k * m) == (n * k) * m


@lawful
@given(any_motion)
def test_once_is_the_motion_and_never_is_the_empty_one(m):
    assert 1 * m == m == m * 1
    assert 0 * m == Motion.EMPTY


@lawful
@given(any_motion, factors, factors)
def test_scalings_multiply(m, s, r):
    assert m.scale(frames=r).scale(frames=s) == m.scale(frames=s * r)


@lawful
@given(any_motion, factors, counts)
def test_scaling_a_repetition_is_repeating_the_scaled(m, s, n):
    assert (n * m).scale(frames=s) == n * m.scale(frames=s)


@lawful
@given(any_motion, any_motion, factors)
def test_scaling_a_sum_scales_both_and_turns_their_order_where_it_reverses(a, b, s):
    first, second = (a, b) if s > 0 else (b, a)
    assert (a + b).scale(frames=s) == first.scale(frames=s) + second.scale(frames=s)


@lawful
@given(any_motion)
def test_reversing_twice_gives_the_motion_back(m):
    assert m.reverse().reverse() == m


@lawful
@given(any_motion, factors, factors, sizes, sizes)
def test_scaling_frames_and_scaling_extremes_commute_and_repeat(m, s, r, e, f):
    both = m.scale(frames=s, extremes=e)
    assert both == m.scale(frames=s).scale(extremes=e) == m.scale(extremes=e).scale(frames=s)
    assert both.scale(frames=r, extremes=f) == m.scale(frames=s * r, extremes=e * f)


@lawful
@given(any_motion, joint_sets, joint_sets)
def test_stripping_twice_keeps_what_both_keep(m, j, k):
    assert m.strip(j).strip(k) == m.strip(j & k)
    assert m.strip(j).duration == m.duration


@lawful
@given(any_motion, any_motion, joint_sets)
def test_stripping_a_sum_strips_both(a, b, j):
    assert (a + b).strip(j) == a.strip(j) + b.strip(j)


@lawful
@given(any_motion, other_motion)
def test_together_is_commutative_and_as_long_as_the_longer(a, b):
    assert a | b == b | a == synchronize(a, b)
    assert (a | b).duration == max(a.duration, b.duration)


@lawful
@given(any_motion, other_motion, motions(("20", "21")))
def test_together_is_associative(a, b, c):
    assert (a | b) | c == a | (b | c)


@lawful
@given(any_motion, any_motion)
def test_together_refuses_joints_that_both_move_and_names_them(a, b):
    shared = set(a.joints) & set(b.joints)
    assume(shared)
    with pytest.raises(LayfigureError) as error:
        _ = a | b
    assert all(joint in str(error.value) for joint in shared)


@lawful
@given(any_motion, other_motion, any_motion, other_motion)
def test_rows_run_together_are_runs_in_a_row_where_durations_agree(a, b, c, d):
    assume(a.duration and b.duration and c.duration and d.duration)
    b, d = b.scale(frames=a.duration / b.duration), d.scale(frames=c.duration / d.duration)
    assert (a | b) + (c | d) == (a + c) | (b + d)


@lawful
@given(any_motion, other_motion, data)
def test_together_shows_what_each_shows(a, b, data):
    time = moment(data.draw, a | b)
    assert values(a | b, time) == values(a, time) | values(b, time)


@lawful
@given(any_motion, any_motion, data)
def test_a_sum_shows_the_left_motion_before_the_seam_and_the_right_one_from_there(a, b, data):
    assume(b.duration)  # nothing follows at the seam with a motion of no length
    time = moment(data.draw, a + b)
    assert values(a + b, time) == (values(a, time) if time < a.duration else values(b, time - a.duration))
    assert (a + b).at(time) == (a.at(time) if time < a.duration else b.at(time - a.duration))


@lawful
@given(plain_motion, data)
def test_backwards_shows_what_forwards_shows_away_from_seams(m, data):
    time = moment(data.draw, m)
    assume(time not in seams_of(m.reverse()))
    assert values(m.reverse(), time) == values(m, m.duration - time)


@lawful
@given(any_motion, st.integers(1, 4))
def test_a_repetition_ends_as_the_motion_ends(m, n):
    assert (n * m).end() == m.end()


def called(motion, names):
    """Return a motion with its joints called by the names of limbs."""
    new = dict(zip(JOINTS, names, strict=True))
    return Motion(motion.duration, {new[joint]: spans for joint, spans in motion.tracks.items()}, motion.marks)


def on_the_humanoid(motion):
    """Return a motion of joints whose limits lie within |flexion| + |pivot| <= 180; of others see test_swing_domain."""
    return called(motion, ("leftforearm", "spine", "rightfoot", "neck"))


def clamped(motion):
    return motion.clamped(HUMANOID)[0]


@lawful
@given(any_motion, any_motion, counts, factors)
def test_clamping_commutes_with_rows_repetitions_and_scaled_time_and_twice_is_once(a, b, n, s):
    a, b = on_the_humanoid(a), on_the_humanoid(b)
    assert clamped(a + b) == clamped(a) + clamped(b)
    assert clamped(n * a) == n * clamped(a)
    assert clamped(a.scale(frames=s)) == clamped(a).scale(frames=s)
    assert clamped(clamped(a)) == clamped(a)


@lawful
@given(plain_motion, plain_motion, counts, factors, shares)
def test_legal_in_is_legal_out(a, b, n, s, share):
    a, b = clamped(on_the_humanoid(a)), clamped(on_the_humanoid(b))
    over = share * min(a.duration, b.duration)
    moved = [a + b, n * a, a.scale(frames=s), a.strip("spine", "neck"), crossfade(a, b, over), a.hold(3)]
    moved.append(a.strip(["spine"]) | b.strip(["leftforearm"]))
    for motion in moved:
        free = sample(HUMANOID, motion, frame_times(motion, 60), clamp=False)
        low, high = np.moveaxis(HUMANOID.arrays.limits[1:], -1, 0)
        assert ((low <= free.angles[:, 1:]) & (free.angles[:, 1:] <= high)).all()
        assert not sample(HUMANOID, motion, frame_times(motion, 60)).clamps


@lawful
@given(any_motion, data)
def test_a_film_shows_what_the_motion_is_exactly(m, data):
    m = called(m, "abcd")
    times = sorted({moment(data.draw, m) for _ in range(4)})
    shown = sample(FREE, m, times)
    assert not shown.clamps
    for number, time in enumerate(times):
        for joint, wanted in values(m, time).items():
            found = shown.angles[number, FREE.index(joint)]
            np.testing.assert_allclose(found, np.array(wanted, dtype=float), rtol=1e-9, atol=1e-8)


@lawful
@given(any_motion)
@example(Motion.EMPTY)
def test_a_motion_reads_back_from_what_it_shows_itself_as(m):
    assert Motion.parse(repr(m)) == m and hash(Motion.parse(repr(m))) == hash(m)


def test_repeating_a_sum_is_not_adding_repetitions():
    a, b = Motion.of({5: [(0, (0, 0, 0)), (4, (0, 0, 9))]}), Motion.of({5: [(0, (0, 0, 9)), (2, (0, 0, 0))]})
    assert 2 * (a + b) != 2 * a + 2 * b
    assert (2 * (a + b)).at(5) == {"5": (0.0, 0.0, 4.5)} and (2 * a + 2 * b).at(5) == {"5": (0.0, 0.0, 2.25)}


def test_slerp_of_legal_poses_is_not_legal_and_is_clamped_and_reported():
    spine, rest = HUMANOID.index("spine"), Pose.rest(HUMANOID)
    ends = rest.with_joint(spine, -70.0, -50.0, 45.0), rest.with_joint(spine, 45.0, -50.0, -45.0)
    even = from_poses(HUMANOID, [(0, ends[0]), (24, ends[1])])
    assert not sample(HUMANOID, even, frame_times(even)).clamps
    turned = slerp(even, HUMANOID)
    shown = sample(HUMANOID, turned, frame_times(turned))
    assert shown.clamps.clamped > 5 and shown.clamps.joint == "spine"
    low, high = np.moveaxis(HUMANOID.arrays.limits[spine], -1, 0)
    assert ((low <= shown.angles[:, spine]) & (shown.angles[:, spine] <= high)).all()
    assert (shown.pose(0), shown.pose(24)) == ends
