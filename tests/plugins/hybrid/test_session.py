"""The hybrid in a session: what a person does, and the log of it."""

from __future__ import annotations

from itertools import combinations

import numpy as np
import pytest

from layfigure import compiled
from layfigure.configuration import load_bindings
from layfigure.kinematics.forward import limb_ends, place_pose
from layfigure.kinematics.measures import body_height
from layfigure.plugins.host import Host
from layfigure.poses.locks import tips_of
from layfigure.poses.packing import pack_pose
from layfigure.poses.pose import Pose
from layfigure.session.document import Document
from layfigure.session.events import KeyEvent
from layfigure.session.figures import open_figure
from layfigure.session.log import parse_log
from layfigure.session.replay import open_log, play
from layfigure.session.session import Session, SessionOptions

CROUCH = ("use ik", "chain 0", "lock place rightfoot", "lock place leftfoot", "goal top -4 -22 4")
HELD = (*CROUCH, "lock hold righthand leftthigh 0 4 -9", "use hybrid")
PINNED = (*CROUCH, "goal righthand 14 -58 -18", "goal righthand 14 -58 -24", "lock place righthand", "use hybrid")


@pytest.fixture
def work(host: Host) -> Session:
    compiled.load()
    options = SessionOptions(frontend="sdl", bindings=load_bindings(host, "layfigure"), compiled=False)
    return Session(host, Document.new(open_figure(host, "humanoid")), options)


def run(session: Session, *lines: str) -> None:
    for line in lines:
        session.execute(line)


def tips(session: Session, pose: Pose) -> np.ndarray:
    return tips_of(session.document.figure, place_pose(session.document.figure, pose))


@pytest.mark.parametrize("lines", [HELD, PINNED], ids=["hand held at the knee", "hand pinned at the knee"])
def test_feet_and_a_hand_stay_and_the_rest_moves_in_nine_different_ways(work: Session, lines: tuple[str, ...]) -> None:
    run(work, *lines)
    figure = work.document.figure
    height = body_height(figure)
    hand, knee = figure.indices(["righthand", "leftthigh"])
    feet = list(figure.indices(["rightfoot", "leftfoot"]))
    stood = tips(work, Pose.rest(figure))[feet]
    place = tips(work, work.document.pose)[hand]
    for _ in range(3):
        shown = work.offer().candidates
        assert len(shown) == 9
        for pose in shown:
            now = tips(work, pose)
            assert np.linalg.norm(now[feet] - stood, axis=1).max() <= 0.005 * height
            off = now[hand] - now[knee] - [0, 4, -9] if lines is HELD else now[hand] - place
            assert np.linalg.norm(off) <= 0.005 * height
        ends = [limb_ends(figure, place_pose(figure, pose)) for pose in shown]
        apart = [np.linalg.norm(a - b, axis=1).max() for a, b in combinations(ends, 2)]
        assert min(apart) > 0.1 * height
        if work.document.states["hybrid"].page < 2:
            run(work, "next")


def test_the_whole_session_replays_to_the_same_bytes(work: Session, host: Host) -> None:
    run(work, *HELD, "pick 3 lefthand", "pick 5 spine", "effector head", "intensity 30", "mutate", "next", "best 2")
    log = parse_log("\n".join(work.log), "replay.log")
    again = open_log(host, log, SessionOptions(compiled=False))
    play(again, log)
    figure = work.document.figure
    assert pack_pose(figure, again.document.pose) == pack_pose(figure, work.document.pose)
    assert again.offer().address == work.offer().address
    assert again.offer().candidates == work.offer().candidates


def test_what_is_picked_stays_as_picked_and_the_net_has_nothing_to_do(work: Session) -> None:
    run(work, *HELD)
    source, figure = work.offer().candidates[3], work.document.figure
    run(work, "pick 4 spine")
    state = work.document.states["hybrid"]
    assert state.seed == work.document.pose
    assert state.generation.settled == {0, figure.index("spine")}
    assert np.array_equal(work.document.pose.angles[figure.index("spine")], source.angles[figure.index("spine")])


def test_a_key_chooses_the_selected_limb_and_the_log_names_it(work: Session) -> None:
    run(work, "use hybrid", "select lefthand")
    work.handle(KeyEvent("g"))
    assert work.log[-1] == "effector lefthand"
    assert work.document.states["hybrid"].chosen == {work.document.figure.index("lefthand")}
    run(work, "select-none")
    work.handle(KeyEvent("g"))
    assert work.status == "no limb is selected; Tab selects one"
    work.handle(KeyEvent("shift+g"))
    assert work.document.states["hybrid"].chosen == set()


def test_undo_takes_back_a_pick(work: Session) -> None:
    run(work, *HELD)
    before = work.document.pose
    run(work, "pick 1 lefthand", "next", "undo")
    assert work.document.pose == before


def test_switching_to_the_generator_and_back_keeps_the_pose(work: Session) -> None:
    run(work, *HELD, "best 4")
    pose = work.document.pose
    run(work, "use generator", "use hybrid")
    assert work.document.pose == pose


def test_when_the_solver_is_compiled_the_page_comes_by_itself(work: Session, monkeypatch: pytest.MonkeyPatch) -> None:
    with monkeypatch.context() as patched:
        patched.setattr(compiled, "loaded", lambda: False)
        run(work, "use hybrid")
        assert work.offer().candidates == (work.document.pose,)
        assert work.offer().note.endswith("until then this is your pose")
    work.kernels_ready()
    assert len(work.offer().candidates) == 9
