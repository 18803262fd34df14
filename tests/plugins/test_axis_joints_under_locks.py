"""Every technique poses a figure whose joints turn about x, y and z, under locks that are kept all the while."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from tests.plugins.axis_figures import PUPPET, beyond_limits

from layfigure import compiled
from layfigure.configuration import load_bindings
from layfigure.kinematics.forward import place_pose
from layfigure.kinematics.measures import body_height
from layfigure.plugins.host import Host
from layfigure.poses.locks import broken, tips_of
from layfigure.session.document import Document
from layfigure.session.figures import open_figure
from layfigure.session.log import parse_log
from layfigure.session.replay import open_log, play
from layfigure.session.session import Session, SessionOptions

FEET = ("lock place leftfoot", "lock place rightfoot")


@pytest.fixture
def puppet(host: Host, tmp_path: Path) -> Session:
    """The puppet, its knees a little bent, with both feet planted."""
    compiled.load()
    file = tmp_path / "puppet.fig"
    file.write_text(PUPPET, encoding="utf-8")
    options = SessionOptions(frontend="sdl", bindings=load_bindings(host, "layfigure"), compiled=False)
    session = Session(host, Document.new(open_figure(host, str(file))), options)
    for side in ("left", "right"):
        run(session, f"set {side}thigh -40 0 0", f"set {side}shin 60 0 0", f"set {side}foot -20 0 0")
    run(session, *FEET)
    return session


def run(session: Session, *lines: str) -> None:
    for line in lines:
        session.execute(line)


def poses(session: Session) -> tuple:
    return (session.document.pose, *session.offer().candidates)


def in_order(session: Session, within: bool = True) -> bool:
    """Whether locks hold, limits too if they are to, and joints mean x, y, z still, in all poses that are shown."""
    document = session.document
    return all(
        not broken(document.figure, pose, document.locks)
        and (not within or beyond_limits(document.figure, pose.angles) <= 0.0)
        and np.array_equal(pose.euler, document.figure.arrays.euler)
        for pose in poses(session)
    )


def test_the_generator_fills_pages_of_nine_under_locks(puppet: Session) -> None:
    run(puppet, "use generator", "within-limits on")
    for line in ("mutate", "next", "pick 3 leftupperarm leftforearm", "intensity 30", "mutate", "best 2"):
        run(puppet, line)
        assert in_order(puppet), line
        assert len(set(puppet.offer().candidates)) == 9


def test_the_hybrid_proposes_nine_different_poses_under_locks(puppet: Session) -> None:
    run(puppet, "use hybrid")
    figure = puppet.document.figure
    for line in ("first", "next", "next", "best 4"):
        run(puppet, line)
        assert in_order(puppet), line
        shown = puppet.offer().candidates
        assert len(shown) == 9
        tips = [tips_of(figure, place_pose(figure, pose)) for pose in shown]
        apart = [np.linalg.norm(a - b, axis=1).max() for i, a in enumerate(tips) for b in tips[:i]]
        assert min(apart) > 0.03 * body_height(figure)


def test_a_hand_is_brought_to_a_goal_while_the_feet_stay(puppet: Session) -> None:
    run(puppet, "use ik", "chain 0", "goal lefthand 10 20 -12")
    figure = puppet.document.figure
    hand = tips_of(figure, place_pose(figure, puppet.document.pose))[figure.index("lefthand")]
    np.testing.assert_allclose(hand, (10, 20, -12), atol=0.005 * body_height(figure))
    assert in_order(puppet)


def test_a_thigh_that_is_turned_by_hand_is_followed_by_the_rest_so_that_the_feet_stay(puppet: Session) -> None:
    run(puppet, "use fk", "set leftthigh -55 0 10")
    assert puppet.document.pose.angles[puppet.document.figure.index("leftthigh")].tolist() == [-55, 0, 10]
    assert in_order(puppet)


def test_the_log_of_all_that_replays_to_the_same_pose(puppet: Session, host: Host) -> None:
    run(puppet, "use generator", "mutate", "pick 3 leftupperarm", "use hybrid", "best 4", "use ik", "chain 0")
    run(puppet, "goal righthand -14 24 -10", "use fk", "set head 20 30 0", "set crank 0 0 500")
    assert in_order(puppet, within=False)
    log = parse_log("\n".join(puppet.log), "puppet.log")
    again = open_log(host, log, SessionOptions(compiled=False))
    play(again, log)
    assert again.document.pose == puppet.document.pose
    assert poses(again) == poses(puppet)
