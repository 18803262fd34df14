"""A session under locks with the real solver: pages, picks and variants keep the feet planted and a hand on a knee."""

from __future__ import annotations

import pytest

from layfigure import compiled
from layfigure.plugins.host import Host
from layfigure.poses.locks import broken
from layfigure.poses.pose_set import load_poses
from layfigure.session.bench import KEEPER
from layfigure.session.log import parse_log
from layfigure.session.replay import open_log, play
from layfigure.session.session import Session, SessionOptions

CROUCH = ("spine -60 0 0", "rightthigh 60 0 0", "leftthigh 60 0 0", "rightleg -60 0 0", "leftleg -60 0 0")
LOCKS = ("place rightfoot", "place leftfoot", "hold righthand leftthigh", "joint neck")


@pytest.fixture
def planted(host: Host, session: Session) -> Session:
    if KEEPER not in host.solvers:
        pytest.skip(f"the solver {KEEPER} is not installed")
    compiled.load()
    for line in (*(f"set {joint}" for joint in CROUCH), *(f"lock {lock}" for lock in LOCKS)):
        session.execute(line)
    return session


def kept(session: Session) -> bool:
    document = session.document
    poses = (document.pose, *session.offer().candidates)
    return not any(broken(document.figure, pose, document.locks) for pose in poses)


@pytest.mark.parametrize("intensity", [100, 15])
def test_every_page_has_nine_different_poses_that_keep_every_lock(planted: Session, intensity: int) -> None:
    planted.execute(f"intensity {intensity}")
    planted.execute("mutate")
    for turn in ("first", "next", "next"):
        planted.execute(turn)
        assert len(set(planted.offer().candidates)) == 9
        assert kept(planted)


def test_picks_filters_and_undo_keep_them_and_the_log_replays(planted: Session, host: Host) -> None:
    before = planted.document
    for line in ("spread apart", "balanced on", "pick 2 leftupperarm leftforearm", "mutate", "best 3", "next"):
        planted.execute(line)
        assert kept(planted), line
    log = parse_log("\n".join(planted.log), "planted.log")
    again = open_log(host, log, SessionOptions(compiled=False))
    play(again, log)
    assert again.document.pose == planted.document.pose
    assert again.offer().candidates == planted.offer().candidates
    for _ in range(5):
        planted.execute("undo")
    assert planted.document.same_as(before)


def test_a_crouching_figure_breathes_with_its_feet_planted(planted: Session) -> None:
    planted.execute("breathe life")
    figure, poses = load_poses(planted.options.folder / "life.poses")
    assert len(poses) == 9
    assert not any(broken(figure, pose, planted.document.locks) for pose in poses)
