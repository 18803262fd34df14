"""Any sequence of gestures on any technique: what must hold whatever a person does."""

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from layfigure import compiled
from layfigure.errors import LayfigureError
from layfigure.figures.library import load_figure
from layfigure.plugins.host import Host
from layfigure.poses.locks import broken, locked_joints
from layfigure.session.document import Document
from layfigure.session.log import parse_log
from layfigure.session.replay import open_log, play
from layfigure.session.session import Session, SessionOptions

HUMANOID = load_figure("humanoid")
LIMBS = ["spine", "neck", "leftupperarm", "rightforearm", "lefthand", "righthand", "rightthigh", "leftleg", "rightfoot"]
limbs = st.sampled_from(LIMBS)
angles = st.integers(-120, 120)
places = st.integers(-120, 120)
anywhere = st.one_of(
    st.builds("set {} {} {} {}".format, limbs, angles, st.just(0), st.just(0)),
    st.builds("lock {} {}".format, st.sampled_from(["place", "joint", "band", "orientation"]), limbs),
    st.builds("lock hold {} {}".format, limbs, limbs),
    st.builds("{} {}".format, st.sampled_from(["enable", "disable", "release", "rest"]), limbs),
    st.builds("{} {}".format, st.sampled_from(["store", "recall"]), st.integers(1, 2)),
    st.sampled_from(["flip", "release all", "enable all", "symmetric"]),
)
picks = st.builds("pick {} {}".format, st.integers(1, 9), limbs)
bests = st.builds("best {}".format, st.integers(1, 9))
intensities = st.builds("intensity {}".format, st.integers(0, 100))
GESTURES = {
    "generator": st.one_of(
        picks, bests, intensities, st.sampled_from(["mutate", "next", "kind twist", "spread apart"])
    ),
    "fk": st.builds("set {} {} {} {}".format, limbs, angles, st.just(0), st.just(0)),
    "ik": st.one_of(
        st.builds("goal {} {} {} {}".format, limbs, places, places, places),
        st.builds("chain {}".format, st.integers(0, 5)),
    ),
    "hybrid": st.one_of(picks, bests, intensities, st.sampled_from(["mutate", "next", "first"])),
    "ga": st.one_of(st.builds("grade {} {}".format, st.integers(1, 9), st.integers(0, 10)), bests, st.just("evolve")),
}


@st.composite
def stretches(draw) -> list[str]:
    """A while of work with one technique."""
    technique = draw(st.sampled_from(sorted(GESTURES)))
    work = draw(st.lists(st.one_of(GESTURES[technique], GESTURES[technique], anywhere), min_size=1, max_size=5))
    return [f"use {technique}", *work]


def whole(least: int, most: int):
    return st.lists(stretches(), min_size=least, max_size=most).map(
        lambda parts: [line for part in parts for line in part]
    )


@pytest.fixture(scope="module")
def host():
    compiled.load()
    return Host.discover()


def begun(host: Host) -> Session:
    return Session(host, Document.new(HUMANOID), SessionOptions())


def tried(session: Session, line: str) -> bool:
    """Run a line that may be impossible where it stands."""
    try:
        session.execute(line)
    except LayfigureError:
        return False
    return True


@settings(max_examples=40, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(sequence=whole(1, 4))
def test_poses_stay_finite_switches_change_nothing_locks_hold_and_undo_returns(host, sequence):
    session = begun(host)
    first = session.document
    for line in sequence:
        before = session.document
        done = tried(session, line)
        after = session.document
        assert np.isfinite(after.pose.angles).all() and np.isfinite(after.pose.translation).all()
        if not done:
            assert after is before, f"{line} was refused and yet changed something"
        if line.startswith("use"):
            assert after.pose == before.pose
        if done and not line.startswith(("flip", "recall", "lock", "release")):
            held = sorted(locked_joints(before.locks))
            assert np.array_equal(after.pose.angles[held], before.pose.angles[held]), line
            if not broken(HUMANOID, before.pose, before.locks):
                assert broken(HUMANOID, after.pose, after.locks) == (), line
    assert session.host.faults == []
    while tried(session, "undo"):
        pass
    assert session.document.pose == first.pose and session.document.locks == first.locks
    assert session.document.enabled == first.enabled and dict(session.document.slots) == {}


@settings(max_examples=15, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(sequence=whole(1, 3))
def test_the_log_of_any_sequence_replays_to_the_same_bits(host, sequence):
    session = begun(host)
    for line in sequence:
        tried(session, line)
    log = parse_log("\n".join(session.log) + "\n", "any.log")
    again = open_log(host, log, session.options)
    play(again, log)
    assert again.document.pose == session.document.pose and again.document.locks == session.document.locks
    assert again.document.technique == session.document.technique
    assert [pose.angles.tobytes() for pose in again.offer().candidates] == [
        pose.angles.tobytes() for pose in session.offer().candidates
    ]


@settings(max_examples=30, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(sequence=whole(1, 3))
def test_no_technique_moves_a_limb_that_is_kept(host, sequence):
    session = begun(host)
    kept = [HUMANOID.index(name) for name in ("leftupperarm", "rightthigh")]
    session.execute("disable leftupperarm rightthigh")
    for line in sequence:
        by_hand = line.startswith(("set", "rest")) and session.document.technique != "fk"
        meant = by_hand and any(name in line for name in ("leftupperarm", "rightthigh"))
        if not meant and not line.startswith(("enable", "disable", "flip", "recall", "symmetric")):
            tried(session, line)
        assert (session.document.pose.angles[kept] == 0).all(), line
